# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads blocks of canned cycles as LinuxCNC does: sticky words, repeats, and the run's first height for G98.

A run lasts as long as a canned cycle is modal. Its words stick in the text's own units and in program coordinates,
as those of LinuxCNC do: they are not converted when units or offsets change.

The canned cycles that need the spindle: tapping (G74, G84) and boring (G85 to G89), as LinuxCNC 2.9.

G84, G74  down, turn the other way, wait P, up, turn as before         G85  down, up to R (both at the feed)
G86       down, wait P, stop, rapid up, turn                           G88  down, wait P, stop, pause, turn
G89       down, wait P, up (both at the feed)
G87       stopped, beside the hole: down; to its axis, turn, up to the middle, down; stopped: beside it, up
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import partial

from CNCStepper.canned_cycle_expansion import DWELL, FEED, OWN_WORD, PECK_BACK_MM, RAPID, Canned, Place, Stroke
from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import ALL_AXES, AXES, CYCLES, MOTION_NAMES, Code
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.functions.outputs import OVERRIDE_CALLS
from CNCStepper.gcode.interpreter.functions.spindle import STOP, need_turning, turn
from CNCStepper.gcode.interpreter.motion.end_points import polar_end
from CNCStepper.gcode.interpreter.state.interpreter_state import Point, Run
from CNCStepper.gcode.interpreter.state.stand_alone_position import continue_at
from CNCStepper.toolpath import LINE, PLANE_AXES, PLANE_NAMES, XY

TURN, REVERSE, STOP_TURNING, ORIENT, PAUSE, LOCK, UNLOCK = (
    "turn",
    "reverse",
    "stop",
    "orient",
    "pause",
    "lock",
    "unlock",
)
OWN = {"G74": "P", "G84": "P", "G85": "", "G86": "P", "G87": "IJK", "G88": "P", "G89": "P"}
SENSE = {"G84": "cw", "G74": "ccw", "G86": "", "G87": "", "G88": ""}  # in which the spindle must turn; "" is any


@dataclass(frozen=True)
class SpindleCycle(Canned):
    """Such a cycle; own: P in seconds. aside: G87's offset in the plane, middle: how far up it bores."""

    aside: tuple[float, float] = (0.0, 0.0)
    middle: float = 0.0

    @property
    def pecks(self) -> float:
        """About how many times the tool goes down for a hole."""
        return 3.0

    def holes(self, height: float, initial: float, places: Iterable[tuple[float, float]]) -> Iterator[list[Stroke]]:
        """Yield the strokes of each hole, one after the other from `height`."""
        clear = self.clear(initial)
        for place in places:
            over = height if height > self.r else clear
            way_in = [Stroke(RAPID, (*place, over))] + [Stroke(RAPID, (*place, self.r))] * (over > self.r)
            yield way_in + list(self._work(place, clear))
            height = clear

    def _work(self, place: tuple[float, float], clear: float) -> Iterator[Stroke]:
        """Yield the strokes of a hole, from R on."""
        bottom, top = (*place, self.z), (*place, clear)
        if self.name == "G87":
            yield from self._back_bore(place, clear)
            return
        if self.name in ("G74", "G84"):
            yield Stroke(LOCK, bottom)
            yield from (Stroke(FEED, bottom), Stroke(STOP_TURNING, bottom), Stroke(REVERSE, bottom))
            yield from (Stroke(DWELL, bottom, self.own), Stroke(FEED, top), Stroke(STOP_TURNING, top))
            yield from (Stroke(TURN, top), Stroke(UNLOCK, top))
            return
        yield Stroke(FEED, bottom)
        if self.name != "G85":
            yield Stroke(DWELL, bottom, self.own)
        if self.name == "G85":
            yield from (Stroke(FEED, (*place, self.r)), Stroke(RAPID, top))
            return
        if self.name == "G89":
            yield Stroke(FEED, top)
            return
        yield Stroke(STOP_TURNING, bottom)
        yield Stroke(RAPID, top) if self.name == "G86" else Stroke(PAUSE, bottom)
        yield Stroke(TURN, top)

    def _back_bore(self, place: tuple[float, float], clear: float) -> Iterator[Stroke]:
        beside = (place[0] + self.aside[0], place[1] + self.aside[1])
        deep, free = (*place, self.z), (*beside, self.z)
        yield from (Stroke(RAPID, (*beside, self.r)), Stroke(STOP_TURNING, free), Stroke(ORIENT, free))
        yield from (Stroke(RAPID, free), Stroke(RAPID, deep), Stroke(TURN, deep))
        yield from (
            Stroke(FEED, (*place, self.middle)),
            Stroke(FEED, deep),
            Stroke(STOP_TURNING, deep),
            Stroke(ORIENT, deep),
        )
        yield from (Stroke(RAPID, free), Stroke(RAPID, (*beside, clear)), Stroke(RAPID, (*place, clear)))
        yield Stroke(TURN, (*place, clear))


