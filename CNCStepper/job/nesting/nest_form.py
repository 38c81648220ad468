# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sheets of a nest and how parts lie on them, as a window or a script asks for it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict

from CNCStepper.quantities import Bounds, Length, LengthOr0


class NestForm(BaseModel):
    """kerf_mm: the width of the cut. gap_mm: between cuts, margin_mm: to the rim. sheet_count: sheets of that size.

    common_lines: facing edges are cut once. time_s: how long a denser nest is looked for.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    kerf_mm: Annotated[float, Bounds("width", zero=True)] = 0.0
    gap_mm: LengthOr0 = 2.0
    common_lines: bool = False
    sheet_x_mm: Length = 600.0
    sheet_y_mm: Length = 400.0
    sheet_count: Annotated[int, Bounds("count", most=1000)] = 10
    thickness_mm: LengthOr0 = 3.0
    sheet_grain: Literal["none", "x", "y"] = "none"
    margin_mm: LengthOr0 = 5.0
    time_s: Annotated[float, Bounds("time", most=3600.0)] = 20.0
