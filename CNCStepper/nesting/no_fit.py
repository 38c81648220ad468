# SPDX-License-Identifier: LGPL-2.1-or-later
r"""No-fit polygons: where the origin of a part may not lie, beside another part, in its holes and on a sheet.

    no_fit(A, B)    = { p : B + p overlaps A }     = A ⊕ (-B), a Minkowski sum of convex pieces
    inner_fit(S, B) = { p : B + p lies within S }  = (S - b) less  (rim of S) ⊕ (-rim of B), b a corner of B

Source: Bennell and Oliveira, "The geometry of nesting problems: a tutorial", EJOR 184 (2008). All polygons are
shapely's, in mm. Minkowski sums of rims are unions of parallelograms, one for each pair of edges.
"""

from __future__ import annotations

import numpy as np
import shapely
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

CONVEX = 1e-12  # relative: what bends less is straight
SEAM_MM = 1e-8  # between parallelograms of edges that are nearly parallel


def no_fit(still: Polygon, part: Polygon) -> BaseGeometry:
    """Return where the origin of `part` may not lie beside `still`, taken without holes; on its rim they touch."""
    sums = [
        (one[:, None, :] - other[None, :, :]).reshape(-1, 2)
        for one in convex_pieces(still)
        for other in convex_pieces(part)
    ]
    return shapely.union_all(shapely.convex_hull([shapely.multipoints(each) for each in sums]))


def inner_fit(room: Polygon, part: Polygon) -> BaseGeometry:
    """Return where the origin of `part` may lie so that it is within `room`, both taken without their holes."""
    rim, own = np.asarray(room.exterior.coords), np.asarray(part.exterior.coords)
    low, high = np.array(part.bounds[:2]), np.array(part.bounds[2:])
    if _is_rectangle(rim):
        first, last = rim.min(axis=0) - low, rim.max(axis=0) - high
        return shapely.box(*first, *last) if (last > first).all() else Polygon()
    if ((rim.max(axis=0) - rim.min(axis=0)) < high - low).any():
        return Polygon()
    within = shapely.transform(Polygon(rim), lambda xy: xy - own[0])
    return within.difference(_rim_sum(rim, -own).buffer(SEAM_MM, join_style="mitre"))


def _is_rectangle(rim: np.ndarray) -> bool:
    """Return whether a closed ring is a rectangle along the axes."""
    if len(rim) != 5:
        return False
    edges = np.diff(rim, axis=0)
    return bool(((edges == 0.0).sum(axis=1) == 1).all())


def _rim_sum(one: np.ndarray, other: np.ndarray) -> BaseGeometry:
    """Return the sum of two closed rings, float64[n, 2] each: the union of the parallelograms of their edges."""
    first, second = one[:-1, None, :] + other[None, :-1, :], one[1:, None, :] + other[None, :-1, :]
    third, fourth = one[1:, None, :] + other[None, 1:, :], one[:-1, None, :] + other[None, 1:, :]
    corners = np.stack([first, second, third, fourth, first], axis=2).reshape(-1, 5, 2)
    side, across = corners[:, 1] - corners[:, 0], corners[:, 3] - corners[:, 0]
    areas = np.abs(side[:, 0] * across[:, 1] - side[:, 1] * across[:, 0])
    flat = areas <= CONVEX * np.hypot(*side.T) * np.hypot(*across.T)
    return shapely.union_all(shapely.polygons(corners[~flat]))


def convex_pieces(polygon: Polygon) -> list[np.ndarray]:
    """Return convex pieces of a polygon's outline, float64[n, 2] each, counter-clockwise; its holes are filled."""
    xy = np.asarray(shapely.geometry.polygon.orient(Polygon(polygon.exterior)).exterior.coords)[:-1]
    if _is_convex(xy.tolist()):
        return [xy]
    return [xy[piece] for piece in _merged(_triangles(xy.tolist()), xy.tolist())]


def _is_convex(points: list[list[float]]) -> bool:
    count = len(points)
    return all(_bend(points[n - 1], points[n], points[(n + 1) % count]) >= 0.0 for n in range(count))


def _bend(one: list[float], two: list[float], three: list[float]) -> float:
    """Return twice the signed area of a triangle, 0 where that is rounding."""
    ax, ay, bx, by = two[0] - one[0], two[1] - one[1], three[0] - two[0], three[1] - two[1]
    area = ax * by - ay * bx
    return 0.0 if abs(area) <= CONVEX * (abs(ax) + abs(ay)) * (abs(bx) + abs(by)) else area


def _triangles(points: list[list[float]]) -> list[list[int]]:
    """Return the triangles of a simple counter-clockwise polygon by cutting ears, as numbers of its corners."""
    left, found = list(range(len(points))), list[list[int]]()
    while len(left) > 3:
        number = next((n for n in range(len(left)) if _is_ear(points, left, n)), None)
        if number is None:  # only corners on straight lines are left over
            number = min(range(len(left)), key=lambda n: abs(_bend(*_around(points, left, n))))
        before, after = left[number - 1], left[(number + 1) % len(left)]
        if _bend(*_around(points, left, number)) > 0.0:
            found.append([before, left[number], after])
        del left[number]
    if _bend(*(points[corner] for corner in left)) > 0.0:
        found.append(left)
    return found


def _around(points: list[list[float]], left: list[int], number: int) -> tuple[list[float], list[float], list[float]]:
    return points[left[number - 1]], points[left[number]], points[left[(number + 1) % len(left)]]


def _is_ear(points: list[list[float]], left: list[int], number: int) -> bool:
    one, two, three = _around(points, left, number)
    if _bend(one, two, three) <= 0.0:
        return False
    ends = (one, two, three)
    return not any(
        points[corner] not in ends
        and _bend(one, two, points[corner]) >= 0.0
        and _bend(two, three, points[corner]) >= 0.0
        and _bend(three, one, points[corner]) >= 0.0
        for corner in left
    )


def _merged(triangles: list[list[int]], points: list[list[float]]) -> list[list[int]]:
    """Return the pieces joined over common edges as long as they stay convex (Hertel and Mehlhorn)."""
    pieces = [list(triangle) for triangle in triangles]
    number = 0
    while number < len(pieces):
        joined = next(
            (
                (other, both)
                for other in range(number + 1, len(pieces))
                if (both := _join(pieces, number, other, points))
            ),
            None,
        )
        if joined is None:
            number += 1
        else:
            pieces[number] = joined[1]
            del pieces[joined[0]]
    return pieces


def _join(pieces: list[list[int]], number: int, other: int, points: list[list[float]]) -> list[int] | None:
    """Return two pieces as one where they share an edge and are convex together."""
    one, two = pieces[number], pieces[other]
    for place, corner in enumerate(one):
        after = one[(place + 1) % len(one)]
        if corner in two and after in two and two[(two.index(after) + 1) % len(two)] == corner:
            start = two.index(corner)
            rest = [two[(start + step) % len(two)] for step in range(1, len(two) - 1)]
            both = [*one[: place + 1], *rest, *one[place + 1 :]]
            return both if _is_convex([points[n] for n in both]) else None
    return None