MOST_STROKES = 1_000_000  # of one block
DIGITS = 9  # of a position in the text's units: what the table's millimetres add is no height
ORIENT_WAY = {"cw": 2, "ccw": 3}  # LinuxCNC's numbers of the senses
EXACT_PATH = "SET_MOTION_CONTROL_MODE(CANON_EXACT_PATH)"


class LinuxCNCCanned(Canned):
    """A canned cycle whose pecks are summed up as LinuxCNC sums them."""

    def levels(self) -> Iterator[float]:
        """Yield where the pecks but the last end; the rounding of the sum may add one that goes no deeper."""
        level = self.r - self.own
        while level > self.z:
            yield level
            level -= self.own


def run_block(block: Block, motion: int, before: int) -> None:
    """Execute a block of the cycle `motion`; `before`: the motion that was modal. Raises ProgramError."""
    axes = PLANE_AXES[PLANE_NAMES.index(block.model.state.plane)]
    name, normal = MOTION_NAMES[motion], axes[2]
    _check_block(block, name)
    begin = _program(block, axes)
    run = block.model.run if before in CYCLES else None
    sticky = run if before == motion else None
    initial = run.initial if run else begin[2]
    z = _word(block, AXES[normal], sticky and sticky.z, name)
    r = _word(block, "R", sticky and sticky.r, name)
    own = _own(block, name, sticky)
    bore = _bore(block, name, sticky)
    dwell = own if (OWN_WORD | OWN)[name] == "P" else _last_dwell(block)
    block.model.run = Run(initial, z, r, own, bore, dwell)
    if not block.model.absolute:
        z, r = round(initial + r + z, DIGITS), round(initial + r, DIGITS)
    cycle = _cycle(block, name, z, r, own, bore)
    _check_heights(cycle, AXES[normal])
    places = _places(block, axes, begin, cycle)
    _check_strokes(cycle, len(places))
    _execute(block, cycle, axes, begin, initial, places)


def retract(block: Block, code: Code) -> None:
    """G98, G99: canned cycles go back to where they began, or to R."""
    block.uncompensated("the retract mode may not be changed", code.name)
    block.model.to_initial = code.name == "G98"


def _execute(block: Block, cycle: Canned, axes: tuple[int, int, int], begin: Place, initial: float, places) -> None:
    """Move through the cycle, with the canonical calls that LinuxCNC has between the moves."""
    lift = cycle.lift(begin, initial)
    for stroke in lift:
        _stroke(block, stroke, axes)
    exact = block.model.path_calls[0] == EXACT_PATH
    if not exact:
        block.call(EXACT_PATH)
    for place, strokes in zip(places, cycle.holes(cycle.r if lift else begin[2], initial, places), strict=True):
        drills = axes == PLANE_AXES[XY] and cycle.name in OWN_WORD
        if drills:
            block.do(partial(block.table.open_span, "cycle", cycle.name, **_span_words(block, cycle, place)))
        for stroke in strokes:
            _stroke(block, stroke, axes)
        if drills:
            block.do(block.table.close_span)
    if cycle.name == "G88" and places:  # the operator has lifted the tool in the pause
        continue_at(block.model, _machine(block, (*places[-1], cycle.clear(initial)), axes))
    for call in () if exact else block.model.path_calls:
        block.call(call)


