# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a lathe program gives X as diameter or radius, in each dialect's own codes."""

import pytest

from CNCStepper.gcode.lathe.diameter_mode import has_diameter_code, x_is


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
    ],
)
def test_x_is(text: str, dialect: str, found: str) -> None:
    assert x_is(text, dialect) == found


def test_only_a_lathe_names_the_codes() -> None:
    assert has_diameter_code("G0 X1\nG7", "linuxcnc")
    assert not has_diameter_code("G0 X1 (G7)\nG17 G70", "linuxcnc")
    assert not has_diameter_code("G7", "grbl")
