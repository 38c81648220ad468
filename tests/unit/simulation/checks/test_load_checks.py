# SPDX-License-Identifier: LGPL-2.1-or-later
"""What loads the tool along the path, against geometry worked out by hand."""

import numpy as np
import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.removal.engagement import engagement
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW
from helpers.simulation.programs import FLAT, begun, square_pocket

MACHINE = load_machine("table-a")
STOCK = Stock((60, 50, 20))


def tool(**more) -> Tool:
    return Tool(**{"number": 1, "shape": "flat", "diameter_mm": 6.0} | more)


def found(program, cutter: Tool):
    return check(program.toolpath(), MACHINE, file="p.nc", stock=STOCK, tools={1: cutter})


def codes(program, cutter: Tool):
    return [(finding.code, finding.place.line) for finding in found(program, cutter)]


def side(ae_mm: float, z: float = -2.0):
    """A cut along the stock's side, `ae_mm` wide."""
    y = -25 - 3 + ae_mm
    return begun().rapid(-40, y, 5).rapid(-40, y, z).feed(40, y, z).rapid(40, y, 5)


@pytest.mark.parametrize("ae_mm", [0.2, 1.0, 3.0, 4.5])
def test_the_engagement_angle_of_a_side_cut(ae_mm):
    met = engagement(side(ae_mm).toolpath(), FLAT, STOCK)
    amid = np.abs(met.place_mm[:, 0]) < 25
    angle = np.degrees(np.arccos(1 - ae_mm / 3))
    assert np.median(met.angle_deg[amid]) == pytest.approx(angle, abs=15)
    assert met.angle_deg[amid].max() < angle + 15
    if ae_mm > 0.3:  # less is within the outermost cells
        assert met.uncut_mm[amid].max() == pytest.approx(2, abs=1e-6)


def test_a_slot_takes_the_whole_front_also_on_an_arc_and_nothing_the_second_time():
    slot = begun().feed(0, 0, -1, 200).feed(20, 0, -1).feed(0, 0, -1)
    met = engagement(slot.toolpath(), FLAT, STOCK)
    there, back = met.row == 3, met.row == 4
    assert met.angle_deg[there][4:].min() == 180
    assert met.angle_deg[back][4:].max() == 0
    ring = begun().feed(10, 0, -1, 200).arc(ARC_CCW, (10, 0, -1), (0, 0, -1)).arc(ARC_CCW, (10, 0, -1), (0, 0, -1))
    met = engagement(ring.toolpath(), FLAT, STOCK)
    assert np.median(met.angle_deg[met.row == 3]) == pytest.approx(180, abs=10)
    assert np.median(met.angle_deg[met.row == 4]) == 0


def test_a_full_slot_is_warned_of_with_value_and_limit():
    cutter = tool(engagement_max_deg=120)
    (finding,) = found(begun().feed(0, 0, -1, 200).feed(20, 0, -1).rapid(20, 0, 5), cutter)
    assert (finding.code, finding.severity, finding.place.line) == ("engagement", "warning", 4)
    assert (finding.value, finding.limit, finding.unit) == (180, 120, "deg")
    assert codes(side(3.0), cutter) == []


def test_flutes_too_short_for_the_cut_and_a_shank_that_rubs():
    cutter = tool(flute_length_mm=5)
    deep = begun().feed(0, 0, -5.1, 200).feed(20, 0, -5.1).rapid(20, 0, 5)
    (finding,) = found(deep, cutter)
    assert (finding.code, finding.severity, finding.count) == ("flute-length", "error", 2)
    assert (finding.value, finding.limit) == (pytest.approx(5.1), 5)
    assert codes(begun().feed(0, 0, -5, 200).feed(20, 0, -5).rapid(20, 0, 5), cutter) == []
    levels = begun().feed(0, 0, -3, 200).feed(20, 0, -3).feed(0, 0, -3).feed(0, 0, -6).feed(20, 0, -6)
    (finding,) = found(levels.rapid(20, 0, 5), cutter)
    assert (finding.code, finding.severity) == ("shank", "warning")
    assert finding.value == pytest.approx(6)
    assert finding.place.line in (6, 7)
    assert codes(side(1.0, -5.1), cutter) == [("flute-length", 5)]


def test_the_holder_goes_into_stock_where_the_pocket_is_narrower():
    long, short = (tool(length_mm=length, holder_diameter_mm=30) for length in (10, 3.5))
    pocket = square_pocket(half_mm=20)
    assert codes(pocket, long) == []
    (finding,) = found(pocket, short)
    assert (finding.code, finding.severity) == ("holder", "error")
    assert (finding.value, finding.limit) == (pytest.approx(4), 3.5)
    row = int(np.flatnonzero(pocket.toolpath().table().line == finding.place.line)[0])
    assert pocket.toolpath().table().end[row, 2] + 40 == pytest.approx(-4)


def test_chips_too_thick_and_too_thin():
    cutter = tool(flutes=2, chip_load_min_mm=0.01, chip_load_max_mm=0.05)  # 10 000 rpm: 200 to 1000 mm/min

    def slot(feed):
        return begun().feed(0, 0, -1, 100).feed(20, 0, -1, feed).rapid(20, 0, 5)

    assert codes(slot(1000), cutter) == codes(slot(200), cutter) == []
    (thick,) = found(slot(1100), cutter)
    assert (thick.code, thick.severity, thick.place.line) == ("chip-load", "warning", 4)
    assert (thick.value, thick.limit, thick.unit) == (pytest.approx(0.055), 0.05, "mm")
    (thin,) = found(slot(190), cutter)
    assert (thin.code, thin.place.line, thin.value, thin.limit) == ("chip-load", 4, pytest.approx(0.0095), 0.01)
    narrow = begun().rapid(-40, -27.9, 5).rapid(-40, -27.9, -2).feed(40, -27.9, -2, 1500).rapid(40, 0, 5)
    assert codes(narrow, cutter) == []  # 0.1 mm wide: the chip is thinner than the way of a tooth


def test_a_v_meets_as_much_as_its_cone_is_wide_there():
    v = tool(shape="v", tip_angle_deg=90, engagement_max_deg=100)
    (finding,) = found(begun().feed(0, 0, -2, 200).feed(20, 0, -2).rapid(20, 0, 5), v)
    assert (finding.code, finding.value) == ("engagement", 180)
    assert codes(begun().rapid(-40, -26, 5).rapid(-40, -26, -2).feed(40, -26, -2).rapid(40, 0, 5), v) == []


def test_a_tool_that_says_nothing_is_not_followed():
    assert codes(begun().feed(0, 0, -15, 200).feed(20, 0, -15).rapid(20, 0, 5), tool()) == []


def test_a_tool_too_small_for_the_map_is_told():
    tiny = tool(diameter_mm=0.1, engagement_max_deg=90)
    program = begun().rapid(-25, -20, 5).feed(-25, -20, -0.1, 100).feed(25, 20, -0.1).rapid(0, 0, 5)
    assert [(f.code, f.severity) for f in found(program, tiny)] == [("engagement-unknown", "info")]
