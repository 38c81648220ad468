# SPDX-License-Identifier: LGPL-2.1-or-later
"""Seeded runs of the sender under faults, judged from the machine's trace; broken senders must fail the judge."""

from __future__ import annotations

import ast
import os
from collections import Counter
from dataclasses import replace
from pathlib import Path

import pytest

from CNCStepper.control.journal.writer import Journal
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.stream.path_comparison import PathWatch
from CNCStepper.control.stream.position_trust import LOST
from CNCStepper.virtual.faults.plan import KINDS, Fault, FaultPlan
from CNCStepper.virtual.grbl.states import State
from helpers.control import fault_judge, restart_judge
from helpers.control.broken_senders import CountsTwice, GoesOnAfterGreeting, IgnoresMissingOk, ResendsAfterError
from helpers.control.fault_bench import FaultBench, reference_of
from helpers.control.fault_cases import plan_of, program_of, shifted_program_of
from helpers.control.fault_disk import FOR_GOOD_S
from helpers.control.fault_judge import (
    EXACT,
    EXCURSION,
    REFUSED,
    SILENT,
    STOPPED_KNOWN,
    STOPPED_UNKNOWN,
    WRONG,
    Run,
    Verdict,
    judge,
)
from helpers.control.limit_switches import HOMED, LOCKED, OVER_S, plan_for, switches_of
from helpers.control.restart_judge import Interval, judge_restart
from helpers.control.restarted_run import SecondGo

BLOCK = 100  # runs of one test; every kind must fire in them
RUNS = max(200, int(os.environ.get("CNCSTEPPER_FAULT_RUNS", "200")))
HOLDS = 5  # every fifth run is held by a person
STOPPED = (STOPPED_KNOWN, STOPPED_UNKNOWN, EXCURSION, REFUSED)
SHORT = ("G21G90G94G17", "M3S8000", "G1Z-1F500", "G1X10F600", "G1Y5", "G1X0", "G0Z2", "M5", "M2")
SPIKES = (*SHORT[:3], "G1X5F4000", *("G1X5.3", "G1X5") * 50, *SHORT[-3:])


def bench_of(seed: int, folder: Path | None = None) -> FaultBench:
    switches = switches_of(seed)
    hold_s = 2.0 + OVER_S * (switches == LOCKED) if seed % HOLDS == 0 else 0.0
    return FaultBench(program_of(seed), plan_for(seed, switches), hold_s=hold_s, folder=folder, switches=switches)


def judged(bench: FaultBench) -> tuple[Run, Verdict]:
    """Let a sender run; what it leaves unfinished is restarted, and both goes are judged together."""
    run = bench.run()
    verdict = judge(run)
    if why := forgets(bench, run):
        return run, Verdict(WRONG, why)
    if verdict.kind not in STOPPED:
        return run, verdict
    second = SecondGo(bench, run)
    why = judge_restart(run.program, run.trace.rows, second.rows, second.said)
    if not why and second.claim and not (second.claim.done and second.at_rest):
        why = f"the restart was not cut to its end: {second.claim}"
    if not second.is_well_advised:
        why = "the journal does not say how the position is found again"
    what = "restarted" if second.claim else "nothing left"
    return run, Verdict(WRONG, f"{why}; {second.said}") if why else Verdict(f"{verdict.kind}, {what}")


def forgets(bench: FaultBench, run: Run) -> str:
    """Return what is wrong with what the next connection finds of the position after a job, "" where nothing is."""
    if bench.folder is None or bench.journal.path is None or run.claim.refused:
        return ""
    trust = PositionTrustFile.of_port(bench.folder, bench.link.name).trust
    return f"kept is {trust}, told {run.claim}" if (trust == LOST) == run.claim.position_known else ""


