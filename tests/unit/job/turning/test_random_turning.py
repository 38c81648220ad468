# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random shafts and bores: no gouge above 0.005 mm, no rapid in stock, nothing left that an insert reaches."""

from __future__ import annotations

import pytest

from CNCStepper.job.turning.make_turning import in_part, placement_of, turned_moves
from CNCStepper.job.turning.report import judge_turning, setup_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.turning.swept_outline import moves_of
from helpers.cycles.seeds import SEEDS
from helpers.job.random_turning import random_job

WAYS = [{}, {"inside": True}, {"along": "x"}, {"along": "profile"}, {"hand": "left"}]
LEFT = [{"hand": "left"}, {"hand": "left", "along": "x"}, {"hand": "left", "along": "profile"}]


def judged(job):
    machine = load_machine("mini-lathe")
    table, answers = turned_moves(job, machine)
    moves = moves_of(in_part(table, placement_of(job, machine)))
    return judge_turning(moves, setup_of(job), job.x_is), answers


def way(seed: int) -> dict[str, str]:
    found = WAYS[seed % len(WAYS)]
    return LEFT[seed // len(WAYS) % len(LEFT)] if "hand" in found else found


@pytest.mark.parametrize("seed", SEEDS)
def test_random_profiles_are_cut_without_gouge_or_rapid_in_stock(seed):
    job = random_job(seed, "mini-lathe", **way(seed))
    verdict, answers = judged(job)
    assert [str(finding) for finding in verdict.findings if finding.severity != "info"] == []
    assert verdict.report()["deepest_cut_mm"] > 0
    roughed = next(answer for answer in answers if answer.cycle == "turn_rough")
    asked = next(operation for operation in job.operation if operation.cycle == "turn_rough")
    assert roughed.figures["ap_mm"] <= asked.ap_mm + 1e-6


def test_the_random_profiles_hold_the_hard_cases():
    """Valleys, hollow and bulging arcs, steps straight up, and several of each in one profile."""
    jobs = [random_job(seed, "mini-lathe") for seed in range(1, 26)]
    curves = [job.curves["part"] for job in jobs]
    falls = [(curve.xy[1:, 1] < curve.xy[:-1, 1] - 0.1).sum() for curve in curves]
    steps = [(abs(curve.xy[1:, 0] - curve.xy[:-1, 0]) < 1e-9).sum() for curve in curves]
    assert max(falls) >= 2 and max(steps) >= 2
    assert any((curve.bulge > 0).any() for curve in curves) and any((curve.bulge < 0).any() for curve in curves)
    assert {job.tool[0].insert[0] for job in jobs} == {"C", "D", "V", "T"}


def test_the_random_profiles_of_a_left_hand_insert_hold_necks_behind_shoulders():
    """Tried along z, along x and along the profile; some begin at the raw end; all fall where the chuck is behind."""
    ways = [way(seed) for seed in range(1, 26)]
    assert {one.get("along", "z") for one in ways if "hand" in one} == {"z", "x", "profile"}
    jobs = [random_job(seed, "mini-lathe", hand="left") for seed in range(1, 26)]
    curves = [job.curves["part"] for job in jobs]
    assert {job.tool[0].hand for job in jobs} == {"left"} and any((curve.bulge != 0).any() for curve in curves)
    assert all(curve.xy[-1, 1] == 30.0 for curve in curves)
    shoulders = [
        ((curve.xy[1:, 0] == curve.xy[:-1, 0]) & (curve.xy[1:, 1] < curve.xy[:-1, 1])).sum() for curve in curves
    ]
    assert max(shoulders) >= 2
    assert {bool(curve.xy[0, 0] == 0.0) for curve in curves} == {True, False}
