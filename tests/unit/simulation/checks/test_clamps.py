# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clamps and the sheet's edge: a hundredth into them is found, a hundredth beside them is not."""

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.checks.clamps import Clamp
from CNCStepper.simulation.stock import Cylinder, Stock
from helpers.simulation.programs import FLAT, begun

MACHINE = load_machine("table-a")
STOCK = Stock((60, 50, 20))
CLAMP = Clamp(((20, -5), (30, 5)), 8.0)


def found(program, tool=FLAT, keep_out=(CLAMP,), **more):
    known = {"stock": STOCK} | more
    return check(program.toolpath(), MACHINE, file="p.nc", tools={1: tool}, keep_out=keep_out, **known)


@pytest.mark.parametrize("into_mm", [-0.01, 0.01, 2.0])
def test_a_rapid_beside_a_clamp(into_mm):
    program = begun().rapid(17 + into_mm, 0, 5).rapid(0, 0, 5)
    findings = found(program)
    assert [(f.code, f.severity, f.place.line) for f in findings] == ([("clamp", "error", 3)] if into_mm > 0 else [])
    if findings:
        assert findings[0].value == pytest.approx(into_mm, abs=0.002)
        assert findings[0].limit == 0
        assert findings[0].place_mm[2] == 5


@pytest.mark.parametrize(("z", "hits"), [(8.0, False), (8.01, False), (7.99, True)])
def test_a_rapid_over_a_clamp(z, hits):
    program = begun().rapid(0, 0, 9).rapid(0, 0, z).rapid(40, 0, z).rapid(40, 0, 20)
    assert [(f.code, f.place.line) for f in found(program)] == ([("clamp", 5)] if hits else [])


def test_a_ramp_over_a_clamp_counts_with_its_height_at_each_place():
    over = begun().rapid(0, 0, 20).rapid(30, 0, 9).rapid(40, 0, 9)
    assert found(over) == []
    low = begun().rapid(0, 0, 20).rapid(30, 0, 7).rapid(40, 0, 9)
    assert [(f.code, f.place.line) for f in found(low)] == [("clamp", 4)]


def test_a_polygon_and_a_narrow_tip():
    corner = Clamp(((20, 0), (30, 10), (30, -10)), 2.0)
    v = Tool(number=1, shape="v", diameter_mm=10, tip_angle_deg=90)
    for x, hits in ((18.4, False), (18.6, True)):  # 1.5 mm over its tip it is 1.5 mm wide
        assert bool(found(begun().rapid(x, 0, 0.5).rapid(0, 0, 5), v, (corner,))) is hits


def test_the_holder_keeps_clear_too():
    tool = FLAT.model_copy(update={"length_mm": 10.0, "holder_diameter_mm": 30.0})
    program = begun().rapid(10, 0, -2.5).rapid(10, 0, 5)
    (finding,) = found(program, tool, stock=None)
    assert (finding.code, finding.place.line) == ("clamp", 3)
    assert "holder" in finding.text
    assert finding.value == pytest.approx(5, abs=0.001)


def test_an_unknown_tool_counts_with_its_axis():
    program = begun(tool=9).rapid(19.9, 0, 5).rapid(20.1, 0, 5)
    assert ("clamp", 4) in [(f.code, f.place.line) for f in found(program)]


@pytest.mark.parametrize("corners", [((0, 0),), ((0, 0), (0, 5)), ((0, 0), (5, 5), (5, 0), (0, 5))])
def test_a_clamp_encloses_something(corners):
    with pytest.raises(JobError):
        Clamp(corners, 5)


@pytest.mark.parametrize(("x", "left"), [(24.99, 2.01), (25.0, 2.0), (25.01, 1.99), (28.0, -1.0)])
def test_a_cut_keeps_away_from_the_sheets_edge(x, left):
    program = begun().feed(0, 0, -1).feed(x, 0, -1).rapid(x, 0, 5)
    findings = found(program, edge_mm=2.0, keep_out=())
    assert [(f.code, f.place.line) for f in findings] == ([("sheet-edge", 4)] if left < 2 else [])
    for finding in findings:
        assert (finding.value, finding.limit) == (pytest.approx(left, abs=0.001), 2.0)
    assert found(program, keep_out=(), edge_mm=None) == []


def test_the_edge_of_a_round_sheet_and_cuts_in_the_air():
    round_sheet = Cylinder((60, 60, 5))
    out = 24.9 / np.sqrt(2)
    program = begun().feed(0, 0, -1).feed(out, out, -1).rapid(out, out, 5)
    assert found(program, stock=round_sheet, edge_mm=2.0, keep_out=()) == []
    beyond = begun().rapid(40, 40, 5).feed(40, 40, -1).feed(45, 40, -1).rapid(45, 40, 5)
    assert found(beyond, stock=round_sheet, edge_mm=2.0, keep_out=()) == []
