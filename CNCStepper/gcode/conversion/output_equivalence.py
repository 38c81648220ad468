# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is on during the rows of two programs, and what happens between them: a part of the judge of
`program_equivalence.py`."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import State
from CNCStepper.toolpath import Event, Toolpath

SPINDLES = ("off", "cw", "ccw")
SAME_RPM, SAME_S = 0.0006, 0.0006  # three decimals are written
HAPPENS = ("dwell", "pause", "optional_pause", "output")
LEFT_OUT = {"dwell": "dwell", "pause": "pause", "optional_pause": "pause"}


@dataclass(frozen=True)
class Switched:
    """Of each state of a program: on, float64[s, 4]: spindle, rpm, mist, flood. tool: int[s], 0 where it is not judged.

    changes: rows before which the tool is changed. strokes: of each row, how many of its canned cycle stand before it.
    """

    path: Toolpath
    on: np.ndarray
    tool: np.ndarray
    changes: np.ndarray
    strokes: np.ndarray

    def same(self, states: np.ndarray, other: Switched, other_states: np.ndarray) -> np.ndarray:
        """Return where the other program has the same on, and the same tool, in these of its states, bool[n]."""
        tools, tools_there = self.tool[states], other.tool[other_states]
        return self.same_on(states, other, other_states) & ((tools == 0) | (tools == tools_there))

    def same_on(self, states: np.ndarray, other: Switched, other_states: np.ndarray) -> np.ndarray:
        """Return where spindle and coolant are the same."""
        return (np.abs(self.on[states] - other.on[other_states]) <= SAME_RPM).all(axis=1)


def switched_of(path: Toolpath, options: WriteOptions, target: Dialect) -> Switched:
    """Return what is on in a program, but for what the target leaves out."""
    table = path.table()
    on = np.array([_on(state, options) for state in path.states], float).reshape(-1, 4)
    if "spindle" in options.leave_out:
        on[:, :2] = 0.0
    if "coolant" in options.leave_out:
        on[:, 2:] = 0.0
    tool = np.array([state.tool for state in path.states])
    by_row = tool[table.state]
    changes = np.flatnonzero(by_row[1:] != by_row[:-1]) + 1
    judged = tool if "T" in target.letters else np.zeros_like(tool)
    return Switched(path, on, judged, changes, _strokes(path))


def _on(state: State, options: WriteOptions) -> tuple[float, ...]:
    turns = state.spindle != "off"
    mist = state.mist or (turns and options.coolant == "mist")
    flood = state.flood or (turns and options.coolant == "flood")
    return SPINDLES.index(state.spindle), state.spindle_rpm if turns else 0.0, mist, flood


def _strokes(path: Toolpath) -> np.ndarray:
    strokes = np.zeros(len(path), int)
    for span in path.spans:
        if span.kind == "cycle":
            strokes[span.first : span.last] = np.arange(span.last - span.first)
    return strokes


class _PlacedEvent(NamedTuple):
    """An event, and the old row that is the next with a way."""

    row: int
    event: Event


def compare_events(
    old: Switched, new: Switched, next_rows: tuple[np.ndarray, np.ndarray], options: WriteOptions, file: str
) -> None:
    """Raise ProgramError unless the same happens in the same order between the same rows, with the same on.

    next_rows: the old row that is next, of each row of both programs, int[n + 1]. A tool change may pause once more,
    with everything off, and a spindle that starts may be waited for.
    """
    changes = set(next_rows[0][old.changes].tolist())
    wanted = list(_happenings(old, next_rows[0], options))
    found = iter(_happenings(new, next_rows[1], options))
    for one in wanted:
        for other in found:
            if _is_same(one, other, old, new, changes):
                break
            if not _is_more(other, options, changes):
                raise _differs(one.event, file)
        else:
            raise _differs(one.event, file)
    for other in found:
        if not _is_more(other, options, changes):
            raise _differs(Event(0, other.event.kind, other.event.value, other.event.text), file)


def _happenings(side: Switched, next_rows: np.ndarray, options: WriteOptions) -> Iterator[_PlacedEvent]:
    """Yield what must happen; pauses that follow one another are one."""
    last: _PlacedEvent | None = None
    for event in side.path.events:
        if event.kind not in HAPPENS or LEFT_OUT.get(event.kind) in options.leave_out:
            continue
        found = _PlacedEvent(int(next_rows[event.index]), event)
        if last and event.kind == "pause" == last.event.kind and found.row == last.row:
            continue
        last = found
        yield found


def _is_same(one: _PlacedEvent, other: _PlacedEvent, old: Switched, new: Switched, changes: set[int]) -> bool:
    was, now = one.event, other.event
    if one.row != other.row or was.kind != now.kind or abs(was.value - now.value) > SAME_S:
        return False
    if was.kind == "output" and was.text != now.text:
        return False
    states = np.array([was.state]), np.array([now.state])
    stands = one.row in changes and not new.on[now.state].any()
    return stands or bool(old.same_on(states[0], new, states[1])[0])


def _is_more(other: _PlacedEvent, options: WriteOptions, changes: set[int]) -> bool:
    """Whether the writer may have added this by itself."""
    if other.event.kind == "pause":
        return options.tool_change == "pause" and other.row in changes
    return other.event.kind == "dwell" and options.spin_up_s > 0


def _differs(event: Event, file: str) -> ProgramError:
    what = "what happens between the moves would not be the same"
    value = f"{event.kind} {event.text or f'{event.value:g}'}".strip()
    return ProgramError("convert-differs", what, value=value, place=Place(file, event.line))
