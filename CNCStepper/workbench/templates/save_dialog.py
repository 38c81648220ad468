# SPDX-License-Identifier: LGPL-2.1-or-later
"""*Save as job template…*: asks for a name, and before it replaces a template of that name."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.job.templates.template_files import LONGEST, named_template
from CNCStepper.workbench.features.base import LATHE_JOB, proxy_type
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.standard_buttons import name_standard_buttons
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates import job_template, turning_template

NAME = "CNCStepper_JobTemplate"


def ask_to_save(job: Any) -> None:
    """Ask for the name of a job's template and return at once; the template is saved when it is given."""
    import FreeCADGui

    dialog = QtGui.QInputDialog(FreeCADGui.getMainWindow())
    dialog.setObjectName(NAME)
    dialog.setWindowTitle(tr("Save as job template"))
    dialog.setLabelText(tr("Name of the template"))
    dialog.setTextValue(str(job.Label)[:LONGEST])
    dialog.setOkButtonText(tr("OK"))  # Qt makes line and buttons for it
    dialog.findChild(QtGui.QLineEdit).setObjectName(f"{NAME}_name")
    name_standard_buttons(dialog.findChild(QtGui.QDialogButtonBox), NAME)
    dialog.resize(dialog.fontMetrics().averageCharWidth() * LONGEST, dialog.sizeHint().height())
    dialog.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
    document, name = job.Document.Name, job.Name
    dialog.textValueSelected.connect(guarded(lambda text: _save(document, name, text)))
    dialog.open()


def _save(document: str, job: str, name: str) -> None:
    """Save the template of a job under a name, unless a person keeps the one that has it."""
    import FreeCAD

    path = named_template(name)
    question = tr("There is a template '{0}' already. Replace it?").format(path.stem)
    more = tr("All of it is replaced, its rules and tools too.")
    if path.exists() and not messages.ask(question, tr("Replace"), tr("Cancel"), more):
        return
    saved = FreeCAD.getDocument(document).getObject(job)
    (turning_template if proxy_type(saved) == LATHE_JOB else job_template).save(saved, path)
    note(tr("{0} was written").format(path))
