# SPDX-License-Identifier: LGPL-2.1-or-later
"""N words: every line with code gets the next number, or loses the one that it has."""

from __future__ import annotations

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.edit.edit_result import Edited, Lines
from CNCStepper.gcode.edit.line_tokens import Token, changed, tokens_of
from CNCStepper.gcode.edit.verification import require_same_path
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.syntax.words import split_line
from CNCStepper.state import Start


def renumber(
    text: str,
    first: int = 10,
    step: int = 10,
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
) -> Edited:
    """Return the program with N words from `first` in steps; lines without code, "%" and O-words get none.

    Raises ProgramError where a number is greater than the controller takes, or a line jumps to an N word.
    """
    if first < 0 or step < 1:
        what = "line numbers begin at 0 or above and grow"
        raise ProgramError("edit-number", what, value=f"{first}, {step}", advice="use 10 and 10")
    most = dialect_named(dialect).largest_line_number
    source, lines, number = Lines(text), [], first
    for place, line in enumerate(source.lines, start=1):
        numbered = _numbered(line, number, Place(file, place))
        if numbered is not None and number > most:
            what = "the program has too many lines for these numbers"
            advice = "begin lower or take smaller steps"
            raise ProgramError("edit-number", what, value=f"N{number}", limit=f"N{most}", advice=advice)
        number += step * (numbered is not None)
        lines.append(line if numbered is None else numbered)
    return _checked(source.edited(lines), dialect, start, file)


def without_numbers(text: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = "") -> Edited:
    """Return the program without N words; raises ProgramError where a line jumps to one."""
    source = Lines(text)
    lines = [_bare(line, Place(file, place)) for place, line in enumerate(source.lines, start=1)]
    return _checked(source.edited(lines), dialect, start, file)


def _numbered(line: str, number: int, place: Place) -> str | None:
    """Return a line with its number, None where it takes none."""
    tokens = _tokens(line, place)
    own = next((token for token in tokens if token.letter == "N"), None)
    if own is not None:
        return changed(line, [(own.first, own.last, str(number))])
    code = split_line(line).code
    if not code.strip() or code.strip()[0] in "%oO":
        return None
    at = len(code) - len(code.lstrip())
    if line[at] == "/":
        at += 1
    return changed(line, [(at, at, f"N{number} ")])


def _bare(line: str, place: Place) -> str:
    own = [token for token in _tokens(line, place) if token.letter == "N"]
    if not own:
        return line
    last = own[0].last
    while last < len(line) and line[last] in " \t":
        last += 1
    return changed(line, [(own[0].begin, last, "")])


def _tokens(line: str, place: Place) -> list[Token]:
    tokens = tokens_of(line, place.file, place.line)
    names = {token.name for token in tokens}
    if "M99" in names and "P" in names:
        what = "the line jumps to a line number"
        raise ProgramError("edit-number", what, value="M99 P", place=place, advice="renumber by hand")
    return tokens


def _checked(edited: Edited, dialect: str | Dialect, start: Start | None, file: str) -> Edited:
    old, new = (interpret(text, start, dialect, file) for text in (edited.before, edited.text))
    require_same_path(old, new, edited, file)
    return edited
