# SPDX-License-Identifier: LGPL-2.1-or-later
"""Program equivalence: judges a converted program without knowledge of its writer.

    old rows    |----- 0 -----|-- 1 --|------------ 2 ------------|     a row may have become several (chords, turns),
    new rows    |-- 0 --|- 0 -|-- 1 --|- 2 -|- 2 -|- 2 -|- 2 -|- 2 -|   in the same order: `owners`

New rows belong to an old one until they have its length and end where it ends. They must be of its kind, at its feed,
with its spindle, coolant and tool, and about its centre through its angle; what happens between rows must happen
there, with the same switched on. Ways shorter than the last digits are not judged, only where they lead.

What is on during the rows of two programs, and what happens between them, are a part of the judge.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.motion.arc_lengths import FULL_TURN, Ways, angles_between, flat, ways_of
from CNCStepper.gcode.writer.block_emitter import Grid
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import State
from CNCStepper.tolerances import SAME_CONVERTED_FEED, SAME_WRITTEN_VALUE
from CNCStepper.toolpath import LINE, RAPID, Chunk, Event, Toolpath

SPINDLES = ("off", "cw", "ccw")
HAPPENS = ("dwell", "pause", "optional_pause", "output")
LEFT_OUT = {"dwell": "dwell", "pause": "pause", "optional_pause": "pause"}


@dataclass(frozen=True)
class Switched:
    """Of each state of a program: on, float64[s, 4]: spindle, rpm, mist, flood. tool: int[s], 0 where it is not judged.

    changes: rows before which the tool is changed. strokes: of each row, how many of its canned cycle stand before it.
    pierces_itself: the target's controller waits at a pierce by itself, and its torch is on or off.
    """

    path: Toolpath
    on: np.ndarray
    tool: np.ndarray
    changes: np.ndarray
    strokes: np.ndarray
    pierces_itself: bool

    def same(self, states: np.ndarray, other: Switched, other_states: np.ndarray) -> np.ndarray:
        """Return where the other program has the same on, and the same tool, in these of its states, bool[n]."""
        tools, tools_there = self.tool[states], other.tool[other_states]
        return self.same_on(states, other, other_states) & ((tools == 0) | (tools == tools_there))

    def same_on(self, states: np.ndarray, other: Switched, other_states: np.ndarray) -> np.ndarray:
        """Return where spindle and coolant are the same."""
        return (np.abs(self.on[states] - other.on[other_states]) <= SAME_WRITTEN_VALUE).all(axis=1)


def switched_of(path: Toolpath, options: WriteOptions, target: Dialect) -> Switched:
    """Return the outputs that are on in a program, without those that the target lacks."""
    table = path.table()
    on = np.array([_on(state, options) for state in path.states], float).reshape(-1, 4)
    if "spindle" in options.leave_out:
        on[:, :2] = 0.0
    if "coolant" in options.leave_out:
        on[:, 2:] = 0.0
    if target.plasma:
        on[:, 1] = on[:, 1] > 0.0
    tool = np.array([state.tool for state in path.states])
    by_row = tool[table.state]
    changes = np.flatnonzero(by_row[1:] != by_row[:-1]) + 1
    judged = tool if "T" in target.letters and not target.plasma else np.zeros_like(tool)
    return Switched(path, on, judged, changes, _strokes(path), target.plasma)


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
                raise _event_differs(one.event, file)
        else:
            raise _event_differs(one.event, file)
    for other in found:
        if not _is_more(other, options, changes):
            raise _event_differs(Event(0, other.event.kind, other.event.value, other.event.text), file)


def _happenings(side: Switched, next_rows: np.ndarray, options: WriteOptions) -> Iterator[_PlacedEvent]:
    """Yield what must happen; pauses that follow one another are one."""
    last: _PlacedEvent | None = None
    states = side.path.table().state
    for event in side.path.events:
        if event.kind not in HAPPENS or LEFT_OUT.get(event.kind) in options.leave_out:
            continue
        if side.pierces_itself and event.kind == "dwell" and _is_pierce(event, side.on[:, 0] > 0.0, states):
            continue
        found = _PlacedEvent(int(next_rows[event.index]), event)
        if last and event.kind == "pause" == last.event.kind and found.row == last.row:
            continue
        last = found
        yield found


def _is_pierce(event: Event, on: np.ndarray, states: np.ndarray) -> bool:
    """Return whether an event happens with the power on that no row before it has had."""
    return bool(on[event.state]) and (event.index == 0 or not on[states[event.index - 1]])


def _is_same(one: _PlacedEvent, other: _PlacedEvent, old: Switched, new: Switched, changes: set[int]) -> bool:
    was, now = one.event, other.event
    if one.row != other.row or was.kind != now.kind or abs(was.value - now.value) > SAME_WRITTEN_VALUE:
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


BY_HAND = "write that place by hand, and please report it, with the program"


def _event_differs(event: Event, file: str) -> ProgramError:
    what = "the actions between the moves would change"
    value = f"{event.kind} {event.text or f'{event.value:g}'}".strip()
    return ProgramError("convert-differs", what, value=value, place=Place(file, event.line), advice=BY_HAND)


ROUNDING = 1.01  # last digits by which the end of a move may differ: half of one by the writer, and the numbers' own
SPIRAL = 0.01  # of an arc's length: its radius may differ at both ends, and the writer's arc is a true one


class Side(NamedTuple):
    """One of the two programs. begins, ends: float64[n, 3], without the lengths of tools that are touched off."""

    path: Toolpath
    table: Chunk
    begins: np.ndarray
    ends: np.ndarray
    ways: Ways
    switched: Switched


def require_same_work(old: Toolpath, new: Toolpath, options: WriteOptions, target: Dialect, file: str = "") -> None:
    """Raise ProgramError, naming the line of the old program, unless the new one does the same work."""
    assert target.writing is not None  # the writer has asked
    slack_mm = ROUNDING * Grid(options.units, target.writing.decimals[options.units]).step_mm
    one, other = _side(old, options, target), _side(new, options, target)
    owners = _owners(one, other, slack_mm, options.chord_mm + options.flat_mm, file)
    real = np.flatnonzero((owners >= 0) & ~(other.ways.length_mm <= 2 * slack_mm))
    _compare_rows(one, other, real, owners[real], file)
    _compare_turns(one, other, owners, slack_mm, file)
    next_rows = _next_real(one, slack_mm), _next_owner(owners, len(one.table))
    compare_events(one.switched, other.switched, next_rows, options, file)


def _side(path: Toolpath, options: WriteOptions, target: Dialect) -> Side:
    table = path.table()
    ends = table.end[:, :3].copy()
    if options.tool_length == "touch_off":
        lengths = np.array([state.tool_length_mm for state in path.states])
        ends[:, 2] -= lengths[table.state]
    begins = np.vstack([np.asarray(path.start.position_mm, float)[None, :3], ends[:-1]])[: len(ends)]
    return Side(path, table, begins, ends, ways_of(table, begins, ends), switched_of(path, options, target))


def _owners(old: Side, new: Side, slack_mm: float, chord_mm: float, file: str) -> np.ndarray:
    """Return the old row of every new one, int[m], -1 for those after the last; raises where one has none."""
    lengths, allowed = new.ways.length_mm.tolist(), _allowed(old, slack_mm, chord_mm).tolist()
    owners = np.full(len(lengths), -1)
    at, skipped_mm = 0, 0.0
    for row, length_mm in enumerate(old.ways.length_mm.tolist()):
        if length_mm <= 2 * slack_mm:
            skipped_mm += length_mm + slack_mm
            continue
        first, gone_mm, known = at, 0.0, length_mm == length_mm
        while True:
            off_mm = allowed[row] + skipped_mm + 2 * slack_mm * (at - first)
            whole = at > first and not (known and abs(gone_mm - length_mm) > off_mm)
            if whole and _close(new, at - 1, old, row, slack_mm):
                break
            if at == len(lengths) or (known and gone_mm > length_mm + off_mm):
                raise _differs("the converted program would not pass this point", old, row, file)
            gone_mm += lengths[at] if lengths[at] == lengths[at] else 0.0
            at += 1
        owners[first:at], skipped_mm = row, 0.0
    if sum(lengths[at:]) > skipped_mm + 2 * slack_mm * (1 + len(lengths) - at):
        raise _differs("the converted program would continue after this", old, len(old.table) - 1, file)
    return owners


def _allowed(old: Side, slack_mm: float, chord_mm: float) -> np.ndarray:
    """Return the permitted length difference for each row, mm: chords are shorter than their arc."""
    ways = old.ways
    with np.errstate(divide="ignore", invalid="ignore"):
        chords = np.where(ways.radius_mm > 0, np.minimum(chord_mm / ways.radius_mm, 1.0), 0.0)
    rounding = np.abs(ways.sweep_rad) * slack_mm
    return 4 * slack_mm + np.where(ways.sweep_rad != 0, ways.length_mm * (SPIRAL + chords) + rounding, 0.0)


def _close(new: Side, at: int, old: Side, row: int, slack_mm: float) -> bool:
    wanted = old.ends[row]
    slack_mm *= 1 + old.switched.strokes[row]
    return bool(np.all((np.abs(new.ends[at] - wanted) <= slack_mm) | np.isnan(wanted)))


def _compare_rows(old: Side, new: Side, rows: np.ndarray, owners: np.ndarray, file: str) -> None:
    """Raise where new rows are of another kind than their owners, or at another feed, or with something else on."""
    one, other = old.table.kind[owners], new.table.kind[rows]
    feeds, made = old.table.feed[owners], new.table.feed[rows]
    _require((one == RAPID) == (other == RAPID), "rapids and cuts would be exchanged", old, owners, file)
    _require((other <= LINE) | (one == other), "otherwise the move would be bent", old, owners, file)
    same = (one == RAPID) | (np.abs(feeds - made) <= SAME_CONVERTED_FEED * feeds)
    _require(same, "the feed would be another", old, owners, file)
    same = old.switched.same(old.table.state[owners], new.switched, new.table.state[rows])
    _require(same, "spindle, coolant or tool would be another", old, owners, file)


def _compare_turns(old: Side, new: Side, owners: np.ndarray, slack_mm: float, file: str) -> None:
    """Raise where the new rows of an arc go through another angle about its centre: the other way round, or again."""
    rows = np.flatnonzero(owners >= 0)
    own = owners[rows]
    planes, centres = old.table.plane[own], old.table.centre[own]
    from_centre = [flat(planes, places[rows] - centres) for places in (new.begins, new.ends)]
    angles = np.where(new.table.kind[rows] > LINE, new.ways.sweep_rad[rows], angles_between(*from_centre))
    swept = np.bincount(own, np.nan_to_num(angles), len(old.table))
    with np.errstate(divide="ignore", invalid="ignore"):
        allowed = 0.02 + 8 * slack_mm / old.ways.radius_mm
    judged = (old.ways.sweep_rad != 0) & (allowed < FULL_TURN / 4) & np.isin(np.arange(len(old.table)), own)
    same = ~judged | (np.abs(swept - old.ways.sweep_rad) <= allowed)
    _require(same, "the arc would go through another angle", old, np.arange(len(old.table)), file)


def _next_real(old: Side, slack_mm: float) -> np.ndarray:
    """Return for each old row, and the end, the first from it on that has a way, int[n + 1]."""
    rows = np.where(old.ways.length_mm <= 2 * slack_mm, len(old.table), np.arange(len(old.table)))
    return np.minimum.accumulate(np.append(rows, len(old.table))[::-1])[::-1]


def _next_owner(owners: np.ndarray, end: int) -> np.ndarray:
    """Return for each new row, and the end, whose rows are the next to be complete from it on, int[m + 1]."""
    complete = (owners >= 0) & (owners != np.append(owners[1:], -1))
    rows = np.append(np.where(complete, owners, end), end)
    return np.minimum.accumulate(rows[::-1])[::-1]


def _require(same: np.ndarray, what: str, old: Side, rows: np.ndarray, file: str) -> None:
    if not same.all():
        raise _differs(what, old, int(rows[np.argmin(same)]), file)


def _differs(what: str, old: Side, row: int, file: str) -> ProgramError:
    value = " ".join(f"{axis}{place:.4f}" for axis, place in zip("XYZ", old.ends[row], strict=True))
    return ProgramError(
        "convert-differs", what, value=value, place=Place(file, int(old.table.line[row])), advice=BY_HAND
    )
