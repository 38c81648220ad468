# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_ImportTools: tools of another program's file into the job."""

from __future__ import annotations

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class ImportTools(Command):
    """Adds the tools of a file to the job."""

    name = "CNCStepper_ImportTools"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_ImportTools", "Import tools…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_ImportTools", "Adds the tools of FreeCAD's library or of a tool table")

    def why_not(self) -> str:
        """Return why there is no job to add tools to."""
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()

    def run(self) -> None:
        """Ask for the file."""
        from CNCStepper.workbench.document import tool_import

        tool_import.ask(targets.job(), done=lambda: None)
