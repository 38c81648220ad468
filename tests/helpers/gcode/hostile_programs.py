# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs that nobody would write: random text, random words, and programs of the right form with wrong insides."""

from __future__ import annotations

from hypothesis import strategies as st

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import dialect_names
from CNCStepper.gcode.interpreter.flow.flow_line_parser import KEYWORDS
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import Limits, run
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

FEW_LINES = Limits(lines=300)

_NUMBERS = st.one_of(
    st.integers(-3, 99).map(str),
    st.floats(-1e6, 1e6, allow_nan=False).map(lambda value: f"{value:.4f}"),
    st.sampled_from(
        ["0", "-0", ".", "1.", ".5", "--1", "1e5", "9" * 14, "9" * 40, "0." + "0" * 30 + "1", "5161", "5420"]
    ),
)
_NAMES = st.sampled_from(["#1", "#2", "##1", "#[#1+1]", "#<a>", "#<_b>", "#<_x>", "#<_value>", "#5221", "#0", "#99999"])
_OPERATORS = st.sampled_from(["+", "-", "*", "/", "**", " MOD ", " EQ ", " lt ", " GE ", " and ", " XOR ", "//", ""])
_FUNCTIONS = st.sampled_from(["SIN", "atan", "EXISTS", "sqrt", "LN", "EXP", "FIX", "round", "FOO", "ACOS"])


def _deeper(values: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(
        st.tuples(values, _OPERATORS, values).map(lambda parts: f"[{''.join(parts)}]"),
        st.tuples(_FUNCTIONS, values).map(lambda parts: f"{parts[0]}[{parts[1]}]"),
        st.tuples(values, values).map(lambda parts: f"ATAN[{parts[0]}]/[{parts[1]}]"),
    )


VALUES = st.recursive(st.one_of(_NUMBERS, _NAMES), _deeper, max_leaves=6)
_CODES = st.one_of(
    st.sampled_from([f"G{number}" for number in range(100)]),
    st.sampled_from([f"M{number}" for number in (*range(10), 19, 30, *range(48, 74), 98, 99)]),
    st.sampled_from(
        [
            "G0",
            "G1",
            "G2",
            "G3",
            "G5.1",
            "G5.2",
            "G5.3",
            "G10",
            "G28.1",
            "G38.2",
            "G41",
            "G43",
            "G43.1",
            "G59.3",
            "G64",
            "G76",
            "G83",
            "G90.1",
            "G92.1",
        ]
    ),
)
_WORDS = st.one_of(
    _CODES,
    _CODES,
    st.tuples(st.sampled_from("ABCDEFHIJKLPQRSTUVWXYZ@^$N"), VALUES).map("".join),
    st.tuples(_NAMES, st.just("="), VALUES).map("".join),
)
_LABELS = st.sampled_from(["o1", "o2", "o<a>", "O 3", "o#1", "o[1+1]"])
_KEYWORDS = st.sampled_from(KEYWORDS)
_FLOW = st.tuples(_LABELS, _KEYWORDS, st.lists(VALUES, max_size=2)).map(
    lambda parts: f"{parts[0]} {parts[1]} {' '.join(f'[{value}]' for value in parts[2])}"
)
_COMMENTS = st.sampled_from(["(DEBUG, #1 %d #<a>)", "(MSG, a)", "; x", "(", ")", "(PRINT, %.3f #5220)", "/", "%", ""])
_LINES = st.one_of(
    st.lists(_WORDS, min_size=1, max_size=6).map(" ".join),
    st.lists(_WORDS, min_size=1, max_size=6).map(" ".join),
    _FLOW,
    _COMMENTS,
)
PROGRAMS = st.lists(_LINES, max_size=25).map("\n".join)
LETTERS = st.text("GMXYZIJKRPQFSTNOLDHgo0123456789.-+[]#<>=()/*;%@^$ \t\r\n", max_size=120)
TEXTS = st.one_of(st.text(max_size=120), LETTERS)
DIALECTS = st.one_of(st.just("linuxcnc"), st.sampled_from(dialect_names()))
STARTS = st.sampled_from([Start(), Start.at_zero(), Start.with_work_zero((10.0, -20.0, 5.0))])


def read(text: str, dialect: str, start: Start | None = None) -> Toolpath | ProgramError:
    """Return the table of a program, or its refusal; any other exception is a failure of the reader."""
    try:
        interpreter = Interpreter(start, dialect, "hostile.nc")
        for _ in run(interpreter, text, limits=FEW_LINES):
            pass
        return interpreter.toolpath()
    except ProgramError as error:
        return error


def check(outcome: Toolpath | ProgramError, text: str) -> None:
    """Check that a refusal names a place in the text and says something, and that a table is whole."""
    if isinstance(outcome, ProgramError):
        place = outcome.place
        assert place is not None and 0 <= place.line <= text.count("\n") + text.count("\r") + 1
        assert outcome.code and outcome.what
    else:
        table = outcome.table()
        assert len(table.line) == len(table.kind) == len(table.end)
