# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut process: the same figures and programs as in one's own process, refusals as answers, the newest wins."""

from __future__ import annotations

import time
from pathlib import Path
from queue import SimpleQueue
from typing import Any

import pytest

from CNCStepper.checkpoint import checkpoint, interruptible
from CNCStepper.errors import CNCStepperError, CycleError
from CNCStepper.job.make import cut_operations, make_program
from CNCStepper.job.model import load_job
from CNCStepper.workbench import cut_answers, cut_worker, patience
from CNCStepper.workbench.setting import content_of, machine_content

JOB = Path(cut_worker.__file__).parents[1] / "job" / "warm.toml"


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> list[dict[str, Any]]:
    said: list[dict[str, Any]] = []
    monkeypatch.setattr(cut_worker, "tell", said.append)
    return said


def one_operation() -> tuple[Any, Any]:
    job, machine = load_job(JOB)
    return job.model_copy(update={"operation": job.operation[:1]}), machine


def ask(parts: dict[str, Any], told: list[dict[str, Any]]) -> dict[str, Any]:
    cut_worker.Answers(SimpleQueue())._answer({"mark": 1, "compiled": True, "parts": parts})
    return {each["key"]: each["answer"] for each in told if "key" in each}


def test_it_answers_what_the_core_makes(told: list[dict[str, Any]]) -> None:
    job, machine = one_operation()
    content, profile = content_of(job), machine_content(machine)
    program = {"program": content, "machine": profile, "title": "Part"}
    answers = ask({"a": {"cut": content, "machine": profile}, "b": program}, told)
    _, [answer] = cut_operations(job.on(machine))
    assert answers["a"] == {"figures": answer.figures, "warnings": answer.warnings}
    assert answers["b"]["texts"] == [("", make_program(job, machine, "Part").program)]
    assert "G1" in answers["b"]["paths"][0]
    assert told[0] == {"begun": 1} and told[-1] == {"done": 1}


def test_a_refusal_is_an_answer(told: list[dict[str, Any]]) -> None:
    job, machine = one_operation()
    content = content_of(job)
    content["operation"][0]["stepover_mm"] = 1000.0
    answers = ask({"a": {"cut": content, "machine": machine_content(machine)}}, told)
    cut_answers.take("a", answers["a"])
    known = cut_answers.known("a")
    cut_answers.forget()
    assert isinstance(known, CycleError) and "stepover_mm" in known.what


@pytest.mark.parametrize("code", ["cut-lost", "cut-memory", "cut-fault"])
def test_what_a_failed_process_left_unanswered_is_asked_anew(monkeypatch: pytest.MonkeyPatch, code: str) -> None:
    now_s = [100.0]
    monkeypatch.setattr(cut_answers.time, "monotonic", lambda: now_s[0])
    key = cut_answers.key_of({"a": 1})
    cut_answers.keep(key, CNCStepperError(code, "the process ended"))
    assert not cut_answers.may_ask(key)  # the recompute that asked takes it for its answer
    now_s[0] += 10
    assert cut_answers.may_ask(key)
    with pytest.raises(CNCStepperError):  # nothing is calculated in the window's thread meanwhile
        cut_answers.answer_to({"a": 1})
    cut_answers.keep(key, cut_answers.Cut({}, ()))
    assert not cut_answers.may_ask(key) and cut_answers.answer_to({"a": 1}) is not None
    cut_answers.keep("b", CycleError("stepover", "refused"))
    now_s[0] += 10
    assert not cut_answers.may_ask("b")
    cut_answers.forget()


def test_a_newer_question_ends_the_work_on_the_one_before(told: list[dict[str, Any]]) -> None:
    job, machine = one_operation()
    questions: SimpleQueue[dict[str, Any]] = SimpleQueue()
    answers = cut_worker.Answers(questions)
    part = {"cut": content_of(job), "machine": machine_content(machine)}
    questions.put({"mark": 2, "compiled": True, "parts": {}})
    with pytest.raises(cut_worker.Outdated):
        answers._answer({"mark": 1, "compiled": True, "parts": {"a": part}})
    assert {"done": 1} not in told
    assert answers._newest()["mark"] == 2


def test_what_takes_long_in_a_window_is_ended_and_left_to_the_process(monkeypatch: pytest.MonkeyPatch) -> None:
    job, machine = one_operation()
    refused: list[int] = []
    monkeypatch.setattr(patience, "long_refused", lambda: refused.append(1))
    monkeypatch.setattr(patience, "hurry", False)
    monkeypatch.setattr(patience, "loaded", True)
    monkeypatch.setattr(patience, "MOST_S", 0.0)
    with pytest.raises(CNCStepperError) as raised, patience.patience():
        cut_operations(job.on(machine))
    assert raised.value.code == patience.LONG and refused


def test_the_first_that_takes_long_has_the_time_to_load_the_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(patience, "long_refused", lambda: None)
    monkeypatch.setattr(patience, "hurry", False)
    monkeypatch.setattr(patience, "loaded", False)
    monkeypatch.setattr(patience, "LOADED_S", -1.0)
    monkeypatch.setattr(patience, "MOST_S", -1.0)
    with patience.patience():
        checkpoint()
    with pytest.raises(CNCStepperError) as raised, patience.patience():
        checkpoint()
    assert raised.value.code == patience.LONG


def test_without_a_window_a_cut_takes_its_time(monkeypatch: pytest.MonkeyPatch) -> None:
    job, machine = one_operation()
    monkeypatch.setattr(patience, "MOST_S", 0.0)
    with patience.patience():
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
        return cut_answers.key_of({"cut": {**given, "operation": [kind({"depth_mm": depth_mm})]}, "machine": kind(a=1)})

    names = [asked(1.0), asked(2.0), asked(1.0, b=1), asked(1.0, cut_answers.Content), asked(2.0, cut_answers.Content)]
    assert len(set(names)) == len(names)
    assert asked(1.0, cut_answers.Content) == asked(1.0, cut_answers.Content)
