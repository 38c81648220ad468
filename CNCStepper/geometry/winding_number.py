# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: how often closed chains of lines and arcs run round a place, counter-clockwise counted positive.

A ray goes from the place towards greater x; each crossing upwards counts one, each downwards minus one. Every
row is cut where it runs level, so that a ray crosses each part at most once, and a part owns its lower end
and not its upper one: no vertex is counted twice, none is missed.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.geometry.box_tree import direction_at, place_at
from CNCStepper.kernels import njit


@njit
def windings(rows, places):
    """Return how often the closed chains in a table of rows run round each place, int64[m]; places: float64[m, 2].

    On a chain itself it is either side's count.
    """
    heights = places[:, 1].copy()
    turns, order = np.zeros(len(places), np.int64), np.argsort(heights, kind="mergesort")
    heights, cuts = heights[order], np.empty(4)
    for row in range(len(rows)):
        parts, bx, by = _level_cuts(rows, row, cuts), rows[row, 0], rows[row, 1]
        for part in range(parts):
            ex, ey = rows[row, 2], rows[row, 3]
            if part + 1 < parts:
                ex, ey = place_at(rows, row, cuts[part + 1])
            ux, uy = direction_at(rows, row, cuts[part])
            first, beyond = np.searchsorted(heights, min(by, ey)), np.searchsorted(heights, max(by, ey))
            for place in order[first:beyond]:
                dx, dy = places[place, 0] - bx, places[place, 1] - by
                of_chord = (ex - bx) * dy - (ey - by) * dx > 0.0
                of_circle = rows[row, 5] * (dx * dx + dy * dy) - 2.0 * (ux * dy - uy * dx) < 0.0
                left = of_chord or of_circle if rows[row, 4] > 0.0 else of_chord and (of_circle or rows[row, 4] == 0.0)
                if left == (ey > by):
                    turns[place] += 1 if left else -1
            bx, by = ex, ey
    return turns


@njit
def _level_cuts(rows, row, cuts):
    """Write the lengths between which a row runs only up or only down, ends included; return how many parts it has."""
    cuts[0], parts, k = 0.0, 1, rows[row, 5]
    if rows[row, 4] != 0.0:
        turn = (math.atan2(rows[row, 7], rows[row, 6]) * (-1.0 if k > 0.0 else 1.0)) % math.pi
        for _ in range(2):
            if 0.0 < turn < abs(rows[row, 4]):
                cuts[parts] = turn / abs(k)
                parts += 1
            turn += math.pi
    cuts[parts] = rows[row, 10]
    return parts
