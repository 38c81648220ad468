# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe programs whose path is put elsewhere: X as a diameter moves as what it is, and a thread keeps its lead."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.transform_verbs import convert_units, offset, scale
from CNCStepper.gcode.interpreter.interpret import interpret

HEAD = "G21 G18 {} G90 G94\nS1000 M3\nG0 X60 Y0 Z5\n"
PATH = "G0 X50\nG1 X50 Z-40 F200\nG2 X54 Z-42 R2\nG91\nG1 X4 Z-1\nG90\nG0 X60 Z5\nM2\n"
LATHE = {"dialect": "linuxcnc"}


def ends(text: str) -> np.ndarray:
    return interpret(text, None, "linuxcnc").table().end[:, [0, 2]]


def test_an_offset_along_x_is_on_the_radius_whatever_the_words_say() -> None:
    diameter, radius = HEAD.format("G7") + PATH, HEAD.format("G8") + PATH.replace("X54", "X52")
    for text, word in ((diameter, "X54"), (radius, "X52")):
        moved = offset(text, 2.0, 0.0, -5.0, **LATHE)
        assert ends(moved.text) == pytest.approx(ends(text) + np.array([2.0, -5.0]))
        assert f"G0 {word}\n" in moved.text and "G1 X4 Z-1" in moved.text


def test_scale_and_units_keep_a_diameter_a_diameter() -> None:
    text = HEAD.format("G7") + PATH
    doubled = scale(text, 2.0, 2.0, 2.0, **LATHE).text
    assert ends(doubled) == pytest.approx(2 * ends(text)) and "G1 X100 Z-80" in doubled and "G1 X8 Z-2" in doubled
    inch = convert_units(text, "inch", **LATHE).text
    assert ends(inch) == pytest.approx(ends(text), abs=0.01) and "G0 X1.9685" in inch


@pytest.mark.parametrize("factors", [(2.0, 2.0, 2.0), (1.0, 1.0, 2.0)])
def test_a_thread_is_not_scaled_as_its_lead_would_stay(factors) -> None:
    text = HEAD.format("G7") + "G33 X60 Z-20 K1.5\nM2\n"
    with pytest.raises(ProgramError) as refusal:
        scale(text, *factors, **LATHE)
    assert refusal.value.code == "edit-thread" and "K1.5" in str(refusal.value)
    assert "G33 X60 Z-25 K1.5" in offset(text, 0.0, 0.0, -5.0, **LATHE).text
