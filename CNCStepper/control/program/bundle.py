# SPDX-License-Identifier: LGPL-2.1-or-later
"""A proof or a job as one file: a zip whose long columns are read where they lie, so that memory stays the same.

    proof.json      the head: plain data, without the lines
    wire.txt        the wire lines, each with its newline
    line_map.npy    the file's line of each, int32
    messages.txt    messages to the operator, and message_map.npy, their lines: `program_columns.py`

Members are stored, not compressed. What is no such file is refused, and no member is read whole but the head.
"""

from __future__ import annotations

import io
import json
import os
import re
import secrets
import shutil
import struct
import sys
from abc import abstractmethod
from array import array
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice
from pathlib import Path
from typing import Any, BinaryIO, TypeVar, overload
from zipfile import ZIP_STORED, BadZipFile, ZipFile, ZipInfo

from CNCStepper.control.program.wire_line import check_line
from CNCStepper.errors import JobError, Place, Text
from CNCStepper.input_file import Unchanged, input_kind

WIRE, LINE_MAP = "wire.txt", "line_map.npy"
TEXT, ARRAY, HEAD = ".txt", ".npy", ".json"
MAGIC = b"PK\3\4"
BLOCK = 1024  # lines that are read at once
KEPT_BLOCKS = 2
CHUNK = 16_384  # items that are written at once
CHUNK_BYTES = 1 << 18
MOST_MEMBERS = 8
MOST_DIRECTORY_BYTES = 1 << 16
MOST_HEAD_BYTES = 8_000_000  # the plan of a certificate has at most 1000 rows
MOST_BLOCK_BYTES = 1 << 24  # no controller reads lines of a thousandth of this
NUMBER, NUMBER_BYTES = "i", 4  # of `array`
_ARRAY_MAGIC = b"\x93NUMPY\1\0"
_ARRAY_HEADER = "{'descr': '<i4', 'fortran_order': False, 'shape': (N,), }"  # N numbers
_ARRAY_BEGIN = re.compile(re.escape(_ARRAY_HEADER).replace("N", r"(\d{1,18})").encode() + rb" *\n")
_ALIGNED = 64  # bytes, what comes before an array's first number
_BLOCK_OF_LINES = re.compile(rb"(?:[^\n]*\n){%d}" % BLOCK)
_LOCAL_HEADER = 30  # bytes of a member's own header, before its name
_Item = TypeVar("_Item")


@dataclass(frozen=True)
class Bundle:
    """What a file holds. head: plain data. columns: by the names of their members, read when they are asked for."""

    head: dict[str, Any]
    columns: Mapping[str, Sequence[Any]]

    @property
    def lines(self) -> Sequence[str]:
        """The wire lines."""
        return self.columns.get(WIRE, ())

    @property
    def file_lines(self) -> Sequence[int]:
        """The file's line of each."""
        return self.columns.get(LINE_MAP, ())


def is_bundle(path: Path) -> bool:
    """Return whether a file begins as a bundle does; raises OSError."""
    if input_kind(path):
        return False
    with open(path, "rb") as file:
        return file.read(len(MAGIC)) == MAGIC


def read_bundle(path: Path, private: bool = False) -> Bundle:
    """Return the content of a bundle; raises OSError, and ValueError for a file that is none.

    private: a copy that nobody else writes, so that its columns are read without asking whether it was changed.
    """
    if kind := input_kind(path):
        raise ValueError(Text("this is {kind}, not a file", kind=kind))
    try:
        members = _members(path, None if private else Unchanged(path))
        (head,) = (member for name, member in members.items() if name.endswith(HEAD))
        columns = {name: _column(name, member) for name, member in members.items() if member != head}
        return Bundle(_head(head), columns)
    except (BadZipFile, NotImplementedError, struct.error, RecursionError) as error:
        raise ValueError(str(error)) from error


def write_bundle(file: BinaryIO, members: Mapping[str, Iterable[bytes]]) -> None:
    """Write a bundle; the same content gives the same bytes."""
    with ZipFile(file, "w") as archive:
        for name, pieces in members.items():
            info = ZipInfo(name)  # of 1980, as all
            info.create_system, info.external_attr = 3, 0o600 << 16  # on any system
            with archive.open(info, "w", force_zip64=True) as member:
                for piece in pieces:
                    member.write(piece)


def new_private(path: Path) -> BinaryIO:
    """Return a new file that only its owner can read; raises OSError where there is one of that name."""
    return open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0), 0o600), "wb")


