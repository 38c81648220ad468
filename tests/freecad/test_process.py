# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs by torch, laser and wire: process and chart in the job, own values, their operations, tools made from it."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest
from FreeCAD import Vector

from CNCStepper.errors import JobError
from CNCStepper.job.make import make_program
from CNCStepper.job.prove import prove_job
from CNCStepper.machine.cut_charts import cut_data_for, shipped_chart, write_chart
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench import api
from CNCStepper.workbench.document.core_job import job_of, machine_of
from CNCStepper.workbench.document.cut_chart_of_job import best_material, cut_data_of, keys_that_count
from CNCStepper.workbench.features.base import edit, problem_of, value_of
from CNCStepper.workbench.features.catalogue import KINDS
from CNCStepper.workbench.features.cut_values import CUT_VALUES
from CNCStepper.workbench.features.cycle_operation import drawings_of
from CNCStepper.workbench.features.sheet_cut import SheetCut
from CNCStepper.workbench.features.tool import model_of
from CNCStepper.workbench.services.choice_labels import PROCESS_WORDS, WORDS

TORCH = {"machine": "torch-table", "process": "plasma", "material": "mild-steel", "stock_size_mm": (200, 150, 3)}
LASER = {"machine": "laser-table", "process": "laser", "material": "plywood", "stock_size_mm": (200, 150, 3)}
WIRE = {"machine": "wire-table", "process": "hot-wire", "material": "eps", "stock_size_mm": (200, 150, 20)}
JOBS = {"plasma": (TORCH, "sheet_cut"), "laser": (LASER, "sheet_cut"), "hot-wire": (WIRE, "wire_cut")}


def sketch(document: Any, *shapes: Any) -> Any:
    made = document.addObject("Sketcher::SketchObject", "Sketch")
    for shape in shapes:
        made.addGeometry(shape, False)
    document.recompute()
    return made


def rectangle(half_x: float, half_y: float) -> list[Any]:
    corners = [(-half_x, -half_y), (half_x, -half_y), (half_x, half_y), (-half_x, half_y), (-half_x, -half_y)]
    return [Part.LineSegment(Vector(*a, 0), Vector(*b, 0)) for a, b in pairwise(corners)]


def cut(document: Any, values: dict[str, Any], cycle: str, *more: Any, **parameters: Any) -> tuple[Any, Any]:
    """Return a job and its one operation: a rectangle of 100 × 60, and what is drawn besides."""
    job = api.new_job(document, stock_form="sheet", **values)
    operation = api.add_operation(job, cycle, sketch(document, *rectangle(50, 30), *more), **parameters)
    document.recompute()
    return job, operation


@pytest.mark.parametrize("process", JOBS)
def test_a_drawing_becomes_a_program_without_feeds_or_tools(document: Any, process: str) -> None:
    values, cycle = JOBS[process]
    job, operation = cut(document, values, cycle)
    assert [problem_of(each) for each in (job.Tools[0], operation, job)] == ["", "", ""]
    row = cut_data_for(process, values["material"], values["stock_size_mm"][2])
    tool = model_of(job.Tools[0])
    assert (tool.shape, tool.diameter_mm, tool.feed_mm_min) == (
        PROCESSES[process].shapes[0],
        row.kerf_mm,
        row.feed_mm_min,
    )
    assert (job.Tools[0].ToolShape, job.Tools[0].Diameter.Value) == (tool.shape, pytest.approx(tool.diameter_mm))
    assert operation.Parts == 1
    core, machine = job_of(job), machine_of(job)
    assert make_program(core, machine, job.Label).program == api.program_text(job)
    proof = prove_job(core, machine, api.program_text(job))
    assert [finding.code for finding in proof.findings if finding.severity == "error"] == []


def test_holes_are_cut_before_the_outline(document: Any) -> None:
    job, operation = cut(document, TORCH, "sheet_cut", Part.Circle(Vector(0, 0, 0), Vector(0, 0, 1), 15))
    assert (operation.Parts, operation.Pierces) == (1, 2), problem_of(operation)
    assert api.program_text(job).count("M3 S") == 2


