# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines that were typed, brought back one by one as the arrow keys of a console do: no Qt, no FreeCAD."""

from __future__ import annotations

KEPT = 200


class History:
    """The newest lines and the place among them, with the line begun and not sent."""

    def __init__(self) -> None:
        self._lines: list[str] = []
        self._at = 0
        self._begun = ""

    def add(self, line: str) -> None:
        """Take a line that was sent; one that is sent again is kept once."""
        if line not in self._lines[-1:]:
            self._lines = [*self._lines, line][-KEPT:]
        self._at, self._begun = len(self._lines), ""

    def older(self, shown: str) -> str:
        """Return the line before the one that is shown, the first of all again and again."""
        if self._at == len(self._lines):
            self._begun = shown
        self._at = max(self._at - 1, 0)
        return self._lines[self._at] if self._lines else shown

    def newer(self, shown: str) -> str:
        """Return the line after the one that is shown, at the end what was begun."""
        if self._at == len(self._lines):
            return shown
        self._at += 1
        return self._lines[self._at] if self._at < len(self._lines) else self._begun
