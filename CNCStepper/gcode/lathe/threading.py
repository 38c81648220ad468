# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Moves that follow the spindle: G33, rigid tapping G33.1, and the threading cycle G76 of a lathe.

    drive line (where the tool stands)  ---------------------------------  X
      ^ I: to the crest of the thread                                \
      |  J: the first cut below it, K: the whole depth                \    angled in and out (L, along E)
    crest  ________________________________________________            \
           pass n cuts J n^(1/R) deep; Q slants the way in              \___________ ...  Z

The table gets the feeds that the commanded speed of the spindle makes of the pitch.
"""

from __future__ import annotations

from math import hypot, radians, tan
from typing import NamedTuple

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.functions.spindle import check_spindle, need_turning
from CNCStepper.gcode.interpreter.motion.end_points import end_point, further_end
from CNCStepper.gcode.interpreter.state.interpreter_state import Point, rpm_at
from CNCStepper.toolpath import LINE, RAPID

MOST_PASSES = 100_000
OTHER_SENSE = {"cw": "ccw", "ccw": "cw"}


def thread(block: Block, motion: int, before: int) -> None:
    """G33: a line whose pitch K, or F of G32, the spindle drives."""
    begin_thread(block, motion)
    end, further = _end(block)
    lead = _lead(block, end)
    synchronise(block, lead)
    block.move(LINE, end, None, feed_of_pitch(block, lead, end), further)
    block.call("STOP_SPEED_FEED_SYNCH()")


def tap(block: Block, motion: int, before: int) -> None:
    """G33.1: down with the spindle, and back with it turning the other way; the tool ends where it was."""
    sense = begin_thread(block, motion)
    begin, (end, further) = block.model.position, _end(block)
    synchronise(block, block.value("K"))
    feed = feed_of_pitch(block, block.value("K"), end)
    block.unheard = True
    block.move(LINE, end, None, feed, further)
    block.model.change(spindle=OTHER_SENSE[sense])
    block.move(LINE, begin, None, feed)
    block.model.change(spindle=sense)
    block.unheard = False
    tip = ", ".join(f"{value / block.model.scale:.4f}" for value in block.model.work(end))
    block.call(f"RIGID_TAP({tip})")
    block.call("STOP_SPEED_FEED_SYNCH()")


def begin_thread(block: Block, motion: int) -> str:
    """Check what all these moves need; return in which sense the spindle turns."""
    name = MOTION_NAMES[motion]
    block.model.arc_allowed = True
    two_blocks = block.dialect.two_block_cycles and name == "G76"
    for letter in "PIJK" if name == "G76" and not two_blocks else block.dialect.lead_word:
        if letter != "F" or not block.model.feed_number:  # F is modal
            block.must_have(letter, name)
    check_spindle(block)
    if block.model.compensation and block.model.compensation.radius:
        block.uncompensated(Text("{name} may not be used", name=name), name)
    if name != "G76" and block.dialect.lead_word != "F" and "F" in block.plan.slots:
        what = Text("{name} takes no F: the spindle drives it", name=name)
        raise ProgramError("unused-word", what, value="F", advice="write F on a line of its own")
    return need_turning(block, name)


def _lead(block: Block, end: Point) -> float:
    """Return the travel a turn along the path: K, or what F, along the axis that moves farther, makes of it."""
    if block.dialect.lead_word == "K":
        return block.value("K")
    begin = block.known_position((0, 2))
    way = abs(end[0] - begin[0]), abs(end[2] - begin[2])
    return block.model.feed_number * hypot(*way) / (max(way) or 1.0)


def _end(block: Block) -> tuple[Point, tuple[float, ...]]:
    model = block.model
    return end_point(model, block.plan, block.values), further_end(model, block.plan, block.values)


def synchronise(block: Block, pitch: float) -> None:
    """Let the next move follow the spindle by a pitch in units of the text."""
    block.event("synchronised", pitch * block.model.scale, MOTION_NAMES[block.plan.motion])
    block.call(f"START_SPEED_FEED_SYNC({pitch:f},0)")


def feed_of_pitch(block: Block, pitch: float, end: Point) -> float:
    """Return the feed in mm/min that a pitch (units of the text a turn) makes; raises ProgramError without a speed."""
    feed = abs(pitch) * block.model.scale * rpm_at(block.model, end)
    if feed <= 0 and not block.model.bare:
        name = MOTION_NAMES[block.plan.motion]
        what = Text("{name} moves with the spindle, whose speed is not set", name=name)
        raise ProgramError("no-speed", what, value=name, advice="write S before")
    return feed


class Thread(NamedTuple):
    """A G76 in work mm: where it begins and ends, and its words; `way`: 1 along X for an inner thread, else -1."""

    begin: Point
    end: Point
    way: float
    crest: float  # from the drive line
    first: float  # depth of the first cut
    depth: float
    pitch: float  # units of the text
    slant: float  # Z a depth
    spring: int
    degression: float
    taper: float  # along Z, with its sign
    taper_pitch: float
    entry: bool
    leaving: bool


def run_thread(block: Block, motion: int, before: int) -> None:
    """G76: passes of growing depth, and spring passes at the full one; raises ProgramError."""
    begin_thread(block, motion)
    end, further = _end(block)
    if further != block.model.further:
        raise ProgramError("axis-unused", "G76 moves X and Z only", value="G76", advice="move other axes before")
    words = _words(block, block.model.work(end))
    count, depth = 1, words.first
    while words.crest + depth < words.crest + words.depth:  # summed as LinuxCNC does, with its rounding
        _pass(block, words, depth)
        count += 1
        depth = words.first * count ** (1.0 / words.degression)
        if count > MOST_PASSES:
            limit = f"{MOST_PASSES} passes"
            advice = "make J larger or R smaller"
            raise ProgramError("passes-many", "J and R make too many passes", value="J", limit=limit, advice=advice)
    for _ in range(words.spring + 1):
        _pass(block, words, words.depth)
    block.move(RAPID, end, None, 0.0)


def _words(block: Block, end: Point) -> Thread:
    slots, scale = block.plan.slots, block.model.scale
    _check_words(block)
    own = scale / 2 if block.model.diameter else scale
    crest, first, depth = (abs(block.value(letter)) * own for letter in "IJK")
    begin = block.model.work(block.known_position((0, 2)))  # a lathe has no Y
    back = -1.0 if end[2] > begin[2] else 1.0  # a thread may be cut away from the chuck
    taper = max(0.0, block.value("E") * scale) if "E" in slots else 0.0
    pitch = block.value("P")
    flags = max(0, int(block.value("L"))) if "L" in slots else 0
    return Thread(
        *(begin, end, 1.0 if block.value("I") > 0 else -1.0, crest, first, depth, pitch),
        slant=back * tan(radians(block.value("Q"))) if "Q" in slots and block.value("Q") != -1 else 0.0,
        spring=max(-1, int(block.value("H"))) if "H" in slots else 0,
        degression=max(1.0, block.value("R")) if "R" in slots else 1.0,
        taper=back * taper,
        taper_pitch=pitch * hypot(taper, depth) / taper if taper else pitch,
        entry=bool(taper and flags & 1),
        leaving=bool(taper and flags & 2),
    )


def _check_words(block: Block) -> None:
    i, j, k = (block.value(letter) for letter in "IJK")
    wrong = "I" if i == 0 else "J" if j <= 0 else "K" if k <= j else ""
    if wrong:
        what = {"I": "I of G76 may not be 0", "J": "J of G76 must be above 0", "K": "K of G76 must be above J"}[wrong]
        raise ProgramError("bad-value", what, value=wrong, advice=Text("correct {letter}", letter=wrong))


def _pass(block: Block, words: Thread, depth: float) -> None:
    """One pass: back to the drive line's side, in, along, out."""
    shift = depth * words.slant
    top, target = words.begin[2] - shift, words.end[2] + words.depth * words.slant - shift
    aside, bottom = depth - words.depth, words.crest + depth  # between passes, and in the thread, from the drive line
    crest = bottom - words.depth
    _to(block, words, RAPID, aside, top)
    if words.entry:
        block.call("DISABLE_FEED_OVERRIDE()")
        synchronise(block, words.taper_pitch)
        _to(block, words, LINE, crest, top)
        _to(block, words, LINE, bottom, top - words.taper, words.taper_pitch)
        synchronise(block, words.pitch)
    else:
        _to(block, words, RAPID, bottom, top)
        block.call("DISABLE_FEED_OVERRIDE()")
        synchronise(block, words.pitch)
    if words.leaving:
        _to(block, words, LINE, bottom, target + words.taper)
        synchronise(block, words.taper_pitch)
        _to(block, words, LINE, crest, target, words.taper_pitch)
    else:
        _to(block, words, LINE, bottom, target)
    block.call("STOP_SPEED_FEED_SYNCH()")
    _to(block, words, RAPID, aside, target)
    block.call("ENABLE_FEED_OVERRIDE()")


def _to(block: Block, words: Thread, motion: int, away: float, z: float, pitch: float = 0.0) -> None:
    """Move to `away` from the drive line, towards the thread, and to a Z; pitch: where it is not that of the thread."""
    x, y, _ = words.begin
    end = block.model.machine((x + words.way * away, y, z))
    block.move(motion, end, None, 0.0 if motion == RAPID else feed_of_pitch(block, pitch or words.pitch, end))
