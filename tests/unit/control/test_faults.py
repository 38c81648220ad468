# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeded runs of the sender under faults, judged from the machine's trace; broken senders must fail the judge."""

from __future__ import annotations

import ast
import os
from collections import Counter
from pathlib import Path

import fault_judge
import fault_restart
import pytest
from broken_senders import CountsTwice, GoesOnAfterGreeting, IgnoresMissingOk, ResendsAfterError
from fault_bench import FaultBench, reference_of
from fault_cases import SIMULATED, plan_of, program_of
from fault_judge import EXACT, EXCURSION, SILENT, STOPPED_KNOWN, STOPPED_UNKNOWN, WRONG, Row, judge
from fault_restart import judge_restart

from CNCStepper.virtual.faults import KINDS, SENDER_KINDS, Fault, FaultPlan

BLOCK = 100  # runs of one test; every kind must fire in them
RUNS = max(200, int(os.environ.get("CNCSTEPPER_FAULT_RUNS", "200")))
HOLDS = 5  # every fifth run is held by a person
SHORT = ("G21G90G94G17", "M3S8000", "G1Z-1F500", "G1X10F600", "G1Y5", "G1X0", "G0Z2", "M5", "M2")
SPIKES = (*SHORT[:3], "G1X5F4000", *("G1X5.3", "G1X5") * 50, *SHORT[-3:])


def bench_of(seed: int, **options) -> FaultBench:
    return FaultBench(program_of(seed), plan_of(seed), hold_s=2.0 if seed % HOLDS == 0 else 0.0, **options)


@pytest.mark.slow
@pytest.mark.parametrize("first", range(1, 1 + RUNS, BLOCK))
def test_every_run_is_exact_or_stopped_with_its_position_declared(first, record_property):
    """A run that fails is repeated by `FaultBench(program_of(SEED), plan_of(SEED), ...)`, as `bench_of(SEED)` does."""
    verdicts, fired, wrong = Counter(), Counter(), []
    for seed in range(first, first + BLOCK):
        run = bench_of(seed).run()
        verdict = judge(run)
        verdicts[verdict.kind] += 1
        fired += run.line.fired
        if verdict.kind == WRONG:
            faults = ", ".join(map(str, plan_of(seed).fault))
            wrong.append(f"seed {seed}: {verdict.why}; faults: {faults}; claim: {run.claim}")
    record_property("faults fired", dict(fired))
    record_property("runs", dict(verdicts))
    assert not wrong, "\n".join(wrong)
    assert set(fired) == set(SIMULATED), f"never fired: {set(SIMULATED) - set(fired)}"
    assert all(verdicts[kind] for kind in (EXACT, STOPPED_KNOWN, STOPPED_UNKNOWN)), verdicts
    assert verdicts[SILENT] + verdicts[EXCURSION] < BLOCK / 5, verdicts


def test_every_kind_is_run_here_or_by_real_processes():
    assert set(SIMULATED) | set(SENDER_KINDS) == set(KINDS)


@pytest.mark.parametrize(
    ("broken", "fault"),
    [
        (IgnoresMissingOk, {"kind": "drop", "count": len("G1X5.3\n")}),
        (ResendsAfterError, {"kind": "corrupt", "bits": ord("G") ^ ord("W")}),
        (CountsTwice, {"kind": "flood"}),
        (GoesOnAfterGreeting, {"kind": "power"}),
    ],
)
def test_broken_sender_fails_the_judge_that_passes_ours(broken, fault, monkeypatch):
    at_byte = byte_of(SPIKES, "G1X5.3", 25)
    plan = FaultPlan(fault=(Fault(at_byte=at_byte, **fault),))
    assert judge(FaultBench(SPIKES, plan).run()).kind != WRONG
    monkeypatch.setattr("CNCStepper.control.sender.Grbl", broken)
    assert judge(FaultBench(SPIKES, plan).run()).kind == WRONG


def test_same_seed_gives_the_same_run():
    one, other = (bench_of(3).run() for _ in range(2))
    assert one.trace.rows == other.trace.rows and one.heard == other.heard and one.claim == other.claim


