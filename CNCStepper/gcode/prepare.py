# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a program file to the wire text: exactly the lines that are sent, and the way back to the file's lines.

No comments, blank lines, "%", N words or blanks; upper case, shortest numbers, plain ASCII; each line fits the
controller's buffer and holds no byte that acts where it stands. Read by the interpreter, the wire text gives the
same moves and states as the file.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.words import Word, is_tape_mark, program_lines, split_line, words_of

REALTIME = frozenset(b"!?~\x18") | frozenset(range(0x80, 0x100))  # bytes that grbl acts upon wherever they stand
ENDS = frozenset(("M2", "M30"))


@dataclass(frozen=True)
class WireText:
    """lines: without their newline. file_lines: int32[len(lines)], the file's line of each, from 1.

    messages: index in `lines` -> what to tell the operator before that line runs.
    """

    lines: tuple[str, ...]
    file_lines: np.ndarray
    messages: Mapping[int, str] = field(default_factory=dict)

    @property
    def text(self) -> str:
        """The lines as they are sent, each with its newline."""
        return "".join(f"{line}\n" for line in self.lines)

    @property
    def sha256(self) -> str:
        """The fingerprint that a certificate names."""
        return hashlib.sha256(self.text.encode("ascii")).hexdigest()


def prepare(text: str, dialect: str | Dialect = "grbl", file: str = "") -> WireText:
    """Return the wire text of a program; raises ProgramError naming file, line, column for what cannot be sent."""
    language = dialect_named(dialect)
    lines: list[str] = []
    file_lines: list[int] = []
    messages: dict[int, str] = {}
    waiting: list[str] = []
    for number, line, words in _lines(text, language, file):
        waiting += [comment.text.strip() for comment in line.comments if comment.message]
        wire = "".join(_short(word) for word in words if word.letter != "N")
        if not wire:
            continue
        check_wire_line(wire, language, Place(file, number, words[0].column))
        if waiting:
            messages[len(lines)] = "\n".join(waiting)
            waiting = []
        lines.append(wire)
        file_lines.append(number)
    return WireText(tuple(lines), np.array(file_lines, np.int32), messages)


def check_wire_line(line: str, dialect: str | Dialect = "grbl", place: Place | None = None) -> None:
    """Raise ProgramError where a line (without newline) may not be sent: too long, or with bytes that act."""
    language = dialect_named(dialect)
    if language.line_limit and len(line) >= language.line_limit:
        limit = f"{language.line_limit - 1} characters"
        value = f"{len(line)} characters"
        what = f"the line does not fit the buffer of {language.title}"
        raise ProgramError("line-too-long", what, value=value, limit=limit, advice="write it as two", place=place)
    acting = sorted(REALTIME.intersection(line.encode("utf-8")))
    if acting or not line.isprintable():
        value = f"0x{acting[0]:02X}" if acting else repr(line)
        what = "the line holds a byte that the controller acts upon wherever it stands"
        raise ProgramError("realtime-byte", what, value=value, advice="take it out", place=place)


def _lines(text: str, language: Dialect, file: str):
    """Yield (number, line, words) of the lines that a controller of this language is to see."""
    begun = False
    for number, raw in enumerate(program_lines(text), 1):
        if is_tape_mark(raw):
            if begun:
                return
            begun = True
            continue
        try:
            line = split_line(raw, language.strict_comments)
            if line.deleted and language.skips_deleted:
                continue
            words = words_of(line.code)
        except ProgramError as error:
            column = error.place.column if error.place else 0
            raise error.at(Place(file, number, column)) from None
        begun = begun or bool(words or line.comments)
        yield number, line, words
        if language.stops_at_end and any(word.name in ENDS for word in words):
            return


def _short(word: Word) -> str:
    """Return a word with the shortest form of its number."""
    sign = "-" if word.number.startswith("-") else ""
    whole, _, rest = word.number.lstrip("+-").partition(".")
    whole, rest = whole.lstrip("0") or "0", rest.rstrip("0")
    number = f"{whole}.{rest}" if rest else whole
    return word.letter + (number if number == "0" else sign + number)
