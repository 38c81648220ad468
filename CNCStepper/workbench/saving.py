# SPDX-License-Identifier: LGPL-2.1-or-later
"""Saving a job's program as a file of its own."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.workbench.words import tr


def save_as(job: Any) -> None:
    """Make the job's program, ask where to, and write it; raises JobError when it cannot be made or written."""
    import FreeCADGui
    from PySide import QtGui

    from CNCStepper.workbench import api, tell
    from CNCStepper.workbench.commands import proving

    proving.make(job)
    kinds = tr("Programs ({0})").format("*.nc *.ngc *.gcode *.tap") + ";;" + tr("All files ({0})").format("*")
    path, _ = QtGui.QFileDialog.getSaveFileName(
        FreeCADGui.getMainWindow(), tr("Save program as…"), str(proposed(job)), kinds
    )
    if path:
        api.save_program(job, path)
        tell.note(tr("Saved {0}").format(path))


def proposed(job: Any) -> Path:
    """Return the file that is proposed: beside the document, named as the job."""
    folder = Path(job.Document.FileName).parent if job.Document.FileName else Path.home()
    return folder / f"{job.Label.replace('/', '-')}.nc"
