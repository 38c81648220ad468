# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tool cannot do is found at its line, with value and limit; what it can do is not."""

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW, ARC_CW, ZX
from helpers.simulation.programs import Program, begun

MACHINE = load_machine("table-a")
STOCK = Stock((60, 50, 20))
DRILL = Tool(number=2, shape="drill", diameter_mm=5)
CORED = Tool(number=1, shape="flat", diameter_mm=6, core_diameter_mm=2)


def found(program: Program, tool: Tool = CORED):
    return check(program.toolpath(), MACHINE, file="p.nc", stock=STOCK, tools={1: tool, 2: DRILL})


def codes(program: Program, tool: Tool = CORED):
    return [(finding.code, finding.place.line) for finding in found(program, tool)]


@pytest.mark.parametrize("form", [{"shape": "flat"}, {"shape": "ball"}, {"shape": "bullnose", "corner_radius_mm": 1}])
def test_a_mill_with_a_core_must_not_plunge(form):
    cored, whole = (Tool(number=1, diameter_mm=6, core_diameter_mm=core, **form) for core in (2, 0))
    program = begun().feed(0, 0, 1).feed(0, 0, -1, 100).feed(5, 0, -1).rapid(5, 0, 5)
    (finding,) = found(program, cored)
    assert (finding.code, finding.severity, finding.place.line) == ("plunge", "error", 4)
    assert (finding.value, finding.limit, finding.unit) == (90, 10, "deg")
    assert np.hypot(*finding.place_mm[:2]) <= 1
    assert finding.place_mm[2] == -1
    assert found(program, whole) == []


@pytest.mark.parametrize(("angle_deg", "may"), [(3, True), (9.99, True), (10.01, False), (45, False)])
def test_it_goes_down_on_ramps_and_helices_that_are_not_too_steep(angle_deg, may):
    fall = 10 * np.tan(np.radians(angle_deg))
    ramp = begun().feed(0, 0, 0).feed(10, 0, -fall).rapid(10, 0, 5)
    assert codes(ramp) == ([] if may else [("plunge", 4)])
    turn = 2 * np.pi * 2 * np.tan(np.radians(angle_deg))
    helix = begun().rapid(2, 0, 0).arc(ARC_CCW, (2, 0, -turn), (0, 0, 0)).rapid(2, 0, 5)
    assert codes(helix) == ([] if may else [("plunge", 4)])


def test_a_drill_that_clips_the_rim_of_the_stock_with_its_cone():
    reach = 30 + 0.5 * np.tan(np.radians(59))  # so wide is the cone at the stock's top
    for into_mm, touches in ((0.06, True), (-0.01, False)):
        program = begun(tool=2).rapid(reach - into_mm, 40, 5).rapid(reach - into_mm, 40, -0.5)
        program.rapid(reach - into_mm, 0, -0.5).rapid(reach - into_mm, 0, 5)
        assert codes(program) == ([("rapid-in-stock", 5)] if touches else [])


def test_it_does_not_go_down_on_a_steep_arc_that_comes_up_again():
    arc = begun().feed(0, 0, 1).arc(ARC_CW, (0.1, 0, 1), (0.05, 0, -1), plane=ZX).rapid(0, 0, 5)
    assert codes(arc) == [("plunge", 4)]


def drilled_first(x: float, depth: float = -4) -> Program:
    program = Program(tool=2).up_first(5).rapid(0, 0, 5).feed(0, 0, -6, 100).rapid(0, 0, 5).set(spindle="off")
    program.table.event("pause")
    program.set(tool=1, spindle="cw")
    program.table.event("dwell", 3.0)
    return program.rapid(x, 0, 5).feed(x, 0, depth, 100).rapid(x, 0, 5)


def test_it_may_plunge_into_a_hole_drilled_before_but_not_beside_it():
    assert codes(drilled_first(0)) == []
    assert codes(drilled_first(1.4)) == []  # its core of 1 mm is still within the hole of 2.5 mm
    assert codes(drilled_first(1.6)) == [("plunge", 6)]
    assert codes(drilled_first(9)) == [("plunge", 6)]
    assert codes(drilled_first(0, -5.5)) == [("plunge", 6)]  # the point left a cone where the core arrives


def test_a_drill_goes_down_and_not_sideways():
    assert codes(begun(tool=2).feed(0, 0, -3, 100).rapid(0, 0, 5)) == []
    assert codes(begun(tool=2).feed(0, 0, -3, 100).feed(5, 0, -3).rapid(5, 0, 5)) == [("drill-sideways", 4)]


def test_a_tool_says_only_what_it_can_have():
    for bad in (
        {"shape": "drill", "core_diameter_mm": 1},
        {"shape": "flat", "core_diameter_mm": 7},
        {"shape": "flat", "chip_load_max_mm": 0.1},
        {"shape": "flat", "flutes": 2, "chip_load_min_mm": 0.2, "chip_load_max_mm": 0.1},
    ):
        with pytest.raises(ValueError):
            Tool(number=1, diameter_mm=6, **bad)
