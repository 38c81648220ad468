# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program's file read back from its wire text, piece by piece: neither text nor table is held whole.

    file ──► piece ──► WireEncoder ──► wire text ──► sink, SHA-256
               │                            │
               └── its other lines ─────────┴──► Interpreter ──► chunks, naming the file's lines

It gives what `prepare` and `read_back` give of a whole text. From the first line that leads elsewhere on, it is read
from the disk, line by line. Programs whose lines are written out before they are sent (`expansion.is_expanded`) are
read as they are run.

A program's file with expanded lines, read back from its wire text as it is run.

file ──► lines on the disk ──► blocks as they are run ──► wire text ──► sink, SHA-256
                                  │                          │
                                  └── comments ──────────────┴──► Interpreter ──► chunks
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import TypedDict, Unpack

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.dialect_options import as_sent
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain
from CNCStepper.gcode.interpreter.program_file import FileReading, LineStore, byte_pieces, encoding_of, text_pieces
from CNCStepper.gcode.syntax.text_format import BOM
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.gcode.wire.backlash_compensation import BacklashCompensation
from CNCStepper.gcode.wire.encoder import WireEncoder, wire_of_block
from CNCStepper.gcode.wire.expansion import Block, expanded_lines, writes_out
from CNCStepper.gcode.wire.line_runs import runs_of_piece
from CNCStepper.gcode.wire.read_back import groups_of, joined_lines, read_block
from CNCStepper.gcode.wire.wire_text import WireLines, WireText
from CNCStepper.machine.backlash import Backlash
from CNCStepper.state import Start
from CNCStepper.toolpath import Chunk, Event, TableBuilder

Sink = Callable[[WireText], None]


class WireOptions(TypedDict, total=False):
    """What every reading takes; `WireFile` has the meanings and the defaults."""

    sink: Sink
    progress: Callable[[float], None]
    name: str


class WireFile:
    """One reading of a program's file through the wire.

    sink: receives the wire text of each piece, in order, with its messages by the index of a line in the piece.
    count: lines sent so far. name: by which refusals know the file; its path where left out.
    """

    def __init__(
        self,
        path: Path,
        start: Start | None,
        dialect: str | Dialect,
        play: Backlash | None = None,
        *,
        sink: Sink = lambda wire: None,
        progress: Callable[[float], None] = lambda share: None,
        name: str = "",
    ):
        self._path, self._sink, self._progress = path, sink, progress
        self._name = name or str(path)
        self._language = as_sent(dialect_named(dialect))
        self._reading = _Reading(path, start, self._language, name=name)
        self._encoder = WireEncoder(self._language, self._name)
        self._take_up = BacklashCompensation(play, self._language, start, self._name) if play else None
        self._start = start
        self._digest = hashlib.sha256()
        self._numbers = _LineNumbers()
        self.count = 0

    @property
    def sha256(self) -> str:
        """The fingerprint of what was sent so far."""
        return self._digest.hexdigest()

    @property
    def table(self) -> TableBuilder:
        """The table that grows: its start, states, events and spans."""
        return self._reading.interpreter.table

    def chunks(self) -> Iterator[Chunk]:
        """Read the file and yield its chunks, each when it is whole; raises ProgramError at the file's line."""
        try:
            yield from self._chunks()
        except ProgramError:
            for _ in FileReading(self._path, self._start, self._language, name=self._name).chunks():
                pass  # refuses the same line, naming the column in the file
            raise

    def _chunks(self) -> Iterator[Chunk]:
        for chunk in self._reading.chunks_of(self._joined(), self._progress):
            yield replace(chunk, line=self._numbers.of(chunk.line)) if self._take_up else chunk

    def take_events(self) -> list[Event]:
        """Take the events out of the table, which would keep every comment of the file."""
        events, self.table.events[:] = list(self.table.events), []
        return self._with_lines(events) if self._take_up else events

    def _with_lines(self, events: list[Event]) -> list[Event]:
        """Return events of the lines that are read with the lines of the file."""
        lines = self._numbers.of_events(np.array([event.line for event in events], np.int64))
        return [replace(event, line=line) for event, line in zip(events, lines.tolist(), strict=True)]

    def _joined(self) -> Iterator[bytes]:
        """Yield the program with the lines that are sent in place of those that they were made from."""
        encoding, first, read = encoding_of(byte_pieces(self._path)), 1, 0
        size = max(1, self._path.stat().st_size)
        for data in byte_pieces(self._path, BOM if encoding == "utf-8" else b""):
            text = data.decode(encoding)
            lines = program_lines(text)
            wire = self._sent(*self._encoder.encode(runs_of_piece(text, first, self._language)))
            self._hand_on(wire)
            if self._take_up:
                numbers, joined = joined_lines(wire, lines, first)
                self._numbers.add(numbers)
                yield "".join(f"{line}\n" for line in joined).encode("utf-8", "surrogatepass")
            else:
                yield b"".join(_filled(wire, lines, first))
            first, read = first + len(lines), read + len(data)
            self._progress(min(1.0, read / size))

    def _hand_on(self, wire: WireText) -> None:
        """Pass the wire text of a piece on."""
        self._digest.update(wire.lines.data)
        self._sink(wire)
        self.count += len(wire.lines)

    def _sent(self, lines: bytes, numbers: np.ndarray) -> WireText:
        """Return the wire text of an encoded piece."""
        wire = WireText(self._encoder.started(WireLines(lines), numbers), numbers, self._encoder.messages)
        return self._take_up.wire(wire) if self._take_up else wire


