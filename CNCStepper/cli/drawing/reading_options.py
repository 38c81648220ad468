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
    """What the options say; None where they say nothing."""

    unit_mm: float | None
    tolerance_mm: float
    join_mm: float

    def read_options(self, near_mm: float) -> ReadOptions:
        """Return how the drawing is read; gaps up to `near_mm` are reported."""
        from CNCStepper.drawing.read_drawing import ReadOptions

        return ReadOptions(self.tolerance_mm, self.unit_mm, near_mm=max(near_mm, self.join_mm), by_colour=True)


OPTIONS = (
    click.option("--unit-mm", type=NumberType(kind="unit"), help="The length of the file's unit, where it is wrong."),
    click.option("--tolerance", "tolerance_mm", type=NumberType(kind="tolerance"), default=0.005, show_default=True,
                 help="How far arcs may be off a spline or an ellipse, mm."),
    click.option("--join", "join_mm", type=NumberType(kind="tolerance"), default=0.05, show_default=True,
                 help="With --mend, ends that are moved together, mm."),
)  # fmt: skip


def reading_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options to a verb, which takes them as `reading`."""

    @functools.wraps(function)
    def called(*arguments: Any, unit_mm: float | None, tolerance_mm: float, join_mm: float, **others: Any) -> Any:
        return function(*arguments, reading=ReadingOptions(unit_mm, tolerance_mm, join_mm), **others)

    for option in reversed(OPTIONS):
        called = option(called)
    return called
