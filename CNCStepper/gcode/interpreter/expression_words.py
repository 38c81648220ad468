# SPDX-License-Identifier: LGPL-2.1-or-later
"""The words and assignments of a line whose values are computed: `G1 X[#1 + 2] #3=4`.

Every value is computed with the parameters before the line; assignments take effect after the line is read.
"""

from __future__ import annotations

from typing import NamedTuple

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.state.system_parameters import SystemParameters, check_assignable
from CNCStepper.gcode.syntax.expressions import Scanner
from CNCStepper.gcode.syntax.words import SIGNS, Word, not_a_word, pack
from CNCStepper.tolerances import WHOLE_NUMBER

_WHOLE_WORDS = "HLMT"
_CODE_DIGIT = 1e-3  # how near ten times a G number must be to a whole one


class ExpressionWords(NamedTuple):
    """words: their numbers are the values. values: of all words but G and M. assignments: name or number, value."""

    words: list[Word]
    values: list[float]
    assignments: list[tuple[int | str, float]]


def is_computed(code: str) -> bool:
    """Whether a line without comments has values that must be computed."""
    return "#" in code or "[" in code


def read_items(code: str, known: SystemParameters) -> ExpressionWords:
    """Return the words and assignments of a line without comments; raises ProgramError with its column."""
    packed, columns = pack(code)
    scanner = Scanner(packed, columns, known)
    items = ExpressionWords([], [], [])
    while not scanner.ended:
        if scanner.take("#"):
            items.assignments.append(_assignment(scanner))
        else:
            _word(scanner, items)
    return items


def _assignment(scanner: Scanner) -> tuple[int | str, float]:
    begin = scanner.position - 1
    target: int | str = scanner.name() if scanner.next == "<" else scanner.whole()
    try:
        check_assignable(target)
    except ProgramError as error:
        raise scanner.error(error.code, error.what, error.advice, begin) from None
    if not scanner.take("="):
        raise scanner.error("assignment", "= is missing after the parameter", "write #1=2", begin)
    return target, scanner.value()


def _word(scanner: Scanner, items: ExpressionWords) -> None:
    """Read a letter and its value."""
    letter, column = scanner.next, scanner.column
    if not (letter in SIGNS or (letter.isascii() and letter.isalpha())) or letter == "O":
        raise not_a_word(scanner.packed, scanner.position, scanner.columns)
    begin = scanner.position
    scanner.position += 1
    if letter == "N" and not scanner.next.isdigit():
        raise scanner.error("line-number", "a line number is written in digits", "write N10", begin)
    value = scanner.value()
    if letter in _WHOLE_WORDS and abs(value - round(value)) < WHOLE_NUMBER:
        value = float(round(value))
    if letter == "G":
        value = _code_number(scanner, value, begin)
    items.words.append(Word(letter, f"{value:.12g}", column))
    if letter not in "GM":
        items.values.append(value)


def _code_number(scanner: Scanner, value: float, begin: int) -> float:
    """Return the number of a G code, which has one decimal at most."""
    tenths = round(10 * value)
    if abs(10 * value - tenths) > _CODE_DIGIT:
        raise scanner.error("unknown-code", "a G code has one decimal at most", "correct the number", begin)
    return tenths / 10
