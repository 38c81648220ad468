# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tests of elliptical pockets and engravings ask the table of moves, and the ellipse by its formula."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from shapely import Polygon

from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Toolpath
from helpers.cycles.sweep_judge import left_mm, reachable

OUTLINE_MM = 2e-4
FLAT_MM = 2e-4


@dataclass(frozen=True)
class Run:
    """One row as points in work coordinates, float64[m, 3], with its feed and length in XY."""

    kind: int
    xyz: np.ndarray
    feed_mm_min: float
    run_mm: float

    @property
    def fall_mm(self) -> float:
        """By how much the row goes down."""
        return float(self.xyz[0, 2] - self.xyz[-1, 2])


def runs(path: Toolpath, first: int = 0, last: int | None = None) -> list[Run]:
    """Return the rows [first, last) with arcs flattened."""
    rows, begins = path.table(), path.begins()
    return [_run(rows, begins, row) for row in range(first, len(path) if last is None else last)]


def spans(path: Toolpath, kind: str) -> list:
    return sorted((span for span in path.spans if span.kind == kind), key=lambda span: span.first)


def wanted(pocket: EllipticalPocket) -> Polygon:
    """Return the wanted region, at most OUTLINE_MM inside the true ellipse."""
    major_mm = max(pocket.radius_x_mm, pocket.radius_y_mm)
    count = math.ceil(2 * math.pi / math.sqrt(8 * OUTLINE_MM / major_mm))
    t, turn = np.linspace(0, 2 * math.pi, count, endpoint=False), math.radians(pocket.rotation_deg)
    x, y = pocket.radius_x_mm * np.cos(t), pocket.radius_y_mm * np.sin(t)
    xy = np.column_stack([x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn)])
    return Polygon(xy + pocket.centre_mm)


def unreachable_mm(pocket: EllipticalPocket, radius_mm: float) -> float:
    """Return the thickness left at the tips of the ellipse: what the tool's disc cannot reach."""
    region = wanted(pocket)
    return left_mm(region, reachable(region, radius_mm, neck_mm=0.0))


def _run(rows, begins: np.ndarray, row: int) -> Run:
    begin, end, kind = begins[row], rows.end[row], int(rows.kind[row])
    if kind in (RAPID, LINE):
        return Run(kind, np.vstack([begin, end]), float(rows.feed[row]), math.dist(begin[:2], end[:2]))
    centre = rows.centre[row][:2]
    radius_mm = math.dist(begin[:2], centre)
    first, last = (math.atan2(*(point[:2] - centre)[::-1]) for point in (begin, end))
    sense = 1 if kind == ARC_CCW else -1
    assert kind in (ARC_CCW, ARC_CW)
    sweep = (sense * (last - first)) % (2 * math.pi)
    if math.dist(begin[:2], end[:2]) < 1e-9:
        sweep = 2 * math.pi
    count = max(2, math.ceil(sweep / (4 * math.asin(math.sqrt(min(1.0, FLAT_MM / 2 / radius_mm))))))
    share = np.linspace(0, 1, count + 1)
    angle = first + sense * sweep * share
    xy = centre + radius_mm * np.column_stack([np.cos(angle), np.sin(angle)])
    xy[0], xy[-1] = begin[:2], end[:2]
    z = begin[2] + share * (end[2] - begin[2])
    return Run(kind, np.column_stack([xy, z]), float(rows.feed[row]), radius_mm * sweep)
