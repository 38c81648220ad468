# SPDX-License-Identifier: LGPL-2.1-or-later
"""Planted faults are found at their line, and clean programs have no finding."""

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.cycle import Removal
from CNCStepper.errors import Place
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.finding import Finding, refused
from CNCStepper.simulation.stock import HeightField, Stock
from CNCStepper.toolpath import ARC_CCW, ARC_CW, ZX
from helpers.simulation.programs import BALL, FLAT, Program, begun, square_pocket, square_removal

MACHINE = load_machine("table-a")
STOCK = Stock((60, 50, 20))


def found(program, tool=FLAT, stock=STOCK, removals=None, machine=MACHINE):
    return check(program.toolpath(), machine, file="p.nc", stock=stock, tools={1: tool}, removals=removals)


def codes(program, **more):
    return [(finding.code, finding.place.line) for finding in found(program, **more)]


def test_clean_programs_have_no_finding():
    assert found(square_pocket(), removals=[square_removal()]) == []
    hopping = square_pocket().rapid(10, 10, 5).rapid(10, 10, -4).feed(-10, 10, -4).rapid(-17, -17, -4).rapid(0, 0, 5)
    assert found(hopping, removals=[square_removal()]) == []
    ball = begun().feed(0, 0, -1, 200).feed(10, 0, -1).rapid(10, 0, 5).rapid(0, 0, 5).rapid(0, 0, -1)
    assert found(ball.rapid(10, 0, -1).rapid(10, 0, 5), tool=BALL) == []


def test_a_finding_reads_as_file_line_column_text():
    finding = Finding("error", "c", Place("p.nc", 3, 1), "it is bad", "mend it", (1, 2, 3), 1.5, 1.0, "mm", 2)
    assert str(finding) == "p.nc:3:1: error: it is bad (at X1 Y2 Z3 mm, value 1.5 mm, limit 1 mm, 2 moves); mend it [c]"
    assert refused([finding])
    assert finding.as_dict()["place_mm"] == [1, 2, 3]


def test_a_gouge_of_two_hundredths_is_found_at_its_line():
    program = square_pocket(wall_mm=0.02)
    (finding,) = found(program, removals=[square_removal()])
    assert finding.code == "gouge"
    assert finding.value == pytest.approx(0.02 * 2**0.5, abs=0.001)
    row = int(np.flatnonzero(program.toolpath().table().line == finding.place.line)[0])
    assert np.abs(program.toolpath().table().end[row, :2] + 200).max() == pytest.approx(17.02)


def test_a_missing_pass_is_found():
    assert [code for code, _ in codes(square_pocket(skip=(8,)), removals=[square_removal()])] == ["left-over"]
    assert codes(square_pocket(levels=(-2,)), removals=[square_removal()])[0][0] == "left-over"


def test_a_rapid_through_a_corner_of_the_stock_is_found():
    for into_mm, touches in ((1.0, True), (0.1, True), (-0.01, False)):
        reach = 55 + (3 - into_mm) * np.sqrt(2)  # x + y on the way; 55 is the corner's
        program = square_pocket().rapid(40, reach - 40, 5).rapid(40, reach - 40, -1)
        program.rapid(25, reach - 25, -1).rapid(25, reach - 25, 5)
        assert codes(program) == ([("rapid-in-stock", program.line - 2)] if touches else [])


@pytest.mark.parametrize(("x", "touches"), [(16.9, False), (17.0, False), (17.02, True)])
def test_a_rapid_along_a_wall_touches_only_when_it_leaves_the_cleared_width(x, touches):
    program = square_pocket().rapid(x, 0, 5).rapid(x, 0, -4).rapid(x, 10, -4).rapid(x, 10, 5)
    assert bool(codes(program)) is touches


def test_a_ball_leaves_its_hole_whatever_the_decimals_of_its_depth():
    for z in (-0.7, -1.00004, -1.00006, -2.0 / 3):
        assert codes(begun().feed(0, 0, z).rapid(0, 0, 5), tool=BALL) == []


