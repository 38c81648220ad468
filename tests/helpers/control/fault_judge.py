# SPDX-License-Identifier: LGPL-2.1-or-later
"""Judges a run by the machine's own trace; knows nothing of the sender but what it claimed and what it was told.

Places are the true ones, in steps: what the board counts, and what it has lost. A reference is the trace of the same
program on a board without faults.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import dist, hypot, inf

from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.grbl.states import State
from CNCStepper.virtual.server.fault_proxy import FaultyLink

NEAR_STEPS = 2.0
RIGHT_MM = 0.002  # of a told position: three decimals
ON_THE_WAY_S = 0.02  # a report, on its way to the sender: what happens then it cannot tell
BRAKED_S = 1.5  # from a report off the path to standstill
ABANDONED = {"close", "kill"}  # faults after which no sender reaches the machine
ANSWER = re.compile(rb"^(?:ok|error:\d+)\r$", re.MULTILINE)
TROUBLE = re.compile(rb"^(?:error:\d+|ALARM:\d+|Grbl .*)\r$", re.MULTILINE)
REPORT = re.compile(rb"<[A-Z][a-z]+(?::\d)?\|MPos:(-?\d+\.\d{3}),(-?\d+\.\d{3}),(-?\d+\.\d{3})[|>]")

EXACT, STOPPED_KNOWN, STOPPED_UNKNOWN, REFUSED = "exact", "stopped, known", "stopped, unknown", "refused"
EXCURSION, SILENT, WRONG = "excursion declared", "damaged unnoticed", "WRONG"

Place = tuple[float, ...]


@dataclass(frozen=True)
class Row:
    """A place the axes came to, and what the spindle did on the way: M number and rpm."""

    time_s: float
    place: Place  # true, steps
    spindle: tuple[int, float]


@dataclass(frozen=True)
class Reference:
    """The path of a program on a machine without faults; ends: the row at which each line has come to its end.

    top_steps: the true height of the work zero.
    """

    rows: tuple[Row, ...]
    ends: tuple[int, ...]
    top_steps: float


class MachineTrace:
    """Notes the true path of a board's axes; `begin_lost` and `lost` say whether its count is still the one met.

    lost_s: when it was so at last; None while it is. begin_lost: None of a board that is locked, or whose homing was
    broken off: it counts from nowhere. A homing is no part of a path: at its end the trace begins anew.
    """

    def __init__(self, board: Grbl):
        self.board = board
        self._homes = False
        self._begin()
        board.on_step = self._note

    @property
    def lost(self) -> bool:
        """Whether the board counts from elsewhere than at the begin."""
        return self.board.axes.lost_steps != self.begin_lost

    @property
    def at_rest(self) -> bool:
        """Whether nothing moves or is going to."""
        return self.board.quiet and self.board.spindle.rpm == 0

    def _begin(self) -> None:
        board = self.board
        self.begin_s = self._noted_s = board.time_s
        self.rows = [self._row()]
        self.begin_lost = None if board.state is State.ALARM else list(board.axes.lost_steps)
        self.lost_s = self.begin_s if self.lost else None
        self._counted, self._declared = board.axes.position_steps, board.axes.declared

    def _note(self, board: Grbl) -> None:
        homed, self._homes = self._homes, board.state is State.HOME
        if homed and not self._homes:
            self._begin()
        elif not self._homes:
            self._note_row(board)

    def _note_row(self, board: Grbl) -> None:
        axes = board.axes
        if axes.position_steps != self._counted and axes.declared == self._declared:
            self.rows.append(self._row())
        self._counted, self._declared = axes.position_steps, axes.declared
        if self.lost and self.lost_s is None:
            self.lost_s = self._noted_s
        self._noted_s = board.time_s

    def _row(self) -> Row:
        axes, spindle = self.board.axes, self.board.spindle
        place = tuple(float(here + lost) for here, lost in zip(axes.position_steps, axes.lost_steps, strict=True))
        return Row(self.board.time_s, place, (spindle.direction, spindle.rpm))


@dataclass(frozen=True)
class Claim:
    """What a sender says at its end."""

    done: bool
    refused: bool
    position_known: bool
    mpos_mm: Place | None
    declared: str  # the code of its error


@dataclass
class Run:
    """All that is known of one run but how the sender works. heard: what reached it, with the moments in s.

    claim_s: when it said its claim. greets: whether the controller was just switched on.
    """

    program: Reference
    answers: int  # of the controller, in a run without faults
    trace: MachineTrace
    line: FaultyLink
    claim: Claim
    heard: list[tuple[float, bytes]] = field(default_factory=list)
    claim_s: float = inf
    greets: bool = True

    @property
    def lost_before(self) -> bool:
        """Whether steps were lost before the board said the last words that the sender may have heard."""
        lost_s = self.trace.lost_s
        return lost_s is not None and lost_s < self.claim_s - ON_THE_WAY_S

    @property
    def reference(self) -> Sequence[Row]:
        """The path that is wanted."""
        return self.program.rows

    @property
    def abandoned(self) -> bool:
        """Whether nobody was left who could stop the machine."""
        return not ABANDONED.isdisjoint(self.line.fired)

    @property
    def damaged(self) -> bool:
        """Whether the controller read other bytes than were sent."""
        return self.line.ways["in"].damaged > 0

    @property
    def said(self) -> bytes:
        """All that reached the sender."""
        return b"".join(data for _, data in self.heard)


@dataclass(frozen=True)
class Verdict:
    """What a run is, and why if it is wrong."""

    kind: str
    why: str = ""


def judge(run: Run) -> Verdict:
    """Return what a run is."""
    claim = run.claim
    if why := _position_wrong(run):
        return Verdict(WRONG, why)
    if run.trace.board.ring.lost and not run.damaged:
        return Verdict(WRONG, "the controller's buffer was overrun")
    if run.trace.begin_lost is None:
        return _judge_not_homed(run)
    if claim.done:
        return _judge_done(run)
    if not run.abandoned and not claim.refused and not run.trace.at_rest:
        return Verdict(WRONG, "the machine was left running")
    if not follows(run.reference, run.trace.rows):
        return _judge_left(run)
    if claim.refused:
        return Verdict(REFUSED)
    return Verdict(STOPPED_KNOWN if claim.position_known else STOPPED_UNKNOWN)


def _position_wrong(run: Run) -> str:
    """Return what is wrong with a position that is said to be known, "" where nothing is."""
    if not run.claim.position_known:
        return ""
    if run.lost_before:
        return "the position is said to be known, but steps were lost"
    if run.claim.refused or run.trace.lost:
        return ""
    told, here = run.claim.mpos_mm, run.trace.board.axes.position_mm
    if told is None or max(abs(a - b) for a, b in zip(told, here, strict=True)) > RIGHT_MM:
        return f"the position is told as {told}, it is {here}"
    return ""


def _judge_not_homed(run: Run) -> Verdict:
    board = run.trace.board
    is_still = board.axes.idle and board.spindle.rpm == 0  # one in a hard alarm reads no line, and so is never quiet
    if run.claim.done or len(run.trace.rows) > 1 or not is_still:
        return Verdict(WRONG, "the program was begun, though the machine was not homed")
    return Verdict(REFUSED if run.claim.refused else STOPPED_UNKNOWN)


def _judge_done(run: Run) -> Verdict:
    if not run.trace.board.quiet:
        return Verdict(WRONG, "done is said while the machine moves")
    if covers(run.reference, run.trace.rows) and run.trace.at_rest:
        return Verdict(EXACT)
    if not run.damaged:
        return Verdict(WRONG, "done is said, but path or spindle are not the program's")
    if TROUBLE.search(_after_greeting(run)) or len(ANSWER.findall(run.said)) != run.answers:
        return Verdict(WRONG, "done is said, but the controller's answers told otherwise")
    if _seen_off_path(run) is not None:
        return Verdict(WRONG, "done is said, but a report had told that the path was left")
    return Verdict(SILENT)


def _judge_left(run: Run) -> Verdict:
    if not run.damaged:
        return Verdict(WRONG, "the machine went elsewhere, though every byte reached it")
    seen_s = _seen_off_path(run)
    if seen_s is not None and run.trace.rows[-1].time_s > seen_s + BRAKED_S and not run.abandoned:
        return Verdict(WRONG, "the machine moved on after a report had told that the path was left")
    if run.claim.declared == "path-left":
        return Verdict(EXCURSION)
    return Verdict(SILENT if seen_s is None else STOPPED_UNKNOWN)


def _after_greeting(run: Run) -> bytes:
    """Return what was said after the greeting of the power-up, where there was one."""
    return run.said.partition(b"for help]\r\n")[2] if run.greets else run.said


def _seen_off_path(run: Run) -> float | None:
    """Return when the sender was told a place that is nowhere on the program's path, None where it never was."""
    board, tail = run.trace.board, b""
    begin_lost = run.trace.begin_lost or []
    per_mm = [1 / board.axes.step_mm(axis) for axis in range(3)]
    for time_s, data in run.heard:
        if time_s < run.trace.begin_s:  # of before it was homed
            continue
        tail += data
        for found in REPORT.finditer(tail):
            counted = (float(text) * scale for text, scale in zip(found.groups(), per_mm, strict=True))
            place = tuple(here + lost for here, lost in zip(counted, begin_lost, strict=True))
            if not _on(run.reference, place, NEAR_STEPS + 1):
                return time_s
        tail = tail[tail.rfind(b"\n") + 1 :]
    return None


