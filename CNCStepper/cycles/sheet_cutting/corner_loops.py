# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Corners that a beam's or a knife's way goes round in its own manner.

loop      a sharp outside corner of a part: straight on past it, round in the scrap, and back in the new direction

 ---------------.---->--.        The beam never slows down on the part, and the corner stays sharp.
                X        )
                |`--.__.'

swivel    a drag knife's axis leads its edge by the blade offset: along a line it lies so far ahead, round an arc on a
          larger one with the same centre, and at a corner it swings round the corner, where the edge stays
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np

from CNCStepper.cycles.sheet_cutting.sheet_model import Loops
from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import COINCIDENT_MM

ROUND = 1.02  # a corner's arc has half a kerf as radius, within rounding and the offset's tolerance
STRAIGHT_RAD = 1e-6


def loops_at(path: Curve, loops: Loops, kerf_mm: float, side: int) -> list[tuple[int, Curve]]:
    """Return the loop for each sharp outside corner of a path: the row of the arc round it, and what replaces it.

    side: +1 where the part lies right of the path.
    """
    sweeps, radii = path.sweeps_rad * -side, np.nan_to_num(path.radii_mm, nan=np.inf)
    sharp = (sweeps > math.radians(loops.angle_deg)) & (sweeps < math.pi - STRAIGHT_RAD)
    rows = np.flatnonzero(sharp & (radii < kerf_mm / 2.0 * ROUND))
    segments = path.segments
    ahead, after = segments.direction(0.0), segments.direction(1.0)
    return [(row, _loop(segments, row, ahead[row], after[row], loops.radius_mm, side)) for row in rows.tolist()]


def with_loops(path: Curve, loops: Sequence[tuple[int, Curve]]) -> Curve:
    """Return a path with some of its arcs replaced."""
    if not loops:
        return path
    instead = dict(loops)
    parts = [instead.get(row) or Curve.trusted(path.xy[row : row + 2], path.bulge[row : row + 1])
             for row in range(len(path))]  # fmt: skip
    xy = np.concatenate([path.xy[:1], *(part.xy[1:] for part in parts)])
    return Curve.trusted(xy, np.concatenate([part.bulge for part in parts]))


def where_clear(
    paths: Sequence[Curve],
    found: Sequence[Sequence[tuple[int, Curve]]],
    clear: Callable[[list[int], list[Curve]], np.ndarray],
) -> tuple[list[Curve], int]:
    """Return the paths with those of their loops that are clear, and how many are not; clear: of items and loops."""
    items = [item for item, loops in enumerate(found) for _ in loops]
    fits = clear(items, [loop for loops in found for _, loop in loops]) if items else np.zeros(0, bool)
    kept: list[list[tuple[int, Curve]]] = [[] for _ in paths]
    for fit, item, loop in zip(fits.tolist(), items, (loop for loops in found for loop in loops), strict=True):
        if fit:
            kept[item].append(loop)
    return [with_loops(path, loops) for path, loops in zip(paths, kept, strict=True)], int((~fits).sum())


def knife_way(path: Curve, blade_mm: float) -> Curve:
    """Return the path of a drag knife's axis for a path of its edge, closed by overlapping the first segment."""
    segments = path.segments
    begin, end = segments.begin + blade_mm * segments.direction(0.0), segments.end + blade_mm * segments.direction(1.0)
    xy: list[complex] = [complex(begin[0])]
    bulge: list[float] = []
    for row in range(len(path)):
        if row:
            _swivel(xy, bulge, segments.begin[row], begin[row])
        xy.append(end[row])
        bulge.append(float(path.bulge[row]))
    if path.closed:
        _swivel(xy, bulge, segments.begin[0], begin[0])
    places = np.array(xy)
    return Curve(np.column_stack([places.real, places.imag]), np.array(bulge))


def _swivel(xy: list[complex], bulge: list[float], corner: complex, end: complex) -> None:
    """Swing round a corner to where the next segment's way begins."""
    if abs(end - xy[-1]) <= COINCIDENT_MM:
        return
    turn = (end - corner) / (xy[-1] - corner)
    bulge.append(math.tan(math.atan2(turn.imag, turn.real) / 4.0))
    xy.append(end)


def _loop(segments, row: int, ahead: complex, after: complex, radius_mm: float, side: int) -> Curve:
    """Return the loop in place of an arc: straight on, round, and back; in half turns at most."""
    begin, end = complex(segments.begin[row]), complex(segments.end[row])
    turn = abs(float(np.angle(after / ahead)))
    reach = abs(end - begin) / (2.0 * math.cos(turn / 2.0))
    corner = begin + ahead * reach
    beyond = radius_mm / math.tan((math.pi - turn) / 2.0)
    first, last = corner + ahead * beyond, corner - after * beyond
    centre = first + ahead * 1j * side * radius_mm
    middle = centre + (corner - centre) / abs(corner - centre) * -radius_mm
    half = side * math.tan((2.0 * math.pi - turn) / 8.0)
    places = np.array([begin, first, middle, last, end])
    return Curve(np.column_stack([places.real, places.imag]), np.array([0.0, half, half, 0.0]))
