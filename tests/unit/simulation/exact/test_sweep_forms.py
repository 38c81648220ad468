# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge with every form of cutter, against faults of known size: good to 0.001 mm."""

import numpy as np
import pytest
import shapely
from shapely import affinity

from CNCStepper.cycles.cycle import Removal
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.swept_area import judge
from CNCStepper.simulation.stock import Stock
from helpers.simulation.programs import begun

MACHINE = load_machine("table-a")
STOCK = Stock((60, 50, 20))
TOOLS = {
    "flat": Tool(number=1, shape="flat", diameter_mm=6),
    "ball": Tool(number=1, shape="ball", diameter_mm=6),
    "bullnose": Tool(number=1, shape="bullnose", diameter_mm=6, corner_radius_mm=1),
    "v": Tool(number=1, shape="v", diameter_mm=6, tip_angle_deg=60),
    "blunt v": Tool(number=1, shape="v", diameter_mm=8, tip_angle_deg=90, tip_diameter_mm=1),
    "engraver": Tool(number=1, shape="engraver", diameter_mm=3, tip_angle_deg=30, tip_diameter_mm=0.2),
    "drill": Tool(number=1, shape="drill", diameter_mm=6),
    "jet": Tool(number=1, shape="jet", diameter_mm=1),
    "tapered jet": Tool(number=1, shape="jet", diameter_mm=2, taper_deg=1),
}
GROOVE = shapely.box(-3, -30, 3, 30)
slow = pytest.mark.slow
every_tool = pytest.mark.parametrize("name", TOOLS)
solid_tool = pytest.mark.parametrize("name", [name for name in TOOLS if "jet" not in name])


def along(x: float, z: float):
    return begun().rapid(x, -10, 5).feed(x, -10, z, 200).feed(x, 10, z).rapid(x, 10, 5)


def judged(program, removal, tool):
    return judge(program.toolpath(), tool, [removal], STOCK)


def profile(tool):
    """Return height over the tip and radius of many points on the tool's side."""
    cutter = Cutter(form_of(tool))
    height = np.linspace(0.0, cutter.rise_mm, 200_001)
    return height, cutter.radius_at(height)


def entry_mm(tool, z, wall, floor):
    """Return how deep the tool enters stock beside a wall that its axis is `wall` away from, over a floor."""
    height, radius = profile(tool)
    z = z + height
    depth = np.minimum(-z, np.hypot(np.maximum(radius - wall, 0.0), np.maximum(floor - z, 0.0)))
    return max(depth.max(), 0.0)


@solid_tool
@pytest.mark.parametrize(("x", "z"), [(0.0, -2.0), (0.02, -2.0), (1.4, -2.0), (2.5, -0.7), (-2.9, -1.0), (1.0, -4.02)])
def test_a_gouge_into_a_groove_is_that_of_the_profile(name, x, z):
    tool = TOOLS[name]
    verdict = judged(along(x, z), Removal(GROOVE, 0, -4), tool)
    assert verdict.gouge_mm == pytest.approx(entry_mm(tool, z, 3 - abs(x), -4), abs=0.001)
    if verdict.gouge_mm > 0.001:
        place = np.array(verdict.gouge.place_mm)
        assert np.sign(place[0]) == (np.sign(x) or np.sign(place[0]))
        assert verdict.gouge.row in (3, 4)  # where it stands or goes at that depth


@solid_tool
def test_the_strip_between_two_passes_is_as_thick_as_the_profile_leaves_it(name):
    tool, spacing, z = TOOLS[name], 1.5, -2.0
    program = begun()
    for x in np.arange(-3, 3.1, spacing):
        program.rapid(x, -20, 5).feed(x, -20, z, 200).feed(x, 20, z).rapid(x, 20, 5)
    strip = Removal(shapely.box(-3, -10, 3, 10), 0, z)
    height, radius = profile(tool)
    middle = spacing / 2 - radius  # from the point on the floor between two passes to the profile
    expected = np.hypot(np.maximum(middle, 0.0), height).min()
    assert judged(program, strip, tool).left_over_mm == pytest.approx(expected, abs=0.001)


@solid_tool
def test_the_corner_between_floor_and_wall_stays_as_the_profile_leaves_it(name):
    tool, z = TOOLS[name], -2.0
    half = tool.radius_mm + 0.5
    strip = Removal(shapely.box(-half, -10, half, 10), 0, z)
    program = begun()
    for x in np.arange(-0.5, 0.51, 0.25):
        program.rapid(x, -20, 5).feed(x, -20, z, 200).feed(x, 20, z).rapid(x, 20, 5)
    height, radius = profile(tool)
    expected = min(np.hypot(half - 0.5 - radius, height).min(), -z)  # no more than there is to remove
    assert judged(program, strip, tool).left_over_mm == pytest.approx(expected, abs=0.001)


