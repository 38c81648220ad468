# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds, line numbers, find and replace, and edits of programs with expressions and O-words."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.edit.feed_scaling import scale_feeds
from CNCStepper.gcode.edit.find_replace import replace
from CNCStepper.gcode.edit.line_tokens import tokens_of
from CNCStepper.gcode.edit.renumber import renumber, without_numbers
from CNCStepper.gcode.edit.transform_verbs import convert_units, mirror, offset, rotate, scale
from CNCStepper.gcode.interpreter.interpret import interpret
from helpers.gcode.edit_programs import random_program

PROGRAM = "%\n(top F80)\nG21 G90\nN7 G0 X10 Y5.\n/G1 Z-1 F200\nG1 X20. F800 (edge F800)\ny15 f80.5 ;F80\nM2\n%\n"


@pytest.mark.parametrize("seed", range(30))
def test_feeds_by_factor(seed: int) -> None:
    text = random_program(seed)
    old, new = interpret(text).table(), interpret(scale_feeds(text, 1.25).text).table()
    assert np.array_equal(old.end, new.end)
    assert np.allclose(old.feed * 1.25, new.feed, rtol=1e-12)


def test_feeds_change_no_comment_and_keep_their_form() -> None:
    assert scale_feeds(PROGRAM, 0.5).text == PROGRAM.replace("Z-1 F200", "Z-1 F100").replace(
        "X20. F800", "X20. F400"
    ).replace("f80.5", "f40.25")


def test_a_feed_by_expression_is_put_into_brackets() -> None:
    text = "#1=100\nG21 G90 G1 X1 F#1\nX2 F[#1 + 5]\nM2\n"
    edited = scale_feeds(text, 2.0, "linuxcnc")
    assert edited.text == "#1=100\nG21 G90 G1 X1 F[#1 * 2]\nX2 F[[#1 + 5] * 2]\nM2\n"
    assert interpret(edited.text, dialect="linuxcnc").table().feed.tolist() == [200.0, 210.0]


def test_a_feed_in_a_subroutine_of_another_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "sub.ngc").write_text("o<sub> sub\nG1 X10 F300\no<sub> endsub\nM2\n", encoding="utf-8")
    text = "G21 G90\nG0 X0 Y0\nG1 X1 F200\no<sub> call\nM2\n"
    with pytest.raises(ProgramError, match="another file") as refused:
        scale_feeds(text, 0.5, "linuxcnc", file=str(tmp_path / "main.ngc"))
    place = refused.value.place
    assert place is not None and (Path(place.file).name, place.line, place.column) == ("sub.ngc", 2, 8)


@pytest.mark.parametrize(
    "edit", [lambda *of: offset(of[0], 5, dialect=of[1]), lambda *of: renumber(*of[:1], dialect=of[1])]
)
def test_the_number_of_a_spindle_is_a_word_that_stays(edit) -> None:
    text = "G21 G90\nM3 S1000 $0\nG0 X0 Y0\nM2\n"
    assert "M3 S1000 $0\n" in edit(text, "linuxcnc").text


def test_a_small_feed_keeps_its_digits() -> None:
    text = "G21 G90\nM3 S100\nG95 F0.05\nG1 X1\nM2\n"
    assert "F0.0165\n" in scale_feeds(text, 0.33, "linuxcnc").text
    assert "F0.001969\n" in convert_units(text, "inch", dialect="linuxcnc").text


@pytest.mark.parametrize(
    ("text", "factor", "line"), [("G0 X1\n", 2.0, 1), ("G1 X1 F1\n", 0.0, 0), ("G1 X1 F1\n", 1e-4, 1)]
)
def test_refused_feeds(text: str, factor: float, line: int) -> None:
    with pytest.raises(ProgramError) as refused:
        scale_feeds(text, factor)
    assert (refused.value.place.line if refused.value.place else 0) == line


def test_renumber() -> None:
    made = renumber(PROGRAM, 100, 5).text.splitlines()
    assert made[1] == "(top F80)"
    assert made[2:8] == [
        "N100 G21 G90",
        "N105 G0 X10 Y5.",
        "/N110 G1 Z-1 F200",
        "N115 G1 X20. F800 (edge F800)",
        "N120 y15 f80.5 ;F80",
        "N125 M2",
    ]
    assert without_numbers("\n".join(made) + "\n").text == PROGRAM.replace("N7 ", "")


def test_numbers_that_the_controller_does_not_take() -> None:
    with pytest.raises(ProgramError, match="too many lines"):
        renumber("G21\n" * 50, 9_999_990, 1)


