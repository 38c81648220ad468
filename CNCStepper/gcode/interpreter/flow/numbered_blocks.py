# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs a lathe's program whose cycles name their profile by the N words of its first and its last block.

G71 P10 Q20 ...     reads N10 to N20 as a profile; the program goes on behind N20
N10 G0 X20. ... N20 G1 X50.
G70 P10 Q20         runs N10 to N20 as they are written, and leads back to where it began
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects.preprocessor import pieces
from CNCStepper.gcode.interpreter.flow.flow_line_parser import names_blocks
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.state.interpreter_state import Model, Point
from CNCStepper.gcode.syntax.words import Word

_NUMBER = re.compile(r"[ \t]*/?[ \t]*N[ \t]*([0-9]+)", re.IGNORECASE)


class NumberedBlocks:
    """The way through such a program: line after line, past the profiles that cycles have read."""

    def __init__(self, interpreter: Interpreter, lines: Sequence[str]):
        self._interpreter, self._lines = interpreter, lines
        self._index = interpreter.line_number
        self._skips_to = 0
        self._finishing: tuple[int, int, Point] | None = None
        interpreter.numbered = self

    def run(self) -> Iterator[None]:
        """Run the program to its end."""
        reader = self._interpreter
        while self._index < len(self._lines):
            self._skips_to = 0
            reader.line_at(self._lines[self._index], self._index + 1, Place(reader.file, self._index + 1))
            self._index = max(self._index + 1, self._skips_to)
            yield
            if self._finishing:
                yield from self._finish(*self._finishing)

    def read(self, first: int, last: int, model: Model, take: Callable[[Model, list[Word], list[float]], None]) -> None:
        """Hand the words of each block of a profile to a cycle; `model` replaces the interpreter's."""
        reader = self._interpreter
        kept = reader.model, reader.line_number, reader.sequence
        begin, end = self._blocks(first, last)
        reader.model = model
        try:
            for index in range(begin, end):
                place = Place(reader.file, index + 1)
                for piece in pieces(self._lines[index], reader.dialect):
                    taken = reader.taken_at(piece.text, place)
                    reader.grammar.plan(taken[0], model.motion)  # refuses what the language lacks
                    take(model, *taken)
        finally:
            reader.model, reader.line_number, reader.sequence = kept
        if begin > self._index:
            self._skips_to = end

    def run_after(self, first: int, last: int, back: Point) -> None:
        """Run the blocks once the present one is done, and go back to a machine position."""
        begin, end = self._blocks(first, last)
        self._finishing = begin, end, back

    def _finish(self, begin: int, end: int, back: Point) -> Iterator[None]:
        reader, self._finishing = self._interpreter, None
        for index in range(begin, end):
            if names_blocks(self._lines[index]):
                what, place = "a profile may not hold a cycle", Place(reader.file, index + 1)
                advice = "write the cycle outside of it, or correct the numbers of its first and its last block"
                raise ProgramError("profile", what, value=self._lines[index].strip()[:40], place=place, advice=advice)
            reader.line_at(self._lines[index], index + 1, Place(reader.file, index + 1))
            yield
        reader.rapid_back(back)
        if begin >= self._index:
            self._index = end

    def _blocks(self, first: int, last: int) -> tuple[int, int]:
        """Return the index of block N<first> and that behind N<last>; raises ProgramError where there are none."""
        begin = self._find(first, 0)
        return begin, self._find(last, begin) + 1

    def _find(self, number: int, begin: int) -> int:
        for index in range(begin, len(self._lines)):
            match = _NUMBER.match(self._lines[index])
            if match and int(match[1]) == number:
                return index
        what = Text("the program has no block N{number}", number=number)
        raise ProgramError("no-block", what, value=str(number), advice="number the profile's first and last block")
