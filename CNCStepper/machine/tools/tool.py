# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter: its shape and what it may do.

 flat      ball      bullnose       v, engraver       drill        jet, wire
|    |    |    |    |       |       \\         /       |     |      |       |  diameter: the kerf, at the
|    |    |    |    |       |        \\       /        |     |       \\     /   sheet's top; taper: of one
+----+     `--'     `._____.'         \\_____/          `. .'         \\   /    wall against the vertical
                  corner_radius   tip_diameter, _angle  point_angle

Its radius by height is in `tool_profile.py`.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, model_validator

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.tools.tool_shapes import Shape, foreign_keys
from CNCStepper.quantities import Bounds, ChipLoadOr0, FeedOr0, SpeedOr0, TipAngle, ToolNumber, Width, WidthOr0


class Tool(BaseModel):
    """A tool as a job file names it; 0 means "not given" for feeds, speed, lengths, flutes and limits.

    The angles are those between the two sides of the tip. flute_length_mm: of the cutting edges; length_mm: from
    the tip to the holder, whose diameter is holder_diameter_mm. length_offset_mm: what a controller adds to Z for it,
    where the machine's tool_length is "table". core_diameter_mm: of the middle of a mill's end that does not cut, 0
    for one that cuts over its centre; such a mill goes down on ramps and helices of at most ramp_max_deg. made_of:
    the cutter's own material, "hss" is high-speed steel. chip_load_min_mm, chip_load_max_mm (a tooth) and
    engagement_max_deg: the largest permitted angle.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    number: ToolNumber
    shape: Shape
    diameter_mm: Width
    corner_radius_mm: Width | None = None
    tip_diameter_mm: WidthOr0 | None = None
    tip_angle_deg: TipAngle | None = None
    point_angle_deg: TipAngle | None = None
    taper_deg: Annotated[float, Bounds("slope", most=44.99, zero=True)] | None = None
    flute_length_mm: WidthOr0 = 0.0
    length_mm: WidthOr0 = 0.0
    holder_diameter_mm: WidthOr0 = 0.0
    length_offset_mm: Annotated[float, Bounds("coordinate", -10_000, 10_000)] | None = None
    core_diameter_mm: WidthOr0 = 0.0
    ramp_max_deg: Annotated[float, Bounds("slope", most=89.99)] = 10.0
    flutes: Annotated[int, Bounds("count", 0, 100)] = 0
    made_of: Literal["carbide", "hss"] = "carbide"
    chip_load_min_mm: ChipLoadOr0 = 0.0
    chip_load_max_mm: ChipLoadOr0 = 0.0
    engagement_max_deg: Annotated[float, Bounds("slope", most=180.0, zero=True)] = 0.0
    feed_mm_min: FeedOr0 = 0.0
    plunge_mm_min: FeedOr0 = 0.0
    spindle_rpm: SpeedOr0 = 0.0

    @model_validator(mode="after")
    def _keys_fit_the_shape(self) -> Tool:
        for key in sorted(foreign_keys(self.shape)):
            if getattr(self, key) != type(self).model_fields[key].default:
                raise ValueError(Text("a {shape} tool has no {key}", shape=self.shape, key=key))
        if self.corner_radius_mm is not None and self.corner_radius_mm > self.radius_mm:
            raise ValueError("corner_radius_mm must not exceed half of diameter_mm")
        if self.tip_diameter_mm is not None and self.tip_diameter_mm >= self.diameter_mm:
            raise ValueError("tip_diameter_mm must be below diameter_mm")
        if self.core_diameter_mm > self.diameter_mm:
            raise ValueError("core_diameter_mm must not exceed diameter_mm")
        if self.chip_load_max_mm and self.chip_load_min_mm > self.chip_load_max_mm:
            raise ValueError("chip_load_min_mm must not exceed chip_load_max_mm")
        if (self.chip_load_min_mm or self.chip_load_max_mm) and not self.flutes:
            raise ValueError("a chip load needs flutes")
        if self.length_mm and self.flute_length_mm > self.length_mm:
            raise ValueError("flute_length_mm must not exceed length_mm")
        return self

    @property
    def radius_mm(self) -> float:
        """Half the diameter."""
        return self.diameter_mm / 2

    @property
    def words(self) -> str:
        """The words by which a person picks the tool, for example "flat 6 mm"."""
        return f"{self.shape} {self.diameter_mm:g} mm"


def tool_from_text(text: str, number: int = 0) -> Tool:
    """Return the tool that a command line names as SHAPE:DIAMETER, for example "flat:6"."""
    shape, _, diameter = text.partition(":")
    try:
        return Tool(number=number, shape=shape, diameter_mm=float(diameter))  # type: ignore[arg-type]
    except ValueError as error:
        raise JobError(
            "tool-text",
            Text("'{text}' is not a tool", text=text),
            advice="write shape:diameter_mm, for example flat:6 or ball:2",
        ) from error
