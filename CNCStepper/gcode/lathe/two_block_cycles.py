# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The cycles of Fanuc's lathes in two blocks: G71 to G73 and G70 along a profile, G76 for threads.

    G71 U2. R0.5                    depth of cut (a radius), retract at 45 degrees
    G71 P10 Q20 U0.4 W0.1 F0.2      profile from N10 to N20; U and W shift it away: stock to leave along X and Z
    G72 W2. R0.5                    the same towards the axis
    G73 U6. W0. R3                  passes parallel to the profile, the first so far away, so many
    G70 P10 Q20                     the blocks N10 to N20 themselves; then, as after all of them, back to the start
    G76 P020060 Q50 R0.05           2 finishing passes, pull-out in tenths of the lead, angle; least cut, last cut
    G76 X26.2 Z-30. R0. P1840 Q350 F3.     floor, end, taper (a radius), depth, first cut, lead

P, Q and the least cut of G76 are in steps of the last digit. Pass n of a thread is first * sqrt(n) deep, and at least
the least cut deeper than the one before. A profile whose first block moves X alone (in G72 Z alone) has no pockets;
G71 of type II moves both. The words are those of the concise guide of Robur's F1 series (pages 48 to 50) and of myCNC's
page "G76 Thread Cycle". The pull-out is at 45 degrees, and the flank moves the begin of a pass as in LinuxCNC's G76.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import copysign, hypot, radians, sqrt, tan

from CNCStepper.errors import ProgramError, Text, all_of
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.block import Block
from CNCStepper.gcode.lathe.profile_cycles import CycleTool, ProfileBlocks, place_of
from CNCStepper.gcode.lathe.roughing_and_finishing import NO_POCKETS, Turning
from CNCStepper.gcode.lathe.threading import MOST_PASSES, begin_thread, feed_of_pitch, synchronise
from CNCStepper.gcode.lathe.turned_profile import Segment
from CNCStepper.toolpath import LINE, RAPID
from CNCStepper.units import LAST_DIGIT

FINISHING, ALONG_X, REPEATED, THREAD = "G70", "G72", "G73", "G76"
MOST_REPEATS = 1000  # passes of G73


def run_two_blocks(block: Block, motion: int, before: int) -> None:
    """Keep the words of a cycle's first block, or cut by those of its second; raises ProgramError."""
    name = MOTION_NAMES[motion]
    block.known_position((0, 2))
    block.uncompensated(Text("{name} may not be used", name=name), name)
    words = {letter: block.values[slot] for letter, slot in block.plan.slots.items()}
    if name == THREAD:
        _require_known(name, words, "XZUWPQRFN")
        if not {"X", "Z"} & {*words}:
            _keep(block, name, words)
        else:
            _cut_thread(block, motion, words)
        return
    _require_known(name, words, "PQUWRFSTN")
    if "P" not in words and name != FINISHING:
        _keep(block, name, words)
        return
    block.must_have("P", name)
    block.must_have("Q", name)
    _along_profile(block, name, words)


def _require_known(name: str, words: dict[str, float], letters: str) -> None:
    for letter in words:
        if letter not in letters:
            what = Text("{name} takes no {letter}", name=name, letter=letter)
            raise ProgramError("unused-word", what, value=letter, advice="take it out")


def _keep(block: Block, name: str, words: dict[str, float]) -> None:
    block.model.cycle_words = {**block.model.cycle_words, name: words}


def _first_block(block: Block, name: str, letters: str) -> dict[str, float]:
    """Return the words of a cycle's first block; raises ProgramError where it, or one of them, is missing."""
    words = block.model.cycle_words.get(name, {})
    for letter in letters:
        if letter not in words:
            what = Text("{name} needs its first block, with {letter}", name=name, letter=letter)
            advice = Text("write a block {name} with {letters} before", name=name, letters=all_of(letters))
            raise ProgramError("missing-word", what, value=name, advice=advice)
    return words


# along a profile


def _along_profile(block: Block, name: str, words: dict[str, float]) -> None:
    if block.numbered is None:
        what = Text("{name} needs the whole program: the profile is in other blocks", name=name)
        raise ProgramError("no-subroutine", what, value=name, advice="read the program as a whole")
    first, last = int(words["P"]), int(words["Q"])
    if name == FINISHING:
        block.numbered.run_after(first, last, block.model.position)
        return
    model, begin = block.model, place_of(block)
    started, centres = model.position, model.state.arc_centres
    reader = ProfileBlocks(begin, model.motion, incremental=False, relative_centres=centres == "incremental")
    block.numbered.read(first, last, model, reader.block)
    model.position = started
    if len(reader.segments) < 2:
        short = "the profile has no more than one move"
        raise ProgramError("profile", short, value=f"P{first} Q{last}", advice="name its first and its last block")
    model.change(arc_centres="absolute")
    leave = complex(words.get("W", 0.0), words.get("U", 0.0) / (2.0 if model.diameter else 1.0))
    tool = CycleTool(block)
    if name == REPEATED:
        _repeat(_first_block(block, name, "UWR"), reader.segments, begin, leave, tool)
    else:
        depth = _first_block(block, name, "WR" if name == ALONG_X else "UR")
        _rough(name, depth, reader.segments, begin, leave, tool)
    tool.rapid(begin)
    model.change(arc_centres=centres)


def _shifted(segments: list[Segment], by: complex) -> list[Segment]:
    return [
        replace(one, start=one.start + by, end=one.end + by, centre=None if one.centre is None else one.centre + by)
        for one in segments
    ]


