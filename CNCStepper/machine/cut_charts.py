# SPDX-License-Identifier: LGPL-2.1-or-later
"""Cut charts: for process, material, thickness and consumable the feed, kerf, pierce and power that cut it.

    [[cut]]                                a row of a chart in TOML; charts ship in machine/charts/
    process = "plasma"
    material = "mild-steel"
    thickness_mm = 3.0
    feed_mm_min = 3000
    kerf_mm = 1.5
    ...

Between two thicknesses of one material and consumable the values are interpolated; outside them they are refused.
"""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from CNCStepper.machine.processes import ProcessName
from CNCStepper.quantities import Bounds, Depth, Feed, FeedOr0, LengthOr0, SpeedOr0, TimeOr0, Width

Name = Annotated[str, Field(min_length=1, max_length=80)]


class CutData(BaseModel):
    """One row of a cut chart; 0 means "not given".

    number: of the row in QtPlasmaC's material file. pierce_height_mm, cut_height_mm: of the torch above the sheet's
    top. preheat_s: before the pierce (oxyfuel). pierce_delay_s: power on, before the lead-in moves. lead_in_mm: how far
    from the part the pierce must be at least, for its spatter. power: the S word of a laser or a hot wire.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    process: ProcessName
    material: Name
    thickness_mm: Depth
    consumable: Annotated[str, Field(max_length=80)] = ""
    number: Annotated[int, Bounds("number")] = 0
    feed_mm_min: Feed
    kerf_mm: Width
    pierce_height_mm: LengthOr0 = 0.0
    pierce_delay_s: TimeOr0 = 0.0
    cut_height_mm: LengthOr0 = 0.0
    lead_in_mm: LengthOr0 = 0.0
    preheat_s: TimeOr0 = 0.0
    plunge_mm_min: FeedOr0 = 0.0
    power: SpeedOr0 = 0.0
    amperes: Annotated[float, Bounds("force", zero=True)] = 0.0
    volts: Annotated[float, Bounds("force", zero=True)] = 0.0
    pressure_bar: Annotated[float, Bounds("force", zero=True)] = 0.0
    source: Annotated[str, Field(max_length=300)] = ""
