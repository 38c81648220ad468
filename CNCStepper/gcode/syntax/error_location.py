# SPDX-License-Identifier: LGPL-2.1-or-later
"""The location of an error: the faulty word, its column, the controller's own answer."""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.errors import Place, ProgramError, Text, joined
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import ARC_WORDS, AXES
from CNCStepper.gcode.syntax.words import Word


def located_error(error: ProgramError, words: list[Word], dialect: Dialect, at: Callable[[int], Place]) -> ProgramError:
    """Return the error of a line of `words`, complete; `at` gives the place of a column."""
    column = error.place.column if error.place else 0
    word = _word(error.value, words)
    answer = dialect.errors.get(error.code)
    answers = Text("{dialect} answers {answer}", dialect=dialect.title, answer=answer) if answer else ""
    return ProgramError(
        error.code,
        error.what,
        advice=joined("; ", filter(None, (error.advice, answers))),
        value=word.text if word and column == 0 else error.value,
        limit=error.limit,
        place=at(column or (word.column if word else 1)),
    )


def _word(name: str, words: list[Word]) -> Word | None:
    """Return the last word called `name`; a modal motion is not on its line, its first coordinate is."""
    named = [word for word in words if name and name in (word.name, word.letter)]
    coordinates = [word for word in words if word.letter in AXES + ARC_WORDS]
    return next(iter(named[-1:] or coordinates[:1] or words[:1]), None)
