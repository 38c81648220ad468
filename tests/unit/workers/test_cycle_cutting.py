# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut process: the same figures and programs as in one's own process, refusals as answers, the newest wins."""

from __future__ import annotations

import re
import time
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import pytest

from CNCStepper.cancellation import checkpoint, interruptible
from CNCStepper.errors import CNCStepperError, CycleError
from CNCStepper.job import request_digest
from CNCStepper.job.cut_transfer import content_of, machine_content
from CNCStepper.job.make import cut_operations, make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.turning import turning_transfer
from CNCStepper.job.turning.make_turning import make_turning, turned_moves
from CNCStepper.job.turning.turning_job import load_turning_job
from CNCStepper.motion.planner.plan import begun, duration_s
from CNCStepper.workbench.calculation import result_cache
from CNCStepper.workbench.services import jit_guard
from CNCStepper.workers import cycle_cutting

JOB = Path(cycle_cutting.__file__).parents[1] / "workers" / "kernel_warm_up.toml"
LATHE_JOB = Path(__file__).parents[3] / "examples" / "jobs" / "lathe-cone.toml"


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    said: list[dict[str, Any]] = []
    monkeypatch.setattr(cycle_cutting, "tell", said.append)
    return said


def one_operation() -> tuple[Any, Any]:
    job, machine = load_job(JOB)
    return job.model_copy(update={"operation": job.operation[:1]}), machine


def ask(parts: dict[str, Any], told: list[dict[str, Any]]) -> dict[str, Any]:
    cycle_cutting.Answers(SimpleQueue())._answer({"mark": 1, "compiled": True, "parts": parts})
    return {each["key"]: each["answer"] for each in told if "key" in each}


def test_it_answers_what_the_core_makes(told: list[dict[str, Any]]) -> None:
    job, machine = one_operation()
    content, profile = content_of(job), machine_content(machine)
    program = {"program": content, "machine": profile, "title": "Part"}
    cut = {"cut": content, "machine": profile}
    answers = ask({"a": cut, "b": program, "c": {"time_of": cut}}, told)
    moves, [answer] = cut_operations(job.on(machine))
    assert answers["c"]["time_s"] == pytest.approx(duration_s(begun(moves), machine), rel=0.02)
    assert answers["a"] == {"figures": answer.figures, "warnings": answer.warnings}
    assert answers["b"]["texts"] == [("", make_program(job, machine, "Part").program)]
    assert "G1" in answers["b"]["paths"][0]
    assert told[0] == {"begun": 1} and told[-1] == {"done": 1}


def test_a_report_has_each_operation_with_its_time_and_the_program(told: list[dict[str, Any]], tmp_path: Path) -> None:
    job, machine = one_operation()
    of = {"program": content_of(job), "machine": machine_content(machine), "title": "Sign"}
    text = make_program(job, machine, "Sign").program
    sheet = {"title": "Sign", "text": text, "facts": [["Material", "mdf"]], "together": "Together", "most": 1}
    sheet |= {"operations": [["1", "Letters · T1"]]}
    for name in ("a.pdf", "a.html"):
        ask({name: {"sheet": {**sheet, "file": str(tmp_path / name)}, "of": of}}, told)
    page = (tmp_path / "a.html").read_text("utf-8")
    assert re.search(r"Letters · T1 · \d+(\.\d)? ", page) and "Together" in page and "mdf" in page
    assert (tmp_path / "a.pdf").read_bytes().startswith(b"%PDF")
    refused = ask({"b": {"sheet": {**sheet, "file": str(tmp_path / "a.txt")}, "of": of}}, told)["b"]
    assert refused["error"]["code"] == "sheet-kind"


def test_a_refusal_is_an_answer(told: list[dict[str, Any]]) -> None:
    job, machine = one_operation()
    content = content_of(job)
    content["operation"][0]["stepover_mm"] = 1000.0
    answers = ask({"a": {"cut": content, "machine": machine_content(machine)}}, told)
    result_cache.take("a", answers["a"])
    known = result_cache.known("a")
    result_cache.forget()
    assert isinstance(known, CycleError) and "stepover_mm" in known.what


@pytest.mark.parametrize("code", ["cut-lost", "cut-memory", "cut-fault"])
def test_what_a_failed_process_left_unanswered_is_asked_anew(monkeypatch: pytest.MonkeyPatch, code: str) -> None:
    now_s = [100.0]
    monkeypatch.setattr(result_cache.time, "monotonic", lambda: now_s[0])
    key = request_digest.key_of({"a": 1})
    result_cache.keep(key, CNCStepperError(code, "the process ended"))
    assert not result_cache.may_ask(key)  # the recompute that asked takes it for its answer
    now_s[0] += 10
    assert result_cache.may_ask(key)
    with pytest.raises(CNCStepperError):  # nothing is calculated in the window's thread meanwhile
        result_cache.answer_to({"a": 1})
    result_cache.keep(key, result_cache.Cut({}, ()))
    assert not result_cache.may_ask(key) and result_cache.answer_to({"a": 1}) is not None
    result_cache.keep("b", CycleError("stepover", "refused"))
    now_s[0] += 10
    assert not result_cache.may_ask("b")
    result_cache.forget()


