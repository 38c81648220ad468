# SPDX-License-Identifier: LGPL-2.1-or-later
"""A document with one of everything that the workbench makes, for tests that save and open it."""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import Any

import FreeCAD
import Part

from CNCStepper.workbench import api
from CNCStepper.workbench.document import program_file

FOLDER = "CNCSTEPPER_DOCUMENTS"  # where `make matrix` lets one FreeCAD leave its document for the next
OLDER = "CNCSTEPPER_OLDER"  # which documents must be there


def draw() -> tuple[Any, Any]:
    """Return a new document and its job: sketch, freehand line, two tools, pocket and engraving."""
    document = FreeCAD.newDocument("Whole")
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.Label = "Elipse da peça"
    sketch.addGeometry(Part.Ellipse(FreeCAD.Vector(5, 3, 0), 30, 20), False)
    wave = [(5 + 3 * math.sin(k / 3), 2.5 * k - 25) for k in range(20)]
    freehand = api.add_freehand(document, wave, tolerance_mm=0.05)
    job = api.new_job(document, machine="table-a", stock_size_mm=(100, 70, 20), stock_origin="top-centre")
    mill = api.add_tool(
        job, number=1, shape="flat", diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=10000
    )
    ball = api.add_tool(
        job, number=2, shape="ball", diameter_mm=3, feed_mm_min=600, plunge_mm_min=150, spindle_rpm=12000
    )
    api.add_elliptical_pocket(job, drawing=sketch, tool=mill, depth_mm=6, stepdown_mm=2, stepover_mm=2.4)
    api.add_engrave(job, drawing=freehand, tool=ball, depth_mm=0.8)
    document.recompute()
    return document, job


def version() -> str:
    """Return the version of the FreeCAD that runs this."""
    return ".".join(FreeCAD.Version()[:3])


def older() -> list[str]:
    """Return the versions whose documents this FreeCAD has to open."""
    return os.environ.get(OLDER, "").split()


def save(folder: Path) -> str:
    """Draw the document, save it as VERSION.FCStd with its program in VERSION.nc beside it; return the program."""
    document, job = draw()
    text = api.program_text(job)
    (folder / f"{version()}.nc").write_text(text, "ascii", newline="\n")
    document.saveAs(str(folder / f"{version()}.FCStd"))
    FreeCAD.closeDocument(document.Name)
    return text


def check(path: Path, wanted: str) -> None:
    """Open a document: the program in it, and the one made anew from its drawing, are the wanted one."""
    document = FreeCAD.openDocument(str(path))
    job = next(obj for obj in document.Objects if obj.Name.startswith("CNCStepper_Job"))
    assert program_file.load(job) == wanted
    document.recompute()
    assert api.program_text(job) == wanted
    for obj in document.Objects:
        obj.touch()
    document.recompute()
    assert api.program_text(job) == wanted
    pocket = job.Operations[0]
    api.edit(pocket, depth_mm=4)
    document.recompute()
    assert "Z-4." in api.program_text(job) and "Z-6." not in api.program_text(job)
    FreeCAD.closeDocument(document.Name)
