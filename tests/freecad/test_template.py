# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template and an imported drawing: the job's program is that of the command line, and it follows the drawing."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest

from CNCStepper.errors import CNCStepperError, JobError
from CNCStepper.job.cut_transfer import program_texts
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import read_template
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.profile import load_machine
from CNCStepper.workbench import api
from CNCStepper.workbench.document.job_files import export_job, open_job
from CNCStepper.workbench.document.template_jobs import apply_template, new_template
from CNCStepper.workbench.features.base import problem_of, proxy_type, values
from CNCStepper.workbench.templates.around import Around
from CNCStepper.workbench.templates.draft import texts_of
from CNCStepper.workbench.templates.job_template import KEYS, JobBeginning, save

ROOT = Path(__file__).parents[2]
DRAWINGS, TEMPLATES = ROOT / "examples" / "drawings", ROOT / "examples" / "templates"
SIGN = DRAWINGS / "sign.svg"
RULES = """
machine = "table-a"
clearance_mm = 10
retract_mm = 2
[stock]
thickness_mm = 6
origin = "top-centre"
[[tool]]
number = 3
shape = "flat"
diameter_mm = 3
flutes = 2
feed_mm_min = 600
plunge_mm_min = 200
spindle_rpm = 10000
[[rule]]
title = "furos"
layer = "holes"
operation = { cycle = "bore", tool = 3, depth_mm = "through", pitch_mm = 1 }
[[rule]]
title = "pockets"
layer = "area"
operation = { cycle = "pocket", tool = 3, depth_mm = 2, stepdown_mm = 1, stepover_mm = 1.2, offset_mm = [0.25, 0] }
[[rule]]
title = "borda"
operation = { cycle = "contour", tool = 3, side = "outside", depth_mm = "through", stepdown_mm = 2 }
"""
PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60">
<g id="cut" fill="none" stroke="#ff0000"><path id="edge" d="M5 5 H90 A8 8 0 0 1 95 13.3 V55 H5 Z"/></g>
<g id="area" fill="none" stroke="#000000"><rect id="outer" x="40" y="10" width="40" height="40"/>
<circle id="island" cx="60" cy="30" r="12.3"/><circle id="inner" cx="60" cy="30" r="6"/></g>
<g id="holes" fill="none" stroke="#0000ff"><circle id="first" cx="20" cy="20" r="4"/>
<circle id="second" cx="20" cy="40.123" r="4"/></g></svg>"""


def program_of_command_line(drawing: Path, template: Path, title: str) -> str:
    job = job_of_drawing(read_template(template), drawing, drawing.with_suffix(".toml")).job
    machine = load_machine(job.machine)
    ((_, text),) = program_texts(job.on(machine), machine, title)
    return text


def plate(folder: Path) -> tuple[Path, Path]:
    drawing, template = folder / "chapa ç.svg", folder / "loja.toml"
    drawing.write_text(PLATE, "utf-8")
    template.write_text(RULES, "utf-8")
    return drawing, template


@pytest.mark.parametrize("split", ["chain", "layer"])
@pytest.mark.parametrize("name", ["sign", "laser"])
def test_a_template_makes_the_program_of_the_command_line(document: Any, split: str, name: str, tmp_path: Path) -> None:
    path = Path(shutil.copy(SIGN, tmp_path / "sign.svg"))
    drawing = api.import_drawing(document, path, split=split)
    job = apply_template(drawing, TEMPLATES / f"{name}.toml")
    document.recompute()
    assert not any(map(problem_of, (*job.Tools, *job.Operations, job)))
    assert api.program_text(job) == program_of_command_line(path, TEMPLATES / f"{name}.toml", job.Label)


def test_islands_holes_and_another_zero(document: Any, tmp_path: Path) -> None:
    path, template = plate(tmp_path)
    drawing = api.import_drawing(document, path)
    job = apply_template(drawing, template)
    document.recompute()
    assert [each.Label for each in job.Operations] == ["furos", "pockets", "pockets in islands 1", "borda"]
    assert not any(map(problem_of, (*job.Tools, *job.Operations, job)))
    assert api.program_text(job) == program_of_command_line(path, template, job.Label)
    export_job(job, tmp_path / "out.toml")
    again, _ = open_job(document, tmp_path / "out.toml")
    document.recompute()
    assert api.program_text(again) == program_of_command_line(path, template, again.Label)


def test_the_operations_follow_the_drawing_s_own_objects(document: Any, tmp_path: Path) -> None:
    path, template = plate(tmp_path)
    drawing = api.import_drawing(document, path)
    job = apply_template(drawing, template)
    held = {each.ChainName for operation in (job.Operations[0], job.Operations[3]) for each, _ in operation.Drawings}
    assert held == {"first", "second", "edge"}
    path.write_text(PLATE.replace('r="4"', 'r="5"'), "utf-8")
    api.reload_drawing(drawing)
    document.recompute()
    assert api.program_text(job) == program_of_command_line(path, template, job.Label)


def test_a_job_that_is_there_gets_other_operations_and_tools(document: Any, tmp_path: Path) -> None:
    path, template = plate(tmp_path)
    drawing = api.import_drawing(document, path)
    job = api.new_job(document)
    api.add_tool(job)
    api.add_elliptical_pocket(job, depth_mm=2)
    assert apply_template(drawing, template, job) == job
    document.recompute()
    assert len([each for each in document.Objects if proxy_type(each) == "CNCStepper_Tool"]) == 1
    assert api.program_text(job) == program_of_command_line(path, template, job.Label)


def test_a_refusal_leaves_the_document_as_it_was(document: Any, tmp_path: Path) -> None:
    path, template = plate(tmp_path)
    drawing = api.import_drawing(document, path)
    before = [each.Name for each in document.Objects]
    template.write_text(
        RULES.replace('layer = "area"', 'layer = "none"').replace('side = "outside"', 'side = "x"'), "utf-8"
    )
    with pytest.raises(JobError, match="side"):
        apply_template(drawing, template)
    assert [each.Name for each in document.Objects] == before


def test_a_new_template_has_the_job_s_tools_and_a_rule_for_each_layer(document: Any, tmp_path: Path) -> None:
    path, template = plate(tmp_path)
    drawing = api.import_drawing(document, path, tolerance_mm=0.01)
    job = apply_template(drawing, template)
    content = new_template(drawing, job)
    assert [texts_of(rule).layer for rule in content["rule"]] == ["cut", "area", "holes"]
    assert content["tool"][0]["number"] == 3 and content["machine"] == read_toml(template)["machine"]
    assert content["drawing"]["tolerance_mm"] == 0.01 and content["stock"]["thickness_mm"] == 6


def plywood_job(document: Any) -> Any:
    """Return a job that cuts a rectangle of 40 by 20 mm out of stock that reaches 7 mm beyond it."""
    plate = document.addObject("Part::Feature", "Plate")
    plate.Shape = Part.Wire(Part.makePolygon([(0, 0, 0), (40, 0, 0), (40, 20, 0), (0, 20, 0), (0, 0, 0)]))
    stock = {"stock_form": "sheet", "stock_size_mm": (54, 34, 9), "stock_origin": "top-left-front", "edge_mm": 3}
    keys = {"machine": "table-b", "material": "plywood", "units": "inch", "work_offset": "G55", "clearance_mm": 12}
    job = api.new_job(document, **stock, **keys, work_origin_mm=(-7, -7, 0))
    api.add_tool(job, number=4, shape="v", diameter_mm=6, tip_angle_deg=60, feed_mm_min=800, spindle_rpm=0)
    api.add_tool(job, number=7, diameter_mm=3, feed_mm_min=0, plunge_mm_min=0, spindle_rpm=0)
    api.add_operation(job, "contour", plate, depth_mm=9, stepdown_mm=3)
    document.recompute()
    return job


def begun(document: Any, around: Around = Around()) -> tuple[Any, JobBeginning]:  # noqa: B008
    job = api.new_job(document)
    api.add_tool(job)
    return job, JobBeginning(job, around)


def state(job: Any) -> tuple[dict[str, Any], list[dict[str, Any]]]:
    return {key: values(job)[key] for key in KEYS}, [values(tool) for tool in job.Tools]


def test_a_new_job_begins_with_a_saved_one_round_another_drawing(document: Any, tmp_path: Path) -> None:
    saved, path = plywood_job(document), tmp_path / "chapa ç.toml"
    save(saved, path)
    wanted, tools = state(saved)
    assert read_template(path).stock.margin_mm == 7
    for box, is_solid, size_mm, zero_mm in (
        (FreeCAD.BoundBox(10, 20, 0, 110, 80, 0), False, (114, 74, 9), (3, 13, 0)),
        (FreeCAD.BoundBox(10, 20, -5, 110, 80, 1), True, (100, 60, 6), (10, 20, 1)),
        (None, False, (100, 70, 9), (0, 0, 0)),
    ):
        job, beginning = begun(document, Around(box, is_solid))
        beginning.take(str(path))
        form = {"stock_form": "box"} if is_solid else {}
        place = {"stock_size_mm": size_mm, "work_origin_mm": zero_mm, **form}
        assert state(job) == (wanted | place, tools)
        document.recompute()
        assert not any(map(problem_of, (job, *job.Tools)))


def test_stock_of_a_size_of_its_own_keeps_it(document: Any, tmp_path: Path) -> None:
    job, path = plywood_job(document), tmp_path / "disco.toml"
    api.edit(job, stock_form="cylinder", stock_size_mm=(90, 34, 12), stock_origin="top-centre")
    save(job, path)
    other, beginning = begun(document, Around(FreeCAD.BoundBox(10, 20, 0, 30, 60, 0)))
    beginning.take(str(path))
    found, _ = state(other)
    assert (found["stock_form"], found["stock_size_mm"]) == ("cylinder", (90, 90, 12))
    assert found["work_origin_mm"] == (20, 40, 0)


def test_what_a_person_typed_stays_through_every_beginning(document: Any, tmp_path: Path) -> None:
    path = tmp_path / "chapa.toml"
    save(plywood_job(document), path)
    job, beginning = begun(document)
    usual = state(job)
    beginning.take(str(path))
    beginning.take("")
    assert state(job) == usual
    api.edit(job, material="mdf", retract_mm=5)
    api.edit(job.Tools[0], diameter_mm=5)
    beginning.take(str(path))
    assert (job.Material, float(job.Retract), job.Machine) == ("mdf", 5, "table-b")
    assert (float(job.Tools[0].Diameter), float(job.Tools[0].Feed)) == (5, 0)
    assert [tool.Number for tool in job.Tools] == [1, 4, 7]
    beginning.take("")
    assert (job.Material, float(job.Retract), job.Machine) == ("mdf", 5, "table-a")
    assert [tool.Number for tool in job.Tools] == [1]


@pytest.mark.parametrize(
    ("old", "new", "why"),
    [
        ("[stock]", "[stock", "toml"),
        ('"table-b"', '"no-such"', "no-such"),
        ('"table-b"', '"wire-table"', "milling"),
        ('machine = "table-b"', 'machine = "mini-lathe"\nprocess = "turning"', "lathe"),
        ("thickness_mm = 9", "thickness_mm = -9", "thickness_mm"),
        ("number = 7", "number = 4", "number"),
    ],
)
def test_a_template_that_cannot_be_used_changes_nothing(
    document: Any, tmp_path: Path, old: str, new: str, why: str
) -> None:
    path = tmp_path / "chapa.toml"
    save(plywood_job(document), path)
    text = path.read_text("utf-8")
    assert old in text.replace("9.0", "9")
    path.write_text(text.replace("9.0", "9").replace(old, new), "utf-8")
    job, beginning = begun(document)
    before, names = state(job), [each.Name for each in document.Objects]
    with pytest.raises(CNCStepperError, match=why):
        beginning.take(str(path))
    assert (state(job), [each.Name for each in document.Objects]) == (before, names)
