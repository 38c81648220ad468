# SPDX-License-Identifier: LGPL-2.1-or-later
"""An edit of a job looks at what has changed, and not again at every operation that it holds."""

from __future__ import annotations

import json
import sys
from collections import Counter
from collections.abc import Callable
from typing import Any

import FreeCAD
import numpy as np
import Part
import pytest
from FreeCAD import Placement, Rotation, Vector

from CNCStepper.job.cut_transfer import setting_from
from CNCStepper.workbench import api
from CNCStepper.workbench.calculation import precalculation, result_cache
from CNCStepper.workbench.calculation.recompute import remake, steps
from CNCStepper.workbench.document import core_job
from CNCStepper.workbench.features.base import edit, proxy_type

ONCE = ("reach_of", "_stamp", "model_construct", "stock_content")  # what all operations need of their job
MOST_CALLS = 130  # of Python's functions, for an operation that a panel of its job looks at with every key
COUNTED = ("value_of", "curve_of_chain", "validated", "model_of", "cycle_values", "load_machine", "drawn_of")
CYCLES = ("drill", "pocket", "contour", "rectangular_pocket", "engrave")


class NoProcess:
    unavailable = False


@pytest.fixture(autouse=True)
def asked(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.setattr(precalculation, "process", lambda: NoProcess)
    yield
    result_cache.forget()


def job_of(document: Any, operations: int) -> Any:
    job = api.new_job(document, stock_size_mm=(100, 80, 20))
    api.add_tool(job)
    square = document.addObject("Part::Feature", "Square")
    square.Shape = Part.makePolygon([Vector(*at, 0) for at in ((0, 0), (40, 0), (40, 30), (0, 30), (0, 0))])
    for number in range(operations):
        cycle = CYCLES[number % len(CYCLES)]
        drawn = square if cycle in ("pocket", "contour", "engrave") else None
        api.add_operation(job, cycle, drawn, depth_mm=1.0, **({"tolerance_mm": 0.02} if drawn else {}))
    document.recompute()
    assert not job.Message
    return job


def answer(look: Any) -> None:
    """Let the cut process have answered all that a look wants to know."""
    for key, question in look.unknown.items():
        is_cut = "cut" in question
        result_cache.keep(key, result_cache.Cut({}, ()) if is_cut else result_cache.Programs((("", "G21\n"),), ("",)))


def calls_of(function: Callable[[], Any], counted: tuple[str, ...] = COUNTED) -> Counter[str]:
    """Return how often each of the counted functions is called, and how often any under ""."""
    calls: Counter[str] = Counter()

    def note(frame: Any, event: str, _: Any) -> None:
        if event == "call":
            calls[""] += 1
            if frame.f_code.co_name in counted:
                calls[frame.f_code.co_name] += 1

    sys.setprofile(note)
    try:
        function()
    finally:
        sys.setprofile(None)
    return calls


def one_edit(job: Any, **changes: Any) -> None:
    """Do what a panel does with an edit that the cut process answers."""
    answer(precalculation.look_at(job.Document, job, changes))
    assert not precalculation.look_at(job.Document, job, changes).unknown
    edit(job, **changes)
    remake(job.Document)


@pytest.mark.parametrize("changes", [{"units": "inch"}, {"edge_mm": 2.0}, {"coolant": "mist"}])
def test_an_edit_of_a_job_costs_the_same_with_many_operations(document: Any, changes: dict[str, Any]) -> None:
    few, many = job_of(document, 5), job_of(FreeCAD.newDocument("Many"), 30)
    counts = [calls_of(lambda job=job: one_edit(job, **changes)) for job in (few, many)]  # type: ignore[misc]
    assert counts[0]["value_of"]
    assert all(counts[0][name] == counts[1][name] for name in COUNTED)


HEIGHT = {"stock_size_mm": (100.0, 80.0, 21.0)}


def test_a_look_works_out_once_what_all_operations_need_of_their_job(document: Any) -> None:
    few, many = job_of(document, 5), job_of(FreeCAD.newDocument("Many"), 30)
    for job in (few, many):
        precalculation.look_at(job.Document, job, {"stock_size_mm": (100.0, 80.0, 22.0)})  # what is kept is kept now
    counts = [calls_of(lambda job=job: precalculation.look_at(job.Document, job, HEIGHT), ONCE) for job in (few, many)]  # type: ignore[misc]
    assert all(counts[0][name] == counts[1][name] for name in ONCE), counts
    assert (counts[1][""] - counts[0][""]) / 25 < MOST_CALLS


def test_a_question_holds_what_the_cut_in_the_window_is_set_up_with(document: Any) -> None:
    job = job_of(document, 5)
    machine = core_job.machine_content(core_job.machine_of(job))
    for operation in job.Operations:
        cycle = operation.Proxy.cycle(operation, tuple(job.WorkOrigin))
        question = json.loads(json.dumps(core_job.cut_question(job, operation, cycle)))
        asked = setting_from(question["cut"], machine)
        assert asked.setup(asked.operation[0]) == core_job.setup_of(job, operation, cycle)


def test_each_height_of_the_stock_is_a_question_of_its_own(document: Any) -> None:
    job = job_of(document, 5)
    looks = [precalculation.look_at(document, job, {"stock_size_mm": (100.0, 80.0, height)}) for height in (21.0, 22.0)]
    assert len(looks[0].unknown) == 6 and not looks[0].unknown.keys() & looks[1].unknown.keys()
    assert {question["cut"]["stock"]["size_mm"][2] for question in looks[1].unknown.values() if "cut" in question} == {
        22.0
    }


def test_a_height_of_a_job_makes_no_cycle_and_no_curve_anew(document: Any) -> None:
    job = job_of(document, 10)
    calls = calls_of(lambda: one_edit(job, clearance_mm=12.0))
    assert not any(calls[name] for name in ("curve_of_chain", "cycle_values", "drawn_of", "load_machine"))


def test_what_is_kept_of_an_operation_follows_every_change(document: Any) -> None:
    job = job_of(document, 3)
    drill, pocket = job.Operations[0], job.Operations[1]
    square = document.getObject("Square")

    def region() -> list[list[float]]:
        return api.job_model(job).operation[1].outlines[0].xy.tolist()  # type: ignore[no-any-return]

    before = region()
    api.edit(drill, depth_mm=3.0)
    assert api.job_model(job).operation[0].depth_mm == 3.0
    api.edit(job.Tools[0], number=7)
    assert {each.tool for each in api.job_model(job).operation} == {7}
    square.Placement = Placement(Vector(5, 0, 0), Rotation())
    document.recompute()
    assert region() == [[x + 5, y] for x, y in before]
    square.Shape = Part.makePolygon([Vector(*at, 0) for at in ((0, 0), (20, 0), (20, 30), (0, 30), (0, 0))])
    document.recompute()
    assert np.ptp(region(), axis=0).tolist() == [20, 30]
    api.edit(job, work_origin_mm=(1.0, 2.0, 0.0))
    shifted = region()
    api.edit(job, work_origin_mm=(0.0, 0.0, 0.0))
    assert region() == [[x + 1, y + 2] for x, y in shifted]
    api.edit(pocket, tolerance_mm=0.05)
    assert api.job_model(job).operation[1].tolerance_mm == 0.05


def test_a_picture_that_is_left_is_drawn_with_the_document(document: Any) -> None:
    job = job_of(document, 1)
    (preview,) = [obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_Preview"]
    before = preview.Path.toGCode()
    edit(job.Operations[0], depth_mm=3.5)
    list(steps(document, lambda obj: obj is preview and not obj.touch()))
    assert preview.Path.toGCode() == before and "Touched" in preview.State
    document.recompute()
    assert "-3.5" in preview.Path.toGCode() and "Touched" not in preview.State