def write_private(path: Path, members: Mapping[str, Iterable[bytes]]) -> None:
    """Write a bundle that only its owner can read; a reader finds it whole or not at all. Raises OSError."""
    draft = path.with_name(f"{path.name}.{secrets.token_hex(4)}")
    try:
        with new_private(draft) as file:
            write_bundle(file, members)
        os.replace(draft, path)
    finally:
        draft.unlink(missing_ok=True)


def copy_private(source: Path, path: Path) -> None:
    """Copy a file to a new one that only its owner can read; raises OSError, and ValueError for a folder or a pipe."""
    if kind := input_kind(source):
        raise ValueError(Text("this is {kind}, not a file", kind=kind))
    with open(source, "rb") as read, new_private(path) as written:
        shutil.copyfileobj(read, written, CHUNK_BYTES)


def head_bytes(content: Mapping[str, Any], **more: Any) -> list[bytes]:
    """Return a head for `write_bundle`; more: as `json.dumps` takes it."""
    return [json.dumps(content, **more).encode("utf-8")]


def line_bytes(lines: Sequence[str], place: Callable[[int], Place] | None = None) -> Iterator[bytes]:
    """Yield lines for `write_bundle`, as they are sent; raises ProgramError for one that holds two.

    place: of a line, by its index from 0.
    """
    if isinstance(lines, Lines):
        yield from lines.pieces()
        return
    first = 0
    for block in _blocks(lines):
        text = "\n".join((*block, ""))
        if text.count("\n") != len(block):
            index = next(index for index, line in enumerate(block) if "\n" in line)
            check_line(block[index], place(first + index) if place else None)
        yield text.encode("utf-8")
        first += len(block)


def number_bytes(numbers: Sequence[int]) -> Iterator[bytes]:
    """Yield numbers as they lie in the file."""
    if isinstance(numbers, Numbers):
        yield from numbers.pieces()
    else:
        yield from (_little_endian(array(NUMBER, block)).tobytes() for block in _blocks(numbers))


