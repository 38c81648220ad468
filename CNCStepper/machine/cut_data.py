# SPDX-License-Identifier: LGPL-2.1-or-later
"""The row of a cut chart: what cuts one thickness of one material, and what lies between two such rows."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Any

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, StrictBool, model_validator

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.processes import ProcessName
from CNCStepper.quantities import MOST_ITEMS, Bounds, Depth, Feed, FeedOr0, LengthOr0, SpeedOr0, TimeOr0, Width

Name = Annotated[str, Field(min_length=1, max_length=80)]
Percent = Annotated[float, Bounds("percent", zero=True)]
KerfAtFeed = tuple[Feed, Width]
OF_ONE_MATERIAL = ("number", "name", "source", "kerf_by_feed")  # keys that mean nothing between two thicknesses


class CutData(BaseModel):
    """One row of a cut chart; 0 means "not given".

    number, name: of the material in QtPlasmaC's material file. pierce_height_mm, cut_height_mm: of the torch above the
    sheet's top. preheat_s: before the pierce (oxyfuel). pierce_delay_s: power on, before the lead-in moves. lead_in_mm:
    how far from the part the pierce must be at least, for its spatter. power: the S word of a laser or a hot wire;
    power_percent: the same as a share of the machine's most. passes: how often the line is cut. blade_offset_mm: of a
    drag knife, from its axis to its edge. kerf_by_feed: rows (feed, kerf) of a wire or beam whose kerf shrinks with the
    feed, feeds rising. thc: whether the torch's height is controlled while it cuts. puddle_jump_height_percent: of the
    pierce height. cut_mode: of a Powermax: 1 normal, 2 continuous pilot arc, 3 gouge.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    process: ProcessName
    material: Name
    thickness_mm: Depth
    consumable: Annotated[str, Field(max_length=80)] = ""
    number: Annotated[int, Bounds("number")] = 0
    name: Annotated[str, Field(max_length=80)] = ""
    feed_mm_min: Feed
    kerf_mm: Width
    kerf_by_feed: Annotated[tuple[KerfAtFeed, ...], Field(max_length=MOST_ITEMS["diameters"])] = ()
    pierce_height_mm: LengthOr0 = 0.0
    pierce_delay_s: TimeOr0 = 0.0
    puddle_jump_height_percent: Percent = 0.0
    puddle_jump_delay_s: TimeOr0 = 0.0
    cut_height_mm: LengthOr0 = 0.0
    lead_in_mm: LengthOr0 = 0.0
    preheat_s: TimeOr0 = 0.0
    plunge_mm_min: FeedOr0 = 0.0
    passes: Annotated[int, Bounds("count", 1, 100)] = 1
    power: SpeedOr0 = 0.0
    power_percent: Annotated[float, Bounds("percent", 0.01, 100.0, zero=True)] = 0.0
    amperes: Annotated[float, Bounds("current", zero=True)] = 0.0
    volts: Annotated[float, Bounds("voltage", zero=True)] = 0.0
    pressure_bar: Annotated[float, Bounds("pressure", zero=True)] = 0.0
    pause_at_end_s: TimeOr0 = 0.0
    cut_mode: Annotated[int, Bounds("number", 0, 3)] = 0
    thc: StrictBool = True
    blade_offset_mm: LengthOr0 = 0.0
    source: Annotated[str, Field(max_length=300)] = ""

    @model_validator(mode="after")
    def _kerf_shrinks_with_feed(self) -> CutData:
        for (slow, wide), (fast, narrow) in pairwise(self.kerf_by_feed):
            if not (slow < fast and narrow <= wide):
                raise ValueError("kerf_by_feed: feeds must rise from row to row, and kerfs must not")
        return self

    def kerf_at(self, feed_mm_min: float) -> float:
        """Return the kerf in mm that a feed gives: of `kerf_by_feed`, linear between its rows; without it `kerf_mm`.

        Raises JobError for a feed outside the rows, where nobody has measured.
        """
        if not self.kerf_by_feed:
            return self.kerf_mm
        feeds, kerfs = zip(*self.kerf_by_feed, strict=True)
        if not feeds[0] <= feed_mm_min <= feeds[-1]:
            raise JobError(
                "chart-feed",
                Text("the chart has no kerf of {material} at this feed", material=self.material),
                value=f"{feed_mm_min:g} mm/min",
                limit=f"{feeds[0]:g} to {feeds[-1]:g} mm/min",
                advice="cut the kerf test at that feed and add a row to kerf_by_feed",
            )
        return float(np.interp(feed_mm_min, feeds, kerfs))

    def power_s(self, most: float = 1.0) -> float:
        """Return the S word: `power`, else `power_percent` of `most` (the machine's largest S), else `most`."""
        if self.power:
            return self.power
        return self.power_percent / 100 * most if self.power_percent else most


def between(thin: CutData, thick: CutData, thickness_mm: float) -> CutData:
    """Return the row of a thickness between two rows of one material and consumable: each number linearly.

    What is named or counted comes from the thicker one; a number of QtPlasmaC's file is given to no such row.
    """
    share = (thickness_mm - thin.thickness_mm) / (thick.thickness_mm - thin.thickness_mm)
    keys: dict[str, Any] = {"thickness_mm": thickness_mm, "source": f"{thick.source} (interpolated)".strip()[:300]}
    for key, value in thick:
        if isinstance(value, float) and key != "thickness_mm":
            keys[key] = _mixed(getattr(thin, key), value, share)
    given = {key: value for key, value in thick if key not in OF_ONE_MATERIAL}
    return CutData.model_validate({**given, "kerf_by_feed": _kerfs_between(thin, thick, share), **keys})


def _mixed(of_thin: float, of_thick: float, share: float) -> float:
    """Return the value between two, to a micron or microsecond; where only one row gives it, that one's."""
    if not of_thin or not of_thick:
        return of_thick
    return round(of_thin + share * (of_thick - of_thin), 6)


def _kerfs_between(thin: CutData, thick: CutData, share: float) -> tuple[KerfAtFeed, ...]:
    """Return the kerfs by feed between two rows: row by row where both have as many, else those of the thicker."""
    if len(thin.kerf_by_feed) != len(thick.kerf_by_feed):
        return thick.kerf_by_feed
    rows = zip(thin.kerf_by_feed, thick.kerf_by_feed, strict=True)
    return tuple((_mixed(feed, feed_2, share), _mixed(kerf, kerf_2, share)) for (feed, kerf), (feed_2, kerf_2) in rows)
