# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a solid is cut into sheets and its pieces are nested, as a window or a script asks for it."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict

from CNCStepper.quantities import Bounds, Depth, Length, LengthOr0


class SliceForm(BaseModel):
    """The sheets of a stack, and the sheets of material on which their pieces are nested.

    hole_mm: the diameter of the registration holes, 0: none. sheet_x_mm, sheet_y_mm: the size of a sheet of material.
    gap_mm: between pieces, margin_mm: to its rim. time_s: how long the nesting may look for a denser one.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    thickness_mm: Depth
    axis: Literal["x", "y", "z"] = "z"
    hole_mm: LengthOr0 = 3.0
    sheet_x_mm: Length = 600.0
    sheet_y_mm: Length = 400.0
    gap_mm: LengthOr0 = 2.0
    margin_mm: LengthOr0 = 3.0
    time_s: Annotated[float, Bounds("time", most=3600.0)] = 10.0