@pytest.mark.slow
@pytest.mark.parametrize("first", range(1, 1 + RUNS, BLOCK))
def test_every_part_is_cut_exactly_or_stopped_and_completed_by_its_restart(first, tmp_path, record_property):
    """A run that fails is repeated by `judged(bench_of(SEED, FOLDER))`."""
    verdicts, fired, machines, wrong = Counter(), Counter(), Counter(), []
    for seed in range(first, first + BLOCK):
        folder = tmp_path / str(seed)
        folder.mkdir()
        bench = bench_of(seed, folder)
        run, verdict = judged(bench)
        verdicts[verdict.kind] += 1
        fired += run.line.fired
        machines[bench.switches or "no switches"] += 1
        machines["homing broken off"] += run.trace.begin_lost is None
        machines["faults while held or paused"] += bench.fired_standing
        if verdict.kind == WRONG:
            faults = ", ".join(map(str, bench.plan.fault))
            wrong.append(f"seed {seed}: {verdict.why}; faults: {faults}; claim: {run.claim}")
    record_property("faults fired", dict(fired))
    record_property("runs", dict(verdicts))
    record_property("machines", dict(machines))
    assert not wrong, "\n".join(wrong)
    assert machines[HOMED] + machines[LOCKED] > BLOCK / 10 and machines[HOMED] and machines[LOCKED], machines
    assert machines["faults while held or paused"], machines
    assert set(fired) == set(KINDS), f"never fired: {set(KINDS) - set(fired)}"
    assert all(verdicts[f"{kind}, restarted"] for kind in (STOPPED_KNOWN, STOPPED_UNKNOWN)) and verdicts[EXACT], (
        verdicts
    )
    left = sum(count for kind, count in verdicts.items() if kind.startswith((SILENT, EXCURSION)))
    assert left < BLOCK / 5, verdicts


