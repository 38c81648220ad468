# SPDX-License-Identifier: LGPL-2.1-or-later
"""Expressions and parameters, by hand and against LinuxCNC's own interpreter."""

from __future__ import annotations

from random import Random

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.interpreter_state import model_at
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters
from CNCStepper.gcode.syntax.expressions import Scanner
from CNCStepper.gcode.syntax.words import pack
from CNCStepper.state import Start
from helpers.gcode.rs274_runs import rs274_calls, run_rs274, same_call

ZERO = Start.at_zero()
VALUES = {
    "[2 + 3 * 4]": 14,
    "[2 - 3 * 4 / 5]": -0.4,
    "[10 - 4 - 3]": 3,
    "[2 ** 3 ** 2]": 64,  # from left to right, as all operators of one strength
    "[-2 ** 2]": 4,  # the sign belongs to the number
    "[9 + 8 * 7 / 6 + 5 - 4 * 3 ** 2 + 1]": 9 + 8 * 7 / 6 + 5 - 36 + 1,
    "[7 MOD -4]": 3,
    "[-7 MOD 4]": 1,
    "[1 + 1 EQ 2 AND 3 LT 4]": 1,
    "[1 EQ 1.00005]": 1,
    "[1 NE 1.00011]": 1,
    "[1 GE 1.00005]": 0,
    "[2 OR 0]": 1,
    "[2 XOR 3]": 0,
    "SIN[30]": 0.5,
    "ATAN[1]/[-1]": 135,
    "ATAN[-1]/[0]": -90,
    "ROUND[-2.5]": -3,
    "FIX[-2.1]": -3,
    "FUP[-2.9]": -2,
    "- - 3": 3,
    "-[2]": -2,
    "+SQRT[16]": 4,
    "[[[[1]]]]": 1,
    "EXISTS[#<nothing>]": 0,
    "EXISTS[#5601]": 1,
}


def value(text: str) -> float:
    scanner = Scanner(*pack(text), SystemParameters(model_at(ZERO, dialect("linuxcnc")), 1))
    result = scanner.value()
    assert scanner.ended
    return result


@pytest.mark.parametrize("text", VALUES)
def test_a_value_is_what_rs274_makes_of_it(text):
    assert value(text) == pytest.approx(VALUES[text], abs=1e-12)


def test_rs274_makes_the_same_of_these_values(tmp_path):
    texts = [text for text in VALUES if "#" not in text]
    program = "".join(f"#1={text}\n(DEBUG,#1)\n" for text in texts) + "M2\n"
    theirs, accepted = rs274_calls(program, tmp_path)
    assert accepted
    said = [float(call.split('"')[1]) for call in theirs if "MESSAGE" in call]
    assert said == pytest.approx([VALUES[text] for text in texts], abs=1e-6)


def random_value(random: Random, depth: int) -> str:
    kind = random.random()
    if depth == 0 or kind < 0.25:
        return random.choice([f"{random.uniform(-9, 9):.3f}", str(random.randint(0, 9)), "#2", "#3", "#<a>", "##4"])
    inner = [random_value(random, depth - 1) for _ in range(random.randint(2, 4))]
    if kind < 0.4:
        name = random.choice(["ABS", "COS", "EXP", "FIX", "FUP", "ROUND", "SIN", "TAN", "SQRT", "LN", "ACOS", "ASIN"])
        return f"{name}[{inner[0]}]"
    if kind < 0.45:
        return f"ATAN[{inner[0]}]/[{inner[1]}]"
    operators = ["+", "-", "*", "/", "**", "MOD", "EQ", "NE", "GT", "GE", "LT", "LE", "AND", "OR", "XOR"]
    return "[" + "".join(f"{part} {random.choice(operators)} " for part in inner[1:]) + inner[0] + "]"


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in range(2, 6))])
def test_random_expressions_have_the_values_of_rs274(seed, tmp_path):
    random = Random(seed)
    head = "#2=1.25 #3=-7 #4=3 #<a>=0.5\n"
    lines: list[str] = []
    while len(lines) < 150:
        text = random_value(random, 3)
        try:
            read = float(interpret(f"{head}#1={text}\nG0 X#1\nM2", ZERO, "linuxcnc").table().end[0, 0])
        except ProgramError:
            continue
        if abs(read) < 1e6 and len(text) < 200:
            lines.append(f"#1={text}\n(DEBUG,#1)\n")
    program = head + "".join(lines) + "M2\n"
    theirs, accepted = rs274_calls(program, tmp_path)
    assert accepted
    said = [[call[13:] for call in calls if "MESSAGE" in call] for calls in (canonical_calls(program), theirs)]
    assert len(said[0]) == 150
    for line, mine, real in zip(lines, *said, strict=True):
        numbers = [float(call.split('"')[1]) for call in (mine, real)]
        assert numbers[0] == pytest.approx(numbers[1], rel=1e-9, abs=2e-6), line


def test_a_comment_says_0_of_what_is_nearly_0(tmp_path):
    program = "#1=0.00009 #2=-0.00009 #3=0.00011 #<a>=0.00005\n(DEBUG,#1 #2 #3 #<a> %.8f#1 %d#3)\nM2\n"
    both = list(canonical_calls(program)), rs274_calls(program, tmp_path)[0]
    mine, theirs = ([call for call in calls if "MESSAGE" in call] for calls in both)
    assert mine == theirs
    assert "0.000000 0.000000 0.000110 0.000000" in mine[0]


