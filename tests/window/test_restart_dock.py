# SPDX-License-Identifier: LGPL-2.1-or-later
"""A restart chosen in the window: from the list, from the picture, by line, and after a sender that was killed."""

from __future__ import annotations

import gc
import os
import re
import signal
import weakref
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui
from test_dock import LONGEST_MS, D, dock, own_sessions, start_button, zeroed  # noqa: F401

from CNCStepper.control.session.files import read_private, running_services
from CNCStepper.workbench import api, restart
from CNCStepper.workbench.dock import virtual_controller
from CNCStepper.workbench.dock.views.widgets import BREAK
from window_helpers.hand import Hand

R = "CNCStepper_Restart_"
START_S = 240  # a process whose kernels are not compiled yet
CUT_LINE = 150  # in the second pocket


@pytest.fixture
def job(hand: Hand) -> Any:
    """Two pockets beside each other."""

    def make() -> Any:
        document = FreeCAD.newDocument("Pockets")
        made = api.new_job(document, machine="table-a", stock_size_mm=(100, 70, 20))
        cutter = api.add_tool(made, number=1, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200)
        for x_mm in (-25.0, 25.0):
            sizes = {"radius_x_mm": 12, "radius_y_mm": 9, "depth_mm": 2.0}
            api.add_elliptical_pocket(made, tool=cutter, centre_mm=(x_mm, 0.0, 0.0), **sizes)
        made.Label = "Two pockets"
        document.recompute()
        FreeCADGui.activeDocument().activeView().fitAll()
        return made

    return hand.main(make)


def opened(hand: Hand) -> None:
    """Click Restart…, and wait for the list of places."""
    hand.click(f"{D}Restart")
    hand.wait(lambda: hand.exists(f"{R}places") and hand.find(f"{R}places").rows, START_S, "the list of places")


def proven(hand: Hand) -> str:
    hand.wait(lambda: hand.find(f"{R}send").isEnabled(), START_S, "the proof of the restart")
    return hand.text(f"{R}words")


def typed(hand: Hand, dock: Any, line: str, answer: str) -> None:  # noqa: F811
    """Type a line in the console, and bring it back with the arrow key."""
    hand.click(f"{D}ConsoleLine")
    hand.key("Ctrl+A")  # the dock keeps what an earlier test has left
    hand.type(line)
    hand.key("Return")
    hand.wait(lambda: answer in dock.console.said.toPlainText(), 20, "the answer")
    hand.key("Up")
    assert hand.text(f"{D}ConsoleLine") == line
    hand.shot("restart-console")


def at_zero(hand: Hand) -> None:
    """Wait for the question for the zero, which nobody can say yes to before it is set."""
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), START_S, "the work zero")
    zeroed(hand)


def test_a_contour_is_chosen_from_the_list_and_the_rest_is_cut(hand: Hand, dock: Any, job: Any) -> None:  # noqa: F811
    opened(hand)
    assert not hand.main(hand.find(f"{R}send").isEnabled)
    hand.shot("restart-list")
    last = hand.main(lambda: hand.find(f"{R}places").rows[-1])
    hand.item(f"{R}places", f"Contour {last.number}")
    hand.fill(f"{R}overlap", "1")
    with hand.watchdog() as watch:
        words = proven(hand)
    assert watch.max_cpu_ms < LONGEST_MS, watch
    assert hand.text(f"{R}choice") == f"From contour {last.number}" and "everything before them counts as cut" in words
    hand.shot("restart-proven")
    hand.click(f"{R}gives_height")
    hand.fill(f"{R}height", "-1")
    hand.wait(lambda: "above the height that is given" in hand.text(f"{R}message"), START_S, "the refusal")
    hand.fill(f"{R}height", "12")
    assert "goes to Z 12.000 first" in proven(hand)
    hand.shot("restart-height")
    hand.choose(f"{D}Speed", "10× speed")
    hand.click(f"{R}send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Connect" in hand.text(f"{D}FlowTitle"), START_S, "the dock")
    assert not hand.exists(f"{R}panel") and "Two pockets, restart" in hand.text(f"{D}FlowTitle")
    hand.click(f"{D}Start")
    at_zero(hand)
    hand.click(f"{D}Start")
    hand.wait(lambda: "Done" in hand.text(f"{D}FlowTitle"), 120, "the end of the cut")


