# SPDX-License-Identifier: LGPL-2.1-or-later
"""What G61, G61.1 and G64 leave in the table: the mode, and how far corners may be cut, in mm."""

import pytest

from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start


def state_of(*lines):
    """Return the path mode and its tolerance in the state of the last move."""
    reader = Interpreter(Start.at_zero(), "linuxcnc")
    for line in [*lines, "G1 X1 F100", "M2"]:
        reader.line(line)
    toolpath = reader.toolpath()
    state = toolpath.states[int(toolpath.table().state[-1])]
    return state.path_mode, state.blend_mm


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["G21 G61"], ("exact_path", 0.0)),
        (["G21 G61.1"], ("exact_stop", 0.0)),
        (["G21 G64"], ("blend", 0.0)),
        (["G21 G64 P0.05"], ("blend", 0.05)),
        (["G20", "G64 P0.01"], ("blend", 0.254)),
        (["G20 G64 P0.01"], ("blend", 0.254)),
        (["G21 G64 P0.05", "G64"], ("blend", 0.0)),
        (["G21 G64 P0.05", "G61"], ("exact_path", 0.0)),
        (["G21 G64 P-1"], ("blend", 0.0)),
    ],
)
def test_the_path_mode_of_a_program(lines, expected):
    mode, blend_mm = state_of(*lines)
    assert (mode, round(blend_mm, 9)) == expected
