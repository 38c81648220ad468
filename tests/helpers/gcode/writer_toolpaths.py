# SPDX-License-Identifier: LGPL-2.1-or-later
"""Toolpaths for the writer's tests, and how far a point lies from a toolpath."""

from __future__ import annotations

from dataclasses import replace
from math import atan2, cos, hypot, pi, sin
from random import Random

import numpy as np

from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, ARC_CW, PLANE_AXES, XY, YZ, TableBuilder, Toolpath

CUTTING = State(tool=1, spindle="cw", spindle_rpm=10_000)


def two_tools() -> Toolpath:
    """Two operations with two tools: lines, arcs, a full circle, turns, another plane."""
    table = TableBuilder(Start(), CUTTING)
    table.open_span("operation", "peça nº 1 (ø!)")
    table.rapid((0, 0, 10))
    table.rapid((0, 0, 2))
    table.feed((0, 0, -1), 200)
    table.feed((10, 0, -1), 800)
    table.arc(ARC_CCW, (0, 0, -2), (5, 0, -1), 800)
    table.arc(ARC_CW, (0, 0, -2), (5, 0, -2), 800)
    table.arc(ARC_CW, (0, 0, -4), (5, 0, -2), 800, turns=3)
    table.rapid((0, 0, 10))
    table.close_span()
    table.set_state(replace(CUTTING, tool=2, spindle_rpm=8000))
    table.open_span("operation", "engrave")
    table.rapid((20, 0, 10))
    table.feed((20, 0, -1), 100)
    table.arc(ARC_CW, (20, 10, -1), (20, 5, -1), 300, plane=XY)
    table.arc(ARC_CW, (20, 20, -1), (20, 15, -1), 300, plane=YZ)
    table.rapid((20, 20, 10))
    table.close_span()
    return table.toolpath()


def random_path(seed: int) -> Toolpath:
    """Lines and arcs of all planes and sizes, full circles, helices, and the arcs that rounding endangers."""
    random = Random(seed)
    scale = random.choice([0.01, 1.0, 50.0, 300.0])
    point = [random.uniform(-scale, scale) for _ in range(3)]
    table = TableBuilder(Start(), CUTTING)
    table.rapid(point)
    for _ in range(random.randint(1, 15)):
        if random.random() < 0.4:
            point = [value if random.random() < 0.4 else random.uniform(-scale, scale) for value in point]
            if random.random() < 0.3:
                table.rapid(point)
            else:
                table.feed(point, random.choice([100, 123.456, 800]))
        else:
            point = _random_arc(random, table, point, scale)
    return table.toolpath()


def _random_arc(random: Random, table: TableBuilder, begin: list[float], scale: float) -> list[float]:
    plane = random.randint(0, 2)
    first, second, normal = PLANE_AXES[plane]
    radius = random.uniform(0.0001, scale) * random.choice([0.001, 1, 1, 1, 20])
    angle, clockwise = random.uniform(0, 2 * pi), random.random() < 0.5
    tiny = random.choice([1e-2, 1e-5, 1e-6])
    sweep = random.choice([random.uniform(0, 2 * pi), random.uniform(0, pi), 2 * pi, tiny, 2 * pi - tiny])
    centre, end = list(begin), list(begin)
    centre[first] -= radius * cos(angle)
    centre[second] -= radius * sin(angle)
    if sweep != 2 * pi:
        turned = angle + (-sweep if clockwise else sweep)
        end[first], end[second] = centre[first] + radius * cos(turned), centre[second] + radius * sin(turned)
    if random.random() < 0.4:
        end[normal] = random.uniform(-scale, scale)
    kind = ARC_CW if clockwise else ARC_CCW
    table.arc(kind, end, centre, random.choice([100, 500.5]), plane, random.choice([1, 1, 1, 2]))
    return end


def row_points(path: Toolpath, count: int) -> list[np.ndarray]:
    """Return `count` points on each row, float64[count, 3]; rows from an unknown place are left out."""
    table, begins = path.table(), path.begins()
    rows = [row for row in range(len(table)) if not np.isnan(begins[row]).any()]
    return [_points(table, begins[row], row, count) for row in rows]


def _points(table, begin: np.ndarray, row: int, count: int) -> np.ndarray:
    share = np.linspace(0, 1, count)[:, None]
    points = begin + (table.end[row] - begin) * share
    if table.turns[row] == 0:
        return points
    first, second, _ = PLANE_AXES[table.plane[row]]
    x, y = begin[first] - table.centre[row, first], begin[second] - table.centre[row, second]
    sense = -1 if table.kind[row] == ARC_CW else 1
    angle = sense * _sweep(table, row, x, y) * share[:, 0]
    points[:, first] = table.centre[row, first] + x * np.cos(angle) - y * np.sin(angle)
    points[:, second] = table.centre[row, second] + x * np.sin(angle) + y * np.cos(angle)
    return points


def _sweep(table, row: int, x: float, y: float) -> float:
    first, second, _ = PLANE_AXES[table.plane[row]]
    u, v = (table.end[row, axis] - table.centre[row, axis] for axis in (first, second))
    angle = atan2(x * v - y * u, x * u + y * v)
    angle = -angle if table.kind[row] == ARC_CW else angle
    if hypot(u - x, v - y) < 1e-9:
        angle = 2 * pi
    return (angle if angle > 0 else angle + 2 * pi) + 2 * pi * (int(table.turns[row]) - 1)
