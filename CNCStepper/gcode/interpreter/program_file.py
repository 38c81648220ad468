# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program read from its file piece by piece, so that neither its text nor its table need be held whole."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator, Sequence
from pathlib import Path

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.fast_path.text_runs import compiled_reader
from CNCStepper.gcode.interpreter.file_chunks import byte_pieces, encoding_of
from CNCStepper.gcode.interpreter.flow.program_flow import run_on
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.line_store import LineStore
from CNCStepper.gcode.syntax.text_format import BOM
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import Chunk, Toolpath


def interpret_file(
    path: Path,
    start: Start | None = None,
    dialect: str | Dialect = "grbl",
    *,
    progress: Callable[[float], None] | None = None,
    cancelled: Callable[[], bool] | None = None,
) -> Toolpath:
    """Return the table of moves of a program's file, as `interpret` does for its text.

    progress: called with the share that is read, from 0 to 1. cancelled: asked between pieces; once it says so,
    ProgramError with the code "cancelled" is raised.
    """
    reading = FileReading(path, start, dialect, progress=progress, cancelled=cancelled)
    chunks = list(reading.chunks())
    table = reading.interpreter.table
    return Toolpath(table.start, chunks, table.states, table.events, table.spans)


class FileReading:
    """One reading of a program's file; `chunks` hands its table on as it grows, `interpreter` knows the rest."""

    def __init__(
        self,
        path: Path,
        start: Start | None = None,
        dialect: str | Dialect = "grbl",
        *,
        progress: Callable[[float], None] | None = None,
        cancelled: Callable[[], bool] | None = None,
        name: str = "",
    ):
        """name: by which refusals know the file; its path where left out."""
        self.path, self._name = path, name or str(path)
        self.interpreter = Interpreter(start, dialect, self._name)
        self._library = library_of(self._name, start)
        self._progress = progress or (lambda share: None)
        self._cancelled = cancelled or (lambda: False)

    def chunks(self, encoding: str = "") -> Iterator[Chunk]:
        """Read the file and yield its chunks, each when it is whole; raises ProgramError, also where there is no end.

        When the last one is out, the states, events and spans of `interpreter.table` are complete. encoding: found out
        when left out.
        """
        encoding = encoding or encoding_of(self._pieces())
        table = self.interpreter.table
        for _ in self._read(encoding):
            yield from table.take_whole()
        yield from self.interpreter.toolpath().chunks

    def _read(self, encoding: str) -> Iterator[None]:
        """Read the file in pieces up to the first line that leads elsewhere, then line by line; yield now and then."""
        size, read, mark = self.path.stat().st_size, 0, BOM if encoding == "utf-8" else b""
        reader = compiled_reader(self.interpreter, size)
        for piece in self._pieces(mark):
            if not (reader.read(piece, encoding) if reader else self._lines(piece.decode(encoding))):
                yield from self._run_on(mark, encoding)
                break
            read += len(piece)
            self._progress(min(1.0, read / size))
            yield
        self._progress(1.0)

    def _run_on(self, mark: bytes, encoding: str) -> Iterator[None]:
        """Read what comes after the lines that were read, wherever it leads."""
        with LineStore.of(piece.decode(encoding) for piece in self._pieces(mark)) as lines:
            yield from self._run(lines)

    def _run(self, lines: Sequence[str]) -> Iterator[None]:
        """Read what comes after the lines that were read of a program's."""
        for _ in run_on(self.interpreter, lines, self._library):
            self._progress(min(1.0, self.interpreter.line_number / len(lines)))
            yield

    def refusals(self) -> Iterator[ProgramError]:
        """Read the file and yield why lines are refused, as `program_flow.refusals` does for its text."""
        encoding = encoding_of(self._pieces())
        mark = BOM if encoding == "utf-8" else b""
        reader = compiled_reader(self.interpreter, self.path.stat().st_size)
        for piece in self._pieces(mark):
            if reader:
                whole = yield from reader.refused(piece, encoding)
            else:
                whole = yield from self._refused_lines(piece.decode(encoding))
            if not whole:
                yield from self._refusals_behind(mark, encoding)
                return

    def _refused_lines(self, text: str) -> Generator[ProgramError, None, bool]:
        for line in program_lines(text):
            if self.interpreter.leads(line):
                return False
            try:
                self.interpreter.line(line)
            except ProgramError as error:
                yield error
        return True

    def _refusals_behind(self, mark: bytes, encoding: str) -> Iterator[ProgramError]:
        """Yield the refusal behind a line that leads elsewhere, which is the last."""
        try:
            for _ in self._run_on(mark, encoding):
                pass
        except ProgramError as error:
            yield error

    def _lines(self, text: str) -> bool:
        """Read lines up to the first that leads elsewhere; return whether there was none."""
        for line in program_lines(text):
            if self.interpreter.leads(line):
                return False
            self.interpreter.line(line)
        return True

    def _pieces(self, mark: bytes = b"") -> Iterator[bytes]:
        """Yield the file as pieces of whole lines, without the byte-order mark; raises ProgramError when cancelled."""
        for piece in byte_pieces(self.path, mark):
            if self._cancelled():
                place = Place(self._name, self.interpreter.line_number)
                raise ProgramError("cancelled", "reading was cancelled", place=place)
            yield piece