def test_a_place_is_clicked_in_the_picture_or_typed_as_a_line(hand: Hand, dock: Any, job: Any) -> None:  # noqa: F811
    opened(hand)
    cut_mm = hand.main(lambda: tuple(job.WorkOrigin + FreeCAD.Vector(-25 - 9, 0, -2)))  # where the cutter's middle goes
    hand.click_view(hand.view_point(*cut_mm))
    hand.wait(lambda: hand.text(f"{R}choice").startswith("From the place that was clicked"), 10, "the click")
    proven(hand)
    hand.shot("restart-picture")
    hand.fill(f"{R}line", str(hand.main(lambda: hand.find(f"{R}line").maximum())))
    hand.wait(lambda: "nothing moves at line" in hand.text(f"{R}message"), START_S, "the refusal")
    assert not hand.main(hand.find(f"{R}send").isEnabled)
    hand.shot("restart-refused")


def test_a_simulation_gives_its_moment(hand: Hand, job: Any) -> None:
    hand.main(FreeCADGui.Selection.addSelection, job)
    hand.command("CNCStepper_Simulate")
    hand.wait(lambda: hand.exists("CNCStepper_Simulation_restart"), START_S, "the simulation")
    program = hand.find("CNCStepper_Simulation_program")
    hand.wait(lambda: program.currentIndex().row() > CUT_LINE, START_S, "the simulation to stand at the program's end")
    hand.item(program, hand.main(lambda: program.model().index(CUT_LINE - 1, 0).data()))
    hand.click("CNCStepper_Simulation_restart")
    hand.wait(lambda: hand.exists(f"{R}choice") and hand.text(f"{R}choice"), START_S, "the restart")
    assert hand.text(f"{R}choice") == f"From line {CUT_LINE}" and hand.text(f"{R}line") == str(CUT_LINE)


class Restarts:
    """Opens and closes restarts by a timer: what pytest's thread holds would be kept until its test ends."""

    def __init__(self, job: Any, times: int):
        self.left, self.tasks, self._job = times, [], job
        self._timer = QtCore.QTimer()
        self._timer.timeout.connect(self._next)
        self._timer.start(20)

    def _next(self) -> None:
        panel = FreeCADGui.getMainWindow().findChild(QtGui.QWidget, f"{R}panel")
        if panel is None and self.left:
            self.tasks.append(weakref.ref(restart.open_restart(self._job, lambda *_: None, CUT_LINE)))
        elif panel is None:
            self._timer.stop()
        elif panel.findChild(QtGui.QWidget, f"{R}send").isEnabled():
            FreeCADGui.Control.closeDialog()
            self.left -= 1

    def kept(self) -> int:
        """Return how many tasks are still in memory."""
        gc.collect()
        return sum(task() is not None for task in self.tasks)


def test_a_restart_that_is_closed_leaves_nothing_in_memory(hand: Hand, job: Any) -> None:
    running = hand.main(Restarts, job, 2)
    hand.wait(lambda: not running.left and not running._timer.isActive(), START_S, "both restarts")
    assert hand.main(lambda: len(running.tasks)) == 2
    hand.wait(lambda: not running.kept(), 10, "the closed tasks to be forgotten")


def kill_the_service(machines: list[Any]) -> None:
    (service,) = running_services()
    os.kill(read_private(service)["process"], signal.SIGKILL)


def cut_the_link(machines: list[Any]) -> None:
    machines[-1].kill()  # the virtual controller goes, and the next one counts from where it is switched on


