# SPDX-License-Identifier: LGPL-2.1-or-later
"""The whole road inside a document: drawing, operation, job, program; made, edited, refused, saved, reopened."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import Draft
import FreeCAD
import numpy as np
import Part
import pytest
import Sketcher
from FreeCAD import Vector

from CNCStepper.errors import JobError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID
from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import problem_of, proxy_type


def sketched_ellipse(document: Any, rx: float = 40, ry: float = 25, centre: tuple[float, float] = (0, 0)) -> Any:
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    at = Vector(*centre)
    index = sketch.addGeometry(Part.Ellipse(at + Vector(rx, 0), at + Vector(0, ry), at))
    sketch.exposeInternalGeometry(index)
    return sketch


def new_job(document: Any, **values: Any) -> Any:
    job = api.new_job(document, **values)
    api.add_tool(job, shape="flat", diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    return job


def cut_points(text: str) -> np.ndarray:
    """Return the end points of all feed moves of a program, in work coordinates."""
    table = interpret(text, Start()).table()
    return table.end[table.kind != RAPID]


def reach_mm(text: str) -> np.ndarray:
    """Return the largest |X|, the largest |Y| and the deepest Z at which a program cuts."""
    points = cut_points(text)
    return np.array([np.abs(points[:, 0]).max(), np.abs(points[:, 1]).max(), points[:, 2].min()])


@pytest.fixture
def reopened(tmp_path: Path) -> Any:
    """A function that saves a document, closes it and opens it again."""

    def reopen(document: Any) -> Any:
        path = str(tmp_path / "peça nº 1.FCStd")
        document.saveAs(path)
        FreeCAD.closeDocument(document.Name)
        return FreeCAD.openDocument(path)

    return reopen


def test_a_pocket_from_numbers(document: Any) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, radius_x_mm=40, radius_y_mm=25, depth_mm=10)
    document.recompute()
    assert problem_of(pocket) == ""
    assert reach_mm(api.program_text(job)) == pytest.approx([37, 22, -10], abs=0.011)
    assert "G21" in api.program_text(job)


def test_a_pocket_follows_its_sketch(document: Any) -> None:
    sketch = sketched_ellipse(document)
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, sketch, depth_mm=4)
    document.recompute()
    before = api.program_text(job)
    assert reach_mm(before) == pytest.approx([37, 22, -4], abs=0.011)
    sketch.Placement.Base = Vector(5, 0, 0)
    with pytest.raises(JobError, match="has changed since"):
        api.program_text(job)
    document.recompute()
    assert reach_mm(api.program_text(job)) == pytest.approx([42, 22, -4], abs=0.011)
    assert tuple(pocket.Centre)[:2] == pytest.approx((5, 0))


def test_a_sketch_made_larger_by_its_constraint(document: Any) -> None:
    sketch = sketched_ellipse(document)
    job = new_job(document)
    api.add_engrave(job, sketch, depth_mm=1, tolerance_mm=0.01)
    major_axis = 1  # the line that exposeInternalGeometry drew
    sketch.addConstraint(Sketcher.Constraint("Coincident", 0, 3, -1, 1))
    sketch.addConstraint(Sketcher.Constraint("Horizontal", major_axis))
    datum = sketch.addConstraint(Sketcher.Constraint("Distance", major_axis, 80.0))
    document.recompute()
    assert reach_mm(api.program_text(job))[0] == pytest.approx(40, abs=0.02)
    sketch.setDatum(datum, FreeCAD.Units.Quantity("60 mm"))
    document.recompute()
    assert reach_mm(api.program_text(job))[0] == pytest.approx(30, abs=0.02)


def test_the_drawing_moves_with_the_body_that_holds_it(document: Any) -> None:
    part = document.addObject("App::Part", "Part")
    sketch = sketched_ellipse(document)
    part.addObject(sketch)
    job = new_job(document)
    api.add_elliptical_pocket(job, sketch, depth_mm=2)
    document.recompute()
    part.Placement.Base = Vector(0, 7, 0)
    document.recompute()
    assert reach_mm(api.program_text(job)) == pytest.approx([37, 29, -2], abs=0.011)


def test_the_work_zero_moves_the_program(document: Any) -> None:
    job = new_job(document, work_origin_mm=(-50, 0, 3))
    api.add_elliptical_pocket(job, sketched_ellipse(document), depth_mm=2)
    document.recompute()
    assert reach_mm(api.program_text(job))[0] == pytest.approx(87, abs=0.011)
    api.edit(job, work_origin_mm=(0, 0, 0))
    document.recompute()
    assert reach_mm(api.program_text(job))[0] == pytest.approx(37, abs=0.011)


def test_feeds_are_mm_min_in_the_program_whatever_freecad_keeps(document: Any) -> None:
    job = new_job(document)
    api.add_elliptical_pocket(job, depth_mm=2)
    job.Tools[0].Feed = "1.2 m/min"
    document.recompute()
    table = interpret(api.program_text(job), Start()).table()
    assert table.feed.max() == pytest.approx(1200)
    assert job.Tools[0].Feed.getValueAs("mm/min") == pytest.approx(1200)


def test_a_property_typed_with_its_unit(document: Any) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=2)
    pocket.Depth = "0.25 in"
    document.recompute()
    assert reach_mm(api.program_text(job))[2] == pytest.approx(-6.35, abs=1e-3)


def test_the_recalculated_steps_are_shown(document: Any) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=10, stepdown_mm=3, finish_stepdown_mm=0.2)
    document.recompute()
    assert 0 < pocket.StepdownUsed.Value <= 3
    assert (10 - 0.2) / pocket.StepdownUsed.Value == pytest.approx(round(9.8 / pocket.StepdownUsed.Value))
    assert 0 < pocket.StepoverUsed.Value <= 2.4
    assert "Up-to-date" in pocket.State


ENGRAVINGS: dict[str, Callable[[Any], Any]] = {
    "sketch": sketched_ellipse,
    "draft wire": lambda _: Draft.make_wire([Vector(0, 0), Vector(40, 0), Vector(40, 25)], closed=True),
    "b-spline": lambda _: Draft.make_bspline([Vector(0, 0), Vector(20, 25), Vector(40, 0)]),
    "freehand": lambda document: api.add_freehand(document, [(x, 25 * math.sin(x / 10)) for x in range(41)], 0.01),
}


@pytest.mark.parametrize("kind", ENGRAVINGS)
def test_an_engraving_follows_the_drawing(document: Any, kind: str) -> None:
    drawing = ENGRAVINGS[kind](document)
    job = new_job(document)
    api.add_engrave(job, drawing, depth_mm=0.5, tolerance_mm=0.01)
    document.recompute()
    points = cut_points(api.program_text(job))
    deep = points[points[:, 2] == -0.5]
    assert len(deep) > 2
    assert max(drawing.Shape.distToShape(Part.Vertex(Vector(x, y, 0)))[0] for x, y, _ in deep) < 0.012
    assert np.abs(deep[:, 0]).max() == pytest.approx(40, abs=0.02)


def refused(document: Any, obj: Any, sentence: str) -> None:
    """See that `obj` shows the sentence and that its job has neither program nor picture."""
    document.recompute()
    (job,) = [other for other in document.Objects if proxy_type(other) == "CNCStepper_Job"]
    (preview,) = [other for other in document.Objects if proxy_type(other) == "CNCStepper_Preview"]
    assert sentence in problem_of(obj)
    assert sentence in problem_of(job)
    assert sentence in job.Message
    assert preview.Path.Size == 0
    with pytest.raises(JobError):
        api.program_text(job)
    assert Path(job.Program).read_bytes() == b""


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"depth_mm": -1}, "depth"),
        ({"depth_mm": 0}, "depth"),
        ({"stepover_mm": 7}, "stepover"),
        ({"radius_y_mm": 2}, "tool"),
        ({"tolerance_mm": 0}, "tolerance"),
        ({"tool": None}, "no tool"),
    ],
)
def test_a_bad_edit_shows_why_and_leaves_no_old_program(document: Any, change: dict[str, Any], sentence: str) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    good, before = (
        api.program_text(job),
        {key: getattr(pocket, key) for key in ("Depth", "Stepover", "RadiusY", "Tool")},
    )
    api.edit(pocket, **change)
    refused(document, pocket, sentence)
    for name, value in before.items():
        setattr(pocket, name, value)
    api.edit(pocket, tolerance_mm=0.01)
    document.recompute()
    assert api.program_text(job) == good


def test_a_refusal_prints_nothing_into_the_report_view(document: Any, capfd: pytest.CaptureFixture[str]) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=-1)
    document.recompute()
    assert problem_of(pocket)
    printed = "".join(capfd.readouterr())
    assert "Traceback" not in printed
    assert "depth" not in printed


def test_a_tool_or_a_line_that_cannot_be_takes_the_program_back(document: Any) -> None:
    job = new_job(document)
    line = api.add_freehand(document, [(0, 0), (10, 0)])
    api.add_engrave(job, line)
    document.recompute()
    assert api.program_text(job)
    api.edit(job.Tools[0], diameter_mm=0)
    refused(document, job.Tools[0], "diameter_mm")
    api.edit(job.Tools[0], diameter_mm=3)
    document.recompute()
    assert api.program_text(job)
    api.edit(line, points_mm=[(1, 1)])
    refused(document, line, "two points")


def test_a_failed_sketch_is_named_instead_of_an_old_program(document: Any) -> None:
    sketch = sketched_ellipse(document)
    job = new_job(document)
    api.add_engrave(job, sketch)
    document.recompute()
    for radius in (10, 20):
        sketch.addConstraint(Sketcher.Constraint("Radius", sketch.addGeometry(Part.Circle()), radius))
        sketch.addConstraint(Sketcher.Constraint("Radius", sketch.GeometryCount - 1, radius + 1))
    document.recompute()
    assert not sketch.isValid()
    with pytest.raises(JobError, match="Sketch"):
        api.program_text(job)


def test_a_sentence_names_its_object_once(document: Any) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=-1)
    pocket.Label = "Bolsão"
    document.recompute()
    assert job.Message.count("Bolsão") == 1
    with pytest.raises(JobError) as refusal:
        api.program_text(job)
    assert str(refusal.value).count("Bolsão") == 1


def test_a_wider_tool_is_refused_by_the_operation_that_uses_it(document: Any) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, radius_x_mm=10, radius_y_mm=5, depth_mm=2, stepover_mm=1)
    document.recompute()
    assert api.program_text(job)
    api.edit(job.Tools[0], diameter_mm=12)
    refused(document, pocket, "tool")


def test_an_open_ellipse_is_refused(document: Any) -> None:
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.addGeometry(Part.ArcOfEllipse(Part.Ellipse(Vector(40, 0), Vector(0, 25), Vector()), 0, 3))
    job = new_job(document)
    refused(document, api.add_elliptical_pocket(job, sketch, depth_mm=2), "is open")


def test_a_deleted_drawing_leaves_no_old_program(document: Any) -> None:
    sketch = sketched_ellipse(document)
    job = new_job(document)
    engraving = api.add_engrave(job, sketch)
    document.recompute()
    assert api.program_text(job)
    document.removeObject(sketch.Name)
    refused(document, engraving, "'Sketch' that it followed was deleted")


def test_heights_that_do_not_fit_are_refused_by_the_job(document: Any) -> None:
    job = new_job(document)
    api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    api.edit(job, clearance_mm=1)
    refused(document, job, "clearance_mm")


def test_an_unknown_machine_is_refused(document: Any) -> None:
    job = new_job(document)
    api.add_elliptical_pocket(job, depth_mm=2)
    api.edit(job, machine="nonesuch")
    refused(document, job, "nonesuch")


def test_what_a_script_takes_out_of_the_document(document: Any, tmp_path: Path) -> None:
    job = new_job(document, units="inch", work_offset="G55", stock_size_mm=(120, 80, 15))
    pocket = api.add_elliptical_pocket(job, sketched_ellipse(document), depth_mm=2)
    document.recompute()
    api.save_program(job, tmp_path / "program.nc")
    assert (tmp_path / "program.nc").read_bytes() == api.program_text(job).encode("ascii")
    assert {"G20", "G55"} <= set(api.program_text(job).split())
    model = api.job_model(job)
    assert (model.units, model.work_offset, model.stock.size_mm) == ("inch", "G55", (120, 80, 15))
    assert model.operation[0].radius_x_mm == pytest.approx(40)
    api.edit(pocket, depth_mm=-1)
    document.recompute()
    with pytest.raises(JobError):
        api.require_valid(job)
    with pytest.raises(JobError):
        api.save_program(job, tmp_path / "other.nc")
    assert not (tmp_path / "other.nc").exists()


def test_a_job_without_operations_says_so(document: Any) -> None:
    job = new_job(document)
    document.recompute()
    assert problem_of(job) == ""
    with pytest.raises(JobError, match="no operations"):
        api.program_text(job)


def test_an_inactive_operation_is_left_out(document: Any) -> None:
    job = new_job(document)
    api.add_elliptical_pocket(job, depth_mm=2)
    deeper = api.add_elliptical_pocket(job, depth_mm=5)
    document.recompute()
    assert reach_mm(api.program_text(job))[2] == pytest.approx(-5)
    api.edit(deeper, active=False)
    document.recompute()
    assert reach_mm(api.program_text(job))[2] == pytest.approx(-2)


def test_a_deleted_operation_is_cut_no_more(document: Any) -> None:
    job = new_job(document)
    api.add_elliptical_pocket(job, depth_mm=2)
    deeper = api.add_elliptical_pocket(job, depth_mm=5)
    document.recompute()
    document.removeObject(deeper.Name)
    document.recompute()
    assert reach_mm(api.program_text(job))[2] == pytest.approx(-2)


def test_an_undone_edit_is_undone_in_the_program(document: Any) -> None:
    document.UndoMode = 1
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    before = api.program_text(job)
    document.openTransaction("edit")
    api.edit(pocket, depth_mm=5)
    document.recompute()
    document.commitTransaction()
    assert api.program_text(job) != before
    document.undo()
    document.recompute()
    assert api.program_text(job) == before


@pytest.mark.parametrize(
    "change", [{"depth_mm": "deep"}, {"depth_mm": math.nan}, {"nonesuch": 1}, {"entry": "jump"}, {"centre_mm": (1,)}]
)
def test_a_value_that_cannot_be_set_changes_nothing(document: Any, change: dict[str, Any]) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    good = api.program_text(job)
    with pytest.raises(JobError):
        api.edit(pocket, radius_x_mm=30, **change)
    document.recompute()
    assert api.program_text(job) == good
    count = len(document.Objects)
    with pytest.raises(JobError):
        api.add_elliptical_pocket(job, **change)
    assert len(document.Objects) == count


def test_the_program_survives_save_and_reopen_byte_for_byte(document: Any, reopened: Any) -> None:
    sketch = sketched_ellipse(document)
    job = new_job(document)
    api.add_elliptical_pocket(job, sketch, depth_mm=2)
    document.recompute()
    text, name = api.program_text(job), job.Name
    again = reopened(document)
    job = again.getObject(name)
    assert api.program_text(job) == text
    assert Path(job.Program).read_bytes() == text.encode("ascii")
    assert {proxy_type(obj) for obj in again.Objects} >= {
        "CNCStepper_Job",
        "CNCStepper_Tool",
        "CNCStepper_EllipticalPocket",
        "CNCStepper_Preview",
    }
    assert type(job.Proxy).__module__ == "CNCStepper.workbench.features.job"
    again.getObject("Sketch").Placement.Base = Vector(3, 0, 0)
    again.recompute()
    assert reach_mm(api.program_text(job))[0] == pytest.approx(40, abs=0.011)


def test_a_failed_document_is_saved_and_mended_after_reopening(document: Any, reopened: Any) -> None:
    job = new_job(document)
    pocket = api.add_elliptical_pocket(job, depth_mm=-2)
    refused(document, pocket, "depth")
    names = job.Name, pocket.Name
    again = reopened(document)
    job, pocket = (again.getObject(name) for name in names)
    with pytest.raises(JobError):
        api.program_text(job)
    assert pocket.Depth.Value == -2
    api.edit(pocket, depth_mm=2)
    again.recompute()
    assert reach_mm(api.program_text(job))[2] == pytest.approx(-2)


def test_the_preview_shows_the_program_at_the_work_zero(document: Any) -> None:
    job = new_job(document, work_origin_mm=(10, 20, 30))
    api.add_elliptical_pocket(job, sketched_ellipse(document), depth_mm=2)
    document.recompute()
    (preview,) = [obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_Preview"]
    assert preview.isDerivedFrom("Path::Feature")
    assert tuple(preview.Placement.Base) == (10, 20, 30)
    names = {command.Name for command in preview.Path.Commands}
    assert names & {"G2", "G3"}
    assert preview.Path.Size == len(interpret(api.program_text(job), Start()))
    assert min(c.Parameters.get("Z", 0) for c in preview.Path.Commands) == pytest.approx(-2)


def test_a_long_program_s_preview_is_thinned(document: Any) -> None:
    job = new_job(document)
    document.recompute()
    (preview,) = [obj for obj in document.Objects if proxy_type(obj) == "CNCStepper_Preview"]
    lines = [f"G1 X{number % 100} Y{number // 100} F800" for number in range(25_000)]
    program_file.store(job, "\n".join(["G21 G90", *lines, "M2", ""]))
    preview.touch()
    document.recompute()
    assert preview.Path.Size == 20_000
    assert preview.Path.Commands[-1].Parameters["Y"] == 249


def test_a_contour_that_cannot_be_made_stains_no_other_operation(document: Any) -> None:
    job = api.new_job(document, stock_size_mm=(100, 80, 10))
    api.add_tool(job, diameter_mm=2)
    flange = api.add_shape(document, "flange", outer_diameter_mm=40, holes=5)
    disc = api.add_shape(document, "circle")
    pocket = api.add_operation(job, "pocket", disc, depth_mm=1, stepover_mm=1)
    contour = api.add_operation(job, "contour", flange, depth_mm=1)
    document.recompute()
    assert problem_of(pocket) == "" and "flange" in problem_of(contour)
