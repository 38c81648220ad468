# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Side entry: straight leads into the stock from outside, where the tool plunges in the air.

      .---.      stock
---- (  o  )  ------+         o  the begin of a run, inside or at the stock
      '- ^ -'       |         ^  its lead, against the run's first direction or square to it; from where it begins
         |          |            the tool's edge is BESIDE_MM from the stock, and all that it covers may be cut
       (   )
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Point
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve
from CNCStepper.tolerances import LEAD_ROUNDING_MM

BESIDE_MM = 1.0
FAR_MM = 1e6


@dataclass(frozen=True)
class Surroundings:
    """What decides on a lead: the stock (empty where it is not known), what may be cut, and the tool's radius."""

    stock: BaseGeometry
    allowed: BaseGeometry
    tool_mm: float


def lead_to(curve: Curve, around: Surroundings) -> np.ndarray | None:
    """Return the begin of a straight lead to a curve, with the tool outside the stock; None if there is none.

    The way goes along the curve's own direction or square to it, and covers nothing that is to stay.
    """
    here, along = curve.xy[0], curve.begin_directions[0]
    square = np.array([-along[1], along[0]])
    leads = [lead for way in (-along, square, -square) if (lead := _lead(here, way, around)) is not None]
    return min(leads, key=lambda lead: float(np.hypot(*(lead - here))), default=None)


def _lead(here: np.ndarray, way: np.ndarray, around: Surroundings) -> np.ndarray | None:
    if around.stock.is_empty:
        return None
    off_mm = around.tool_mm + BESIDE_MM
    if Point(here).distance(around.stock) >= off_mm:
        return here
    near = around.stock.buffer(off_mm)
    inside = LineString([here, here + FAR_MM * way]).intersection(near)
    pieces = [piece for piece in shapely.get_parts(inside) if piece.distance(Point(here)) < LEAD_ROUNDING_MM]
    ends = [np.array(point) for piece in pieces for point in piece.coords]
    if not ends:  # beside the stock but for the chords that stand for the arcs of `near`
        return here
    there = max(ends, key=lambda end: float(np.hypot(*(end - here))))
    covered = LineString([here, there]).buffer(around.tool_mm - LEAD_ROUNDING_MM).intersection(around.stock)
    return there if covered.difference(around.allowed).area <= LEAD_ROUNDING_MM**2 else None
