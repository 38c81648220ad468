# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge against faults of known size."""

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.cycle import Removal
from CNCStepper.simulation.exact.swept_area import judge
from CNCStepper.simulation.stock import HeightField, Stock
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import BALL, FLAT, Program, begun, square_pocket, square_removal

STOCK = Stock((60, 50, 20))


def judged(program, removals, tool=FLAT, stock=STOCK):
    return judge(program.toolpath(), tool, removals, stock)


def test_a_clean_pocket_has_neither_gouge_nor_rest():
    verdict = judged(square_pocket(), [square_removal()])
    assert verdict.gouge_mm < 0.001
    assert verdict.left_over_mm < 0.001
    assert verdict.islands == []
    assert [level.z_mm for level in verdict.levels] == pytest.approx([-2, -4])


@pytest.mark.parametrize("fault_mm", [0.005, 0.02, 0.3, 1.5])
def test_a_wall_cut_too_far_is_a_gouge_of_that_size(fault_mm):
    verdict = judged(square_pocket(wall_mm=fault_mm), [square_removal()])
    corner_mm = fault_mm * np.sqrt(2)  # the rounded corners move along the diagonal
    assert verdict.gouge_mm == pytest.approx(corner_mm, abs=0.001)
    assert np.abs(verdict.gouge.place_mm[:2]) == pytest.approx([17 + 3 / 2**0.5 + fault_mm] * 2, abs=0.1)


@pytest.mark.parametrize("fault_mm", [0.005, 0.02, 0.3])
def test_a_wall_not_reached_is_a_rest_of_that_size(fault_mm):
    verdict = judged(square_pocket(wall_mm=-fault_mm), [square_removal()])
    assert verdict.gouge_mm < 0.001
    assert verdict.left_over_mm == pytest.approx(fault_mm * np.sqrt(2), abs=0.001)


def test_a_gouge_is_found_among_many_moves_over_a_seam():
    """Two removals that nearly touch: each move along the seam may enter the sliver between them, which is nothing."""
    halves = [Removal(shapely.box(-20, low, 20, high), 0, -4) for low, high in ((-15, 0), (0.0003, 15))]
    program = begun().rapid(-17, 0, 5).feed(-17, 0, -4)
    for x in np.linspace(-17, 17, 400):
        program.feed(float(x), 0, -4)
    program.feed(17.4, 0, -4).rapid(17.4, 0, 5)
    verdict = judged(program, halves)
    assert verdict.gouge_mm == pytest.approx(0.4, abs=0.001)


def test_a_floor_too_deep_and_a_floor_too_high():
    deep = judged(square_pocket(levels=(-2, -4.02)), [square_removal()])
    assert deep.gouge_mm == pytest.approx(0.02, abs=0.001)
    high = judged(square_pocket(levels=(-2, -3.8)), [square_removal()])
    assert high.left_over_mm == pytest.approx(0.2, abs=0.001)
    assert high.gouge_mm < 0.001


def test_a_missing_finishing_ring_and_a_missing_level():
    ring = judged(square_pocket(skip=(8,)), [square_removal()])
    assert ring.left_over_mm > 0.9
    level = judged(square_pocket(levels=(-2,)), [square_removal()])
    assert level.left_over_mm == pytest.approx(2, abs=0.001)


def test_a_missing_ring_in_the_middle_leaves_an_island():
    program = begun().feed(0, 0, -2).feed(20, 0, -2).rapid(20, 0, 5).rapid(0, 8, 5).feed(0, 8, -2).feed(20, 8, -2)
    region = shapely.box(0, -3, 20, 11)
    verdict = judged(program, [Removal(region, 0.0, -2.0)])
    assert verdict.left_over_mm == pytest.approx(2, abs=0.001)
    (island,) = verdict.islands
    assert island.thickness_mm == pytest.approx(2, abs=0.001)
    assert island.place_mm[1] == pytest.approx(4, abs=0.001)


