# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a drawing as curves of lines and arcs.

Lines, arcs and circles come over exactly; ellipses, B-splines and all else as arcs within a tolerance,
sampled between any two knots of a B-spline, with a vertex at each of their corners and cusps.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fit import fit_arcs, fit_curve
from CNCStepper.workbench.shapes import edges_of, sorted_chains

SHORTEST_MM = 1e-7  # FreeCAD's own measure of "the same point"
SAMPLED = 0.99  # of the tolerance: the fit measures at samples, between them it may be a little worse
MOST_FITS = 256  # kept
QUARTERS = 4  # parts of a curve without inner knots, such as a whole ellipse

_fits: dict[tuple[Any, ...], Curve] = {}  # by all that an edge's fit depends on, the oldest first


def curves_of(
    drawing: Any, origin_mm: tuple[float, ...], tolerance_mm: float, picked: Sequence[str] = ()
) -> tuple[Curve, ...]:
    """Return the drawing's connected lines, each chain as one curve, from the work zero at `origin_mm`.

    picked: the faces and edges of it that count, all where there is none. Raises GeometryError for an empty drawing,
    one that is not flat, or a tolerance that cannot be kept.
    """
    require_tolerance(tolerance_mm)
    chains = sorted_chains(edges_of(drawing, picked), SHORTEST_MM)
    return tuple(curve_of_chain(chain, tolerance_mm).moved(-origin_mm[0], -origin_mm[1]) for chain in chains)


def require_tolerance(tolerance_mm: float) -> None:
    """Raise GeometryError for a tolerance that cannot be kept."""
    if not tolerance_mm > 0:
        raise GeometryError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm")


def curve_of(edge: Any, tolerance_mm: float) -> Curve:
    """Return one edge as a curve, run along its increasing parameter."""
    import Part

    if isinstance(edge.Curve, Part.Line):
        return Curve(_points(edge, np.array(edge.ParameterRange)), np.zeros(1))
    if isinstance(edge.Curve, Part.Circle):
        return _arcs(edge)
    return _fitted(edge, tolerance_mm * SAMPLED)


def curve_of_chain(edges: list[Any], tolerance_mm: float) -> Curve:
    """Return edges in the order in which they touch as one curve, each turned so that it goes on."""
    pieces = [curve_of(edge, tolerance_mm) for edge in edges]
    if len(pieces) > 1 and _gap(pieces[0].xy[-1], pieces[1]) > _gap(pieces[0].xy[0], pieces[1]):
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


def _fitted(edge: Any, tolerance_mm: float) -> Curve:
    """Return the fit of an edge; those of the last edges are kept, because FreeCAD asks for each several times."""
    key = edge.Curve.Content, edge.Placement.toMatrix().A, edge.ParameterRange, tolerance_mm
    if key not in _fits:
        if len(_fits) == MOST_FITS:
            del _fits[next(iter(_fits))]
        _fits[key] = _fit(edge, tolerance_mm)
    return _fits[key]


def _fit(edge: Any, tolerance_mm: float) -> Curve:
    """Return a B-spline from corner to corner, all else in quarters, so that an ellipse comes out symmetrical."""
    import Part

    point, (first, last) = partial(_points, edge), edge.ParameterRange
    if isinstance(edge.Curve, Part.BSplineCurve):
        return fit_curve(point, first, last, tolerance_mm, edge.Curve.getKnots())
    bounds = np.linspace(first, last, QUARTERS + 1).tolist()
    return _one([fit_arcs(point, *span, tolerance_mm) for span in itertools.pairwise(bounds)])


def _points(edge: Any, parameters: np.ndarray) -> np.ndarray:
    return np.array([tuple(edge.valueAt(float(t)))[:2] for t in parameters])
