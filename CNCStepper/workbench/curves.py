# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines of a drawing as curves of lines and arcs.

Lines, arcs and circles come over exactly; ellipses, B-splines and all else as arcs within a tolerance,
fitted span by span (a span of a B-spline lies between two of its knots, where it may have a corner).
"""

from __future__ import annotations

import itertools
import math
from functools import partial
from typing import Any

import numpy as np

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.fit import fit_arcs
from CNCStepper.workbench.shapes import edges_of

SHORTEST_MM = 1e-7  # FreeCAD's own measure of "the same point"
STRAIGHT_MM = 1e-7  # an arc that rises less above its chord is a line
SAMPLED = 0.99  # of the tolerance: the fit measures at samples, between them it may be a little worse
QUARTERS = 4  # parts of a curve without inner knots, such as a whole ellipse


def curves_of(drawing: Any, origin_mm: tuple[float, ...], tolerance_mm: float) -> tuple[Curve, ...]:
    """Return the drawing's connected lines, each chain as one curve, from the work zero at `origin_mm`.

    Raises GeometryError for an empty drawing, one that is not flat, or a tolerance that cannot be kept.
    """
    import Part

    if not tolerance_mm > 0:
        raise GeometryError("tolerance", "the tolerance must be above 0", value=f"{tolerance_mm:g} mm")
    edges = [edge for edge in edges_of(drawing) if edge.Length > SHORTEST_MM]
    return tuple(_chained(chain, tolerance_mm).moved(-origin_mm[0], -origin_mm[1]) for chain in Part.sortEdges(edges))


def curve_of(edge: Any, tolerance_mm: float) -> Curve:
    """Return one edge as a curve, run along its increasing parameter."""
    import Part

    if isinstance(edge.Curve, Part.Line):
        return Curve(_points(edge, np.array(edge.ParameterRange)), np.zeros(1))
    if isinstance(edge.Curve, Part.Circle):
        return _arcs(edge)
    point = partial(_points, edge)
    return _straightened(
        _one([fit_arcs(point, *span, tolerance_mm * SAMPLED) for span in itertools.pairwise(_spans(edge))])
    )


def _chained(edges: list[Any], tolerance_mm: float) -> Curve:
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
        curve.xy[-1] = curve.xy[0]
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


def _spans(edge: Any) -> list[float]:
    """Return the parameters between which the edge is smooth and simple enough to fit, ascending."""
    import Part

    first, last = edge.ParameterRange
    if isinstance(edge.Curve, Part.BSplineCurve):
        inner = [knot for knot in edge.Curve.getKnots() if first < knot < last]
        if inner:
            return [first, *inner, last]
    return [float(parameter) for parameter in np.linspace(first, last, QUARTERS + 1)]


def _points(edge: Any, parameters: np.ndarray) -> np.ndarray:
    return np.array([tuple(edge.valueAt(float(t)))[:2] for t in parameters])


def _straightened(curve: Curve) -> Curve:
    rise_mm = np.abs(curve.bulge) * np.hypot(*np.diff(curve.xy, axis=0).T) / 2
    return Curve(curve.xy, np.where(rise_mm > STRAIGHT_MM, curve.bulge, 0.0))
