# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clamps, the stock's form and its edge in a document: what a person draws is what the check is given."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import FreeCAD
import pytest
import shapely
from FreeCAD import Rotation, Vector

from CNCStepper.errors import JobError
from CNCStepper.job.model import Job as Model
from CNCStepper.simulation.check_context import CheckContext
from CNCStepper.simulation.checks.clamps import clamps, sheet_edge
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Cylinder
from CNCStepper.workbench import api
from CNCStepper.workbench.document.core_job import read_back
from CNCStepper.workbench.document.machine_of_job import machine_of
from CNCStepper.workbench.features.base import problem_of

DATA = Path(__file__).parent / "data"


def new_job(document: Any, **values: Any) -> Any:
    """Return a job of a pocket of 80 x 50 mm, 2 mm deep, in the middle of its stock."""
    job = api.new_job(document, **values)
    api.add_tool(job, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000)
    api.add_elliptical_pocket(job, radius_x_mm=40, radius_y_mm=25, depth_mm=2, stepdown_mm=2)
    return job


def block(document: Any, at: tuple[float, float, float], size: tuple[float, float, float] = (20, 10, 15)) -> Any:
    box = document.addObject("Part::Box", "Clamp")
    box.Length, box.Width, box.Height = size
    box.Placement.Base = Vector(*at)
    return box


def model(job: Any) -> Model:
    job.Document.recompute()
    return api.job_model(job)


def findings(job: Any) -> list[Finding]:
    """Return what the core's checks of clamps and edge find in the job's program."""
    checked = model(job)
    subject = CheckContext.of(read_back(job, api.program_text(job)), machine_of(job), job.Label)
    found = list(clamps(subject, checked.tools, checked.clamps))
    edge_mm = checked.stock.edge_mm
    return found + ([] if edge_mm is None else list(sheet_edge(subject, checked.tools, checked.stock.stock(), edge_mm)))


def test_a_box_is_a_clamp_in_work_coordinates(document: Any) -> None:
    job = new_job(document, work_origin_mm=(5, 6, 7))
    api.edit(job, clamps=[block(document, (45, -4, 0))])
    (clamp,) = model(job).clamps
    assert clamp.outline.equals(shapely.box(40, -10, 60, 0)) and clamp.top_mm == 8


def test_a_moved_clamp_is_found_and_named(document: Any) -> None:
    job = new_job(document)
    beside, way_off = block(document, (60, -5, -5)), block(document, (60, 30, -5))
    api.edit(job, clamps=[way_off, beside])
    assert findings(job) == []
    text = api.program_text(job)
    beside.Placement.Base = Vector(30, -5, -5)
    with pytest.raises(JobError, match="has changed since"):
        api.program_text(job)
    (finding,) = findings(job)
    assert (finding.severity, finding.text) == ("error", "the tool goes into clamp 2")
    assert api.program_text(job) == text


def test_a_turned_clamp_is_enclosed_exactly(document: Any) -> None:
    job = new_job(document)
    turned = block(document, (60, 0, -5))
    turned.Placement.Rotation = Rotation(Vector(0, 0, 1), 30)
    tilted = block(document, (-90, 0, 0))
    tilted.Placement.Rotation = Rotation(Vector(1, 0, 0), 45)
    api.edit(job, clamps=[turned, tilted])
    flat, steep = model(job).clamps
    assert flat.outline.area == pytest.approx(200) and flat.top_mm == 10
    assert steep.outline.bounds == pytest.approx((-90, -15 / math.sqrt(2), -70, 10 / math.sqrt(2)))
    assert steep.top_mm == pytest.approx(25 / math.sqrt(2))


def test_a_round_clamp_lies_within_its_outline(document: Any) -> None:
    screw = document.addObject("Part::Cylinder", "Screw")
    screw.Radius, screw.Height = 10, 8
    screw.Placement.Base = Vector(70, 0, -3)
    job = new_job(document)
    api.edit(job, clamps=[screw])
    (clamp,) = model(job).clamps
    assert clamp.outline.contains(shapely.Point(70, 0).buffer(10, quad_segs=256))
    assert clamp.outline.area == pytest.approx(math.pi * 100, rel=0.05)
    assert 5 <= clamp.top_mm <= 5.1


