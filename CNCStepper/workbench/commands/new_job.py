# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_NewJob: a job with a first tool, its stock taken from what is selected."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import missing
from CNCStepper.workbench.commands import choice, defaults
from CNCStepper.workbench.commands.base import Command
from CNCStepper.workbench.commands.creation import create, labelled, show_all
from CNCStepper.workbench.words import QT_TRANSLATE_NOOP, tr


class NewJob(Command):
    """Makes a job; also a document, when none is open."""

    name = "CNCStepper_NewJob"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_NewJob", "New job")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_NewJob", "Makes a job. A selected solid or drawing gives its stock")

    def why_not(self) -> str:
        """Return why no job can be made."""
        return missing.why_not() or choice.why_no_panel()

    def run(self) -> None:
        """Make the job, open its panel, and bring its stock into view."""
        import FreeCAD

        document = choice.document() or FreeCAD.newDocument()
        create(document, tr("New job"), lambda: _job(document))
        show_all()


def _job(document: Any) -> Any:
    from CNCStepper.workbench import api
    from CNCStepper.workbench.viewproviders.job import previews

    job = labelled(api.new_job(document, **_stock()), tr("Job"))
    labelled(api.add_tool(job), tr("Tool"))
    for preview in previews(job):
        labelled(preview, tr("Preview"))
    return job


def _stock() -> dict[str, Any]:
    """Return the values that the selection gives; none where nothing is selected."""
    from CNCStepper.workbench.shapes import box_of, box_of_boxes

    if (solid := choice.solid()) is not None:
        return defaults.stock_of_solid(box_of(solid))
    boxes = [box for drawing, _ in choice.drawings() if (box := box_of(drawing)).isValid()]
    return defaults.stock_of_drawing(box_of_boxes(boxes)) if boxes else {}
