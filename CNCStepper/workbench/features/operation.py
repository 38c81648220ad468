# SPDX-License-Identifier: LGPL-2.1-or-later
"""What all operations share: a tool, a cycle made from their properties, and a job that cuts them in order."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import CycleError
from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import (
    BOOL,
    CONTAINERS,
    DRAWING,
    JOB,
    LINK,
    TEXT,
    Feature,
    Property,
    proxy_type,
    require_parts,
    show,
    values,
)
from CNCStepper.workbench.shapes import containers_of
from CNCStepper.workbench.words import later

OPERATION_GROUP, CUT, RESULT = later("Operation"), later("Cut"), later("Recalculated to whole passes")
OPERATION = (
    Property("tool", "Tool", LINK, OPERATION_GROUP, later("Tool"), later("The tool that cuts it")),
    Property("active", "Active", BOOL, OPERATION_GROUP, later("Active"), later("Whether the program holds it"), True),
)


def drawn(group: str, text: str) -> tuple[Property, ...]:
    """Return the properties of an operation that follows a drawing."""
    return (
        Property("drawing", "Drawing", DRAWING, group, later("Drawing"), text),
        Property("containers", "Containers", CONTAINERS, group, later("Containers"),
                 later("The parts and bodies that the drawing moves with"), (), output=True),
        Property("deleted_drawing", "DeletedDrawing", TEXT, group, later("Deleted drawing"),
                 later("The drawing it followed, when that was deleted"), "", output=True),
    )  # fmt: skip


class Operation(Feature):
    """The proxy of an operation: its properties are its cycle's parameters, under the same keys."""

    CYCLE = ""
    removed_label = ""
    last_cut: Any = None  # a CutOnce
    warnings: tuple[str, ...] = ()  # what the last cut says that a person should know

    def follow(self, obj: Any, origin_mm: tuple[float, ...]) -> None:
        """Take those parameters from the drawing that it gives; only while `obj` itself is recomputed."""

    def cycle_values(self, obj: Any, origin_mm: tuple[float, ...]) -> dict[str, Any]:
        """Return the cycle's parameters; `origin_mm` is where the work zero lies in the document."""
        raise NotImplementedError

    def cycle(self, obj: Any, origin_mm: tuple[float, ...]) -> Any:
        """Return the checked cycle of `obj` in work coordinates; raises CycleError, GeometryError or JobError."""
        packages.require()
        from CNCStepper.cycles.catalogue import cycle_class
        from CNCStepper.machine.profile import validated

        content = {"cycle": self.CYCLE, "tool": _tool(obj).Number, **self.cycle_values(obj, origin_mm)}
        return validated(cycle_class(self.CYCLE), content, obj.Label)

    def cut_once(self, cycle: Any, setup: Any) -> Any:
        """Return the cycle with its cut, which is kept for the next who asks for the same; raises CycleError."""
        from CNCStepper.workbench.cut_once import CutOnce

        if self.last_cut is None or not self.last_cut.fits(cycle, setup):
            self.last_cut = CutOnce(cycle, setup)
        return self.last_cut

    def make(self, obj: Any) -> None:
        """Cut it for trial, as its job would, and show the figures."""
        self.warnings = ()
        _refuse_deleted(obj)
        require_parts(part for part in (obj.Tool, obj.Drawing) if part is not None)
        show(obj, self.figures(obj))

    def onChanged(self, obj: Any, name: str) -> None:
        """Stand on what the drawing moves with, too; FreeCAD calls this at every change."""
        if name == "Drawing" and "DeletedDrawing" in obj.PropertiesList and "Restore" not in obj.State:
            obj.Containers = containers_of(obj.Drawing)
            obj.DeletedDrawing = self.removed_label
            self.removed_label = ""

    def onBeforeChange(self, obj: Any, name: str) -> None:
        """Note which drawing is being deleted; FreeCAD calls this before every change."""
        if name == "Drawing" and obj.Drawing is not None and obj.Drawing.Removing:
            self.removed_label = obj.Drawing.Label

    def figures(self, obj: Any) -> dict[str, float]:
        """Return what the cycle reports (recalculated ae and ap, passes); nothing while it belongs to no job."""
        jobs = jobs_of(obj)
        origin_mm = tuple(jobs[0].WorkOrigin) if jobs else (0.0, 0.0, 0.0)
        self.follow(obj, origin_mm)
        cycle = self.cycle(obj, origin_mm)
        if not jobs:
            return {}
        from CNCStepper.workbench.making import setup_of

        answer = self.cut_once(cycle, setup_of(jobs[0], _tool(obj))).answer
        self.warnings = tuple(answer.warnings)
        return answer.figures


def parameters(obj: Any) -> dict[str, Any]:
    """Return the values of `obj` that are its cycle's own parameters."""
    return {key: value for key, value in values(obj).items() if key not in ("tool", "active", "drawing")}


def jobs_of(obj: Any) -> list[Any]:
    """Return the jobs that hold an operation (one, unless a user linked it twice)."""
    return [other for other in obj.InList if proxy_type(other) == JOB]


def _refuse_deleted(obj: Any) -> None:
    if obj.DeletedDrawing:
        raise CycleError(
            "drawing-deleted",
            f"the drawing '{obj.DeletedDrawing}' that it followed was deleted",
            advice="undo that, choose another drawing, or choose none",
        )


def _tool(obj: Any) -> Any:
    if proxy_type(obj.Tool) != "CNCStepper_Tool":
        raise CycleError("tool-missing", f"{obj.Label} has no tool", advice="choose one of the job's tools for it")
    return obj.Tool
