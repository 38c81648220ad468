# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that prepare a job: a new one with stock from what is selected and a first tool; tools of a file."""

from __future__ import annotations

from typing import Any

from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench.commands.create_object import create, labelled
from CNCStepper.workbench.document import default_values, preferred_values, targets
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, tr
from CNCStepper.workbench.services.view_fit import show_all
from CNCStepper.workbench.templates.around import Around


class NewJob(Command):
    """Makes a job; also a document, when none is open."""

    name = "CNCStepper_NewJob"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_NewJob", "New job")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_NewJob", "Makes a job. A selected solid or drawing gives its stock")

    def why_not(self) -> str:
        """Return why no job can be made."""
        return missing_packages.why_not() or targets.why_no_panel()

    def run(self) -> None:
        """Make the job, open its panel, and bring its stock into view."""
        import FreeCAD

        document = targets.document() or FreeCAD.newDocument()
        create(document, tr("New job"), lambda: _job(document))
        show_all()


def _job(document: Any) -> Any:
    from CNCStepper.workbench import api
    from CNCStepper.workbench.viewproviders.job import previews

    around = _around()
    job = labelled(api.new_job(document, **preferred_values.of_new_job(), **_stock(around)), tr("Job"))
    job.Proxy.around = around
    api.add_tool(job, **default_values.tool(job))
    for preview in previews(job):
        labelled(preview, tr("Preview"))
    return job


def _around() -> Around:
    """Return what the selection gives the stock."""
    from CNCStepper.workbench.drawings.shapes import box_of, box_of_boxes

    if (solid := targets.solid()) is not None:
        return Around(box_of(solid), is_solid=True)
    boxes = [box for drawing, _ in targets.drawings() if (box := box_of(drawing)).isValid()]
    return Around(box_of_boxes(boxes)) if boxes else Around()


def _stock(around: Around) -> dict[str, Any]:
    """Return the values of the stock round a solid or drawings; none round nothing."""
    if around.box is None:
        return {}
    if around.is_solid:
        return default_values.stock_of_solid(around.box)
    return default_values.stock_of_drawing(around.box, preferred_values.thickness_mm())


class ImportTools(Command):
    """Adds the tools of a file to the job."""

    name = "CNCStepper_ImportTools"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_ImportTools", "Import tools…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_ImportTools", "Adds the tools of FreeCAD's library or of a tool table")

    def why_not(self) -> str:
        """Return why there is no job to add tools to."""
        no_job = missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()
        return no_job or targets.why_not_by_process(tuple(PROCESSES))

    def run(self) -> None:
        """Ask for the file."""
        from CNCStepper.workbench.document.tools import tool_import

        tool_import.ask(targets.job(), done=lambda: None)
