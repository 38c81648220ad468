# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes the wire text of a program file: exactly the lines that are sent, with their lines in the file.

No comments, blank lines, "%", N words or blanks; upper case, shortest numbers, plain ASCII; each line fits the
controller's buffer and has no real-time byte; the first move names its motion (`wire_text.py`).
Read by the interpreter, the wire text gives the same moves and states as the file. Line numbers and checksums of Marlin
belong to the link, as does the "?" that ends a transfer to the mini-lathe.

The wire text of a language of records: each record whole, so that a chunk may begin at any of them.

    G01 X-10. F1. # Z-50. #   ->   G01X-10.F1.#G01Z-50.F1.#
    G90 # G00 X5. Z8. # X3. # ->   G90#G00X5.Z8.#G00X3.Z8.#

The mini-lathe has no acknowledgement and a buffer of unknown size, so that a sender ends chunks with "?" where it
likes; each must open with its G word. Numbers stay as they are written: without its point a number is another one. In
absolute mode the control drives an axis without a word to 0: the word where it stands is added, or the record refused.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterable, Iterator

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.preprocessor import Piece, pieces
from CNCStepper.gcode.interpreter.flow.flow_line_parser import is_plain
from CNCStepper.gcode.syntax.words import Comment, Word, is_percent_mark, split_line, words_of
from CNCStepper.gcode.wire.backlash_compensation import with_backlash_compensation
from CNCStepper.gcode.wire.expansion import Block, expanded, is_expanded
from CNCStepper.gcode.wire.line_runs import WireRun, wire_runs
from CNCStepper.gcode.wire.wire_text import (
    FirstFeed,
    FirstMove,
    WireLines,
    WireText,
    check_wire_line,
    with_first_feed,
    with_first_motion,
)
from CNCStepper.machine.backlash import Backlash
from CNCStepper.state import Start

AXES = "XZ"


class Records:
    """Follows from record to record the motion, its F, and in absolute mode the axis positions."""

    def __init__(self, dialect: Dialect):
        self.are_used = "records" in dialect.front
        self._codes = dialect.codes
        self._absolute = dialect.distance == "absolute"
        self._motion: Word | None = None
        self._feed: Word | None = None
        self._at: dict[str, Word] = {}

    def wire(self, blocks: list[list[Word]]) -> str:
        """Return the records of one line; raises ProgramError where an axis of an absolute one is nowhere named."""
        records = ([word for word in block if word.letter != "N"] for block in blocks)
        return "".join(f"{self._record(words)}#" for words in records if words)

    def _record(self, words: list[Word]) -> str:
        self._follow(words)
        if not any(word.letter in AXES for word in words):
            return "".join(word.text for word in words)
        if self._absolute:
            words = self._with_both_axes(words)
        opens = any(self._group(word) == "motion" for word in words)
        has_feed = any(word.letter == "F" for word in words)
        before = [self._motion] if self._motion and not opens else []
        after = [self._feed] if self._feed and not has_feed else []
        return "".join(word.text for word in (*before, *words, *after))

    def _follow(self, words: list[Word]) -> None:
        """Note the modes that a record sets."""
        for word in words:
            group = self._group(word)
            if group == "motion":
                self._motion, self._feed = word, None
            elif group:
                self._motion = None
                self._at = {}  # other units or a distance mode: the words mean something else
            if group == "distance":
                self._absolute = self._codes[word.name].sets["distance"] == "absolute"
        self._feed = next((word for word in words if word.letter == "F"), self._feed)

    def _with_both_axes(self, words: list[Word]) -> list[Word]:
        self._at |= {word.letter: word for word in words if word.letter in AXES}
        named = next(word for word in words if word.letter in AXES)
        for axis in AXES:
            if axis not in self._at:
                what = "in absolute mode the control drives an axis without a word to 0"
                place = Place(column=named.column)
                raise ProgramError("absent-axis", what, value=named.text, advice="name both axes", place=place)
        others = [word for word in words if word.letter not in AXES]
        codes = [word for word in others if word.letter in "GM"]
        return [*codes, *(self._at[axis] for axis in AXES), *(word for word in others if word not in codes)]

    def _group(self, word: Word) -> str:
        code = self._codes.get(word.name) if word.letter in "GM" else None
        return code.group if code else ""


