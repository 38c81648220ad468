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

The text of a program that is being edited, read again after each change.
"""

from __future__ import annotations

import json
import math
import re
import sys
from collections.abc import Callable
from pathlib import Path
from queue import Empty
from typing import Any

import numpy as np

from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError, ProgramError, Text
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.job.editing.line_analysis import Abandoned, Reading, read_program, unsendable
from CNCStepper.job.editing.path_segments import Picture
from CNCStepper.job.start_state_file import read_start
from CNCStepper.machine.profile import Machine, validated
from CNCStepper.motion.planner.backlash_moves import row_times_s
from CNCStepper.motion.planner.plan import begun
from CNCStepper.recovery.restart.description import contours_as_data
from CNCStepper.state import Start, State
from CNCStepper.workers.json_lines import Questions, serve, tell

Tell = Callable[[dict[str, Any]], None]
GoOn = Callable[[], bool]
STATE = ("units", "distance", "arc_centres", "plane", "feed_mode", "work_system", "tool", "spindle", "spindle_rpm")
MACHINE = "machine.json"
MOST_DIFF_LINES = 2000  # of a difference, which is shown to a person
_WORD = re.compile(r"[A-Za-z@^$#]?[ \t]*[^A-Za-z\s(;]*")


class ProgramText:
    """The lines as the editor has them, `mark` for mark, and the answers about them."""

    def __init__(self, folder: Path):
        self._folder = folder
        self.lines: list[str] = []
        self.dialect, self.file = "grbl", ""
        self.machine: Machine | None = None
        self.start: Start | None = None
        self.mark = self.version = 0  # of the text as the editor counts, and of all that was ever changed
        self._reading: Reading | None = None
        self._ends_s: np.ndarray | None = None
        self._picture: Picture | None = None
        self._todo: list[Callable[[Tell, GoOn], None]] = []

    @property
    def unfinished(self) -> bool:
        """Whether something about the newest text is still to be found out."""
        return bool(self._todo)

    def change(self, question: dict[str, Any]) -> None:
        """Take a new text, a change of it, or how it is to be read."""
        if "as" in question:
            self._read_as(**question["as"])
        elif "text" in question:
            self.lines = program_lines((self._folder / question["text"]).read_bytes().decode("utf-8", "surrogatepass"))
        else:
            first, removed, lines = question["change"]
            self.lines[first : first + removed] = lines
        self.mark = question.get("mark", self.mark)
        self.version += 1
        self._todo = [self._read, self._time]

    def go_on(self, tell: Tell, go_on: GoOn) -> None:
        """Compute the next result and report it; raises Abandoned when a newer text has come."""
        self._todo[0](tell, go_on)
        if not go_on():
            raise Abandoned
        self._todo.pop(0)

    def answer(self, question: dict[str, Any]) -> dict[str, Any]:
        """Return the answer to a question about the text."""
        if "line" in question:
            return self._line(int(question["line"]))
        if "pick" in question:
            return {"pick": self._picture.pick(**question["pick"]) if self._picture else None}
        if "place" in question:
            return {"place": self._picture.pick_mm(**question["place"]) if self._picture else None}
        if "contours" in question:
            return contours_as_data(self.lines, self.dialect, self.start, self.file)
        if "edit" in question:
            return self._edit(**question["edit"])
        what = "nothing is known that could be asked so"
        advice = Text("use one of: {known}", known=", ".join(("line", "pick", "place", "contours", "edit")))
        raise CNCStepperError("editor-question", what, value=str(question)[:80], advice=advice)

    def _read_as(self, dialect: str, file: str, machine: bool) -> None:
        self.dialect, self.file = dialect, file
        self.start = read_start(self._folder)
        path = self._folder / MACHINE
        self.machine = validated(Machine, json.loads(path.read_text("utf-8")), str(path)) if machine else None

    def _read(self, tell: Tell, go_on: GoOn) -> None:
        self._reading = self._ends_s = self._picture = None
        self._reading = read_program(self.lines, self.start, self.dialect, self.file, go_on)
        tell(
            {
                "read": self.mark,
                "lines": len(self.lines),
                "refused": self._reading.refused,
                "refusals": [self._told(error) for error in self._reading.refusals],
            }
        )

    def _time(self, tell: Tell, go_on: GoOn) -> None:
        """Answer with the time that it takes, and the lines for a 3D view."""
        reading = self._reading
        assert reading is not None
        duration_s = self._times(reading)
        if not go_on():
            raise Abandoned
        self._picture = Picture(reading.toolpath)
        path = f"path-{self.mark}.npz"
        self._picture.save(self._folder / path)
        tell({"timed": self.mark, "duration_s": duration_s, "path": path})
        self._todo.append(self._send)

    def _send(self, tell: Tell, go_on: GoOn) -> None:
        """Answer with the errors of the text as it is sent, of a program that can be read."""
        assert self._reading is not None
        if not self._reading.refused:
            told = [self._told(error) for error in unsendable(self.lines, self.dialect, self.file, self.start, go_on)]
            tell({"sendable": self.mark, "refusals": told})

    def _times(self, reading: Reading) -> float | None:
        """Find out when every row ends; return how long all takes, None where the machine cannot be planned."""
        if self.machine is None:
            return None
        try:
            self._ends_s = row_times_s(begun(reading.toolpath), self.machine, backlash_of(self.machine, self.dialect))
        except CNCStepperError:
            return None  # a program of more axes than the machine has: its times are not known
        return float(self._ends_s[-1]) if len(self._ends_s) else 0.0

    def _told(self, error: ProgramError) -> dict[str, Any]:
        """Return a refusal as plain values."""
        line, column = (error.place.line, error.place.column) if error.place else (0, 0)
        text = self.lines[line - 1] if 0 < line <= len(self.lines) else ""
        return {**error_to_json(error), "length": _length(text, column, error.value)}

    def _edit(self, verb: str, values: dict[str, Any]) -> dict[str, Any]:
        """Return the difference that a verb makes, with the new text in a file; or why it is refused."""
        from CNCStepper.job.editing.edit_verbs import edited

        text = "\n".join(self.lines) + "\n"
        try:
            result = edited(text, verb, values, self.dialect, self.start, self.file, self.machine)
        except CNCStepperError as error:
            return {"edited": self.mark, "error_of_edit": error_to_json(error)}
        name = f"edited-{self.mark}.nc"
        (self._folder / name).write_bytes(result.text.encode("utf-8", "surrogatepass"))
        diff = result.diff().splitlines()
        shown = diff[:MOST_DIFF_LINES]
        return {
            "edited": self.mark,
            "text": name,
            "changes": result.changes,
            "diff": shown,
            "more": len(diff) - len(shown),
        }

    def _line(self, line: int) -> dict[str, Any]:
        """Return what holds after a line."""
        after = self._reading.after(line) if self._reading else None
        if self._reading is None or after is None:
            return {"line": line, "state": None, "way": []}
        rows = self._reading.rows_of(line)
        row = int(rows[-1]) if len(rows) else after.row
        time_s = None
        if self._ends_s is not None:
            time_s = float(self._ends_s[row]) if row >= 0 else 0.0
        return {
            "line": line,
            "state": _state(after.state),
            "work_mm": [None if math.isnan(value) else value for value in after.work_mm],
            "time_s": time_s,
            "way": self._picture.way(rows) if self._picture else [],
        }


def _state(state: State) -> dict[str, Any]:
    """Return what a person looks for in the modal state; the feed in force in its own unit of time."""
    told = {name: getattr(state, name) for name in STATE}
    feed = state.feed_mm_turn if state.feed_mode == "per_turn" else state.feed_mm_min
    return {**told, "feed": feed, "coolant": [name for name in ("mist", "flood") if getattr(state, name)]}


def _length(text: str, column: int, value: str) -> int:
    """Return how many characters of a line a refusal means, from its column on: those that it names, else the word."""
    if column < 1 or column > len(text):
        return 0
    rest = text[column - 1 :]
    if value and rest.upper().startswith(value.upper()):
        return len(value)
    match = _WORD.match(rest)
    return max(len(match[0].rstrip()) if match else 1, 1)


CHANGES = ("as", "text", "change")


def main(arguments: list[str]) -> int:
    """Answer what standard input asks about texts in the folder `arguments[0]`; return the exit status."""
    folder = Path(arguments[0])
    return serve(lambda questions: Answers(folder, questions, tell).run(), "editor-fault", "the reading")


class Answers:
    """The text as the editor has it, and what was found out about it."""

    def __init__(self, folder: Path, questions: Questions, tell: Callable[[dict[str, Any]], None]):

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