@pytest.mark.parametrize(
    ("find", "new", "options", "old", "made"),
    [
        ("F80", "F9", {"comments": True}, "(top F80)", "(top F9)"),
        ("F800", "F900", {}, "X20. F800 (edge F800)", "X20. F900 (edge F800)"),
        (r"X(\d+)", r"X\g<1>5", {"pattern": True}, "X10 Y5.", "X105 Y5."),
        ("Y", "Y-", {"ignore_case": True}, "y15 f80.5", "Y-15 f80.5"),
    ],
)
def test_replace(find: str, new: str, options: dict, old: str, made: str) -> None:
    text = replace(PROGRAM, find, new, **options).text
    assert old not in text
    assert made in text


def test_a_number_is_found_whole() -> None:
    with pytest.raises(ProgramError, match="not found"):
        replace(PROGRAM, "F80", "F90")  # F800, f80.5 and comments are something else
    with pytest.raises(ProgramError, match="not found"):
        replace("G17 G21\n", "G1", "G0")


def test_what_replacing_breaks_is_refused_at_its_place() -> None:
    with pytest.raises(ProgramError) as refused:
        replace(PROGRAM, "X20.", "X", file="a.nc")
    assert str(refused.value).startswith("a.nc:6:")
    with pytest.raises(ProgramError, match="pattern"):
        replace(PROGRAM, "(", "x", pattern=True)


LOOP = """#31=5 (width)
o100 sub
G1 X[#31*2] Y#32 F100
Y[#32+1]
o100 endsub
G21 G90 G17
G0 X0 Y0 Z5
#32=0
o101 while [#32 LT 3]
  o100 call
  #32=[#32+1]
o101 endwhile
G0 Z9
M2
"""


@pytest.mark.parametrize(
    ("edit", "linear", "shift"),
    [
        (lambda t: offset(t, 2.0, -3.5, dialect="linuxcnc"), (1, 1, 1), (2, -3.5, 0)),
        (lambda t: scale(t, 1.5, dialect="linuxcnc"), (1.5, 1.5, 1.5), (0, 0, 0)),
        (lambda t: mirror(t, "X", dialect="linuxcnc"), (-1, 1, 1), (0, 0, 0)),
        (lambda t: convert_units(t, "inch", dialect="linuxcnc"), (1, 1, 1), (0, 0, 0)),
    ],
)
def test_loops_and_expressions_are_edited_where_they_stand(edit, linear, shift) -> None:
    edited = edit(LOOP)
    old, new = (interpret(text, dialect="linuxcnc").table() for text in (LOOP, edited.text))
    assert np.abs(old.end * linear + shift - new.end).max() < 0.002
    assert edited.text.removeprefix("G20\n").count("\n") == LOOP.count("\n")
    assert "o101 while [#32 LT 3]" in edited.text


def test_an_offset_of_an_expression_as_it_is_written() -> None:
    made = offset(LOOP, 2.0, -3.5, dialect="linuxcnc").text
    assert "G1 X[[#31*2] + 2] Y[#32 + [-3.5]] F100\nY[[#32+1] + [-3.5]]\n" in made


def test_turning_needs_both_coordinates_of_a_line_that_runs_often() -> None:
    with pytest.raises(ProgramError) as refused:
        rotate(LOOP.replace("[#31*2]", "[#31*2+#32]"), 30.0, dialect="linuxcnc")
    assert (refused.value.code, refused.value.place.line) == ("edit-place", 4)


def test_a_line_in_two_modes_is_refused() -> None:
    text = "o1 sub\nX1 Y1\no1 endsub\nG21 G90 G0 X0 Y0 Z0\no1 call\nG91\no1 call\nM2\n"
    with pytest.raises(ProgramError) as refused:
        offset(text, 1.0, dialect="linuxcnc")
    assert (refused.value.code, refused.value.place.line) == ("edit-doubtful", 2)


def test_a_line_that_reads_where_the_machine_stands_is_refused() -> None:
    with pytest.raises(ProgramError) as refused:
        offset("G21 G90 G0 X1\nX[#5420 + 1]\nM2\n", 1.0, dialect="linuxcnc")
    assert (refused.value.code, refused.value.place.line) == ("edit-parameter", 2)


def test_words_where_they_stand() -> None:
    line = "/ N20 G01 x 1 0.5 (to [x]) Y-SIN[#1] #3=[4+#<a b>] Z#2 ;Z9"
    assert [(token.letter, line[token.first : token.last]) for token in tokens_of(line)] == [
        ("N", "20"),
        ("G", "01"),
        ("X", "1 0.5"),
        ("Y", "-SIN[#1]"),
        ("Z", "#2"),
    ]
