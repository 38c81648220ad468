# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeded fault runs of the sender at boards of ours, judged as those at grbl, and pulses that end by themselves."""

from __future__ import annotations

import os
from collections import Counter
from pathlib import Path
from random import Random

import pytest

from CNCStepper.errors import LinkError
from CNCStepper.virtual.faults.plan import FaultPlan
from helpers.control.fault_bench import FaultBench
from helpers.control.fault_cases import plan_of, program_of
from helpers.control.fault_judge import EXACT, REFUSED, STOPPED_KNOWN, STOPPED_UNKNOWN, WRONG, Verdict, judge
from helpers.control.restart_judge import judge_restart
from helpers.control.restarted_run import SecondGo
from helpers.controllers.fault_board import FaultBoard

RUNS = max(20, int(os.environ.get("CNCSTEPPER_FAULT_RUNS", "0")) // 10)
HOLDS = 5  # every fifth run is held by a person
LATE_RUNS = 5


@pytest.mark.slow
@pytest.mark.parametrize("controller", ["thesis-a", "usb-board"])
def test_every_part_is_cut_exactly_or_stopped_and_completed_by_its_restart(controller: str, tmp_path: Path) -> None:
    verdicts, wrong = Counter[str](), []
    for seed in range(1, 1 + RUNS):
        folder = tmp_path / str(seed)
        folder.mkdir()
        hold_s = 2.0 * (seed % HOLDS == 0)
        bench = FaultBench(program_of(seed), plan_of(seed), hold_s=hold_s, folder=folder, board=FaultBoard(controller))
        verdict = judged(bench)
        verdicts[verdict.kind] += 1
        wrong += [f"seed {seed}: {verdict.why}"] * (verdict.kind == WRONG)
    print(dict(verdicts))
    assert not wrong, "\n".join(wrong)
    assert verdicts[EXACT] and verdicts[STOPPED_UNKNOWN] and verdicts[STOPPED_KNOWN], verdicts


def judged(bench: FaultBench) -> Verdict:
    """Let a sender run, and the restart of what it leaves; judge both."""
    run = bench.run()
    verdict = judge(run)
    if verdict.kind in (EXACT, REFUSED, WRONG):
        return verdict
    second = SecondGo(bench, run)
    why = judge_restart(run.program, run.trace.rows, second.rows, second.said)
    if not why and second.claim and not (second.claim.done and second.at_rest):
        why = f"the restart was not cut to its end: {second.claim}"
    return Verdict(WRONG, f"{why}; {second.said}") if why else verdict


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(1, 1 + LATE_RUNS))
def test_pulses_that_come_late_stop_the_job_with_the_position_unknown(seed: int) -> None:
    board = FaultBoard()
    bench = FaultBench(program_of(seed), FaultPlan(), board=board)
    late_s = Random(f"late {seed}").uniform(0.5, 4.0)
    print(f"late at {late_s:.3f} s")
    let_pass = board.output.advance

    def advance(dt_s: float) -> None:
        let_pass(dt_s)
        if board.output.time_s > late_s and board.output.rate_mm_min > 0:
            board.output.error = board.output.error or LinkError("pulses-late", "a pulse came 4 ms late")

    board.output.advance = advance
    run = bench.run()
    assert board.output.error, "it came late"
    assert not run.claim.done and not run.claim.position_known and run.claim.declared == "parport-alarm-3"
    assert "a pulse came 4 ms late" in " ".join(text for _, text in bench.told)
