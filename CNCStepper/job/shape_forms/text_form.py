# SPDX-License-Identifier: LGPL-2.1-or-later
"""`[[shape]] text = { ... }`: a text in a font of the system, or in a single-line font, on a line or along a curve.

The curve is a line, an arc, or that of another shape of the job, of any kind.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, StrictBool, model_validator

from CNCStepper.drawing.text.text_curves import MOST_CHARACTERS, TextStyle, text_along, text_curves
from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.curve import Curve, circle, straight
from CNCStepper.job.shape_forms.text_parameters import TextParameters
from CNCStepper.quantities import Angle, Bounds, Coordinate, Length, Turn

Point = tuple[Coordinate, Coordinate]
MOST_NAME = 200  # characters of a font's name
ALIGNED = {"left": 0.0, "center": 0.5, "right": 1.0}  # the share of a curve's length where its text is aligned


NO_SHAPES: Mapping[str, Sequence[Curve]] = {}


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class ArcForm(_Checked):
    """An arc under a text, mm and degrees: from `start_deg` on, counter-clockwise for a positive sweep.

    Letters stand outside of an arc that runs clockwise, inside of one that runs counter-clockwise.
    """

    centre: Point
    radius: Length
    start_deg: Angle
    sweep_deg: Turn

    def curve(self) -> Curve:
        """Return the arc."""
        first_deg = self.start_deg + min(self.sweep_deg, 0.0)
        whole = circle((0.0, 0.0), self.radius).rotated(first_deg)
        length_mm = whole.length_mm * abs(self.sweep_deg) / 360.0
        arc = (whole if abs(self.sweep_deg) == 360.0 else whole.part(0.0, length_mm)).moved(*self.centre)
        return arc.reversed() if self.sweep_deg < 0.0 else arc


class AlongForm(_Checked):
    """The curve along which a text runs: a line by two points, an arc, or the curve of a shape that stands before it.

    reverse: it runs the other way round. above_mm: how far above it letters stand.
    """

    line: tuple[Point, Point] | None = None
    arc: ArcForm | None = None
    shape: str = Field(default="", max_length=200)
    reverse: StrictBool = False
    above_mm: Annotated[float, Bounds("coordinate", -1000.0, 1000.0)] = 0.0

    @model_validator(mode="after")
    def _is_one(self) -> AlongForm:
        if (self.line is not None) + (self.arc is not None) + bool(self.shape) != 1:
            raise ValueError(Text("a text runs along a line, an arc or a shape: give one of them"))
        if self.arc is not None and not self.arc.sweep_deg:
            raise ValueError(Text("the arc of a text needs a sweep"))
        return self

    def curve(self, shapes: Mapping[str, Sequence[Curve]] = NO_SHAPES) -> Curve:
        """Return the line, the arc, or the curve of one of the shapes; raises JobError where that is not one curve."""
        if self.line is not None:
            found = straight(*self.line)
        elif self.arc is not None:
            found = self.arc.curve()
        else:
            found = self._of_shape(shapes)
        return found.reversed() if self.reverse else found

    def _of_shape(self, shapes: Mapping[str, Sequence[Curve]]) -> Curve:
        curves = shapes.get(self.shape, ())
        if len(curves) == 1:
            return curves[0]
        if self.shape in shapes:
            what = Text("a text runs along one curve, but the shape '{shape}' has several", shape=self.shape)
            raise JobError("text-along", what, value=f"{len(curves)}", advice="name a shape of one curve")
        what = Text("a text runs along the shape '{shape}', which does not stand before it", shape=self.shape)
        raise JobError("text-along", what, advice=Text("name one of: {known}", known=", ".join(shapes) or Text("none")))


class TextForm(TextParameters, _Checked):
    """A text; sizes in mm.

    The font is a `font` of the system in its `style`, a `file`, or a `single_line` font whose letters are open curves.
    height_mm: of capitals, with size = "em" of the em. The text's first base line begins at `position_mm` (align:
    ends there, or has its middle there) and is turned about it; along a curve align is the part of the curve.
    part: all curves, the outlines of letters, or the holes in them (islands of a pocket).
    """

    text: str = Field(min_length=1, max_length=MOST_CHARACTERS)
    font: str = Field(default="", max_length=MOST_NAME)
    style: str = Field(default="", max_length=MOST_NAME)
    single_line: str = Field(default="", max_length=MOST_NAME)
    position_mm: Point = (0.0, 0.0)
    rotation_deg: Angle = 0.0
    kerning: StrictBool = True
    along: AlongForm | None = None

    @model_validator(mode="after")
    def _has_one_font(self) -> TextForm:
        if sum(map(bool, (self.font, self.file, self.single_line))) != 1:
            raise ValueError(Text("a text needs one of font, file and single_line"))
        return self

    def curves(self, folder: Path, shapes: Mapping[str, Sequence[Curve]] = NO_SHAPES) -> tuple[Curve, ...]:
        """Return the text's curves; a font file is looked for in `folder`, `shapes` are those that stand before it.

        Raises JobError as text_curves does, and for a part of the letters that there is not.
        """
        wanted = {"all": (False, True), "outlines": (False,), "holes": (True,)}[self.part]
        chosen = tuple(
            curve for curve in self._set(folder, shapes) if (curve.closed and curve.area_mm2 < 0.0) in wanted
        )
        if not chosen:
            what, advice = Text("the letters of the text have no {part}", part=self.part), 'leave part = "holes" out'
            raise JobError("text-part", what, advice=advice)
        return chosen

    def _set(self, folder: Path, shapes: Mapping[str, Sequence[Curve]]) -> tuple[Curve, ...]:
        style = TextStyle(
            font=self.font,
            style=self.style,
            file=folder / self.file if self.file else None,
            single_line=self.single_line,
            height_mm=self.height_mm,
            size=self.size,
            align=self.align,
            letter_spacing_mm=self.spacing_mm,
            line_spacing=self.line_spacing,
            slant_deg=self.slant_deg,
            kerning=self.kerning,
        )
        if self.along is not None:
            curve = self.along.curve(shapes)
            along_mm = ALIGNED[self.align] * curve.length_mm
            return text_along(style, self.text, curve, self.tolerance_mm, along_mm, self.along.above_mm)
        curves = text_curves(style, self.text, self.tolerance_mm)
        return tuple(curve.rotated(self.rotation_deg).moved(*self.position_mm) for curve in curves)
