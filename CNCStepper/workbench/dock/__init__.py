# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller's dock: `show()` opens it, `send(job)` sends a job from it. Nothing of Qt is loaded before."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.proof_folder import RestartPlace


def show() -> Any:
    """Open the dock, attached to a machine that a window before this one left connected; return it."""
    from CNCStepper.workbench.dock.window import open_dock

    return open_dock()


def send(job: Any, place: RestartPlace | None = None) -> None:
    """Open the dock and begin to send a job object: check, connect, ask for the work zero, stream. Returns at once.

    place: where it is to be restarted, None for the whole program.
    """
    show().widget().sending.send(job, place)


def start_here() -> Any:
    """Return the start state of the machine that this window is connected to, None where it is not known."""
    opened = sys.modules.get(f"{__name__}.window")  # no dock was ever opened before this is loaded
    return opened.start_here() if opened else None


def open_if_connected() -> None:
    """Open the dock where a machine was left connected by a window before this one; else do nothing."""
    import importlib.util

    from CNCStepper.control.session.files import running_services

    # Where platformdirs is missing nothing was ever connected; what is missing is said elsewhere.
    if importlib.util.find_spec("platformdirs") and running_services():
        from CNCStepper.workbench.dock.window import open_unless_connected

        open_unless_connected()
