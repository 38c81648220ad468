# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reversed contours, and programs split at tool changes."""

from __future__ import annotations

from random import Random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.reverse_passes import reverse
from CNCStepper.gcode.edit.split_by_tool import split
from CNCStepper.gcode.interpreter.interpret import interpret

CONTOURS = """G21 G90 G17 G94
M3 S1000
G0 Z5
G0 X10 Y5
G1 Z-1.0 F200
G1 X20. F800 (edge)
(corner)
Y15
G2 X10 Y25 I-10 F400
G0 Z5
X40
G1 Z-1 F200
G91
X10 F600
Y10
G90
G0 Z5
X0 Y0
M5
M2
"""


def test_contours_backwards() -> None:
    assert (
        reverse(CONTOURS).text
        == """G21 G90 G17 G94
M3 S1000
G0 Z5
G0 X10 Y25
G1 Z-1.0 F200
G3 X20 Y15 I0 J-10 F400
G1 Y5 F800
(corner)
X10 (edge)
G0 Z5
X50 Y35
G1 Z-1 F200
G91
Y-10 F600
X-10
G90
G0 Z5
X0 Y0
M5
M2
"""
    )


def contours(seed: int) -> str:
    """Contours of lines and arcs with changing feeds and planes of number, coolant and dwells between them."""
    random = Random(seed)
    lines = ["G21 G90 G17", "M3 S900", "G0 Z5 (up)"]
    for _ in range(random.randint(1, 4)):
        x, y = random.randint(-50, 50), random.randint(-50, 50)
        lines += [f"G0 X{x} Y{y}", *random.choice([[], ["M8", "G4 P0.2"]]), f"G1 Z-{random.randint(1, 3)} F150"]
        relative = random.random() < 0.3
        lines += ["G91"] * relative
        for k in range(random.randint(1, 6)):
            dx, dy = random.choice([(3, 0), (0, 4), (-2, 5), (7.25, -1.5)])
            feed = f" F{random.choice([300, 400])}" if random.random() < 0.4 or k == 0 else ""
            end = f"X{dx:g} Y{dy:g}" if relative else f"X{x + dx:g} Y{y + dy:g}"
            arc = random.random() < 0.4
            word = random.choice(["G2", "G3"]) + f" {end} I{dx / 2:g} J{dy / 2:g}" if arc else f"G1 {end}"
            lines.append(word + feed + random.choice(["", " (so)"]))
            x, y = x + dx, y + dy
        lines += ["G90"] * relative
        lines += ["G0 Z5", *random.choice([[], ["M9"]])]
    return "\n".join([*lines, "G0 X0 Y0", "M5", "M2", ""])


@pytest.mark.parametrize("seed", range(40))
def test_reversed_twice_is_the_same_table(seed: int) -> None:
    text = contours(seed)
    once = reverse(text)
    old, new, back = (interpret(one).table() for one in (text, once.text, reverse(once.text).text))
    assert np.allclose(old.end, back.end, atol=1e-9, equal_nan=True)
    assert np.allclose(old.centre, back.centre, atol=1e-9)
    assert np.array_equal(old.kind, back.kind)
    assert np.array_equal(old.feed, back.feed)
    assert sorted(old.feed.tolist()) == sorted(new.feed.tolist())
    assert not np.allclose(old.end, new.end, equal_nan=True)
    assert [(event.index, event.kind) for event in interpret(text).events if event.kind != "comment"] == [
        (event.index, event.kind) for event in interpret(once.text).events if event.kind != "comment"
    ]


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        (CONTOURS.replace("Y15\n", "Y15 Z-2\n"), "reverse-ramp", 8),
        (CONTOURS.replace("G0 Z5\nX40", "G0 X40"), "reverse-rapid", 10),
        ("G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX5\nZ-2\nX9\nG0 Z5\nM2\n", "reverse-apart", 6),
        ("G21 G90\nG0 X0 Y0 Z5\nM2\n", "reverse-nothing", 1),
        ("G21 G90\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX5\nG91\nX9\nG90\nG0 Z5\nM2\n", "reverse-apart", 6),
    ],
)
def test_unsafe_to_reverse(text: str, code: str, line: int) -> None:
    with pytest.raises(ProgramError) as refused:
        reverse(text)
    assert (refused.value.code, refused.value.place.line) == (code, line)


def test_passes_in_depths_of_a_closed_contour() -> None:
    text = "G21 G90\nM3 S1\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX5\nY5\nX0 Y0\nZ-2\nX5\nY5\nX0 Y0\nG0 Z5\nM5\nM2\n"
    ends = interpret(reverse(text).text).table().end
    assert ends[:, :2].tolist()[1:10] == [[0, 0], [5, 5], [5, 0], [0, 0], [0, 0], [5, 5], [5, 0], [0, 0], [0, 0]]


TWO_TOOLS = """G21 G90 G17 G54 G94
T1
M3 S1000
G0 Z5
G0 X10 Y5
G1 Z-1.0 F200
G1 X20. F800 (edge)
G0 Z15
M5
(MSG, tool 2)
M0
T2
M3 S500
X40
G1 Z-1 F200
Y10
G0 Z15
M5
M2
"""


