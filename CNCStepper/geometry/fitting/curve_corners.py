# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a parametric curve has a corner or a cusp: where its direction jumps, however closely one looks.

Three neighbouring samples between which the way turns by more than SHARP are looked at again, finer, about the
sharpest of them; a bend becomes gentle on the way, a corner stays as sharp until it is found to SAME_MM.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

SAMPLES = 256
SHARP_RAD = np.radians(10.0)
SAME_MM = 1e-7
FINER = 8  # times, at each look
LOOKS = 18  # FINER ** LOOKS is beyond the resolution of a float
Function = Callable[[np.ndarray], np.ndarray]  # parameters float64[m] -> float64[m, 2]


def corner_parameters(point: Function, first: float, last: float, knots: Sequence[float] = ()) -> list[float]:
    """Return the parameters of the corners between `first` and `last`, in that direction.

    A corner at one of the `knots` is that knot exactly.
    """
    low, high = min(first, last), max(first, last)
    inner = np.array([knot for knot in sorted(knots) if low < knot < high])
    every = np.unique(np.concatenate([np.linspace(low, high, SAMPLES + 1), inner, _between([low, *inner, high])]))
    turns = _turns(point(every))
    found = [
        _sharpened(point, *every[number : number + 3].tolist()) for number in np.flatnonzero(turns > SHARP_RAD).tolist()
    ]
    apart = _without_twins([place for place in found if place is not None], (high - low) / SAMPLES**2, inner)
    return apart if last > first else apart[::-1]


def _sharpened(point: Function, low: float, middle: float, high: float) -> float | None:
    """Return where between `low` and `high` the corner is; None when it is only a bend."""
    for _ in range(LOOKS):
        fine = np.concatenate([np.linspace(low, middle, FINER, endpoint=False), np.linspace(middle, high, FINER + 1)])
        places = point(fine)
        turns = _turns(places)
        sharpest = int(turns.argmax())
        if not turns[sharpest] > SHARP_RAD:
            return None
        low, middle, high = fine[sharpest : sharpest + 3].tolist()
        if np.hypot(*np.diff(places[sharpest : sharpest + 3], axis=0).T).sum() <= SAME_MM:
            break
    return middle


def _turns(places: np.ndarray) -> np.ndarray:
    """Return by how much the way turns at each inner one of the points, rad, 0 where two are the same."""
    steps = np.diff(places @ (1.0, 1j))
    return np.abs(np.angle(steps[1:] * np.conj(steps[:-1])))


def _between(bounds: Sequence[float]) -> np.ndarray:
    ascending = np.asarray(bounds, float)
    return (ascending[:-1, None] + np.diff(ascending)[:, None] * np.array([0.23, 0.51, 0.79])).ravel()


def _without_twins(ascending: list[float], same: float, knots: np.ndarray) -> list[float]:
    """Return the corners, each once: two samples beside one find it twice."""
    kept: list[float] = []
    for place in sorted(ascending):
        near = knots[np.abs(knots - place) <= same]
        exact = float(near[np.abs(near - place).argmin()]) if len(near) else place
        if not kept or exact - kept[-1] > same:
            kept.append(exact)
    return kept
