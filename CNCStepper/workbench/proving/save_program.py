# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saving a job's program as a file of its own."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.errors import OutputError
from CNCStepper.workbench.services.messages import ask, guarded, note, sentence
from CNCStepper.workbench.services.translation import tr


def save_as(job: Any) -> None:
    """Make the job's program and ask where to; raises JobError when it cannot be made. What follows is told."""
    import FreeCADGui
    from PySide import QtCore, QtGui

    from CNCStepper.workbench.proving import prove_program

    prove_program.make(job)
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
    """Return the proposed file: in the document's folder, named as the job."""
    folder = Path(job.Document.FileName).parent if job.Document.FileName else Path.home()
    return folder / f"{job.Label.replace('/', '-')}.nc"


def _write(job: Any, path: str) -> None:
    from CNCStepper.workbench import api

    try:
        saved = api.save_program(job, path)
    except OutputError as error:  # the dialog has asked about the name that was typed, not about those made of it
        if not ask(sentence(error), tr("Replace"), tr("Cancel")):
            return
        saved = api.save_program(job, path, overwrite=True)
    note(tr("Saved {0}").format(", ".join(map(str, saved))))