def _stroke(block: Block, stroke: Stroke, axes: tuple[int, int, int]) -> None:
    model, end = block.model, _machine(block, stroke.end, axes)
    if stroke.kind == DWELL:
        block.event("dwell", stroke.seconds)
        block.call(f"DWELL({stroke.seconds:.4f})")
    elif stroke.kind == RAPID:
        block.rapid(end, row=end != model.position)
    elif stroke.kind == FEED:
        block.move(LINE, end, None, block.feed_of(LINE, end))
    else:
        _spindle_stroke(block, stroke.kind)


def _spindle_stroke(block: Block, kind: str) -> None:
    """Switch the spindle as the cycle does; `block.turning` is its sense before the hole."""
    other = {"cw": "ccw", "ccw": "cw"}[block.turning]
    if kind in (TURN, REVERSE):
        turn(block, block.turning if kind == TURN else other)
    elif kind == STOP_TURNING:
        block.model.change(spindle="off")
        block.call(STOP)
    elif kind == ORIENT:
        block.event("orient")
        block.call(f"ORIENT_SPINDLE(0, 0.0000, {ORIENT_WAY[block.turning]})")
    elif kind == PAUSE:
        block.event("pause")
        block.call("PROGRAM_STOP()")
    else:  # a spindle that the program has switched off stays off
        locks, allowed = kind == LOCK, block.model.overrides
        for name in ("feed", "speed"):
            if locks or name in allowed:
                block.call(f"{'DISABLE' if locks else 'ENABLE'}_{OVERRIDE_CALLS[name]}")


def _span_words(block: Block, cycle: Canned, place: tuple[float, float]) -> dict[str, float]:
    """Return the words of a hole's block in machine mm; seconds for P."""
    model = block.model
    x, y, z = _machine(block, (*place, cycle.z), PLANE_AXES[XY])
    words = {"X": x, "Y": y, "Z": z, "R": cycle.r * model.scale + model.offset[2]}
    if letter := OWN_WORD[cycle.name]:
        words[letter] = cycle.own * (model.scale if letter == "Q" else 1.0)
    return words | {"G": 98.0 if cycle.to_initial else 99.0}


def _cycle(block: Block, name: str, z: float, r: float, own: float, bore: Place) -> Canned:
    to_initial = block.model.to_initial
    if name in OWN:
        middle = bore[2] if block.model.absolute else round(z + bore[2], DIGITS)
        return SpindleCycle(name, z, r, own, to_initial, aside=bore[:2], middle=middle)
    return LinuxCNCCanned(name, z, r, own, block.model.to_initial, PECK_BACK_MM / block.model.scale)


def _places(block: Block, axes: tuple[int, int, int], begin: Place, cycle: Canned) -> list[tuple[float, float]]:
    """Return the positions of the block's holes, L times."""
    slots = block.plan.slots
    count = block.whole("L", 1, int(MOST_STROKES / (4.0 * cycle.pecks) + 1.0)) if "L" in slots else 1
    if block.plan.polar:
        return _polar_places(block, begin, count)
    words = [block.value(AXES[axis]) if AXES[axis] in slots else None for axis in axes[:2]]
    if block.model.absolute:
        a, b = (here if word is None else word for word, here in zip(words, begin, strict=False))
        return [(a, b)] * count
    da, db = (word or 0.0 for word in words)
    places, (a, b) = [], begin[:2]
    for _ in range(count):
        a, b = a + da, b + db
        places.append((a, b))
    return places


def _polar_places(block: Block, begin: Place, count: int) -> list[tuple[float, float]]:
    """Return the positions of holes in polar coordinates (@, ^); under G91 each counts from the one before."""
    model, here = block.model.local(), complex(*begin[:2]) * block.model.scale
    places = []
    for _ in range(count):
        end = polar_end(model, block.plan, block.values, here)
        here = here if model.absolute else complex(*end)
        places.append((round(end[0] / model.scale, DIGITS), round(end[1] / model.scale, DIGITS)))
    return places


def _own(block: Block, name: str, sticky: Run | None) -> float:
    letter = (OWN_WORD | OWN)[name]
    if letter not in ("P", "Q"):
        return 0.0
    if name in ("G74", "G84"):  # their P may be left out
        return block.value("P") if "P" in block.plan.slots else _last_dwell(block)
    own = _word(block, letter, sticky and sticky.own, name)
    if own < 0 or (letter == "Q" and own == 0):
        what = Text(
            "{letter} of {name} must be {word} 0",
            letter=letter,
            name=name,
            word="above" if letter == "Q" else "at least",
        )
        raise ProgramError("bad-value", what, value=letter, advice=Text("correct {letter}", letter=letter))
    return own