# --- paths ---------------------------------------------------------------------------------------------


def follows(reference: Sequence[Row], rows: Sequence[Row]) -> bool:
    """Return whether a path is the reference, in its order and with its spindle, as far as it goes."""
    count, stretches = reached(reference, rows)
    return bool(stretches) and count == len(rows) - 1


def covers(reference: Sequence[Row], rows: Sequence[Row]) -> bool:
    """Return whether a path is the whole reference."""
    end = reference[-1].place
    count, stretches = reached(reference, rows)
    left = (reference[stretch + 1 :] for stretch in stretches)
    at_end = count == len(rows) - 1 and dist(rows[-1].place, end) <= NEAR_STEPS
    return at_end and any(all(dist(row.place, end) <= NEAR_STEPS for row in rows_left) for rows_left in left)


def reached(reference: Sequence[Row], rows: Sequence[Row]) -> tuple[int, set[int]]:
    """Return the last row up to which a path follows the reference from its begin, and on which stretches it may be.

    The path is straight between two rows; it may pass a corner of the reference where that lies near enough. There is
    no stretch where it begins elsewhere.
    """
    stretches = {0} if dist(reference[0].place, rows[0].place) <= NEAR_STEPS else set()
    for count, (before, row) in enumerate(pairwise(rows)):
        after = {found for stretch in stretches for found in _steps(reference, stretch, before, row)}
        if not after:
            return count, stretches
        stretches = after
    return len(rows) - 1, stretches


