# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which panel belongs to which object."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.base import JOB, proxy_type
from CNCStepper.workbench.features.elliptical_pocket import FINISH, PATH
from CNCStepper.workbench.features.tool import FORM, LIMITS
from CNCStepper.workbench.panels.editor import Editor
from CNCStepper.workbench.panels.links import DrawingField, ToolField
from CNCStepper.workbench.panels.panel import Panel

KINDS = {"tool": ToolField, "drawing": DrawingField}
FOLDED = {"CNCStepper_EllipticalPocket": (FINISH, PATH), "CNCStepper_Tool": (FORM, LIMITS)}
FREEHAND = "CNCStepper_Freehand"
HIDDEN = {FREEHAND: ("points_mm",)}


def panel_of(obj: Any) -> Panel:
    """Return a new panel that edits one of our objects."""
    name = proxy_type(obj)
    if name == JOB:
        from CNCStepper.workbench.panels.job import JobPanel

        return JobPanel(obj)
    editor = Editor(obj, KINDS, FOLDED.get(name, ()), HIDDEN.get(name, ()))
    if name == FREEHAND:
        from CNCStepper.workbench.panels.freehand import FreehandPanel

        return FreehandPanel(obj, editor)
    return Panel(obj, editor)
