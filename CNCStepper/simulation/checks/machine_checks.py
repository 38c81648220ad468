# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine cannot do: travel, rates, spindle speeds, coolant, tool changes, moves from nowhere."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.motion.planner.standstills import EventsAsOne
from CNCStepper.simulation.arc_chords import extremes
from CNCStepper.simulation.check_context import CheckContext, PartCheck
from CNCStepper.simulation.finding import Finding, Severity
from CNCStepper.simulation.tip_segments import segments_of_chunks

ROUNDING_MM = 1e-4
MOST_SPEEDS = 100_000  # of a spindle that are reported separately
DIRECTION_TOLERANCE_MM = 0.01  # of the chords whose directions stand for an arc's


class Travel(PartCheck):
    """Finds each end of an axis that the program leaves; arcs count with their real extremes.

    Where the work zero is not known, a program larger than the travel is refused and its place is
    reported as unknown.
    """

    def __init__(self) -> None:
        self._parts = 0
        self._low, self._high = np.full(3, np.nan), np.full(3, np.nan)
        self._highest: list[Finding | None] = [None] * 3  # a finding without numbers at the highest place of each axis

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        low, high = extremes(subject.table, subject.toolpath.begins()[:, :3])
        self._parts += 1
        if subject.toolpath.start.zero_known:
            for axis, name, profile in subject.machine.numbered_axes:
                bounds = profile.travel_min_mm, profile.travel_max_mm
                yield from _beyond(subject, name, low[:, axis], high[:, axis], *bounds)
            return
        if self._parts == 1:
            yield subject.finding(
                0 if len(subject.table) else -1,
                "info",
                "place-unknown",
                "the work zero is not known, so the program's place on the table is unknown",
                advice="give the work zero to have the travel checked",
                place_mm=None,
            )
        for axis, name, _ in subject.machine.numbered_axes:
            self._extend(subject, axis, name, low[:, axis], high[:, axis])

    def _extend(self, subject: CheckContext, axis: int, name: str, low: np.ndarray, high: np.ndarray) -> None:
        """Let the program's extent in one axis grow by the rows of a part."""
        if not np.isfinite(low).any():
            return
        self._low[axis] = np.fmin(self._low[axis], np.nanmin(low))
        if not np.nanmax(high) <= self._high[axis]:
            self._high[axis] = np.nanmax(high)
            self._highest[axis] = subject.finding(
                int(np.nanargmax(high)),
                "error",
                "travel",
                Text("the program is larger than the travel of {name}", name=name.upper()),
                advice="make the program smaller, split it, or use a larger machine",
                unit="mm",
            )

    def end(self, last: CheckContext) -> Iterator[Finding]:
        for size_mm, axis, found in zip(self._high - self._low, last.machine.axes, self._highest, strict=True):
            travel_mm = axis.travel_max_mm - axis.travel_min_mm
            if found is not None and size_mm > travel_mm + ROUNDING_MM:
                yield replace(found, value=float(size_mm), limit=travel_mm)


def _beyond(subject: CheckContext, name: str, low, high, min_mm: float, max_mm: float) -> Iterator[Finding]:
    for reach, limit, sign in ((low, min_mm, -1.0), (high, max_mm, 1.0)):
        over = sign * (reach - limit)
        rows = np.flatnonzero(over > ROUNDING_MM)
        if len(rows):
            worst = rows[over[rows].argmax()]
            yield subject.finding(
                int(rows[0]),
                "error",
                "travel",
                Text("the move leaves the travel of {name} by {over:.4g} mm", name=name.upper(), over=over[worst]),
                advice=Text(
                    "move the work zero {word} the {name} axis or make the program smaller",
                    word="up" if sign < 0 else "down",
                    name=name.upper(),
                ),
                value=float(reach[worst]),
                limit=limit,
                unit="mm",
                count=len(rows),
                group=f"{name}{sign:+g}",
                rank=float(over[worst]),
            )


