# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether a restart program does, from the entrance on, what the program itself does: the judge of the restart's text.

It looks at the two tables of moves alone, and knows nothing of how the entry was written.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.recovery.restart.entry_point import EntryPoint
from CNCStepper.recovery.restart.program import Program
from CNCStepper.state import ZERO3, State
from CNCStepper.toolpath import Toolpath

SAME_MM = 1e-5  # what the numbers of the entry leave
SAME_FEED = 1e-6  # of the feed


def require_same_rest(program: Program, entrance: EntryPoint, restart: Toolpath, entry_lines: int) -> None:
    """Raise ProgramError, naming the first line that would differ, unless the rest is run as in the undisturbed run.

    restart: the moves of the restart program, whose first lines, so many, are the entry.
    """
    old, new = program.table, restart.table()
    first = entrance.row + (1 if entrance.share else 0)
    own = int(np.searchsorted(new.line, entry_lines + 1))
    count = len(old) - first
    if len(new) - own != count:
        raise _differs(program, min(first, len(old) - 1), "moves")
    begin = restart.table().end[own - 1, :3] if own else np.full(3, np.nan)
    wanted = old.end[entrance.row, :3] if entrance.share else program.begins[entrance.row]
    if not np.allclose(begin, wanted, rtol=0.0, atol=SAME_MM, equal_nan=True):
        raise _differs(program, entrance.row, "begin")
    for name in ("kind", "plane", "turns"):
        _require(program, first, getattr(new, name)[own:] == getattr(old, name)[first:], name)
    for name in ("end", "centre"):
        one, other = getattr(new, name)[own:], getattr(old, name)[first:]
        _require(program, first, np.isclose(one, other, 0.0, SAME_MM, equal_nan=True).all(axis=1), name)
    _require(program, first, np.isclose(new.feed[own:], old.feed[first:], SAME_FEED, SAME_FEED), "feed")
    _require_states(program, first, restart, own)
    _require_events(program, first, restart, own, entrance)


def _require_states(program: Program, first: int, restart: Toolpath, own: int) -> None:
    pairs = np.stack([program.table.state[first:], restart.table().state[own:]], axis=1)
    kinds, rows = np.unique(pairs, axis=0, return_index=True)
    for (one, other), row in sorted(zip(kinds.tolist(), rows.tolist(), strict=True), key=lambda pair: pair[1]):
        before, after = program.path.states[one], restart.states[other]
        if not _same(before, after):
            raise _differs(program, first + row, _difference(before, after))


def _require_events(program: Program, first: int, restart: Toolpath, own: int, entrance: EntryPoint) -> None:
    """Compare what happens between the moves of the program's own lines."""
    old = [
        (event.index - first, event.kind, event.value, event.text)
        for event in program.path.events
        if event.line >= entrance.first_line
    ]
    shift = int(restart.table().line[own]) - int(program.table.line[first]) if own < len(restart) else 0
    new = [
        (event.index - own, event.kind, event.value, event.text)
        for event in restart.events
        if event.line >= entrance.first_line + shift
    ]
    if old != new:
        raise _differs(program, min(first, len(program.table) - 1), "events")


def _same(old: State, new: State) -> bool:
    """Whether two states are one, but for what the numbers of the entry leave in offsets and feeds."""
    if old == new:
        return True
    one, other = (
        [*state.offset_mm, *state.g92_mm, state.tool_length_mm, state.feed_mm_min, state.feed_mm_turn]
        for state in (old, new)
    )
    blank: dict[str, Any] = {
        "offset_mm": ZERO3,
        "g92_mm": ZERO3,
        "tool_length_mm": 0.0,
        "feed_mm_min": 0.0,
        "feed_mm_turn": 0.0,
    }
    near = bool(np.allclose(one, other, rtol=SAME_FEED, atol=SAME_MM))
    return near and replace(old, **blank) == replace(new, **blank)


def _difference(old: State, new: State) -> str:
    """Return the name of the first part of the state that differs."""
    return next(name for name in vars(old) if getattr(old, name) != getattr(new, name))


def _require(program: Program, first: int, same: np.ndarray, what: str) -> None:
    if not same.all():
        raise _differs(program, first + int(np.argmin(same)), what)


def _differs(program: Program, row: int, value: str) -> ProgramError:
    """Return the refusal of an entrance after which something is not as it was; value: what."""
    advice = "restart at the begin of its operation, or send the whole program"
    what = "entered here, the program would do something else than when it is run whole"
    return program.refusal("restart-differs", what, row, value=value, advice=advice)
