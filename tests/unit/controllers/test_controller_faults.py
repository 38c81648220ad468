# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeded fault runs of the sender at boards of ours, judged as those at grbl: links, kills, late pulses, wrong pins.

A sender cannot see a pin that is dead or exchanged: the runs have a person who does, and stops the machine. The journal
counts what the pulses were, so that the person also names the line from which on the part is not cut.
"""

from __future__ import annotations

import os
from bisect import bisect_right
from collections import Counter
from pathlib import Path
from random import Random

import pytest

from CNCStepper.control.session.command import Command
from CNCStepper.virtual.faults.plan import FaultPlan
from helpers.control.fault_bench import FaultBench
from helpers.control.fault_cases import plan_of, program_of
from helpers.control.fault_judge import (
    EXACT,
    EXCURSION,
    SILENT,
    STOPPED_KNOWN,
    STOPPED_UNKNOWN,
    WRONG,
    Run,
    Verdict,
    covers,
    judge,
    reached,
)
from helpers.control.restart_judge import judge_restart
from helpers.control.restarted_run import SecondGo
from helpers.controllers.fault_board import FaultBoard, dead_pin, swapped_pins

RUNS = max(20, int(os.environ.get("CNCSTEPPER_FAULT_RUNS", "0")) // 10)
HOLDS = 5  # every fifth run is held by a person
LATE, PINS = "late", "wrong pin"
KINDS = ("plan", LATE, "plan", PINS)  # by turns
SEES_S = 0.4  # after which a person stops a machine that goes elsewhere
STOPPED = (STOPPED_KNOWN, STOPPED_UNKNOWN)
CABLES = (dead_pin(0), dead_pin(1), swapped_pins(0, 1))


@pytest.mark.slow
@pytest.mark.parametrize("controller", ["thesis-a", "usb-board"])
def test_every_part_is_cut_exactly_or_stopped_and_completed_by_its_restart(controller: str, tmp_path: Path) -> None:
    verdicts, wrong = Counter[str](), []
    for seed in range(1, 1 + RUNS):
        folder = tmp_path / str(seed)
        folder.mkdir()
        kind = KINDS[seed % len(KINDS)]
        verdict = RUNNERS[kind](seed, controller, folder)
        verdicts[f"{kind}: {verdict.kind}"] += 1
        wrong += [f"seed {seed} ({kind}): {verdict.why}"] * (verdict.kind == WRONG)
    print(dict(verdicts))
    assert not wrong, "\n".join(wrong)
    left = sum(count for kind, count in verdicts.items() if kind.endswith((SILENT, EXCURSION)))
    assert left < RUNS / 5, verdicts
    assert verdicts[f"plan: {EXACT}"] and verdicts[f"plan: {STOPPED_UNKNOWN}"], verdicts
    assert verdicts[f"{LATE}: {STOPPED_UNKNOWN}"] and verdicts[f"{PINS}: {STOPPED_UNKNOWN}"], verdicts
    assert verdicts[f"{PINS}: {STOPPED_KNOWN}"], "stopped with a ramp, by a sender that cannot see the pin"


def planned(seed: int, controller: str, folder: Path) -> Verdict:
    """Run with the faults of a plan."""
    hold_s = 2.0 * (seed % HOLDS == 0)
    plan = plan_of(seed // 2)
    return completed(FaultBench(program_of(seed), plan, hold_s=hold_s, folder=folder, board=FaultBoard(controller)))


def late(seed: int, controller: str, folder: Path) -> Verdict:
    """Run with a pulse that comes too late at some moment."""
    board = FaultBoard(controller)
    board.late_s = Random(f"late {seed}").uniform(0.5, 4.0)
    bench = FaultBench(program_of(seed), FaultPlan(), folder=folder, board=board)
    run = bench.run()
    if not board.output.error:
        return judge(run)
    claim = run.claim
    if claim.done or claim.position_known or not claim.declared.endswith("-alarm-3"):
        return Verdict(WRONG, f"late pulses end in {claim}")
    if "a pulse came 4 ms late" not in " ".join(text for _, text in bench.told):
        return Verdict(WRONG, "why it ended is not told")
    return restarted(bench, run, judge(run))


def wrong_pin(seed: int, controller: str, folder: Path) -> Verdict:
    """Run with a cable that is wrong from some moment on, which a person sees, and stops by a button or a word."""
    random, board = Random(f"pin {seed}"), FaultBoard(controller)
    board.cable_s, board.cable = random.uniform(0.5, 3.0), random.choice(CABLES)
    bench = FaultBench(program_of(seed), FaultPlan(), folder=folder, board=board)
    by_button, begun = random.random() < 0.5, list(board.axes.lost_steps)
    seen_s: list[float] = []
    look = bench.link.at_read

    def person(now_s: float) -> None:
        look(now_s)
        if board.axes.lost_steps != begun and len(seen_s) < 2:
            seen_s[:] = seen_s or [now_s]
            if now_s > seen_s[0] + SEES_S:
                seen_s.append(now_s)
                if by_button:
                    board.press("R")
                    board.release("R")
                else:
                    bench.sender.ask(Command("stop"))

    bench.link.at_read = person
    run = bench.run()
    if board.axes.lost_steps == begun:
        return judge(run)
    if not run.trace.at_rest:
        return Verdict(WRONG, "the machine was left running")
    if by_button and len(seen_s) == 2 and run.claim.position_known and not run.claim.done:
        return Verdict(WRONG, f"the position is called known after a reset by hand: {run.claim}")
    kind = STOPPED_KNOWN if run.claim.position_known else STOPPED_UNKNOWN
    reference = run.program
    _, stretches = reached(reference.rows, run.trace.rows)
    line = min(bisect_right(reference.ends, min(stretches)), len(bench.lines) - 1)
    return restarted(bench, run, Verdict(kind), line)


RUNNERS = {"plan": planned, LATE: late, PINS: wrong_pin}


def completed(bench: FaultBench) -> Verdict:
    """Let a sender run, and the restart of what it leaves; judge both.

    As at grbl's boards no restart mends what was cut by a line that came damaged without anybody seeing it.
    """
    run = bench.run()
    verdict = judge(run)
    return restarted(bench, run, verdict) if verdict.kind in STOPPED else verdict


def restarted(bench: FaultBench, run: Run, verdict: Verdict, seen_line: int | None = None) -> Verdict:
    """Return a verdict that is WRONG where the restart, at a new connection, does not complete the part."""
    if verdict.kind == WRONG:
        return verdict
    board = bench.board
    assert isinstance(board, FaultBoard)
    if board.output.error or seen_line is not None:
        bench.board = board.connected_again()
    second = SecondGo(bench, run, seen_line)
    why = judge_restart(run.program, run.trace.rows, second.rows, second.said)
    if not why and second.claim and not (second.claim.done and second.at_rest):
        why = f"the restart was not cut to its end: {second.claim}"
    if seen_line is not None and not second.rows and not covers(run.program.rows, run.trace.rows):
        why = why or "nothing was cut again"
    return Verdict(WRONG, f"{why}; {second.said}") if why else verdict
