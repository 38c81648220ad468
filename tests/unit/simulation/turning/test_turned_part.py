# SPDX-License-Identifier: LGPL-2.1-or-later
"""The turned part against figures by hand, and against points on a grid that share nothing with it."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.turning.half_section import HalfSection, bar, below_chain
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.turning.tool_section import ToolSection, convex_parts
from CNCStepper.simulation.turning.turned_part import turned_part
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder
from helpers.cycles.seeds import SEEDS
from helpers.simulation.half_section_judge import cut_points
from helpers.simulation.lathe_moves import cnmg, cut, lathe_path

STOCK = bar(55, 170, 1)
SHOULDER = [("rapid", 5, 25), ("feed", -40, 25), ("feed", -40, 30), ("rapid", 5, 30)]


def test_a_cylinder_has_its_diameter_and_a_fillet_of_the_nose() -> None:
    part = cut(SHOULDER, STOCK, cnmg()).section
    assert part.diameter_mm(-20) == pytest.approx(50, abs=1e-9)
    assert part.diameter_mm(-100) == 55
    assert part.bore_profile == []
    z, diameter = np.array(part.outer_profile).T
    fillet = (z > -40 + 1e-6) & (z < -39.2 - 1e-6) & (diameter < 51.6)
    from_centre = np.hypot(z[fillet] + 39.2, diameter[fillet] / 2 - 25.8)
    assert fillet.sum() > 10
    assert np.abs(from_centre - 0.8).max() < 1e-7  # a part's inner corner has the nose's radius


def test_the_volume_is_that_of_the_turned_region() -> None:
    part = cut(SHOULDER, STOCK, cnmg()).section
    ring = np.pi * (27.5**2 - 25**2) * 41
    corner = (0.8**2 - np.pi * 0.8**2 / 4) * 2 * np.pi * (25 + 0.8 * (1 - 0.7766))  # Pappus, about
    assert STOCK.volume_mm3 == pytest.approx(np.pi * 27.5**2 * 171)
    assert STOCK.volume_mm3 - part.volume_mm3 == pytest.approx(ring - corner, abs=0.1)


def test_a_cone_is_offset_by_the_nose_that_does_not_touch_with_its_tip() -> None:
    part = cut([("rapid", 5, 10), ("feed", 0, 10), ("feed", -20, 20), ("feed", -20, 40)], STOCK, cnmg()).section
    slope = np.arctan2(10, 20)
    over = 0.8 * (1 / np.cos(slope) - 1 - np.tan(slope))  # nose centre (0.8, 0.8) from the tip, along r
    assert part.diameter_mm(-10) == pytest.approx(2 * (15 - over), abs=2e-3)


def test_an_arc_of_g18_leaves_its_radius_less_the_nose() -> None:
    nose = ToolSection.of(TurningTool(number=1, insert="RCMT 0803M0"))  # a disc of 8 mm about its centre
    moves = [("rapid", 5, 24), ("feed", 0, 24), ("ccw", -20, 44, -20, 24), ("rapid", -20, 60)]
    part = cut(moves, bar(80, 100, 0), nose).section
    angles = np.linspace(0.1, 1.4, 9)
    wanted = np.column_stack([-20 + 16 * np.cos(angles), 24 + 16 * np.sin(angles)])
    assert shapely.distance(part.region.boundary, shapely.points(wanted)).max() < 1e-3


def test_states_on_the_way_are_those_of_the_moves_done() -> None:
    whole = cut([*SHOULDER, ("rapid", 5, 24), ("feed", -10, 24), ("feed", -20, 24)], STOCK, cnmg())
    assert whole.at(-1).region.equals(STOCK.region)
    assert whole.at(0).diameter_mm(-5) == 55
    assert whole.at(1).diameter_mm(-5) == pytest.approx(50)
    assert whole.at(5).diameter_mm(-5) == pytest.approx(48)
    assert whole.at(5).diameter_mm(-15) == pytest.approx(50)
    assert whole.at(6).region.symmetric_difference(whole.section.region).area < 1e-9


def test_a_parted_piece_falls_and_is_cut_no_more() -> None:
    blade = ToolSection.of(TurningTool(number=1, kind="parting", width_mm=3, reach_mm=30))
    away = [("rapid", -33, 40), ("rapid", -10, 40), ("feed", -10, 5), ("rapid", -10, 40)]
    part = cut([("rapid", -33, 30), ("feed", -33, 0), *away], STOCK, blade)
    (fallen,) = part.fallen
    assert fallen.section.region.bounds == pytest.approx((-30, 0, 1, 27.5), abs=1e-6)
    assert part.held.region.bounds == pytest.approx((-170, 0, -33, 27.5), abs=1e-6)
    assert part.section.diameter_mm(-9) == 55  # the later groove meets nothing
    assert part.section.diameter_mm(-31.5) == 0


def test_a_drill_and_a_boring_bar_leave_their_bore() -> None:
    drill = ToolSection.of(TurningTool(number=1, kind="drill", diameter_mm=20))
    part = cut([("rapid", 5, 0), ("feed", -30, 0), ("rapid", 5, 0)], STOCK, drill)
    assert part.section.bore_mm(-10) == pytest.approx(20)
    assert part.section.diameter_mm(-10) == 55
    point_mm = 10 / np.tan(np.radians(59))
    assert part.section.bore_mm(-30 + point_mm / 2) == pytest.approx(10, abs=1e-6)
    assert part.section.bore_profile[0] == (-170, 0)


def test_a_thread_is_cut_once_a_turn() -> None:
    insert = ToolSection.of(TurningTool(number=1, kind="threading", tip_angle_deg=60, nose_radius_mm=0), pitch_mm=2.0)
    part = cut([("rapid", 4, 26), ("feed", -20, 26), ("feed", -20, 30)], bar(54, 100, 0), insert).section
    for turn in range(3, 9):
        assert part.diameter_mm(4 - 2 * turn) == pytest.approx(52, abs=1e-6)
        assert part.diameter_mm(3 - 2 * turn) == pytest.approx(54)
    half_width = (27 - 26) * np.tan(np.radians(30))
    assert part.diameter_mm(-10 + half_width / 2) == pytest.approx(53, abs=1e-6)


def test_g33_is_a_thread_by_its_event() -> None:
    table = TableBuilder(Start((40.0, 0.0, 4.0), zero_known=True), State(tool=1, spindle_rpm=500, spindle="cw"))
    table.rapid((26, 0, 4), 1)
    table.event("synchronised", 1.5, "G33")
    table.feed((26, 0, -20), 750, 2)
    insert = ToolSection.of(TurningTool(number=1, kind="threading", tip_angle_deg=60, nose_radius_mm=0))
    part = turned_part(moves_of(table.toolpath()), bar(54, 100, 0), {1: insert}).section
    assert part.diameter_mm(4 - 1.5 * 4) == pytest.approx(52)
    assert part.diameter_mm(4 - 1.5 * 4.5) == pytest.approx(54, abs=0.6)
    assert part.diameter_mm(4 - 1.5 * 4.5) > 53


def test_a_tool_over_the_axis_cuts_on_the_other_side() -> None:
    square = ToolSection(shapely.box(0, 0, 5, 20))
    part = cut([("rapid", -10, 30), ("feed", -10, -3), ("rapid", -10, 30)], bar(20, 40, 0), square)
    assert part.held.region.bounds[2] == pytest.approx(-10)
    part = cut(
        [("rapid", 5, -8), ("feed", -10, -8), ("rapid", 5, -8)], bar(20, 40, 0), ToolSection(shapely.box(0, 0, 5, 3))
    )
    assert part.section.bore_mm(-5) == 0
    assert shapely.Point(-5, 6.5).distance(part.section.region) > 0.4  # r -8 to -5 is r 5 to 8


def test_offsets_of_the_tool_are_no_part_of_its_place() -> None:
    """An offset of the tool along X and Z moves the machine, not the tip in the work coordinates."""
    path, offset_mm = lathe_path([("rapid", 5, 40), *SHOULDER]), np.array((7.0, 0.0, 12.0))
    table = TableBuilder(path.start, State(tool=1))
    table.rapid((40.0, 0.0, 5.0), 1)
    table.set_state(State(tool=1, offset_mm=tuple(offset_mm.tolist()), tool_length_mm=4.0))
    for kind, end in zip(path.table().kind[1:], path.table().end[1:] + offset_mm, strict=True):
        table.feed(tuple(end), 200.0) if kind else table.rapid(tuple(end))
    part = turned_part(moves_of(table.toolpath()), STOCK, {1: cnmg()})
    assert part.region.symmetric_difference(cut(SHOULDER, STOCK, cnmg()).region).area < 1e-9


def random_outline(random: np.random.Generator) -> np.ndarray:
    """Return a star-shaped outline about its control point, often not convex."""
    count = int(random.integers(4, 9))
    angles = (np.arange(count) + random.uniform(0, 0.8, count)) * 2 * np.pi / count
    reach = random.uniform(1.5, 6.0, count)
    return np.column_stack([reach * np.cos(angles), reach * np.sin(angles) + 2])


@pytest.mark.parametrize("seed", SEEDS)
def test_random_outlines_along_random_moves_cut_what_points_on_a_grid_say(seed: int) -> None:
    random = np.random.default_rng(seed)
    outline = random_outline(random)
    section = ToolSection(shapely.Polygon(outline))
    places = np.column_stack([random.uniform(-25, 8, 4), random.uniform(6, 22, 4)])
    part = cut([("feed", z, r) for z, r in places], bar(40, 30, 0), section)
    points = np.column_stack([random.uniform(-30, 0, 500), random.uniform(0, 20, 500)])
    gone = cut_points(points, outline, np.vstack([(5.0, 40.0), places]), 0.04)
    left = shapely.union_all([part.region, *(one.section.region for one in part.fallen)])
    near = shapely.distance(left.boundary, shapely.points(points)) < 0.1
    assert near.mean() < 0.3
    fallen_early = shapely.union_all([one.section.region for one in part.fallen]).buffer(0.1)
    compared = ~near & ~shapely.contains_xy(fallen_early, *points.T)
    assert (shapely.contains_xy(left, *points.T) != ~gone)[compared].sum() == 0


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_an_outline_that_is_not_convex_is_its_parts(seed: int) -> None:
    outline = shapely.Polygon(random_outline(np.random.default_rng(seed)))
    parts = [shapely.Polygon(part) for part in convex_parts(outline)]
    assert shapely.union_all(parts).symmetric_difference(outline).area < 1e-4
    assert all(part.convex_hull.area - part.area < 1e-9 for part in parts)


def test_profiles_of_a_step_a_groove_and_an_undercut() -> None:
    region = below_chain([(0, 5), (-10, 5), (-10, 9), (-20, 9), (-20, 4), (-25, 4), (-30, 8)])
    part = HalfSection(region)
    assert part.outer_profile == [(-30, 16), (-25, 8), (-20, 8), (-20, 18), (-10, 18), (-10, 10), (0, 10)]
    assert part.diameter_mm(-10) == 18
    assert part.diameter_mm(-27.5) == pytest.approx(12)
    assert part.diameter_mm(3) == 0
    overhang = HalfSection(region.difference(shapely.box(-18, 3, -12, 6)))
    assert overhang.outer_profile == part.outer_profile
    assert overhang.bore_profile == []  # a hollow in the middle is no bore: the axis is solid
