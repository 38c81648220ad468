# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller's dock as tests open it and leave it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import FreeCADGui
from PySide import QtGui

from CNCStepper.workbench.dock.model.port_choices import VIRTUAL
from window_helpers.hand import Hand


@contextmanager
def opened_dock(hand: Hand, at_end: Callable[[Any], None]) -> Iterator[Any]:
    """Give the dock's panel; at the end it is disconnected, `at_end` called with it, its profile that of before."""
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock"))
    shown = hand.main(FreeCADGui.getMainWindow().findChild, QtGui.QDockWidget, "CNCStepper_Dock")
    panel = hand.main(shown.widget)
    before = hand.main(lambda: panel.connection.profile)
    yield panel

    def end() -> None:
        panel.sending.away()
        panel.link.leave()
        at_end(panel)
        panel.connection.machine.setCurrentText(before)
        panel.connection.look(VIRTUAL)
        panel.refresh()
        shown.close()

    hand.main(end)


@contextmanager
def one_run(hand: Hand, bench: Any) -> Iterator[None]:
    """Let a machine test be started inside, and wait until all its lines are answered and the machine stands.

    At ten times its speed the machine may be there before anybody looks whether it moves.
    """
    before = hand.main(lambda: bench.answered)
    yield
    hand.wait(lambda: bench.trouble or (bench.answered is not before and not bench.why_not()), 30, "the test's end")
    assert hand.main(lambda: bench.trouble) == ""
