# SPDX-License-Identifier: LGPL-2.1-or-later
"""Removed volumes of whole programs against formulas."""

import numpy as np
import pytest

from CNCStepper.machine.tools.tool_profile import Form
from CNCStepper.simulation.removal.heightmap import Grid, Part, height_map
from CNCStepper.simulation.removal.removal_moves import Moves
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import BALL, FLAT, begun

STOCK = Stock((60, 50, 20))
R = 3.0
SPHERE_CAP = np.pi * 2.0**2 * (3 * R - 2.0) / 3  # 2 mm deep
SEGMENT = R**2 * np.arccos((R - 2.0) / R) - (R - 2.0) * np.sqrt(2 * R * 2.0 - 4.0)  # the ball's section at 2 mm


def volume(program, tool, cell_mm=0.05):
    return height_map(program.toolpath(), tool, STOCK, cell_mm).removed_volume_mm3


def test_a_line_and_a_full_circle_of_a_flat_tool():
    line = begun().feed(0, 0, -2).feed(20, 9.3, -2)
    assert volume(line, FLAT) == pytest.approx(2 * (np.pi * R**2 + np.hypot(20, 9.3) * 2 * R), rel=1e-3)
    ring = begun().rapid(10, 0, 5).feed(10, 0, -2).arc(ARC_CCW, (10, 0, -2), (0, 0, -2))
    assert volume(ring, FLAT) == pytest.approx(2 * np.pi * (13**2 - 7**2), rel=1e-3)


def test_a_line_and_a_full_circle_of_a_ball():
    line = begun().feed(0, 0, -2).feed(20, 9.3, -2)
    assert volume(line, BALL) == pytest.approx(SPHERE_CAP + np.hypot(20, 9.3) * SEGMENT, rel=1e-3)
    ring = begun().rapid(10, 0, 5).feed(10, 0, -2).arc(ARC_CCW, (10, 0, -2), (0, 0, -2))
    assert volume(ring, BALL) == pytest.approx(2 * np.pi * 10 * SEGMENT, rel=1e-3)


def test_a_ramp_of_a_flat_tool():
    """A wedge; over its length the leading half disc makes the floor lower by slope * sqrt(R² - y²) at most."""
    program = begun().feed(-10, 0, 0).feed(10, 0, -4)
    slope, y = 4 / 20, (np.arange(60000) + 0.5) / 10000 - 3
    half = np.sqrt(R**2 - y**2)
    # along a strip at y: depth slope * (s + half) until the end's level, which lasts from 20 - half to 20 + half
    strip = slope * 20**2 / 2 + slope * 20 * 2 * half
    assert volume(program, FLAT) == pytest.approx(strip.sum() / 10000, rel=1e-3)


def test_a_ramp_of_a_ball_and_a_plunge():
    steep = begun().feed(0, 0, -2)
    assert volume(steep, BALL) == pytest.approx(SPHERE_CAP, rel=1e-3)
    assert volume(steep, FLAT) == pytest.approx(2 * np.pi * R**2, rel=1e-3)


def test_cells_fill_the_stock_and_what_is_below_it_is_no_volume():
    part = height_map(begun().feed(0, 0, -30).toolpath(), FLAT, Stock((30, 20, 5)), 0.05)
    assert np.multiply(part.heights_mm.shape, part.cell_mm[::-1]).tolist() == pytest.approx([20, 30])
    assert part.removed_volume_mm3 == pytest.approx(5 * np.pi * R**2, rel=1e-3)


def test_lines_over_ground_that_is_cut_already_leave_what_each_alone_does():
    rng = np.random.default_rng(8)
    way = np.column_stack([rng.uniform(-6, 6, (40, 2)), rng.choice([-0.7, -1.3], 40)])
    points = np.vstack([way, way[::-1], way])
    moves, uncut = Moves.lines(points[:-1], points[1:], Form(1.5, 1.5)), Part(Grid.of(Stock((12, 12, 3)), 0.07))
    one_by_one = uncut
    for k in range(len(moves)):
        one_by_one = one_by_one.after(moves, k, k + 1)
    together = uncut.after(moves)
    assert np.array_equal(together.heights_mm(), one_by_one.heights_mm())
    assert np.array_equal(together.means_mm(), one_by_one.means_mm())
