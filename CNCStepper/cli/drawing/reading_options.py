# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options with which verbs read drawings."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.options import NumberType

if TYPE_CHECKING:
    from CNCStepper.drawing.read_drawing import ReadOptions


@dataclass(frozen=True)
class ReadingOptions:
    """The values of the options; None without one."""

    unit_mm: float | None
    tolerance_mm: float
    join_mm: float
    height_mm: float | None
    trace: dict[str, Any]

    def read_options(self, near_mm: float) -> ReadOptions:
        """Return how the drawing is read; gaps up to `near_mm` are reported."""
        from CNCStepper.drawing.read_drawing import ReadOptions
        from CNCStepper.drawing.trace.options import TraceOptions

        near_mm = max(near_mm, self.join_mm)
        trace = TraceOptions(**self.trace)
        return ReadOptions(
            self.tolerance_mm, self.unit_mm, near_mm=near_mm, by_colour=True, height_mm=self.height_mm, trace=trace
        )


TRACE_KEYS = ("threshold", "invert", "blur_px", "width_mm", "dpi", "simplify_mm", "speck_mm2")
OPTIONS = (
    click.option("--unit-mm", type=NumberType(kind="unit"), help="The length of the file's unit, where it is wrong."),
    click.option("--tolerance", "tolerance_mm", type=NumberType(kind="tolerance"), default=0.005, show_default=True,
                 help="How far arcs may be off a spline or an ellipse, mm."),
    click.option("--join", "join_mm", type=NumberType(kind="tolerance"), default=0.05, show_default=True,
                 help="With --mend, ends that are moved together, mm."),
    click.option("--height", "height_mm", type=NumberType(),
                 help="Of a solid: the height of its faces or section, mm. [default: its outline from above]"),
    click.option("--threshold", type=click.IntRange(1, 255),
                 help="Of a picture: greys below it are dark. [default: found from the picture]"),
    click.option("--invert", is_flag=True, help="Of a picture: its light areas are traced."),
    click.option("--blur", "blur_px", type=NumberType(above=0.0), help="Of a picture: a blur of that radius, pixels."),
    click.option("--width-mm", type=NumberType(kind="length"), help="Of a picture: its width."),
    click.option("--dpi", type=NumberType(above=1.0), help="Of a picture: pixels an inch. [default: the file's, 96]"),
    click.option("--simplify", "simplify_mm", type=NumberType(kind="tolerance"),
                 help="Of a picture: how far curves may be off the pixels. [default: half a pixel]"),
    click.option("--speck", "speck_mm2", type=NumberType(above=0.0),
                 help="Of a picture: areas left out up to, mm². [default: four pixels]"),
)  # fmt: skip


def reading_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options to a verb, which takes them as `reading`."""

    @functools.wraps(function)
    def called(*arguments: Any, **others: Any) -> Any:
        own = {key: others.pop(key) for key in ("unit_mm", "tolerance_mm", "join_mm", "height_mm")}
        given = {key: others.pop(key) for key in TRACE_KEYS}
        trace = {key: value for key, value in given.items() if value is not None}
        return function(*arguments, reading=ReadingOptions(**own, trace=trace), **others)

    for option in reversed(OPTIONS):
        called = option(called)
    return called
