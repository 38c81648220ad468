# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the random walks of test_monkey.py begin with: jobs of every process with all their operations, all drawings."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import FreeCAD
import Part
from FreeCAD import Vector

from CNCStepper.workbench import api
from CNCStepper.workbench.features.catalogue import OPERATIONS, TURNING_OPERATIONS

PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="60mm" height="40mm" viewBox="0 0 60 40">
<rect x="2" y="2" width="56" height="36"/><circle cx="30" cy="20" r="8"/></svg>"""
SHEET_MM = (200.0, 150.0)


def outline(document: Any) -> Any:
    """Return a rectangle. None of Draft's: its editor, which a double click opens, crashes FreeCAD 1.1.3."""
    corners = [(-30, -20, 0), (30, -20, 0), (30, 20, 0), (-30, 20, 0), (-30, -20, 0)]
    drawn = document.addObject("Part::Feature", "Outline")
    drawn.Shape = Part.makePolygon([Vector(*corner) for corner in corners])
    return drawn


def milling(document: Any, folder: Path) -> None:
    """A job of milling and every operation of it, a text and a shape."""
    drawn, job = outline(document), api.new_job(document)
    api.add_tool(job, diameter_mm=6)
    for cycle, kind in OPERATIONS.items():
        if "milling" in kind.BY:
            api.add_operation(job, cycle, drawn)
    api.add_text(document, "ABC")
    api.add_shape(document, "flange")


def turning(document: Any, folder: Path) -> None:
    """A lathe's job and every operation of it."""
    job = api.new_lathe_job(document)
    api.add_tool(job)
    profile = api.add_profile(document, ("20; 0", "20; -30"))
    for cycle, kind in TURNING_OPERATIONS.items():
        api.add_operation(job, cycle, profile if kind.FOLLOWS else None)


def cutting(document: Any, folder: Path) -> None:
    """Jobs by torch, laser and wire, each with its operation."""
    drawn = outline(document)
    for process, machine, material, thickness_mm, cycle in (
        ("plasma", "torch-table", "mild-steel", 3, "sheet_cut"),
        ("laser", "laser-table", "plywood", 3, "sheet_cut"),
        ("hot-wire", "wire-table", "eps", 20, "wire_cut"),
    ):
        size_mm = (*SHEET_MM, thickness_mm)
        values = {"machine": machine, "material": material, "stock_form": "sheet", "stock_size_mm": size_mm}
        api.add_operation(api.new_job(document, process=process, **values), cycle, drawn)


def drawings(document: Any, folder: Path) -> None:
    """A drawing of a file, a freehand line, a text, a shape, slices, a nest, an arrangement, an edited program."""
    file = folder / "placa ç.svg"
    file.write_text(PLATE, "utf-8")
    drawing = api.import_drawing(document, file)
    box = document.addObject("Part::Box", "Box")
    job = api.new_job(document)
    api.add_tool(job, diameter_mm=3)
    text, shape = api.add_text(document, "ABC"), api.add_shape(document, "flange")
    line = api.add_freehand(document, [(0, 0), (10, 5), (20, 0), (30, 8)])
    document.recompute()
    api.add_operation(job, "engrave", line)
    document.recompute()
    api.edit_program(job)
    api.add_slices(document, box)
    api.add_nest(document, [text, shape, *drawing.Group[:1]])
    api.add_arrangement(job, [job], file=str(folder / "placas.nc"))


KINDS: dict[str, Callable[[Any, Path], None]] = {
    "milling": milling,
    "turning": turning,
    "cutting": cutting,
    "drawings": drawings,
}


def draw(kind: str, folder: Path) -> Any:
    """Return a document of a kind; nothing to undo."""
    document = FreeCAD.newDocument("Monkey")
    document.UndoMode = 1
    KINDS[kind](document, folder)
    document.recompute()
    document.clearUndos()
    return document