def test_a_rapid_over_the_low_side_of_a_height_field_touches_nothing():
    field = HeightField((60, 50, 20), heights_mm=np.array([[20.0, 10.0], [20.0, 10.0]]))  # falls from left to right
    for x, z, touches in ((10, -6, False), (10, -6.3, True), (20, -7.5, False), (20, -8, True)):
        program = begun().rapid(x, 0, 5).rapid(x, 0, z).rapid(x, 0, 5)
        assert codes(program, stock=field) == ([("rapid-in-stock", 4)] if touches else [])


def test_a_rapid_down_before_the_pocket_is_cut_is_found():
    program = begun().rapid(0, 0, -2).feed(5, 0, -2).rapid(5, 0, 5)
    assert codes(program) == [("rapid-in-stock", 3)]


def test_a_ramp_that_ends_a_few_hundredths_deep_is_found():
    program = begun(spindle="off", spindle_rpm=0).feed(0, 0, 1).feed(20, 0, -0.02).feed(0, 0, -1).rapid(0, 0, 5)
    assert codes(program) == [("spindle-off", 4)]


def dip(**state) -> Program:
    """Return a program whose half circle of G18 begins and ends over the stock and dips into it."""
    program = begun(**state).rapid(-10, 0, 1)
    return program.arc(ARC_CW, (10, 0, 1), (0, 0, 1), plane=ZX).rapid(10, 0, 5)


def test_an_arc_that_dips_into_the_stock_between_its_ends_is_seen():
    assert codes(dip()) == []
    assert codes(dip(spindle="off")) == [("spindle-off", 4)]


def test_a_spindle_switched_on_at_no_speed_stands():
    slow = MACHINE.model_copy(update={"spindle": MACHINE.spindle.model_copy(update={"min_rpm": 0.0})})
    program = begun(spindle_rpm=0).feed(0, 0, -1).rapid(0, 0, 5)
    assert codes(program, machine=slow) == [("spindle-off", 3)]


def test_a_wide_mill_that_comes_down_on_a_corner_between_two_points_of_its_rim():
    wide = Tool(number=1, shape="flat", diameter_mm=50)
    for into_mm, touches in ((0.1, True), (-0.01, False)):
        x, y = 30 + (25 - into_mm) * np.cos(np.radians(47.8)), 25 + (25 - into_mm) * np.sin(np.radians(47.8))
        program = begun().rapid(x, y, 5).rapid(x, y, -3).rapid(x, y, 5)
        assert codes(program, tool=wide) == ([("rapid-in-stock", 4)] if touches else [])


def test_a_gouge_is_told_of_the_line_that_makes_it_and_not_of_the_way_out():
    program = begun().feed(0, 0, -1).feed(2, 0, -1).rapid(2, 0, 5)
    hole = Removal(shapely.Point(0, 0).buffer(3), 0, -1)
    assert [one for one in codes(program, removals=[hole]) if one[0] == "gouge"] == [("gouge", 4)]
    deep = begun().feed(0, 0, -3).rapid(0, 0, 5)
    assert ("gouge", 3) in codes(deep, removals=[hole])


def test_a_cut_without_the_spindle_is_found_once():
    program = begun(spindle="off", spindle_rpm=0).feed(0, 0, -1).feed(5, 0, -1).feed(9, 0, -1).rapid(9, 0, 5)
    assert codes(program) == [("spindle-off", 3)]
    air = begun(spindle="off", spindle_rpm=0).feed(0, 0, 1).feed(50, 0, 1).feed(50, 0, -3).feed(50, 9, -3)
    assert codes(air) == []


@pytest.mark.parametrize("over_mm", [-0.01, 0.01])
def test_travel_exceeded_by_a_hundredth_after_an_offset(over_mm):
    program = Program(zero_mm=(-30.0, -200.0, -40.0)).up_first(5).rapid(0, 0, 5).rapid(30 + over_mm, 0, 5)
    findings = found(program)
    assert [(f.code, f.place.line) for f in findings] == ([("travel", 3)] if over_mm > 0 else [])
    if findings:
        assert findings[0].value == pytest.approx(0.01)
        assert findings[0].limit == 0
        assert "X by 0.01 mm" in findings[0].text


