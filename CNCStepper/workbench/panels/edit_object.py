# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening the panel of an object that is there already."""

from __future__ import annotations

from typing import Any


def edit(obj: Any) -> None:
    """Open an object's panel inside a transaction, which the panel commits or aborts; one that is open stays."""
    from CNCStepper.workbench import freehand
    from CNCStepper.workbench.document import targets
    from CNCStepper.workbench.panels import open_panel
    from CNCStepper.workbench.services import messages
    from CNCStepper.workbench.services.translation import tr

    if reason := targets.why_no_panel():
        messages.note(reason)
        return
    freehand.leave()
    obj.Document.openTransaction(tr("Edit {0}").format(obj.Label))
    try:
        open_panel(obj)
    except Exception:
        obj.Document.abortTransaction()
        raise
