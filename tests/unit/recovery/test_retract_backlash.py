# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motors that have play lead the tool back along its way: judged by pushing it through its gaps, point after point."""

from __future__ import annotations

import random
from collections.abc import Sequence
from itertools import pairwise

import numpy as np
import pytest

from CNCStepper.control.stream.return_after_jog import landed_mm, over_backlash
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.machine.backlash import Backlash, Motors
from CNCStepper.motion.planner.backlash_moves import tool_moves
from CNCStepper.recovery.retract.move_curve import Move
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath, stretch_moves
from CNCStepper.recovery.retract.wire_writer import crossing, taken_up
from CNCStepper.simulation.tip_segments import segments
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, RAPID, Toolpath
from helpers.gcode.backlash_programs import program_of_places, pushed, random_program

AT_ZERO = Start.at_zero()
STEPS_PER_MM = (80.0, 80.0, 400.0)
STEP_MM = 0.018  # of X, Y and Z at once
SEEDS = range(16)


def some_play(rng: random.Random) -> Backlash:
    gaps = tuple(rng.choice((0.0, 1.0)) * rng.uniform(0.005, 0.4) for _ in range(3))
    return Backlash((*gaps[:2], 0.1), tuple(rng.choice((-1, 1)) for _ in range(3)), STEPS_PER_MM)


