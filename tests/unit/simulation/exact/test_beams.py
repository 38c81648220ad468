# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jets and wires under check: on rapids, never on, near the edge, and on a table that knows no height."""

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.cycle import Removal
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.checks.program_report import report
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import UNKNOWN
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import Program, begun

SHEET = Stock((60, 50, 3))
MACHINE = load_machine("table-a")
LASER = MACHINE.model_copy(update={"spindle": MACHINE.spindle.model_copy(update={"laser": True})})
each_beam = pytest.mark.parametrize("shape", ["jet", "wire"])


def beam(shape: str = "jet", **more: float) -> Tool:
    return Tool(number=1, shape=shape, diameter_mm=0.8, **more)


def codes(program: Program, tool: Tool | None = None, machine=MACHINE, **more):
    found = check(program.toolpath(), machine, file="p.nc", stock=SHEET, tools=tool or beam(), **more)
    return [(finding.code, finding.place.line) for finding in found if finding.code != "spin-up"]


def two_cuts(between: str) -> Program:
    program = begun(spindle="off").rapid(-20, 0, 1.5).set(spindle="cw").feed(20, 0, 1.5)
    return program.set(spindle=between).rapid(-20, 9, 1.5).set(spindle="cw").feed(20, 9, 1.5)


@each_beam
def test_a_rapid_with_the_beam_on_is_found(shape: str) -> None:
    assert codes(two_cuts("off"), beam(shape)) == []
    assert codes(two_cuts("cw"), beam(shape)) == [("rapid-in-stock", 5)]
    beside = begun(spindle="off").rapid(-40, 30, 1.5).set(spindle="cw").feed(-20, 0, 1.5).feed(-40, 30, 1.5)
    assert codes(beside.rapid(40, 30, 1.5), beam(shape)) == []


def test_a_laser_switches_off_on_rapids_by_itself() -> None:
    assert codes(two_cuts("cw"), machine=LASER) == []


@pytest.mark.parametrize("state", [{"spindle": "off"}, {"spindle_rpm": 0.0}])
def test_a_beam_that_is_never_on_is_found(state: dict) -> None:
    program = begun(**state).rapid(-20, 0, 1.5).feed(20, 0, 1.5)
    assert ("spindle-off", 4) in codes(program)
    assert not height_map(program.toolpath(), beam(), SHEET).removed_volume_mm3


@pytest.mark.parametrize(("y", "near"), [(22.59, False), (22.61, True)])
def test_a_cut_near_the_edge_counts_however_high_the_head_is_held(y: float, near: bool) -> None:
    program = begun(spindle="off").rapid(-20, y, 1.5).set(spindle="cw")
    assert codes(program.feed(20, y, 1.5), edge_mm=2.0) == ([("sheet-edge", 4)] if near else [])


def flat_table() -> Program:
    """Return a half circle that bulges to X 10, on a table that never names a height."""
    program = Program().rapid(0, -10, UNKNOWN)
    return program.arc(ARC_CCW, (0, 10, UNKNOWN), (0, 0, UNKNOWN))


def test_a_table_without_a_height_is_judged_as_any_other() -> None:
    toolpath, ring = flat_table().toolpath(), shapely.Point(0, 0).buffer(10, quad_segs=512).exterior
    right = shapely.box(0, -20, 20, 20).intersection(ring)
    kerf = Removal(right.buffer(0.4, quad_segs=128), 0, -3)
    assert codes(flat_table(), removals=[kerf]) == []
    wide = Removal(right.buffer(0.5, quad_segs=128), 0, -3)
    assert [code for code, _ in codes(flat_table(), removals=[wide])] == ["left-over"]
    volume_mm3 = height_map(toolpath, beam(), SHEET, 0.05).removed_volume_mm3
    assert volume_mm3 == pytest.approx(3 * (np.pi * 10 * 0.8 + np.pi * 0.16), rel=1e-3)
    told = report(toolpath, np.zeros(len(toolpath)), tools=beam())
    assert told["cut_length_mm"] == pytest.approx(np.pi * 10, rel=1e-4)
    assert (told["air_length_mm"], told["pierces"]) == (0, 1)


def test_its_arcs_count_with_their_extremes_and_its_feeds_with_their_rates() -> None:
    program = Program(zero_mm=(-9.9, -200.0, 0.0)).rapid(0, -10, UNKNOWN)
    program.arc(ARC_CCW, (0, 10, UNKNOWN), (0, 0, UNKNOWN), feed_mm_min=6000)
    assert codes(program) == [("travel", 2), ("feed-above-rate", 2), ("feed-above-rate", 2)]


@each_beam
def test_cut_air_and_pierces_are_those_of_the_beam(shape: str) -> None:
    program = two_cuts("off").set(spindle="off").feed(20, 20, 1.5)
    told = report(program.toolpath(), np.zeros(len(program.toolpath())), tools=beam(shape))
    assert told["cut_length_mm"] == pytest.approx(80)
    assert told["air_length_mm"] == pytest.approx(11)
    assert told["pierces"] == 2
