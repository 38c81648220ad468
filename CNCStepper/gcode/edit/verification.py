# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every changed program is read again: its table must be the old one where the map puts it, to the last written digit.

Kinds, feeds, what is on and what happens between the rows must be as they were, arcs must lie about the mapped centre
and go through their angle. A row's end is compared in work coordinates; an axis for which the program has said no
coordinate of the work stands where the machine stood, in the old table as in the new one.

State that no path edit may change: outputs, tool, and the modes of path control.
"""

from __future__ import annotations

from itertools import zip_longest

import numpy as np

from CNCStepper.errors import Place, ProgramError
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.line_states import EXPAND, Source
from CNCStepper.gcode.edit.path_transforms import Map
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.motion.arc_lengths import FULL_TURN, Ways, ways_of
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.state import State
from CNCStepper.tolerances import SAME_SURFACE_SPEED
from CNCStepper.toolpath import PLANE_AXES, PLANE_NAMES, RAPID, Event, Toolpath


def modes_of(state: State) -> tuple:
    """Return those of a state; a speed that follows X is not among them."""
    rpm = state.spindle_rpm if not state.surface_m_min else 0.0
    on = state.spindle, rpm, state.mist, state.flood, state.tool
    return *on, state.work_system, state.feed_mode, state.path_mode


def same_modes(old: Toolpath, new: Toolpath) -> np.ndarray:
    """Return the rows of two tables of equal length that have the same modes, bool[n]."""
    numbers: dict[tuple, int] = {}
    one, other = (_by_row(path, numbers) for path in (old, new))
    surface, after = (_surface(path) for path in (old, new))
    return (one == other) & (np.abs(surface - after) <= SAME_SURFACE_SPEED * surface)


def _by_row(path: Toolpath, numbers: dict[tuple, int]) -> np.ndarray:
    of_states = np.array([numbers.setdefault(modes_of(state), len(numbers)) for state in path.states])
    return of_states[path.table().state]


def _surface(path: Toolpath) -> np.ndarray:
    return np.array([state.surface_m_min for state in path.states])[path.table().state]


DIGITS = 1.001  # last digits that rounding may take away
CENTRE_DIGITS = 12  # of a centre: ends and radii are rounded too
FEED_ROUNDING, EXACT = 1e-3, 1e-9  # relative
FEED_DIGIT_MM_MIN = 0.0006 * 25.4  # three decimals are written


def verified(source: Source, edited: Edited, where: Map, free: dict[int, tuple[bool, ...]], step_mm: float) -> Edited:
    """Return the edit; raises ProgramError, naming the line, where the new text means anything else than it must."""
    new = interpret(edited.text, source.start, source.dialect, source.file)
    old = source.toolpath
    wrong = _wrong_rows(old, new, where, free, step_mm) if len(old) == len(new) else np.zeros(1, bool)
    if wrong.any():
        row = int(np.flatnonzero(wrong)[0])
        line = int(new.table().line[row])
        origin = edited.origins[line - 1] if line else 0
        what = "the changed line would lead elsewhere than it must"
        value = program_lines(edited.text)[line - 1].strip() if line else ""
        raise ProgramError("edit-differs", what, value=value, advice=EXPAND, place=Place(source.file, origin, 1))
    if len(old) != len(new) or not same_events(old, new):
        place = Place(source.file, _parting_line(old, new, edited))
        raise ProgramError("edit-differs", "the changed program makes other moves", advice=EXPAND, place=place)
    return edited


def require_same_path(old: Toolpath, new: Toolpath, edited: Edited, file: str, feed_factor: float = 1.0) -> None:
    """Raise ProgramError where a text that only looks otherwise does something else; feeds must be times a factor."""
    one, other = old.table(), new.table()
    same = len(old) == len(new) and same_events(old, new)
    same = same and all(
        np.array_equal(getattr(one, name), getattr(other, name), equal_nan=name == "end")
        for name in ("kind", "end", "centre", "plane", "turns")
    )
    if not same or not (same_modes(old, new) & _times(old, new, feed_factor)).all():
        place = Place(file, _parting_line(old, new, edited))
        raise ProgramError("edit-differs", "the changed program makes other moves", place=place, advice=EXPAND)


def _times(old: Toolpath, new: Toolpath, factor: float) -> np.ndarray:
    """Return the rows whose feed is times the factor, but for rounding; feeds of inverse time and a turn are small."""
    if factor == 1.0:
        return old.table().feed == new.table().feed
    small = np.array([state.feed_mode != "per_minute" for state in old.states], bool)[old.table().state]
    wanted = factor * old.table().feed
    return small | (np.abs(wanted - new.table().feed) <= FEED_DIGIT_MM_MIN + EXACT * wanted)


def _parting_line(old: Toolpath, new: Toolpath, edited: Edited) -> int:
    """Return the old line at which moves or events of two tables part, 0 where there is none."""
    one, other = old.table(), new.table()
    origins = np.array([0, *edited.origins])[other.line]
    shared = min(len(one), len(other))
    parted = (one.line[:shared] != origins[:shared]) | (one.kind[:shared] != other.kind[:shared])
    event = None if parted.any() else _parting_event(old, new)
    if event and event.line:
        return event.line
    row = int(np.argmax(parted)) if parted.any() else shared
    lines = one.line if row < len(one) else origins
    return int(lines[row]) if row < len(lines) else 0


def same_events(old: Toolpath, new: Toolpath, but: tuple[str, ...] = ()) -> bool:
    """Return whether the same happens between the same rows of two tables, with the same on; `but` for these kinds."""
    one, other = ([event for event in _events(path) if event[1] not in but] for path in (old, new))
    return one == other


def _parting_event(old: Toolpath, new: Toolpath) -> Event | None:
    """Return the first of the old events that the new table has not so, None where all are there."""
    triples = zip_longest(old.events, _events(old), _events(new)[: len(old.events)])
    return next((event for event, one, other in triples if one != other), None)


def _events(path: Toolpath) -> list[tuple]:
    on = {event.state: modes_of(path.states[event.state]) for event in path.events}
    return [(event.index, event.kind, event.value, event.text, on[event.state]) for event in path.events]


def _wrong_rows(
    old: Toolpath, new: Toolpath, where: Map, free: dict[int, tuple[bool, ...]], step_mm: float
) -> np.ndarray:
    one, other = old.table(), new.table()
    wanted_kind = np.where(_turned(old, where), 5 - one.kind.astype(int), one.kind)
    wrong = (wanted_kind != other.kind) | ~_same_feeds(old, new, where) | ~same_modes(old, new)
    wrong |= ~_same_arcs(old, new, where, step_mm)
    ends_old, ends_new = one.end[:, :3] - old.offsets_mm()[:, :3], other.end[:, :3] - new.offsets_mm()[:, :3]
    stay = np.array([free.get(line, (False,) * 3) for line in one.line.tolist()], bool).reshape(-1, 3)
    wanted = np.where(stay, ends_old, _mapped(ends_old, where))
    away = np.abs(wanted - ends_new)
    known = ~(np.isnan(wanted) | np.isnan(ends_new))
    known[_within_cycles(old), 2] = False
    wrong |= (np.isnan(ends_old) != np.isnan(ends_new)).any(axis=1)
    return wrong | ((away > DIGITS * step_mm) & known).any(axis=1)


def _same_arcs(old: Toolpath, new: Toolpath, where: Map, step_mm: float) -> np.ndarray:
    """Return the rows whose centre lies where the map puts it, seen from their begin, with the angle as it was.

    Only the place along its normal, Y of a lathe, may be unknown. By R the centre of half a circle goes with the root
    of what rounding does to its ends.
    """
    one, other = (_ways(path) for path in (old, new))
    before, after = (np.nan_to_num(path.table().centre - path.begins()[:, :3]) for path in (old, new))
    away = np.abs(before @ where.linear.T - after)
    away[np.arange(len(away)), np.array(PLANE_AXES)[old.table().plane, 2]] = 0.0
    radius = np.maximum(np.minimum(one.radius_mm, other.radius_mm), step_mm)
    root = np.sqrt(step_mm / radius)
    whole = np.abs(one.sweep_rad) % FULL_TURN == 0
    near = CENTRE_DIGITS * step_mm + np.where(whole, 0.0, 8.0 * root * other.radius_mm)
    senses = np.where(_turned(old, where), -1.0, 1.0)
    turned = np.abs(senses * one.sweep_rad - other.sweep_rad)
    allowed = 0.02 + 8.0 * step_mm / radius + 4.0 * root
    same = (away.max(axis=1) <= near) & ((turned <= allowed) | (allowed > FULL_TURN / 4))
    return same | (one.sweep_rad == 0)


def _ways(path: Toolpath) -> Ways:
    table = path.table()
    return ways_of(table, path.begins()[:, :3], table.end[:, :3])


def _same_feeds(old: Toolpath, new: Toolpath, where: Map) -> np.ndarray:
    """Return the rows whose feed is as it was, but for rounding in another unit; in inverse time it follows the way."""
    one, other = old.table(), new.table()
    inverse = np.array([state.feed_mode == "inverse_time" for state in old.states], bool)[one.state]
    slack = FEED_ROUNDING if where.units else EXACT
    return inverse | (np.abs(one.feed - other.feed) <= slack * one.feed)


def _within_cycles(old: Toolpath) -> np.ndarray:
    """Return the rows inside canned cycles: how far a drill goes back between pecks is the controller's own."""
    inside = np.zeros(len(old), bool)
    for span in old.spans:
        if span.kind == "cycle":
            inside[span.first : span.last - 1] = True
    return inside


def _mapped(points: np.ndarray, where: Map) -> np.ndarray:
    """Return the places after the map; what depends on an unknown coordinate is unknown."""
    if where.is_diagonal:
        return points * np.diag(where.linear) + where.shift
    return where.of(points)


def _turned(old: Toolpath, where: Map) -> np.ndarray:
    """Return the rows whose arcs the map turns round."""
    senses = [where.in_plane(plane) for plane in PLANE_NAMES]
    turned = np.array([sense is not None and sense[1] < 0 for sense in senses])
    table = old.table()
    return turned[table.plane] & (table.kind > RAPID + 1)
