# SPDX-License-Identifier: LGPL-2.1-or-later
"""A template and an imported drawing: the job's program is that of the command line, and it follows the drawing."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.cut_transfer import program_texts
from CNCStepper.job.templates.drawing_job import job_of_drawing
from CNCStepper.job.templates.template import read_template
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.profile import load_machine
from CNCStepper.workbench import api
from CNCStepper.workbench.document.job_files import export_job, open_job
from CNCStepper.workbench.document.template_jobs import apply_template, new_template
from CNCStepper.workbench.features.base import problem_of, proxy_type
from CNCStepper.workbench.templates.draft import texts_of

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
