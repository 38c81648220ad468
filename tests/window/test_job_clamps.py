# SPDX-License-Identifier: LGPL-2.1-or-later
"""Clamps, edge margin and the stock's form in a job's panel, with real keys and clicks, and how they are drawn."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from FreeCAD import Rotation, Vector
from PySide import QtGui

from CNCStepper.workbench import api, panels
from window_helpers import screen_places as places
from window_helpers.hand import Hand

P = "CNCStepper_Panel"
ADD, REMOVE = f"{P}_clamps_add", f"{P}_clamps_remove"
CLICKS = 4


class Bench:
    """A job with a pocket, two blocks that hold the sheet, one of them turned, and a sketch."""

    def __init__(self) -> None:
        self.document = FreeCAD.newDocument("Clamps")
        self.document.UndoMode = 1
        self.job = api.new_job(self.document, stock_size_mm=(120, 80, 12))
        api.add_tool(self.job, diameter_mm=6)
        api.add_elliptical_pocket(self.job, radius_x_mm=40, radius_y_mm=25, depth_mm=3)
        self.blocks = [self._block("Front clamp", (-10, -48, -4), 0), self._block("Side clamp", (48, -8, -4), 30)]
        self.sketch = self.document.addObject("Sketcher::SketchObject", "Sketch")
        self.document.recompute()
        self.document.clearUndos()
        FreeCADGui.ActiveDocument.ActiveView.viewIsometric()
        FreeCADGui.SendMsgToActiveView("ViewFit")

    def _block(self, label: str, at: tuple[float, float, float], turn_deg: float) -> Any:
        block = self.document.addObject("Part::Box", "Block")
        block.Label, block.Length, block.Width, block.Height = label, 24, 16, 12
        block.Placement = FreeCAD.Placement(Vector(*at), Rotation(Vector(0, 0, 1), turn_deg))
        return block

    def select(self, *objects: Any) -> None:
        FreeCADGui.Selection.clearSelection()
        for obj in objects:
            FreeCADGui.Selection.addSelection(obj)


@pytest.fixture
def bench(hand: Hand) -> Iterator[Bench]:
    yield hand.main(Bench)
    hand.main(FreeCADGui.Control.closeDialog)
    hand.main(FreeCAD.closeDocument, "Clamps")


def open_panel(hand: Hand, job: Any) -> None:
    hand.main(panels.edit, job)
    hand.wait(keyboard_in_panel, what="the panel with the keyboard")
    hand.settle()


def keyboard_in_panel() -> bool:
    focus = QtGui.QApplication.focusWidget()
    return focus is not None and focus.objectName().startswith(P)


def show(hand: Hand, name: str) -> None:
    """Scroll the panel to a widget."""
    hand.main(lambda: places.scroll_to(places.find(name)))
    hand.settle()


def click(hand: Hand, name: str, done: Callable[[], Any]) -> None:
    """Click a button until it has done its work: FreeCAD 1.1 lets clicks fall through a panel that has just grown."""
    for _ in range(CLICKS):
        show(hand, name)
        hand.click(name)
        try:
            hand.wait(done, 3)
            return
        except AssertionError:
            print(f"{name} is clicked again", flush=True)
    hand.wait(done, 1, f"what {name} does")


def note() -> str:
    return str(places.find(f"{P}_clamps_error").text()) if places.visible(f"{P}_clamps_error") else ""


def rows(hand: Hand) -> list[str]:
    def texts() -> list[str]:
        clamps = places.find(f"{P}_clamps")
        return [clamps.item(row).text() for row in range(clamps.count())]

    return hand.main(texts)


def test_clamps_are_taken_from_the_selection_and_let_go(hand: Hand, bench: Bench) -> None:
    front, side = bench.blocks
    open_panel(hand, bench.job)
    click(hand, f"{P}_group_clamps", lambda: places.visible(ADD))
    click(hand, ADD, lambda: "Select one or more solids" in note())
    hand.main(bench.select, bench.sketch)
    click(hand, ADD, lambda: "no solid" in note())
    hand.main(bench.select, front, side)
    click(hand, ADD, lambda: list(bench.job.Clamps) == [front, side])
    assert rows(hand) == ["1  Front clamp", "2  Side clamp"] and hand.main(note) == ""
    hand.wait(lambda: len(api.job_model(bench.job).clamps) == 2, what="the clamps of the job as it is made")
    hand.shot("panel-job-clamps")
    hand.item(f"{P}_clamps", "1  Front clamp")
    click(hand, REMOVE, lambda: list(bench.job.Clamps) == [side])
    assert rows(hand) == ["1  Side clamp"]
    hand.click(f"{P}_ok")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog())
    assert hand.main(lambda: (bench.document.UndoCount, front in bench.document.Objects)) == (1, True)
    hand.undo()
    hand.wait(lambda: list(bench.job.Clamps) == [])
    hand.wait(lambda: api.job_model(bench.job).clamps == [])


def test_form_and_edge_are_chosen_and_typed(hand: Hand, bench: Bench) -> None:
    open_panel(hand, bench.job)
    show(hand, f"{P}_stock_form")
    hand.choose(f"{P}_stock_form", "cylinder")
    hand.wait(lambda: bench.job.StockForm == "cylinder")
    hand.wait(lambda: not places.visible(f"{P}_stock_size_mm_y"))
    hand.fill(f"{P}_stock_size_mm_x", "110")
    hand.wait(lambda: api.job_model(bench.job).stock.size_mm == (110, 110, 12))
    hand.fill(f"{P}_edge_mm", "4 mm + 1 mm")
    hand.wait(lambda: bench.job.EdgeMargin.Value == 5)
    hand.shot("panel-job-cylinder")
    hand.fill(f"{P}_edge_mm", "-1")
    hand.wait(lambda: places.visible(f"{P}_edge_mm_error"), what="the note")
    assert hand.main(lambda: (bench.job.EdgeMargin.Value, bool(api.program_text(bench.job)))) == (5, True)
    hand.fill(f"{P}_edge_mm", "2,5")
    hand.wait(lambda: bench.job.EdgeMargin.Value == 2.5)
    hand.choose(f"{P}_stock_form", "sheet")
    hand.wait(lambda: api.job_model(bench.job).stock.size_mm == (110, 80, 12))
    hand.click(f"{P}_ok")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog())
    assert hand.main(lambda: bench.document.UndoCount) == 1
    hand.undo()
    hand.wait(lambda: (bench.job.StockForm, bench.job.EdgeMargin.Value) == ("box", 0))
    assert hand.main(lambda: tuple(bench.job.StockSize)) == (120, 80, 12)


def bounds(job: Any) -> tuple[float, ...]:
    """Return the bounds of what the job draws, x0 y0 z0 x1 y1 z1."""
    import pivy.coin as coin

    look = coin.SoGetBoundingBoxAction(coin.SbViewportRegion(100, 100))
    look.apply(job.ViewObject.RootNode)
    box = look.getBoundingBox()
    return tuple(value for corner in (box.getMin(), box.getMax()) for value in corner.getValue())


def test_clamps_are_drawn_and_follow_their_solids(hand: Hand, bench: Bench) -> None:
    front, side = bench.blocks
    hand.main(lambda: api.edit(bench.job, clamps=[front, side], edge_mm=6))
    hand.main(bench.document.recompute)
    assert hand.main(bounds, bench.job) == pytest.approx((-60, -48, -12, 69, 40, 8), abs=0.3)
    hand.main(FreeCADGui.Selection.clearSelection)
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    hand.shot("clamps-in-view")
    hand.main(lambda: setattr(front.Placement, "Base", Vector(-100, -48, 30)))
    hand.main(bench.document.recompute)
    assert hand.main(bounds, bench.job)[0] == pytest.approx(-100)
    assert hand.main(bounds, bench.job)[5] == pytest.approx(42)


def test_a_cylinder_is_drawn_round(hand: Hand, bench: Bench) -> None:
    hand.main(lambda: api.edit(bench.job, stock_form="cylinder", stock_size_mm=(110, 1, 20), edge_mm=6))
    hand.main(bench.document.recompute)
    assert hand.main(bounds, bench.job) == pytest.approx((-55, -55, -20, 55, 55, 0))
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    hand.shot("stock-cylinder")
