# SPDX-License-Identifier: LGPL-2.1-or-later
"""A part of the path as wire text for a controller after a reset, in mm and absolute coordinates.

G21G90G17G94G54      the modes after a reset, repeated
G43.1Z5  G92X3Y0Z0   the tool's length and G92, which a reset takes away
M3S8000  G4P3        outputs that must be on, and their wait
G1Z... G1X... G1Z... up, over and down to the path, after a jog
G1X... F...          from the machine's position to the path, less than a step, then along it
G20G91F30            modes of the program's own lines that follow

The motors' moves along the tool's way, where the wire text compensates backlash.

    tool    ◄────── x        held on its way there, and taken back
    motors  ◄──── ◄─┼── x    they stood ahead of it on the other side, or anywhere in the gap: what is left of it first

Where the side of the motors in their gaps is unknown, as after a jog, they approach the path so that it is known.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from CNCStepper.control.stream.return_after_jog import Axes
from CNCStepper.gcode.dialects.codes import MOTION_NAMES, PLANE_CODES, UNIT_CODES
from CNCStepper.gcode.edit.word_values import number_text
from CNCStepper.gcode.interpreter.state.modal_state_stack import FEED_MODES, SPINDLE
from CNCStepper.gcode.wire.monotonic_split import Piece, arc_pieces
from CNCStepper.machine.backlash import Backlash, Motors
from CNCStepper.recovery.retract.move_curve import Move, Point
from CNCStepper.recovery.retract.places_on_path import Part
from CNCStepper.state import State
from CNCStepper.toolpath import LINE, PLANE_AXES, PLANE_NAMES, RAPID
from CNCStepper.units import MM_PER_INCH

AXES, CENTRES = "XYZ", "IJK"
DECIMALS = 4  # of mm: finer than a step, and no more digits than 32-bit floats hold
MODES = "G21G90G17G94"
_HEIGHT = re.compile(r"Z-?[\d.]+")


def head_lines(state: State, position_mm: Point) -> list[str]:
    """Return the lines that bring modes, tool length and G92 back at a machine that was reset at `position_mm`."""
    lines = [MODES + state.work_system]
    if state.tool_length_mm:
        lines.append(f"G43.1Z{_number(state.tool_length_mm)}")
    if any(state.g92_mm):
        lines.append("G92" + _point_words(position_mm, state))
    return lines


def output_lines(state: State, spin_up_s: float, power: str = "speed") -> list[str]:
    """Return the lines that switch spindle, beam and coolant on as a state has them; power: as of the dialect."""
    lines = [name for name, on in (("M7", state.mist), ("M8", state.flood)) if on]
    if state.spindle_turns:
        speed = f"S{_number(state.spindle_rpm)}" if power == "speed" else ""
        lines.append(f"{SPINDLE[state.spindle]}{speed}")
        lines += [f"G4P{_number(spin_up_s)}"] * (spin_up_s > 0)
    return lines


def over_lines(ways: Iterable[tuple[Axes, float]], state: State) -> list[str]:
    """Return the lines that take a machine that was jogged away back, as `over` has their places and speeds."""
    return [f"G1{_point_words(place_mm, state)}F{_number(feed_mm_min)}" for place_mm, feed_mm_min in ways]


def without_height(lines: Iterable[str]) -> list[str]:
    """Return lines for a machine without Z: without its words, and without those that move nothing else."""
    flat = [(line, _HEIGHT.sub("", line)) for line in lines]
    return [short for line, short in flat if short == line or "X" in short or "Y" in short]


def way_lines(moves: Iterable[tuple[Move, Part]], state: State) -> tuple[list[str], list[Part]]:
    """Return the lines of moves, one each, and the part of the path of each.

    state: whose work system, G92 and tool length are in force.
    """
    written = [(_line(move, state), part) for move, part in moves]
    return [line for line, _ in written], [part for _, part in written]


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


def _line(move: Move, state: State) -> str:
    """Return the line of a move; the centre counts from the begin as it was rounded."""
    feed = f"F{_number(move.feed_mm_min)}" if move.kind != RAPID else ""
    words = f"{MOTION_NAMES[move.kind]}{_point_words(move.end, state)}"
    if not move.is_arc:
        return words + feed
    arms = (
        (CENTRES[axis], round(move.centre[axis] - offset, DECIMALS) - round(move.begin[axis] - offset, DECIMALS))
        for axis, offset in ((axis, state.offset_mm[axis]) for axis in sorted(PLANE_AXES[move.plane][:2]))
    )
    return PLANE_CODES[move.plane] + words + "".join(f"{letter}{_number(arm)}" for letter, arm in arms) + feed


def _point_words(point_mm: Iterable[float | None], state: State) -> str:
    """Return the words of a point of the machine in work coordinates; an axis that is None has none."""
    axes = zip(AXES, point_mm, state.offset_mm, strict=False)
    return "".join(axis + _number(value - offset) for axis, value, offset in axes if value is not None)


def _number(value: float) -> str:
    return number_text(value, DECIMALS)


def taken_up(moves: Iterable[tuple[Move, Part]], motors: Motors) -> Iterator[tuple[Move, Part]]:
    """Yield the motors' moves that lead the tool along some of its own, which `motors` follows.

    motors.at_mm: their position before the first, anywhere in their gaps.
    """
    for move, (row, first, last) in moves:
        share = first
        for piece in _one_way(move, motors.play):
            stood_mm = motors.at_mm
            ready_mm = motors.go(piece.begin_mm, piece.end_mm)
            if ready_mm is not None:
                yield crossing(stood_mm, ready_mm, move, motors.play), (row, share, share)
            part = row, share, share + (last - first) * piece.share
            yield _beside(move, piece, _point(ready_mm or stood_mm), _point(motors.at_mm)), part
            share = part[2]


def crossing(stood_mm: Sequence[float], ready_mm: Sequence[float], move: Move, play: Backlash) -> Move:
    """Return the motors' move across the backlash at a move of the tool: no faster, and without a beam."""
    if move.kind == RAPID or play.beam:
        return Move(RAPID, _point(stood_mm), _point(ready_mm))
    return Move(LINE, _point(stood_mm), _point(ready_mm), feed_mm_min=move.feed_mm_min)


def _one_way(move: Move, play: Backlash) -> list[Piece]:
    """Return a move cut where an axis turns back."""
    if not move.is_arc:
        return [Piece(move.begin, move.end, 1.0, 0)]
    return arc_pieces(play, move.begin, move.end, move.centre, move.kind, move.plane, move.turns)


def _beside(move: Move, piece: Piece, begin_mm: Point, end_mm: Point) -> Move:
    """Return a piece of the tool's move as the motors go it, about a centre as far beside as they are."""
    x, y, z = (place + motor - tool for place, motor, tool in zip(move.centre, end_mm, piece.end_mm, strict=True))
    centre = (x, y, z) if move.is_arc else move.centre
    return replace(move, begin=begin_mm, end=end_mm, centre=centre, turns=piece.turns)


def _point(place_mm: Sequence[float]) -> Point:
    x, y, z = place_mm
    return x, y, z
