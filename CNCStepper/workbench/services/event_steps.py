# SPDX-License-Identifier: LGPL-2.1-or-later
"""Long work of the window's thread in steps, between which the window sees to its events."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from PySide import QtCore

from CNCStepper.workbench.services.messages import guarded


def in_events(steps: Iterator[None], done: Callable[[], object]) -> None:
    """Take one step in each of the next events, then call `done` in one of its own; return at once."""

    def step() -> None:
        try:
            next(steps)
        except StopIteration:
            done()
        else:
            QtCore.QTimer.singleShot(0, guarded(step))

    QtCore.QTimer.singleShot(0, guarded(step))