def test_a_ridge_lower_than_it_is_wide_counts_with_its_height():
    program = square_pocket(levels=(-2,)).rapid(0, 0, -1.5)
    for x in (-17, 17):  # both halves deeper, a strip of 4 mm between them stays 0.1 mm higher
        program.rapid(x, -17, -1.5).feed(x, -17, -2.1)
        for k in range(0, 16, 2):
            here = x - np.sign(x) * min(k, 12)
            program.feed(here, -17, -2.1).feed(here, 17, -2.1).feed(here, -17, -2.1)
        program.rapid(0, 0, 5)
    verdict = judged(program, [square_removal(depth_mm=2.1)])
    assert verdict.left_over_mm == pytest.approx(0.1, abs=0.001)


def test_the_outside_of_the_stock_is_air():
    program = begun().feed(0, 0, -2).feed(40, 0, -2)
    slot = shapely.LineString([(0, 0), (30, 0)]).buffer(3, quad_segs=128)
    assert judged(program, [Removal(slot, 0, -2)]).gouge_mm < 0.001
    assert judged(program, [Removal(slot, 0, -2)], stock=None).gouge_mm == pytest.approx(2, abs=0.01)


def test_a_helix_that_is_too_wide_gouges():
    region = shapely.Point(0, 0).buffer(8, quad_segs=512)
    for radius, gouge in ((5.0, 0.0), (5.02, 0.02)):
        program = begun().feed(radius, 0, 0).arc(ARC_CCW, (radius, 0, -3), (0, 0, 0), turns=3)
        program.arc(ARC_CCW, (radius, 0, -3), (0, 0, -3)).feed(0, 0, -3).feed(2.5, 0, -3)
        program.arc(ARC_CCW, (2.5, 0, -3), (0, 0, -3))
        verdict = judged(program, [Removal(region, 0, -3)])
        assert verdict.gouge_mm == pytest.approx(gouge, abs=0.001)
        assert verdict.left_over_mm < 0.001


def test_a_convex_corner_of_the_part_is_judged_by_its_nearer_face():
    """The tool enters a square boss along the diagonal; the deepest point lies nearer to a face than to the corner."""
    boss = shapely.box(-20, -20, 20, 20).difference(shapely.box(0, 0, 30, 30))
    centre = -3 / np.sqrt(2) + 0.2
    program = begun().rapid(-10, -10, 5).feed(-10, -10, -1).feed(centre, centre, -1)
    verdict = judged(program, [Removal(boss, 0, -1)])
    angle = np.linspace(0, np.pi / 2, 100001)
    x, y = centre + 3 * np.cos(angle), centre + 3 * np.sin(angle)
    assert verdict.gouge_mm == pytest.approx(np.minimum(x, y).max(), abs=0.001)


def test_a_ball_gouges_with_its_radius_at_height():
    groove = shapely.box(-3, -30, 3, 30)
    for x, gouge in ((0.0, 0.0), (0.02, 0.02)):
        program = begun().feed(x, -10, -5).feed(x, 10, -5)
        assert judged(program, [Removal(groove, 0, -5)], BALL).gouge_mm == pytest.approx(gouge, abs=0.002)
    shallow = begun().rapid(2, -10, 5).feed(2, -10, -0.1).feed(2, 10, -0.1)
    assert judged(shallow, [Removal(groove, 0, -5)], BALL).gouge_mm < 0.002


def test_a_ball_leaves_scallops():
    program = begun()
    for x in (-2, 0, 2):
        program.rapid(x, -12, 5).feed(x, -12, -3).feed(x, 12, -3).rapid(x, 12, 5)
    strip = Removal(shapely.box(-2, -10, 2, 10), 0, -3)
    assert judged(program, [strip], BALL).left_over_mm == pytest.approx(np.hypot(1, 3) - 3, abs=0.001)


def engraving(shift_mm=0.0, depth_mm=1.0, to=20):
    program = begun().feed(0, shift_mm, -depth_mm, 200).feed(10, shift_mm, -depth_mm).feed(to, 10 + shift_mm, -depth_mm)
    return program.rapid(to, 10 + shift_mm, 5)