def _steps(reference: Sequence[Row], stretch: int, before: Row, row: Row) -> set[int]:
    """Return the stretches of the reference that one row of a path may have come to from `stretch`."""
    found = set()
    while True:
        begin, end = reference[stretch], reference[stretch + 1]
        if row.spindle == end.spindle and distance(row.place, begin.place, end.place) <= NEAR_STEPS:
            found.add(stretch)
        stretch += 1
        if stretch + 1 >= len(reference) or distance(end.place, before.place, row.place) > NEAR_STEPS:
            return found


def _on(reference: Sequence[Row], place: Place, near_steps: float) -> bool:
    return any(distance(place, begin.place, end.place) <= near_steps for begin, end in pairwise(reference))


def distance(place: Place, begin: Place, end: Place) -> float:
    """Return how far a place is from a stretch."""
    x, y, z = end[0] - begin[0], end[1] - begin[1], end[2] - begin[2]
    u, v, w = place[0] - begin[0], place[1] - begin[1], place[2] - begin[2]
    length2 = x * x + y * y + z * z
    share = min(max((u * x + v * y + w * z) / length2, 0.0), 1.0) if length2 else 0.0
    return hypot(u - share * x, v - share * y, w - share * z)


def spot(place: Place, begin: Place, end: Place) -> float:
    """Return how far along a stretch a place lies that is on it."""
    return min(dist(begin, place), dist(begin, end))
