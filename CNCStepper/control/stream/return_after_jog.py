# SPDX-License-Identifier: LGPL-2.1-or-later
"""The return path from a jogged position to the held tool position: up, over, and slowly down.

over  ┌───────────────┐   at the height of the highest
up    │               │   down, slowly
      o jogged to     x held tool position
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set
from math import inf
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from CNCStepper.machine.backlash import Backlash

OVER_MM_MIN, DOWN_MM_MIN = 1000.0, 100.0
THERE_MM = 0.005  # reports are rounded
UP = 2  # the axis
DOWNWARDS = -1

Point = tuple[float, float, float]
Axes = tuple[float | None, float | None, float | None]  # an axis that is None stays


def over(here_mm: Sequence[float], there_mm: Sequence[float], top_mm: float = -inf) -> Iterator[tuple[Axes, float]]:
    """Yield the place and the speed in mm/min of each straight move; none from a place to itself.

    top_mm: a height of Z that is free all the way over; at least the higher of the two places.
    """
    aside = any(abs(a - b) > THERE_MM for a, b in zip(here_mm[:2], there_mm[:2], strict=True))
    top_mm = max(here_mm[2], there_mm[2], top_mm if aside else -inf)
    if top_mm - here_mm[2] > THERE_MM:
        yield (None, None, top_mm), OVER_MM_MIN
    if aside:
        yield (there_mm[0], there_mm[1], None), OVER_MM_MIN
    if top_mm - there_mm[2] > THERE_MM:
        yield (None, None, there_mm[2]), DOWN_MM_MIN


def over_backlash(here_mm: Point, there_mm: Point, top_mm: float, play: Backlash) -> Iterator[tuple[Axes, float]]:
    """Yield the places and speeds of the motors' way from where they were jogged to, as `over`, to `landed_mm`.

    Each axis ends by a way longer than its gap: X and Y above the place, in the sense in which they are true, Z down.
    """
    clear_mm = max(here_mm[UP], top_mm, landed_mm(there_mm, play)[UP] + play.backlash_mm[UP])
    x_mm, y_mm = (there_mm[axis] - play.true_sense[axis] * play.backlash_mm[axis] for axis in (0, 1))
    yield from over(here_mm, (x_mm, y_mm, clear_mm), clear_mm)
    yield (there_mm[0], there_mm[1], None), OVER_MM_MIN
    yield (None, None, landed_mm(there_mm, play)[UP]), DOWN_MM_MIN


def back_over_backlash(
    here_mm: Sequence[float],
    there_mm: Sequence[float],
    ahead_mm: Sequence[float],
    loose: Set[int],
    top_mm: float,
    play: Backlash,
) -> Iterator[tuple[Axes, float]]:
    """Yield positions and speeds of the motors' return to where they were, as far ahead of the tool as before.

    loose: the axes of which nobody knows on which side they stand, Z where X or Y is; the others stand as they stood.
    The tool reaches its place and stays there while the motors cross the rest of their gaps.
    """
    tool = (place - ahead * (axis in loose) for axis, (place, ahead) in enumerate(zip(there_mm, ahead_mm, strict=True)))
    yield from over_backlash(_point(here_mm), _point(tuple(tool)), top_mm, play.of_axes(loose))
    yield _point(there_mm), DOWN_MM_MIN


def landed_mm(there_mm: Point, play: Backlash) -> Point:
    """Return the motors' position after they came to a place of the tool by `over_backlash`."""
    return there_mm[0], there_mm[1], there_mm[UP] + play.ahead_mm(UP, DOWNWARDS)


def _point(place_mm: Sequence[float]) -> Point:
    x, y, z = place_mm
    return x, y, z
