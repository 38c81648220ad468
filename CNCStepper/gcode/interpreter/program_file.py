# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program read from its file piece by piece, so that neither its text nor its table need be held whole.

The lines of a long text, kept on the disk: a program that jumps is read wherever it leads, and only a part is held.

    file     | 256 lines | 256 lines | ...        in UTF-8, each line with a LF
    blocks           v                            those read last, as lists of lines

The file has no name, so that nothing is left of it where the process is killed.

A program's file in pieces of whole lines, so that its text need not be held whole.
"""

from __future__ import annotations

import tempfile
from array import array
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from types import TracebackType
from typing import overload

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.fast_path.policy import PIECE
from CNCStepper.gcode.interpreter.fast_path.text_runs import compiled_reader
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run_on
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.syntax.text_format import BOM
from CNCStepper.gcode.syntax.words import program_lines, require_short
from CNCStepper.state import Start
from CNCStepper.toolpath import Chunk, Toolpath

BLOCK = 256  # lines that are read at once
MOST_BLOCKS = 512  # that are held
MOST_HELD = 32_000_000  # characters of them


class LineStore(Sequence[str]):
    """Lines that are added a piece of the text after the other, and then read in any order; raises OSError."""

    def __init__(self) -> None:
        self._file = tempfile.TemporaryFile(prefix="cncstepper-lines-")  # noqa: SIM115  closed by close()
        self._begins = array("q", [0])  # of the blocks that are whole, and of the next one
        self._count = 0
        self._waiting: list[str] = []  # lines of the block that is not whole yet
        self._blocks: dict[int, list[str]] = {}
        self._held = 0

    @classmethod
    def of(cls, pieces: Iterable[str]) -> LineStore:
        """Return the store of a text that comes in pieces of whole lines."""
        store = cls()
        for piece in pieces:
            store.add(piece)
        return store

    def __enter__(self) -> LineStore:
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self.close()

    def add(self, piece: str) -> None:
        """Add whole lines of the text."""
        lines = program_lines(piece)
        self._count += len(lines)
        self._waiting += lines
        whole = len(self._waiting) // BLOCK * BLOCK
        for first in range(0, whole, BLOCK):
            self._begins.append(self._begins[-1] + self._written(self._waiting[first : first + BLOCK]))
        del self._waiting[:whole]

    def close(self) -> None:
        """Give the disk back."""
        self._file.close()

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> list[str]: ...

    def __getitem__(self, index: int | slice) -> str | list[str]:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(self._count))]
        place = index + self._count if index < 0 else index
        if not 0 <= place < self._count:
            raise IndexError(Text("there are {count} lines, none at {index}", count=self._count, index=index))
        number, line = divmod(place, BLOCK)
        block = self._blocks.get(number)
        return (self._read(number) if block is None else block)[line]

    def __len__(self) -> int:
        return self._count

    def _written(self, lines: list[str]) -> int:
        """Write lines at the end; return how many bytes they are."""
        data = "".join(f"{line}\n" for line in lines).encode("utf-8", "surrogatepass")
        self._file.seek(0, 2)
        return self._file.write(data)

    def _read(self, number: int) -> list[str]:
        """Return a block, and keep it; those that were read first are forgotten."""
        if number == len(self._begins) - 1:
            return self._waiting
        begin, end = self._begins[number], self._begins[number + 1]
        self._file.seek(begin)
        block = self._file.read(end - begin).decode("utf-8", "surrogatepass").split("\n")[:-1]
        self._blocks[number] = block
        self._held += end - begin
        while len(self._blocks) > 1 and (len(self._blocks) > MOST_BLOCKS or self._held > MOST_HELD):
            old = next(iter(self._blocks))
            del self._blocks[old]
            self._held -= self._begins[old + 1] - self._begins[old]
        return block


def text_pieces(path: Path) -> Iterator[str]:
    """Yield the text of a file as `text_format.decoded` gives it whole."""
    encoding = encoding_of(byte_pieces(path))
    for piece in byte_pieces(path, BOM):
        yield piece.decode(encoding)


def byte_pieces(path: Path, mark: bytes = b"") -> Iterator[bytes]:
    """Yield the bytes of a file, without the mark before them, if it is there.

    Raises ProgramError for a line that is longer than any program's.
    """
    rest = b""
    with path.open("rb") as file:
        while piece := file.read(PIECE):
            rest = (rest + piece).removeprefix(mark)
            mark = b""
            end = _end_of_lines(rest)
            if end:
                yield rest[:end]
            rest = rest[end:]
            if len(rest) > PIECE:
                require_short(len(rest), Place(str(path)))
    if rest:
        yield rest


def encoding_of(pieces: Iterable[bytes]) -> str:
    """Return the encoding of whole lines: UTF-8, or Latin-1 where they cannot be that."""
    return "utf-8" if all(map(_is_utf_8, pieces)) else "latin-1"


def _end_of_lines(data: bytes) -> int:
    """Return where the last whole line of `data` ends; a CR at the very end may belong to a LF that follows."""
    return data.rfind(b"\n") + 1 or data.rfind(b"\r", 0, -1) + 1


def _is_utf_8(piece: bytes) -> bool:
    if piece.isascii():
        return True
    try:
        piece.decode("utf-8")
    except UnicodeDecodeError:
        return False
    return True


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
    """One reading of a program's file; `chunks` yields its table as it grows, `interpreter` holds the state."""

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
            whole = (
                reader.read(piece, encoding)
                if reader
                else self.interpreter.lines(program_lines(piece.decode(encoding)))
            )
            if not whole:
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
        """Read the file and yield why lines are refused, as `run_with_subroutines.refusals` does for its text."""
        encoding = encoding_of(self._pieces())
        mark = BOM if encoding == "utf-8" else b""
        reader = compiled_reader(self.interpreter, self.path.stat().st_size)
        for piece in self._pieces(mark):
            if reader:
                whole = yield from reader.refused(piece, encoding)
            else:
                whole = yield from self.interpreter.refusals(program_lines(piece.decode(encoding)))
            if not whole:
                yield from self._refusals_behind(mark, encoding)
                return

    def _refusals_behind(self, mark: bytes, encoding: str) -> Iterator[ProgramError]:
        """Yield the refusal behind a line that leads elsewhere, which is the last."""
        try:
            for _ in self._run_on(mark, encoding):
                pass
        except ProgramError as error:
            yield error

    def _pieces(self, mark: bytes = b"") -> Iterator[bytes]:
        """Yield the file as pieces of whole lines, without the byte-order mark; raises ProgramError when cancelled."""
        for piece in byte_pieces(self.path, mark):
            if self._cancelled():
                place = Place(self._name, self.interpreter.line_number)
                raise ProgramError("cancelled", "reading was cancelled", place=place, advice="read it again")
            yield piece
