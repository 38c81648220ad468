# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many lines are certainly cut, from how many were acknowledged.

`ok` means planned, not done: as many moves as the planner and the segments after it hold may still be to come.
Lines count as moves only where their own words prove that an axis goes some way; all else (a G0Z5 at 5, a line
without axes) may have taken no place in the planner. The last `ok` of all says nothing: a controller that is reset,
by its button too, leaves the line that it was at with an `ok`, even a pause that waited for the moves before it.

    acknowledged   G0Z5 | G1X1 | G1X2 | G1X2 | G1X3 | S900 |      a planner of 2: X3 and X2 may be to come,
                            ^ the first that may be               all before the first X2 is cut

How many acknowledged moves a controller still holds, from its own reports; and how many lines a CNCStepper controller
has made, which it knows pulse by pulse.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from CNCStepper.control.protocol.grbl.driver import PLANNER_BLOCKS, Received
from CNCStepper.control.protocol.grbl.settings import STEPS_PER_MM
from CNCStepper.control.protocol.grbl.status_reports import Alarm, Feedback, Greeting, Status, sizes
from CNCStepper.gcode.syntax.words import scanned_words

LOOK_BACK = 400  # lines: a millisecond or two
SEGMENTS = 12  # between planner and motors, the most of grbl, grblHAL and FluidNC
STEPS = 2.0  # a way that no rounding takes for none
_HARMLESS = {0.0, 1.0, 2.0, 3.0, 17.0, 18.0, 19.0, 40.0, 61.0, 94.0}  # G-codes that leave zero and units as they are
_ENDS = {2.0, 30.0}  # M-codes that set modes back
_PAUSE, _DWELL = 0.0, 4.0  # M0 and G4: answered only when all before them is cut
_AXES = "XYZ"
LONGEST_STEP_MM = 1.0  # of an axis whose setting is not reported

Words = list[tuple[str, float]]


def finished_lines(lines: Sequence[str], acknowledged: int, blocks: int, step_mm: float) -> int:
    """Return how many of the acknowledged lines are certainly cut; 0 when that is unknown.

    blocks: how many moves the controller holds at most. step_mm: the longest step of an axis. Going back from the
    last line but one, each stretch of lines over which an axis goes some way holds a move at least.
    """
    moves = 0
    later: dict[str, float] = {}  # by axis: the place at the end of the stretch
    last = acknowledged - 2
    for index in range(last, max(last - LOOK_BACK, -1), -1):
        text = lines[index]
        words = _words(text)
        if ("M", _PAUSE) in words or ("G", _DWELL) in words:
            return index + 1
        places = {letter: value for letter, value in words if letter in _AXES}
        if not _is_plain(text, words):
            later.clear()
        elif any(axis in later and _goes(value, later[axis], STEPS * step_mm) for axis, value in places.items()):
            moves += 1
            later = places
        else:
            later = places | later
        if moves >= blocks:
            return index + 1
    return 0


def longest_step_mm(settings: Mapping[int, float]) -> float:
    """Return the longest step of the axes, from the settings of the controller."""
    known = [settings.get(STEPS_PER_MM + axis, 0.0) for axis in range(len(_AXES))]
    return 1 / min(known) if min(known) > 0 else LONGEST_STEP_MM


def _words(text: str) -> Words:
    return [(letter, float(number)) for letter, number in scanned_words(text)]


def _goes(before: float, to: float, least: float) -> bool:
    """Return whether an axis surely moves, be its words places (G90) or ways (G91), mm or inch."""
    return abs(to - before) >= least and abs(to) >= least


def _is_plain(text: str, words: Words) -> bool:
    """Return whether places before and after a line may be compared, and it moves as G0 to G3 do."""
    return not text.startswith("$") and all(
        number in _HARMLESS if letter == "G" else letter != "M" or number not in _ENDS for letter, number in words
    )


class Capacity:
    """`moves` is the largest number reported."""

    def __init__(self) -> None:
        self._blocks = 0

    @property
    def moves(self) -> int:
        """Moves in the planner and behind it."""
        return (self._blocks or PLANNER_BLOCKS) + SEGMENTS

    def on_message(self, received: Iterable[Received]) -> None:
        """Take `[OPT:letters,blocks,bytes]`, and the free blocks of a status."""
        for report in received:
            if isinstance(report, Status) and report.buffer:
                self._blocks = max(self._blocks, report.buffer[0])
            elif isinstance(report, Feedback) and report.tag == "OPT":
                self._blocks = max(self._blocks, sizes(report.text)[0])


class MadeLines:
    """How many lines of a job are made, by the queue that a CNCStepper controller reports.

    Two reports must agree on it, so that a damaged one is not believed. Behind an alarm or a reset nothing is counted.
    """

    def __init__(self) -> None:
        self.lines = 0
        self._last = 0
        self._is_over = False

    def take(self, report: Received, acknowledged: int) -> None:
        """Take a report; acknowledged: lines of the job that were answered before it."""
        if isinstance(report, (Alarm, Greeting)):
            self._is_over = True
        elif isinstance(report, Status) and report.queued_lines is not None and not self._is_over:
            now = acknowledged - report.queued_lines
            self.lines = max(self.lines, min(now, self._last))
            self._last = now
