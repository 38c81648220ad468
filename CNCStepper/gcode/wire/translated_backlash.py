# SPDX-License-Identifier: LGPL-2.1-or-later
"""Backlash compensation of a translated program: from the tool's rows to the motors', chunk by chunk.

    row of the tool          line of the translation     lines sent                row of the motors
    0  X10                   G1X10                       G1X10                     0
    1  X4 (turns back)       G1X4                        G1X9.95 | G1X3.95         1, 2

The lines sent are read back; each row of the motors has state and line of the tool's row that it belongs to. Events and
spans of the program name rows of the tool: `row` gives the motors'.
"""

from __future__ import annotations

from array import array
from dataclasses import replace

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.wire.backlash_compensation import BacklashCompensation
from CNCStepper.gcode.wire.read_back import groups_of
from CNCStepper.gcode.wire.wire_text import WireText
from CNCStepper.machine.backlash import Backlash
from CNCStepper.state import Start
from CNCStepper.toolpath import Chunk, Event, Span, Toolpath


class MotorRows:
    """The motors' rows of a translated program, whose lines come in their order."""

    def __init__(self, play: Backlash, target: Dialect, start: Start, file: str):
        self._compensation = BacklashCompensation(play, target, start, file)
        self._reader = Interpreter(start, target, file)
        self._file = file
        self._firsts = array("q")  # the motors' first row, by the tool's

    @property
    def known(self) -> int:
        """How many rows of the tool have come."""
        return len(self._firsts)

    def row(self, index: int) -> int:
        """Return the motors' first row of a row of the tool; the next one to come for the tool's next."""
        return self._firsts[index] if index < len(self._firsts) else self._reader.table.index

    def compensated(self, wire: WireText, chunk: Chunk) -> tuple[WireText, list[Chunk]]:
        """Return the lines sent for the next lines of a translation, and the motors' rows of the chunk that they make.

        Raises ProgramError where a line cannot be compensated.
        """
        sent, table, counts = self._compensation.wire(wire), self._reader.table, array("q")
        for group, number in zip(groups_of(sent), wire.file_lines.tolist(), strict=True):
            before = table.index
            for line in group:
                self._reader.line_at(line, number, Place(self._file, number))
            if table.index > before:
                self._firsts.append(before)
                counts.append(table.index - before)
        if len(counts) != len(chunk):
            raise differs(Place(self._file, int(chunk.line[0]) if len(chunk) else 0))
        table.events.clear()
        states, lines = (np.repeat(column, counts) for column in (chunk.state, chunk.line))
        return sent, list(self._with(states, lines))

    def renumbered(self, path: Toolpath) -> Toolpath:
        """Return the program's events and spans with the motors' rows; its chunks stay as they are."""
        return replace(path, events=list(map(self.event, path.events)), spans=list(map(self.span, path.spans)))

    def event(self, event: Event) -> Event:
        """Return an event with the motors' row."""
        return replace(event, index=self.row(event.index))

    def span(self, span: Span) -> Span:
        """Return a span with the motors' rows."""
        return replace(span, first=self.row(span.first), last=self.row(span.last))

    def _with(self, states: np.ndarray, lines: np.ndarray):
        """Yield the rows that were read, with other states and lines."""
        begin = 0
        for piece in self._reader.table.take():
            some = slice(begin, begin + len(piece))
            yield replace(piece, state=states[some], line=lines[some])
            begin = some.stop


def differs(place: Place) -> ProgramError:
    """Return the error of lines that mean another path than their program."""
    what = "the lines that would be sent mean another path than the program"
    return ProgramError("translation", what, advice="this is a fault of this program: report it", place=place)
