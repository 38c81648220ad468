# SPDX-License-Identifier: LGPL-2.1-or-later
"""The thesis's programs on our controller with its own interpolators, pulse for pulse."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.interpolation.dda_moves import DdaMoves
from CNCStepper.motion.planner.machine_limits import Limits
from helpers.controllers.talk import Talk
from helpers.controllers.thesis_programs import PROGRAMS, Move, line_pulses, moves_of

STEPS_PER_MM = 10
FEED_MM_S, ACCELERATION_MM_S2 = 15.0, 125.0  # along 60/80 mm, where each axis may have 100 mm/s²


def table(interpolation: str = "dda", steps_per_mm: float = STEPS_PER_MM) -> Machine:
    machine = load_machine("thesis-table")
    axes = {name: axis.model_copy(update={"steps_per_mm": steps_per_mm}) for name, axis in machine.axis.items()}
    return machine.model_copy(update={"interpolation": interpolation, "axis": axes})


@pytest.mark.parametrize("number", PROGRAMS)
def test_a_program_of_the_thesis_comes_out_pulse_for_pulse(number: int) -> None:
    talk, moves = Talk(table()), moves_of(number)
    assert {move.centre is None for move in moves} == {True, False}
    talk.send("G21G90G94F900", *(move.words() for move in moves))
    played, first = talk.output.played, 0
    for move in moves:
        count = _pulses_to(played, first, move)
        pulses = played[first : first + count]
        if move.centre is None:
            way = tuple(round((b - a) * STEPS_PER_MM) for a, b in zip(move.begin, move.end, strict=True))
            assert [(step, back) for _, step, back, _ in pulses] == line_pulses(way)
        assert max(move.distance((x / STEPS_PER_MM, y / STEPS_PER_MM)) for *_, (x, y, _) in pulses) <= 1 / STEPS_PER_MM
        first += count
    assert first == len(played)


def _pulses_to(played: list, first: int, move: Move) -> int:
    """Return how many pulses there are up to and with the one that reaches a move's end."""
    end = (round(move.end[0] * STEPS_PER_MM), round(move.end[1] * STEPS_PER_MM), 0)
    return next(count for count in range(1, len(played) - first + 1) if played[first + count - 1][3] == end)


def test_a_lines_pulses_keep_the_vector_speed_between_their_ramps() -> None:
    talk = Talk(table())
    talk.send("G21G90G94F900", "G1X60Y80")
    times_s = np.array([time_s for time_s, *_ in talk.output.played])
    ramp_s = FEED_MM_S / ACCELERATION_MM_S2
    wanted_s = 100.0 / FEED_MM_S + ramp_s
    assert times_s[-1] - times_s[0] == pytest.approx(wanted_s - math.sqrt(2 * 0.1 / ACCELERATION_MM_S2), abs=0.001)
    middle = (times_s > times_s[0] + ramp_s) & (times_s < times_s[-1] - ramp_s)
    places = np.array([place[:2] for *_, place in talk.output.played])[middle] / STEPS_PER_MM
    inside_s = times_s[middle]
    speed = math.dist(places[0], places[-1]) / (inside_s[-1] - inside_s[0])
    assert speed == pytest.approx(FEED_MM_S, rel=0.005)


def test_figure_13_comes_out_as_published() -> None:
    """X pulses in rounds 13, 26 and 39, the first Y pulse in round 44: their waits are as their rounds."""
    moves = DdaMoves(Limits.of(table("published", 1.0)), (2, 11, 0), published=True)
    moves.arc((11.0, 2.0, 0.0), (1.0, 1.0), math.sqrt(101), True, 1.0)  # so slow that nothing is ramp
    pulses = moves.make(1e6)[0]
    rounds = pulses.ticks / pulses.ticks[0] * 13
    assert pulses.step[:4].tolist() == [1, 1, 1, 2]
    assert rounds[:4] == pytest.approx([13, 26, 39, 44], abs=0.3)
    assert (pulses.back[:4] & pulses.step[:4]).tolist() == [0, 0, 0, 2]


def test_the_board_makes_the_published_arc_of_its_profile() -> None:
    ours, published = (Talk(table(interpolation, 1.0)) for interpolation in ("dda", "published"))
    for talk in (ours, published):
        talk.send("G21G90G94F900", "G0X2Y11", "G2X11Y2I-1J-10")
    arcs = [[(step, back) for _, step, back, _ in talk.output.played[11:]] for talk in (ours, published)]
    assert arcs[0] != arcs[1]
    assert [talk.output.position_steps for talk in (ours, published)] == [(11, 2, 0)] * 2


def test_an_arc_that_is_not_in_xy_is_made_of_chords() -> None:
    machine = load_machine("table-a").model_copy(update={"controller": "thesis-a", "interpolation": "dda"})
    talk = Talk(machine)
    talk.send("G21G90G94F900", "G18G2X10Z0I5K0")
    assert talk.output.position_steps[0] == round(10 * machine.axes[0].steps_per_mm)
    highest = max(abs(place[2]) for *_, place in talk.output.played)
    assert highest == pytest.approx(5 * machine.axes[2].steps_per_mm, rel=0.02)
