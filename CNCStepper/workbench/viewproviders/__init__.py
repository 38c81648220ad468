# SPDX-License-Identifier: LGPL-2.1-or-later
"""How our objects look and behave in FreeCAD's tree and 3D view; needed only where there is a window.

Documents keep the modules and names of these classes: a class that moves leaves its old name behind.
"""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.services import object_observers


def register() -> None:
    """Attach a view provider to each object that is made or opened in FreeCAD's window from now on."""
    object_observers.observe(attach)


def attach(obj: Any) -> None:
    """Give an object of ours the view provider of its kind, unless it has it; its long cuts are deferred.

    FreeCAD opens what was made without a window hidden: that, which has no view provider at all, is shown.
    """
    view = getattr(obj, "ViewObject", None)
    if view is None:
        return
    from CNCStepper.workbench.calculation import deferred_cuts

    kind = _kind(obj)
    made_without = view.Proxy is None
    if not isinstance(view.Proxy, kind):
        kind(view)
    if made_without:
        view.Visibility = True
    deferred_cuts.begin()


def _kind(obj: Any) -> type:
    from CNCStepper.workbench.features.base import JOB, LATHE_JOB, proxy_type
    from CNCStepper.workbench.features.cycle_operation import CycleOperation as Feature
    from CNCStepper.workbench.viewproviders.base import ViewProvider
    from CNCStepper.workbench.viewproviders.drawing import Drawing
    from CNCStepper.workbench.viewproviders.job import Job, LatheJob
    from CNCStepper.workbench.viewproviders.operation import Operation
    from CNCStepper.workbench.viewproviders.preview import Preview
    from CNCStepper.workbench.viewproviders.program import Program
    from CNCStepper.workbench.viewproviders.tool import Tool, TurningTool

    if isinstance(obj.Proxy, Feature):
        return Operation
    kinds = {
        JOB: Job,
        LATHE_JOB: LatheJob,
        "CNCStepper_Preview": Preview,
        "CNCStepper_Program": Program,
        "CNCStepper_Drawing": Drawing,
        "CNCStepper_Tool": Tool,
        "CNCStepper_TurningTool": TurningTool,
    }
    return kinds.get(proxy_type(obj), ViewProvider)
