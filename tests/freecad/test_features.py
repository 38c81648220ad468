# SPDX-License-Identifier: LGPL-2.1-or-later
"""The weak places of the document objects: what is deleted, refused at once, cut once, old, or not writable."""

from __future__ import annotations

import resource
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest
from FreeCAD import Vector

from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import problem_of

DATA = Path(__file__).parent / "data"


@pytest.fixture
def job(document: Any) -> Any:
    job = api.new_job(document)
    api.add_tool(job, diameter_mm=6)
    return job


def sketched_ellipse(document: Any, label: str) -> Any:
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.exposeInternalGeometry(sketch.addGeometry(Part.Ellipse(Vector(40, 0), Vector(0, 25), Vector())))
    sketch.Label = label
    return sketch


@pytest.mark.parametrize("add", [api.add_elliptical_pocket, api.add_engrave])
def test_a_deleted_drawing_is_named_until_another_is_chosen(document: Any, job: Any, add: Any) -> None:
    sketch = sketched_ellipse(document, "Elipse da peça")
    operation = add(job, sketch, depth_mm=2)
    document.recompute()
    good = api.program_text(job)
    document.removeObject(sketch.Name)
    with pytest.raises(JobError):
        api.program_text(job)
    document.recompute()
    assert "'Elipse da peça'" in problem_of(operation)
    assert "'Elipse da peça'" in job.Message
    assert program_file.load(job) == ""
    api.edit(operation, drawing=sketched_ellipse(document, "Outra"))
    document.recompute()
    assert problem_of(operation) == ""
    assert api.program_text(job) == good


def test_a_drawing_that_was_let_go_leaves_the_numbers(document: Any, job: Any) -> None:
    pocket = api.add_elliptical_pocket(job, sketched_ellipse(document, "Elipse"), depth_mm=2)
    document.recompute()
    good = api.program_text(job)
    api.edit(pocket, drawing=None)
    document.recompute()
    assert problem_of(pocket) == ""
    assert api.program_text(job) == good


def test_after_a_deletion_none_can_be_chosen(document: Any, job: Any) -> None:
    sketch = sketched_ellipse(document, "Elipse")
    pocket = api.add_elliptical_pocket(job, sketch, depth_mm=2)
    document.recompute()
    good = api.program_text(job)
    document.removeObject(sketch.Name)
    document.recompute()
    assert problem_of(pocket)
    api.edit(pocket, drawing=None)
    document.recompute()
    assert problem_of(pocket) == ""
    assert api.program_text(job) == good


def test_the_undone_deletion_of_a_drawing_mends_all(document: Any, job: Any) -> None:
    document.UndoMode = 1
    sketch = sketched_ellipse(document, "Elipse")
    pocket = api.add_elliptical_pocket(job, sketch, depth_mm=2)
    document.recompute()
    good = api.program_text(job)
    document.openTransaction("delete")
    document.removeObject(sketch.Name)
    document.recompute()
    document.commitTransaction()
    assert problem_of(pocket)
    document.undo()
    document.recompute()
    assert problem_of(pocket) == ""
    assert api.program_text(job) == good


@pytest.mark.parametrize(
    ("values", "word"),
    [
        ({"machine": "table-q"}, "table-q"),
        ({"stock_size_mm": (100, 70, 0)}, "stock"),
        ({"stock_size_mm": (100, -70, 20)}, "stock"),
    ],
)
def test_a_job_that_can_never_be_is_refused_at_once(document: Any, values: dict[str, Any], word: str) -> None:
    with pytest.raises(JobError, match=word):
        api.new_job(document, **values)
    assert document.Objects == []


@pytest.mark.parametrize("values", [{"diameter_mm": 0}, {"feed_mm_min": -1}, {"number": 256}])
def test_a_tool_that_can_never_be_is_refused_at_once(job: Any, values: dict[str, Any]) -> None:
    before = len(job.Document.Objects)
    with pytest.raises(JobError, match=next(iter(values))):
        api.add_tool(job, **values)
    assert len(job.Document.Objects) == before
    assert len(job.Tools) == 1


@pytest.mark.parametrize(
    ("name", "value", "word"),
    [("StockSize", Vector(0, 70, 20), "stock"), ("Machine", "nonesuch", "nonesuch"), ("Dialect", "klingon", "klingon")],
)
def test_a_bad_value_in_the_property_editor_takes_the_program_back(
    document: Any, job: Any, name: str, value: Any, word: str
) -> None:
    api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    good, before = api.program_text(job), getattr(job, name)
    setattr(job, name, value)
    document.recompute()
    assert word in problem_of(job)
    assert program_file.load(job) == ""
    setattr(job, name, before)
    document.recompute()
    assert problem_of(job) == ""
    assert api.program_text(job) == good


