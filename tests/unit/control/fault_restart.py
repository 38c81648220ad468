# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges a part that was cut in two goes: is all of it cut, nothing else, and little of it twice?

What the tool cuts is where it goes with its spindle on below the stock's top. A way into the cut from above is no cut
beside it: only the place in the plane counts there, and that it goes no deeper than the program.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import dist

from fault_judge import NEAR_STEPS, Place, Row, distance

PIECE_STEPS = 8.0  # in which a path is looked at; 0.1 mm


def cut_places(rows: Sequence[Row], top_steps: float) -> list[Place]:
    """Return places along what a trace cuts, in its order, at most PIECE_STEPS apart."""
    places = []
    for before, row in pairwise(rows):
        if row.spindle[1] > 0 and max(before.place[2], row.place[2]) < top_steps:
            count = max(1, round(dist(before.place, row.place) / PIECE_STEPS))
            shares = ((piece + 0.5) / count for piece in range(count))
            places += [_between(before.place, row.place, share) for share in shares]
    return places


def judge_restart(
    reference: Sequence[Row], goes: Sequence[Sequence[Row]], *, top_steps: float, overlap_steps: float
) -> str:
    """Return what is wrong with a part cut in several goes, "" where nothing is.

    overlap_steps: how much of a path may be cut by more than one go.
    """
    wanted = cut_places(reference, top_steps)
    cut = [cut_places(rows, top_steps) for rows in goes]
    if stray := next((place for go in cut for place in go if not _allowed(place, reference)), None):
        return f"it was cut at {stray}, where the program does not cut"
    times = [sum(_near(place, go) for go in cut) for place in wanted]
    if 0 in times:
        return f"it was not cut at {wanted[times.index(0)]}"
    twice = sum(count > 1 for count in times) * PIECE_STEPS
    return f"{twice:.0f} steps were cut more than once" if twice > overlap_steps else ""


def _allowed(place: Place, reference: Sequence[Row]) -> bool:
    """Return whether the program's path passes at or below a place."""
    return any(
        distance((*place[:2], 0.0), (*begin.place[:2], 0.0), (*end.place[:2], 0.0)) <= NEAR_STEPS
        and min(begin.place[2], end.place[2]) <= place[2] + NEAR_STEPS
        for begin, end in pairwise(reference)
    )


def _near(place: Place, cut: Sequence[Place]) -> bool:
    return any(dist(place, other) <= PIECE_STEPS + NEAR_STEPS for other in cut)


def _between(begin: Place, end: Place, share: float) -> Place:
    return tuple(a + (b - a) * share for a, b in zip(begin, end, strict=True))
