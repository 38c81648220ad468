# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared steps of the commands for a job's program or an edited one: check, send, save."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.errors import OutputError
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.document.preferred_values import program_folder
from CNCStepper.workbench.features.base import named, problem_of
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import ask, guarded, note, sentence
from CNCStepper.workbench.services.translation import tr


def why_not() -> str:
    """Return why no program can be taken further, "" when one can."""
    if (edited := targets.program()) is not None:
        return why_not_of(edited)
    return (
        missing_packages.why_not()
        or targets.why_no_panel()
        or targets.why_no_job()
        or targets.why_no_program(targets.job())
    )


def why_not_of(edited: Any) -> str:
    """Return why an edited program cannot be taken further, "" when it can."""
    problem = named(edited, translated(problem_of(edited))) if problem_of(edited) else ""
    return missing_packages.why_not() or targets.why_no_panel() or problem


def meant() -> Any:
    """Return the edited program that is selected, else the job that is meant."""
    return targets.program() or targets.job()


def make(job: Any) -> None:
    """Make a program from the present document; raises JobError when that is impossible."""
    from CNCStepper.workbench import api

    job.Document.recompute()
    api.require_valid(job)


def save_as(job: Any) -> None:
    """Make the job's program and ask where to; raises JobError when it cannot be made. What follows is told."""
    import FreeCADGui
    from PySide import QtCore, QtGui

    make(job)
    dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), tr("Save program as…"), str(proposed(job).parent))
    dialog.setObjectName("CNCStepper_Save_file")
    dialog.setAcceptMode(QtGui.QFileDialog.AcceptMode.AcceptSave)
    dialog.setFileMode(QtGui.QFileDialog.FileMode.AnyFile)
    dialog.setNameFilters([tr("Programs ({0})").format("*.nc *.ngc *.gcode *.tap"), tr("All files ({0})").format("*")])
    dialog.setDefaultSuffix("nc")
    dialog.selectFile(proposed(job).name)
    dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    dialog.fileSelected.connect(guarded(lambda path: _write(job, path)))
    dialog.open()


def proposed(job: Any) -> Path:
    """Return the file that is proposed: in the preferred folder or beside the document, named as the job."""
    return program_folder(job.Document) / f"{job.Label.replace('/', '-')}.nc"


def _write(job: Any, path: str) -> None:
    from CNCStepper.workbench import api

    try:
        saved = api.save_program(job, path)
    except OutputError as error:  # the dialog has asked about the name that was typed, not about those made of it
        if not ask(sentence(error), tr("Replace"), tr("Cancel")):
            return
        saved = api.save_program(job, path, overwrite=True)
    note(tr("Saved {0}").format(", ".join(map(str, saved))))