def test_an_engraving_is_judged_by_the_tools_centre_and_depth():
    line = Removal(shapely.LineString([(0, 0), (10, 0), (20, 10)]), 0.0, -1.0)
    clean = judged(engraving(), [line], BALL)
    assert (clean.gouge_mm, clean.left_over_mm) == (0.0, 0.0)
    beside = judged(engraving(shift_mm=0.05), [line], BALL)
    assert beside.gouge_mm == pytest.approx(0.05, abs=0.001)
    assert beside.left_over_mm == pytest.approx(0.05, abs=0.001)
    assert judged(engraving(depth_mm=1.02), [line], BALL).gouge_mm == pytest.approx(0.02, abs=0.001)
    assert judged(engraving(depth_mm=0.9), [line], BALL).left_over_mm == pytest.approx(0.1, abs=0.001)
    short = judged(
        engraving(to=18), [Removal(shapely.LineString([(0, 0), (10, 0), (18, 10), (19, 10)]), 0.0, -1.0)], BALL
    )
    assert short.left_over_mm == pytest.approx(1.0, abs=0.001)


@pytest.mark.parametrize("rounded_mm", [-0.0004, 0.0004])
def test_an_engraving_rounded_off_the_edge_of_its_line_leaves_nothing(rounded_mm):
    line = Removal(shapely.LineString([(0, 0), (10, 0), (20, 10)]), 0.0, -1.0)
    rounded = judged(engraving(shift_mm=rounded_mm), [line], BALL)
    assert rounded.left_over_mm == pytest.approx(0.0004, abs=0.0001)


def test_an_engraving_beside_a_pocket_does_not_gouge_it():
    program = square_pocket()
    program.rapid(22, -10, 5).feed(22, -10, -0.5).feed(22, 10, -0.5).rapid(22, 10, 5)
    line = Removal(shapely.LineString([(22, -10), (22, 10)]), 0.0, -0.5)
    verdict = judged(program, [square_removal(), line])
    assert verdict.gouge_mm < 0.001
    assert verdict.left_over_mm < 0.001


def test_two_bottoms_each_have_their_floor():
    shelf = Removal(shapely.box(20, -8, 28, 8), 0.0, -1.0)
    program = square_pocket().rapid(14, 0, 5).feed(14, 0, -1)
    for y in (-5, -2.5, 0, 2.5, 5):
        program.feed(14, y, -1).feed(25, y, -1).feed(14, y, -1)
    tip = judged(program, [square_removal(), shelf])
    assert tip.gouge_mm < 0.001
    program.feed(14, 0, -4).feed(17.5, 0, -4).rapid(17.5, 0, 5)
    assert judged(program, [square_removal(), shelf]).gouge_mm == pytest.approx(0.5, abs=0.001)


def test_nothing_cut_leaves_all_of_it():
    verdict = judged(Program().up_first(5), [square_removal()])
    assert verdict.left_over_mm == 4
    assert verdict.gouge_mm == 0


def valley():
    """Return a stock with a valley along Y: 10 mm deep up to 8 mm beside its middle, rising to the top at 10 mm."""
    across = np.interp(np.abs(np.linspace(-30, 30, 61)), (8, 10), (10, 20))
    return HeightField((60, 50, 20), heights_mm=np.tile(across, (2, 1)))


@pytest.mark.parametrize("into_mm", [-0.01, 0.02])
def test_the_air_over_a_height_field_is_no_gouge_and_its_floor_is_one(into_mm):
    pocket = Removal(shapely.Point(-20, 0).buffer(3, quad_segs=128), 0, -2)
    program = begun().rapid(-20, 0, 5).feed(-20, 0, -2).rapid(-20, 0, 5).rapid(2, -30, 5).rapid(2, -30, -10 - into_mm)
    verdict = judge(program.feed(2, 30, -10 - into_mm).toolpath(), FLAT, [pocket], valley())
    assert verdict.gouge_mm == pytest.approx(max(into_mm, 0.0), abs=0.001)


def test_nothing_is_left_where_a_height_field_holds_nothing():
    across = Removal(shapely.box(-15, -3, 15, 3), 0, -9)  # its floor lies 1 mm over the valley's
    program = begun().rapid(-15, 0, 5)
    for x in (-1, 1):
        program.rapid(15 * x, 0, 5).feed(15 * x, 0, -9).feed(7 * x, 0, -9).rapid(7 * x, 0, 5)
    whole = judge(program.toolpath(), FLAT, [across], valley())
    assert whole.left_over_mm < 0.001
    assert judge(program.toolpath(), FLAT, [across], Stock((60, 50, 20))).left_over_mm > 1
