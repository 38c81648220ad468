# SPDX-License-Identifier: LGPL-2.1-or-later
"""From a program file to the wire text: exactly the lines that are sent, and the way back to the file's lines.

No comments, blank lines, "%", N words or blanks; upper case, shortest numbers, plain ASCII; each line fits the
controller's buffer and holds no byte that acts where it stands; the first move names its motion (`first_motion.py`).
Read by the interpreter, the wire text gives the same moves and states as the file. Line numbers and checksums of Marlin
belong to the link, as does the "?" that ends what is sent to the mini-lathe.
"""

from __future__ import annotations

from array import array
from collections.abc import Iterator

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.expand import expanded, is_expanded
from CNCStepper.gcode.first_motion import bare_first_move, with_first_motion
from CNCStepper.gcode.flow_lines import is_plain
from CNCStepper.gcode.front import Piece, pieces
from CNCStepper.gcode.take_up import with_take_up
from CNCStepper.gcode.wire_lines import WireLines
from CNCStepper.gcode.wire_records import Records
from CNCStepper.gcode.wire_runs import WireRun, wire_runs
from CNCStepper.gcode.wire_text import WireText, check_wire_line
from CNCStepper.gcode.words import Comment, Word, is_tape_mark, split_line, words_of
from CNCStepper.machine.play import Play
from CNCStepper.state import Start

ENDS = frozenset(("M2", "M30"))
Wire = tuple[int, list[Comment], str, int]  # number of a line, its comments, what is sent, its first column


def prepare(
    text: str,
    dialect: str | Dialect = "grbl",
    file: str = "",
    start: Start | None = None,
    play: Play | None = None,
) -> WireText:
    """Return the wire text of a program; raises ProgramError naming file, line, column for what cannot be sent.

    Loops, subroutines and expressions are written out, where lines are sent one by one, as they run from `start`; a
    controller that reads the file itself keeps them. play: of the axes, to be taken up from `start` on (`play_of`).
    """
    language = dialect_named(dialect)
    wire = _wire_text(text, language, file, start)
    return with_take_up(wire, play, language, start, file) if play else wire


def _wire_text(text: str, language: Dialect, file: str, start: Start | None) -> WireText:
    lines = bytearray()
    file_lines = array("i")
    messages: dict[int, str] = {}
    waiting: list[str] = []
    wires = _expanded(text, language, start, file) if is_expanded(text, language) else _lines(text, language, file)
    for found in wires:
        if isinstance(found, WireRun):
            if waiting and found.lines:
                messages[len(file_lines)] = "\n".join(waiting)
                waiting = []
            lines += found.lines
            file_lines.frombytes(found.numbers.astype(np.intc).tobytes())
            continue
        number, comments, wire, column = found
        waiting += [comment.text.strip() for comment in comments if comment.message]
        if not wire:
            continue
        check_wire_line(wire, language, Place(file, number, column))
        if waiting:
            messages[len(file_lines)] = "\n".join(waiting)
            waiting = []
        lines += f"{wire}\n".encode("ascii")
        file_lines.append(number)
    return _whole_text(WireLines(bytes(lines)), np.array(file_lines, np.int32), messages, language, file)


def _whole_text(
    lines: WireLines, file_lines: np.ndarray, messages: dict[int, str], language: Dialect, file: str
) -> WireText:
    """Return the lines with the motion of the first move named."""
    index = bare_first_move(lines, language)
    if index is not None:
        lines = with_first_motion(lines, index, language)
        check_wire_line(lines[index], language, Place(file, int(file_lines[index])))
    return WireText(lines, file_lines, messages)


def _lines(text: str, language: Dialect, file: str) -> Iterator[WireRun | Wire]:
    """Yield the lines that a controller is to see."""
    begun, records = False, Records(language)
    for run in wire_runs(text, language):
        if isinstance(run, WireRun):
            begun = begun or run.begins
            yield run
            continue
        number, raw = run
        comments: list[Comment] = []
        blocks: list[list[Word]] = []
        try:
            found = pieces(raw, language, as_written=True)
            if any(is_tape_mark(piece.text) for piece in found):
                if begun:
                    return
                begun = True
                continue
            if language.reads_files and not is_plain(raw):
                yield number, [], _code(raw, language), 1
                continue
            for piece in found:
                line = split_line(piece.text, language.strict_comments)
                if not (line.deleted and language.skips_deleted):
                    comments += line.comments
                    blocks.append(_words(line.code, piece))
            wire = records.wire(blocks) if records.are_used else "".join(map(_short, _sent(blocks)))
        except ProgramError as error:
            column = error.place.column if error.place else 0
            raise error.at(Place(file, number, column)) from None
        begun = begun or bool(comments) or any(blocks)
        yield number, comments, wire, min((word.column for block in blocks for word in block), default=1)
        if language.stops_at_end and any(word.name in ENDS for block in blocks for word in block):
            return


def _expanded(text: str, language: Dialect, start: Start | None, file: str) -> Iterator[Wire]:
    """Yield the same of a program that is written out."""
    for line, words, comments in expanded(text, language, start, file):
        yield (
            line,
            list(comments),
            "".join(map(_short, _sent([words]))),
            min((word.column for word in words), default=1),
        )


def _words(code: str, piece: Piece) -> list[Word]:
    """Return the words of a piece, with their columns in the line."""
    try:
        words = words_of(code)
    except ProgramError as error:
        place = error.place or Place()
        raise error.at(Place(place.file, place.line, piece.column(place.column))) from None
    return [word._replace(column=piece.column(word.column)) for word in words]


def _code(raw: str, language: Dialect) -> str:
    """Return a line that computes or leads elsewhere as it stands, without its comments."""
    return " ".join(split_line(raw, language.strict_comments).code.split())


def _sent(blocks: list[list[Word]]) -> Iterator[Word]:
    return (word for block in blocks for word in block if word.letter != "N")


def _short(word: Word) -> str:
    """Return a word with the shortest form of its number."""
    sign = "-" if word.number.startswith("-") else ""
    whole, _, rest = word.number.lstrip("+-").partition(".")
    whole, rest = whole.lstrip("0") or "0", rest.rstrip("0")
    number = f"{whole}.{rest}" if rest else whole
    return word.letter + (number if number == "0" else sign + number)
