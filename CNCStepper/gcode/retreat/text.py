# SPDX-License-Identifier: LGPL-2.1-or-later
"""A stretch of the way as wire text for a controller that has just been reset, in mm and absolute coordinates.

G21G90G17G94G54      what a reset leaves, said once more
G43.1Z5  G92X3Y0Z0   the tool's length and G92, which a reset takes away
M3S8000  G4P3        what is to be on, and the time that it needs
G1Z... G1X... G1Z... up, over and down to the way, where somebody has jogged off it
G1X... F...          from where the machine stands to the way, less than a step, then along it
G20G91F30            modes again in which the program's own lines go on
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import ceil, tau

from CNCStepper.gcode.codes import MOTION_NAMES, PLANE_CODES, UNIT_CODES
from CNCStepper.gcode.edit.numbers import number_text
from CNCStepper.gcode.retreat.move import Move, Point
from CNCStepper.gcode.retreat.over import over
from CNCStepper.gcode.retreat.way import Place, Way
from CNCStepper.gcode.saved_modes import FEED_MODES, SPINDLE
from CNCStepper.state import State
from CNCStepper.toolpath import LINE, PLANE_AXES, PLANE_NAMES, RAPID
from CNCStepper.units import MM_PER_INCH

AXES, CENTRES = "XYZ", "IJK"
DECIMALS = 4  # of mm: finer than a step, and no more digits than 32-bit floats hold
SHORT_MM = 0.01  # shorter arcs are written as lines: their rounded ends would say another angle
MOST_SWEEP_RAD = 0.75 * tau  # of one line: beyond it rounded ends could make a whole circle of it, or none
MODES = "G21G90G17G94"

Part = tuple[int, float, float]  # row, from share, to share


def head_lines(state: State, position_mm: Point) -> list[str]:
    """Return the lines that bring modes, tool length and G92 back at a machine that was reset at `position_mm`."""
    lines = [MODES + state.work_system]
    if state.tool_length_mm:
        lines.append(f"G43.1Z{_number(state.tool_length_mm)}")
    if any(state.g92_mm):
        lines.append("G92" + _point(position_mm, state))
    return lines


def output_lines(state: State, spin_up_s: float) -> list[str]:
    """Return the lines that switch spindle, beam and coolant on as a state has them."""
    lines = [name for name, on in (("M7", state.mist), ("M8", state.flood)) if on]
    if state.spindle_turns:
        lines.append(f"{SPINDLE[state.spindle]}S{_number(state.spindle_rpm)}")
        lines += [f"G4P{_number(spin_up_s)}"] * (spin_up_s > 0)
    return lines


def over_lines(here_mm: Point, there_mm: Point, top_mm: float, state: State) -> list[str]:
    """Return the lines that take a machine that was jogged away back: up, over, and slowly down."""
    return [
        f"G1{_point(place_mm, state)}F{_number(feed_mm_min)}"
        for place_mm, feed_mm_min in over(here_mm, there_mm, top_mm)
    ]


def way_lines(way: Way, begin: Place, end: Place, state: State) -> tuple[list[str], list[Part]]:
    """Return the lines along a stretch, a move each, and the part of the way that each of them is.

    state: whose work system, G92 and tool length are in force.
    """
    row = min(max(begin.row, 0), len(way) - 1)
    move = way.move(row)
    join = Move(
        RAPID if move.kind == RAPID else LINE, (0.0, 0.0, 0.0), move.at(begin.share), feed_mm_min=move.feed_mm_min
    )
    lines, parts = [_line(join, state)], [(row, begin.share, begin.share)]
    for row, first, last in way.stretch(begin, end):
        for one, part in _pieces(way.move(row), first, last):
            lines.append(_line(one, state))
            parts.append((row, *part))
    return lines, parts


def modes_line(state: State, feed_mm_min: float) -> str:
    """Return the line after which a program's own lines mean what they meant: units, distance, plane, feed."""
    words = [
        UNIT_CODES[state.units],
        {"absolute": "G90", "incremental": "G91"}[state.distance],
        PLANE_CODES[PLANE_NAMES.index(state.plane)],
        FEED_MODES[state.feed_mode],
    ]
    scale = MM_PER_INCH if state.units == "inch" else 1.0
    words += [f"F{_number(feed_mm_min / scale)}"] * (feed_mm_min > 0 and state.feed_mode == "per_minute")
    off = state.spindle == "off" and state.spindle_rpm > 0
    return "".join(words) + f"S{_number(state.spindle_rpm)}" * off


def _pieces(move: Move, first: float, last: float) -> Iterator[tuple[Move, tuple[float, float]]]:
    """Yield a part of a move in pieces that rounding cannot turn into something else."""
    share = last - first
    if not move.is_arc or move.length_mm * abs(share) < SHORT_MM:
        one = Move(RAPID if move.kind == RAPID else LINE, move.at(first), move.at(last), feed_mm_min=move.feed_mm_min)
        yield one, (first, last)
        return
    count = ceil(abs(move.sweep_rad * share) / MOST_SWEEP_RAD)
    for number in range(count):
        ends = first + share * number / count, first + share * (number + 1) / count
        yield move.part(*ends), ends


def _line(move: Move, state: State) -> str:
    """Return the line of a move; the centre is told from the begin as it was rounded."""
    feed = f"F{_number(move.feed_mm_min)}" if move.kind != RAPID else ""
    words = f"{MOTION_NAMES[move.kind]}{_point(move.end, state)}"
    if not move.is_arc:
        return words + feed
    arms = (
        (CENTRES[axis], round(move.centre[axis] - offset, DECIMALS) - round(move.begin[axis] - offset, DECIMALS))
        for axis, offset in ((axis, state.offset_mm[axis]) for axis in sorted(PLANE_AXES[move.plane][:2]))
    )
    return PLANE_CODES[move.plane] + words + "".join(f"{letter}{_number(arm)}" for letter, arm in arms) + feed


def _point(point_mm: Iterable[float | None], state: State) -> str:
    """Return the words of a point of the machine in work coordinates; an axis that is None has none."""
    axes = zip(AXES, point_mm, state.offset_mm, strict=False)
    return "".join(axis + _number(value - offset) for axis, value, offset in axes if value is not None)


def _number(value: float) -> str:
    return number_text(value, DECIMALS)
