# SPDX-License-Identifier: LGPL-2.1-or-later
"""The work surface of an arrangement and how programs lie on it, as a window or a script asks for it."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, StrictBool

from CNCStepper.quantities import Length, LengthOr0


class ArrangeForm(BaseModel):
    """sheet_x_mm, sheet_y_mm: of the work surface. gap_mm: between cuts. tool_mm: its diameter. turn: by quarters."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    sheet_x_mm: Length
    sheet_y_mm: Length
    gap_mm: LengthOr0 = 5.0
    tool_mm: LengthOr0 = 0.0
    turn: StrictBool = False
