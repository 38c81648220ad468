# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part as it stood at a moment, kept in the document as a mesh of FreeCAD."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.program import job_behind
from CNCStepper.workbench.freehand.mode import undo_step
from CNCStepper.workbench.services.quantity_format import clock_text
from CNCStepper.workbench.services.translation import tr


def keep_mesh(job: Any, stl: str, time_s: float) -> Any:
    """Add a mesh from a file in work coordinates to a job's document, at the job's work zero, in one undo step."""
    import FreeCAD
    import Mesh

    with undo_step(job.Document, tr("Keep the cut part as mesh")):
        obj = job.Document.addObject("Mesh::Feature", "CutPart")
        obj.Label = tr("{0}, cut until {1}").format(job.Label, clock_text(time_s))
        obj.Mesh = Mesh.Mesh(stl)
        obj.Placement = FreeCAD.Placement(FreeCAD.Vector(job_behind(job).WorkOrigin), FreeCAD.Rotation())
    return obj