def _filled(wire: WireText, lines: list[str], first: int) -> Iterator[bytes]:
    """Yield the bytes of `read_back.joined_lines`, where no line has become several."""
    data, numbers = wire.lines.data, wire.file_lines
    left_out = np.setdiff1d(np.arange(first, first + len(lines)), numbers, assume_unique=True)
    places, begin = wire.lines.begins(np.searchsorted(numbers, left_out)), 0
    for number, place in zip(left_out.tolist(), places.tolist(), strict=True):
        yield data[begin:place]
        yield f"{lines[number - first]}\n".encode("utf-8", "surrogatepass")
        begin = place
    yield data[begin:]


class _Reading(FileReading):
    """Reads pieces that somebody makes in place of those of the file."""

    def chunks_of(self, pieces: Iterator[bytes], progress: Callable[[float], None]) -> Iterator[Chunk]:
        """Yield the chunks of whole lines in UTF-8; they are kept on the disk where one of them may lead elsewhere.

        progress: called where one does, with the share of the lines that is reached.
        """
        self._told = progress
        with LineStore() as self._store:
            self._made = self._stored(pieces) if self.interpreter.dialect.o_words else pieces
            yield from self.chunks("utf-8")

    def _stored(self, pieces: Iterator[bytes]) -> Iterator[bytes]:
        for piece in pieces:
            self._store.add(piece.decode("utf-8", "surrogatepass"))
            yield piece

    def _pieces(self, mark: bytes = b"") -> Iterator[bytes]:
        yield from self._made

    def _run_on(self, mark: bytes, encoding: str) -> Iterator[None]:
        for _ in self._made:
            pass  # the wire text of the rest is sent, and stored
        self._progress = self._told
        yield from self._run(self._store)


class _LineNumbers:
    """The file's line of each line that is read, from the last chunk but one on."""

    def __init__(self) -> None:
        self._first, self._numbers = 1, np.zeros(0, np.int32)  # of line `first` and those behind it
        self._kept_from = 1

    def add(self, numbers: np.ndarray) -> None:
        """Note those of further lines."""
        self._numbers = np.concatenate([self._numbers, numbers])

    def of(self, lines: np.ndarray) -> np.ndarray:
        """Return the file's lines of a chunk's rows."""
        found = self.of_events(lines)
        self._numbers, self._first = self._numbers[self._kept_from - self._first :], self._kept_from
        self._kept_from = int(lines[0]) if len(lines) else self._kept_from
        return found

    def of_events(self, lines: np.ndarray) -> np.ndarray:
        """Return the file's lines of events, int32[n]."""
        return self._numbers[lines - self._first]  # type: ignore[no-any-return]


BLOCKS = 4096  # that are written out at once


def wire_of_file(
    path: Path,
    start: Start | None,
    dialect: str | Dialect,
    play: Backlash | None = None,
    **options: Unpack[WireOptions],
) -> WireFile:
    """Return the reading of any program's file; see `WireFile`."""
    language = dialect_named(dialect)
    written_out = writes_out(language) and not all(map(is_plain, text_pieces(path)))
    reading = WireBlocks if written_out else WireFile
    return reading(path, start, language, play, **options)


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
        """Send blocks, and read their wire text back."""
        wire = self._sent(*self._encoder.join(wire_of_block(block, self._language) for block in blocks))
        self._hand_on(wire)
        sent = groups_of(wire)
        for block in blocks:
            read_block(self._reading.interpreter, block, sent)

    def _with_lines(self, events: list[Event]) -> list[Event]:
        return events
