# SPDX-License-Identifier: LGPL-2.1-or-later
"""Points in space as few lines, arcs in one of the three planes, and helices about Z.

    points     0 1 2 3 4 5 6 7 8 9 ...      the way through them is first divided where it changes its kind:
               |  flat   | plane | space    in XY (Z stays), in ZX or YZ (Y or X stays), free in space

Each piece ends on a point, and reaches as far as one line or arc serves all points on its way in space. Corners
(see point_fit.py) are ends of pieces. A helix shares the tolerance between its plane and its height:

    away from the circle <= IN_PLANE * tolerance,  away from the even rise <= IN_HEIGHT * tolerance
"""

from __future__ import annotations

import itertools
import math
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.fitting.fit_kernels import fit_stretches, off_arc, serves
from CNCStepper.geometry.fitting.point_fit import CORNER_DEG, REACH, SURE, sharpest

PLANES = ((0, 1, 2), (2, 0, 1), (1, 2, 0))  # XY, ZX, YZ: the plane's axes, then the one that stays
IN_PLANE, IN_HEIGHT = 0.8, 0.6  # the hypotenuse of both is 1
LEAST_PLANAR = 4  # moves in one plane that are worth leaving a way in space for
CHECKS = 8  # places between two points at which the rise of a helix is checked


class Piece(NamedTuple):
    """A line, arc or helix from the end of the piece before to the point `last`.

    plane: of an arc, 0 XY, 1 ZX, 2 YZ. bulge: tan(sweep / 4) seen from the plane's normal; 0 is straight in space.
    """

    last: int
    plane: int
    bulge: float


