# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the machine cannot do: travel, rates, spindle speeds, coolant, tool changes, moves from nowhere."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from CNCStepper.machine.profile import AXIS_NAMES
from CNCStepper.simulation.arcs import extremes
from CNCStepper.simulation.finding import Finding, Severity
from CNCStepper.simulation.segments import segments_of_chunks
from CNCStepper.simulation.subject import Subject

ROUNDING_MM = 1e-4
DIRECTION_TOLERANCE_MM = 0.01  # of the chords whose directions stand for an arc's


def travel(subject: Subject) -> Iterator[Finding]:
    """Yield each end of an axis that the program leaves; arcs count with their real extremes.

    Where the work zero is not known, a program larger than the travel is refused and its place is
    reported as unknown.
    """
    low, high = extremes(subject.table, subject.toolpath.begins()[:, :3])
    known = subject.toolpath.start.zero_known
    if not known:
        yield subject.finding(
            0 if len(subject.table) else -1,
            "info",
            "place-unknown",
            "the work zero is not known, so the program's place on the table is unknown",
            advice="give the work zero to have the travel checked",
            place_mm=None,
        )
    for axis, (name, profile) in enumerate(zip(AXIS_NAMES, subject.machine.axes, strict=True)):
        bounds = profile.travel_min_mm, profile.travel_max_mm
        if known:
            yield from _beyond(subject, name, low[:, axis], high[:, axis], *bounds)
        else:
            yield from _larger(subject, name, low[:, axis], high[:, axis], bounds[1] - bounds[0])


def _beyond(subject: Subject, name: str, low, high, min_mm: float, max_mm: float) -> Iterator[Finding]:
    for reach, limit, sign in ((low, min_mm, -1.0), (high, max_mm, 1.0)):
        over = sign * (reach - limit)
        rows = np.flatnonzero(over > ROUNDING_MM)
        if len(rows):
            worst = rows[over[rows].argmax()]
            yield subject.finding(
                int(rows[0]),
                "error",
                "travel",
                f"the move leaves the travel of {name.upper()} by {over[worst]:.4g} mm",
                advice=f"move the work zero {'up' if sign < 0 else 'down'} the {name.upper()} axis"
                " or make the program smaller",
                value=float(reach[worst]),
                limit=limit,
                unit="mm",
                count=len(rows),
            )


def _larger(subject: Subject, name: str, low, high, travel_mm: float) -> Iterator[Finding]:
    if np.isfinite(low).any():
        size_mm = float(np.nanmax(high) - np.nanmin(low))
        if size_mm > travel_mm + ROUNDING_MM:
            yield subject.finding(
                int(np.nanargmax(high)),
                "error",
                "travel",
                f"the program is larger than the travel of {name.upper()}",
                advice="make the program smaller, split it, or use a larger machine",
                value=size_mm,
                limit=travel_mm,
                unit="mm",
            )


def rates(subject: Subject) -> Iterator[Finding]:
    """Yield each axis that a feed asks to go faster than it can; the controller will slow the move down."""
    fastest = _fastest_mm_min(subject)
    for axis, (name, profile) in enumerate(zip(AXIS_NAMES, subject.machine.axes, strict=True)):
        over = np.flatnonzero(fastest[:, axis] > profile.max_rate_mm_min * (1 + 1e-6))
        if len(over):
            yield subject.finding(
                int(over[0]),
                "warning",
                "feed-above-rate",
                f"the feed asks more of {name.upper()} than its highest rate",
                advice="lower F; the machine will take longer than the feed says",
                value=float(fastest[over, axis].max()),
                limit=profile.max_rate_mm_min,
                unit="mm/min",
                count=len(over),
            )


def _fastest_mm_min(subject: Subject) -> np.ndarray:
    """Return how fast the feed asks each axis to go on every row, float64[n, 3]; 0 on rapids."""
    fastest = np.zeros((len(subject.table), 3))
    for chords in segments_of_chunks(subject.toolpath, DIRECTION_TOLERANCE_MM):
        path = chords.level_where_unknown()
        path = path[subject.is_feed[path.row]]
        delta = np.abs(path.end - path.begin)
        length = np.linalg.norm(delta, axis=1)
        share = delta / np.where(length > 0, length, 1.0)[:, None]
        np.maximum.at(fastest, path.row, share * subject.table.feed[path.row][:, None])
    return fastest


