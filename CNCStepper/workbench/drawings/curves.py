# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a drawing as curves of lines and arcs.

Lines, arcs and circles come over exactly; ellipses, B-splines and all else as arcs within a tolerance,
sampled between any two knots of a B-spline, with a vertex at each of their corners and cusps.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.curve_fit_cache import Ellipse, Line, Spline, fit_of
from CNCStepper.workbench.drawings.shapes import edges_of, sorted_chains

SHORTEST_MM = 1e-7  # FreeCAD's own measure of "the same point"
Piece = Curve | Line


def curves_of(
    drawing: Any, origin_mm: tuple[float, ...], tolerance_mm: float, picked: Sequence[str] = ()
) -> tuple[Curve, ...]:
    """Return the drawing's connected lines, each chain as one curve, from the work zero at `origin_mm`.

    picked: the faces and edges of it that count, all where there is none. Raises GeometryError for an empty drawing,
    one that is not flat, or a tolerance that cannot be kept.
    """
    require_tolerance(tolerance_mm)
    chains = [pieces_of(chain) for chain in sorted_chains(edges_of(drawing, picked), SHORTEST_MM)]
    return tuple(curve_of_chain(chain, tolerance_mm).moved(-origin_mm[0], -origin_mm[1]) for chain in chains)


def require_tolerance(tolerance_mm: float) -> None:
    """Raise GeometryError for a tolerance that cannot be kept."""
    if not tolerance_mm > 0:
        advice = "give a tolerance above 0"
        raise GeometryError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm", advice=advice)


def pieces_of(edges: Sequence[Any]) -> list[Piece]:
    """Return edges, each run along its increasing parameter, as curves; those that are fitted as plain data."""
    return [_piece_of(edge) for edge in edges]


def _piece_of(edge: Any) -> Piece:
    import Part

    if isinstance(edge.Curve, Part.Line):
        return Curve(_points(edge, np.array(edge.ParameterRange)), np.zeros(1))
    return _arcs(edge) if isinstance(edge.Curve, Part.Circle) else _line_of(edge)


def curve_of_chain(chain: Sequence[Piece], tolerance_mm: float) -> Curve:
    """Return pieces in the order in which they touch as one curve, each turned so that it goes on.

    The first one keeps its direction where it can: two halves of a circle touch at both ends, but for rounding errors.
    """
    pieces = [fit_of(piece, tolerance_mm) if isinstance(piece, Line) else piece for piece in chain]
    if len(pieces) > 1 and _gap(pieces[0].xy[-1], pieces[1]) > max(_gap(pieces[0].xy[0], pieces[1]), SHORTEST_MM):
        pieces[0] = pieces[0].reversed()
    for number, piece in enumerate(pieces[1:], start=1):
        last = pieces[number - 1].xy[-1]
        if math.dist(last, piece.xy[-1]) < math.dist(last, piece.xy[0]):
            pieces[number] = piece.reversed()
    curve = _one(pieces)
    if len(curve) > 1 and math.dist(curve.xy[0], curve.xy[-1]) <= SHORTEST_MM:
        return Curve(np.vstack([curve.xy[:-1], curve.xy[:1]]), curve.bulge)
    return curve


def _gap(point: np.ndarray, piece: Curve) -> float:
    return min(math.dist(point, piece.xy[0]), math.dist(point, piece.xy[-1]))


def _one(pieces: list[Curve]) -> Curve:
    """Return touching pieces as one curve; ends that differ by less than FreeCAD's own measure become one."""
    if len(pieces) == 1:
        return pieces[0]
    xy = np.vstack([pieces[0].xy[:1], *(piece.xy[1:] for piece in pieces)])
    return Curve(xy, np.concatenate([piece.bulge for piece in pieces]))


def _arcs(edge: Any) -> Curve:
    """Return a circle or an arc in parts of at most a half turn; its sense is as seen from above."""
    first, last = edge.ParameterRange
    parts = max(1, math.ceil((last - first) / math.pi - 1e-9))
    points = _points(edge, np.linspace(first, last, 2 * parts + 1))
    (ax, ay), (bx, by) = points[1] - points[0], points[2] - points[1]
    sense = math.copysign(1.0, ax * by - ay * bx)
    return Curve(points[::2], np.full(parts, sense * math.tan((last - first) / parts / 4)))


def _line_of(edge: Any) -> Line:
    import Part

    curve, (first, last) = edge.Curve, edge.ParameterRange
    if isinstance(curve, Part.Ellipse):
        centre = curve.Center
        ends = [curve.value(angle) - centre for angle in (0.0, math.pi / 2)]
        return Ellipse(first, last, *((at.x, at.y) for at in (centre, *ends)))
    return _spline(curve, first, last, corners=isinstance(curve, Part.BSplineCurve))


def _spline(curve: Any, first: float, last: float, corners: bool) -> Spline:
    if not corners:
        curve = curve.toBSpline(first, last)
        first, last = curve.FirstParameter, curve.LastParameter
    period = 0.0
    if curve.isPeriodic():
        period = curve.LastParameter - curve.FirstParameter
        curve = curve.copy()
        curve.setNotPeriodic()
    pairs = zip(curve.getKnots(), curve.getMultiplicities(), strict=True)
    knots = tuple(knot for knot, times in pairs for _ in range(times))
    poles = tuple((pole.x, pole.y) for pole in curve.getPoles())
    return Spline(first, last, curve.Degree, poles, tuple(curve.getWeights()), knots, period, corners)


def _points(edge: Any, parameters: np.ndarray) -> np.ndarray:
    return np.array([tuple(edge.valueAt(float(t)))[:2] for t in parameters])
