# SPDX-License-Identifier: LGPL-2.1-or-later
"""The "%" that may open and close a program, as the marks at the two ends of a punched tape did."""

from __future__ import annotations

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.syntax.words import is_percent_mark


class PercentMarkers:
    """Whether a program has begun, by a mark or by its first line, and whether a mark has closed it."""

    def __init__(self) -> None:
        self.begun = self.opened_by_mark = self.closed = False

    @property
    def lacks_mark(self) -> bool:
        """Whether a mark opened the program and none closed it."""
        return self.opened_by_mark and not self.closed

    def is_mark(self, text: str, strict: bool) -> bool:
        """Whether a line is a mark; raises ProgramError where none is allowed.

        The first line opens the program by it, a later one closes it; a `strict` dialect closes only what was opened.
        """
        if not is_percent_mark(text):
            return False
        if not self.begun:
            self.begun = self.opened_by_mark = True
        elif self.opened_by_mark or not strict:
            self.closed = True
        else:
            place = Place(column=text.index("%") + 1)
            what = "% may stand only on the first and the last line"
            raise ProgramError("misplaced", what, value="%", advice="take it out", place=place)
        return True
