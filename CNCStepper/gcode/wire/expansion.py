# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes a program with parameters, expressions, loops and subroutines out as plain lines, in the order of their run.

    #1 = 3                          G1 X6 F100
    o1 repeat [2]          ->       G1 X6
    G1 X[#1 * 2] F100
    o1 endrepeat

For controllers that are sent lines: they cannot jump back in what they have forgotten. What a program computes from the
position is computed from the start state, so that the lines are right for that start only.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.expression_words import ExpressionWords
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run_on
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.gcode.syntax.words import Comment, Word, program_lines
from CNCStepper.state import Start

DECIMALS = 6  # of computed numbers: far below a step, and within what controllers count with


class Block(NamedTuple):
    """A block as it was run: the line of the program, its words with plain numbers, its comments."""

    line: int
    words: list[Word]
    comments: tuple[Comment, ...]


def is_expanded(text: str, dialect: Dialect) -> bool:
    """Whether a program's lines must be written out before they are sent."""
    return writes_out(dialect) and not is_plain(text)


def writes_out(dialect: Dialect) -> bool:
    """Whether the lines of programs that compute or jump are written out in this dialect."""
    return (dialect.expressions or dialect.o_words) and not dialect.reads_files


def expanded(text: str, dialect: Dialect, start: Start | None = None, file: str = "") -> Iterator[Block]:
    """Yield the blocks of a program in the order in which they are run; raises ProgramError as the interpreter does."""
    yield from expanded_lines(program_lines(text), dialect, start, file)


def expanded_lines(
    lines: Sequence[str], dialect: Dialect, start: Start | None = None, file: str = ""
) -> Iterator[Block]:
    """Yield the same of a program's lines, of which no more is held than they hold themselves."""
    reader = _Recorder(start, dialect, file)
    for _ in run_on(reader, lines, library_of(file, start)):
        yield from reader.taken()


class _Recorder(Interpreter):
    """Reads every line the general way and keeps its block."""

    def __init__(self, start: Start | None, dialect: Dialect, file: str):
        super().__init__(start, dialect, file)
        self._blocks: list[Block] = []

    @property
    def runs(self) -> bool:
        """Never: a run of lines is read without its words."""
        return False

    def taken(self) -> list[Block]:
        """Return and forget the blocks since last time, and the rows that they have made."""
        blocks, self._blocks = self._blocks, []
        self.table.forget()
        return blocks

    def _line(self, text: str) -> None:
        self._any_line(text)

    def _block(self, plan: Plan, items: ExpressionWords, comments: tuple[Comment, ...]) -> None:
        super()._block(plan, items, comments)
        words = [word._replace(number=_plain(word)) for word in items.words]
        self._blocks.append(Block(self.line_number, words, comments))


def _plain(word: Word) -> str:
    """Return a word's number without an exponent."""
    if "e" not in word.number and len(word.number.partition(".")[2]) <= DECIMALS:
        return word.number
    return f"{float(word.number):.{DECIMALS}f}"
