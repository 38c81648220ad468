# SPDX-License-Identifier: LGPL-2.1-or-later
"""A value that makes no sense, or a cut that takes long, set as FreeCAD's property editor sets it, never freezes it."""

from __future__ import annotations

from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from PySide import QtGui
from test_typing import hidden_view

from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of
from CNCStepper.workbench.services import jit_guard
from window_helpers.hand import Hand

REFUSED_MS = 50.0  # of processor time in which FreeCAD recomputes a document without any cut; measured 5 to 11
MOST_CUT_S = 0.02  # of a cut in the window, in place of jit_guard's
SPARE_MS = 30.0  # of a recompute besides the one cut that is ended; measured 6 to 15


def draw() -> Any:
    """Make a job with a pocket in a plate."""
    document = FreeCAD.newDocument("Editor")
    plate = document.addObject("Part::Feature", "Outline")
    corners = ((-60, -40), (60, -40), (60, 40), (-60, 40), (-60, -40))
    plate.Shape = Part.makePolygon([Vector(*corner, 0) for corner in corners])
    job = api.new_job(document, stock_size_mm=(150, 100, 20))
    api.add_tool(job, diameter_mm=6)
    api.add_operation(job, "pocket", plate, depth_mm=2)
    document.recompute()
    return job


@pytest.fixture
def job(hand: Hand) -> Any:
    """The job when its program is there."""
    made = hand.main(draw, limit_s=120)
    hand.wait(lambda: not made.Message, 120, "the program")
    return made


def set_and_recompute(obj: Any, name: str, value: Any) -> Any:
    """Do what FreeCAD's property editor does with a value; return the refusal at that moment."""
    setattr(obj, name, value)
    obj.Document.recompute()
    return obj.Proxy.refusal


@pytest.mark.parametrize(
    "name, value, beyond",
    [
        ("Depth", "10 m", "depth_mm goes far beyond the stock"),
        ("Stepdown", "1 m", "stepdown_mm goes far beyond the stock"),
        ("StockToLeave", "9 m", "stock_to_leave_mm goes far beyond"),
    ],
)
def test_an_absurd_value_is_refused_before_anything_is_computed(
    hand: Hand, job: Any, name: str, value: str, beyond: str
) -> None:
    pocket = job.Operations[0]
    before = getattr(pocket, name)
    with hidden_view(hand), hand.watchdog() as watch:
        hand.main(set_and_recompute, pocket, name, value)
        problem, message = hand.main(lambda: (problem_of(pocket), job.Message))
    print(f"{name} = {value}: {watch}".partition(" in\n")[0], flush=True)
    assert beyond in problem and beyond in message
    assert watch.max_cpu_ms < REFUSED_MS, watch
    hand.main(set_and_recompute, pocket, name, before)
    hand.wait(lambda: not problem_of(pocket) and not job.Message, 60, "the pocket")


def test_a_cut_that_takes_long_is_ended_and_made_beside_the_window(
    hand: Hand, job: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(jit_guard, "MOST_S", MOST_CUT_S)
    monkeypatch.setattr(jit_guard, "loaded", True)
    pocket = job.Operations[0]
    with hidden_view(hand), hand.watchdog() as watch:
        refusal = hand.main(set_and_recompute, pocket, "Stepover", "0.05 mm")
    print(f"a long cut: {watch}".partition(" in\n")[0], flush=True)
    assert refusal is not None and refusal.code == jit_guard.LONG
    assert watch.max_cpu_ms < 1000 * MOST_CUT_S + SPARE_MS, watch
    hand.wait(lambda: not pocket.Proxy.refusal and not job.Message, 120, "the cut made beside the window")


def test_a_hidden_view_gets_its_place_back(hand: Hand) -> None:
    def width() -> int:
        return int(FreeCADGui.getMainWindow().findChild(QtGui.QMdiArea).width())

    before = hand.main(width)
    with hidden_view(hand):
        pass
    hand.wait(lambda: abs(width() - before) <= 2, 5, f"the view's {before} pixels")