def test_a_program_for_each_tool() -> None:
    first, second = split(TWO_TOOLS)
    assert (first.number, first.tool, second.number, second.tool) == (1, 1, 2, 2)
    assert first.text == "(program 1 of 2, tool 1)\n" + TWO_TOOLS[: TWO_TOOLS.index("(MSG")] + "M2\n"
    assert second.text == (
        "(program 2 of 2, tool 2)\nG21 G17 G90 G91.1 G94 G54\nG0 Z15\nG0 X20 Y5\nG0 F800\n"
        + TWO_TOOLS[TWO_TOOLS.index("(MSG") :]
    )


def test_m6_and_tape_marks() -> None:
    text = "%\n" + TWO_TOOLS.replace("T1\n", "T1 M6\nT2\n").replace("M0\nT2\n", "M6\n") + "%\n"
    first, second = split(text.replace("M5\n(MSG", "(MSG").replace("G0 Z5\n", "G0 Z5\nM8\n"), "linuxcnc")
    assert first.text.endswith("G0 Z15\nM5\nM9\nM2\n%\n")
    assert second.text.startswith("%\n(program 2 of 2, tool 2)\n")
    assert "\nM8\n(MSG, tool 2)\nT2 M6\n" in second.text
    whole = interpret(text, dialect="linuxcnc").table().end
    parts = [interpret(part.text, dialect="linuxcnc").table().end for part in (first, second)]
    assert np.allclose(np.vstack([parts[0], parts[1][2:]]), whole, equal_nan=True)


@pytest.mark.parametrize("mode", ["G61", "G61.1", "G64 P0.02 Q0.01", "G98", "G99", "M49", "M50 P0", "M51 P0"])
def test_a_later_program_keeps_the_path_and_the_retract_mode(mode: str) -> None:
    first, second = split(TWO_TOOLS.replace("G0 Z5\n", f"G0 Z5\n{mode}\n").replace("T2\n", "T2 M6\n"), "linuxcnc")
    assert mode in first.text.splitlines()
    written = [line.replace("020000", "02").replace("0100", "01") for line in second.text.splitlines()]
    assert mode in written[1:4]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (TWO_TOOLS.replace("T2\n", ""), "split-one"),
        (TWO_TOOLS.replace("G0 Z15\nM5\n(MSG", "G0 Z15\n(MSG"), "split-spindle"),
        (TWO_TOOLS.replace("G0 Z15\nM5\n(MSG", "M5\n(MSG"), "split-height"),
    ],
)
def test_what_cannot_be_split(text: str, code: str) -> None:
    with pytest.raises(ProgramError) as refused:
        split(text)
    assert refused.value.code == code


CIRCLES = """G21 G90 G17
G0 Z5
M3 S900
G0 X10 Y0
G1 Z-1 F100
G1 X20 F300
G3 I5 J2 P2
G1 Y8
G0 Z5
G0 X40 Y0
G1 Z-1 F100
G2 I-3 F300 (a hole alone)
G0 Z5
M2
"""


def test_whole_circles_run_backwards_about_their_own_centres() -> None:
    text = reverse(CIRCLES, "linuxcnc").text
    assert "G0 X20 Y8\n" in text and "G0 X40 Y0\n" in text and "(a hole alone)" in text
    old, new = interpret(CIRCLES, dialect="linuxcnc").table(), interpret(text, dialect="linuxcnc").table()
    circles, turned = old.kind > 1, new.kind > 1
    assert circles.sum() == turned.sum() == 2
    assert np.allclose(old.centre[circles][:, :2], new.centre[turned][:, :2])
    assert np.allclose(old.end[circles][:, :2], new.end[turned][:, :2])
    assert (old.kind[circles] + new.kind[turned] == 5).all() and (old.turns[circles] == new.turns[turned]).all()


def test_a_whole_helix_is_no_way_that_can_be_turned_round() -> None:
    with pytest.raises(ProgramError) as refused:
        reverse(CIRCLES.replace("G1 Z-1 F100\nG2 I-3", "G1 Z0 F100\nG2 I-3 Z-1"), "linuxcnc")
    assert refused.value.code == "reverse-ramp" and refused.value.place.line == 12


def test_a_rapid_that_moves_nothing_leads_to_its_way_all_the_same() -> None:
    text = (
        "G21 G90\nT1 M6\nM3 S1000\nG0 Z5\nG0 X10 Y10\nG1 Z-1 F100\nG1 X20\nY20\nX10 Y10\nG0 Z5\nM5\n"
        "T2 M6\nM3 S500\nG0 X10\nG1 Z-2\nX40\nY30\nG0 Z5\nM2\n"
    )
    edited = reverse(text, "linuxcnc")
    assert edited.text.splitlines()[13:17] == ["G0 X40 Y30", "G1 Z-2", "Y10", "X10"]
    back = interpret(reverse(edited.text, "linuxcnc").text, dialect="linuxcnc").table()
    assert np.array_equal(back.end, interpret(text, dialect="linuxcnc").table().end, equal_nan=True)
    with pytest.raises(ProgramError, match="not above all cuts"):
        reverse(text.replace("G0 Z5\nM5\nT2 M6\nM3 S500\n", ""), "linuxcnc")