def starts(subject: Subject) -> Iterator[Finding]:
    """Yield a program without a move, feeds without a rate or from nowhere, sideways rapids at an unknown height."""
    if not len(subject.toolpath):
        yield subject.finding(-1, "error", "no-motion", "the program moves nothing", advice="see whether it is whole")
        return
    feeds = subject.is_feed
    from_nowhere = (np.isnan(subject.begin) & np.isfinite(subject.end)).any(axis=1)
    has_height = bool(np.isfinite(subject.end[:, 2]).any())  # a table without Z never names one
    sideways = np.isfinite(subject.end[:, :2]).any(axis=1) & np.isnan(subject.begin[:, 2])
    rules: tuple[tuple[np.ndarray, Severity, str, str, str], ...] = (
        (feeds & (subject.table.feed <= 0), "error", "no-feed", "a cutting move has no feed rate", "give F before it"),
        (
            feeds & from_nowhere,
            "warning",
            "position-unknown",
            "a cutting move begins at an unknown position, so it is not checked against the stock",
            "begin with rapids that name X, Y and Z",
        ),
        (
            ~feeds & sideways & has_height,
            "warning",
            "height-unknown",
            "a rapid goes sideways while the height is not known",
            "begin the program with a rapid to a safe Z",
        ),
    )
    for where, severity, code, text, advice in rules:
        rows = np.flatnonzero(where)
        if len(rows):
            yield subject.finding(int(rows[0]), severity, code, text, advice=advice, count=len(rows))


def outputs(subject: Subject) -> Iterator[Finding]:
    """Yield spindle speeds out of range and coolant that the machine does not have."""
    spindle, coolant = subject.machine.spindle, subject.machine.outputs.coolant
    min_rpm = 0.0 if spindle.laser else spindle.min_rpm
    seen: set[tuple] = set()
    for index, row in subject.first_rows_of_states():
        state = subject.toolpath.states[index]
        speed = ("rpm", state.spindle_rpm)
        if state.spindle != "off" and not min_rpm <= state.spindle_rpm <= spindle.max_rpm and speed not in seen:
            seen.add(speed)
            yield subject.finding(
                row,
                "error",
                "spindle-speed",
                "the spindle cannot turn at this speed",
                advice=f"choose S from {min_rpm:g} to {spindle.max_rpm:g}",
                value=state.spindle_rpm,
                limit=min_rpm if state.spindle_rpm < min_rpm else spindle.max_rpm,
                unit="rpm",
            )
        for name, word in (("mist", "M7"), ("flood", "M8")):
            if getattr(state, name) and name not in coolant and (name,) not in seen:
                seen.add((name,))
                yield subject.finding(
                    row, "error", "coolant", f"the machine has no {name} coolant", advice=f"take out {word}"
                )


def spin_up(subject: Subject) -> Iterator[Finding]:
    """Yield each cut that begins before the spindle can have reached its speed."""
    needed_s = subject.machine.spindle.spin_up_s
    if needed_s <= 0 or subject.machine.spindle.laser:
        return
    running = np.r_[False, subject.spindle_on, False].astype(np.int8)
    change = np.diff(running)
    for first, last in zip(np.flatnonzero(change == 1), np.flatnonzero(change == -1), strict=True):
        cuts = np.flatnonzero(subject.is_feed[first:last]) + first
        if not len(cuts):
            continue
        waited_s = sum(
            event.value
            for event in subject.toolpath.events
            if event.kind == "dwell"
            and first <= event.index <= cuts[0]
            and subject.toolpath.states[event.state].spindle != "off"
        )
        if waited_s < needed_s - 1e-9:
            yield subject.finding(
                int(cuts[0]),
                "warning",
                "spin-up",
                "the cut begins without waiting for the spindle",
                advice=f"write G4 P{needed_s:g} after the spindle starts",
                value=waited_s,
                limit=needed_s,
                unit="s",
            )


def tool_changes(subject: Subject) -> Iterator[Finding]:
    """Yield changes of the tool number without a stop, and stops for the hand with the spindle running."""
    events = subject.toolpath.events
    stops = {event.index for event in events if event.kind in ("pause", "tool_change")}
    numbers = np.array([state.tool for state in subject.toolpath.states], int)[subject.table.state]
    for row in np.flatnonzero(numbers[1:] != numbers[:-1]) + 1:
        if numbers[row - 1] != 0 and int(row) not in stops:
            yield subject.finding(
                int(row),
                "error",
                "tool-change",
                f"tool {numbers[row]} cuts on without a stop to change tool {numbers[row - 1]}",
                advice="stop with M5 and M0 before the new tool",
            )
    for event in events:
        if event.kind == "pause" and subject.toolpath.states[event.state].spindle != "off":
            yield subject.finding_at(
                event.line,
                "warning",
                "pause-spindle",
                "the program pauses while the spindle turns",
                advice="write M5 before M0",
            )
