# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_EllipticalPocket: a pocket from the selected ellipse, or from numbers."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands import defaults
from CNCStepper.workbench.commands.creation import Operation, labelled, tool_for
from CNCStepper.workbench.words import QT_TRANSLATE_NOOP, tr


class EllipticalPocket(Operation):
    """Adds an elliptical pocket to the job."""

    name = "CNCStepper_EllipticalPocket"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_EllipticalPocket", "Elliptical pocket")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_EllipticalPocket", "Cuts a pocket: the selected ellipse, or one by numbers")

    def add(self, job: Any, drawing: Any) -> Any:
        """Return the new operation."""
        from CNCStepper.workbench import api
        from CNCStepper.workbench.ellipses import ellipse_of

        if drawing is not None:
            ellipse_of(drawing)
        tool = tool_for(job)
        values = defaults.pocket(tuple(job.StockSize), job.StockOrigin, float(tool.Diameter), drawing is not None)
        return labelled(api.add_elliptical_pocket(job, drawing, tool=tool, **values), tr("Elliptical pocket"))
