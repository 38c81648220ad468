# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller's dock: `show()` opens it, `send(job)` sends a job from it. Nothing of Qt is loaded before."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from CNCStepper.recovery.restart.restart_proof_folder import RestartPlace


def show() -> Any:
    """Open the dock, attached to a machine that a window before this one left connected; return it."""
    from CNCStepper.workbench.dock.window import open_dock

    return open_dock()


def send(job: Any, place: RestartPlace | None = None) -> None:
    """Open the dock and begin to send a job object: check, connect, ask for the work zero, stream. Returns at once.

    place: where it is to be restarted, None for the whole program.
    """
    from CNCStepper.workbench.dock import window

    window.send(job, place)


def open_if_connected() -> None:
    """Open the dock where a machine was left connected by a window before this one; else do nothing."""
    import importlib.util

    from CNCStepper.control.session.files import running_services

    # Where platformdirs is missing nothing was ever connected; what is missing is said elsewhere.
    if importlib.util.find_spec("platformdirs") and running_services():
        from CNCStepper.workbench.dock.window import open_unless_connected

        open_unless_connected()