ENDS = frozenset(("M2", "M30"))
MOST_MESSAGE = 4000  # characters of the messages at one line: some fifty lines of text
CUT = "…\n"  # stands before the end of a longer one
Wire = tuple[int, list[Comment], str, int]  # number of a line, its comments, its wire text, its first column


def prepare(
    text: str,
    dialect: str | Dialect = "grbl",
    file: str = "",
    start: Start | None = None,
    play: Backlash | None = None,
) -> WireText:
    """Return the wire text of a program; raises ProgramError naming file, line, column for what cannot be sent.

    Loops, subroutines and expressions are written out, where lines are sent one by one, as they run from `start`; a
    controller that reads the file itself keeps them. play: of the axes, to be taken up from `start` on (`backlash_of`).
    """
    language = dialect_named(dialect)
    wire = _wire_text(text, language, file, start)
    return with_backlash_compensation(wire, play, language, start, file) if play else wire


def _wire_text(text: str, language: Dialect, file: str, start: Start | None) -> WireText:
    encoder = WireEncoder(language, file)
    if is_expanded(text, language):
        lines, file_lines = encoder.join(_expanded(text, language, start, file))
    else:
        lines, file_lines = encoder.encode(wire_runs(text, language))
    return WireText(encoder.started(WireLines(lines), file_lines), file_lines, encoder.messages)


class WireEncoder:
    """Turns the lines of a program, in their order, into those that are sent; a long program comes in pieces.

    messages: of the lines that were made last, index of a line -> what to tell the operator before it runs, the end of
    it where it is longer than a person reads at a pause.
    """

    def __init__(self, language: Dialect, file: str):
        self._language, self._file = language, file
        self._records = Records(language)
        self._begun = self._over = False  # after this word or comment nothing is sent
        self._first_move = FirstMove(language)
        self._first_feed = FirstFeed(language)
        self._waiting = ""  # messages for the next line
        self.messages: dict[int, str] = {}

    def encode(self, runs: Iterable[WireRun | tuple[int, str]]) -> tuple[bytes, np.ndarray]:
        """Return the wire text of further lines, each with its newline, and the line of the file of each, int32[n].

        Raises ProgramError naming file, line, column for what cannot be sent.
        """
        return self.join(self._lines(runs))

    def started(self, lines: WireLines, file_lines: np.ndarray) -> WireLines:
        """Return encoded lines, with the motion and feed that the first ones lack, where they are among them.

        The program's first move names its motion, and its first cut a feed.
        """
        index = self._first_move.without_motion(lines)
        if index is not None:
            lines = with_first_motion(lines, index, self._language)
            check_wire_line(lines[index], self._language, Place(self._file, int(file_lines[index])))
        missing = self._first_feed.missing(lines)
        if missing is not None:
            lines = with_first_feed(lines, *missing)
            check_wire_line(lines[missing[0]], self._language, Place(self._file, int(file_lines[missing[0]])))
        return lines

    def join(self, wires: Iterable[WireRun | Wire]) -> tuple[bytes, np.ndarray]:
        """Return the same of lines that are written out already."""
        lines, file_lines = bytearray(), array("i")
        self.messages = {}
        for found in wires:
            if isinstance(found, WireRun):
                if found.lines:
                    self._notify_at(len(file_lines))
                lines += found.lines
                file_lines.frombytes(found.numbers.astype(np.intc).tobytes())
                continue
            number, comments, wire, column = found
            for comment in comments:
                if comment.message:
                    self._keep(comment.text.strip())
            if not wire:
                continue
            check_wire_line(wire, self._language, Place(self._file, number, column))
            self._notify_at(len(file_lines))
            lines += f"{wire}\n".encode("ascii")
            file_lines.append(number)
        return bytes(lines), np.array(file_lines, np.int32)

    def _keep(self, message: str) -> None:
        """Keep a message until the next line that is sent; of many messages the last."""
        waiting = f"{self._waiting}\n{message}" if self._waiting else message
        self._waiting = waiting if len(waiting) <= MOST_MESSAGE else CUT + waiting[len(CUT) - MOST_MESSAGE :]

    def _notify_at(self, index: int) -> None:
        if self._waiting:
            self.messages[index], self._waiting = self._waiting, ""

    def _lines(self, runs: Iterable[WireRun | tuple[int, str]]) -> Iterator[WireRun | Wire]:
        """Yield the lines that a controller is to see."""
        for run in runs:
            if self._over:
                return
            if isinstance(run, WireRun):
                self._begun = self._begun or run.begins
                yield run
            else:
                yield from self._line(*run)

    def _line(self, number: int, raw: str) -> Iterator[Wire]:
        """Yield the part of a line that a controller gets."""
        language = self._language
        comments: list[Comment] = []
        blocks: list[list[Word]] = []
        try:
            found = pieces(raw, language, as_written=True)
            if any(is_percent_mark(piece.text) for piece in found):
                self._over, self._begun = self._begun, True
                return
            if language.reads_files and not is_plain(raw):
                yield number, [], _code(raw, language), 1
                return
            for piece in found:
                line = split_line(piece.text, language.strict_comments)
                if not (line.deleted and language.skips_deleted):
                    comments += line.comments
                    blocks.append(_words(line.code, piece))
            records = self._records
            wire = records.wire(blocks) if records.are_used else _shortened(blocks, language)
        except ProgramError as error:
            column = error.place.column if error.place else 0
            raise error.at(Place(self._file, number, column)) from None
        self._begun = self._begun or bool(comments) or any(blocks)
        yield number, comments, wire, min((word.column for block in blocks for word in block), default=1)
        if language.stops_at_end and any(word.name in ENDS for block in blocks for word in block):
            self._over = True