@pytest.fixture
def machines(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    """The processes of the virtual controllers that the dock starts."""
    started: list[Any] = []
    start = virtual_controller._started
    monkeypatch.setattr(virtual_controller, "_started", lambda *how: started.append(start(*how)) or started[-1])
    return started


def go_on_from_the_lost_link(hand: Hand) -> None:
    """The message of the lost link is plain, and its own button shows how far the job came."""
    hand.wait(lambda: hand.exists(f"{D}GoOn"), START_S, "the way on")
    sentence = hand.text(f"{D}StateSentence").replace(BREAK, "")
    assert not re.search(r"Errno|socket://|\[[a-z-]+\]", sentence), sentence
    hand.shot("dock-way-on")
    hand.click(f"{D}GoOn")
    hand.wait(lambda: hand.exists(f"{R}said"), START_S, "what the journal tells")
    hand.main(FreeCADGui.Control.closeDialog)
    hand.wait(lambda: not hand.exists(f"{R}panel"), 10, "the restart to close")


@pytest.mark.parametrize(("lose", "how"), [(kill_the_service, "Killed"), (cut_the_link, "Failed")])
def test_a_job_that_was_lost_is_offered_and_restarted_once_the_zero_is_set(
    hand: Hand,
    dock: Any,  # noqa: F811
    job: Any,
    machines: list[Any],
    lose: Any,
    how: str,
) -> None:
    hand.main(FreeCADGui.Selection.addSelection, job)
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Connect" in hand.text(f"{D}FlowTitle"), START_S, "the proof")
    hand.choose(f"{D}Speed", "10× speed")
    hand.click(f"{D}Start")
    at_zero(hand)
    assert not hand.exists(f"{D}Offer")
    hand.click(f"{D}Start")
    hand.wait(lambda: dock.link.status and dock.link.status.acknowledged > 140, 60, "cuts that the journal knows of")
    lose(machines)
    hand.wait(lambda: hand.text(f"{D}State") == "Connection lost", 30)
    go_on_from_the_lost_link(hand)
    hand.click(f"{D}Cancel")
    hand.click(f"{D}Connect")
    hand.wait(lambda: hand.exists(f"{D}Offer"), START_S, "the offer")
    assert "Two pockets" in hand.text(f"{D}Offer")
    hand.shot("restart-offer")
    typed(hand, dock, "$$", "$110=")
    hand.click(f"{D}Unfinished")
    hand.wait(lambda: hand.exists(f"{R}said"), START_S, "what the journal tells")
    said = hand.text(f"{R}said")
    assert all(f"<b>{name}:</b>" in said for name in (how, "Certain", "Not certain", "On the path", "Position"))
    assert "path at line" in said or "OFF the path" in said
    words = proven(hand)
    line = int(hand.text(f"{R}line"))
    assert line > 1 and f"From line {line}" == hand.text(f"{R}choice") and "goes to Z" in words
    hand.shot("restart-unfinished")
    hand.click(f"{R}send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), START_S, "the work zero")
    assert not hand.main(start_button().isEnabled) and "position is unknown" in hand.text(f"{D}FlowDetail")
    hand.main(dock.sending.confirm_step)  # whatever asks for the start past the button, the machine is not moved
    hand.wait(lambda: "Refused by the machine" in hand.text(f"{D}FlowTitle"), 20, "the refusal of the service")
    assert "position is unknown" in hand.text(f"{D}FlowDetail")
    assert hand.main(lambda: dock.link.status.mpos_mm) == (0, 0, 0)
    hand.shot("restart-position-unknown")
    hand.click(f"{D}Cancel")
    hand.click(f"{D}Unfinished")
    hand.wait(lambda: hand.exists(f"{R}said"), START_S, "what the journal tells")
    proven(hand)
    hand.click(f"{R}send")
    at_zero(hand)
    hand.click(f"{D}Start")
    hand.wait(lambda: "Done" in hand.text(f"{D}FlowTitle"), 120, "the end of the cut")
