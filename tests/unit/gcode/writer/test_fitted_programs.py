# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random points, fitted, written and read back: the controller takes every arc, and nothing gets longer or moves."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import Moves, point_of
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.geometry.fitting.point_fit import fit_points
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath

SETUP = Setup(Tool(number=1, shape="flat", diameter_mm=1, feed_mm_min=600, plunge_mm_min=200), 10.0, 2.0)
DIGIT_MM = {"mm": 0.001, "inch": 0.00254}
ERROR_33_MM, ERROR_33_SHARE = 0.005, 0.001  # grbl: radii may differ by the one, or by the other of the radius
FLAT_MM = 1e-4


def random_points(seed: int) -> np.ndarray:
    """Return points along smooth and cornered lines, dense and sparse, exact and rough, large and tiny."""
    rng = np.random.default_rng(seed)
    count, size_mm = int(rng.integers(2, 400)), 10.0 ** rng.uniform(-1, 2.5)
    share = np.linspace(0, 1, count)
    kind = seed % 5
    if kind == 0:  # arcs of any radius
        points = np.exp(1j * rng.uniform(0.01, 6.2) * share)
    elif kind == 1:  # waves
        points = share + 1j * rng.uniform(0.01, 0.3) * np.sin(rng.uniform(3, 60) * share)
    elif kind == 2:  # a spiral
        points = (0.05 + share) * np.exp(1j * rng.uniform(2, 40) * share)
    elif kind == 3:  # straight lines with corners
        knots = rng.uniform(-1, 1, (int(rng.integers(2, 9)), 2)) @ (1, 1j)
        points = np.interp(share * (len(knots) - 1), np.arange(len(knots)), knots)
    else:  # a lobed outline
        points = (1 + 0.3 * np.sin(rng.integers(2, 7) * 2 * math.pi * share)) * np.exp(2j * math.pi * share)
    rough_mm = rng.choice([0.0, 0.0, 1e-4, 5e-3])
    points = size_mm * points + rng.normal(0, rough_mm, (count, 2)) @ (1, 1j)
    return np.column_stack([points.real, points.imag]) + rng.uniform(-200, 200, 2)


def program(curve: Curve, units: str) -> str:
    table = TableBuilder(Start())
    moves = Moves(table, SETUP)
    moves.approach(point_of(curve.xy[0]))
    moves.plunge(-1.0)
    moves.follow(curve, 600)
    moves.retract()
    return write(table.toolpath(), dialect("grbl"), WriteOptions(units=units, clearance_mm=10.0))


def radii_mm(path: Toolpath) -> np.ndarray:
    """Return the radius at the begin and at the end of each arc, float64[n, 2]."""
    table, arcs = path.table(), np.flatnonzero(path.table().turns)
    ends = np.stack([path.begins()[arcs, :2], table.end[arcs, :2]], axis=1) - table.centre[arcs, None, :2]
    return np.hypot(ends[..., 0], ends[..., 1])


def cut_line(path: Toolpath) -> np.ndarray:
    """Return points along what is cut, arcs by chords within FLAT_MM."""
    table, begins = path.table(), path.begins()
    rows = [row for row in range(len(path)) if table.kind[row] and table.end[row, 2] < 0 and begins[row, 2] < 0]
    points = [begins[rows[0], :2]] if rows else []
    for row in rows:
        if table.turns[row]:
            a, b, c = (at[row, :2] @ (1, 1j) for at in (begins, table.end, table.centre))
            sense = 1 if table.kind[row] == 3 else -1
            sweep = sense * (sense * np.angle((b - c) / (a - c)) % (2 * math.pi))
            count = 2 + math.ceil(abs(sweep) / math.sqrt(8 * FLAT_MM / max(abs(a - c), FLAT_MM)))
            turned = c + (a - c) * np.exp(1j * sweep * np.linspace(0, 1, count)[1:-1])
            points += list(np.column_stack([turned.real, turned.imag]))
        points.append(table.end[row, :2])
    return np.array(points)


@pytest.mark.parametrize("units", ["mm", "inch"])
@pytest.mark.parametrize("seed", [*range(5), *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(5, 60))])
def test_a_fitted_program_obeys_the_controller_and_is_no_longer_than_its_points(seed: int, units: str) -> None:
    points, tolerance_mm = random_points(seed), (0.002, 0.01, 0.05)[seed % 3]
    drawn = from_points(points)
    curve = fit_points(points, tolerance_mm)
    text = program(curve, units)
    path = interpret(text, Start.with_work_zero((0.0, 0.0, 0.0)), "grbl")  # refuses what error:33 does
    radii = radii_mm(path)
    differ = np.abs(radii[:, 0] - radii[:, 1])
    assert (differ <= np.maximum(ERROR_33_MM, ERROR_33_SHARE * radii[:, 0])).all()
    assert len(curve) <= len(drawn)
    assert len(text.splitlines()) <= len(program(drawn, units).splitlines())
    line = cut_line(path)
    if len(line) > 1:
        away = shapely.hausdorff_distance(shapely.LineString(line), shapely.LineString(drawn.xy))
        assert away <= tolerance_mm + 3 * DIGIT_MM[units] + FLAT_MM


def test_most_curved_cases_are_fitted_with_arcs_and_are_shorter_by_far() -> None:
    fits = [(random_points(seed), seed) for seed in range(60) if seed % 5 != 3]
    curves = [(len(points), fit_points(points, (0.002, 0.01, 0.05)[seed % 3])) for points, seed in fits]
    assert sum(bool(curve.bulge.any()) for _, curve in curves) > 0.7 * len(curves)
    assert sum(len(curve) < count / 3 for count, curve in curves) > 0.5 * len(curves)


def test_a_line_that_leaves_its_points_is_seen() -> None:
    angles = np.linspace(0, 7, 100)
    points = np.column_stack([50 * np.cos(angles) + angles**2, 40 * np.sin(angles)])
    path = interpret(program(fit_points(points, 0.5), "mm"), Start.with_work_zero((0.0, 0.0, 0.0)), "grbl")
    assert shapely.hausdorff_distance(shapely.LineString(cut_line(path)), shapely.LineString(points)) > 0.1