def fit_space(points: np.ndarray, tolerance_mm: float) -> list[Piece]:
    """Return few pieces along the polyline through `points`, float64[n, 3], all different from their neighbours.

    No place of the one is farther than `tolerance_mm` from the other, and they run in the same order. Raises
    GeometryError for a tolerance that is not above 0.
    """
    if not tolerance_mm > 0:
        advice = "give a tolerance above 0"
        raise GeometryError("fit", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm", advice=advice)
    pieces: list[Piece] = []
    first = 0
    for last, plane in _stretches(points):
        part = points[first : last + 1]
        fitted = _in_space(part, tolerance_mm) if plane < 0 else _in_plane(part, plane, tolerance_mm)
        pieces += [Piece(first + piece.last, piece.plane, piece.bulge) for piece in fitted]
        first = last
    return pieces


def straight(points: np.ndarray, tolerance_mm: float) -> list[Piece]:
    """Return straight pieces alone, each reaching as far as doubling and halving find; corners stay."""
    bounds = [0, *_corners(points, tolerance_mm), len(points) - 1]
    ends: list[int] = []
    for first, last in itertools.pairwise(bounds):
        while first < last:
            first = _reach(points, first, last, tolerance_mm * SURE)
            ends.append(first)
    return [Piece(end, 0, 0.0) for end in ends]


def is_straight(points: np.ndarray, tolerance_mm: float) -> bool:
    """Whether the line from the first to the last point serves all between, and none runs back by more."""
    chord = points[-1] - points[0]
    length = float(np.linalg.norm(chord))
    if not length:
        return False
    local = points - points[0]
    along = local @ (chord / length)
    away = np.linalg.norm(local - along[:, None] * (chord / length), axis=1)
    beyond = np.maximum(np.maximum(-along, along - length), 0.0)
    back = np.maximum.accumulate(along) - along
    return bool((np.hypot(away, beyond) <= tolerance_mm).all() and (back <= tolerance_mm).all())


def _stretches(points: np.ndarray) -> list[tuple[int, int]]:
    """Return (last point, plane or -1) of each stretch of one kind, the longest in one plane taken first."""
    still = np.diff(points, axis=0) == 0.0
    reaches = [_run_ends(still[:, normal]) for _, _, normal in PLANES]
    stretches: list[tuple[int, int]] = []
    first, count = 0, len(still)
    while first < count:
        reach, plane = max((int(ends[first]), -plane) for plane, ends in enumerate(reaches))
        if reach - first >= LEAST_PLANAR or (reach > first and reach == count):
            stretches.append((reach, -plane))
            first = reach
            continue
        if stretches and stretches[-1][1] < 0:
            stretches[-1] = (first + 1, -1)
        else:
            stretches.append((first + 1, -1))
        first += 1
    return stretches


def _run_ends(still: np.ndarray) -> np.ndarray:
    """Return for each move the point at which the run of still moves that it begins ends; itself where it moves."""
    moving = np.flatnonzero(~still)
    place = np.searchsorted(moving, np.arange(len(still)))
    return np.append(moving, len(still))[place]


def _in_plane(points: np.ndarray, plane: int, tolerance_mm: float) -> list[Piece]:
    ends, bulges = _fit_flat(points, plane, tolerance_mm)
    return [Piece(int(end), plane, float(bulge)) for end, bulge in zip(ends, bulges, strict=True)]


def _in_space(points: np.ndarray, tolerance_mm: float) -> list[Piece]:
    """Return helices and lines, or lines alone where these are as few."""
    lines = straight(points, tolerance_mm)
    if len(lines) == 1 or (np.diff(points[:, :2], axis=0) == 0.0).all(axis=1).any():
        return lines
    helices = _helices(points, tolerance_mm)
    return helices if len(helices) < len(lines) else lines


def _helices(points: np.ndarray, tolerance_mm: float) -> list[Piece]:
    """Return what serves in the plane, halved where the rise along it is not even."""
    pieces: list[Piece] = []
    first = 0
    ends, bulges = _fit_flat(points, 0, IN_PLANE * tolerance_mm)
    for end, bulge in zip(ends.tolist(), bulges.tolist(), strict=True):
        part = points[first : end + 1]
        if end - first == 1 or is_straight(part, tolerance_mm * SURE):
            pieces.append(Piece(end, 0, 0.0))
        elif _rises_evenly(part, bulge, IN_HEIGHT * tolerance_mm * SURE):
            pieces.append(Piece(end, 0, bulge))
        else:
            middle = (end - first) // 2
            for begin, half in ((first, part[: middle + 1]), (first + middle, part[middle:])):
                pieces += [piece._replace(last=begin + piece.last) for piece in _in_space(half, tolerance_mm)]
        first = end
    return pieces


def _fit_flat(points: np.ndarray, plane: int, tolerance_mm: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the last point and the bulge of each line or arc that serves points seen in one plane."""
    a, b, _ = PLANES[plane]
    z = np.ascontiguousarray(points[:, a] + 1j * points[:, b])
    breaks = np.unique([0, *_corners(points, tolerance_mm), len(z) - 1]).astype(np.int64)
    return fit_stretches(z, breaks, tolerance_mm * SURE)


def _rises_evenly(points: np.ndarray, bulge: float, tolerance_mm: float) -> bool:
    """Whether the height grows with the length along the arc, at the points and between them."""
    share = np.linspace(0.0, 1.0, CHECKS, endpoint=False)
    between = (points[:-1, None] + share[:, None] * np.diff(points, axis=0)[:, None]).reshape(-1, 3)
    between = np.vstack([between, points[-1:]])
    chord, sweep = complex(*(points[-1] - points[0])[:2]), 4.0 * math.atan(bulge)
    if not chord or not bulge:
        return False
    tangent = chord / abs(chord) * np.exp(-0.5j * sweep)
    curvature = 2.0 * math.sin(sweep / 2.0) / abs(chord)
    local = ((between[:, 0] - points[0, 0]) + 1j * (between[:, 1] - points[0, 1])) * np.conj(tangent)
    along = np.array([off_arc(complex(place), curvature, sweep / curvature)[1] for place in local])
    even = points[0, 2] + np.clip(along / (sweep / curvature), 0.0, 1.0) * (points[-1, 2] - points[0, 2])
    return bool((np.abs(between[:, 2] - even) <= tolerance_mm).all())


def _corners(points: np.ndarray, tolerance_mm: float) -> list[int]:
    """Return the numbers of the points at which the path has a corner in space, ascending."""
    place = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    reach = REACH * tolerance_mm
    before, after = (
        np.stack([np.interp(place + way, place, points[:, axis]) for axis in range(3)], axis=1)
        for way in (-reach, reach)
    )
    come, go = points - before, after - points
    across = np.linalg.norm(np.cross(come, go), axis=1)
    turn = np.arctan2(across, (come * go).sum(axis=1))
    turn[[0, -1]] = 0.0
    return [int(corner) for corner in sharpest(place, turn, math.radians(CORNER_DEG), reach / 2.0)]


def _reach(points: np.ndarray, first: int, last: int, tolerance_mm: float) -> int:
    """Return how far one line serves from the point `first`."""
    good, bad, step = first + 1, last + 1, 2
    while good < last and bad > last:
        trial = min(first + step, last)
        if is_straight(points[first : trial + 1], tolerance_mm):
            good = trial
        else:
            bad = trial
        step *= 2
    while bad - good > 1 and bad <= last:
        trial = (good + bad) // 2
        if is_straight(points[first : trial + 1], tolerance_mm):
            good = trial
        else:
            bad = trial
    return good


def serves_points(points: np.ndarray, plane: int, bulge: float, tolerance_mm: float) -> bool:
    """Whether the arc or helix from the first to the last point stays within the tolerance of the path through all."""
    if not tolerance_mm > 0:
        return False
    a, b, normal = PLANES[plane]
    z = np.ascontiguousarray(points[:, a] + 1j * points[:, b])
    if (points[:, normal] == points[0, normal]).all():
        return bool(serves(z, 0, len(z) - 1, bulge, tolerance_mm))
    flat = serves(z, 0, len(z) - 1, bulge, IN_PLANE * tolerance_mm)
    return bool(flat and plane == 0 and _rises_evenly(points, bulge, IN_HEIGHT * tolerance_mm))