def test_an_own_value_wins_over_the_chart_and_0_takes_it_again(document: Any) -> None:
    job, _ = cut(document, TORCH, "sheet_cut")
    row, before = cut_data_of(job), api.program_text(job)
    edit(job, feed_mm_min=1234, kerf_mm=2.5, pierce_delay_s=0.7, cut_height_mm=2.25)
    document.recompute()
    text = api.program_text(job)
    assert "F1234" in text and "P0.7" in text and "Z2.25" in text, text
    assert job.Tools[0].Diameter.Value == pytest.approx(2.5)
    own = cut_data_of(job)
    assert (own.feed_mm_min, own.kerf_mm, own.amperes) == (1234, 2.5, row.amperes)
    edit(job, feed_mm_min=0, kerf_mm=0, pierce_delay_s=0, cut_height_mm=0)
    document.recompute()
    assert cut_data_of(job) == row and api.program_text(job) == before


def test_an_own_feed_of_a_wire_has_the_kerf_of_the_chart_at_it(document: Any) -> None:
    job, operation = cut(document, WIRE, "wire_cut")
    row = cut_data_of(job)
    assert row.kerf_by_feed, "the chart of the hot wire has no kerfs by feed: this test shows nothing"
    feed_mm_min = row.kerf_by_feed[-1][0]
    edit(job, feed_mm_min=feed_mm_min)
    document.recompute()
    assert problem_of(operation) == ""
    assert operation.KerfUsed.Value == pytest.approx(row.kerf_at(feed_mm_min)) != pytest.approx(row.kerf_mm)


def test_own_values_stay_in_the_document(document: Any, tmp_path: Path) -> None:
    job, _ = cut(document, TORCH, "sheet_cut")
    edit(job, feed_mm_min=1500)
    document.recompute()
    text, name = api.program_text(job), job.Name
    document.saveAs(str(tmp_path / "cut.FCStd"))
    FreeCAD.closeDocument(document.Name)
    job = FreeCAD.openDocument(str(tmp_path / "cut.FCStd")).getObject(name)
    assert value_of(job, next(entry for entry in CUT_VALUES if entry.key == "feed_mm_min")) == 1500
    assert "Hidden" in job.getEditorMode("Coolant") and "Hidden" not in job.getEditorMode("CutFeed")
    for obj in job.Document.Objects:
        obj.touch()
    job.Document.recompute()
    assert api.program_text(job) == text


def test_a_chart_of_the_shop_is_found_beside_the_document(document: Any, tmp_path: Path) -> None:
    rows = [row.model_copy(update={"feed_mm_min": 777.0}) for row in shipped_chart("plasma")]
    write_chart(tmp_path / "ours.toml", rows)
    document.saveAs(str(tmp_path / "cut.FCStd"))
    job, _ = cut(document, {**TORCH, "chart": "ours.toml"}, "sheet_cut")
    assert "F777" in api.program_text(job)
    edit(job, chart="missing.toml")
    document.recompute()
    assert "no such file" in problem_of(job.Tools[0])


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"stock_size_mm": (200, 150, 400)}, "400 mm"),
        ({"material": "cheese"}, "cheese"),
        ({"consumable": "999A"}, "999A"),
        ({"material": ""}, "material"),
        ({"kerf_mm": -1}, "kerf_mm"),
    ],
)
def test_what_the_chart_does_not_have_is_named(document: Any, changes: dict[str, Any], named: str) -> None:
    job, _ = cut(document, TORCH, "sheet_cut")
    edit(job, **changes)
    document.recompute()
    assert named in problem_of(job.Tools[0])
    with pytest.raises(JobError):
        api.program_text(job)


def test_the_machine_must_name_the_process(document: Any) -> None:
    with pytest.raises(JobError) as refusal:
        api.new_job(document, machine="torch-table", process="laser", material="plywood")
    assert refusal.value.code == "process-machine" and "plasma" in refusal.value.sentence
    with pytest.raises(JobError):
        api.new_job(document, machine="torch-table")


def test_an_operation_of_another_process_says_so(document: Any) -> None:
    job, operation = cut(document, TORCH, "sheet_cut")
    pocket = api.add_operation(job, "circular_pocket", radius_mm=10, depth_mm=1)
    document.recompute()
    assert problem_of(operation) == "" and "plasma" in problem_of(pocket)
    edit(job, machine="table-a", process="milling")
    document.recompute()
    assert "milling" in problem_of(operation)
    assert set(SheetCut.BY) & {"milling", "hot-wire"} == set()
    assert {process for kind in KINDS for process in kind.BY} == set(PROCESSES)