def test_assignments_take_effect_after_the_line():
    table = interpret("#1=5\nG0 X#1 #1=7 #2=#1\nX#1 Y#2\nM2", ZERO, "linuxcnc").table()
    assert table.end[:, :2].tolist() == [[5, 0], [7, 5]]


def test_a_refused_line_assigns_nothing():
    reader = Interpreter(ZERO, "linuxcnc")
    reader.line("#1=5 #<a>=6")
    for line in ("#1=8 #<a>=9 #<b>=1 G1 X1", "#1=8 #2=[1/0]"):
        with pytest.raises(ProgramError):
            reader.line(line)
    parameters = reader.model.parameters
    assert (parameters.get(1), parameters.get(2), parameters.get_named("a")) == (5, 0, 6)
    assert not parameters.has_name("b")


def test_positions_and_offsets_can_be_read():
    text = "G21 G10 L2 P1 X10 Y20\nG0 X1 Y2 Z3\nG20\n#1=#5420 #2=#<_z> #3=#5221\nM2"
    reader = Interpreter(ZERO, "linuxcnc")
    for line in text.split("\n"):
        reader.line(line)
    numbers = [reader.model.parameters.get(number) for number in (1, 2, 3)]
    assert numbers == pytest.approx([1 / 25.4, 3 / 25.4, 10])


def test_an_unknown_position_is_no_number():
    with pytest.raises(ProgramError, match="position along Y is not known") as caught:
        interpret("G0 X1\n#1=#<_y>\nM2", Start(), "linuxcnc")
    assert (caught.value.place.line, caught.value.place.column) == (2, 4)


def test_parameters_of_the_start_are_there():
    start = Start(position_mm=(0.0, 0.0, 0.0), zero_known=True, parameters={31: 4.5})
    assert interpret("G0 X#31\nM2", start, "linuxcnc").table().end[0, 0] == 4.5


def test_a_dialect_without_expressions_refuses_them():
    for text in ("G0 X#1", "G0 X[1]", "o1 sub", "#1=2"):
        with pytest.raises(ProgramError, match=r"not part of this dialect|not read"):
            interpret(text, ZERO, "grbl")


def test_words_and_values_mix_on_a_line():
    table = interpret("g[1] x-[2] y+sqrt[9]z.5 f[100]\nM2", ZERO, "linuxcnc").table()
    assert table.end[0, :3].tolist() == [-2, 3, 0.5]
    assert table.feed[0] == 100


WORDS_AS_NAMES = (
    *("sub", "endsub", "call", "do", "while", "repeat", "if", "elseif", "else", "endif", "break", "continue", "return"),
    *("and", "or", "xor", "mod", "eq", "ne", "gt", "ge", "lt", "le", "sin", "atan", "exists", "fix", "ln", "round"),
    *(
        "o100",
        "g1",
        "m98",
        "x",
        "100",
        "1x",
        "a-b",
        "a+b",
        "a*b",
        "a=b",
        "a.b",
        "a,b",
        "a#b",
        "#1",
        "[1]",
        "%",
        "$",
        "@",
    ),
    *("@", "!", "?", "&", "'", "_", "__x", "_sub", "<a", "ç", "Ç", "_Ç", "coração"),
)
NAMES_WITH_BLANKS = ["a b", "A B", "aB", " a", "a\tb "]


@pytest.mark.parametrize(
    "text",
    [
        "".join(f"#<{name}>={k}\nG0 X#<{name}>\n" for k, name in enumerate([*WORDS_AS_NAMES, *NAMES_WITH_BLANKS])),
        "".join(f"G0 X[EXISTS[#<{name}>]]\n" for name in WORDS_AS_NAMES),
        "".join(f"#<k>=7\n# < {name} > = 4 (c)\nG0 Y # <{name}> ; c\n" for name in WORDS_AS_NAMES),
        "".join(f"#<{name}>=2\n(debug, #<{name}>)\n" for name in ["sub", "while", "AND", "Ç", "ç", "a-b"]),
        "".join(
            f"o<{name}> if [1]\nG0 X{k}\nO<{name}> EndIf\n" for k, name in enumerate(("sub", "if", "ç", "Ç", "a-b"))
        ),
        "o<corte ção> sub\nG0 X3\no<corte ção> endsub\no<corteção> call\n",
    ],
    ids=["set", "exists", "blanks", "spoken", "labels", "subroutine"],
)
def test_names_are_read_as_rs274_reads_them(text, tmp_path):
    (tmp_path / "program.ngc").write_text(text + "M2\n", "utf-8")
    run = run_rs274(tmp_path, "program.ngc")
    assert run.returncode == 0, run.stderr
    real = [line.rstrip() for line in run.stdout.splitlines() if line.strip()]
    ours = [call.rstrip() for call in canonical_calls(text + "M2\n") if call.strip()]
    assert [mine for mine, call in zip(ours, real, strict=True) if not same_call(mine, call)] == []


@pytest.mark.parametrize(("line", "column"), [("#<a(x)>=1 #<a(y)>=2", 4), ("G0 X1 (c) Y# < b;c>", 17)])
def test_a_comment_in_a_name_is_refused(line, column):
    with pytest.raises(ProgramError) as caught:
        interpret(f"{line}\nM2\n", ZERO, "linuxcnc")
    assert (caught.value.code, caught.value.place.column) == ("comment", column)


def test_letters_beyond_ascii_are_told_apart_by_their_case(tmp_path):
    text = "o<Ção> sub\nG0 X1\no<Ção> endsub\no<ção> call\nM2\n"
    assert not rs274_calls(text, tmp_path)[1]
    with pytest.raises(ProgramError):
        list(canonical_calls(text))
