# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judges of edited programs: what an edit may not change, and what it must."""

from __future__ import annotations

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.cutting_passes import Rows, passes_of
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.line_states import Source
from CNCStepper.gcode.edit.path_transforms import mirrored, moved
from CNCStepper.gcode.edit.reverse_passes import require_reversed, reverse
from CNCStepper.gcode.edit.verification import require_same_path, verified
from CNCStepper.gcode.interpreter.interpret import interpret

OLD = (
    "G21 G90 G17 G94 F100\nT1 M6\nM3 S1000\nM8\nG0 X4 Y0 Z5\nG1 Z-1\nG3 I-4\nG2 X0 Y4 I-4 P2\nG1 X9\nM5\nG4 P3\n"
    "M3 S1200\nG1 X19 F200\nG0 Z9\nM2\n"
)
OTHERWISE = [
    ("G3 I-4", "G3 I-5"),
    ("I-4 P2", "I-4 P3"),
    ("M3 S1000", "M4 S1000"),
    ("S1200", "S1201"),
    ("M8", "M7"),
    ("T1", "T2"),
    ("M5\nG4 P3\n", "G4 P3\nM5\n"),
    ("X19 F200", "X19 F201"),
    ("G1 X9", "G0 X9"),
    ("G17", "G17 G64"),
]


@pytest.mark.parametrize(("was", "becomes"), OTHERWISE)
def test_an_edit_that_changes_what_it_should_not_is_refused(was: str, becomes: str) -> None:
    source = Source(OLD, "linuxcnc", None, "a.ngc")
    assert was in OLD
    good, bad = (Edited(OLD, text, tuple(range(1, 16))) for text in (OLD, OLD.replace(was, becomes)))
    assert verified(source, good, moved(0, 0), {}, 0.001) is good
    require_same_path(source.toolpath, interpret(OLD, None, "linuxcnc"), good, "a.ngc")
    with pytest.raises(ProgramError, match=r"^a\.ngc:\d+"):
        verified(source, bad, moved(0, 0), {}, 0.001)
    with pytest.raises(ProgramError, match=r"^a\.ngc"):
        require_same_path(source.toolpath, interpret(bad.text, None, "linuxcnc"), bad, "a.ngc")


def test_a_mirrored_circle_must_lie_about_the_mirrored_centre() -> None:
    old = "G21 G90 G17 F100\nG0 X4 Y0 Z5\nG3 I-4\nM2\n"
    for centre, good in (("I4", True), ("I-4", False)):
        new = old.replace("X4", "X-4").replace("G3 I-4", f"G2 {centre}")
        edited = Edited(old, new, (1, 2, 3, 4))
        source = Source(old, "linuxcnc")
        if good:
            assert verified(source, edited, mirrored("x"), {}, 0.001) is edited
        else:
            with pytest.raises(ProgramError, match="elsewhere"):
                verified(source, edited, mirrored("x"), {}, 0.001)


def test_feeds_must_be_times_the_factor() -> None:
    old, new = (interpret(f"G21 G90\nG1 X1 F{feed}\nM2\n", None, "linuxcnc") for feed in (100, 70))
    edited = Edited("", "", (1, 2, 3))
    require_same_path(old, new, edited, "", 0.7)
    for factor in (1.0, 0.71):
        with pytest.raises(ProgramError, match="other moves"):
            require_same_path(old, new, edited, "", factor)


@pytest.mark.parametrize(
    ("was", "becomes"),
    [
        ("", ""),
        ("G2 X4 Y0 I-4 J0", "G2 X4 Y0 I-4 J0 P2"),
        ("G2 X4 Y0 I-4 J0", "G3 X4 Y0 I-4 J0"),
        ("G0 X20 Y3", "G0 X20 Y2"),
        ("Z9 (up)", "Z8 (up)"),
        ("M5\nG4 P3\n", "G4 P3\nM5\n"),
        ("S1000", "S900"),
    ],
)
def test_passes_that_are_not_the_old_ones_backwards_are_refused(was: str, becomes: str) -> None:
    old = "G21 G90 G17 F100\nM3 S1000\nG0 X4 Y0 Z5\nG1 Z-1\nG3 X4 Y0 I-4\nG1 X20 Y3\nG0 Z9 (up)\nM5\nG4 P3\nX0 Y0\nM2\n"
    made = reverse(old, "linuxcnc").text
    assert was in made, made
    source = Source(old, "linuxcnc")
    rows = Rows(source)
    edited = Edited(old, made.replace(was, becomes), tuple(range(1, 12)))
    if not was:
        require_reversed(source, rows, passes_of(rows), edited)
        return
    with pytest.raises(ProgramError, match="other moves"):
        require_reversed(source, rows, passes_of(rows), edited)