def _rough(
    name: str, first: dict[str, float], segments: list[Segment], begin: complex, leave: complex, tool: CycleTool
) -> None:
    step = first["W" if name == ALONG_X else "U"]
    if step <= 0:
        what = Text("the depth of cut of {name} must be above 0", name=name)
        raise ProgramError("bad-value", what, value=name, advice="correct it")
    way = segments[0].end - segments[0].start
    alone = way.imag == 0.0 if name == ALONG_X else way.real == 0.0
    mode = NO_POCKETS if alone else 0
    cycle = Turning(_shifted(segments, leave))
    cycle.above = step
    cycle.rough(tool, mode, begin + leave, 0.0, step, first["R"], name == ALONG_X)


def _repeat(first: dict[str, float], segments: list[Segment], begin: complex, leave: complex, tool: CycleTool) -> None:
    """G73: the profile again and again, each time nearer."""
    count = int(first["R"])
    if count != first["R"] or not 1 <= count <= MOST_REPEATS:
        what, limit = "R of G73 is how many passes it makes", f"1 to {MOST_REPEATS}"
        raise ProgramError("bad-value", what, value="R", limit=limit, advice="correct R")
    for number in range(count, 0, -1):
        share = (number - 1) / (count - 1) if count > 1 else 0.0
        shift = leave + share * complex(first["W"], first["U"])
        tool.rapid(begin + shift)
        tool.rapid(segments[0].end + shift)
        for segment in _shifted(segments[1:], shift):
            segment.draw(tool)


# threads


def _cut_thread(block: Block, motion: int, words: dict[str, float]) -> None:
    """G76: roughing passes down to the last cut, then as many finishing passes as the first block asks for."""
    begin_thread(block, motion)
    for letter in "XZPQ":
        block.must_have(letter, THREAD)
    first, model = _first_block(block, THREAD, "PQR"), block.model
    unit = LAST_DIGIT[model.state.units]
    finishing, pull_out, angle = _six_digits(first["P"])
    depth, cut, least = (_digits(letter, from_) * unit for letter, from_ in (("P", words), ("Q", words), ("Q", first)))
    last = first["R"]
    if not (0 < cut <= depth and 0 <= last < depth):
        what = "Q of G76, the first cut, must be above 0 and at most P, the depth; the last cut below it"
        raise ProgramError("bad-value", what, value="Q", limit=f"{depth:g}", advice="correct Q, P or R")
    begin, lead = place_of(block), model.feed_number
    end, taper = complex(words["Z"], words["X"]), words.get("R", 0.0)
    way, side = copysign(1.0, end.real - begin.real), copysign(1.0, begin.imag - end.imag)
    out = min(0.1 * pull_out * lead, abs(end.real - begin.real))
    tool = _ThreadTool(block, lead)
    for deep in [*_depths(cut, depth - last, least), *[depth] * finishing]:
        above = side * (depth - deep)
        z = begin.real + way * deep * tan(radians(angle / 2.0))
        slope = taper / (begin.real - end.real)
        floor = [complex(at, end.imag + above + slope * (at - end.real)) for at in (z, end.real - way * out, end.real)]
        tool.rapid(complex(z, begin.imag))
        tool.rapid(floor[0])
        tool.follow(floor[1])
        if out:
            tool.follow(floor[2] + 1j * side * out)
        tool.rapid(complex(end.real, begin.imag))
        tool.rapid(begin)


def _six_digits(number: float) -> tuple[int, int, float]:
    """Return finishing passes, pull-out in tenths of the lead and angle, deg, of P with six digits."""
    whole = int(number)
    finishing, rest = divmod(whole, 10_000)
    if whole != number or not 1 <= finishing <= 99:
        what = "P of G76's first block is six digits: finishing passes, pull-out, angle"
        raise ProgramError("bad-value", what, value="P", limit="010000 to 999999", advice="write P010060, for example")
    return finishing, rest // 100, float(rest % 100)


def _digits(letter: str, words: dict[str, float]) -> float:
    if words[letter] != int(words[letter]):
        what = Text("{letter} of G76 has no point: it is in steps of the last digit", letter=letter)
        raise ProgramError("bad-value", what, value=letter, advice="write 0.35 mm as 350")
    return words[letter]


def _depths(first: float, depth: float, least: float) -> Iterator[float]:
    """Yield how deep each roughing pass is."""
    number, before = 0, 0.0
    while before < depth:
        number += 1
        before = min(max(first * sqrt(number), before + least if number > 1 else 0.0), depth)
        yield before
        if number > MOST_PASSES:
            limit = f"{MOST_PASSES} passes"
            raise ProgramError("passes-many", "Q makes too many passes", value="Q", limit=limit, advice="enlarge Q")


class _ThreadTool:
    """Moves the tool of a thread; places are Z + iX in units of the text, X a radius."""

    def __init__(self, block: Block, lead: float):
        self._block, self._lead = block, lead

    def rapid(self, place: complex) -> None:
        """G0."""
        self._block.move(RAPID, self._point(place), None, 0.0)

    def follow(self, place: complex) -> None:
        """Cut in step with the spindle: the lead is along the axis that moves farther."""
        way = place - place_of(self._block)
        pitch = self._lead * hypot(way.real, way.imag) / (max(abs(way.real), abs(way.imag)) or 1.0)
        end = self._point(place)
        synchronise(self._block, pitch)
        self._block.move(LINE, end, None, feed_of_pitch(self._block, pitch, end))

    def _point(self, place: complex) -> tuple[float, float, float]:
        model = self._block.model
        return model.machine((place.imag * model.scale, model.work(model.position)[1], place.real * model.scale))
