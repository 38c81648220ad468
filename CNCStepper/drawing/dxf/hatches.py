# SPDX-License-Identifier: LGPL-2.1-or-later
"""The boundaries of a HATCH as closed curves: polylines, lines and arcs exactly, ellipses and splines fitted.

A hatch is mostly drawn with its boundary beside it. Such a boundary is left out (`without_drawn`): a tool would cut it
twice.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from CNCStepper.drawing.drawing import Chain
from CNCStepper.drawing.dxf.entities import (
    BROKEN,
    REDRAW,
    Fits,
    bulged,
    curve_of,
    from_above,
    require_finite,
    round_arc,
)
from CNCStepper.errors import GeometryError, Text
from CNCStepper.geometry.chain_joining import chained
from CNCStepper.geometry.curve import Curve
from CNCStepper.safe_text import printable

MOST_CHARACTERS = 255
DRAWN_DIGITS = 2  # of mm: boxes and lengths of two curves that are one
FULL_DEG = 360.0


def hatch_curves(entity: Any, fits: Fits) -> list[Curve]:
    """Return the boundaries of a hatch in its unit; raises GeometryError with the reason where one is not closed."""
    try:
        curves = [_boundary(path, fits) for path in entity.paths]
    except BROKEN as error:
        if isinstance(error, GeometryError):
            raise
        why = printable(str(error), MOST_CHARACTERS) or type(error).__name__
        raise GeometryError("dxf-broken", Text("its numbers make no curve: {why}", why=why), advice=REDRAW) from error
    if not curves:
        raise GeometryError("dxf-hatch", "it has no boundary", advice="draw an outline in its place")
    return [from_above(entity, curve) for curve in curves]


def _boundary(path: Any, fits: Fits) -> Curve:
    if hasattr(path, "vertices"):
        rows = np.array(path.vertices, float).reshape(-1, 3)
        require_finite(rows)
        return bulged(rows, closed=True)
    chains, _ = chained([_edge(edge, fits) for edge in path.edges])
    if len(chains) != 1 or not chains[0].closed:
        advice = "draw its boundary closed, or leave it out"
        raise GeometryError("dxf-hatch", "its boundary is not closed", advice=advice)
    return chains[0]


def _edge(edge: Any, fits: Fits) -> Curve:
    from ezdxf.entities import factory

    kind = edge.type.name
    if kind == "LINE":
        rows = np.array([(*edge.start, 0.0), (*edge.end, 0.0)], float)
        require_finite(rows)
        return bulged(rows, closed=False)
    if kind == "ARC":
        require_finite(np.array([(*edge.center, edge.radius), (edge.start_angle, edge.end_angle, 0.0)], float))
        turn = edge.end_angle - edge.start_angle
        sweep = FULL_DEG if abs(turn) >= FULL_DEG else turn % FULL_DEG
        return round_arc(edge.center, edge.radius, math.radians(edge.start_angle), math.radians(sweep))
    if kind == "ELLIPSE":
        given = {"center": edge.center, "major_axis": edge.major_axis, "ratio": edge.ratio}
        whole = abs(edge.end_angle - edge.start_angle) >= FULL_DEG
        ends = (0.0, math.tau) if whole else (edge.start_param, edge.end_param)
        return curve_of(factory.new("ELLIPSE", given | {"start_param": ends[0], "end_param": ends[1]}), fits)
    spline: Any = factory.new("SPLINE", {"degree": edge.degree})
    spline.control_points, spline.fit_points = edge.control_points, edge.fit_points
    spline.knots, spline.weights = edge.knot_values, edge.weights
    return curve_of(spline, fits)


def without_drawn(chains: Sequence[Chain]) -> tuple[list[Chain], int]:
    """Return the chains without filled ones that are drawn as lines on their layer too, and how many these were."""
    if not any(chain.attributes.filled for chain in chains):
        return list(chains), 0
    drawn = {_key(chain) for chain in chains if chain.curve.closed and not chain.attributes.filled}
    kept = [chain for chain in chains if not (chain.attributes.filled and _key(chain) in drawn)]
    return kept, len(chains) - len(kept)


def _key(chain: Chain) -> tuple[object, ...]:
    box_mm = np.round(chain.curve.box_mm, DRAWN_DIGITS) + 0.0
    return chain.attributes.layer, *box_mm.tolist(), round(chain.curve.length_mm, DRAWN_DIGITS)
