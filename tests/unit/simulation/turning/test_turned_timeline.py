# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part at a moment against the part that the judge cuts from the program up to there."""

from __future__ import annotations

import itertools
from dataclasses import replace
from functools import reduce
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.gcode.dialects import dialect
from CNCStepper.job.prove import prove
from CNCStepper.job.turning.make_turning import in_part, make_turning, placement_of
from CNCStepper.job.turning.report import setup_of
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.turning.turned_part import turned_part
from CNCStepper.simulation.turning.turned_timeline import TurnedTimeline, track_of
from CNCStepper.state import Start

JOBS = Path(__file__).resolve().parents[4] / "examples" / "jobs"


def timeline(name: str) -> tuple[TurnedTimeline, dict]:
    """Return the timeline of the last program of a job, behind those before it, and its tools."""
    job, machine = load_turning_job(JOBS / f"lathe-{name}.toml")
    paths, times = [], np.zeros(0)
    for program in make_turning(job, machine):
        letters = dialect(machine.language()).letters
        start = Start(tool=program.answers[0].tool) if "T" not in letters else None
        proof = prove(program.program, machine, start=start)
        paths.append(in_part(proof.toolpath, placement_of(job, machine)))
        times = proof.times_s
    setup, moves = setup_of(job), moves_of(reduce(followed, paths))
    part = turned_part(moves, setup.stock, setup.tools)
    first = sum(map(len, paths[:-1]))
    return TurnedTimeline(part, setup.tools, track_of(paths[-1], times, part.moves, first), first), setup.tools


@pytest.fixture(scope="module", params=["cylinder", "thread", "shaft"])
def whole(request: pytest.FixtureRequest) -> tuple[TurnedTimeline, dict]:
    return timeline(request.param)


def test_the_last_moment_is_the_proven_part(whole: tuple) -> None:
    line, _ = whole
    last = line.at(line.duration_s).section
    assert last.outer_profile == line.part.section.outer_profile
    assert last.volume_mm3 == line.part.section.volume_mm3


@pytest.mark.parametrize("share", [0.0, 0.13, 0.4, 0.62, 0.9])
def test_a_moment_is_the_part_that_the_moves_until_then_leave(whole: tuple, share: float) -> None:
    line, tools = whole
    time_s = share * line.duration_s
    done, part = line._done(time_s)
    moves = line.part.moves
    own = moves[: done + 1]
    end = own.end.copy()
    end[done] = own.begin[done] + part * (own.end[done] - own.begin[done])
    alone = turned_part(replace(own, end=end), line.part.stock, tools).section
    moment = line.at(time_s)
    assert moment.section.region.symmetric_difference(alone.region).area < 1e-3
    tip = line.track.tip_mm(line.track.row_at(time_s), line.track.share_at(line.track.row_at(time_s), time_s))
    assert (tip[2], tip[0]) == pytest.approx(tuple(end[done]), abs=2e-3)


def test_material_only_ever_goes(whole: tuple) -> None:
    line, _ = whole
    volumes = [line.at(t).section.volume_mm3 for t in np.linspace(0.0, line.duration_s, 25)]
    assert volumes[0] >= volumes[-1]
    assert all(after <= before + 1e-6 for before, after in itertools.pairwise(volumes))


def test_the_surface_knows_the_tool_that_cut_it_last() -> None:
    line, _ = timeline("shaft")
    moment = line.at(line.duration_s)
    groove, raw, cone = (-49.0, 15.0), (-120.0, 27.5), (-10.0, 12.0)
    assert line.cutters(moment, np.array([groove, raw, cone]), 0.01).tolist() == [3, 0, 2]
    before = line.at(0.0)
    assert line.cutters(before, np.array([cone]), 0.01).tolist() == [2]
