# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools of FreeCAD's own library (.fctb, .fctl) and of LinuxCNC's tool table (.tbl) into a job."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.units import MM_PER_INCH
from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, note, notice
from CNCStepper.workbench.services.translation import tr


def ask(job: Any, done: Callable[[], None]) -> None:
    """Ask for a file of tools and return at once; `done` is called when the job has them."""
    import FreeCADGui
    from PySide import QtCore, QtGui

    every, inches = tr("Tools ({0})").format("*.fctb *.fctl *.tbl"), tr("Tool tables in inches ({0})").format("*.tbl")
    dialog = QtGui.QFileDialog(FreeCADGui.getMainWindow(), tr("Import tools"), _folder(job))
    dialog.setObjectName("CNCStepper_Import_file")
    dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
    dialog.setNameFilters([every, inches])
    dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)

    def take(path: str) -> None:
        unit_mm = MM_PER_INCH if dialog.selectedNameFilter() == inches else 1.0
        _tell(_taken(job, Path(path), unit_mm))
        done()

    dialog.fileSelected.connect(guarded(take))
    dialog.open()


def _taken(job: Any, path: Path, unit_mm: float) -> tuple[list[Any], list[str]]:
    """Add the tools of a file as one undo step, or as part of the one that is open; nothing where it is refused."""
    import FreeCAD

    from CNCStepper.workbench import api

    if FreeCAD.getActiveTransaction() is not None:
        return api.import_tools(job, path, unit_mm)
    undo_steps.begin(job.Document, tr("Import tools"))
    try:
        taken = api.import_tools(job, path, unit_mm)
    except Exception:
        job.Document.abortTransaction()
        raise
    job.Document.commitTransaction()
    job.Document.recompute()
    return taken


def _tell(taken: tuple[list[Any], list[str]]) -> None:
    tools, notes = taken
    told = tr("{0} tools imported").format(len(tools))
    if notes:
        notice(told, "\n".join(map(translated, notes)))
    else:
        note(told)


def _folder(job: Any) -> str:
    """Return where the file is looked for first: beside the document."""
    return str(Path(job.Document.FileName).parent) if job.Document.FileName else str(Path.home())
