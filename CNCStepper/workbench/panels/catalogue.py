# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which panel belongs to which object."""

from __future__ import annotations

from typing import Any

from CNCStepper.cycles.parameter import FINISH, LEADS, PATH, TABS
from CNCStepper.cycles.sheet_cutting.sheet_parameters import RULES
from CNCStepper.job.shape_forms.text_parameters import SETTING
from CNCStepper.workbench.features.base import JOB, LATHE_JOB, proxy_type
from CNCStepper.workbench.features.drawings.drawing import REPAIR
from CNCStepper.workbench.features.operation import Operation
from CNCStepper.workbench.features.tool import FORM, LIMITS
from CNCStepper.workbench.panels.drawing_fields import DrawingField, DrawingsField, MarksField
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.point_list_field import PointsField
from CNCStepper.workbench.panels.task_panel import Panel
from CNCStepper.workbench.panels.tools.tip_angle_field import TipAngleField
from CNCStepper.workbench.panels.tools.tool_field import ToolField

KINDS = {
    "tool": ToolField,
    "mark_drawings": MarksField,
    "pattern_points_mm": PointsField,
    "tip_angle_deg": TipAngleField,
}
RARE = (FINISH, PATH, TABS, LEADS, RULES)  # groups of operations
FREEHAND = "CNCStepper_Freehand"
DRAWING = "CNCStepper_Drawing"
SLICES = "CNCStepper_Slices"
PROFILE = "CNCStepper_TurningProfile"
NEST = "CNCStepper_Nest"
ARRANGEMENT = "CNCStepper_Arrangement"
OUTLINES = ("CNCStepper_Text", "CNCStepper_Shape")
HIDDEN = {FREEHAND: ("points_mm",)}


def panel_of(obj: Any) -> Panel:
    """Return a new panel that edits one of our objects."""
    name = proxy_type(obj)
    if name == JOB:
        from CNCStepper.workbench.panels.job import JobPanel

        return JobPanel(obj)
    if name in (LATHE_JOB, PROFILE) or obj.Proxy.JOB_TYPE == LATHE_JOB:
        from CNCStepper.workbench.panels.turning import turning_panel

        return turning_panel(obj)
    folded = RARE if isinstance(obj.Proxy, Operation) else (FORM, LIMITS)
    drawings = DrawingField if getattr(obj.Proxy, "SHAPE", ()) else DrawingsField
    if name == DRAWING:
        from CNCStepper.workbench.panels.drawing import DrawingPanel, FileField

        return DrawingPanel(obj, Editor(obj, {"file": FileField}, (REPAIR,)))
    if name == SLICES:
        from CNCStepper.workbench.panels.slices import SlicesPanel, SolidField

        return SlicesPanel(obj, Editor(obj, {"solid": SolidField}))
    if name == NEST:
        from CNCStepper.workbench.panels.placing.nest import NestPanel

        return NestPanel(obj, Editor(obj, {}, (), ("parts", "part_values", "remnants")))
    if name == ARRANGEMENT:
        from CNCStepper.workbench.panels.placing.arrangement import ArrangementPanel, JobField

        return ArrangementPanel(obj, Editor(obj, {"job": JobField}, (), ("programs", "files", "counts")))
    if name in OUTLINES:
        from CNCStepper.workbench.panels.text import FontField, LinesField, OutlinePanel

        is_new = obj.Shape.isNull()
        return OutlinePanel(obj, Editor(obj, {"text": LinesField, "font": FontField}, (SETTING,)), is_new)
    editor = Editor(obj, {**KINDS, "drawings": drawings}, folded, HIDDEN.get(name, ()))
    if name == FREEHAND:
        from CNCStepper.workbench.panels.freehand import FreehandPanel

        return FreehandPanel(obj, editor)
    return Panel(obj, editor)
