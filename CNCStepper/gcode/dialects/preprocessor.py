# SPDX-License-Identifier: LGPL-2.1-or-later
"""Brings lines of dialects that are spelled differently into the form of RS274, so that there is one grammar.

    N10 X5000 # N20 G01 Z-1. F2. #   ->   N10 X0.5000    N20 G01 Z-1. F120.      records, numbers without a point, mm/s
    G4 S2 ; settle                   ->   G4 P2000 ; settle                       one letter for the dwell

A dialect names its steps in their order (`Dialect.front`). Each character of a piece knows the column in the line that
it stands for, so that errors name the place in the text as it is written. Steps know no state of the machine.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from decimal import Decimal
from functools import reduce
from operator import xor

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.word_pattern import DECIMAL

TEN_THOUSANDTH = Decimal("0.0001")
_DOTLESS = re.compile(r"([A-FH-LO-Z][ \t]*)([+-]?[0-9]+)(?![0-9.])", re.IGNORECASE)
_POINTLESS = re.compile(r"[XZIKRUW][ \t]*[+-]?0*[1-9][0-9]*(?![0-9.])", re.IGNORECASE)
_REPEATED = re.compile(r"G[ \t]*73(?![0-9.])", re.IGNORECASE)
_FEED = re.compile(rf"(F[ \t]*)({DECIMAL})", re.IGNORECASE)
_COMMAND = re.compile(r"[GMT][ \t]*[0-9]", re.IGNORECASE)
_CHECKSUM = re.compile(r"\*([0-9]+)[ \t]*$")
_DWELL = re.compile(r"(?<![0-9A-Z])G0?4(?![0-9.])", re.IGNORECASE)
_SHOWN = re.compile(r"[ \t]*(?:N[0-9]+[ \t]*)?(M117|M0*[01])(?![0-9])[ \t]*(?![SP][0-9. ])([A-Z].*)?$", re.IGNORECASE)
_NAME = re.compile(r"[ \t]*(?:%[ \t]*([^% \t][^%]*)|[:O][ \t]*([0-9]+)[ \t]*)$", re.IGNORECASE)


@dataclass(frozen=True)
class Piece:
    """Text in the form of RS274; columns: of each of its characters in the line, from 1. ends_chunk: by "?"."""

    text: str
    columns: tuple[int, ...]
    ends_chunk: bool = False

    def column(self, column: int) -> int:
        """Return the line's column of a column in `text`."""
        if not self.columns or column < 1:
            return column
        return self.columns[column - 1] if column <= len(self.columns) else self.columns[-1] + 1

    def cut(self, begin: int, end: int) -> Piece:
        """Return the piece in [begin, end)."""
        return Piece(self.text[begin:end], self.columns[begin:end])

    def replaced(self, pattern: re.Pattern[str], text_of: Callable[[re.Match[str]], str], end: int) -> Piece:
        """Return the piece with each match before `end` replaced; new characters get the match's first column."""
        text, at = "", 0
        columns: tuple[int, ...] = ()
        for match in pattern.finditer(self.text, 0, end):
            new = text_of(match)
            text += self.text[at : match.start()] + new
            columns += self.columns[at : match.start()] + (self.columns[match.start()],) * len(new)
            at = match.end()
        return Piece(text + self.text[at:], columns + self.columns[at:], self.ends_chunk)

    def refused(self, code: str, what: str, at: int, value: str, advice: str, limit: str = "") -> ProgramError:
        """Return the error for the character at index `at`."""
        place = Place(column=self.column(at + 1))
        return ProgramError(code, what, advice=advice, value=value[:40], limit=limit, place=place)


def pieces(line: str, dialect: Dialect, as_written: bool = False) -> list[Piece]:
    """Return a line of the dialect as pieces in the form of RS274; raises ProgramError with its column.

    as_written: the words stay as they are; only other text is split.
    """
    found = [Piece(line, tuple(range(1, len(line) + 1)))]
    for step in dialect.front:
        if as_written and step in VALUE_STEPS:
            continue
        found = [piece for before in found for piece in STEPS[step](before)]
    return found


def reads_moves_directly(dialect: Dialect) -> bool:
    """Return whether a line with only N, one G, coordinates and F is read unchanged."""
    return not {"records", "dotless", "pointed", "feed_per_second", "without_height"} & {*dialect.front}


# records of the mini-lathe


