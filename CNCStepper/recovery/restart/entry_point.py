# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a path can be entered safely: at the place that is wanted, or before it.

Straight above a place where the tool has been there is no material, for no cutter is wider below than above. So any
place of a cut can be entered from above once the moves before it have been made, unless a line would have to be cut in
two that cannot be: then the entrance goes back, and gives the reason.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.gcode.dialects.codes import CYCLES
from CNCStepper.recovery.restart.interrupted_program import Program, entry_of, stretch_of
from CNCStepper.recovery.restart.restart_places import Place
from CNCStepper.recovery.tool_power_on import cut_begin
from CNCStepper.tolerances import SAME_MM
from CNCStepper.toolpath import LINE, XY

LEAST_MM = 0.01  # a shorter part of a move is not written
WAITS = frozenset(("pause", "optional_pause", "tool_change", "probe", "input", "output"))
_CYCLE = re.compile(r"G[ \t]*(?:7[ \t]*[346]|8[ \t]*[1-9])(?![0-9])", re.IGNORECASE)


@dataclass(frozen=True)
class EntryPoint:
    """Where the path is entered: after a share of a row, from 0 to below 1.

    first_line: the line, as they run from 1, from which on the program's own lines follow. overlap_mm: how much of the
    way before the wanted place is cut again. notes: why it is not the wanted place, sentence by sentence.
    """

    row: int
    share: float
    first_line: int
    overlap_mm: float = 0.0
    notes: tuple[str, ...] = ()


Step = Callable[[Program, Place], tuple[Place, str] | None]


def entry_point_of(program: Program, wanted: Place, overlap_mm: float = 0.0, from_edge: bool = False) -> EntryPoint:
    """Return where the path is entered for a restart at `wanted`, or `overlap_mm` before it on the same cut.

    from_edge: the tool is a wire, which can be entered only where its cut begins. Raises ProgramError where nothing is
    cut before it, or after it.
    """
    if from_edge and program.feeds[wanted.row]:
        wanted = Place(cut_begin(program.path, wanted.row))
    _check_worthwhile(program, wanted)
    place, overlap_mm, notes = _earlier(program, wanted, overlap_mm)
    while step := next((found for one in _STEPS if (found := one(program, place))), None):
        place, note = step
        notes = (*notes, note) if note else notes
    _check_worthwhile(program, place)
    return EntryPoint(place.row, place.share, _first_line(program, place), overlap_mm, notes)


def _check_worthwhile(program: Program, place: Place) -> None:
    cuts = program.feeds
    if not cuts[: place.row].any() and not (place.share and cuts[place.row]):
        what = "nothing is cut before this place"
        raise program.refusal("restart-at-start", what, place.row, advice="send the whole program")
    if not cuts[place.row :].any():
        what = "nothing is left to cut from this place on"
        raise program.refusal("restart-nothing-left", what, place.row, advice="choose an earlier place")


def _earlier(program: Program, wanted: Place, overlap_mm: float) -> tuple[Place, float, tuple[str, ...]]:
    """Return the place before `wanted` on the same cut, how far before, and a note where the cut does not go so far."""
    row, share = wanted
    if not overlap_mm or not program.feeds[row]:
        return wanted, 0.0, ()
    begin = entry_of(program, stretch_of(program, row), row).last
    if row < begin:
        return wanted, 0.0, ()
    ends_mm = np.cumsum(program.ways.length_mm[begin : row + 1])
    here_mm = float(ends_mm[-1]) - float(program.ways.length_mm[row]) * (1 - share)
    if here_mm <= overlap_mm:
        note = (
            Text("the overlap is only {here_mm:.3g} mm: the cut begins there", here_mm=here_mm)
            if here_mm < overlap_mm
            else ""
        )
        return Place(begin), here_mm, (note,) * bool(note)
    back = int(np.searchsorted(ends_mm, here_mm - overlap_mm, side="right"))
    length_mm = float(program.ways.length_mm[begin + back])
    gone_mm = here_mm - overlap_mm - float(ends_mm[back] - length_mm)
    return Place(begin + back, gone_mm / length_mm), overlap_mm, ()


# the steps back (or, in the air, forward); each returns the new place and a note, None where the place can stay


def _whole_move(program: Program, place: Place) -> tuple[Place, str] | None:
    """Take a move whole that cannot be begun in its middle."""
    if not place.share:
        return None
    length_mm = float(program.ways.length_mm[place.row])
    if length_mm * place.share < LEAST_MM:
        return Place(place.row), ""
    if not _can_be_parted(program, place.row) or length_mm * (1 - place.share) < LEAST_MM:
        return Place(place.row), Text("line {file_line} is run from its begin", file_line=program.file_line(place.row))
    return None


def _can_be_parted(program: Program, row: int) -> bool:
    """Whether the rest of a row can be written as a line of its own, after which the next line follows."""
    lines, state = program.table.line, program.path.states[int(program.table.state[row])]
    alone = (row == 0 or lines[row - 1] != lines[row]) and (row + 1 == len(lines) or lines[row + 1] != lines[row])
    after = any(event.index == row + 1 and event.line == lines[row] for event in program.path.events)
    plain = state.feed_mode == "per_minute" and program.table.turns[row] <= 1
    return bool(alone and plain and not after and not program.compensated[int(lines[row]) - 1])


