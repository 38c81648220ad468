# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a lathe program gives X as diameter or radius, in each dialect's own codes."""

import pytest

from CNCStepper.gcode.lathe.diameter_mode import is_lathe_program, x_is


@pytest.mark.parametrize(
    ("text", "dialect", "found"),
    [
        ("G7\nG0 X10", "linuxcnc", "diameter"),
        ("G8\nG0 X10", "linuxcnc", "radius"),
        ("G0 X10", "linuxcnc", "radius"),
        ("g07 x1\n(G8 X2)", "linuxcnc", "diameter"),
        ("G7\nX1\nG8\nX2", "linuxcnc", "both"),
        ("G8\nG7\nX2", "linuxcnc", "diameter"),
        ("N10 G20 # N20 G00 X-10. #", "mini-lathe", "radius"),
        ("N10 G21 # N20 G00 X-10. #", "mini-lathe", "diameter"),
        ("N10 G20 # N20 G00 X-10. #", "mini-lathe:g20=diameter", "diameter"),
        ("G7 X1", "grbl", "radius"),
        ("G0 X1.", "fanuc-lathe", "diameter"),
        ("G0 X1.", "fanuc-lathe:x=radius", "radius"),
        ("G0 X1", "mach-turn", "diameter"),
        ("G0 X1", "mach-turn:x=radius", "radius"),
    ],
)
def test_x_is(text: str, dialect: str, found: str) -> None:
    assert x_is(text, dialect) == found


def test_only_a_lathe_names_the_codes() -> None:
    assert is_lathe_program("G0 X1\nG7", "linuxcnc")
    assert not is_lathe_program("G0 X1 (G7)\nG17 G70", "linuxcnc")
    assert not is_lathe_program("G7", "grbl")
    assert is_lathe_program("G0 X1.", "fanuc-lathe") and is_lathe_program("", "mach-turn:x=radius")