def _expanded(text: str, language: Dialect, start: Start | None, file: str) -> Iterator[Wire]:
    """Yield the same of a program that is written out."""
    for block in expanded(text, language, start, file):
        yield wire_of_block(block, language)


def wire_of_block(block: Block, language: Dialect) -> Wire:
    """Return the wire text of an expanded block, "" for nothing."""
    column = min((word.column for word in block.words), default=1)
    return block.line, list(block.comments), _shortened([block.words], language), column


def _words(code: str, piece: Piece) -> list[Word]:
    """Return the words of a piece, with their columns in the line."""
    try:
        words = words_of(code)
    except ProgramError as error:
        place = error.place or Place()
        raise error.at(Place(place.file, place.line, piece.column(place.column))) from None
    return [word._replace(column=piece.column(word.column)) for word in words]


def _code(raw: str, language: Dialect) -> str:
    """Return a line that computes or leads elsewhere as it is, without its comments."""
    return " ".join(split_line(raw, language.strict_comments).code.split())


def _shortened(blocks: list[list[Word]], language: Dialect) -> str:
    """Return the words that are sent, each with the shortest form of its number.

    N words stay where cycles name the blocks of their profile by them.
    """
    pointed, left_out = "pointed" in language.front, "" if language.two_block_cycles else "N"
    sent = (word for block in blocks for word in block if word.letter != left_out)
    return "".join(_short(word, pointed) for word in sent)


def _short(word: Word, pointed: bool) -> str:
    """Return a word with the shortest form of its number; pointed: without its point it would be another one."""
    sign = "-" if word.number.startswith("-") else ""
    whole, _, rest = word.number.lstrip("+-").partition(".")
    whole, rest = whole.lstrip("0") or "0", rest.rstrip("0")
    number = f"{whole}.{rest}" if rest or (pointed and whole != "0" and "." in word.number) else whole
    return word.letter + (number if number == "0" else sign + number)