def array_bytes(numbers: Sequence[int]) -> Iterator[bytes]:
    """Yield numbers for `write_bundle`, as an array of numpy's, which a sender's Python need not have."""
    header, before = _ARRAY_HEADER.replace("N", str(len(numbers))), len(_ARRAY_MAGIC) + 2
    size = -(-(before + len(header) + 1) // _ALIGNED) * _ALIGNED - before
    yield _ARRAY_MAGIC + struct.pack("<H", size) + f"{header:{size - 1}}\n".encode("ascii")
    yield from number_bytes(numbers)


@dataclass(frozen=True)
class _Member:
    """The bytes of a file from `begin` on; unchanged: None for a private copy."""

    path: Path
    begin: int
    size: int
    unchanged: Unchanged | None

    def read(self, begin: int, end: int) -> bytes:
        """Return some of them; raises JobError where the file was changed or cannot be read any more."""
        if self.unchanged:
            self.unchanged.check()
        try:
            with open(self.path, "rb") as file:
                file.seek(self.begin + begin)
                data = file.read(end - begin)
        except OSError as error:
            raise self._unreadable(Text("{error}", error=error.strerror or error)) from error
        if len(data) != end - begin:
            raise self._unreadable("it is cut short")
        return data

    def _unreadable(self, why: str) -> JobError:
        what = Text("the program's file cannot be read any more: {why}", why=why)
        return JobError("program-unreadable", what, advice="make it again", place=Place(str(self.path)))

    def pieces(self) -> Iterator[bytes]:
        """Yield them all, piece by piece."""
        for begin in range(0, self.size, CHUNK_BYTES):
            yield self.read(begin, min(begin + CHUNK_BYTES, self.size))


class _Column(Sequence[Any]):
    """Items in a file; the last blocks read are kept, for reading at two places at once. For any thread."""

    def __init__(self, member: _Member, count: int):
        self._member, self._count = member, count
        self._block = lru_cache(KEPT_BLOCKS)(self._read)

    @abstractmethod
    def _read(self, number: int) -> list[Any]:
        """Return the items of a block."""

    def pieces(self) -> Iterator[bytes]:
        """Yield the items as they lie in the file."""
        return self._member.pieces()

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[Any]:
        for first in range(0, self._count, BLOCK):
            yield from self._read(first // BLOCK)

    @overload
    def __getitem__(self, index: int) -> Any: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[Any, ...]: ...

    def __getitem__(self, index: int | slice) -> Any:
        if isinstance(index, slice):
            return tuple(self[place] for place in range(*index.indices(self._count)))
        number, place = divmod(range(self._count)[index], BLOCK)
        return self._block(number)[place]


class Lines(_Column):
    """Lines of text; raises ValueError where the last has no newline, or one is longer than any that is sent."""

    def __init__(self, member: _Member):
        self._offsets = [0]  # where every BLOCK-th line begins, and the end
        held = b""
        for piece in member.pieces():
            held, begin = held + piece, 0
            while found := _BLOCK_OF_LINES.match(held, begin):
                self._offsets.append(self._offsets[-1] + found.end() - begin)
                begin = found.end()
            held = held[begin:]
            if len(held) > MOST_BLOCK_BYTES:
                raise ValueError("its lines are too long")
        if held and not held.endswith(b"\n"):
            raise ValueError("the last line has no end")
        super().__init__(member, (len(self._offsets) - 1) * BLOCK + held.count(b"\n"))
        self._offsets.append(member.size)

    def _read(self, number: int) -> list[str]:
        data = self._member.read(self._offsets[number], self._offsets[number + 1])
        return data.decode("utf-8", "replace").split("\n")[:-1]


class Numbers(_Column):
    """Numbers of four bytes, the lowest first."""

    def __init__(self, member: _Member):
        super().__init__(member, member.size // NUMBER_BYTES)

    def _read(self, number: int) -> list[int]:
        begin, end = (min((number + more) * BLOCK, self._count) * NUMBER_BYTES for more in (0, 1))
        return _little_endian(array(NUMBER, self._member.read(begin, end))).tolist()


class _Archive(io.FileIO):
    """A file of which `zipfile` reads no directory that is larger than any of a bundle."""

    def read(self, size: int | None = -1) -> bytes:
        """Return as many bytes; raises ValueError for too many."""
        if size is not None and size > MOST_DIRECTORY_BYTES:
            raise ValueError("its directory is too large")
        return super().read(size) or b""


def _members(path: Path, unchanged: Unchanged | None) -> dict[str, _Member]:
    """Return where the members of a zip lie."""
    with _Archive(path) as file, ZipFile(file) as archive:
        infos = archive.infolist()
        if len(infos) > MOST_MEMBERS or len({info.filename for info in infos}) != len(infos):
            raise ValueError("it holds more than a bundle does")
        begins = [_begin(file, info) for info in infos]
    return {
        info.filename: _Member(path, begin, info.file_size, unchanged)
        for info, begin in zip(infos, begins, strict=True)
    }


def _begin(file: io.FileIO, info: ZipInfo) -> int:
    """Return where the bytes of a member begin."""
    if info.compress_type != ZIP_STORED or info.flag_bits & 1 or info.compress_size != info.file_size:
        raise ValueError("it was compressed or encrypted anew")
    file.seek(info.header_offset)
    header = file.read(_LOCAL_HEADER)
    begin = info.header_offset + _LOCAL_HEADER + sum(struct.unpack("<HH", header[-4:]))
    if header[: len(MAGIC)] != MAGIC or begin + info.file_size > os.fstat(file.fileno()).st_size:
        raise ValueError("it is damaged")
    return begin


def _head(member: _Member) -> dict[str, Any]:
    if member.size > MOST_HEAD_BYTES:
        raise ValueError("its head is too large")
    head = json.loads(member.read(0, member.size))
    if not isinstance(head, dict):
        raise ValueError("its head is no object of JSON")
    return head


def _column(name: str, member: _Member) -> Sequence[Any]:
    """Return the column of a member."""
    if name.endswith(TEXT):
        return Lines(member)
    if not name.endswith(ARRAY):
        raise ValueError(Text("it contains a file that no bundle has: {name}", name=name[:60]))
    header = member.read(0, min(member.size, MOST_DIRECTORY_BYTES))
    found = _ARRAY_BEGIN.match(header, len(_ARRAY_MAGIC) + 2)
    size = member.size - found.end() if found else -1
    if not found or not header.startswith(_ARRAY_MAGIC) or int(found[1]) * NUMBER_BYTES != size:
        raise ValueError("its line map is no array of whole numbers")
    return Numbers(_Member(member.path, member.begin + found.end(), size, member.unchanged))


def column_of_file(path: Path) -> Lines | Numbers:
    """Return a column that lies in a file of its own, as `line_bytes` or `number_bytes` gives it; raises OSError."""
    member = _Member(path, 0, path.stat().st_size, Unchanged(path))
    return Lines(member) if path.suffix == TEXT else Numbers(member)


def _little_endian(numbers: array[int]) -> array[int]:
    """Return numbers as they lie in the file, or those of a file, on any computer."""
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers


def _blocks(items: Iterable[_Item]) -> Iterator[list[_Item]]:
    rest = iter(items)
    while block := list(islice(rest, CHUNK)):
        yield block
