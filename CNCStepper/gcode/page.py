# SPDX-License-Identifier: LGPL-2.1-or-later
"""The page that a writer fills: words in their modal order, nothing repeated, every line checked.

It knows what the machine holds after each line: position in counts of the last digit, motion, feed, plane.
"""

from __future__ import annotations

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.ascii import COMMENT_WIDTH, ascii_text, comment_lines
from CNCStepper.gcode.codes import AXES, MOTION_NAMES
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.grid import Grid
from CNCStepper.toolpath import PLANE_AXES, RAPID, XY

PLANE_CODES = ("G17", "G18", "G19")
CENTRES = "IJK"


class Page:
    """The lines written so far and the modal words in force; `at` is None on axes never written."""

    def __init__(self, dialect: Dialect, grid: Grid):
        self.dialect = dialect
        self.grid = grid
        self.lines: list[str] = []
        self.own_comments: set[str] = set()
        self.at: list[int | None] = [None, None, None]
        self._motion = ""
        self._feed = ""
        self._plane = XY
        self._stale: set[int] = set()  # axes whose next word is written even where nothing changes

    def text(self) -> str:
        """Return the program."""
        return "".join(f"{line}\n" for line in self.lines)

    def line(self, *words: str) -> None:
        """Write words as one line; raises ProgramError where it is longer than the controller's buffer."""
        line = " ".join(word for word in words if word)
        if self.dialect.line_limit and len(line) >= self.dialect.line_limit:
            limit = f"{self.dialect.line_limit - 1} characters"
            raise ProgramError("line-too-long", "a line does not fit the controller's buffer", value=line, limit=limit)
        if line:
            self.lines.append(line)

    def comment(self, text: str, own: bool = False) -> None:
        """Write a comment; one that the writer itself has written is not repeated."""
        for line in comment_lines(text):
            if own or line not in self.own_comments:
                self.lines.append(line)
            if own:
                self.own_comments.add(line)

    def message(self, text: str) -> None:
        """Write a message to the operator."""
        for line in comment_lines(f"MSG, {text}"):
            self.lines.append(line if line.startswith("(MSG,") else f"(MSG, {line[1:]}")

    def stop(self, code: str, message: str = "") -> None:
        """Write a pause with its message on the same line."""
        text = ascii_text(message)[: COMMENT_WIDTH - 8]
        self.line(code)
        if text:
            self.lines[-1] += f" (MSG, {text})"
        self.forget()

    def forget(self) -> None:
        """Let the next move write all its words, since somebody may have moved the machine."""
        self._motion, self._feed, self._stale = "", "", {0, 1, 2}

    def move(self, kind: int, end: list[int | None], feed_mm_min: float = 0.0) -> None:
        """Write a straight move; nothing where it leads nowhere."""
        axes = self._axes(end)
        if axes:
            self.line(self._motion_word(kind), *axes, self._feed_word(kind, feed_mm_min))
            self._arrive(end)

    def arc(
        self, kind: int, end: list[int | None], offset: tuple[int, int], plane: int, feed_mm_min: float, turns: int
    ) -> None:
        """Write an arc with its centre at begin + `offset`; the words of its plane are written always."""
        self.select_plane(plane)
        first, second, _ = PLANE_AXES[plane]
        self._stale |= {first, second}
        axes = self._axes(end)
        centre = {first: offset[0], second: offset[1]}
        words = [f"{CENTRES[axis]}{self.grid.text(centre[axis])}" for axis in sorted(centre)]
        self._motion = MOTION_NAMES[kind]
        self.line(self._motion, *axes, *words, f"P{turns}" if turns > 1 else "", self._feed_word(kind, feed_mm_min))
        self._arrive(end)

    def select_plane(self, plane: int) -> None:
        """Write the plane word where it is not in force."""
        if plane != self._plane:
            self.line(PLANE_CODES[plane])
            self._plane = plane

    def _axes(self, end: list[int | None]) -> list[str]:
        return [
            f"{AXES[axis]}{self.grid.text(count)}"
            for axis, count in enumerate(end)
            if count is not None and (axis in self._stale or count != self.at[axis])
        ]

    def _motion_word(self, kind: int) -> str:
        name = MOTION_NAMES[kind]
        if name == self._motion:
            return ""
        self._motion = name
        return name

    def _feed_word(self, kind: int, feed_mm_min: float) -> str:
        if kind == RAPID:
            return ""
        word = f"F{self.grid.short(feed_mm_min)}"
        if word in ("F", "F0") or not feed_mm_min > 0:
            raise ProgramError("no-feed", "a cutting move has no feed", value=f"{feed_mm_min:g} mm/min")
        if word == self._feed:
            return ""
        self._feed = word
        return word

    def _arrive(self, end: list[int | None]) -> None:
        self.at = [count if count is not None else at for count, at in zip(end, self.at, strict=True)]
        self._stale -= {axis for axis, count in enumerate(end) if count is not None}
