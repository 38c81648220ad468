# SPDX-License-Identifier: LGPL-2.1-or-later
"""The two sides of a half section, and curves as the rows that a `[[profile]]` table of a job file takes.

      r ^        outside: from the front face's inner end along it, over the part, to the first place farthest back
        |  ______________
        | |              |     +------> front: the largest z
        | |__    ________|
        |____|__|__________> z     bore: from the front face's inner end inwards, to the back or to the axis

Curves lie in (z, r), mm.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve, joined, straight
from CNCStepper.job.turning.profile_form import CHORDS_MM, Xis
from CNCStepper.quantities import QUANTITIES
from CNCStepper.tolerances import NO_LENGTH_MM, SAME_MM

Side = Literal["outside", "bore"]
DECIMALS = 9  # of a row's numbers, mm: what drawings lose is less


def chained(pieces: Sequence[Curve]) -> list[Curve]:
    """Return pieces joined where ends lie within SAME_MM of each other; closed chains end where they begin."""
    rest, chains = list(pieces), []
    while rest:
        chain = [rest.pop(0)]
        while (found := _next(rest, chain[-1].xy[-1])) is not None:
            chain.append(found)
        while (found := _next(rest, chain[0].xy[0])) is not None:
            chain.insert(0, found.reversed())
        chains.append(_one(chain))
    return chains


def _next(rest: list[Curve], end: np.ndarray) -> Curve | None:
    """Take the piece that begins at a place out of the rest, turned where it ends there; None where there is none."""
    for number, piece in enumerate(rest):
        for turned in (piece, piece.reversed()):
            if math.dist(turned.xy[0], end) <= SAME_MM:
                del rest[number]
                return turned
    return None


def _one(chain: list[Curve]) -> Curve:
    xy = np.vstack([chain[0].xy[:1], *(piece.xy[1:] for piece in chain)])
    if math.dist(xy[0], xy[-1]) <= SAME_MM:
        xy[-1] = xy[0]
    return Curve(xy, np.concatenate([piece.bulge for piece in chain]))


def side_of(boundary: Curve, side: Side) -> Curve:
    """Return one side of a half section from the front to the back.

    boundary: of the region, closed, or open with both ends on the axis. Raises JobError for a part without that bore.
    """
    loop = _counterclockwise(boundary)
    z, r = loop.xy[:-1].T
    front = np.flatnonzero(z >= z.max() - SAME_MM)
    loop = loop.started_at(int(front[np.argmin(r[front])]))
    z, r = loop.xy.T
    back = np.flatnonzero(z <= z.min() + SAME_MM)
    if side == "outside":
        return _stretch(loop, 0, int(back[0]))
    inner = loop.reversed()
    z, r = inner.xy.T
    ends = np.flatnonzero((z <= z.min() + SAME_MM) | (r <= SAME_MM))
    if not ends[0]:
        what, advice = "the part has no bore that opens at its front end", "turn it round, or take its outside"
        raise JobError("profile-bore", what, advice=advice)
    return _stretch(inner, 0, int(ends[0]))


def _counterclockwise(boundary: Curve) -> Curve:
    """Return the boundary closed along the axis, counter-clockwise, with a vertex where an arc is upright."""
    loop = boundary
    if not loop.closed:
        loop = joined([loop, straight(tuple(loop.xy[-1]), tuple(loop.xy[0]))])
    loop = loop if loop.area_mm2 > 0 else loop.reversed()
    return joined([piece for number in range(len(loop)) for piece in _upright_parts(loop, number)])


def _upright_parts(loop: Curve, number: int) -> list[Curve]:
    """Return a segment of a curve, an arc divided where its z is largest and smallest."""
    segment = _stretch(loop, number, number + 1)
    bulge = float(segment.bulge[0])
    if not bulge:
        return [segment]
    centre, sweep = _centre(segment), 4 * math.atan(bulge)
    first = math.atan2(*(segment.xy[0] - centre)[::-1])
    shares = sorted(share for turn in range(-4, 5) if 0 < (share := (turn * math.pi - first) / sweep) < 1)
    return segment.split([share * segment.length_mm for share in shares])


def _centre(segment: Curve) -> np.ndarray:
    """Return the centre of a curve of one arc."""
    (begin, end), bulge = segment.xy, float(segment.bulge[0])
    along = (end - begin) / 2
    return (begin + end) / 2 + np.array([-along[1], along[0]]) * ((1 - bulge * bulge) / (2 * bulge))  # type: ignore[no-any-return]


def from_front(chain: Curve) -> Curve:
    """Return a chain as a profile runs: from the larger z on; one that is upright from the axis on."""
    (z_first, r_first), (z_last, r_last) = chain.xy[[0, -1]]
    if abs(z_first - z_last) > SAME_MM:
        return chain if z_first > z_last else chain.reversed()
    return chain if r_first <= r_last else chain.reversed()


def profile_rows(chain: Curve, x_is: Xis) -> list[Any]:
    """Return the rows [x, z] or {to, arc, centre} of a chain, as `points` of a profile take them."""
    scale = 2.0 if x_is == "diameter" else 1.0
    rows: list[Any] = [_pair(chain.xy[0], scale)]
    for number in range(len(chain)):
        rows += _rows(_stretch(chain, number, number + 1), scale)
    return rows


def _rows(segment: Curve, scale: float) -> list[Any]:
    bulge, to = float(segment.bulge[0]), _pair(segment.xy[1], scale)
    if abs(bulge) * segment.length_mm / 2 < NO_LENGTH_MM:
        return [to]
    centre = _centre(segment)
    if max(map(abs, _pair(centre, scale))) > QUANTITIES["coordinate"].most:  # almost a line
        return [_pair(point, scale) for point in segment.points(CHORDS_MM)[1:]]
    return [{"to": to, "arc": "ccw" if bulge > 0 else "cw", "centre": _pair(centre, scale)}]


def _pair(point: np.ndarray, scale: float) -> list[float]:
    z, r = point.tolist()
    return [round(r * scale, DECIMALS) + 0.0, round(z, DECIMALS) + 0.0]


def _stretch(chain: Curve, first: int, last: int) -> Curve:
    """Return the part of a curve between two of its vertices."""
    return Curve(chain.xy[first : last + 1], chain.bulge[first:last])
