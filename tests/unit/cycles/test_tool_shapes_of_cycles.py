# SPDX-License-Identifier: LGPL-2.1-or-later
"""The table of shapes that suit a cycle agrees with what the cycles themselves refuse."""

from __future__ import annotations

from typing import Any

import pytest

from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.cycles.cycle import Setup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import circle
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_shapes import SHAPES, SUITED
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder

ROUND = circle((0.0, 0.0), 20.0)
AREA = {"stepdown_mm": 1.0, "stepover_mm": 0.5}
HOLES = {"pattern": {"kind": "points", "points_mm": [(0.0, 0.0)]}}
VALUES: dict[str, dict[str, Any]] = {
    "bore": {**HOLES, "diameter_mm": 9.0, "pitch_mm": 1.0},
    "circular_pocket": {**AREA, "centre_mm": (0.0, 0.0), "radius_mm": 20.0},
    "contour": {"curves": [ROUND], "stepdown_mm": 1.0},
    "drill": HOLES,
    "elliptical_pocket": {**AREA, "centre_mm": (0.0, 0.0), "radius_x_mm": 20.0, "radius_y_mm": 15.0},
    "engrave": {"curves": [ROUND]},
    "face": {**AREA, "outlines": [ROUND]},
    "pocket": {**AREA, "outlines": [ROUND]},
    "rectangular_pocket": {**AREA, "corner_a_mm": (0.0, 0.0), "corner_b_mm": (20.0, 20.0)},
    "thread": {**HOLES, "major_diameter_mm": 9.0, "pitch_mm": 1.0},
}
ALLOWED_ALL_THE_SAME = {("engrave", "drill")}  # a job file may ask for it; the window never presets it


def refused(cycle: str, shape: str) -> bool:
    tool = Tool(number=1, shape=shape, diameter_mm=4.0, feed_mm_min=600, plunge_mm_min=200, spindle_rpm=9000)
    made = cycle_class(cycle).model_validate({"cycle": cycle, "tool": 1, "depth_mm": 1.0, **VALUES[cycle]})
    try:
        made.cut(Setup(tool=tool, clearance_mm=5.0, retract_mm=2.0), TableBuilder(Start()))
    except CycleError as error:
        return error.code == "tool-shape"
    return False


@pytest.mark.parametrize("cycle", SUITED)
def test_a_shape_suits_exactly_where_the_cycle_takes_it(cycle: str) -> None:
    taken = {shape for shape in SHAPES if not refused(cycle, shape)}
    assert taken - {shape for name, shape in ALLOWED_ALL_THE_SAME if name == cycle} == set(SUITED[cycle])
