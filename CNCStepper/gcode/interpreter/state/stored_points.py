# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points that parameters hold: nine numbers in a row for X Y Z A B C U V W, lengths in the machine's own unit."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from CNCStepper.gcode.dialects.codes import ALL_AXES
from CNCStepper.gcode.interpreter.state.parameters import TURNING, Parameters
from CNCStepper.state import ZERO9

FURTHER = ALL_AXES[3:]
ROTATION = 9  # of a work system: its parameter comes after the nine offsets


def nine(values: Sequence[float]) -> tuple[float, ...]:
    """Return values of the first axes with 0 for the others."""
    return tuple(map(float, values)) + ZERO9[len(values) :]


def further_of(point: tuple[float, ...]) -> tuple[float, ...]:
    """Return A B C U V W of a point."""
    return point[3:]


def length_scale(axis: int, scale: float) -> float:
    """Return `scale` for an axis that measures lengths, 1 for one that turns."""
    return 1.0 if axis in TURNING else scale


def stored_point(parameters: Parameters, first: int, unit_mm: float) -> tuple[float, ...]:
    """Return the point that begins at parameter `first`, mm and degrees."""
    return tuple(parameters.get(first + axis) * length_scale(axis, unit_mm) for axis in range(9))


def store_point(
    parameters: Parameters, first: int, point: Sequence[float], unit_mm: float, axes: Iterable[int]
) -> None:
    """Keep some axes of a point, mm and degrees, in the parameters from `first` on."""
    for axis in axes:
        parameters.set(first + axis, point[axis] / length_scale(axis, unit_mm))