def test_a_newer_question_ends_the_work_on_the_one_before(told: list[dict[str, Any]]) -> None:
    job, machine = one_operation()
    questions: SimpleQueue[dict[str, Any]] = SimpleQueue()
    answers = cycle_cutting.Answers(questions)
    part = {"cut": content_of(job), "machine": machine_content(machine)}
    questions.put({"mark": 2, "compiled": True, "parts": {}})
    with pytest.raises(cycle_cutting.Outdated):
        answers._answer({"mark": 1, "compiled": True, "parts": {"a": part}})
    assert {"done": 1} not in told
    assert answers._newest.wait()["mark"] == 2


def test_what_takes_long_in_a_window_is_ended_and_left_to_the_process(monkeypatch: pytest.MonkeyPatch) -> None:
    job, machine = one_operation()
    refused: list[int] = []
    monkeypatch.setattr(jit_guard, "long_refused", lambda: refused.append(1))
    monkeypatch.setattr(jit_guard, "hurry", False)
    monkeypatch.setattr(jit_guard, "loaded", True)
    monkeypatch.setattr(jit_guard, "MOST_S", 0.0)
    with pytest.raises(CNCStepperError) as raised, jit_guard.without_compiling():
        cut_operations(job.on(machine))
    assert raised.value.code == jit_guard.LONG and refused


def test_the_first_that_takes_long_has_the_time_to_load_the_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(jit_guard, "long_refused", lambda: None)
    monkeypatch.setattr(jit_guard, "hurry", False)
    monkeypatch.setattr(jit_guard, "loaded", False)
    monkeypatch.setattr(jit_guard, "LOADED_S", -1.0)
    monkeypatch.setattr(jit_guard, "MOST_S", -1.0)
    with jit_guard.without_compiling():
        checkpoint()
    with pytest.raises(CNCStepperError) as raised, jit_guard.without_compiling():
        checkpoint()
    assert raised.value.code == jit_guard.LONG


def test_without_a_window_a_cut_takes_its_time(monkeypatch: pytest.MonkeyPatch) -> None:
    job, machine = one_operation()
    monkeypatch.setattr(jit_guard, "MOST_S", 0.0)
    with jit_guard.without_compiling():
        assert len(cut_operations(job.on(machine))[0])


def test_whoever_begins_a_calculation_can_end_it() -> None:
    job, machine = one_operation()
    looks: list[float] = []

    def look() -> None:
        looks.append(time.monotonic())
        if len(looks) == 3:
            raise TimeoutError

    with pytest.raises(TimeoutError), interruptible(look):
        cut_operations(job.on(machine))
    assert len(looks) == 3


def test_a_question_is_named_by_all_that_it_holds() -> None:
    def asked(depth_mm: float, kind: type = dict, **given: int) -> str:
        return request_digest.key_of(
            {"cut": {**given, "operation": [kind({"depth_mm": depth_mm})]}, "machine": kind(a=1)}
        )

    names = [
        asked(1.0),
        asked(2.0),
        asked(1.0, b=1),
        asked(1.0, request_digest.Content),
        asked(2.0, request_digest.Content),
    ]
    assert len(set(names)) == len(names)
    assert asked(1.0, request_digest.Content) == asked(1.0, request_digest.Content)


def test_a_report_of_a_lathe_s_job_has_its_operations_times_and_bar(told: list[dict[str, Any]], tmp_path: Path) -> None:
    job, machine = load_turning_job(LATHE_JOB)
    title, path = "Shaft", tmp_path / "a.html"
    text = make_turning(job, machine, title)[0].program
    of = {"turned_program": turning_transfer.content_of(job, machine), "title": title}
    rows = [[f"{number}", each.cycle] for number, each in enumerate(job.operation, start=1)]
    sheet = {"title": title, "text": text, "facts": [], "operations": rows, "together": "Together", "most": 20}
    answer = ask({"a": {"sheet": {**sheet, "file": str(path)}, "of": of}}, told)["a"]
    assert answer == {"written": str(path)}
    page = path.read_text("utf-8")
    assert re.search(r"turn_rough · \d+(\.\d)? ", page) and "<!-- stock -->" in page and "<!-- Z (mm) -->" in page
    moves, _ = turned_moves(job, machine)
    whole_s = duration_s(begun(moves), machine)
    assert sum(turning_transfer.operation_times_s(job, machine)) == pytest.approx(whole_s)
