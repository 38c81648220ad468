# SPDX-License-Identifier: LGPL-2.1-or-later
"""Find and replace, line by line, in the code alone or in comments too, as plain text or as a pattern.

Plain text that ends in a number is not found inside a longer one: F80 is no part of F800, G1 none of G1.5 or G17.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.edit.edit_result import Edited, Lines
from CNCStepper.gcode.edit.line_tokens import comment_spans
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.state import Start


def replace(
    text: str,
    find: str,
    new: str,
    pattern: bool = False,
    comments: bool = False,
    ignore_case: bool = False,
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
) -> Edited:
    """Return the program with `new` in place of each `find` within a line.

    pattern: `find` is a regular expression of Python, and `new` may name its groups. comments: look there too.
    Raises ProgramError for a pattern that is none, for text that is not found, and for a result that cannot be read.
    """
    search = _search(find, pattern, not comments, ignore_case)
    put: str | Callable[[re.Match[str]], str] = new if pattern else lambda match: new
    source = Lines(text)
    try:
        lines = [_line(line, search, put, comments) for line in source.lines]
    except (re.error, IndexError) as error:
        what = Text("the replacement cannot be made: {error}", error=error)
        advice = "name only groups that the pattern has, and write each backslash twice"
        raise ProgramError("edit-pattern", what, value=new[:40], advice=advice) from None
    if lines == source.lines:
        advice = "look at its case, or look in comments too"
        raise ProgramError(
            "edit-not-found", "the text is not found, or is the same already", value=find[:40], advice=advice
        )
    edited = _grown(source, lines)
    interpret(edited.text, start, dialect, file)
    return edited


def _grown(source: Lines, lines: list[str]) -> Edited:
    """Return the edit where lines have become several."""
    parts = [line.split("\n") for line in lines]
    origins = [number for number, part in enumerate(parts, start=1) for _ in part]
    return source.edited([line for part in parts for line in part], origins)


def _search(find: str, pattern: bool, code_only: bool, ignore_case: bool) -> re.Pattern[str]:
    if not find:
        raise ProgramError("edit-pattern", "there is nothing to find", advice="give the text to be replaced")
    expression = find if pattern else re.escape(find)
    if not pattern and code_only:
        expression = (r"(?<![0-9.])" if find[0] in "0123456789." else "") + expression
        expression += r"(?![0-9.])" if find[-1] in "0123456789." else ""
    try:
        return re.compile(expression, re.IGNORECASE if ignore_case else 0)
    except re.error as error:
        what, advice = Text("the pattern cannot be read: {error}", error=error), "correct it, or find it as plain text"
        raise ProgramError("edit-pattern", what, value=find[:40], advice=advice) from None


def _line(line: str, search: re.Pattern[str], put: str | Callable, comments: bool) -> str:
    """Return a line with all matches replaced, by default in the code alone."""
    if comments:
        return search.sub(put, line)
    made, at = [], 0
    for first, last in [*comment_spans(line), (len(line), len(line))]:
        made += [search.sub(put, line[at:first]), line[first:last]]
        at = last
    return "".join(made)
