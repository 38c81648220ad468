# SPDX-License-Identifier: LGPL-2.1-or-later
"""The other kinds of windows are what they are called, and the workbench opens in them."""

from __future__ import annotations

import importlib.util

import FreeCADGui
import pytest
from PySide import QtGui
from test_language import shown_texts

from window_helpers.hand import Hand


@pytest.mark.window("scaled")
def test_a_scaled_window_has_twice_the_pixels(hand: Hand) -> None:
    assert hand.main(lambda: QtGui.QApplication.primaryScreen().devicePixelRatio()) == pytest.approx(2, abs=0.1)
    hand.shot("window")


@pytest.mark.window("portuguese")
def test_freecad_speaks_portuguese(hand: Hand) -> None:
    hand.menu("Arquivo")
    hand.shot("menu")
    hand.key("Esc")


@pytest.mark.window("portuguese")
def test_the_panel_of_a_window_that_began_in_portuguese_is_portuguese(hand: Hand) -> None:
    def dock() -> QtGui.QDockWidget:
        return FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock")

    hand.command("CNCStepper_Controller")
    hand.wait(lambda: dock() is not None and dock().isVisible())
    hand.settle()
    texts = hand.main(lambda: shown_texts(dock()))
    hand.shot("dock-portuguese")
    hand.main(lambda: dock().hide())
    assert "Desconectado" in texts
    assert not texts & {"Hold", "Resume", "Stop", "Home", "Restart…", "Disconnected"}


@pytest.mark.window("bare")
def test_the_workbench_opens_without_packages(hand: Hand) -> None:
    for name in ("numba", "serial", "shapely"):
        assert importlib.util.find_spec(name) is None
    assert hand.main(lambda: FreeCADGui.activeWorkbench().name()) == "CNCStepperWorkbench"
    hand.shot("window")