@pytest.mark.slow
def test_part_with_a_tool_length_or_a_g92_is_cut_exactly_or_completed_by_its_restart(tmp_path, record_property):
    """A run that fails is repeated by `judged(FaultBench(shifted_program_of(SEED), plan_of(SEED), folder=FOLDER))`."""
    verdicts, wrong = Counter(), []
    for seed in range(1, 1 + RUNS // 8):
        folder = tmp_path / str(seed)
        folder.mkdir()
        _, verdict = judged(FaultBench(shifted_program_of(seed), plan_of(seed), folder=folder))
        verdicts[verdict.kind] += 1
        wrong += [f"seed {seed}: {verdict.why}"] * (verdict.kind == WRONG)
    record_property("runs", dict(verdicts))
    assert not wrong, "\n".join(wrong)
    assert all(verdicts[f"{kind}, restarted"] for kind in (STOPPED_KNOWN, STOPPED_UNKNOWN)) and verdicts[EXACT]


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
    monkeypatch.setattr("CNCStepper.control.service.sender.Grbl", broken)
    monkeypatch.setattr(PathWatch, "may_have_restarted", lambda watch, sent: False)
    assert judge(FaultBench(SPIKES, plan).run()).kind == WRONG


def test_restart_that_is_not_heard_is_reckoned_with_where_the_spindle_stands(monkeypatch):
    plan = FaultPlan(fault=(Fault(kind="power", at_byte=byte_of(SPIKES, "G1X5.3", 25)),))
    monkeypatch.setattr("CNCStepper.control.service.sender.Grbl", GoesOnAfterGreeting)
    bench = FaultBench(SPIKES, plan)
    run = bench.run()
    assert run.claim.declared == "path-left" and judge(run).kind == STOPPED_UNKNOWN
    assert "or the controller restarted unheard" in bench.outcome.text


def test_line_that_was_refused_and_those_behind_it_are_not_called_cut(tmp_path):
    lines = (*HEAD, "G0Z2", "G1Z-1F500", "G4P0.1", "G1X5F1500", "G4P0", *["S8000"] * 3, "G4P3", "G1Y5", *TAIL)
    plan = FaultPlan(fault=(Fault(kind="corrupt", at_byte=byte_of(lines, "G1X5F1500"), bits=ord("G") ^ ord("W")),))
    bench = FaultBench(lines, plan, folder=tmp_path)
    run, verdict = judged(bench)
    assert run.claim.declared == "grbl-error-20" and run.said.count(b"ok\r\n") > 10
    assert bench.outcome.status.acknowledged == lines.index("G1X5F1500")
    assert verdict.kind == f"{STOPPED_KNOWN}, restarted", verdict.why


def test_same_seed_gives_the_same_run():
    one, other = (bench_of(4).run() for _ in range(2))
    assert one.trace.rows == other.trace.rows and one.heard == other.heard and one.claim == other.claim


def test_judge_forgives_a_power_loss_only_behind_the_last_words_of_the_board(tmp_path):
    refused = Fault(kind="corrupt", at_byte=byte_of(SHORT, "G1X10F600"), bits=ord("G") ^ ord("W"))
    (tmp_path / "before").mkdir()
    ended_s = FaultBench(SHORT, FaultPlan(fault=(refused,)), folder=tmp_path / "before").run().claim_s
    plan = FaultPlan(fault=(refused, Fault(kind="power", at_s=ended_s - 1e-6)))
    run, verdict = judged(FaultBench(SHORT, plan, folder=tmp_path))
    assert run.claim.position_known and run.trace.lost and verdict.kind == f"{STOPPED_KNOWN}, restarted", verdict.why
    assert judge(replace(run, claim_s=run.claim_s + 0.05)).kind == WRONG


def test_judge_knows_nothing_of_the_sender():
    for module in (fault_judge, restart_judge):
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


def test_question_that_arrives_as_a_check_mode_is_refused_and_the_part_is_cut_later(tmp_path):
    fault = Fault(kind="corrupt", at_byte=byte_of(SHORT, "$G") + 1, bits=ord("G") ^ ord("C"))
    bench = FaultBench(SHORT, FaultPlan(fault=(fault,)), folder=tmp_path)
    run, verdict = judged(bench)
    assert run.claim.declared == "modes-unknown" and run.claim.position_known
    assert b"[MSG:Enabled]" in run.said and verdict.kind == f"{REFUSED}, restarted", verdict.why


def test_question_that_arrives_as_a_hold_is_refused_and_the_part_is_cut_later(tmp_path):
    fault = Fault(kind="corrupt", at_byte=byte_of(SHORT, "$#") + 1, bits=ord("#") ^ ord("!"))
    bench = FaultBench(SHORT, FaultPlan(fault=(fault,)), folder=tmp_path)
    run, verdict = judged(bench)
    assert run.claim.declared == "answer-missing" and verdict.kind == f"{REFUSED}, restarted", verdict.why


def test_restart_while_the_controller_is_asked_costs_the_position(tmp_path):
    plan = FaultPlan(fault=(Fault(kind="power", at_s=0.15),))
    _, verdict = judged(FaultBench(WHOLE, plan, switches=HOMED, folder=tmp_path))
    assert verdict.kind == f"{REFUSED}, restarted", verdict.why


@pytest.mark.parametrize(("text", "byte"), [("F0 S0", 0), ("GC:", 1)])
def test_modes_that_come_damaged_are_refused(text, byte):
    clean = FaultBench(SHORT, FaultPlan())
    at_byte = clean.run().said.index(text.encode("ascii")) + byte
    fault = Fault(kind="duplicate", way="out", at_byte=at_byte)
    run = FaultBench(SHORT, FaultPlan(fault=(fault,))).run()
    assert run.claim.declared == "modes-unknown" and judge(run).kind == REFUSED


@pytest.mark.parametrize("dwell", [(), ("G4P0.1",) * 9])
def test_check_mode_in_which_lines_are_read_and_nothing_moves_stops_the_job_and_none_counts_as_cut(tmp_path, dwell):
    bench = FaultBench((*SPIKES[:-3], *dwell, *SPIKES[-3:]), FaultPlan(), folder=tmp_path)
    begin = bench.journal.begin

    def check_mode_on(*met):
        begin(*met)
        bench.board.state = State.CHECK

    bench.journal.begin = check_mode_on
    run, verdict = judged(bench)
    assert run.claim.declared == "machine-check" and run.claim.position_known
    assert "without moving (value Check); leave the check mode" in bench.outcome.text
    assert verdict.kind == f"{STOPPED_KNOWN}, restarted", verdict.why


# --- homing ----------------------------------------------------------------------------------------------


def test_a_state_that_came_damaged_before_a_homing_is_asked_for_again(tmp_path):
    fault = Fault(kind="duplicate", way="out", at_byte=56)  # <Aalarm|...
    run, verdict = judged(FaultBench(WHOLE, FaultPlan(fault=(fault,)), switches=LOCKED, folder=tmp_path))
    assert run.claim.declared == "" and run.claim.position_known and verdict.kind == EXACT, verdict.why


@pytest.mark.parametrize(
    ("fault", "declared"),
    [
        ({"kind": "alarm", "at_s": 3.0}, "grbl-alarm-9"),
        ({"kind": "reset", "at_s": 3.0}, "grbl-alarm-6"),
        ({"kind": "power", "at_s": 3.0}, "controller-restarted"),
        ({"kind": "close", "at_s": 3.0}, "link-lost"),
        ({"kind": "kill", "at_s": 3.0}, "session-lost"),
        ({"kind": "withhold", "at_s": 3.0}, "answer-missing"),
        ({"kind": "corrupt", "at_byte": len("?$\n$"), "bits": ord("H") ^ ord("X")}, "homing-not-made"),
        ({"kind": "drop", "at_byte": len("?$\n"), "count": len("$H")}, "homing-not-made"),
        ({"kind": "drop", "at_byte": len("?$\n$H")}, "answer-missing"),
    ],
)
def test_fault_in_a_homing_ends_the_job_with_the_position_unknown_and_a_second_go_completes_it(
    fault, declared, tmp_path
):
    bench = FaultBench(WHOLE, FaultPlan(fault=(Fault(**fault),)), switches=LOCKED, folder=tmp_path)
    run, verdict = judged(bench)
    assert run.claim.declared == declared and not run.claim.position_known
    assert verdict.kind in (f"{REFUSED}, restarted", f"{STOPPED_UNKNOWN}, restarted"), verdict.why


def test_machine_with_switches_homes_before_its_restart_and_the_journal_says_so(tmp_path):
    plan = FaultPlan(fault=(Fault(kind="power", at_s=3.0, when="motion"),))
    bench = FaultBench(program_of(1), plan, switches=HOMED, folder=tmp_path)
    run = bench.run()
    assert judge(run).kind == STOPPED_UNKNOWN
    second = SecondGo(bench, run)
    assert second.homes and second.is_well_advised and second.claim.done
    assert judge_restart(run.program, run.trace.rows, second.rows, second.said) == ""


def test_homing_that_is_believed_though_it_was_none_fails_the_judge(monkeypatch):
    monkeypatch.setattr("CNCStepper.control.operator.homing.check_took", lambda seconds: None)
    fault = Fault(kind="corrupt", at_byte=len("?$\n$"), bits=ord("H") ^ ord("X"))
    verdict = judge(FaultBench(WHOLE, FaultPlan(fault=(fault,)), switches=LOCKED).run())
    assert verdict.kind == WRONG


# --- restarts --------------------------------------------------------------------------------------------


def killed_at(at_s: float, folder: Path) -> FaultBench:
    return FaultBench(program_of(1), FaultPlan(fault=(Fault(kind="kill", at_s=at_s),)), folder=folder)


def test_killed_sender_is_restarted_from_its_journal(tmp_path):
    _, verdict = judged(killed_at(4.0, tmp_path))
    assert verdict.kind == f"{STOPPED_UNKNOWN}, restarted", verdict.why


def test_dwell_that_a_reset_ends_is_no_proof_that_all_before_it_is_cut(tmp_path):
    lines = (*HEAD, "G0Z2", "G0X1Y1", "G1Z-1F500", "G1X5F100", "G4P0.2", *TAIL)
    bench = FaultBench(lines, FaultPlan(fault=(Fault(kind="reset", at_s=3.0, when="motion"),)), folder=tmp_path)
    run, verdict = judged(bench)
    assert b"ALARM:3\r\nok\r\n" in run.said
    assert verdict.kind == f"{STOPPED_UNKNOWN}, restarted", verdict.why


def test_line_behind_which_the_path_was_left_is_not_called_cut(tmp_path):
    lines = (*HEAD, "G0Z2", "G0X1Y1", "G1Z-1F500", "G1X5F2000", "G1Y1.01", "G4P0.2", "G1Y9F600", "G1X1", *TAIL)
    plan = FaultPlan(fault=(Fault(kind="corrupt", at_byte=byte_of(lines, "G1X5F2000") + 3, bits=ord("5") ^ ord("4")),))
    bench = FaultBench(lines, plan, folder=tmp_path)
    run, verdict = judged(bench)
    assert run.claim.declared == "path-left" and verdict.kind == f"{EXCURSION}, restarted", verdict.why


def test_restart_that_is_told_together_with_an_alarm_is_not_overheard():
    alarm = Fault(kind="alarm", at_s=1.93, when="motion", code=2)
    faults = (alarm, Fault(kind="power", at_s=1.93, when="rest"), Fault(kind="delay", way="out", at_s=1.9))
    run = FaultBench(program_of(4484), FaultPlan(fault=faults)).run()
    assert any(b"ALARM:2" in data and b"Grbl" in data for _, data in run.heard)
    assert judge(run).kind == STOPPED_UNKNOWN


def test_journal_that_takes_acknowledged_lines_for_cut_fails_the_judge(tmp_path, monkeypatch):
    monkeypatch.setattr(Journal, "_certain", lambda self, acknowledged, is_idle: acknowledged)
    _, verdict = judged(damaging(tmp_path))
    assert verdict.kind == WRONG and "steps are left uncut" in verdict.why


def test_zero_that_was_not_set_again_fails_the_judge(tmp_path, monkeypatch):
    plan = FaultPlan(fault=(Fault(kind="power", at_s=3.0, when="motion"),))
    monkeypatch.setattr("helpers.control.restarted_run.set_zero", lambda board, first: None)
    _, verdict = judged(FaultBench(program_of(1), plan, folder=tmp_path))
    assert verdict.kind == WRONG


def damaging(folder: Path) -> FaultBench:
    """Return a bench whose machine stops dead with its buffer full."""
    plan = FaultPlan(fault=(Fault(kind="alarm", at_s=3.0, when="motion", code=1),))
    return FaultBench(program_of(1), plan, folder=folder)


@pytest.mark.slow
def test_full_disk_holds_until_there_is_room_and_else_the_part_is_restarted(tmp_path):
    kinds = []
    for for_s in (2.0, FOR_GOOD_S):
        folder = tmp_path / str(for_s)
        folder.mkdir()
        plan = FaultPlan(fault=(Fault(kind="disk", at_s=1.0, for_s=for_s),))
        bench = FaultBench(TEETH, plan, folder=folder)
        kinds.append(judged(bench)[1].kind)
        assert any("the journal cannot be written" in text for _, text in bench.told)
    assert kinds == [EXACT, f"{STOPPED_KNOWN}, restarted"]


HEAD, TAIL = ("G21G90G94G17", "M3S8000"), ("G0Z2", "M5", "M2")
WHOLE = (*HEAD, "G0Z2", "G0X1Y1", "G1Z-1F500", "G1X11F1500", "G1Y11", "G1X1", *TAIL)  # lines 1 to 10, cuts 5 to 8
FIRST_GO = (*HEAD, "G0Z2", "G0X1Y1", "G1Z-1F500", "G1X6F1500", *TAIL)
TEETH = (*HEAD, "G0Z2", "G1Z-1F500", *("G1X5F4000", "G1X4") * 40, *TAIL)
SECOND = ("G0X1Y1", "G1Z-1F500", "G1X11F1500", "G1Y11", "G1X1")
SAID = Interval(first=5, last=7, entrance=5)  # not certain are G1X11 and G1Y11


@pytest.mark.parametrize(
    ("second", "said", "wrong"),
    [
        (SECOND, SAID, ""),
        (("G0X5.5Y1", "G1Z-1F500", *SECOND[2:]), SAID, ""),
        (("G0X7Y1", "G1Z-1F500", *SECOND[2:]), SAID, "cut by neither go"),
        (SECOND, Interval(first=6, last=7, entrance=6), "before the overlap are cut twice"),
        (SECOND, Interval(first=4, last=5, entrance=4), "behind the overlap are cut twice"),
        (("G0X5.5Y3", "G1Z-1F500", "G1Y1F1500", *SECOND[2:]), SAID, "leaves the allowed region"),
        (("G0X5.5Y1", "G1Z-1.5F500", "G1Z-1", *SECOND[2:]), SAID, "leaves the allowed region"),
        (("G0X20Y1", *SECOND), SAID, "leaves the allowed region"),
        (SECOND[:-1], SAID, "does not end as the program does"),
        ((*SECOND[:-1], "G1X1.1"), SAID, "does not end as the program does"),
    ],
)
def test_judge_of_restarts(second, said, wrong):
    goes = [reference_of(lines).rows for lines in (FIRST_GO, (*HEAD, "G0Z2", *second, *TAIL))]
    found = judge_restart(reference_of(WHOLE), *goes, said)
    assert wrong in found if wrong else found == ""


def test_judge_wants_all_cut_where_nothing_is_sent_again():
    program = reference_of(WHOLE)
    assert judge_restart(program, program.rows, [], Interval(10, 10, 10)) == ""
    assert "left uncut" in judge_restart(program, reference_of(FIRST_GO).rows, [], Interval(8, 10, 8))


def test_judge_allows_an_earlier_entrance_only_within_the_way_into_a_cut():
    goes = [reference_of(lines).rows for lines in (FIRST_GO, (*HEAD, "G0Z2", *SECOND, *TAIL))]
    assert judge_restart(reference_of(WHOLE), *goes, Interval(first=6, last=7, entrance=5)) == ""
    assert "far before" in judge_restart(reference_of(TEETH), *goes, Interval(first=12, last=14, entrance=4))