def _word(block: Block, letter: str, sticky: float | None, name: str) -> float:
    """Return a word's number, or the one that sticks; raises ProgramError where there is neither."""
    if letter in block.plan.slots:
        return block.value(letter)
    if sticky is None:
        what = Text("{name} needs a {letter} word: none is in force", name=name, letter=letter)
        raise ProgramError("missing-word", what, value=name, advice=Text("add {letter}", letter=letter))
    return sticky


def _last_dwell(block: Block) -> float:
    return block.model.run.dwell if block.model.run else 0.0


def _bore(block: Block, name: str, sticky: Run | None) -> Place:
    """Return G87's way aside in the plane, and along its normal the height to bore to."""
    if name != "G87":
        return 0.0, 0.0, 0.0
    letters = ["IJK"[axis] for axis in PLANE_AXES[PLANE_NAMES.index(block.model.state.plane)]]
    old = sticky.bore if sticky else (None, None, None)
    a, b, c = (_word(block, letter, value, name) for letter, value in zip(letters, old, strict=True))
    return a, b, c


def _check_block(block: Block, name: str) -> None:
    """Check what no word of the cycle is."""
    block.uncompensated("canned cycles may not be used", name)
    for letter in ALL_AXES[3:6]:
        if letter in block.plan.slots:
            what = "a canned cycle moves X, Y and Z only"
            raise ProgramError(
                "unused-word", what, value=letter, advice=Text("move {letter} on a line of its own", letter=letter)
            )
    if name in ("G74", "G84") and block.model.plane_code != "G17":  # LinuxCNC 2.9 feeds to another place then
        what = Text(
            "{name} is read in the plane XY only: LinuxCNC moves along the wrong axes in {plane_code}",
            name=name,
            plane_code=block.model.plane_code,
        )
        raise ProgramError("plane", what, value=name, advice="write G17 before, or tap with G33.1")
    _check_feed(block, name)
    block.turning = need_turning(block, name, SENSE[name]) if name in SENSE else "off"


def _check_feed(block: Block, name: str) -> None:
    state = block.model.state
    if state.feed_mode == "inverse_time":
        advice = "write G94 before"
        raise ProgramError("feed-mode", "a canned cycle takes no inverse time feed", value=name, advice=advice)
    if (state.feed_mm_turn if state.feed_mode == "per_turn" else state.feed_mm_min) <= 0:
        raise ProgramError(
            "no-feed", Text("{name} has no feed", name=name), value=name, advice="write an F word above 0 before"
        )


def _check_heights(cycle: Canned, normal: str) -> None:
    if cycle.r < cycle.z:
        limit = Text("at least {z:g}", z=cycle.z)
        raise ProgramError(
            "retract-low",
            Text("R lies below {normal}", normal=normal),
            value="R",
            limit=limit,
            advice=Text("correct R or {normal}", normal=normal),
        )


def _check_strokes(cycle: Canned, count: int) -> None:
    if cycle.pecks * count * 4.0 > MOST_STROKES:
        limit = Text("{most_strokes} moves in one block", most_strokes=MOST_STROKES)
        raise ProgramError("pecks-many", "Q asks for too many pecks", value="Q", limit=limit, advice="make Q larger")


def _program(block: Block, axes: tuple[int, int, int]) -> Place:
    """Return the position in program coordinates and the text's units; only axes with a word may be unknown."""
    model, slots = block.model, block.plan.slots
    needed = [axis for axis in axes if axis == axes[2] or not model.absolute or AXES[axis] not in slots]
    for axis in needed:
        block.known(axis)
    work = model.work(model.position)
    a, b, c = (round(work[axis] / model.scale, DIGITS) for axis in axes)
    return a, b, c


def _machine(block: Block, place: Place, axes: tuple[int, int, int]) -> Point:
    model, end = block.model, [0.0, 0.0, 0.0]
    for axis, value in zip(axes, place, strict=True):
        end[axis] = value * model.scale
    return model.machine((end[0], end[1], end[2]))
