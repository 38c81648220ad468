# SPDX-License-Identifier: LGPL-2.1-or-later
"""Removed volumes against formulas, and every height against an independent one."""

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st
from programs import BALL, FLAT, begun

from CNCStepper.simulation.cutter import Cutter
from CNCStepper.simulation.heightmap import HeightMap, height_map
from CNCStepper.simulation.segments import Segments
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW

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


@settings(max_examples=15, deadline=None)
@given(
    st.tuples(*[st.floats(-12, 12)] * 2, st.floats(-6, 1)),
    st.tuples(*[st.floats(-12, 12)] * 2, st.floats(-6, 1)),
    st.booleans(),
)
def test_heights_agree_with_a_walk_along_the_segment(begin, end, ball):
    part = HeightMap(Stock((36, 36, 20)), 1.2)
    part.cut(Cutter(R, ball), Segments(np.array([begin]), np.array([end]), np.zeros(1, np.int64)))
    x, y = np.meshgrid(part.x_mm, part.y_mm)
    want = np.zeros_like(x)
    for share in np.linspace(0, 1, 2001):
        px, py, pz = np.array(begin) * (1 - share) + np.array(end) * share
        room = R**2 - (x - px) ** 2 - (y - py) ** 2
        z = np.where(room >= 0, pz + (R - np.sqrt(np.maximum(room, 0)) if ball else 0.0), 0.0)
        want = np.minimum(want, z)
    path = shapely.LineString([begin[:2], end[:2]]) if begin[:2] != end[:2] else shapely.Point(begin[:2])
    clear = np.abs(shapely.distance(path, shapely.points(x, y)) - R) > 1e-9  # exactly on the rim rounding decides
    off = np.abs(part.heights_mm - want)[clear]
    assert np.quantile(off, 0.98) < 0.02  # at the rim a walk in steps may miss a cell
    assert (part.heights_mm <= want + 1e-9)[clear].all()


def test_without_numba_the_kernel_gives_the_same():
    from CNCStepper.simulation import heightmap

    begin, end = np.array([[-5.0, -3.0, -1.0], [2.0, 2.0, -4.0]]), np.array([[6.0, 4.0, -2.0], [2.0, 2.0, -5.0]])
    grid = np.array([-9.5, -9.5, 1.0, 1.0])
    maps = [np.zeros((20, 20)) for _ in range(2)]
    for ball in (False, True):
        heightmap._cut(maps[0], grid, begin, end, R, ball)
        getattr(heightmap._cut, "py_func", heightmap._cut)(maps[1], grid, begin, end, R, ball)
        assert (maps[0] == maps[1]).all()


def test_cells_fill_the_stock_and_what_is_below_it_is_no_volume():
    part = height_map(begun().feed(0, 0, -30).toolpath(), FLAT, Stock((30, 20, 5)), 0.05)
    assert np.multiply(part.heights_mm.shape, part.cell_mm[::-1]).tolist() == pytest.approx([20, 30])
    assert part.removed_volume_mm3 == pytest.approx(5 * np.pi * R**2, rel=1e-3)