@pytest.mark.parametrize("fault_mm", [0.0, 0.02, 0.2])
def test_a_v_in_a_ramp_counts_with_the_height_at_each_place(fault_mm):
    """It falls along a groove as wide as itself at the lower end: nothing is cut but by the fault."""
    tool = TOOLS["v"]
    half = 2 / np.sqrt(3)  # its radius 2 mm over the tip
    groove = shapely.box(-half, -30, half, 30)
    program = begun().rapid(fault_mm, -10, 5).rapid(fault_mm, -10, 0).feed(fault_mm, 10, -2).rapid(fault_mm, 10, 5)
    verdict = judged(program, Removal(groove, 0, -3), tool)
    assert verdict.gouge_mm == pytest.approx(entry_mm(tool, -2.0, half - fault_mm, -3), abs=0.001)


@pytest.mark.parametrize(
    ("name", "low", "high"), [("jet", 1.0, 1.0), ("tapered jet", 2 * (1 - 20 * np.tan(np.pi / 180)), 2)]
)
def test_a_beam_cuts_through_the_sheet_from_any_height_but_not_when_off(name, low, high):
    tool = TOOLS[name]
    program = begun(spindle="off", spindle_rpm=0).rapid(0, -10, 1).feed(0, -8, 1).set(spindle="cw", spindle_rpm=1000)
    program.feed(0, 8, 1).set(spindle="off", spindle_rpm=0).feed(0, 12, 1)
    kerf = shapely.LineString([(0, -8), (0, 8)])
    wide = judged(program, Removal(kerf.buffer(high / 2, quad_segs=128), 0, -20), tool)
    assert wide.gouge_mm < 0.001
    assert wide.left_over_mm == pytest.approx((high - low) / 2 * np.cos(np.radians(tool.taper_deg or 0)), abs=0.001)
    narrow = judged(program, Removal(kerf.buffer(high / 2 - 0.02, quad_segs=128), 0, -20), tool)
    assert narrow.gouge_mm == pytest.approx(0.02, abs=0.001)


@every_tool
def test_no_form_that_is_given_is_taken_as_another(name):
    program = along(0, -1)
    found = check(program.toolpath(), MACHINE, stock=STOCK, tools={1: TOOLS[name]})
    assert "tool-shape" not in [finding.code for finding in found]


@pytest.mark.parametrize("shape", ["bullnose", "v", "engraver"])
def test_a_form_that_is_not_given_is_said_to_be_judged_as_a_flat(shape):
    found = check(along(0, -1).toolpath(), MACHINE, stock=STOCK, tools=Tool(number=1, shape=shape, diameter_mm=6))
    assert [finding.code for finding in found] == ["tool-shape"]
    assert "_mm" in found[0].advice or "_deg" in found[0].advice


@solid_tool
@pytest.mark.parametrize("turn_deg", [pytest.param(0, marks=slow), 25, pytest.param(70, marks=slow)])
@pytest.mark.parametrize(
    ("off", "z"), [(0.5, -3.0), pytest.param(0.2, -2.0, marks=slow), pytest.param(-0.3, -2.5, marks=slow)]
)
def test_a_corner_of_the_part_is_entered_by_the_deepest_point_of_the_whole_face(name, turn_deg, off, z):
    """Beside a convex corner the deepest point is not on the disc that a straight wall would meet first."""
    tool = TOOLS[name]
    turn = np.radians(turn_deg)
    corner = affinity.rotate(shapely.box(0, 0, 60, 60), turn_deg, (0, 0))
    removal = Removal(shapely.box(-20, -20, 20, 20).difference(corner), 0, -3)
    there = -off * np.array([np.cos(turn + np.pi / 4), np.sin(turn + np.pi / 4)])
    program = begun().rapid(*20 * there / abs(off) * np.sign(off), 5).feed(*there, z).rapid(*there, 5)
    height, radius = profile(tool)
    height, radius = height[::400], radius[::400]
    angle = np.linspace(0, 2 * np.pi, 1441)
    place = np.array([np.outer(radius, np.cos(angle)), np.outer(radius, np.sin(angle))])
    place = np.tensordot([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]], place, axes=1)
    beyond = np.maximum(np.minimum(*(place - off * np.sqrt(0.5))), 0.0)
    level = (z + height)[:, None]
    expected = np.minimum(-level, np.hypot(beyond, np.maximum(-3 - level, 0.0))).max()
    assert judged(program, removal, tool).gouge_mm == pytest.approx(max(expected, 0.0), abs=0.003)  # of the brute force
