# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that open and export job files, save templates and write a job's report; they are in the menu alone."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.messages import note
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, tr


class OpenJob(Command):
    """Makes the objects of a job file; also a document, when none is open."""

    name = "CNCStepper_OpenJob"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_OpenJob", "Open job…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_OpenJob", "Opens a job file with its tools, operations and curves")

    def why_not(self) -> str:
        """Return why no job can be opened."""
        return missing_packages.why_not() or targets.why_no_panel()

    def run(self) -> None:
        """Ask for the file."""
        from CNCStepper.workbench.document.job_files import ask_to_open

        ask_to_open(self.take)

    def take(self, path: str) -> None:
        """Make the objects as one undo step, and show what they do not hold."""
        from pathlib import Path

        import FreeCAD

        from CNCStepper.workbench.document.job_opening import JobOpening

        JobOpening(targets.document() or FreeCAD.newDocument(), Path(path), self.text()).begin()


class ExportJob(Command):
    """Writes the job as a job file."""

    name = "CNCStepper_ExportJob"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_ExportJob", "Export job…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_ExportJob", "Writes the job as a file that cncstepper runs")

    def why_not(self) -> str:
        """Return why there is no job that can be written."""
        no_job = missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()
        return no_job or targets.why_no_program(targets.job())

    def run(self) -> None:
        """Ask for the file, and write it."""
        from CNCStepper.workbench.document.job_files import ask_to_export

        job = targets.job()
        ask_to_export(job, lambda path: self.write(job, path))

    def write(self, job: Any, path: str) -> None:
        """Write the file."""
        from CNCStepper.workbench.document.job_files import export_job

        job.Document.recompute()
        export_job(job, path)
        note(tr("{0} was written").format(path))


class SaveJobTemplate(Command):
    """Saves the job's set-up as a template, with which new jobs begin."""

    name = "CNCStepper_SaveJobTemplate"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_SaveJobTemplate", "Save as job template…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_SaveJobTemplate",
        "Saves machine, material, stock, work zero and tools of the job under a name; a new job can begin with them",
    )

    def why_not(self) -> str:
        """Return why there is no job that can be saved so."""
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()

    def run(self) -> None:
        """Ask for the name, and save the template."""
        from CNCStepper.workbench.templates.save_dialog import ask_to_save

        ask_to_save(targets.job())


class Report(Command):
    """Writes the report of a job."""

    name = "CNCStepper_Report"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Report", "Report…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Report", "Writes the job on paper: its operations with tool and time, its path and its program"
    )

    def why_not(self) -> str:
        """Return why there is no job with a program."""
        no_job = missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()
        return no_job or targets.why_no_program(targets.job())

    def run(self) -> None:
        """Ask for the file, write it, and open it."""
        from CNCStepper.workbench.report import job_report

        job_report.ask(targets.job(), job_report.show)
