# SPDX-License-Identifier: LGPL-2.1-or-later
"""The way from where somebody jogged to back to where the tool stood: up, over, and slowly down.

over  ┌───────────────┐   at the height of the highest
up    │               │   down, slowly
      o jogged to     x where the tool stood
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import inf

OVER_MM_MIN, DOWN_MM_MIN = 1000.0, 100.0
THERE_MM = 0.005  # what is reported is rounded

Axes = tuple[float | None, float | None, float | None]  # an axis that is None stays


def over(here_mm: Sequence[float], there_mm: Sequence[float], top_mm: float = -inf) -> Iterator[tuple[Axes, float]]:
    """Yield the place and the speed in mm/min of each straight move; none from a place to itself.

    top_mm: a height of Z that is free all the way over; the higher of the two places at least is gone to.
    """
    aside = any(abs(a - b) > THERE_MM for a, b in zip(here_mm[:2], there_mm[:2], strict=True))
    top_mm = max(here_mm[2], there_mm[2], top_mm if aside else -inf)
    if top_mm - here_mm[2] > THERE_MM:
        yield (None, None, top_mm), OVER_MM_MIN
    if aside:
        yield (there_mm[0], there_mm[1], None), OVER_MM_MIN
    if top_mm - there_mm[2] > THERE_MM:
        yield (None, None, there_mm[2]), DOWN_MM_MIN