def farthest_mm(points: np.ndarray, path: Toolpath) -> float:
    """Return how far points are from the way of a table of moves at most."""
    ways = segments(path, 0.005)
    way = ways.end - ways.begin
    length2 = np.maximum((way**2).sum(axis=1), 1e-18)
    farthest = 0.0
    for point in points[:: max(1, len(points) // 300)]:
        share = np.clip(((point - ways.begin) * way).sum(axis=1) / length2, 0.0, 1.0)
        farthest = max(farthest, float(np.linalg.norm(ways.begin + share[:, None] * way - point, axis=1).min()))
    return farthest


class Loose:
    """A random program whose play is taken up, and the tool at some place of it, as likely in a gap as on a cut.

    path: of the tool as the program says. codes: by which it goes to places, arcs too where none are named.
    """

    def __init__(self, seed: int, codes: Sequence[str] = ()):
        self.rng = rng = random.Random(seed)
        self.play = some_play(rng)
        program = program_of_places(rng, 12, codes) if codes else random_program(rng, 12)
        self.path = interpret(program, AT_ZERO)
        wire = prepare(program, "grbl", "", AT_ZERO, self.play)
        motors = interpret("".join(f"{line}\n" for line in wire.lines), AT_ZERO)
        self.motors, self.way = RetractPath(motors), RetractPath(tool_moves(motors, self.play))
        self.place = self.some_place()
        here = [self.motors.move(row).part(0.0, 1.0) for row in range(self.place.row)]
        here.append(self.motors.move(self.place.row).part(0.0, self.place.share))
        self.motors_mm, self.tool_mm = here[-1].end, pushed(self.play, np.zeros(3), here)[-1]

    def some_place(self) -> Place:
        rows = [row for row in range(len(self.way)) if self.way.move(row).is_still == (self.rng.random() < 0.5)]
        return Place(self.rng.choice(rows), self.rng.uniform(0.05, 0.95))


@pytest.mark.parametrize("seed", SEEDS)
def test_tool_goes_to_any_other_place_along_its_way(seed: int) -> None:
    print("seed", seed)
    loose = Loose(seed)
    assert farthest_mm(wandered(loose), loose.path) < STEP_MM


@pytest.mark.parametrize("seed", SEEDS)
def test_tool_goes_back_along_lines_to_places_of_the_machine(seed: int) -> None:
    """Which it has gone straight, though short of some places by its play."""
    print("seed", seed)
    loose = Loose(seed, ("G1", "G53G0", "G53G1"))
    assert farthest_mm(wandered(loose), loose.way.toolpath) < STEP_MM


def wandered(loose: Loose) -> np.ndarray:
    """Return where the tool is on its ways to some places, one after another, to which it comes."""
    motors, tool_mm = Motors(loose.play, loose.motors_mm), loose.tool_mm
    begin, reached = loose.place, [tool_mm[None]]
    for _ in range(3):
        end = loose.some_place()
        reached.append(
            pushed(loose.play, tool_mm, [move for move, _ in taken_up(stretch_moves(loose.way, begin, end), motors)])
        )
        begin, tool_mm = end, reached[-1][-1]
        assert tool_mm == pytest.approx(loose.way.move(end.row).at(end.share), abs=STEP_MM)
    return np.vstack(reached)


@pytest.mark.parametrize("seed", SEEDS)
def test_program_goes_on_with_the_motors_where_it_has_them(seed: int) -> None:
    print("seed", seed)
    loose = Loose(seed)
    end = Place(loose.place.row, 1.0)
    motors, own = Motors(loose.play, loose.motors_mm), loose.motors.move(end.row)
    moves = [move for move, _ in taken_up(stretch_moves(loose.way, loose.place, end), motors)]
    moves.append(crossing(motors.at_mm, own.end, own, loose.play))
    on = [loose.motors.move(row) for row in range(end.row + 1, len(loose.motors))]
    tool = pushed(loose.play, loose.tool_mm, [*moves, *on])
    assert farthest_mm(tool, loose.path) < STEP_MM
    assert tool[-1] == pytest.approx(loose.way.move(len(loose.way) - 1).end, abs=STEP_MM)


@pytest.mark.parametrize("seed", SEEDS)
def test_each_move_of_the_motors_is_the_part_of_the_way_that_it_says(seed: int) -> None:
    print("seed", seed)
    loose = Loose(seed)
    tool_mm = loose.tool_mm
    for move, (row, first, last) in taken_up(
        stretch_moves(loose.way, loose.place, loose.some_place()), Motors(loose.play, loose.motors_mm)
    ):
        for share, part in pairwise((0.0, 0.3, 1.0)):
            tool_mm = pushed(loose.play, tool_mm, [move.part(share, part)])[-1]
            assert tool_mm == pytest.approx(loose.way.move(row).at(first + (last - first) * part), abs=STEP_MM)


@pytest.mark.parametrize("seed", SEEDS)
def test_jogged_tool_comes_to_its_place_from_either_side_of_its_gaps(seed: int) -> None:
    print("seed", seed)
    rng = random.Random(seed)
    play = some_play(rng)
    there = tuple(rng.uniform(-20.0, -10.0) for _ in range(3))
    here = rng.choice((there, landed_mm(there, play), tuple(rng.uniform(-20.0, -10.0) for _ in range(3))))
    sides = [
        rng.uniform(min(0.0, gap * sense), max(0.0, gap * sense))
        for gap, sense in zip(play.backlash_mm, play.true_sense, strict=True)
    ]
    moves, at = [], here
    for place, _ in over_backlash(here, there, rng.uniform(-20.0, -5.0), play):
        moves.append(Move(LINE, at, tuple(now if to is None else to for now, to in zip(at, place, strict=True))))
        at = moves[-1].end
    assert at == pytest.approx(landed_mm(there, play))
    tool = pushed(play, np.add(here, sides), moves)
    assert tool[-1] == pytest.approx(there, abs=0.006)
    aside = np.linalg.norm(np.diff(tool[:, :2], axis=0), axis=1) > 1e-9
    assert not aside.any() or tool[:-1][aside][:, 2].min() > there[2] - 1e-6


def test_beam_is_off_while_motors_cross_their_gaps_alone() -> None:
    there, own = (1.0, 0.0, 0.0), Move(LINE, (0.0, 0.0, 0.0), (9.0, 0.0, 0.0), feed_mm_min=300.0)
    gaps = (0.1, 0.1, 0.1), (-1, -1, -1), STEPS_PER_MM
    assert crossing((0.9, 0.0, 0.0), there, own, Backlash(*gaps, beam=True)).kind == RAPID
    assert crossing((0.9, 0.0, 0.0), there, own, Backlash(*gaps)).feed_mm_min == 300.0
