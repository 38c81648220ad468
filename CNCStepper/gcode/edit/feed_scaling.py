# SPDX-License-Identifier: LGPL-2.1-or-later
"""Scales all feeds of a program: each F word is changed in place, an expression is put into brackets."""

from __future__ import annotations

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.edit.edit_result import Edited, Lines
from CNCStepper.gcode.edit.line_states import EXPAND
from CNCStepper.gcode.edit.line_tokens import Token, changed, tokens_of
from CNCStepper.gcode.edit.verification import require_same_path
from CNCStepper.gcode.edit.word_values import Value, decimals_of, feed_decimals
from CNCStepper.gcode.interpreter.flow.run_with_subroutines import run
from CNCStepper.gcode.interpreter.flow.subprogram_files import library_of
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID, Toolpath

DECIMALS = 3


def scale_feeds(
    text: str, factor: float, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = ""
) -> Edited:
    """Return the program with every feed times `factor`, also those of inverse time.

    Raises ProgramError for a factor not above 0, a program without F words, a feed that would round to 0, one that
    stands in another file, and one that is the lead of a thread.
    """
    if not factor > 0:
        advice = "give a factor above 0"
        raise ProgramError("edit-feed", "the factor must be above 0", value=f"{factor:g}", advice=advice)
    old = _read(text, dialect_named(dialect), start, file)
    _require_no_lead(old, dialect_named(dialect), file)
    source = Lines(text)
    lines = [_line(line, factor, Place(file, number)) for number, line in enumerate(source.lines, start=1)]
    if lines == source.lines and factor != 1.0:
        advice = "add one before the first cut"
        raise ProgramError("edit-feed", "the program has no F word", advice=advice, place=Place(file, 1))
    edited = source.edited(lines)
    new = interpret(edited.text, start, dialect, file)
    require_same_path(old, new, edited, file, factor)
    if (new.table().feed[new.table().kind != RAPID] <= 0).any():
        what, advice = "a feed would become 0", "give a larger factor"
        raise ProgramError("edit-feed", what, value=f"{factor:g}", place=Place(file, 1), advice=advice)
    return edited


def _read(text: str, dialect: Dialect, start: Start | None, file: str) -> Toolpath:
    """Return the moves of a program; raises ProgramError where a subroutine in another file has an F word."""
    reader, library = Interpreter(start, dialect, file), library_of(file, start)
    for _ in run(reader, text, library):
        pass
    for source in library.sources:
        for number, line in enumerate(source.lines, start=1):
            for token in tokens_of(line, source.file, number):
                if token.letter == "F":
                    what = "a subroutine in another file sets a feed: it is not edited with the program"
                    place = Place(source.file, number, token.begin + 1)
                    raise ProgramError("edit-flow", what, value=f"F{token.written}", advice=EXPAND, place=place)
    return reader.toolpath()


def _require_no_lead(path: Toolpath, dialect: Dialect, file: str) -> None:
    """Raise ProgramError for a program with a thread whose lead is an F word."""
    threads = [event for event in path.events if event.kind == "synchronised" and dialect.lead_word == "F"]
    if threads:
        what, advice = "F is the lead of the thread here, not a feed", "change the feeds of the other lines by hand"
        raise ProgramError("edit-feed", what, value="G32", advice=advice, place=Place(file, threads[0].line))


def _line(line: str, factor: float, place: Place) -> str:
    feeds = (token for token in tokens_of(line, place.file, place.line) if token.letter == "F")
    edits = [(token.first, token.last, _scaled(token, factor, place)) for token in feeds]
    return changed(line, edits) if edits else line


def _scaled(token: Token, factor: float, place: Place) -> str:
    decimals = max(DECIMALS, decimals_of(token.written) if token.number is not None else 0)
    decimals = feed_decimals(factor * (token.number or 0.0), decimals)
    text = Value.of(token, factor).text(decimals, token.written)
    if token.number and not text.strip("0."):
        what = "the feed would round to 0"
        there = Place(place.file, place.line, token.begin + 1)
        raise ProgramError("edit-feed", what, value=f"F{token.written}", place=there, advice="give a larger factor")
    return text