def records(piece: Piece) -> Iterator[Piece]:
    """Split at "#" and "?"; a comment runs from ";" to "#". Each record must end."""
    begin = 0
    for match in re.finditer("[#?]", piece.text):
        ends_chunk = match[0] == "?"
        record = piece.cut(begin, match.start())
        if ends_chunk and record.text.strip():
            raise _unended(record)
        yield Piece(*_with_brackets(record), ends_chunk)
        begin = match.end()
    rest = piece.cut(begin, len(piece.text))
    if rest.text.strip():
        raise _unended(rest)


def _unended(record: Piece) -> ProgramError:
    at = len(record.text) - len(record.text.lstrip())
    return record.refused("record-end", "the record does not end", at, record.text.strip(), "end it with #", "#")


def _with_brackets(record: Piece) -> tuple[str, tuple[int, ...]]:
    """Return text and columns with the comment after ";" in parentheses."""
    code, semicolon, comment = record.text.partition(";")
    if not semicolon:
        return record.text, record.columns
    text = f"{code}({comment.translate(str.maketrans('()', '[]')).strip()})"
    return text, (record.columns + record.columns[-1:])[: len(text)]


def dotless(piece: Piece) -> Iterator[Piece]:
    """Give numbers without a point, which are in 1/10000, their point; not those of G, M and N."""
    end = _end_of_code(piece.text)
    yield piece.replaced(_DOTLESS, lambda match: f"{match[1]}{Decimal(match[2]) * TEN_THOUSANDTH:f}", end)


def feed_per_second(piece: Piece) -> Iterator[Piece]:
    """Turn F from a second into F a minute."""
    yield piece.replaced(_FEED, lambda match: f"{match[1]}{Decimal(match[2]) * 60:f}", _end_of_code(piece.text))


# lines of Marlin


def semicolons(piece: Piece) -> Iterator[Piece]:
    """Refuse comments in parentheses; in a text for the display they are nothing special."""
    end = _semicolon(piece.text)
    at = piece.text.find("(", 0, end)
    if at >= 0 and _SHOWN.match(piece.text, 0, end) is None:
        raise piece.refused("comment", "parentheses are no comment here", at, "(", "begin the comment with ;")
    yield piece


def checksum(piece: Piece) -> Iterator[Piece]:
    """Take a checksum off: the exclusive or of all bytes before "*"."""
    end = _semicolon(piece.text)
    match = _CHECKSUM.search(piece.text, 0, end)
    if match is None:
        yield piece
        return
    summed = reduce(xor, piece.text[: match.start()].encode("utf-8"), 0)
    if int(match[1]) != summed:
        raise piece.refused(
            "checksum", "the checksum is wrong", match.start(), match[0], Text("it should be *{summed}", summed=summed)
        )
    yield piece.cut(0, match.start())


def texts(piece: Piece) -> Iterator[Piece]:
    """Turn the text after M0 and M117 into a message."""
    end = _semicolon(piece.text)
    match = _SHOWN.match(piece.text, 0, end)
    if match is None or (not match[2] and match[1].upper() != "M117"):
        yield piece
        return
    stop = "" if match[1].upper() == "M117" else match[1]
    text = f"{stop}(MSG, {(match[2] or '').translate(str.maketrans('()', '[]')).strip()})"
    yield Piece(text, (piece.columns[match.start(1)],) * len(text))


def dwell_in_seconds(piece: Piece) -> Iterator[Piece]:
    """Write the S of a dwell (seconds) as P (milliseconds); S goes before P."""
    end = _semicolon(piece.text)
    if _DWELL.search(piece.text, 0, end) is None or not re.search("[Ss]", piece.text[:end]):
        yield piece
        return
    without = piece.replaced(re.compile(rf"P[ \t]*{DECIMAL}", re.IGNORECASE), lambda match: "", end)
    seconds = re.compile(rf"S[ \t]*({DECIMAL})", re.IGNORECASE)
    yield without.replaced(seconds, lambda match: f"P{Decimal(match[1]) * 1000:f}", _semicolon(without.text))


def one_command(piece: Piece) -> Iterator[Piece]:
    """Refuse a second command on the line, which the controller would take for a parameter and pass over."""
    found = list(_COMMAND.finditer(piece.text, 0, min(_semicolon(piece.text), _end_of_code(piece.text))))
    if len(found) > 1:
        what = "a line holds one command"
        raise piece.refused("several-commands", what, found[1].start(), found[1][0], "write them on two lines")
    yield piece


# programs of ISO controls


def program_name(piece: Piece) -> Iterator[Piece]:
    """Take the name of a program, after "%" or as :1234 or O1234 on a line of its own, for a comment."""
    match = _NAME.match(piece.text)
    if match is None:
        yield piece
    elif match[1]:
        at = piece.text.index("%")
        yield piece.cut(at, at + 1)
    else:
        text = f"({piece.text.strip()})"
        yield Piece(text, (piece.column(1),) * len(text))


