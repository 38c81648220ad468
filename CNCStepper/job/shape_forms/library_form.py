# SPDX-License-Identifier: LGPL-2.1-or-later
"""`[[shape]] library = { ... }`: a shape of the library by its kind and its dimensions."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, model_validator

from CNCStepper.drawing.shape_library.shape_families import figure_of
from CNCStepper.errors import GeometryError, JobError
from CNCStepper.geometry.curve import Curve
from CNCStepper.quantities import Angle, Coordinate


class LibraryForm(BaseModel):
    """A shape of the library by its kind and its dimensions, turned about its zero and then moved.

    part: all of its curves, its outline, or its holes.
    """

    model_config = ConfigDict(extra="allow", frozen=True, allow_inf_nan=False)

    kind: str
    part: Literal["all", "outline", "holes"] = "all"
    offset_mm: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    rotation_deg: Angle = 0.0

    @model_validator(mode="after")
    def _can_be_drawn(self) -> LibraryForm:
        try:
            self.curves()
        except (GeometryError, JobError) as error:
            raise ValueError(error.sentence) from error
        return self

    def curves(self) -> tuple[Curve, ...]:
        """Return its curves, the outline first; raises JobError and GeometryError as the library does."""
        figure = figure_of(self.kind, self.model_extra or {})
        chosen = {"all": figure.curves, "outline": (figure.outline,), "holes": figure.holes}[self.part]
        if not chosen:
            raise GeometryError("shape-holes", "this shape has no holes", advice='leave part = "holes" out')
        return tuple(curve.rotated(self.rotation_deg).moved(*self.offset_mm) for curve in chosen)
