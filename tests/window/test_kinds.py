# SPDX-License-Identifier: LGPL-2.1-or-later
"""The other kinds of windows are what they are called, and the workbench opens in them."""

from __future__ import annotations

import importlib.util

import FreeCADGui
import pytest
from hand import Hand
from PySide import QtGui


@pytest.mark.window("scaled")
def test_a_scaled_window_has_twice_the_pixels(hand: Hand) -> None:
    assert hand.main(lambda: QtGui.QApplication.primaryScreen().devicePixelRatio()) == pytest.approx(2, abs=0.1)
    hand.shot("window")


@pytest.mark.window("portuguese")
def test_freecad_speaks_portuguese(hand: Hand) -> None:
    hand.menu("Arquivo")
    hand.shot("menu")
    hand.key("Esc")


@pytest.mark.window("bare")
def test_the_workbench_opens_without_packages(hand: Hand) -> None:
    for name in ("numba", "serial", "shapely"):
        assert importlib.util.find_spec(name) is None
    assert hand.main(lambda: FreeCADGui.activeWorkbench().name()) == "CNCStepperWorkbench"
    hand.shot("window")