@pytest.mark.parametrize("path", ["nonesuch/program.nc", "."])
def test_a_program_that_cannot_be_written_says_so(document: Any, job: Any, tmp_path: Path, path: str) -> None:
    api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    with pytest.raises(JobError, match="cannot be written") as refusal:
        api.save_program(job, tmp_path / path)
    assert refusal.value.code == "program-unwritable"


def test_an_operation_is_cut_once_a_recompute(document: Any, job: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    cuts = []
    original = EllipticalPocket.cut
    monkeypatch.setattr(EllipticalPocket, "cut", lambda *given: (cuts.append(1), original(*given))[1])
    first = api.add_elliptical_pocket(job, depth_mm=2)
    second = api.add_elliptical_pocket(job, depth_mm=3, radius_x_mm=30)
    document.recompute()
    assert len(cuts) == 2
    api.edit(first, depth_mm=4)
    document.recompute()
    assert len(cuts) == 3
    api.edit(job.Tools[0], feed_mm_min=500)
    document.recompute()
    assert len(cuts) == 5
    fresh = api.program_text(job)
    for operation in (first, second):
        operation.Proxy.last_cut = None
    job.touch()
    document.recompute()
    assert api.program_text(job) == fresh
    assert len(cuts) == 7


def test_a_document_of_the_first_release_opens_with_its_program(tmp_path: Path) -> None:
    wanted = (DATA / "first-release.nc").read_bytes().decode("ascii")
    path = tmp_path / "first-release.FCStd"
    path.write_bytes((DATA / "first-release.FCStd").read_bytes())
    document = FreeCAD.openDocument(str(path))
    try:
        job = document.getObject("CNCStepper_Job")
        assert program_file.load(job) == wanted
        document.recompute()  # a newer FreeCAD marks the sketches of an older one as changed
        assert blocks(api.program_text(job)) == blocks(wanted)
        for obj in document.Objects:
            obj.touch()
        document.recompute()
        assert [problem_of(obj) for obj in document.Objects] == [""] * len(document.Objects)
        assert blocks(api.program_text(job)) == blocks(wanted)
    finally:
        FreeCAD.closeDocument(document.Name)


def blocks(text: str) -> list[str]:
    """Return the blocks of a program without its comments, which have grown, and its G80, which grbl's have no more."""
    return [line.replace(" G80", "") for line in text.splitlines() if not line.startswith("(")]


def test_memory_stays_flat_over_200_recomputes(document: Any, job: Any) -> None:
    pocket = api.add_elliptical_pocket(job, depth_mm=2, radius_x_mm=15, radius_y_mm=10)

    def edits(count: int) -> None:
        for number in range(count):
            api.edit(pocket, depth_mm=2 + number % 2 / 10)
            document.recompute()

    edits(50)
    before_mb = resident_mb()
    edits(200)
    assert resident_mb() - before_mb < 4


def resident_mb() -> float:
    """Return the memory that this process holds now (Linux)."""
    pages = int(Path("/proc/self/statm").read_text("ascii").split()[1])
    return pages * resource.getpagesize() / 2**20


def test_after_undo_and_redo_the_program_is_made_again(document: Any, job: Any) -> None:
    document.UndoMode = 1
    pocket = api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    before = api.program_text(job)
    document.openTransaction("edit")
    api.edit(pocket, depth_mm=3)
    document.recompute()
    document.commitTransaction()
    after = api.program_text(job)
    document.undo()
    assert api.program_text(job) == before
    document.redo()
    assert api.program_text(job) == after
    assert document.UndoCount == 1


NUMBERS_IN = ("Depth", "Stepdown", "Stepover", "RadiusX", "RadiusY", "FinishStepdown", "FinishStepover", "FinishFeed")


@pytest.mark.parametrize("value", [0.0, -1.0, 1e-12, 1e9, 1e300])
def test_no_number_in_the_property_editor_raises_or_leaves_an_old_program(
    document: Any, job: Any, value: float, capfd: pytest.CaptureFixture[str]
) -> None:
    pocket = api.add_elliptical_pocket(job, depth_mm=2, method="tolerance")
    document.recompute()
    for obj, names in ((pocket, NUMBERS_IN), (job.Tools[0], ("Diameter", "Feed", "Plunge", "SpindleSpeed"))):
        for name in names:
            before = getattr(obj, name)
            setattr(obj, name, value)
            document.recompute()
            assert (program_file.load(job) == "") == bool(problem_of(job)), name
            setattr(obj, name, before)
    document.recompute()
    assert problem_of(job) == ""
    assert "Traceback" not in "".join(capfd.readouterr())
