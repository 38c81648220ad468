# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first evening: the card comes once, examples open as documents, the tour follows a person to a cut part."""

from __future__ import annotations

from collections.abc import Iterator

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtGui
from test_language import PORTUGUESE, STARTED_IN, shown_texts
from test_road import DOCK, accept, ours, own_sessions, state, step  # noqa: F401

from CNCStepper.workbench import first_run
from CNCStepper.workbench.document import program_file, targets
from CNCStepper.workbench.first_run.card_setting import CLOSED, GROUP, was_closed
from CNCStepper.workbench.first_run.examples import EXAMPLES
from window_helpers import screen_places as places
from window_helpers.hand import Hand

CARD, TOUR = "CNCStepper_FirstSteps", "CNCStepper_Tour"
PLAYER = "CNCStepper_Simulation_"


@pytest.fixture(autouse=True)
def newcomer(hand: Hand) -> Iterator[None]:
    """Who has never closed the card; afterwards all is closed again."""
    hand.main(lambda: FreeCAD.ParamGet(GROUP).SetBool(CLOSED, False))
    yield

    def end() -> None:
        FreeCAD.ParamGet(GROUP).SetBool(CLOSED, True)
        window = FreeCADGui.getMainWindow()
        for shown in (*window.findChildren(QtGui.QDialog, CARD), *window.findChildren(QtGui.QDockWidget, TOUR)):
            shown.close()
            shown.deleteLater()
        for name in list(FreeCAD.listDocuments()):
            FreeCAD.closeDocument(name)

    hand.main(end)
    hand.settle()


def reopen() -> None:
    """Open the workbench as at FreeCAD's start."""
    FreeCADGui.activateWorkbench("PartWorkbench")
    FreeCADGui.activateWorkbench("CNCStepperWorkbench")


def place(hand: Hand) -> int:
    return int(hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, TOUR).tour.place))


def reached(hand: Hand, number: int) -> None:
    hand.wait(
        lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, TOUR).tour.place == number, 20, f"{number}"
    )


def test_the_card_comes_until_it_is_closed_and_by_the_menu(hand: Hand) -> None:
    hand.main(reopen)
    hand.wait(lambda: hand.exists(CARD), 10, "the card")
    hand.shot("first-steps", CARD)
    hand.click(f"{CARD}_close")
    hand.wait(lambda: not hand.exists(CARD))
    assert hand.main(was_closed)
    hand.main(reopen)
    hand.settle()
    assert not hand.exists(CARD)
    hand.menu("CNCStepper", "First steps")
    hand.wait(lambda: hand.exists(CARD))
    hand.click(f"{CARD}_machine")
    hand.wait(lambda: hand.exists("CNCStepper_Assistant"), 20, "the assistant")
    hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDialog, "CNCStepper_Assistant").close())


@pytest.mark.parametrize("number", [0, len(EXAMPLES) - 1])
def test_an_example_is_two_clicks(hand: Hand, number: int) -> None:
    example = EXAMPLES[number]
    hand.main(first_run.open_card)
    hand.wait(lambda: hand.exists(f"{CARD}_example"))
    hand._click_place(hand._place(places.of_widget, f"{CARD}_example", None))
    hand.wait(lambda: places.popup_entry(example.title))
    hand.shot("first-steps-examples")
    hand._click_place(hand.main(places.popup_entry, example.title))
    hand.wait(lambda: targets.jobs() and program_file.load(targets.jobs()[0]), 120, "the program")
    job = hand.main(lambda: targets.jobs()[0])
    assert hand.main(lambda: (job.Label, job.Document.UndoNames)) == (example.path.stem, [example.title])
    hand.shot(f"example-{example.path.stem}")


def test_the_tour_follows_a_person_to_a_cut_part(hand: Hand) -> None:
    hand.main(first_run.open_card)
    hand.click(f"{CARD}_try")
    hand.wait(lambda: hand.exists(f"{TOUR}_do"), 10, "the tour")
    assert hand.text(f"{TOUR}_do") == "New job"
    hand.shot("tour-1")
    hand.click(f"{TOUR}_do")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_ok"), 20, "the job's panel")
    accept(hand)
    reached(hand, 1)
    hand.click(f"{TOUR}_do")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_ok"), 20, "the text's panel")
    accept(hand)
    reached(hand, 2)
    (text,) = hand.main(ours, "Text")
    hand.tree(hand.main(lambda: text.Label))
    hand.click(f"{TOUR}_do")
    hand.wait(lambda: hand.exists("CNCStepper_Panel_depth_mm"), 20, "the engraving's panel")
    accept(hand)
    reached(hand, 3)
    hand.shot("tour-4")
    hand.click(f"{TOUR}_do")
    hand.wait(lambda: hand.exists(f"{PLAYER}play") and hand.find(f"{PLAYER}play").isEnabled(), 180, "the simulation")
    reached(hand, 4)
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10)
    cut(hand)


def cut(hand: Hand) -> None:
    """Send the part to the virtual machine; the tour sees it connected, cutting and done."""
    hand.click(f"{TOUR}_do")
    step(hand, "Connect")
    hand.choose(f"{DOCK}Speed", "10× speed")
    hand.click(f"{DOCK}Start")
    step(hand, "Work zero")
    reached(hand, 5)
    hand.click(f"{DOCK}ZeroAll")
    hand.wait(lambda: hand.find(f"{DOCK}Start").isEnabled(), 10, "Start")
    hand.click(f"{DOCK}Start")
    reached(hand, 6)
    hand.shot("tour-7")
    step(hand, "Done")
    reached(hand, 7)
    assert "first part is cut" in hand.text(f"{TOUR}_text")
    hand.shot("tour-end")
    hand.click(f"{DOCK}Cancel")
    hand.click(f"{DOCK}Connect")
    state(hand, "Not connected")
    hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock").close())


def test_card_and_tour_are_portuguese(hand: Hand) -> None:
    hand.main(FreeCADGui.setLocale, PORTUGUESE)
    try:
        card = hand.main(first_run.open_card)
        hand.settle()
        hand.shot("first-steps-portuguese", CARD)
        assert "Experimentar sem máquina" in hand.main(lambda: shown_texts(card))
        hand.click(f"{CARD}_try")
        hand.wait(lambda: hand.exists(f"{TOUR}_do"), 10, "the tour")
        assert hand.text(f"{TOUR}_do") == "Novo trabalho"
        hand.shot("tour-portuguese")
    finally:
        hand.main(FreeCADGui.setLocale, STARTED_IN)
