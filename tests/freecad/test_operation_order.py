# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations are moved and copied within their job; nothing leaves it, and undo gives all back."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.document.operation_order import can_step, duplicate, job_of, move, step
from CNCStepper.workbench.features.base import problem_of, proxy_type


@pytest.fixture
def job(document: Any) -> Any:
    """A job with five circular pockets, a to e, of which the second stands on a drawing."""
    document.UndoMode = 1
    job = api.new_job(document)
    api.add_tool(job)
    for number, label in enumerate("abcde"):
        made = api.add_operation(job, "circular_pocket", depth_mm=1 + number, radius_mm=10)
        made.Label = label
    document.recompute()
    return job


def labels(job: Any) -> str:
    return "".join(operation.Label[0] for operation in job.Operations)


def of(job: Any, wanted: str) -> list[Any]:
    return [operation for operation in job.Operations if operation.Label in wanted]


@pytest.mark.parametrize(
    ("moved", "beside", "after", "order"),
    [
        ("a", "c", True, "bcade"),
        ("a", "c", False, "bacde"),
        ("e", "a", False, "eabcd"),
        ("bd", "e", True, "acebd"),
        ("db", "a", False, "bdace"),
        ("a", "", True, "bcdea"),
        ("b", "b", True, "abcde"),
        ("a", "b", False, "abcde"),
    ],
)
def test_operations_are_moved(job: Any, moved: str, beside: str, after: bool, order: str) -> None:
    before = api.program_text(job)
    job.Document.openTransaction("Move")
    move(job, of(job, moved), of(job, beside)[0] if beside else None, after)
    job.Document.commitTransaction()
    job.Document.recompute()
    assert labels(job) == order
    assert (api.program_text(job) == before) == (order == "abcde")
    if order != "abcde":
        job.Document.undo()
        assert labels(job) == "abcde"
        assert api.program_text(job) == before


@pytest.mark.parametrize(
    ("moved", "by", "order"),
    [("a", 1, "bacde"), ("a", -1, "abcde"), ("ab", -1, "abcde"), ("bc", -1, "bcade"), ("ac", -1, "acbde"),
     ("de", 1, "abcde"), ("ce", 1, "abdce"), ("be", 1, "acbde")],
)  # fmt: skip
def test_operations_step_up_and_down(job: Any, moved: str, by: int, order: str) -> None:
    assert can_step(of(job, moved), by) == (order != "abcde")
    step(of(job, moved), by)
    assert labels(job) == order


def test_an_operation_of_another_job_is_not_moved(document: Any, job: Any) -> None:
    other = api.new_job(document)
    api.add_tool(other)
    stranger = api.add_operation(other, "circular_pocket", depth_mm=1, radius_mm=10)
    with pytest.raises(JobError, match="is no operation of"):
        move(job, [stranger, *of(job, "a")], of(job, "c")[0])
    assert labels(job) == "abcde"
    assert list(other.Operations) == [stranger]


def test_duplicates_stand_behind_their_originals(document: Any, job: Any) -> None:
    objects, before = len(document.Objects), api.program_text(job)
    document.openTransaction("Duplicate")
    copies = duplicate(of(job, "bd"))
    document.commitTransaction()
    document.recompute()
    assert [each.Label[0] for each in job.Operations] == list("abbcdde")
    assert [job_of(copy) for copy in copies] == [job, job]
    assert [copy.Tool for copy in copies] == [job.Tools[0]] * 2
    assert [problem_of(copy) for copy in copies] == ["", ""]
    assert float(copies[0].Depth) == 2
    api.edit(copies[0], depth_mm=3)
    document.recompute()
    assert float(of(job, "b")[0].Depth) == 2
    document.undo()
    assert (len(document.Objects), labels(job), api.program_text(job)) == (objects, "abcde", before)


@pytest.mark.parametrize("recursive", [False, True])
def test_what_freecad_copies_lands_behind_the_original(document: Any, job: Any, recursive: bool) -> None:
    document.copyObject(of(job, "c")[0], recursive)
    document.recompute()
    assert [each.Label[0] for each in job.Operations] == list("abccde")
    copy = job.Operations[3]
    assert copy.Tool == job.Tools[0]
    assert [problem_of(obj) for obj in document.Objects if proxy_type(obj)] == [""] * len(document.Objects)
    document.copyObject(copy, recursive)
    document.recompute()
    assert [each.Label[0] for each in job.Operations] == list("abcccde")
    assert api.program_text(job)


def test_a_copied_tool_is_one_more_tool_of_the_job(document: Any, job: Any) -> None:
    copy = document.copyObject(job.Tools[0])
    assert list(job.Tools)[1:] == [copy]
    assert copy.Number == job.Tools[0].Number + 1


def test_a_copied_job_keeps_its_operations_to_itself(document: Any, job: Any) -> None:
    document.copyObject([job], True)
    document.recompute()
    jobs = [obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_Job"]
    assert [len(each.Operations) for each in jobs] == [5, 5]
    assert [len(each.Tools) for each in jobs] == [1, 1]
    assert api.program_text(jobs[1]).splitlines()[1:] == api.program_text(jobs[0]).splitlines()[1:]


def test_into_another_document_it_lands_in_the_only_job(document: Any, job: Any) -> None:
    other = FreeCAD.newDocument("Other")
    into = api.new_job(other)
    api.add_tool(into)
    copy = other.copyObject(of(job, "b")[0], True)
    copy = copy[-1] if isinstance(copy, list | tuple) else copy
    other.recompute()
    assert [problem_of(obj) for obj in into.Operations] == [""]
    assert len(into.Operations) == 1
    assert into.Operations[0].Tool in into.Tools
    assert len({tool.Number for tool in into.Tools}) == len(into.Tools)
    assert labels(job) == "abcde"


def test_a_reopened_document_takes_nothing_in(document: Any, job: Any, tmp_path: Path) -> None:
    lonely = of(job, "e")[0]
    job.Operations = of(job, "abcd")
    document.saveAs(str(tmp_path / "a.FCStd"))
    document.saveAs(str(tmp_path / "b.FCStd"))
    name, own = lonely.Name, job.Name
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(tmp_path / "b.FCStd"))
    assert labels(again.getObject(own)) == "abcd"
    assert again.getObject(name) is not None