def test_an_arc_leaves_the_travel_between_its_ends():
    program = Program(zero_mm=(-10.0, -200.0, -40.0)).up_first(5).rapid(0, -10, 5).arc(ARC_CCW, (0, 10, 5), (0, 0, 5))
    assert codes(program) == []
    program = Program(zero_mm=(-9.99, -200.0, -40.0)).up_first(5).rapid(0, -10, 5).arc(ARC_CCW, (0, 10, 5), (0, 0, 5))
    assert codes(program) == [("travel", 3)]


def test_where_the_zero_is_unknown_the_place_is_reported_and_only_size_is_refused():
    small = Program(zero_known=False).up_first(5).rapid(0, 0, 5).rapid(400, 0, 5)
    assert [(f.code, f.severity) for f in found(small)] == [("place-unknown", "info")]
    large = small.rapid(400.01, 0, 5)
    assert ("travel", "error") in [(f.code, f.severity) for f in found(large)]
    assert refused(found(large))


def test_rates_speeds_coolant_and_tools():
    fast = begun().feed(0, 0, 1, 900).feed(10, 0, 1, 6000).feed(10, 10, 1, 5000)
    assert codes(fast) == [("feed-above-rate", 3), ("feed-above-rate", 4)]
    assert codes(begun(spindle_rpm=25000)) == [("spindle-speed", 1)]
    assert codes(begun(spindle_rpm=0)) == [("spindle-speed", 1)]
    assert codes(begun().set(mist=True).rapid(1, 1, 5)) == [("coolant", 3)]
    assert codes(begun().set(flood=True).rapid(1, 1, 5)) == []
    assert codes(begun().feed(0, 0, 2).set(tool=7).feed(1, 1, 2)) == [("tool-change", 4), ("unknown-tool", 4)]
    assert codes(begun().feed(0, 0, 1, 0)) == [("no-feed", 3)]


def test_a_stop_makes_a_tool_change_and_wants_a_still_spindle():
    tools = {1: FLAT, 2: BALL}
    program = begun().feed(0, 0, 2).set(spindle="off")
    program.table.event("pause")
    program.set(tool=2, spindle="cw")
    program.table.event("dwell", 3.0)
    program.feed(5, 0, 2)
    assert check(program.toolpath(), MACHINE, stock=STOCK, tools=tools) == []
    turning = begun().feed(0, 0, 2)
    turning.table.event("pause", line=4)
    turning.set(tool=2).feed(5, 0, 2)
    assert [f.code for f in check(turning.toolpath(), MACHINE, stock=STOCK, tools=tools)] == ["pause-spindle"]


def test_a_cut_before_the_spindle_turns_at_its_speed():
    program = begun().feed(0, 0, 2)
    program.table.events.clear()
    assert codes(program) == [("spin-up", 3)]


def test_below_the_stock_and_from_nowhere():
    through = begun().feed(0, 0, -20.2).rapid(0, 0, 5)
    assert [(f.code, f.severity) for f in found(through)] == [("below-stock", "warning")]
    table = begun().feed(0, 0, -20.2).feed(0, 0, -25.2).rapid(0, 0, 5)
    assert [(f.severity, f.place.line) for f in found(table)] == [("error", 4)]
    beside = begun().rapid(50, 0, 5).rapid(50, 0, -25).rapid(50, 0, 5)
    assert found(beside) == []
    arc = begun().rapid(40, -30, 5).feed(40, -30, -21).arc(ARC_CW, (40, 30, -21), (40, 0, 0)).rapid(40, 30, 5)
    assert codes(arc) == [("below-stock", 5)]  # it bulges under the stock, its ends lie beside it
    assert codes(Program().feed(0, 0, 1)) == [("position-unknown", 1)]
    assert codes(Program().rapid(0, 0, 5)) == [("height-unknown", 1)]


def test_a_table_without_moves_is_no_program():
    assert [finding.code for finding in found(Program())] == ["no-motion"]
