# SPDX-License-Identifier: LGPL-2.1-or-later
"""How a picture is traced."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, StrictBool

from CNCStepper.quantities import Bounds, Length, Width

Grey = Annotated[int, Field(strict=True, ge=1, le=255)]


class TraceOptions(BaseModel):
    """The keys of a trace; what is left out is found from the picture.

    threshold: the grey, 1 to 255, below which a pixel is dark; found by Otsu's method. invert: light areas are traced.
    blur_px: radius of a Gaussian blur before that. width_mm or dpi: the size; else the file's own dpi, else 96.
    simplify_mm: how far lines and arcs may leave the pixels' contour; half a pixel. speck_mm2: smaller areas and holes
    are left out; four pixels.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    threshold: Grey | None = None
    invert: StrictBool = False
    blur_px: Annotated[float, Bounds("factor", 0.1, 100.0, zero=True)] = 0.0
    width_mm: Length | None = None
    dpi: Annotated[float, Bounds("factor", 1.0, 100_000.0)] | None = None
    simplify_mm: Width | None = None
    speck_mm2: Annotated[float, Bounds("factor", 0.0, 1_000_000.0)] | None = None
