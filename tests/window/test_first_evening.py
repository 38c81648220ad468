# SPDX-License-Identifier: LGPL-2.1-or-later
"""What stopped a designer's first evening: tools that do not suit, a V-bit's angle, untyped feeds, jumping rows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCAD
import FreeCADGui
import Part
import pytest
from FreeCAD import Vector
from PySide import QtGui
from test_cycle_panels import accept, begin, cut_off, the
from test_dock import D, connected, dock, own_sessions, pocket, says, zeroed  # noqa: F401

from CNCStepper.workbench.panels.tools.tool_words import tool_words
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.translation import tr
from window_helpers import screen_places as places
from window_helpers.hand import Hand

P = "CNCStepper_Panel_"
BOTH = pytest.mark.window("plain", "portuguese")


def draw() -> None:
    document = FreeCAD.newDocument("Evening")
    document.UndoMode = 1
    sketch = document.addObject("Sketcher::SketchObject", "Sketch")
    sketch.Label = "Round"
    sketch.addGeometry(Part.Circle(Vector(0, 0, 0), Vector(0, 0, 1), 20), False)
    document.recompute()
    FreeCADGui.Selection.clearSelection()
    FreeCADGui.SendMsgToActiveView("ViewFit")


@pytest.fixture
def document(hand: Hand) -> Iterator[Any]:
    hand.main(draw)
    yield
    hand.main(FreeCADGui.Control.closeDialog)


def says_of(hand: Hand, key: str) -> str:
    return hand.text(f"{P}{key}_error") if hand.exists(f"{P}{key}_error") else ""


def tools() -> list[Any]:
    return list(the("Job").Tools)


@BOTH
def test_a_v_bit_is_asked_for_its_angle_and_never_preset_for_a_pocket(hand: Hand, document: None) -> None:
    begin(hand, "CNCStepper_NewJob", "Round")
    hand.click(f"{P}tools_add")
    hand.wait(lambda: len(tools()) == 2, 10, "the second tool")
    assert not hand.exists(f"{P}tip_angle_60")
    hand.choose(f"{P}shape", hand.main(words_of, "v"))
    hand.wait(lambda: hand.exists(f"{P}tip_angle_60"), 10, "the question for the angle")
    hand.settle()
    hand.shot("evening-v-bit")
    hand.settle()
    hand.wait(lambda: cut_off() == [], 5, "a panel of which nothing is cut off")
    hand.click(f"{P}tip_angle_60")
    hand.wait(lambda: tools()[1].TipAngle == 60, 10, "the angle")
    hand.wait(lambda: not hand.exists(f"{P}tip_angle_60"), 5, "the question to go")
    assert hand.main(lambda: tools()[1].Label) == f"T2 {hand.main(words_of, 'v')} 6 mm 60°"
    assert hand.main(lambda: tools()[0].Label).startswith("T1 ")
    assert hand.main(lambda: tools()[1].ViewObject.Proxy.icon_name()) == "CNCStepper_Tool_v"
    accept(hand)

    begin(hand, "CNCStepper_Pocket", "Round")
    cut = hand.main(the, "Pocket")
    assert hand.main(lambda: cut.Tool.Number) == 1  # the last that suits, though the V-bit is the last of the job
    hand.choose(f"{P}tool", hand.main(lambda: tool_words(tools()[1])))
    hand.wait(lambda: says_of(hand, "tool"), 20, "the note beside the tool")
    hand.shot("evening-unsuited-tool")
    hand.settle()
    hand.wait(lambda: cut_off() == [], 5, "a panel of which nothing is cut off")
    hand.click(f"{P}remedy_tool")
    hand.wait(lambda: not says_of(hand, "tool"), 20, "the note to go")
    assert hand.main(lambda: cut.Tool.Number) == 1
    accept(hand)


@BOTH
def test_a_warning_has_its_remedy_as_a_button(hand: Hand, document: None) -> None:
    begin(hand, "CNCStepper_NewJob", "Round")
    accept(hand)
    begin(hand, "CNCStepper_Pocket", "Round")
    cut, job = hand.main(the, "Pocket"), hand.main(the, "Job")
    hand.fill(f"{P}depth_mm", "27")
    hand.wait(lambda: hand.exists(f"{P}remedy_depth_mm"), 20, "the remedy of the depth")
    hand.shot("evening-too-deep")
    hand.settle()
    hand.wait(lambda: cut_off() == [], 5, "a panel of which nothing is cut off")
    hand.click(f"{P}remedy_depth_mm")
    hand.wait(lambda: cut.Depth.Value == job.StockSize[2] == 20, 20, "the depth of the stock")
    hand.wait(lambda: not hand.exists(f"{P}remedy_depth_mm"), 10, "the remedy to go")
    hand.fill(f"{P}stepover_mm", "7")
    hand.wait(lambda: hand.exists(f"{P}remedy_stepover_mm"), 20, "the remedy of the width")
    hand.click(f"{P}remedy_stepover_mm")
    hand.wait(lambda: cut.Stepover.Value == pytest.approx(2.4) and not says_of(hand, "stepover_mm"), 20, "the width")
    accept(hand)


def test_the_stock_is_fitted_to_what_lies_beside_it(hand: Hand, document: None) -> None:
    begin(hand, "CNCStepper_NewJob")  # the usual stock, which does not reach so far
    accept(hand)
    job = hand.main(the, "Job")
    hand.main(lambda: setattr(job, "WorkOrigin", (60, 0, 0)) or job.Document.recompute())
    begin(hand, "CNCStepper_Pocket", "Round")
    hand.wait(lambda: hand.exists(f"{P}remedy_stock"), 20, "the remedy of the stock")
    hand.click(f"{P}remedy_stock")
    hand.wait(lambda: not hand.exists(f"{P}remedy_stock"), 20, "the remedy to go")
    assert hand.main(lambda: tuple(job.StockSize)) == pytest.approx((60, 60, 20), abs=0.1)
    assert hand.main(lambda: tuple(job.WorkOrigin)) == pytest.approx((0, 0, 0), abs=0.1)
    accept(hand)


@BOTH
def test_a_material_gives_the_feeds_that_nobody_has_typed(hand: Hand, document: None) -> None:
    begin(hand, "CNCStepper_NewJob", "Round")
    hand.click(f"{P}tools_add")
    hand.wait(lambda: len(tools()) == 2, 10, "the second tool")
    hand.fill(f"{P}feed_mm_min", "555")
    hand.wait(lambda: tools()[1].Feed.getValueAs("mm/min") == pytest.approx(555), 10, "the feed that is typed")
    assert hand.main(lambda: f"{tr('Cutting table A')} (table-a)" == combo_text("machine"))
    hand.choose(f"{P}material", hand.main(words_of, "plywood"))
    hand.wait(lambda: tools()[0].Feed.Value == tools()[0].SpindleSpeed == 0, 10, "the material's values")
    assert hand.main(lambda: [tool.Feed.getValueAs("mm/min") for tool in tools()]) == [0, pytest.approx(555)]
    hand.wait(lambda: tools()[0].FeedUsed.Value > 0 and tools()[1].PlungeUsed.Value > 0, 20, "the feeds in use")
    hand.shot("evening-material")
    hand.choose(f"{P}material", hand.main(tr, "not given"))
    hand.wait(lambda: tools()[0].Feed.getValueAs("mm/min") == pytest.approx(800), 10, "a new tool's values again")
    accept(hand)


def draw_across() -> None:
    """Draw a circle that crosses the one that is there."""
    sketch = FreeCAD.ActiveDocument.addObject("Sketcher::SketchObject", "Across")
    sketch.addGeometry(Part.Circle(Vector(18, 0, 0), Vector(0, 0, 1), 12), False)
    FreeCAD.ActiveDocument.recompute()


def test_why_a_long_panel_stays_open_is_seen(hand: Hand, document: None) -> None:
    hand.main(draw_across)
    begin(hand, "CNCStepper_NewJob", "Round")
    accept(hand)
    hand.tree("Round")
    hand.tree("Across", modifiers=("Ctrl",))
    hand.command("CNCStepper_Pocket")
    hand.wait(lambda: hand.exists(f"{P}problem"), 20, "the refusal")
    hand.click(f"{P}ok")
    hand.wait(lambda: not places.find(f"{P}problem").visibleRegion().isEmpty(), 20, "the refusal in sight")
    hand.shot("evening-refused-ok")


def combo_text(key: str) -> str:
    return str(FreeCADGui.getMainWindow().findChild(QtGui.QComboBox, f"{P}{key}").currentText())


def rows(panel: Any) -> tuple[Any, ...]:
    """Return the dock's width and the places of its rows."""
    names = ("Lines", "Buffer", "ProgramLine", "Elapsed", "WorkX", "JogXPlus", "Home", "Hold")
    found = [panel.findChild(QtGui.QWidget, f"{D}{name}") for name in names]
    return panel.width(), *((widget.mapTo(panel, widget.rect().topLeft()).y(), widget.height()) for widget in found)


def test_rows_and_width_of_the_dock_stay_while_a_job_is_cut(hand: Hand, dock: Any) -> None:  # noqa: F811
    pocket(hand)
    connected(hand)
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 240, "the work zero")
    zeroed(hand)
    hand.click(f"{D}Start")
    hand.wait(lambda: dock.link.status.acknowledged > 20, 60, "the first cuts")
    seen, shown_s = set(), []

    def look() -> bool:
        seen.add(rows(dock))
        shown_s.append(dock.link.status.remaining_s)
        return dock.link.status.acknowledged > 0.6 * dock.link.status.total

    hand.wait(look, 120, "most of the cut")
    assert len(seen) == 1, seen
    assert len(set(shown_s)) > 5 and shown_s == sorted(shown_s, reverse=True)
    hand.shot("evening-dock")
