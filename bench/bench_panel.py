# SPDX-License-Identifier: LGPL-2.1-or-later
"""Milliseconds from an edit to the new program and picture, in FreeCAD, for the two cuts of the demo part.

Python starts FreeCAD with this file, and FreeCAD measures: its task panels do the same at every good key.
"""

from __future__ import annotations

import statistics
import sys
import time
from typing import Any

from in_freecad import ROOT, is_measuring, run

EDITS = 40


def pocket(document: Any) -> tuple[Any, Any]:
    """Return the demo's pocket and its job."""
    from CNCStepper.workbench import api

    job = api.new_job(document)
    api.add_tool(job, diameter_mm=6)
    return api.add_elliptical_pocket(job, depth_mm=10), job


def engraving(document: Any) -> tuple[Any, Any]:
    """Return the demo's engraving and its job."""
    from CNCStepper.drawing.point_list import read_points
    from CNCStepper.workbench import api

    points = read_points(ROOT / "examples" / "brazil-outline.csv", closed=True).xy
    job = api.new_job(document, stock_size_mm=(400, 400, 6))
    api.add_tool(job, shape="ball", diameter_mm=2)
    return api.add_engrave(job, api.add_freehand(document, points.tolist(), closed=True)), job


def measure(document: Any, make: Any) -> str:
    """Return a line with what the edits of an operation took."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.calculation.recompute import remake

    operation, job = make(document)
    document.recompute()
    depth_mm = operation.Depth.Value
    times_ms = []
    for number in range(EDITS):
        api.edit(operation, depth_mm=depth_mm - number % 5 / 10)
        begun = time.perf_counter()
        remake(document)
        times_ms.append((time.perf_counter() - begun) * 1000)
    lines = api.program_text(job).count("\n")
    times = f"fastest {min(times_ms):.0f}, median {statistics.median(times_ms):.0f}, longest {max(times_ms):.0f} ms"
    return f"{times} ({lines} lines)"


def inside() -> None:
    """Measure, in FreeCAD."""
    import FreeCAD

    for make in (pocket, engraving):
        result = measure(FreeCAD.newDocument(), make)
        print(f"panel: edit the demo's {make.__name__}: {result}", file=sys.stderr)


if __name__ == "__main__" or is_measuring("panel"):
    run(__file__, "panel", inside)