def rates(subject: CheckContext) -> Iterator[Finding]:
    """Yield each axis that a feed would move faster than it can; the controller will slow the move down."""
    fastest = _fastest_mm_min(subject)
    for axis, name, profile in subject.machine.numbered_axes:
        over = np.flatnonzero(fastest[:, axis] > profile.max_rate_mm_min * (1 + 1e-6))
        if len(over):
            yield subject.finding(
                int(over[0]),
                "warning",
                "feed-above-rate",
                Text("the feed asks more of {name} than its highest rate", name=name.upper()),
                advice="lower F; the machine will take longer than the feed says",
                value=float(fastest[over, axis].max()),
                limit=profile.max_rate_mm_min,
                unit="mm/min",
                count=len(over),
                group=name,
                rank=float(fastest[over, axis].max()),
            )


def _fastest_mm_min(subject: CheckContext) -> np.ndarray:
    """Return the speed of each axis at the programmed feed on every row, float64[n, 3]; 0 on rapids."""
    fastest = np.zeros((len(subject.table), 3))
    for chords in segments_of_chunks(subject.toolpath, DIRECTION_TOLERANCE_MM):
        path = chords.known_in_x()
        path = path[subject.is_feed[path.row]]
        delta, length = np.abs(path.end - path.begin), path.length_mm
        share = delta / np.where(length > 0, length, 1.0)[:, None]
        firsts = np.flatnonzero(np.append(True, path.row[1:] != path.row[:-1])[: len(path)])
        speeds = share * subject.table.feed[path.row][:, None]
        fastest[path.row[firsts]] = np.maximum.reduceat(speeds, firsts) if len(firsts) else speeds
    return fastest


class Starts(PartCheck):
    """Finds a program without a move, feeds without a rate or from nowhere, sideways rapids at an unknown height."""

    def __init__(self) -> None:
        self._moves = self._has_height = False
        self._sideways: list[Finding] = []  # which count only where some row names a height: a table may have no Z

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        self._moves |= len(subject.toolpath) > 0
        self._has_height |= bool(np.isfinite(subject.end[:, 2]).any())
        feeds = subject.is_feed
        from_nowhere = (np.isnan(subject.begin) & np.isfinite(subject.end)).any(axis=1)
        sideways = ~feeds & np.isfinite(subject.end[:, :2]).any(axis=1) & np.isnan(subject.begin[:, 2])
        yield from _first_of(
            subject, feeds & (subject.table.feed <= 0), "error", "no-feed", "a cutting move has no feed rate",
            "give F before it",
        )  # fmt: skip
        yield from _first_of(
            subject, feeds & from_nowhere, "warning", "position-unknown",
            "a cutting move begins at an unknown position, so it is not checked against the stock",
            "begin with rapids that name X, Y and Z",
        )  # fmt: skip
        self._sideways += _first_of(
            subject, sideways, "warning", "height-unknown", "a rapid goes sideways while the height is not known",
            "begin the program with a rapid to a safe Z",
        )  # fmt: skip

    def end(self, last: CheckContext) -> Iterator[Finding]:
        if not self._moves:
            text, advice = "the program moves nothing", "see whether it is whole"
            yield last.finding(-1, "error", "no-motion", text, advice=advice)
        elif self._has_height and "y" in last.machine.axis:  # a lathe's Z is no height
            yield from self._sideways


def _first_of(
    subject: CheckContext, where: np.ndarray, severity: Severity, code: str, text: str, advice: str
) -> Iterator[Finding]:
    """Yield one finding for all rows of bool[n], at the first."""
    rows = np.flatnonzero(where)
    if len(rows):
        yield subject.finding(int(rows[0]), severity, code, text, advice=advice, count=len(rows), group="")


class Outputs(PartCheck):
    """Finds spindle speeds out of range and coolant that the machine does not have, each once.

    A program with more than MOST_SPEEDS wrong speeds is refused anyway, so further ones are not reported.
    """

    def __init__(self) -> None:
        self._seen: set[tuple] = set()

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        spindle, coolant, seen = subject.machine.spindle, subject.machine.outputs.coolant, self._seen
        min_rpm = 0.0 if spindle.laser else spindle.min_rpm
        for index, row in subject.first_rows_of_states():
            state = subject.toolpath.states[index]
            speed, wrong = ("rpm", state.spindle_rpm), not min_rpm <= state.spindle_rpm <= spindle.max_rpm
            if state.spindle != "off" and wrong and speed not in seen and len(seen) < MOST_SPEEDS:
                seen.add(speed)
                yield subject.finding(
                    row,
                    "error",
                    "spindle-speed",
                    "the spindle cannot turn at this speed",
                    advice=Text("choose S from {min_rpm:g} to {max_rpm:g}", min_rpm=min_rpm, max_rpm=spindle.max_rpm),
                    value=state.spindle_rpm,
                    limit=min_rpm if state.spindle_rpm < min_rpm else spindle.max_rpm,
                    unit="rpm",
                )
            for name, word in (("mist", "M7"), ("flood", "M8")):
                if getattr(state, name) and name not in coolant and (name,) not in seen:
                    seen.add((name,))
                    text, advice = (
                        Text("the machine has no {name} coolant", name=name),
                        Text("take out {word}", word=word),
                    )
                    yield subject.finding(row, "error", "coolant", text, advice=advice)