def test_judge_knows_nothing_of_the_sender():
    for module in (fault_judge, fault_restart):
        tree = ast.parse(Path(module.__file__).read_text("utf-8"))
        imports = [node for node in ast.walk(tree) if isinstance(node, (ast.Import, ast.ImportFrom))]
        names = " ".join(ast.unparse(node) for node in imports)
        assert "CNCStepper.control" not in names and "fault_bench" not in names and "importlib" not in names


# --- X90 for X10 ---------------------------------------------------------------------------------------


def byte_of(lines: tuple[str, ...], text: str, occurrence: int = 0) -> int:
    """Return which byte to the controller a text of the program is, when nothing goes wrong."""
    clean = FaultBench(lines, FaultPlan())
    assert judge(clean.run()).kind == EXACT
    at_byte = -1
    for _ in range(occurrence + 1):
        at_byte = clean.link.sent.index(text.encode("ascii"), at_byte + 1)
    return at_byte


def damaged(lines: tuple[str, ...], text: str, byte: int, bits: int) -> FaultBench:
    """Return a bench on which one byte of a line of the program is changed on its way."""
    fault = Fault(kind="corrupt", at_byte=byte_of(lines, text) + byte, bits=bits)
    return FaultBench(lines, FaultPlan(fault=(fault,)))


def test_x90_for_x10_is_held_and_declared():
    bench = damaged(SHORT, "G1X10F600", 3, ord("1") ^ ord("9"))
    run = bench.run()
    assert run.claim.declared == "path-left" and not run.claim.done and run.claim.position_known
    assert judge(run).kind == EXCURSION
    assert run.trace.board.axes.position_mm[0] < 16.0  # 10 mm/s, some reports a second
    assert "not on the program's path" in bench.outcome.text


def test_damage_that_no_answer_and_no_report_betrays_is_counted_on_its_own():
    bench = damaged(SHORT, "G1X10F600", 6, ord("6") ^ ord("7"))  # F700: the same path
    assert judge(bench.run()).kind == EXACT
    bench = damaged(SHORT, "M3S8000", 3, ord("8") ^ ord("9"))  # S9000
    assert judge(bench.run()).kind == SILENT


def test_end_of_the_path_is_compared_too():
    lines = ("G21G91G94G17", "M3S8000", "G1X2F3000", "G1X.002", "M5", "M2")
    bench = damaged(lines, "G1X.002", 4, ord("0") ^ ord("1"))  # X.102
    run = bench.run()
    assert run.claim.declared == "path-left" and judge(run).kind == EXCURSION


# --- the judge of restarts -------------------------------------------------------------------------------


def rows_of(lines: tuple[str, ...]) -> list[Row]:
    return list(reference_of(lines)[0])


HEAD, TAIL = ("G21G90G94G17", "M3S8000"), ("G0Z2", "M5", "M2")
WHOLE = (*HEAD, "G0X1Y1", "G1Z-1F500", "G1X11F1500", "G1Y11", *TAIL)
FIRST_GO = (*HEAD, "G0X1Y1", "G1Z-1F500", "G1X6F1500", *TAIL)


@pytest.mark.parametrize(
    ("second", "wrong"),
    [
        (("G0Z2", "G0X5.5Y1", "G1Z-1F500", "G1X11F1500", "G1Y11"), ""),
        (("G0Z2", "G0X7Y1", "G1Z-1F500", "G1X11F1500", "G1Y11"), "not cut"),
        (("G0Z2", "G0X1Y1", "G1Z-1F500", "G1X11F1500", "G1Y11"), "more than once"),
        (("G0Z2", "G0X5.5Y3", "G1Z-1F500", "G1Y1F1500", "G1X11", "G1Y11"), "where the program does not cut"),
        (("G0Z2", "G0X5.5Y1", "G1Z-1.5F500", "G1Z-1", "G1X11F1500", "G1Y11"), "where the program does not cut"),
    ],
)
def test_judge_of_restarts(second, wrong):
    goes = [rows_of(FIRST_GO), rows_of((*HEAD, *second, *TAIL))]
    top_steps = rows_of(WHOLE)[0].place[2] - 2.0
    said = judge_restart(rows_of(WHOLE), goes, top_steps=top_steps, overlap_steps=120.0)
    assert wrong in said if wrong else said == ""
