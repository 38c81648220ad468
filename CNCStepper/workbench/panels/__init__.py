# SPDX-License-Identifier: LGPL-2.1-or-later
"""The task panels: one for each of our objects that can be edited."""

from __future__ import annotations

import gc
from typing import Any

from CNCStepper.workbench.document import undo_steps
from CNCStepper.workbench.services.translation import tr


def open_panel(obj: Any) -> None:
    """Show the task panel of a job, tool, operation or freehand line inside the transaction that is open.

    OK keeps the changes as one undo step, Cancel takes them back, a newly made object with them. Where no
    transaction is open yet, one is opened. Raises MissingPackage when the object's values cannot be judged.
    """
    import FreeCAD
    import FreeCADGui

    from CNCStepper.workbench import packages

    packages.require()
    from CNCStepper.workbench.panels.catalogue import panel_of

    _leave_what_is_loaded()  # before a person types
    if FreeCAD.getActiveTransaction() is None:
        undo_steps.begin(obj.Document, tr("Edit {0}").format(obj.Label))
    panel = panel_of(obj)
    FreeCADGui.Control.showDialog(panel)
    panel.focus_first()


def edit(obj: Any) -> None:
    """Open an object's panel inside a transaction, which the panel commits or aborts; one that is open stays."""
    from CNCStepper.workbench import freehand
    from CNCStepper.workbench.document import targets
    from CNCStepper.workbench.services import messages

    if reason := targets.why_no_panel():
        messages.note(reason)
        return
    freehand.leave()
    undo_steps.begin(obj.Document, tr("Edit {0}").format(obj.Label))
    try:
        open_panel(obj)
    except Exception:
        obj.Document.abortTransaction()
        raise


YOUNG = 1  # generations 0 and 1 of the collector
_collected: list[bool] = []


def _leave_what_is_loaded() -> None:
    """Exclude all that is loaded from Python's garbage collections; again changes nothing.

    A full collection looks at every container of the process, some 300 000 in FreeCAD's window, which takes longer
    than a key may. Nearly all of them stay for the whole session: modules, classes, functions. What is young is
    collected before; a full collection would keep the panel waiting for as long.
    """
    if not _collected:
        _collected.append(True)
        gc.collect(YOUNG)
        gc.freeze()
