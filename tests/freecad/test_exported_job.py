# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of texts, shapes, an imported drawing and a freehand line, exported and opened in another folder."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import FreeCAD
import pytest
from FreeCAD import Placement, Rotation, Vector

from CNCStepper.job.cut_transfer import program_texts
from CNCStepper.job.model import load_job
from CNCStepper.workbench import api
from CNCStepper.workbench.document.job_files import export_job, open_job
from CNCStepper.workbench.features.base import problem_of

PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="60mm" viewBox="0 0 100 60">
<path id="çurva" d="M5 5 C 30 40 60 -20 90 20" fill="none" stroke="#ff0000"/>
<ellipse id="oval" cx="50" cy="35" rx="20.123" ry="9.7" fill="none" stroke="#0000ff"/></svg>"""


def everything(document: Any, folder: Path) -> Any:
    """Return a job that cuts each kind of drawing, moved and turned by numbers that end nowhere."""
    (folder / "peça ç.svg").write_text(PLATE, encoding="utf-8")
    drawing = api.import_drawing(document, folder / "peça ç.svg")
    text = api.add_text(document, "Ação\n7", font="DejaVu Sans", height_mm=9, slant_deg=10)
    arc = api.add_text(document, "Volta já", font="engraving", height_mm=6, along="arc", arc_radius_mm=40)
    shape = api.add_shape(document, "flange", outer_diameter_mm=90, holes=5)
    line = api.add_freehand(document, [(x, 5 * math.sin(x / 7)) for x in range(60)], smooth_mm=0.05)
    for number, obj in enumerate((text, arc, shape, line)):
        obj.Placement = Placement(Vector(100 / 3, 70 + 50 * number, 0), Rotation(Vector(0, 0, 1), 10 * math.pi))
    document.recompute()
    job = api.new_job(document, stock_size_mm=(400, 400, 12), work_origin_mm=(-50 / 7, 20 / 3, 0))
    job.Label = "Ação"
    api.add_tool(job, diameter_mm=1, feed_mm_min=700)
    curve, oval = drawing.Group
    for cut in (line, arc, curve, shape):
        api.add_engrave(job, cut, depth_mm=0.3)
    api.add_operation(job, "pocket", oval, depth_mm=1 / 3, stepover_mm=0.4)
    api.add_operation(job, "pocket", text, depth_mm=0.5, stepover_mm=0.4)
    api.add_operation(job, "contour", shape, depth_mm=2)
    document.recompute()
    return job


@pytest.mark.parametrize("machine", ["table-a", "table-b"])
def test_a_job_of_every_drawing_is_the_same_program_in_another_folder(
    document: Any, tmp_path: Path, machine: str
) -> None:
    here, there = tmp_path / "aqui ç", tmp_path / "lá longe"
    here.mkdir()
    there.mkdir()
    job = everything(document, here)
    api.edit(job, machine=machine)
    document.recompute()
    assert [*filter(None, map(problem_of, (*job.Tools, *job.Operations, job)))] == []
    text = api.program_text(job)
    export_job(job, here / "job.toml")
    (here / "job.toml").rename(there / "job.toml")
    (here / "peça ç.svg").unlink()
    model, profile = load_job(there / "job.toml")
    assert next(iter(program_texts(model.on(profile), profile, job.Label)))[1] == text
    other = FreeCAD.newDocument("Other")
    try:
        opened, notes = open_job(other, there / "job.toml")
        opened.Label = job.Label
        other.recompute()
        assert [*filter(None, map(problem_of, (*opened.Tools, *opened.Operations, opened)))] == []
        assert api.program_text(opened) == text
        export_job(opened, there / "again.toml")
        model, profile = load_job(there / "again.toml")
        assert next(iter(program_texts(model.on(profile), profile, job.Label)))[1] == text
        assert notes == []
    finally:
        FreeCAD.closeDocument(other.Name)
