# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs whose lines are not run in their order: subroutines, branches, loops, and the limits that hold them."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
from click.testing import CliRunner

from CNCStepper.cli.program.trace import command as trace
from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.fast_path import policy
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import Limits, run
from CNCStepper.gcode.interpreter.flow.subprogram_files import Library
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start

ZERO = Start.at_zero()
TWICE = "o<twice> sub\nG0 X#1\nG0 Y#1\no<twice> endsub\nM2\n"


def xs(text: str, **more) -> list[float]:
    return interpret(text, ZERO, "linuxcnc", **more).table().end[:, 0].tolist()


def refusal(text: str, **more) -> ProgramError:
    with pytest.raises(ProgramError) as caught:
        interpret(text, ZERO, "linuxcnc", **more)
    return caught.value


def test_the_lines_of_the_table_are_those_of_the_text():
    text = "o1 repeat [2]\nG91 G0 X1\no1 endrepeat\no<a> call\nM2\no<a> sub\nG0 X1\no<a> endsub"
    table = interpret(text, ZERO, "linuxcnc").table()
    assert table.line.tolist() == [2, 2, 7]


def test_what_a_subroutine_in_another_file_does_stands_at_its_call(tmp_path):
    (tmp_path / "twice.ngc").write_text(TWICE, "ascii")
    table = interpret("G0 X1\no<twice> call [5]\nG0 X2\nM2", ZERO, "linuxcnc", str(tmp_path / "main.ngc")).table()
    assert table.line.tolist() == [1, 2, 2, 3]
    assert table.end[:, :2].tolist() == [[1, 0], [5, 0], [5, 5], [2, 5]]


def test_an_error_in_a_subroutine_names_its_file(tmp_path):
    (tmp_path / "wrong.ngc").write_text("o<wrong> sub\nG0 X1\nG1 X[1/0] F9\no<wrong> endsub\n", "ascii")
    error = refusal("G0 X1\no<wrong> call\nM2", file=str(tmp_path / "main.ngc"))
    place = error.place
    assert (place.file, place.line, place.column) == (str(tmp_path / "wrong.ngc"), 3, 5)


def test_a_search_path_is_looked_through_after_the_folder_of_the_program(tmp_path):
    beside, library = tmp_path / "programs", tmp_path / "a library ç"
    beside.mkdir()
    library.mkdir()
    (library / "twice.ngc").write_text(TWICE, "ascii")
    (library / "once.ngc").write_text("o<once> sub\nG0 X100\no<once> endsub\n", "ascii")
    (beside / "once.ngc").write_text("o<once> sub\nG0 X7\no<once> endsub\n", "ascii")
    text = "o<twice> call [3]\no<once> call\nM2"
    start = replace(ZERO, search=(str(library),))
    assert interpret(text, start, "linuxcnc", str(beside / "main.ngc")).table().end[:, 0].tolist() == [3, 3, 7]


@pytest.mark.parametrize("name", ["../twice", "/etc/passwd", ".hidden", "c:twice", "a" * 150, "twice.ngc"])
def test_only_files_of_the_folders_are_read(name, tmp_path):
    (tmp_path / "twice.ngc").write_text(TWICE, "ascii")
    folder = tmp_path / "inner"
    folder.mkdir()
    (folder / ".hidden.ngc").write_text("o<.hidden> sub\no<.hidden> endsub\n", "ascii")
    assert refusal(f"o<{name}> call\nM2", file=str(folder / "main.ngc")).code == "no-subroutine"


def test_a_file_may_not_be_too_large(tmp_path):
    (tmp_path / "big.ngc").write_text("o<big> sub\n" + "G0 X1\n" * 100 + "o<big> endsub\n", "ascii")
    reader = Interpreter(ZERO, "linuxcnc")
    with pytest.raises(ProgramError) as caught:
        list(run(reader, "o<big> call\nM2", Library((tmp_path,), largest_bytes=500)))
    assert (caught.value.code, caught.value.limit, caught.value.place.line) == ("input-large", "0.0005 MB", 1)


def test_endless_programs_stop_at_the_limit():
    reader = Interpreter(ZERO, "linuxcnc")
    with pytest.raises(ProgramError) as caught:
        list(run(reader, "o1 while [1]\nG91 G0 X1\no1 endwhile\nM2", limits=Limits(lines=1000)))
    assert caught.value.code == "endless"
    assert caught.value.place.line in (1, 2, 3)
    assert reader.table.index in range(330, 336)


