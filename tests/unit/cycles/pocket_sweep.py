# SPDX-License-Identifier: LGPL-2.1-or-later
"""The independent judge of an elliptical pocket: exact sweeps of the tool by level, from the table of moves alone.

The wanted ellipse is drawn here from its formula. Buffers by shapely are polygons inside the true ones;
by how much is BUFFER of the radius.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from shapely import LineString, Polygon, buffer, get_parts, line_merge, points, prepare, union_all
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.elliptical_pocket import EllipticalPocket
from CNCStepper.cycles.form import Answer, Setup
from CNCStepper.machine.tool import Tool
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, TableBuilder, Toolpath

QUAD_SEGS = 64
BUFFER = 1 - math.cos(math.pi / 4 / QUAD_SEGS)
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


def tool(diameter_mm: float = 6.0, **changes: object) -> Tool:
    values = {"number": 1, "shape": "flat", "diameter_mm": diameter_mm, "feed_mm_min": 800, "plunge_mm_min": 200}
    return Tool(**(values | changes))


def cut(operation, cutter: Tool | None = None, clearance_mm: float = 10.0) -> tuple[Toolpath, Answer]:
    """Return what an operation makes on a fresh table."""
    table = TableBuilder(Start())
    answer = operation.cut(Setup(cutter or tool(), clearance_mm, 2.0), table)
    return table.toolpath(), answer


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


def gouge_mm(path: Toolpath, pocket: EllipticalPocket, radius_mm: float) -> float:
    """Return how deep the tool enters what is to stay: sideways anywhere below the top, or below the floor."""
    below = np.vstack([run.xyz[run.xyz[:, 2] < 1e-9] for run in runs(path)])
    wall = wanted(pocket).exterior
    region = Polygon(wall)
    prepare([wall, region])
    centres = points(np.unique(below[:, :2], axis=0))
    signed = np.where(region.covers(centres), 1.0, -1.0) * wall.distance(centres)
    return max(float(radius_mm - signed.min()), -pocket.depth_mm - float(below[:, 2].min()))


def left_over(path: Toolpath, pocket: EllipticalPocket, radius_mm: float, tolerance_mm: float) -> dict[float, float]:
    """Return by level the area, mm², that the tool could reach farther than `tolerance_mm` inside and did not."""
    floors = _floors(path)
    margin_mm = tolerance_mm + OUTLINE_MM + FLAT_MM + 2 * BUFFER * radius_mm
    reach = wanted(pocket).buffer(-radius_mm, quad_segs=QUAD_SEGS)
    opening = reach.buffer(radius_mm - margin_mm, quad_segs=QUAD_SEGS)
    known: dict[bytes, float] = {}
    for z_mm, lines in floors.items():
        key = b"".join(line.tobytes() for line in lines)
        if key not in known:
            known[key] = opening.difference(_swept(lines, radius_mm)).area
        floors[z_mm] = known[key]  # type: ignore[assignment]
    return floors  # type: ignore[return-value]


def unreachable_mm(pocket: EllipticalPocket, radius_mm: float) -> float:
    """Return the thickness left at the tips: what the ellipse's opening by the tool's disc is shorter."""
    plain = pocket.model_copy(update={"rotation_deg": 0.0, "centre_mm": (0.0, 0.0)})
    opened = wanted(plain).buffer(-radius_mm, quad_segs=QUAD_SEGS).buffer(radius_mm, quad_segs=QUAD_SEGS)
    along = 0 if pocket.radius_x_mm >= pocket.radius_y_mm else 1
    return max(pocket.radius_x_mm, pocket.radius_y_mm) - opened.bounds[2 + along]


def _floors(path: Toolpath) -> dict[float, list[np.ndarray]]:
    lines: dict[float, list[np.ndarray]] = {}
    for run in runs(path):
        bottom_mm = run.xyz[-1, 2]
        if run.kind != RAPID and bottom_mm < 0 and abs(run.fall_mm) < 1e-9:
            lines.setdefault(float(bottom_mm), []).append(run.xyz[:, :2])
    return lines


def _swept(lines: list[np.ndarray], radius_mm: float) -> BaseGeometry:
    """Return what the tool's disc covers along the lines.

    They are cut where they meet first: shapely's buffer of a line that crosses itself can lack pieces.
    """
    chains = get_parts(line_merge(union_all([LineString(line) for line in lines])))
    return union_all(buffer(chains, radius_mm, quad_segs=QUAD_SEGS))


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