class SpinUp(PartCheck):
    """Finds each cut that begins before the spindle can have reached its speed."""

    def __init__(self) -> None:
        self._waited_s: float | None = None  # since the spindle was started, before its first cut; None: not waiting
        self._turns = False  # at the end of the part before

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        needed_s, laser = subject.machine.spindle.spin_up_s, subject.machine.spindle.laser
        if needed_s <= 0 or laser or not len(subject.table):
            return
        turns = subject.spindle_on
        edges = [0, *(np.flatnonzero(turns[1:] != turns[:-1]) + 1).tolist(), len(turns)]
        dwells = _dwells_while_turning(subject)
        for first, last in pairwise(edges):
            if turns[first] and not (first == 0 and self._turns):
                self._waited_s = 0.0
            if turns[first] and self._waited_s is not None:
                yield from self._wait(subject, first, last, dwells, needed_s)
        self._turns = bool(turns[-1])

    def _wait(
        self, subject: CheckContext, first: int, last: int, dwells: list[tuple[int, float]], needed_s: float
    ) -> Iterator[Finding]:
        """Count the dwells of rows [first, last), on which the spindle turns, up to the first cut."""
        assert self._waited_s is not None
        cuts = np.flatnonzero(subject.is_feed[first:last]) + first
        until = int(cuts[0]) if len(cuts) else last - 1
        waited_s = self._waited_s + sum(dwell_s for row, dwell_s in dwells if first <= row <= until)
        self._waited_s = None if len(cuts) else waited_s
        if len(cuts) and waited_s < needed_s - 1e-9:
            yield subject.finding(
                until,
                "warning",
                "spin-up",
                "the cut begins without waiting for the spindle",
                advice=Text("write G4 P{needed_s:g} after the spindle starts", needed_s=needed_s),
                value=waited_s,
                limit=needed_s,
                unit="s",
            )


def _dwells_while_turning(subject: CheckContext) -> list[tuple[int, float]]:
    """Return the rows after the dwells with a turning spindle, and their times in s."""
    states = subject.toolpath.states
    return [
        (event.index, event.value)
        for event in subject.toolpath.events
        if event.kind == "dwell" and states[event.state].spindle != "off"
    ]


class ToolChanges(PartCheck):
    """Finds changes of the tool number without a stop, and stops for the hand with the spindle running."""

    def __init__(self) -> None:
        self._tool = 0  # of the last row before

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        events, states = subject.toolpath.events, subject.toolpath.states
        stops = {event.index for event in events if event.kind in ("pause", "tool_change")}
        numbers = np.append(self._tool, subject.tool_numbers)
        for row in np.flatnonzero(numbers[1:] != numbers[:-1]):
            if numbers[row] != 0 and int(row) not in stops:
                yield subject.finding(
                    int(row),
                    "error",
                    "tool-change",
                    Text(
                        "tool {number} cuts on without a stop to change tool {number2}",
                        number=numbers[row + 1],
                        number2=numbers[row],
                    ),
                    advice="stop with M5 and M0 before the new tool",
                )
        self._tool = int(numbers[-1])
        for event in events:
            if event.kind == "pause" and states[event.state].spindle != "off":
                yield subject.finding_at(
                    event.line,
                    "warning",
                    "pause-spindle",
                    "the program pauses while the spindle turns",
                    advice="write M5 before M0",
                    count=event.count if isinstance(event, EventsAsOne) else 1,
                )
