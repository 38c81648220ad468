# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's file whose lines are written out, read back from what is sent of it as it is run.

file ──► lines on the disk ──► blocks as they are run ──► what is sent ──► sink, SHA-256
                                  │                          │
                                  └── comments ──────────────┴──► Interpreter ──► chunks
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import islice
from pathlib import Path

from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.interpreter.file_chunks import text_pieces
from CNCStepper.gcode.interpreter.flow.o_words import is_plain
from CNCStepper.gcode.interpreter.line_store import LineStore
from CNCStepper.gcode.wire.encoder import wire_of_block
from CNCStepper.gcode.wire.expansion import Block, expanded_lines, writes_out
from CNCStepper.gcode.wire.read_back import groups_of, read_block
from CNCStepper.gcode.wire.wire_file import Sink, WireFile
from CNCStepper.machine.backlash import Backlash
from CNCStepper.state import Start
from CNCStepper.toolpath import Chunk, Event

BLOCKS = 4096  # that are written out at once


def wire_of_file(
    path: Path,
    start: Start | None,
    dialect: str | Dialect,
    play: Backlash | None = None,
    *,
    sink: Sink = lambda wire: None,
    progress: Callable[[float], None] = lambda share: None,
    name: str = "",
) -> WireFile:
    """Return the reading of any program's file; see `WireFile`."""
    language = dialect_named(dialect)
    written_out = writes_out(language) and not all(map(is_plain, text_pieces(path)))
    reading = WireBlocks if written_out else WireFile
    return reading(path, start, language, play, sink=sink, progress=progress, name=name)


class WireBlocks(WireFile):
    """One reading of a program whose lines are written out."""

    def _chunks(self) -> Iterator[Chunk]:
        reader = self._reading.interpreter
        with LineStore.of(text_pieces(self._path)) as lines:
            blocks = expanded_lines(lines, self._language, self._start, self._name)
            while some := list(islice(blocks, BLOCKS)):
                self._read(some)
                self._progress(min(1.0, some[-1].line / len(lines)))
                yield from reader.table.take_whole()
        yield from reader.toolpath().chunks

    def _read(self, blocks: list[Block]) -> None:
        """Send blocks, and read back what is sent of them."""
        wire = self._sent(*self._encoder.join(map(wire_of_block, blocks)))
        self._hand_on(wire)
        sent = groups_of(wire)
        for block in blocks:
            read_block(self._reading.interpreter, block, sent)

    def _with_lines(self, events: list[Event]) -> list[Event]:
        return events
