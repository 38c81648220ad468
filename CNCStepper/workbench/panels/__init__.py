# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels: one for each of our objects that can be edited."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.services.translation import tr


def open_panel(obj: Any) -> None:
    """Show the task panel of a job, tool, operation or freehand line inside the transaction that is open.

    OK keeps the changes as one undo step, Cancel takes them back, a newly made object with them. Where no
    transaction is open yet, one is opened. Raises MissingPackage when the object's values cannot be judged.
    """
    import FreeCAD
    import FreeCADGui

    from CNCStepper.workbench import packages
    from CNCStepper.workbench.services import garbage_collection

    packages.require()
    from CNCStepper.workbench.panels.catalogue import panel_of

    garbage_collection.leave_what_is_loaded()  # before a person types
    if FreeCAD.getActiveTransaction() is None:
        obj.Document.openTransaction(tr("Edit {0}").format(obj.Label))
    panel = panel_of(obj)
    FreeCADGui.Control.showDialog(panel)
    panel.focus_first()
