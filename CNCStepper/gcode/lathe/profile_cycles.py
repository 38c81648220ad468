# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lathe cycles along a profile, G70, G71 and G72: subroutine O<Q> draws it, `roughing_and_finishing.py` cuts it.

The blocks of the subroutine are read, not executed: X Z (or U W, from the point before) end a line or an arc, A rounds
the corner after it and C breaks it. O-words and parameters work as ever; #<_x> and #<_z> follow the profile.
"""

from __future__ import annotations

from math import sqrt

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.interpreter.motion.straight_and_arc_moves import arc, straight
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.lathe.roughing_and_finishing import Turning
from CNCStepper.gcode.lathe.turned_profile import Segment
from CNCStepper.gcode.syntax.line_grammar import Plan
from CNCStepper.gcode.syntax.words import Word
from CNCStepper.tolerances import SAME_TEXT_PLACE
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID

PROFILE_WORDS = "XZUWIKRAC"


def run_profile(block: Block, motion: int, before: int) -> None:
    """Read the profile and cut it; raises ProgramError."""
    name = MOTION_NAMES[motion]
    _check(block, name)
    model, words = block.model, dict(zip(block.plan.slots, block.values, strict=True))
    incremental = not model.absolute
    centres = model.state.arc_centres
    model.change(distance="absolute", arc_centres="absolute")
    started, here = model.position, place_of(block)
    begin = complex(words.get("Z", here.real), words.get("X", here.imag))
    if incremental:
        begin = here + complex(words.get("Z", 0.0), words.get("X", 0.0))
    tool = CycleTool(block)
    tool.rapid(complex(words.get("Z", here.real), words.get("X", here.imag)))
    reader = ProfileBlocks(begin, model.motion, incremental, centres == "incremental")
    if block.read_profile is None:
        what = Text("{name} needs the whole program: the profile is a subroutine", name=name)
        raise ProgramError("no-subroutine", what, value=name, advice="read the program as a whole")
    block.read_profile(round(words["Q"]), model, reader.block)
    model.position = started
    if len(reader.segments) > 1:
        _cut(name, words, begin, reader, tool)
    distance = "incremental" if incremental else "absolute"
    model.change(distance=distance, arc_centres=centres)


def _check(block: Block, name: str) -> None:
    block.must_have("Q", name)
    block.known_position((0, 2))  # a lathe has no Y
    block.uncompensated(
        Text("{name} may not be used", name=name), name
    )  # LinuxCNC 2.9 takes G70 then, and cuts elsewhere
    if block.model.state.plane != "ZX":
        raise ProgramError(
            "plane", Text("{name} works in the plane ZX", name=name), value=name, advice="write G18 before"
        )
    if "I" in block.plan.slots and block.value("I") <= 0:
        raise ProgramError("bad-value", Text("I of {name} must be above 0", name=name), value="I", advice="correct I")


def place_of(block: Block) -> complex:
    """Return where the tool is: Z + iX in units of the text, X a radius."""
    x, _, z = block.model.programmed_work()
    return complex(z, x) / block.model.scale


def _cut(name: str, words: dict[str, float], begin: complex, reader: ProfileBlocks, tool: CycleTool) -> None:
    away, escape = words.get("D", 0.0), words.get("R", 0.5)
    cycle = Turning(reader.segments)
    if name == "G70":
        passes = int(words.get("P", 1.0))
        cycle.finish(tool, begin, away, words.get("E", 0.0), passes)
        return
    mode = int(name.partition(".")[2] or 0)
    cycle.rough(tool, mode, begin, away, words.get("I", 1.0), escape, name.startswith("G72"))


class ProfileBlocks:
    """Takes the blocks of the subroutine, one after the other."""

    def __init__(self, begin: complex, motion: int, incremental: bool, relative_centres: bool):
        self.end = begin
        self.segments: list[Segment] = []
        self.incremental = incremental
        self.relative_centres = relative_centres
        self.motion = motion

    def block(self, model: Model, words: list[Word], values: list[float]) -> None:
        """Take a block: its words, and the values of all but G and M; `model` follows the profile."""
        letters = [word.letter for word in words if word.letter not in "GM"]
        given = {letter: value for letter, value in zip(letters, values, strict=True) if letter in PROFILE_WORDS}
        for word in words:
            if word.letter == "G" and word.name in MOTION_NAMES:
                self.motion = MOTION_NAMES.index(word.name)
        if model.diameter:
            given |= {letter: given[letter] / 2 for letter in "XU" if letter in given}
        end = self._end(given)
        if end == self.end:
            return
        if self.motion in (RAPID, LINE, ARC_CW, ARC_CCW):
            self._add(given, end)
        self.end = end
        _, y, _ = model.programmed_work()
        model.position = model.machine((end.imag * model.scale, y, end.real * model.scale))

    def _end(self, given: dict[str, float]) -> complex:
        z, x = (0.0, 0.0) if self.incremental else (self.end.real, self.end.imag)
        for letter, other in ("UX", "WZ"):
            if letter in given and (self.incremental or other in given):
                what = Text(
                    "{letter} continues from the last point: neither with {other} nor under G91",
                    letter=letter,
                    other=other,
                )
                raise ProgramError("profile", what, value=letter, advice=Text("write {other} alone", other=other))
        end = complex(given.get("Z", z + given.get("W", 0.0)), given.get("X", x + given.get("U", 0.0)))
        return end + self.end if self.incremental else end

    def _add(self, given: dict[str, float], end: complex) -> None:
        if self.motion in (RAPID, LINE):
            self.segments.append(Segment(self.end, end))
        else:
            self.segments.append(Segment(self.end, end, self._centre(given, end), self.motion == ARC_CCW))
        if "A" in given and "C" in given:
            what = "a corner is either rounded (A) or broken (C)"
            raise ProgramError("profile", what, value="C", advice="take one of them out")
        if "A" in given:
            self.segments.append(Segment(end, end, end, False, given["A"]))
        if "C" in given:
            self.segments.append(Segment(end, end, corner=given["C"]))

    def _centre(self, given: dict[str, float], end: complex) -> complex:
        if "R" in given:
            if "I" in given or "K" in given:
                raise ProgramError("arc-words", "an arc takes either R or a centre", value="R", advice="take out R")
            return self._centre_by_radius(given["R"], end)
        if not ("I" in given or "K" in given):
            raise ProgramError("arc-words", "the arc has neither I nor K nor R", advice="give its centre")
        centre = complex(given.get("K", 0.0), given.get("I", 0.0))
        return centre + self.end if self.relative_centres else centre

    def _centre_by_radius(self, radius: float, end: complex) -> complex:
        chord = end - self.end
        square = (radius * radius - abs(chord) ** 2 / 4) / abs(chord) ** 2
        if square < 0:
            what = "the radius is too small to reach the end of the arc"
            raise ProgramError("arc-radius", what, value="R", advice="correct R or the end point")
        aside = 1j * sqrt(square) * chord
        return (self.end + end) / 2.0 + (aside if self.motion == ARC_CCW else -aside)


class CycleTool:
    """Makes the moves of the cycle as blocks with X and Z would be made."""

    def __init__(self, block: Block):
        self.block = block

    def line(self, end: complex) -> None:
        """G1."""
        self._move(LINE, X=end.imag, Z=end.real)

    def rapid(self, end: complex) -> None:
        """G0."""
        self._move(RAPID, X=end.imag, Z=end.real)

    def arc(self, ccw: bool, centre: complex, end: complex) -> None:
        """G2 or G3; an arc that leads nowhere is none."""
        way = end - place_of(self.block)
        if max(abs(way.real), abs(way.imag)) > SAME_TEXT_PLACE:
            motion = ARC_CCW if ccw else ARC_CW
            self._move(motion, X=end.imag, Z=end.real, I=centre.imag, K=centre.real)

    def _move(self, motion: int, **words: float) -> None:
        block = self.block
        slots = {letter: place for place, letter in enumerate(words)}
        outer = block.plan, block.values
        block.plan = Plan(slots, (), motion, True, (0, -1, 1), False, False, -1, -1)
        block.values = list(words.values())
        make = straight if motion in (RAPID, LINE) else arc
        make(block, motion, motion)
        block.plan, block.values = outer
        block.model.motion = motion