def _whole_line(program: Program, place: Place) -> tuple[Place, str] | None:
    """Go back to the first move of a line that makes several, as a canned cycle does."""
    lines = program.table.line
    first = place.row
    while first and lines[first - 1] == lines[place.row]:
        first -= 1
    if first == place.row:
        return None
    return Place(first), Text(
        "line {file_line} makes several moves and is run from its begin", file_line=program.file_line(first)
    )


def _whole_thread(program: Program, place: Place) -> tuple[Place, str] | None:
    """Go back to where a cut begins that rises on a helix: the teeth of a thread mill are wider than its neck."""
    if not program.feeds[place.row]:
        return None
    first, table = stretch_of(program, place.row).first, program.table
    rows = slice(first, place.row + 1)
    rises = table.end[rows, 2] > program.begins[rows, 2] + SAME_MM
    if place == Place(first) or not (rises & (table.kind[rows] > LINE) & (table.plane[rows] == XY)).any():
        return None
    begin = program.file_line(first)
    return Place(first), Text(
        "it cuts upwards on a helix, as thread mills do, and is entered at its begin, line {begin}", begin=begin
    )


def _before_entry(program: Program, place: Place) -> tuple[Place, str] | None:
    """Go back to where a descent or a lead-in begins."""
    if not program.feeds[place.row]:
        return None
    entry = entry_of(program, stretch_of(program, place.row), place.row)
    if not entry.first <= place.row < entry.last or place == Place(entry.first):
        return None
    return Place(entry.first), Text(
        "it is within a way into the cut, which begins at line {file_line}", file_line=program.file_line(entry.first)
    )


def _uncompensated(program: Program, place: Place) -> tuple[Place, str] | None:
    """Go back to where the compensation of the tool's radius is switched on."""
    line = _first_line(program, place)
    if line > len(program.lines) or not program.compensated[line - 1]:
        return None
    free = np.flatnonzero(~program.compensated[:line])[-1] + 1  # the line that switches it on
    row = int(np.searchsorted(program.table.line, free))
    return Place(row), Text(
        "the tool's radius is compensated: it begins at line {file_line}, with G41 or G42",
        file_line=program.file_line(row),
    )


def _whole_cycle(program: Program, place: Place) -> tuple[Place, str] | None:
    """Go back to the first hole of a canned cycle whose heights are counted from where it began (G91)."""
    first = _first_line(program, place)
    begun = [number for number, text in enumerate(program.lines[:first], 1) if _CYCLE.search(text)]
    if not begun or begun[-1] == first:
        return None
    model = program.model_before(first)
    if model.motion not in CYCLES or model.absolute:
        return None
    row = int(np.searchsorted(program.table.line, begun[-1]))
    return Place(row), Text(
        "the canned cycle is begun anew, at line {file_line}: G91 is in force", file_line=program.file_line(row)
    )


def _in_air(program: Program, place: Place) -> tuple[Place, str] | None:
    """Enter a run of rapids where it is highest: at or before the place, else after the lift that follows."""
    if program.feeds[place.row]:
        return None
    first, last = _rapids_about(program, place.row)
    heights = program.begins[first : last + 1, 2]
    if np.isnan(heights[place.row - first]) or heights[place.row - first] >= np.nanmax(heights) - SAME_MM:
        return None
    high = first + np.flatnonzero(heights >= np.nanmax(heights) - SAME_MM)
    before = high[high <= place.row]
    if len(before):
        return Place(int(before[-1])), ""
    return None if _waits(program, place.row, int(high[0])) else (Place(int(high[0])), "")


def _rapids_about(program: Program, row: int) -> tuple[int, int]:
    """Return the first row of a run of rapids and the row after it (the last row of all, where none follows)."""
    cuts = np.flatnonzero(program.feeds)
    at = int(np.searchsorted(cuts, row))
    first = int(cuts[at - 1]) + 1 if at else 0
    return first, int(cuts[at]) if at < len(cuts) else len(program.feeds) - 1


def _waits(program: Program, row: int, later: int) -> bool:
    """Whether the program waits, or switches an output, between a row and a later one."""
    lines = program.table.line
    return any(
        event.kind in WAITS
        and (row <= event.index < later or (event.index == later and event.line <= lines[later - 1]))
        for event in program.path.events
    )


_STEPS: tuple[Step, ...] = (
    _whole_move,
    _whole_line,
    _whole_thread,
    _before_entry,
    _uncompensated,
    _whole_cycle,
    _in_air,
)


def _first_line(program: Program, place: Place) -> int:
    """Return the first line that is run after the entrance: lines between two moves belong to the second."""
    line = int(program.table.line[place.row])
    if place.share:
        return line + 1
    before = int(program.table.line[place.row - 1]) if place.row else 0
    return before + 1 if before < line else line
