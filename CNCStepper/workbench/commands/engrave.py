# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Engrave: the tool follows the lines of the selected drawing."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands import choice, defaults
from CNCStepper.workbench.commands.creation import Operation, labelled, tool_for
from CNCStepper.workbench.words import QT_TRANSLATE_NOOP, tr


class Engrave(Operation):
    """Adds an engraving to the job."""

    name = "CNCStepper_Engrave"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Engrave", "Engrave")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Engrave", "Cuts along the lines of the selected drawing")

    def why_not(self) -> str:
        """Return why nothing can be engraved."""
        return super().why_not() or ("" if choice.drawing() is not None else _no_drawing())

    def add(self, job: Any, drawing: Any) -> Any:
        """Return the new operation."""
        from CNCStepper.workbench import api
        from CNCStepper.workbench.shapes import edges_of

        edges_of(drawing)
        values = defaults.engraving(tuple(job.StockSize))
        return labelled(api.add_engrave(job, drawing, tool=tool_for(job), **values), tr("Engraving"))


def _no_drawing() -> str:
    return tr("Select what is to be engraved: a sketch, a wire, a B-spline or a freehand line")
