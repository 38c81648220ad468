# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random programs restarted at random lines: what was cut before and the restart together are the whole cut.

The programs move their zero by G92, change work offsets, are in inches, enter by helix, ramp and drilled holes, and fly
beside the stock and through its valley below its top.
"""

from __future__ import annotations

import os
import random

import numpy as np
import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.recovery.restart.approach import Options
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from CNCStepper.recovery.restart.restart_program import Restart, restart
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.tip_segments import tips_mm
from CNCStepper.toolpath import RAPID, Toolpath
from helpers.simulation.seeded_programs import MACHINE, Program, clean_program

CASES = int(os.environ.get("CNCSTEPPER_CASES", "0"))
FEW, MANY = 1, max(4, CASES)
RESTARTS = 3  # of each program
SEED = int(os.environ.get("RESTART_SEED", "0")) or (
    1 if os.environ.get("CI") else random.SystemRandom().randrange(10**9)
)
CELL_MM = 0.5
OVERLAPS_MM = (0.0, 0.0, 0.5, 3.0)
NOWHERE = {"restart-at-start", "restart-nothing-left"}


def restarted(program: Program, pick: random.Random) -> Restart | None:
    """Return a restart at a random line or point; None where nothing is cut before, or after it."""
    options = Options(pick.choice(OVERLAPS_MM), spin_up_s=MACHINE.spindle.spin_up_s, tools=program.tools)
    where = RequestedPlace(line=pick.randint(1, len(program.blocks)))
    if pick.random() < 0.3:
        where = RequestedPlace(at_mm=(pick.uniform(-40, 40), pick.uniform(-30, 30), pick.uniform(-8, 0)))
    try:
        return restart(program.text, where, "grbl", program.start, "p.nc", options)
    except ProgramError as error:
        assert error.code in NOWHERE, error
        return None


def judge(program: Program, made: Restart, told: str) -> None:
    """Assert that a restart is safe, and completes the part."""
    own = interpret(made.text, made.start, "grbl", "p.nc")
    moves = followed(made.cut, own)
    found = check(
        own, MACHINE, file="p.nc", stock=program.stock, tools=program.tools, removals=program.removals, cut=moves
    )
    assert not found, (told, str(found[0]), made.text[:600])
    assert_enters_from_above(own, made, told)
    whole = interpret(program.text, program.start, "grbl", "p.nc")
    assert_same_end(whole, own, made, told)
    cuts = [height_map(path, program.tools, program.stock, CELL_MM).heights_mm for path in (whole, moves)]
    assert np.allclose(*cuts, atol=0.002), (told, float(np.abs(cuts[0] - cuts[1]).max()))


def assert_enters_from_above(own: Toolpath, made: Restart, told: str) -> None:
    """The first moves: straight up, over, and straight down at the plunge feed, with the spindle on by then."""
    table, tips = own.table(), tips_mm(own)[1]
    over = 1 + any(made.approach.state.g92_mm)  # there, and once more in the numbers of G92
    assert (table.kind[: over + 1] == RAPID).all(), told
    assert np.isnan(table.end[0, :2]).all(), told
    assert np.allclose(table.end[: over + 1, 2], table.end[0, 2]), told
    assert tips[0, 2] > 0, told
    if made.approach.plunge_mm_min:
        down = over + 1
        assert table.kind[down] != RAPID, told
        assert np.allclose(table.end[down, :2], table.end[over, :2]), told
        assert table.end[down, 2] < table.end[over, 2], told
        assert own.states[int(table.state[down])].spindle_turns, told


def assert_same_end(whole: Toolpath, own: Toolpath, made: Restart, told: str) -> None:
    """All moves after the one that is entered are those of the undisturbed run, in the same state."""
    old, new = whole.table(), own.table()
    count = len(old) - made.entrance.row - 1
    assert np.allclose(old.end[len(old) - count :], new.end[len(new) - count :], atol=1e-5), told
    pairs = zip(old.state[len(old) - count :].tolist(), new.state[len(new) - count :].tolist(), strict=True)
    for one, other in set(pairs):
        before, after = whole.states[one], own.states[other]
        assert np.allclose(before.offset_mm, after.offset_mm, atol=1e-6), told
        assert (before.units, before.work_system, before.tool) == (after.units, after.work_system, after.tool), told
        assert (before.spindle, before.spindle_rpm) == (after.spindle, after.spindle_rpm), told
        assert before.feed_mm_min == pytest.approx(after.feed_mm_min), told


def seeded(first: int, count: int) -> None:
    print(f"RESTART_SEED={SEED}")
    made = 0
    for seed in range(first, first + count):
        program, pick = clean_program(seed), random.Random(seed)
        for number in range(RESTARTS):
            one = restarted(program, pick)
            if one is not None:
                made += 1
                judge(program, one, f"seed {seed}, restart {number}, {one.entrance}")
    assert made >= count // 2, "hardly any place was entered"


@pytest.mark.slow
def test_random_programs_restarted_at_random_places_are_cut_whole():
    seeded(SEED, FEW)


def test_an_entry_in_inches_across_work_systems_is_near_enough_to_its_place():
    seeded(770399865, 1)


@pytest.mark.slow
def test_many_random_programs_restarted_at_random_places_are_cut_whole():
    seeded(SEED + FEW, MANY)
