# SPDX-License-Identifier: LGPL-2.1-or-later
"""What an editing verb gives back: the new text, where its lines come from, and the difference as a person reads it."""

from __future__ import annotations

import difflib
from dataclasses import dataclass

from CNCStepper.gcode.syntax.words import program_lines


@dataclass(frozen=True)
class Edited:
    """A program before and after an edit. origins: for each line of the new text its old line, from 1."""

    before: str
    text: str
    origins: tuple[int, ...]

    @property
    def changes(self) -> int:
        """How many lines of the new text are changed or new."""
        old = program_lines(self.before)
        new = zip(program_lines(self.text), self.origins, strict=True)
        return sum(line != old[origin - 1] for line, origin in new)

    def diff(self, name: str = "program", context: int = 1) -> str:
        """Return the unified difference."""
        old, new = program_lines(self.before), program_lines(self.text)
        lines = difflib.unified_diff(old, new, name, f"{name} (edited)", lineterm="", n=context)
        return "".join(f"{line}\n" for line in lines)


class Lines:
    """The lines of a program, each with how it ends, so that a new text ends them in the same way."""

    def __init__(self, text: str):
        self.text = text
        self.lines = program_lines(text)
        self._mark = "\ufeff" if text.startswith("\ufeff") else ""
        self._end = next((end for end in ("\r\n", "\n", "\r") if end in text), "\n")
        self._last = self._end if text.endswith(("\n", "\r")) else ""

    def edited(self, lines: list[str], origins: list[int] | None = None) -> Edited:
        """Return the edit with `lines` in place of all lines; without `origins` each keeps its number."""
        places = origins if origins is not None else list(range(1, len(lines) + 1))
        body = self._end.join(lines) + (self._last if lines else "")
        return Edited(self.text, self._mark + body, tuple(places))