def dwell_by_axis(piece: Piece) -> Iterator[Piece]:
    """Write the X, U or F of a dwell (seconds) as P; P itself is refused."""
    end = _end_of_code(piece.text)
    if _DWELL.search(piece.text, 0, end) is None:
        yield piece
        return
    at = piece.text.upper().find("P", 0, end)
    if at >= 0:
        what = "P of G04 is seconds on some controls and milliseconds on others"
        raise piece.refused("dwell", what, at, piece.text[at:], "write X and the seconds")
    seconds = re.compile(rf"[XUF][ \t]*({DECIMAL})", re.IGNORECASE)
    yield piece.replaced(seconds, lambda match: f"P{match[1]}", end)


def pointed(piece: Piece) -> Iterator[Piece]:
    """Refuse lengths and seconds without a point, which are in steps of the last digit on many controls; 0 is 0.

    R of G73 is how many passes it makes.
    """
    end = _end_of_code(piece.text)
    counts = "R" if _REPEATED.search(piece.text, 0, end) else ""
    found = _POINTLESS.finditer(piece.text, 0, end)
    match = next((one for one in found if one[0][0].upper() not in counts), None)
    if match is not None:
        what = "a number without a point is in the last digit's steps on this control, or in whole units by a setting"
        raise piece.refused("no-point", what, match.start(), match[0], "write the point")
    yield piece


# programs of QtPlasmaC


def without_height(piece: Piece) -> Iterator[Piece]:
    """Take Z out; a line that moves nothing else is left with its comments only, as QtPlasmaC's filter does it."""
    words, comments = _height_words(piece.text)
    if not words:
        yield piece
        return
    others = "".join(piece.text[begin:end] for begin, end in _outside(len(piece.text), [*words, *comments]))
    if not re.search(r"[XYABCUVW]", re.sub("<[^>]*>", "", others), re.IGNORECASE):
        words = _outside(len(piece.text), comments)
    blank = set().union(*(range(begin, end) for begin, end in words))
    text = "".join(" " if at in blank else character for at, character in enumerate(piece.text))
    yield Piece(text, piece.columns, piece.ends_chunk)


def _height_words(text: str) -> tuple[list[tuple[int, int]], list[tuple[int, int]]]:
    """Return where Z words with their values stand, and where comments."""
    words, comments, at = [], [], 0
    while at < len(text):
        begin = at
        if text[at] in "(;":
            at = text.find(")", at) + 1 if text[at] == "(" and ")" in text[at:] else len(text)
            comments.append((begin, at))
        elif text[at] == "<":
            at = text.find(">", at) + 1 or len(text)
        elif text[at] in "Zz":
            at = _end_of_value(text, at + 1)
            words.append((begin, at))
        else:
            at += 1
    return words, comments


def _end_of_value(text: str, at: int) -> int:
    """Return where a word's value ends: a number, or an expression with its brackets, or a parameter."""
    while at < len(text) and text[at] in " \t":
        at += 1
    if match := re.compile(rf"{DECIMAL}|#(?:<[^>]*>|[0-9]+)").match(text, at):
        return match.end()
    depth = 0
    while at < len(text) and (depth or text[at] == "["):
        depth += {"[": 1, "]": -1}.get(text[at], 0)
        at += 1
    return at


def _outside(length: int, spans: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Return what of [0, length) lies between the spans."""
    ends = [0, *(end for _, end in sorted(spans))]
    begins = [*(begin for begin, _ in sorted(spans)), length]
    return [(end, begin) for end, begin in zip(ends, begins, strict=True) if end < begin]


def _semicolon(text: str) -> int:
    """Return where a comment after ";" begins, or the end."""
    at = text.find(";")
    return at if at >= 0 else len(text)


def _end_of_code(text: str) -> int:
    """Return where the first comment in parentheses begins, or the end."""
    at = text.find("(")
    return at if at >= 0 else len(text)


STEPS: dict[str, Callable[[Piece], Iterator[Piece]]] = {
    step.__name__: step
    for step in (
        records,
        dotless,
        feed_per_second,
        semicolons,
        checksum,
        texts,
        dwell_in_seconds,
        one_command,
        program_name,
        dwell_by_axis,
        pointed,
        without_height,
    )
}
VALUE_STEPS = frozenset(("dotless", "feed_per_second", "dwell_in_seconds", "dwell_by_axis"))  # they change numbers