def test_a_clamp_moves_with_the_part_that_holds_it(document: Any) -> None:
    fixture = document.addObject("App::Part", "Fixture")
    clamp = block(document, (60, -5, -5))
    fixture.addObject(clamp)
    job = new_job(document)
    api.edit(job, clamps=[clamp])
    assert findings(job) == []
    fixture.Placement.Base = Vector(-30, 0, 0)
    document.recompute()
    assert [finding.code for finding in findings(job)] == ["clamp"]


def test_what_is_no_solid_is_refused_and_named(document: Any) -> None:
    job = new_job(document)
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    api.edit(job, clamps=[sketch])
    document.recompute()
    assert "Sketch" in problem_of(job) and "no solid" in problem_of(job)
    with pytest.raises(JobError):
        api.program_text(job)
    api.edit(job, clamps=[])
    document.recompute()
    assert problem_of(job) == "" and api.program_text(job)


def test_a_deleted_clamp_is_a_clamp_no_more(document: Any) -> None:
    job = new_job(document)
    clamp = block(document, (30, -5, -5))
    api.edit(job, clamps=[clamp])
    assert findings(job)
    document.removeObject(clamp.Name)
    assert findings(job) == []


def test_an_undone_clamp_is_undone_in_one_step(document: Any) -> None:
    document.UndoMode = 1
    job = new_job(document)
    clamp = block(document, (30, -5, -5))
    document.recompute()
    document.openTransaction("clamp")
    api.edit(job, clamps=[clamp], edge_mm=3)
    document.recompute()
    document.commitTransaction()
    document.undo()
    document.recompute()
    assert model(job).clamp == () and model(job).stock.edge_mm is None


def test_the_edge_margin_is_judged(document: Any) -> None:
    job = new_job(document)
    assert model(job).stock.edge_mm is None and findings(job) == []
    api.edit(job, edge_mm=10)
    assert findings(job) == []
    api.edit(job, edge_mm=10.1)
    (finding,) = findings(job)
    assert (finding.code, finding.limit) == ("sheet-edge", 10.1) and finding.value == pytest.approx(10, abs=0.02)
    api.edit(job, edge_mm=-1)
    document.recompute()
    assert "edge_mm" in problem_of(job)


def test_every_form_of_stock(document: Any) -> None:
    job = new_job(document)
    assert (model(job).stock.form, model(job).stock.size_mm) == ("box", (100, 70, 20))
    api.edit(job, stock_form="sheet", stock_size_mm=(300, 200, 3))
    assert (model(job).stock.form, model(job).stock.size_mm) == ("sheet", (300, 200, 3))
    api.edit(job, stock_form="cylinder", stock_size_mm=(120, 70, 10))
    stock = model(job).stock.stock()
    assert isinstance(stock, Cylinder) and stock.size_mm == (120, 120, 10)
    assert tuple(job.StockSize) == (120, 70, 10)  # the width of the next box
    with pytest.raises(JobError, match="stock_form cannot be 'ball'"):
        api.edit(job, stock_form="ball")


def test_clamps_survive_save_and_reopen(document: Any, tmp_path: Path) -> None:
    job = new_job(document)
    api.edit(job, clamps=[block(document, (30, -5, -5))], edge_mm=2, stock_form="sheet")
    before, name = model(job), job.Name
    path = str(tmp_path / "fixação ç.FCStd")
    document.saveAs(path)
    FreeCAD.closeDocument(document.Name)
    job = FreeCAD.openDocument(path).getObject(name)
    assert api.job_model(job) == before and len(job.Clamps) == 1 and api.program_text(job)


def test_a_document_of_an_older_version_gets_them(document: Any, tmp_path: Path) -> None:
    copy = tmp_path / "first-release.FCStd"
    copy.write_bytes((DATA / "first-release.FCStd").read_bytes())
    opened = FreeCAD.openDocument(str(copy))
    job = opened.getObject("CNCStepper_Job")
    assert (job.StockForm, job.EdgeMargin.Value, job.Clamps, list(job.ClampOutlines)) == ("box", 0, [], [])
    opened.recompute()
    before = api.program_text(job)
    api.edit(job, clamps=[block(opened, (0, 0, -5))], stock_form="cylinder", edge_mm=1)
    assert len(model(job).clamps) == 1 and model(job).stock.form == "cylinder"
    assert api.program_text(job) == before
