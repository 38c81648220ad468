# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text: the lines sent, their lines in the file, and the limits of a line.

The lines that are sent, held as the bytes that go over the wire.

The first move of a wire text names its motion: the controller's modal motion depends on earlier programs.

program   X10            proven as the rapid of a fresh controller
sent      G0X10          after M2 of another program a bare X10 would be a cut (G1)

The first cut of a program that has no F names the feed with which it was proven.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import overload

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import ALL_AXES, MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.syntax.words import Word, words_of
from CNCStepper.toolpath import RAPID
from CNCStepper.units import MM_PER_INCH

AT_ONCE = 4096  # lines that are made at once


class WireLines(Sequence[str]):
    """Lines of plain ASCII, each made from the bytes when it is asked for; a sequence as a tuple of them is.

    data    G21\\nG0X1\\nM2\\n
    ends       3    8  11      of each line, the place of its newline
    """

    def __init__(self, data: bytes):
        self.data = data
        self._ends = np.flatnonzero(np.frombuffer(data, np.uint8) == ord("\n"))

    @overload
    def __getitem__(self, index: int) -> str: ...

    @overload
    def __getitem__(self, index: slice) -> tuple[str, ...]: ...

    def __getitem__(self, index: int | slice) -> str | tuple[str, ...]:
        if isinstance(index, slice):
            return tuple(self[place] for place in range(*index.indices(len(self))))
        end = int(self._ends[index])
        return self.data[self.data.rfind(b"\n", 0, end) + 1 : end].decode("ascii")

    def begins(self, indices: np.ndarray) -> np.ndarray:
        """Return where lines begin in `data`, int64[n]; the index behind the last one is the end."""
        return np.append(0, self._ends + 1)[indices]

    def __len__(self) -> int:
        return len(self._ends)

    def __iter__(self) -> Iterator[str]:
        begin = 0
        for last in range(AT_ONCE, len(self) + AT_ONCE, AT_ONCE):
            end = int(self._ends[min(last, len(self)) - 1]) + 1
            yield from self.data[begin:end].decode("ascii").split("\n")[:-1]
            begin = end

    def __eq__(self, other: object) -> bool:
        if isinstance(other, WireLines):
            return self.data == other.data
        return tuple(self) == other if isinstance(other, tuple) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.data)

    def __repr__(self) -> str:
        return repr(tuple(self))


REALTIME = frozenset(b"!?~\x18") | frozenset(range(0x80, 0x100))  # bytes that grbl acts upon anywhere


@dataclass(frozen=True)
class WireText:
    """lines: without their newline. file_lines: int32[len(lines)], the file's line of each, from 1.

    messages: index in `lines` -> what to tell the operator before that line runs. leads: bool[len(lines)], whether
    a line stands for the same line of the program as the next one, to which it leads; None for none
    (`backlash_compensation.py`).
    """

    lines: WireLines
    file_lines: np.ndarray
    messages: Mapping[int, str] = field(default_factory=dict)
    leads: np.ndarray | None = None

    @property
    def text(self) -> str:
        """The lines as they are sent, each with its newline."""
        return self.lines.data.decode("ascii")

    @property
    def sha256(self) -> str:
        """The fingerprint that a certificate names."""
        return hashlib.sha256(self.lines.data).hexdigest()


def check_wire_line(line: str, dialect: str | Dialect = "grbl", place: Place | None = None) -> None:
    """Raise ProgramError where a line (without newline) may not be sent: too long, or with bytes that act."""
    language = dialect_named(dialect)
    if language.line_limit and len(line) >= language.line_limit:
        limit = f"{language.line_limit - 1} characters"
        value = f"{len(line)} characters"
        what: str = Text("the line does not fit the buffer of {language}", language=language.title)
        raise ProgramError("line-too-long", what, value=value, limit=limit, advice="write it as two", place=place)
    acting = sorted(REALTIME.intersection(line.encode("utf-8")))
    if acting or not line.isprintable():
        value = f"0x{acting[0]:02X}" if acting else repr(line)
        what = "the line holds a real-time command byte"
        raise ProgramError("realtime-byte", what, value=value, advice="take it out", place=place)


_AXIS = re.compile(f"[{ALL_AXES}]")


class FirstMove:
    """Looks for the first move of a program in lines that come piece by piece."""

    def __init__(self, dialect: Dialect):
        self._dialect = dialect
        self._is_known = dialect.first_motion == NO_MOTION

    def without_motion(self, lines: WireLines) -> int | None:
        """Return the index of the first line that moves, where no line up to it names a motion; else None."""
        codes_of = self._dialect.codes
        for index, line in enumerate(() if self._is_known else lines):
            codes = [codes_of[word.name] for word in words_of(line) if word.name in codes_of]
            names_motion = any(code.motion is not None for code in codes)
            if names_motion or (_AXIS.search(line) and not any(code.axes for code in codes)):
                self._is_known = True
                return None if names_motion else index
        return None


def with_first_motion(lines: WireLines, index: int, dialect: Dialect) -> WireLines:
    """Return the lines with the dialect's first motion before the line `index`."""
    begin = sum(len(line) + 1 for line in lines[:index])
    name = MOTION_NAMES[dialect.first_motion].encode("ascii")
    return WireLines(lines.data[:begin] + name + lines.data[begin:])


class FirstFeed:
    """Searches the first cut of a program without an F before it, in lines that come piece by piece."""

    def __init__(self, dialect: Dialect):
        self._dialect = dialect
        is_read_as_it_is = dialect.reads_files or "records" in dialect.front
        self._is_known = not dialect.default_feed_mm_min or dialect.feed_is_setting or is_read_as_it_is
        self._motion = dialect.first_motion
        self._unit_mm = 1.0

    def missing(self, lines: WireLines) -> tuple[int, str] | None:
        """Return the index of the first line that cuts, and the F word that it needs; None where it needs none."""
        for index, line in enumerate(() if self._is_known else lines):
            words = words_of(line)
            unit_mm = self._unit_mm
            is_named = self._follow(words)
            self._is_known = any(word.letter == "F" for word in words)
            if self._is_known:
                return None
            moves = is_named or any(word.letter in ALL_AXES for word in words)
            if moves and self._motion not in (RAPID, NO_MOTION):
                self._is_known = True
                in_unit_mm = self._unit_mm if self._dialect.feed_in_new_units else unit_mm
                return index, f"F{self._dialect.default_feed_mm_min / in_unit_mm:.10g}"
        return None

    def _follow(self, words: list[Word]) -> bool:
        """Note the modes that a line sets; return whether it names a motion, which needs a feed even without axes."""
        codes = [self._dialect.codes.get(word.name) for word in words if word.letter in "GM"]
        for code in filter(None, codes):
            self._motion = self._motion if code.motion is None else code.motion
            if units := code.sets.get("units"):
                self._unit_mm = MM_PER_INCH if units == "inch" else 1.0
        return any(code is not None and code.motion is not None for code in codes)


def with_first_feed(lines: WireLines, index: int, word: str) -> WireLines:
    """Return the lines with an F word behind the line `index`."""
    end = sum(len(line) + 1 for line in lines[: index + 1]) - 1
    return WireLines(lines.data[:end] + word.encode("ascii") + lines.data[end:])