@pytest.mark.parametrize(
    ("values", "shown", "hidden"),
    [
        (TORCH, {"Clearance", "Retract", "CutHeight", "PierceHeight", "Amperes"}, {"Coolant", "Power", "Preheat"}),
        (LASER, {"Power", "PierceDelay", "Kerf"}, {"Clearance", "Retract", "CutHeight", "Amperes", "Coolant"}),
        (WIRE, {"CutFeed", "Kerf", "Power"}, {"Clearance", "Retract", "PierceHeight", "Amperes", "Coolant"}),
        ({}, {"Clearance", "Retract", "Coolant"}, {"CutFeed", "Kerf", "Consumable", "Chart", "Power", "Amperes"}),
    ],
    ids=["torch", "laser", "wire", "milling"],
)
def test_a_job_shows_only_what_its_process_has(
    document: Any, values: dict[str, Any], shown: set[str], hidden: set[str]
) -> None:
    job = api.new_job(document, **values)
    modes = {name: "Hidden" in job.getEditorMode(name) for name in shown | hidden}
    assert {name for name, is_hidden in modes.items() if is_hidden} == hidden
    assert keys_that_count(job)


def test_a_sheet_cut_shows_only_what_its_process_has(document: Any) -> None:
    job, operation = cut(document, TORCH, "sheet_cut")

    def seen(name: str) -> bool:
        return "Hidden" not in operation.getEditorMode(name)

    assert seen("PierceDelay") and not seen("DynamicPower") and not seen("BladeOffset") and not seen("ArcsRadius")
    edit(operation, arcs_by="own", arcs_radius_mm=4)
    document.recompute()
    assert seen("ArcsRadius") and problem_of(operation) == ""
    edit(job, **LASER)
    document.recompute()
    assert problem_of(operation) == "" and seen("DynamicPower")
    edit(operation, dynamic_power=True)
    document.recompute()
    assert "M4" in api.program_text(job)


def test_the_tool_of_the_chart_follows_the_process(document: Any) -> None:
    job, _ = cut(document, TORCH, "sheet_cut")
    tool = job.Tools[0]
    assert "ReadOnly" in tool.getEditorMode("Diameter")
    edit(job, **WIRE)
    document.recompute()
    assert tool.ToolShape == "wire" and problem_of(tool) == ""
    edit(tool, from_chart=False, diameter_mm=1.5)
    document.recompute()
    assert "ReadOnly" not in tool.getEditorMode("Diameter") and model_of(tool).diameter_mm == 1.5


def test_a_material_is_chosen_that_the_chart_covers() -> None:
    rows = shipped_chart("plasma")
    assert best_material(rows, 3.0, "mild-steel") == "mild-steel"
    chosen = best_material(rows, 3.0, "plywood")
    assert cut_data_for("plasma", chosen, 3.0).material == chosen


def test_processes_and_materials_have_words() -> None:
    assert set(PROCESS_WORDS) == set(PROCESSES)
    charted = {row.material for name, one in PROCESSES.items() if one.uses_chart for row in shipped_chart(name)}
    assert charted - set(WORDS) == set()


def test_marks_come_before_the_cut_and_are_kept_with_the_document(document: Any) -> None:
    job, operation = cut(document, LASER, "sheet_cut")
    line = sketch(document, Part.LineSegment(Vector(-20, 0, 0), Vector(20, 0, 0)))
    edit(operation, mark_drawings=[line], mark_power=50, mark_feed_mm_min=700)
    document.recompute()
    assert problem_of(operation) == problem_of(job) == ""
    text = api.program_text(job)
    assert 0 < text.index("X20") < text.index("X50") and "F700" in text and "S50" in text
    document.openTransaction("move the mark")
    line.Placement.Base.y = 5
    document.recompute()
    assert api.program_text(job) != text and "Y5" in api.program_text(job)
    edit(job, **TORCH)  # a torch has one power: what it cannot do counts no more
    document.recompute()
    assert problem_of(operation) == "" and "Hidden" in operation.getEditorMode("MarkDrawings")


def test_a_mark_that_is_deleted_is_told_and_not_left_out(document: Any) -> None:
    _, operation = cut(document, LASER, "sheet_cut")
    line = sketch(document, Part.LineSegment(Vector(-20, 0, 0), Vector(20, 0, 0)))
    edit(operation, mark_drawings=[line])
    document.recompute()
    label = line.Label
    document.removeObject(line.Name)
    document.recompute()
    assert f"'{label}'" in problem_of(operation)
    edit(operation, mark_drawings=[])
    document.recompute()
    assert f"'{label}'" in problem_of(operation)  # until somebody says what is cut now
    edit(operation, drawings=drawings_of(operation))
    document.recompute()
    assert problem_of(operation) == ""