def test_recursion_stops_at_the_limit():
    text = "o<deep> sub\n#<n>=#1\no1 if [#<n> GT 0]\no<deep> call [#<n> - 1]\no1 endif\nG91 G0 X1\no<deep> endsub\n"
    assert len(xs(text + "o<deep> call [8]\nM2")) == 9
    assert refusal(text + "o<deep> call [9]\nM2").code == "too-many-calls"
    with pytest.raises(ProgramError) as caught:
        list(run(Interpreter(ZERO, "linuxcnc"), text + "o<deep> call [3]\nM2", limits=Limits(calls=3)))
    assert (caught.value.code, caught.value.limit) == ("too-many-calls", "3")


def test_arguments_are_local_and_values_come_back():
    text = (
        "#1=9 #2=8\no<f> sub\n#<mine>=[#1 + #2 + #3]\no<f> endsub [#<mine>]\n"
        "o<f> call [1] [2]\nG0 X#<_value> Y#1 Z#2\nG0 X[EXISTS[#<mine>]]\nM2"
    )
    assert interpret(text, ZERO, "linuxcnc").table().end[:, :3].tolist() == [[3, 9, 8], [0, 9, 8]]


def test_a_subprogram_of_fanuc_s_form_shares_the_parameters():
    text = "#1=2\nM98 P10 L3\nG0 X#1\nM2\nO10\n#1=[#1 * 2]\nM99"
    assert xs(text) == [16]


def test_a_line_of_its_own_has_no_flow():
    reader = Interpreter(ZERO, "linuxcnc")
    for line in ("o1 if [1]", "M98 P5"):
        with pytest.raises(ProgramError) as caught:
            reader.line(line)
        assert caught.value.code == "not-supported"


def test_a_skipped_line_is_not_read_but_its_comments_must_close():
    assert xs("o1 if [0]\nwhat ever ? X[[\no1 endif\nG0 X1\nM2") == [1]
    assert refusal("o1 if [0]\nG0 (open\no1 endif\nM2").place.line == 2


def test_m73_brings_modes_back_at_the_end_of_a_subroutine():
    text = "o1 sub\nM73\nG91 G20\nG0 X1\no1 endsub\nG21 G90\no1 call\nG0 X1\nM2"
    assert xs(text) == [25.4, 1]


def test_messages_speak_of_values():
    path = interpret("#1=2.5 #<a b>=3\n(DEBUG, x is #1, %d#<ab>)\n(MSG, #1 stays)\nM2", ZERO, "linuxcnc")
    texts = [event.text for event in path.events if event.kind == "message"]
    assert texts == ["x is 2.500000, 3", "#1 stays"]


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("G0 X1\nG1 Y2 F3 (o1 if [#1])\n; #1=2", True),
        ("(MSG, o)\nN10 G0 X1", True),
        ("G0 X#1", False),
        ("G0 X[1]", False),
        ("G0 X1\nN10 o1 call", False),
        ("\n /O1", False),
        ("M98 P1", False),
        ("M99", False),
        ("(DEBUG, #1)", False),
        ("(a comment) O1 (and another)", False),
    ],
)
def test_plain_programs_are_told_apart(text, plain, monkeypatch):
    assert is_plain(text) == plain
    monkeypatch.setattr(policy, "PAYS", 0)
    monkeypatch.setattr(policy, "PAYS_WITH_LOADING", 0)
    assert is_plain(text) == plain


@pytest.mark.parametrize("seed", range(4))
def test_the_kernel_tells_plain_programs_apart_as_the_pattern_does(seed, monkeypatch):
    chance = random.Random(seed)
    texts = ["".join(chance.choices(" \t/NnOoMm9809.+X(();#[\r\n\n", k=chance.randrange(12))) for _ in range(3000)]
    expected = [is_plain(text) for text in texts]
    assert 500 < sum(expected) < 2500
    monkeypatch.setattr(policy, "PAYS", 0)
    monkeypatch.setattr(policy, "PAYS_WITH_LOADING", 0)
    for text, plain in zip(texts, expected, strict=True):
        assert is_plain(text) == plain, f"seed {seed}: {text!r}"


def test_the_verb_trace_finds_subroutines_beside_the_program_and_where_it_is_told(tmp_path):
    library = tmp_path / "library"
    library.mkdir()
    (library / "twice.ngc").write_text(TWICE, "ascii")
    (tmp_path / "main.ngc").write_text("o<twice> call [5]\nM2\n", "ascii")
    program = str(tmp_path / "main.ngc")
    refused = CliRunner().invoke(trace, [program])
    assert isinstance(refused.exception, ProgramError) and refused.exception.code == "no-subroutine"
    found = CliRunner().invoke(trace, [program, "--search", str(library)])
    assert "STRAIGHT_TRAVERSE(5.0000, 5.0000, 0.0000, 0.0000, 0.0000, 0.0000)" in found.output
