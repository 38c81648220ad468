# SPDX-License-Identifier: LGPL-2.1-or-later
"""Roughing takes hardly longer than its depth of cut allows, by a bound that knows the material alone."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.job.turning.make_turning import in_part, placement_of, turned_moves
from CNCStepper.job.turning.report import judge_turning, setup_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.turning.swept_outline import moves_of
from helpers.cycles.seeds import SEEDS
from helpers.job.random_turning import STOCK_MM, random_job

WAYS = [{"inside": inside, "along": along} for along in ("z", "x", "profile") for inside in (False, True)]
MOST_SHARE = 1.10
FEED_MM_MIN = 100.0  # 0.2 mm at 500 rpm


@pytest.mark.parametrize("seed", SEEDS[::3])
def test_roughing_takes_a_tenth_longer_than_the_least_at_most(seed):
    """The least: the section of what is cut by the depth of cut, at feed, and the same way back as a rapid; the last
    pass along the profile and its wall, and before each pass the clearance, at feed."""
    machine = load_machine("mini-lathe")
    job = random_job(seed, "mini-lathe", **WAYS[seed % len(WAYS)])
    rough = next(operation for operation in job.operation if operation.cycle == "turn_rough")
    job = job.model_copy(update={"operation": (rough,), "stock": job.stock.model_copy(update={"face_mm": 0.0})})
    table, (answer,) = turned_moves(job, machine)
    moves = moves_of(in_part(table, placement_of(job, machine)))
    part = judge_turning(moves, setup_of(job), job.x_is).part
    area_mm2 = part.stock.region.area - part.section.region.area
    profile, inside = job.curves["part"], job.tool[0].is_inside
    wall_mm = abs((job.stock.bore_mm / 2 if inside else STOCK_MM) - profile.xy[-1, 1])
    passes = area_mm2 / answer.figures["ap_mm"]
    clear_mm = (answer.figures["passes"] + 1) * rough.clearance_mm
    least_min = (passes + profile.length_mm + wall_mm + clear_mm) / FEED_MM_MIN + passes / machine.fastest_mm_min
    length_mm = np.hypot(*(moves.end - moves.begin).T)
    feeds_mm, rapids_mm = length_mm[~moves.rapid].sum(), length_mm[moves.rapid].sum()
    taken_min = feeds_mm / FEED_MM_MIN + rapids_mm / machine.fastest_mm_min
    assert 0.5 * least_min < taken_min < MOST_SHARE * least_min
