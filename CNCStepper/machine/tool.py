# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter: its shape and what it may do.

 flat      ball      bullnose       v, engraver       drill        jet, wire
|    |    |    |    |       |       \\         /       |     |      |       |  diameter: the kerf, at the
|    |    |    |    |       |        \\       /        |     |       \\     /   sheet's top; taper: of one
+----+     `--'     `._____.'         \\_____/          `. .'         \\   /    wall against the vertical
                  corner_radius   tip_diameter, _angle  point_angle
"""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field, model_validator

from CNCStepper.errors import JobError
from CNCStepper.machine.shapes import Shape, foreign_keys


class Tool(BaseModel):
    """A tool as a job file names it; 0 means "not given" for feeds, speed, lengths, flutes and limits.

    The angles are those between the two sides of the tip. flute_length_mm: of the cutting edges; length_mm: from
    the tip to the holder, whose diameter is holder_diameter_mm. length_offset_mm: what a controller adds to Z for it,
    where the machine's tool_length is "table". core_diameter_mm: of the middle of a mill's end that does not cut, 0
    for one that cuts over its centre; such a mill goes down on ramps and helices of at most ramp_max_deg. made_of:
    the cutter's own material, "hss" is high-speed steel. chip_load_min_mm, chip_load_max_mm (a tooth) and
    engagement_max_deg: what the tool allows.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)

    number: int = Field(ge=0, le=255)
    shape: Shape
    diameter_mm: float = Field(gt=0, allow_inf_nan=False)
    corner_radius_mm: float | None = Field(default=None, gt=0)
    tip_diameter_mm: float | None = Field(default=None, ge=0)
    tip_angle_deg: float | None = Field(default=None, gt=0, lt=180)
    point_angle_deg: float | None = Field(default=None, gt=0, lt=180)
    taper_deg: float | None = Field(default=None, ge=0, lt=45)
    flute_length_mm: float = Field(default=0.0, ge=0)
    length_mm: float = Field(default=0.0, ge=0)
    holder_diameter_mm: float = Field(default=0.0, ge=0)
    length_offset_mm: float | None = Field(default=None, ge=-10_000, le=10_000)
    core_diameter_mm: float = Field(default=0.0, ge=0)
    ramp_max_deg: float = Field(default=10.0, gt=0, lt=90)
    flutes: int = Field(default=0, ge=0)
    made_of: Literal["carbide", "hss"] = "carbide"
    chip_load_min_mm: float = Field(default=0.0, ge=0)
    chip_load_max_mm: float = Field(default=0.0, ge=0)
    engagement_max_deg: float = Field(default=0.0, ge=0, le=180)
    feed_mm_min: float = Field(default=0.0, ge=0)
    plunge_mm_min: float = Field(default=0.0, ge=0)
    spindle_rpm: float = Field(default=0.0, ge=0)

    @model_validator(mode="after")
    def _keys_fit_the_shape(self) -> Tool:
        for key in sorted(foreign_keys(self.shape)):
            if getattr(self, key) != type(self).model_fields[key].default:
                raise ValueError(f"a {self.shape} tool has no {key}")
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
            "tool-text", f"'{text}' is not a tool", advice="write shape:diameter_mm, for example flat:6 or ball:2"
        ) from error
