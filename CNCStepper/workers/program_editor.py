# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process that reads a program while it is typed: `python -m CNCStepper.workers.program_editor FOLDER`.

Each line on standard input is a question in JSON, each line on standard output an answer; a question that changes the
text ends the work on the text before.

    {"as": {"dialect": "", "file": "", "machine": true}}   how to read; machine.json and start.json stand in FOLDER
    {"text": "program.nc", "mark": 1}                      the whole text, a file in FOLDER
    {"change": [first, removed, [line, ...]], "mark": 2}   lines from `first` (counted from 0) give way to others
    {"line": 12}                                           what holds after a line, and the way that it makes
    {"pick": {"matrix": [[...]], "size": [w, h], "at": [x, y]}}   which line's way lies there in the picture
    {"place": {"matrix": ...}}                             which place of the cuts lies there
    {"contours": true}                                     by what the places of a restart can be named
    {"edit": {"verb": "offset", "values": {"x_mm": 5}}}    what an editing verb would make of it (`edit_verbs`)

    {"read": 2, "lines": n, "refused": k, "refusals": [...]}   for the newest text; a refusal as `error_to_json`, and
                                                               "length", how many characters of its line are meant
    {"timed": 2, "duration_s": s, "path": "path-2.npz"}        then the times, and lines for the 3D view
    {"sendable": 2, "refusals": [...]}                         of a good one, what only fails when it is sent
    {"line": 12, ...}  {"pick": 12 or null}  {"place": [x, y, z] or null}
    {"contours": [...], "operations": [...], ...}              as `place_list` tells them
    {"edited": 2, "text": "edited-2.nc", "diff": [line, ...], "more": 0, "changes": n}   or "error_of_edit"
    what cannot be answered           {"error": {...}}, and the process ends with exit status 1

Places are counted as the text has them, lines and columns from 1. When standard input is closed the process ends.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from queue import Empty
from typing import Any

from CNCStepper.job.editing.line_analysis import Abandoned
from CNCStepper.workers.json_lines import Questions, serve, tell

CHANGES = ("as", "text", "change")


def main(arguments: list[str]) -> int:
    """Answer what standard input asks about texts in the folder `arguments[0]`; return the exit status."""
    folder = Path(arguments[0])
    return serve(lambda questions: Answers(folder, questions, tell).run(), "editor-fault", "the reading")


class Answers:
    """The text as the editor has it, and what was found out about it."""

    def __init__(self, folder: Path, questions: Questions, tell: Callable[[dict[str, Any]], None]):
        from CNCStepper.workers.program_document import ProgramText

        self._questions, self._tell = questions, tell
        self._waiting: list[dict[str, Any]] = []
        self._text = ProgramText(folder)

    def run(self) -> None:
        """Answer for ever."""
        while True:
            self.step()

    def step(self) -> None:
        """Take what is asked, changes first, and answer it; wait where nothing is asked."""
        self._take(wait=not self._waiting and not self._text.unfinished)
        try:
            if self._text.unfinished:
                self._text.go_on(self._tell, self._newest())
        except Abandoned:
            return
        if self._waiting:
            self._tell(self._text.answer(self._waiting.pop(0)))

    def _take(self, wait: bool = False) -> None:
        """Heed the changes that are asked for, and keep the other questions, of each kind the newest."""
        try:
            while True:
                self._put(self._questions.get() if wait else self._questions.get_nowait())
                wait = False
        except Empty:
            pass

    def _put(self, question: dict[str, Any]) -> None:
        kind = next(iter(question))
        if kind in CHANGES:
            self._text.change(question)
        else:
            self._waiting = [other for other in self._waiting if kind not in other] + [question]

    def _newest(self) -> Callable[[], bool]:
        """Return what tells whether the present text is still the newest one; questions about it then wait."""
        version = self._text.version

        def is_newest() -> bool:
            self._take()
            return self._text.version == version

        return is_newest


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
