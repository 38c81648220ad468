# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter: its shape and what it may do."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from CNCStepper.errors import JobError

Shape = Literal["flat", "ball", "bullnose", "v", "drill", "engraver"]


class Tool(BaseModel):
    """A tool as a job file names it; 0 means "not given" for feeds and speed."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    number: int = Field(ge=0, le=255)
    shape: Shape
    diameter_mm: float = Field(gt=0)
    feed_mm_min: float = Field(default=0.0, ge=0)
    plunge_mm_min: float = Field(default=0.0, ge=0)
    spindle_rpm: float = Field(default=0.0, ge=0)

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
