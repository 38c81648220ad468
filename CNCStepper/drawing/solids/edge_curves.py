# SPDX-License-Identifier: LGPL-2.1-or-later
"""Edges of a solid, as the process that reads it sends them, as curves in one order whichever OCCT has found them.

    ["line", x, y, x, y]                                begin and end, mm
    ["ellipse", x, y, ax, ay, bx, by, first, last]      centre, half axes, parameters: centre + a cos(t) + b sin(t)
    ["spline", degree, poles, weights, knots]           poles [[x, y], ...], knots with their multiplicity

Lines and circles are exact, ellipses and splines arcs within a tolerance. Another version of OCCT, or the file in place
of the script, may divide an edge, turn it, or list it elsewhere. So pieces of one line or circle that meet become one,
a closed chain runs counter-clockwise from its leftmost, then lowest corner, and chains are in the order of these.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import JobError, Text
from CNCStepper.geometry.chain_joining import chained
from CNCStepper.geometry.curve import Curve, circle, joined
from CNCStepper.geometry.fitting.curve_to_arcs import fit_arcs, fit_curve
from CNCStepper.tolerances import SAME_MM

MOST_EDGES = 100_000
MOST_DEGREE = 25
ROUND_SHARE = 1e-9  # half axes that differ by less, relatively, are those of a circle
STEADY_CURVATURE = 1e-7  # 1/mm
DIGITS = 6  # of a place in mm, by which corners are compared
PLACE_DIGITS, BULGE_DIGITS = 7, 10  # that are kept


def loops_of(edges: Sequence[Sequence[Any]], tolerance_mm: float) -> list[Curve]:
    """Return the chains of edges in the order of their first corners; raises JobError for what is no edge."""
    if len(edges) > MOST_EDGES:
        value, limit = f"{len(edges)}", f"{MOST_EDGES}"
        advice = "simplify the solid"
        raise JobError("solid-large", "the solid has too many edges there", value=value, limit=limit, advice=advice)
    pieces = [_curve(edge, tolerance_mm) for edge in edges]
    chains, _ = chained([piece for piece in pieces if piece.length_mm > SAME_MM])
    return ordered([rounded(canonical(chain)) for chain in chains])


def rounded(chain: Curve) -> Curve:
    """Return a chain without the last digits, in which two versions of OCCT differ; what ties to one stays tied."""
    return Curve(np.round(chain.xy, PLACE_DIGITS) + 0.0, np.round(chain.bulge, BULGE_DIGITS))


def ordered(chains: Sequence[Curve]) -> list[Curve]:
    """Return chains in the order of their first corners: x, then y, then length."""
    return sorted(chains, key=lambda chain: (*_rounded(chain.xy[0]), round(chain.length_mm, DIGITS)))


def canonical(chain: Curve) -> Curve:
    """Return a chain without the ends of pieces that go on, in its one sense, from its one first corner."""
    if not chain.closed:
        first, last = _rounded(chain.xy[0]), _rounded(chain.xy[-1])
        return merged(chain if first <= last else chain.reversed())
    chain = chain if chain.area_mm2 >= 0.0 else chain.reversed()
    whole = _circle_of(chain)
    if whole is not None:
        return whole
    starts = np.flatnonzero(~_goes_on(chain))
    if not len(starts):
        return chain
    chain = merged(chain.started_at(int(starts[0])))
    corners = [_rounded(corner) for corner in chain.xy[:-1]]
    return chain.started_at(corners.index(min(corners)))


def merged(chain: Curve) -> Curve:
    """Return a chain with pieces of one line or circle that follow each other as one, in arcs below a full turn."""
    goes_on = _goes_on(chain)
    angles = chain.sweeps_rad
    kept_xy: list[np.ndarray] = [chain.xy[0]]
    sweeps: list[float] = []
    for row in range(len(chain)):
        if row and goes_on[row] and abs(sweeps[-1] + angles[row]) < 1.5 * math.pi:
            kept_xy[-1], sweeps[-1] = chain.xy[row + 1], sweeps[-1] + angles[row]
        else:
            kept_xy.append(chain.xy[row + 1])
            sweeps.append(angles[row])
    return Curve(np.array(kept_xy), np.tan(np.array(sweeps) / 4.0))


def _goes_on(chain: Curve) -> np.ndarray:
    """Return at which vertices, the last one apart, the line or circle before goes on; the first of an open one not."""
    turn = np.einsum("ij,ij->i", chain.begin_directions, np.roll(chain.end_directions, 1, axis=0))
    bend = np.abs(chain.curvatures - np.roll(chain.curvatures, 1))
    goes_on = (turn > 1.0 - STEADY_CURVATURE**2 - 1e-12) & (bend < STEADY_CURVATURE)
    if not chain.closed:
        goes_on[0] = False
    return goes_on


def _circle_of(chain: Curve) -> Curve | None:
    """Return a chain that is a whole circle as one that begins at its rightmost place."""
    if not (chain.bulge > 0.0).all() or abs(chain.sweeps_rad.sum() - math.tau) > STEADY_CURVATURE:
        return None
    centres, radii = chain.centres, chain.radii_mm
    if np.ptp(radii) > SAME_MM or np.ptp(centres, axis=0).max() > SAME_MM:
        return None
    x, y = np.round(centres[0], PLACE_DIGITS).tolist()
    return circle((x, y), round(float(radii[0]), PLACE_DIGITS))


def _rounded(corner: np.ndarray) -> tuple[float, float]:
    x, y = np.round(corner, DIGITS).tolist()
    return x + 0.0, y + 0.0


def _curve(edge: Sequence[Any], tolerance_mm: float) -> Curve:
    """Return an edge as a curve; raises JobError for one that is none."""
    checkpoint()
    try:
        kind, *values = edge
        if kind == "line":
            x, y, to_x, to_y = map(float, values)
            return Curve(np.array([(x, y), (to_x, to_y)]), np.zeros(1))
        if kind == "ellipse":
            return _ellipse(tolerance_mm, *map(float, values))
        if kind == "spline":
            return _spline(tolerance_mm, *values)
    except (TypeError, ArithmeticError, LookupError) as error:
        raise JobError(
            "solid-edge", Text("an edge of the solid is no curve: {error}", error=error), advice="repair the solid"
        ) from error
    raise JobError("solid-edge", "an edge of the solid is of no kind that is known", advice="repair the solid")


def _ellipse(
    tolerance_mm: float, x: float, y: float, ax: float, ay: float, bx: float, by: float, first: float, last: float
) -> Curve:
    centre, along, across = np.array([x, y]), np.array([ax, ay]), np.array([bx, by])

    def point(t: np.ndarray) -> np.ndarray:
        return centre + np.outer(np.cos(t), along) + np.outer(np.sin(t), across)  # type: ignore[no-any-return]

    sweep = last - first
    is_round = abs(math.hypot(ax, ay) - math.hypot(bx, by)) <= ROUND_SHARE * math.hypot(ax, ay)
    parts = max(1, math.ceil(abs(sweep) / (math.pi if is_round else math.pi / 2.0) - 1e-9))
    bounds = np.linspace(first, last, parts + 1)
    if is_round:
        bulge = math.copysign(math.tan(abs(sweep) / parts / 4.0), sweep * (ax * by - ay * bx))
        curve = Curve(point(bounds), np.full(parts, bulge))
    else:
        curve = joined(fit_arcs(point, *part, tolerance_mm) for part in itertools.pairwise(bounds.tolist()))
    whole = math.isclose(abs(sweep), math.tau, rel_tol=1e-9)
    return Curve(np.vstack([curve.xy[:-1], curve.xy[:1]]), curve.bulge) if whole else curve


def _spline(tolerance_mm: float, degree: int, poles: Any, weights: Any, knots: Any) -> Curve:
    points, heavy, steps = np.array(poles, float), np.array(weights, float), np.array(knots, float)
    if not (1 <= degree <= MOST_DEGREE and len(steps) == len(points) + degree + 1 and len(heavy) == len(points)):
        what, advice = "the knots and poles of a spline of the solid do not belong together", "repair the solid"
        raise JobError("solid-edge", what, advice=advice)
    first, last = float(steps[degree]), float(steps[len(points)])
    inner = np.unique(steps[(steps > first) & (steps < last)]).tolist()
    columns = np.column_stack([points * heavy[:, None], heavy])

    def point(t: np.ndarray) -> np.ndarray:
        checkpoint()
        places = de_boor(degree, columns, steps, t)
        return places[:, :2] / places[:, 2:]  # type: ignore[no-any-return]

    return fit_curve(point, first, last, tolerance_mm, inner)


def de_boor(degree: int, poles: np.ndarray, knots: np.ndarray, t: np.ndarray) -> np.ndarray:
    """Return the places of a B-spline at parameters t, by de Boor's algorithm (A Practical Guide to Splines, 1978)."""
    span = np.clip(np.searchsorted(knots, t, "right") - 1, degree, len(poles) - 1)
    rows = poles[span[:, None] + np.arange(-degree, 1)]
    for level in range(1, degree + 1):
        for row in range(degree, level - 1, -1):
            low, high = knots[span + row - degree], knots[span + row + 1 - level]
            share = ((t - low) / np.where(high > low, high - low, 1.0))[:, None]
            rows[:, row] = (1.0 - share) * rows[:, row - 1] + share * rows[:, row]
    return rows[:, degree]
