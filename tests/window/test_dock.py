# SPDX-License-Identifier: LGPL-2.1-or-later
"""The controller's dock under a real hand: connect, jog, zero, send, hold, resume, done; refused, stopped, closed."""

from __future__ import annotations

import dataclasses
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import FreeCADGui
import pytest
from PySide import QtCore, QtGui

from CNCStepper.control.processes.python_finder import command, environment, find_python
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service import connection_client
from CNCStepper.control.transport import link
from CNCStepper.errors import MissingPackage
from CNCStepper.simulation.tip_follower import AS_NEAR_MM
from CNCStepper.workbench import api
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.dock.model.port_choices import VIRTUAL
from CNCStepper.workbench.dock.model.send_steps import STEPS
from CNCStepper.workbench.services import sounds
from CNCStepper.workbench.simulation.live_cut import live_cut
from CNCStepper.workbench.simulation.scene import AT_MOMENT, FINISHED
from window_helpers import screen_places as places
from window_helpers.hand import Hand

D = "CNCStepper_Dock_"
LONGEST_MS = 50.0


@pytest.fixture(autouse=True)
def own_sessions(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Machines that other windows on this computer are connected to are none of ours."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))


@pytest.fixture
def dock(hand: Hand) -> Iterator[Any]:
    """The dock's panel, opened by its command; disconnected and closed afterwards."""
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock"))
    shown = hand.main(FreeCADGui.getMainWindow().findChild, QtGui.QDockWidget, "CNCStepper_Dock")
    panel = hand.main(shown.widget)
    hand.main(panel.connection.look, VIRTUAL)
    yield panel
    hand.main(panel.link.command, "stop")
    hand.wait(lambda: not panel.link.moment.job_runs, 20)
    hand.main(panel.sending.away)
    hand.main(panel.link.leave)
    hand.main(panel.refresh)
    hand.main(shown.close)


def says(hand: Hand, state: str, seconds: float = 20.0) -> None:
    hand.wait(lambda: hand.find(f"{D}State").text() == state, seconds, f"the state {state}")


def connected(hand: Hand, speed: str = "10× speed") -> None:
    hand.choose(f"{D}Speed", speed)
    hand.click(f"{D}Connect")
    says(hand, "Idle", 60)


def pocket(hand: Hand, machine: str = "table-a", **values: Any) -> Any:
    def make() -> Any:
        document = FreeCAD.newDocument("Pocket")
        job = api.new_job(document, machine=machine, stock_size_mm=(100, 70, 20))
        cutter = api.add_tool(job, number=1, diameter_mm=6, feed_mm_min=800, plunge_mm_min=200)
        api.add_elliptical_pocket(job, tool=cutter, radius_x_mm=20, radius_y_mm=12, depth_mm=2.0, **values)
        job.Label = "Pocket job"
        document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(job)
        return job

    return hand.main(make)


def zeroed(hand: Hand) -> None:
    """Make the place of the tool the work zero; before that nothing can be started."""
    assert not hand.main(start_button().isEnabled)
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: start_button().isEnabled(), 10, "Start")


def started(hand: Hand) -> None:
    """Send the job, set the work zero when it is asked for, and start."""
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 60)
    zeroed(hand)
    hand.click(f"{D}Start")


def work_mm(hand: Hand, axis: str) -> float:
    return float(hand.text(f"{D}Work{axis}"))


def test_without_a_controller_nothing_works_and_says_why(hand: Hand, dock: Any) -> None:
    for name in ("Hold", "Resume", "Stop", "JogXPlus", "ZeroX", "Home", "Unlock", "Override_feed_10", "Outline"):
        widget = hand.find(f"{D}{name}")
        assert not hand.main(widget.isEnabled), name
        assert "Connect to a controller first" in hand.main(widget.toolTip), name
    assert hand.text(f"{D}State") == "Not connected"
    assert hand.text(f"{D}Port") == "Virtual grbl (no machine)"
    hand.shot("dock-not-connected")


def test_the_dock_is_one_and_comes_back(hand: Hand, dock: Any) -> None:
    window = FreeCADGui.getMainWindow()
    shown = hand.main(window.findChild, QtGui.QDockWidget, "CNCStepper_Dock")
    hand.main(shown.close)
    hand.command("CNCStepper_Controller")
    assert hand.main(shown.isVisible)
    assert len(hand.main(window.findChildren, QtGui.QDockWidget, "CNCStepper_Dock")) == 1


def test_jog_and_zero(hand: Hand, dock: Any) -> None:
    connected(hand)
    hand.click(f"{D}Step3")
    before = work_mm(hand, "X")
    hand.click(f"{D}JogXPlus")
    hand.wait(lambda: work_mm(hand, "X") == pytest.approx(before + 10, abs=0.01))
    says(hand, "Idle")
    hand.click(f"{D}Step1")
    hand.click(f"{D}JogZMinus")
    hand.wait(lambda: work_mm(hand, "Z") == pytest.approx(-0.1, abs=0.01))
    says(hand, "Idle")
    hand.click(f"{D}ZeroX")
    hand.wait(lambda: work_mm(hand, "X") == 0)
    assert work_mm(hand, "Z") != 0
    for step, button, axis, far_mm in (
        ("Step0", "JogXMinus", "X", -0.01),
        ("Step2", "JogYPlus", "Y", 1),
        ("Step3", "JogYMinus", "Y", -10),
        ("Step3", "JogZPlus", "Z", 10),
    ):
        hand.click(f"{D}{step}")
        before = work_mm(hand, axis)
        hand.click(f"{D}{button}")
        hand.wait(lambda axis=axis, to=before + far_mm: work_mm(hand, axis) == pytest.approx(to, abs=0.006), 20, button)
        says(hand, "Idle")
    for axis in "YZ":
        assert work_mm(hand, axis) != 0
        hand.click(f"{D}Zero{axis}")
        hand.wait(lambda axis=axis: work_mm(hand, axis) == 0)
    hand.shot("dock-idle")
    hand.click(f"{D}JogFeed")
    hand.key("Ctrl+A")
    hand.type("777")
    hand.key("Tab")
    hand.wait(lambda: settings.jog_feed_mm_min() == 777, 5, "the feed to be remembered")
    hand.main(dock.jog.feed.setValue, 1000.0)
    hand.click(f"{D}Connect")
    says(hand, "Not connected")


def test_overrides_change_by_their_steps_and_go_back(hand: Hand, dock: Any, twins: Any) -> None:
    hand.fill(f"{D}Port", twins("grbl", "--firmware", "grblhal").address)
    hand.click(f"{D}Connect")
    says(hand, "Idle", 90)
    for kind in ("feed", "spindle"):
        for step, percent in ((10, 110), (1, 111), (-1, 110), (-10, 100), (1, 101), ("reset", 100)):
            hand.click(f"{D}Override_{kind}_{step}")
            hand.wait(lambda kind=kind, shown=f"{percent} %": hand.text(f"{D}Override_{kind}") == shown)
    for percent in (25, 50, 100):
        hand.click(f"{D}Override_rapid_{percent}")
        hand.wait(lambda shown=f"{percent} %": hand.text(f"{D}Override_rapid") == shown)
    for step, on in (("mist", "Mist"), ("flood", "Flood, Mist"), ("mist", "Flood"), ("flood", "Off")):
        hand.click(f"{D}Override_coolant_{step}")
        hand.wait(lambda on=on: hand.text(f"{D}Override_coolant") == on, what=on)


def test_what_the_controller_says_can_be_copied(hand: Hand, dock: Any) -> None:
    connected(hand)
    hand.click(f"{D}ConsoleLine")
    hand.type("$I")
    hand.key("Return")
    hand.wait(lambda: "VER" in hand.text(f"{D}ConsoleSaid"), 10, "the answer")
    hand.main(dock.log.say, "", "Something to copy")
    for name, words in (("ConsoleSaid", "VER"), ("Messages", "Something to copy")):
        hand.click(f"{D}{name}")
        hand.key("Ctrl+A")
        hand.key("Ctrl+C")
        hand.wait(lambda words=words: words in QtGui.QApplication.clipboard().text(), 5, words)


def test_the_dock_opens_the_assistant_and_keeps_a_ports_rate(hand: Hand, dock: Any) -> None:
    before = hand.main(lambda: dock.connection.baud_rate)
    hand.fill(f"{D}Port", "COM99")
    for rate in ("57600", str(before)):
        hand.choose(f"{D}Baud", rate)
        assert hand.main(lambda: dock.connection.baud_rate) == int(rate)
    hand.click(f"{D}SetUp")
    hand.wait(lambda: hand.exists("CNCStepper_Assistant"), 20, "the assistant")
    hand.click("CNCStepper_Assistant_close")
    hand.wait(lambda: not hand.exists("CNCStepper_Assistant"), 5, "its end")


def test_a_held_jog_ends_with_the_button(hand: Hand, dock: Any) -> None:
    connected(hand, "1× speed")
    hand.click(f"{D}Step4")
    hand.hover(f"{D}JogYPlus")
    hand.mouse.down(1)
    says(hand, "Jogging")
    hand.wait(lambda: work_mm(hand, "Y") > 8)
    hand.mouse.up(1)
    says(hand, "Idle", 2)
    stood = work_mm(hand, "Y")
    time.sleep(0.5)
    assert work_mm(hand, "Y") == stood


def test_a_held_jog_ends_when_the_window_hangs(hand: Hand, dock: Any) -> None:
    connected(hand, "1× speed")
    hand.click(f"{D}Step4")
    hand.hover(f"{D}JogYPlus")
    hand.mouse.down(1)
    says(hand, "Jogging")
    hand.main(time.sleep, 1.5)  # the button is still down, the window does not live
    hung = hand.main(lambda: dock.link.client.poll() and None) or work_mm(hand, "Y")
    hand.mouse.up(1)
    says(hand, "Idle", 2)
    assert work_mm(hand, "Y") == pytest.approx(hung, abs=15)
    assert work_mm(hand, "Y") < 1000 / 60 * 2.0


@pytest.fixture
def heard(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The names of the sounds that the dock plays."""
    played: list[str] = []
    monkeypatch.setattr(sounds, "play", played.append)
    return played


def test_send_hold_resume_done(hand: Hand, dock: Any, heard: list[str]) -> None:
    pocket(hand, stepover_mm=1.0)  # so that it is not at its end before all has been clicked on a slow machine
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Connect" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    hand.choose(f"{D}Speed", "10× speed")
    hand.click(f"{D}Start")
    hand.wait(lambda: "Work zero" in hand.text(f"{D}FlowTitle"), 60, "the controller")
    assert "position is unknown" in hand.text(f"{D}FlowDetail") and "All = 0" in hand.main(start_button().toolTip)
    hand.shot("dock-zero")
    zeroed(hand)
    assert not hand.exists(f"{D}FlowDetail")
    hand.click(f"{D}Live")
    hand.click(f"{D}Start")
    says(hand, "Running")
    hand.wait(lambda: hand.find(f"{D}Progress").value() > 100, 60)
    hand.shot("dock-running")
    big_digits_follow(hand, dock)
    the_cut_is_in_the_view(hand, dock)
    hand.click(f"{D}Override_feed_10")
    hand.wait(lambda: hand.text(f"{D}Override_feed") == "110 %")
    hand.click(f"{D}Override_coolant_flood")
    hand.wait(lambda: hand.text(f"{D}Override_coolant") == "Flood")
    hand.click(f"{D}Hold")
    says(hand, "Held")
    hand.shot("dock-held")
    assert not hand.main(hand.find(f"{D}JogXPlus").isEnabled)
    hand.click(f"{D}Resume")
    says(hand, "Running")
    hand.wait(lambda: "Done" in hand.text(f"{D}FlowTitle"), 120, "the end of the cut")
    assert "lines are cut" in hand.text(f"{D}FlowDetail")
    says(hand, "Idle")
    assert hand.main(lambda: shown_part(dock)) == FINISHED
    hand.shot("dock-done")
    assert heard == [sounds.END]
    hand.click(f"{D}Cancel")
    assert not hand.exists(f"{D}Flow")
    hand.wait(lambda: dock.live.shown is None, 5, "an empty view")
    hand.click(f"{D}Live")


def test_a_cut_whose_document_was_closed_is_not_shown(hand: Hand, dock: Any) -> None:
    job = pocket(hand)
    hand.main(lambda: FreeCAD.closeDocument(job.Document.Name))
    assert hand.main(live_cut, job, None, dock) is None


def shown_part(dock: Any) -> int:
    return int(dock.live.shown._scene._part.whichChild.getValue())


def the_cut_is_in_the_view(hand: Hand, dock: Any) -> None:
    """The part is in the 3D view as it is cut by now, the tool where it is reported, and the path behind it."""
    hand.wait(lambda: dock.live.shown is not None and dock.live.shown.time_s > 0 and dock.live.shown._scene._tiles, 60)
    shown = dock.live.shown
    with hand.watchdog() as dog:
        begun_s, cut = shown.time_s, dock.link.status.acknowledged
        hand.wait(lambda: shown.time_s > begun_s + 5 and dock.link.status.acknowledged > cut, 60, "the cut to go on")
    print(f"while the cut is shown: {dog}")
    assert dog.max_cpu_ms < LONGEST_MS, dog
    tip_mm = hand.main(lambda: shown._scene._tool_place.translation.getValue().getValue())
    assert tip_mm == pytest.approx(shown._path.points_mm[-1], abs=AS_NEAR_MM) and len(shown._path.points_mm) > 5
    assert hand.main(lambda: shown_part(dock)) == AT_MOMENT
    hand.main(FreeCADGui.SendMsgToActiveView, "ViewFit")
    hand.main(FreeCADGui.ActiveDocument.ActiveView.viewIsometric)
    hand.shot("dock-live-cut")


def big_digits_follow(hand: Hand, dock: Any) -> None:
    """Open the window of big digits while the job is cut: it shows what the dock shows, large, and cuts nothing off."""
    hand.click(f"{D}Digits")
    hand.wait(lambda: hand.exists("CNCStepper_Digits_State"), 5, "the big digits")
    assert hand.main(dock.digits.isWindow) and hand.text("CNCStepper_Digits_State") == "Running"
    hand.wait(lambda: hand.text("CNCStepper_Digits_WorkX") == hand.text(f"{D}WorkX"), 5, "the same position")
    assert "0:" in hand.text("CNCStepper_Digits_Remaining") and hand.text("CNCStepper_Digits_Line")[-1].isdigit()
    hand.shot("dock-big-digits", dock.digits)
    for size in ((720, 520), (300, 240)):
        hand.main(dock.digits.resize, *size)
        hand.settle()
        assert hand.main(lambda: all(fits(label) for label in dock.digits.findChildren(QtGui.QLabel)))
    hand.main(dock.digits.close)


def fits(label: Any) -> bool:
    return label.fontMetrics().boundingRect(label.text()).width() <= label.width()


def test_stop_ends_the_job_and_says_how_it_stands(hand: Hand, dock: Any) -> None:
    pocket(hand)
    connected(hand, "1× speed")
    started(hand)
    says(hand, "Running")
    hand.click(f"{D}Stop")
    hand.wait(lambda: "Stopped" in hand.text(f"{D}FlowTitle"), 20)
    assert "position is kept" in hand.text(f"{D}FlowDetail")
    says(hand, "Idle")
    the_outline_is_run(hand, dock)


def test_a_refusal_stops_before_the_machine(hand: Hand, dock: Any) -> None:
    job = pocket(hand)
    hand.main(setattr, job, "Coolant", "mist")  # which this machine has not
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Flow") and "Refused" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    assert hand.exists("CNCStepper_Findings_list") and not hand.exists(f"{D}Start")
    assert hand.text(f"{D}State") == "Not connected"
    hand.shot("dock-refused")


def test_warnings_are_shown_and_a_person_goes_on(hand: Hand, dock: Any) -> None:
    pocket(hand, centre_mm=(40.0, 0.0, 0.0))  # over the edge of the stock
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Flow") and "Warnings" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    assert hand.exists("CNCStepper_Findings_list")
    hand.shot("dock-warnings")
    hand.click(f"{D}Start")
    hand.wait(lambda: "Connect" in hand.text(f"{D}FlowTitle"))
    hand.click(f"{D}Cancel")
    assert not hand.exists(f"{D}Flow")


def test_a_controller_set_up_differently_cuts_only_when_somebody_says_so(hand: Hand, dock: Any) -> None:
    pocket(hand, machine="table-b")
    connected(hand)
    started(hand)
    hand.wait(lambda: "Another machine" in hand.text(f"{D}FlowTitle"))
    assert "$100" in hand.text(f"{D}FlowDetail") and hand.text(f"{D}State") == "Idle"
    hand.shot("dock-differs")
    hand.click(f"{D}Start")
    says(hand, "Running")


def test_without_pyserial_the_dock_opens_and_says_so(hand: Hand, dock: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    def lacks(*_: Any) -> Any:
        raise MissingPackage("package-missing", "pyserial is missing", advice="install it")

    monkeypatch.setattr(link, "port_names", lacks)
    monkeypatch.setattr(connection_client, "find_python", lacks)
    hand.main(dock.connection.look)
    assert "Pyserial is missing. Install it." in hand.text(f"{D}Messages")
    hand.fill(f"{D}Port", "COM99")
    hand.click(f"{D}Connect")
    says(hand, "No connection")
    assert hand.text(f"{D}StateSentence") == "Pyserial is missing. Install it."
    hand.click(f"{D}Port")
    hand.key("Ctrl+A")
    hand.key("Delete")
    assert not hand.main(hand.find(f"{D}Connect").isEnabled)


@pytest.fixture
def locked_machine() -> Iterator[str]:
    """The address of a virtual grbl with homing switches, which is in alarm until it is homed."""
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--homing", "--speed", "10")
    words = command(find_python(), "CNCStepper.cli.main", *words)
    machine = subprocess.Popen(words, env=environment(), stdout=subprocess.PIPE, text=True)
    yield machine.stdout.readline().split()[-1]
    machine.terminate()
    machine.wait()


def test_an_alarm_is_unlocked_and_homed_at_an_address_that_is_typed(hand: Hand, dock: Any, locked_machine: str) -> None:
    hand.fill(f"{D}Port", locked_machine)
    assert not hand.exists(f"{D}Baud") and not hand.exists(f"{D}Speed")
    hand.click(f"{D}Connect")
    says(hand, "Alarm", 30)
    assert "home the machine, or unlock it" in hand.text(f"{D}StateSentence")
    hand.shot("dock-alarm")
    hand.click(f"{D}Unlock")
    says(hand, "Idle")
    hand.click(f"{D}Home")
    says(hand, "Homing")
    says(hand, "Idle", 60)
    assert hand.text(f"{D}StateSentence") == "The machine is at rest and waits."


def homed(hand: Hand, address: str) -> None:
    hand.fill(f"{D}Port", address)
    hand.click(f"{D}Connect")
    says(hand, "Alarm", 30)
    hand.click(f"{D}Home")
    says(hand, "Homing")
    says(hand, "Idle", 60)


def zero_at(hand: Hand, dock: Any, x_mm: float, y_mm: float, z_mm: float) -> None:
    """Jog by so much, and set the zero of all axes there."""
    there = [at + by for at, by in zip(hand.main(lambda: dock.link.status.mpos_mm), (x_mm, y_mm, z_mm), strict=True)]
    hand.main(lambda: dock.link.command("jog", x_mm, y_mm, z_mm, 5000.0))
    hand.wait(lambda: dock.link.status.mpos_mm == pytest.approx(there, abs=0.02), 60, "the end of the jog")
    says(hand, "Idle", 60)
    before = hand.main(lambda: dock.link.start)
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: dock.link.start not in (None, before), 10, "the new zero")


def test_a_job_is_proven_for_the_zero_that_the_machine_has(
    hand: Hand, dock: Any, locked_machine: str, heard: list[str]
) -> None:
    pocket(hand)
    homed(hand, locked_machine)
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Flow") and "Refused" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    rows = hand.find("CNCStepper_Findings_list")
    found = hand.main(lambda: [rows.item(row).text() for row in range(rows.count())])
    assert any("leaves the travel of X by 17 mm" in row for row in found), found
    hand.shot("dock-travel")
    assert sounds.BEYOND in heard
    hand.click(f"{D}Cancel")
    zero_at(hand, dock, -200.0, -200.0, -40.0)
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    proven = hand.main(lambda: dock.sending._result.begins)
    assert proven == hand.main(lambda: dock.link.start)
    assert proven.work_offsets_mm["G54"] == pytest.approx((-201, -201, -41), abs=0.02)  # homing pulls off by 1 mm
    zero_at(hand, dock, 10.0, 10.0, 0.0)
    hand.wait(lambda: dock.sending._result.begins == dock.link.start, 60, "the proof from the new zero")
    assert hand.main(lambda: (dock.sending._result.begins != proven, dock.sending.flow.step)) == (True, "zero")
    hand.wait(lambda: start_button().isEnabled())
    zero_at(hand, dock, 180.0, 0.0, 0.0)
    hand.wait(lambda: dock.sending.flow.again and not start_button().isEnabled(), 5, "the check with the new zero")
    hand.shot("dock-zero-again")
    hand.wait(lambda: "Refused" in hand.text(f"{D}FlowTitle"), 60, "the refusal of a zero too near to the edge")
    hand.click(f"{D}Cancel")
    zero_at(hand, dock, -100.0, 0.0, 0.0)
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    hand.click(f"{D}Start")
    says(hand, "Running")
    hand.click(f"{D}Stop")
    hand.wait(lambda: "Stopped" in hand.text(f"{D}FlowTitle"), 20)


def the_outline_is_run(hand: Hand, dock: Any) -> None:
    """Run the outline by its button, as any program: checked, asked for the zero, sent; it cuts nothing.

    No homing is needed where the work zero was set, as for the job itself.
    """
    assert not hand.main(lambda: dock.link.start)
    hand.click(f"{D}Outline")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Work zero" in hand.text(f"{D}FlowTitle"), 60, "the proof")
    assert dock.sending.flow.label == "Pocket job, outline"
    hand.wait(lambda: start_button().isEnabled())
    hand.shot("dock-outline")
    seen: list[Any] = []
    hand.click(f"{D}Start")
    hand.wait(lambda: seen.append(dock.link.status) or "Done" in hand.text(f"{D}FlowTitle"), 60, "its end")
    assert all(status.wpos_mm[2] > -0.01 and not status.spindle_rpm for status in seen)
    assert dock.link.status.wpos_mm == pytest.approx((-17, -9, 10), abs=0.02)  # 20 by 12 mm less the cutter's radius
    hand.click(f"{D}Cancel")
    outline = hand.main(lambda: FreeCAD.ActiveDocument.getObjectsByLabel("Pocket job, outline")[0])
    corners = " ".join(word for word in hand.main(api.program_text, outline).split() if word[0] in "XY")
    assert corners == "X-17.000 Y-9.000 X17.000 Y9.000 X-17.000 Y-9.000"


def start_button() -> Any:
    return FreeCADGui.getMainWindow().findChild(QtGui.QPushButton, f"{D}Start")


def test_the_window_asks_before_it_closes_over_a_job(hand: Hand, dock: Any) -> None:
    pocket(hand)
    connected(hand, "1× speed")
    started(hand)
    says(hand, "Running")
    window = FreeCADGui.getMainWindow()
    hand.main(lambda: QtCore.QTimer.singleShot(0, window.close))
    hand.wait(lambda: hand.exists(f"{D}Closing"))
    hand.shot("dock-closing")
    hand.click(f"{D}Closing_cancel")
    hand.wait(lambda: not hand.exists(f"{D}Closing"))
    assert hand.main(window.isVisible)
    says(hand, "Running")
    (guard,) = hand.main(lambda: window.findChildren(QtCore.QObject, "CNCStepper_Dock_ClosingGuard"))
    for answer in ("keep", "stop"):
        answered: list[bool] = []
        hand.main(lambda answered=answered: QtCore.QTimer.singleShot(0, lambda: answered.append(guard.may_close())))
        hand.wait(lambda: hand.exists(f"{D}Closing"))
        assert hand.main(lambda: dock.link.moment.job_runs)
        hand.click(f"{D}Closing_{answer}")
        hand.wait(lambda answered=answered: answered == [True], 5, "the answer")
    hand.wait(lambda: not dock.link.moment.job_runs, 20, "the stop")


def test_the_window_lives_while_100_000_lines_stream(hand: Hand, dock: Any, tmp_path: Path) -> None:
    lines = ["G21", "G90", "G94"] + [f"G1X{index % 7}Y{index % 5}F30000" for index in range(100_000)]
    file = tmp_path / "send.zip"
    write_job(file, SendJob(port="", lines=lines, file="long.nc"))
    connected(hand)
    hand.main(lambda: dock.link.command("set_zero", "XYZ"))
    with hand.watchdog() as watch:
        hand.main(lambda: dock.link.command("run", file, zero_confirmed=True))
        says(hand, "Running", 60)
        hand.wait(lambda: dock.link.status.acknowledged > 1000, 60)
        time.sleep(3)
    print(watch)
    assert watch.max_cpu_ms < LONGEST_MS, watch


def test_a_new_window_takes_up_what_a_killed_one_left(hand: Hand, tmp_path: Path) -> None:
    words = [find_python(), str(Path(__file__).parents[1] / "window_helpers" / "left_behind.py"), str(tmp_path)]
    before = subprocess.Popen(words, env=environment(), stdout=subprocess.PIPE, text=True)
    try:
        while int(before.stdout.readline()) < 5:
            pass
    finally:
        before.kill()
        before.wait()
    hand.command("CNCStepper_Controller")
    says(hand, "Running")
    assert "Attached again" in hand.text(f"{D}Messages")
    assert "left-behind.nc" in hand.text(f"{D}JobTitle")
    hand.shot("dock-attached")
    lines = hand.text(f"{D}Lines")
    hand.wait(lambda: hand.text(f"{D}Lines") != lines, 10, "the cut to go on")
    hand.click(f"{D}Hold")
    says(hand, "Held")
    hand.click(f"{D}Resume")
    says(hand, "Running")
    hand.click(f"{D}Stop")
    says(hand, "Idle")
    hand.click(f"{D}Connect")
    says(hand, "Not connected")


def test_nothing_makes_the_dock_wider_or_is_cut_off_in_a_narrow_one(hand: Hand, dock: Any) -> None:
    narrow = hand.main(lambda: dock.minimumSizeHint().width())
    long = "Gearbox cover, the second setup, with_a_name_that_has_no_place_at_which_its_line_could_be_broken"
    hand.main(dock.sending.flow.begin, long)
    for step in (*STEPS, ""):
        hand.main(setattr, dock.sending.flow, "step", step)
        hand.main(dock.refresh)
        hand.settle()
        assert hand.main(lambda: dock.minimumSizeHint().width()) == narrow, step
        assert hand.main(cut_off, dock) == [], step
        if step == "zero":
            hand.shot("dock-narrow")


def cut_off(dock: Any) -> list[str]:
    """Return the names of the buttons that have less room than their texts need."""
    window = FreeCADGui.getMainWindow()
    window.resizeDocks([dock.parentWidget()], [300], QtCore.Qt.Orientation.Horizontal)
    QtCore.QCoreApplication.processEvents()
    shown = [button for button in dock.findChildren(QtGui.QPushButton) if button.isVisible()]
    return [button.objectName() for button in shown if button.width() < button.minimumSizeHint().width()]


def test_a_g_code_file_goes_the_way_of_a_job(hand: Hand, dock: Any, tmp_path: Path) -> None:
    file = tmp_path / "peça de fora.nc"
    file.write_text("G21 G90\nT1\nM3 S9000\nG4 P3\nG0 Z5\nX-20 Y0\nG1 Z-1 F200\nX20 F800\nG0 Z5\nM5\nM2\n", "utf-8")
    hand.click(f"{D}SendFile")
    hand.wait(lambda: hand.exists("CNCStepper_Tell_notice"), 10, "why there is none to send it for")
    hand.shot("dock-file-no-job")
    hand.click("CNCStepper_Tell_ok")
    pocket(hand)
    hand.click(f"{D}SendFile")
    hand.wait(lambda: hand.exists("CNCStepper_Editor_file"), 10, "the question which file")
    for _ in range(3):  # the list that completes names may take the folder, and show it
        hand.fill("fileNameEdit", str(file))
        hand.key("Return")
        if not hand.exists("CNCStepper_Editor_file"):
            break
    hand.wait(lambda: hand.exists(f"{D}Start") and "Connect" in hand.text(f"{D}FlowTitle"), 240, "the proof")
    assert "peça de fora.nc" in hand.text(f"{D}FlowTitle")
    hand.shot("dock-file")


def test_relay_keys_switch_and_show_what_is_on(hand: Hand, dock: Any) -> None:
    assert "Connect to a controller first" in hand.main(hand.find(f"{D}Relay_flood").toolTip)
    connected(hand)
    key = hand.find(f"{D}Relay_flood")
    hand.main(lambda: places.scroll_to(places.find(f"{D}Relay_flood")))
    hand.settle()
    hand.click(f"{D}Relay_flood")
    hand.wait(lambda: "F" in (dock.link.status.outputs or ""), 20, "flood is on")
    hand.shot("dock-relays")
    hand.wait(key.isChecked)
    hand.wait(key.isEnabled)
    hand.click(f"{D}Relay_flood")
    hand.wait(lambda: "F" not in (dock.link.status.outputs or ""), 20, "flood is off")
    spindle = hand.find(f"{D}Relay_spindle_cw")
    for is_on in (True, False):
        hand.wait(spindle.isEnabled)
        hand.click(spindle)
        hand.wait(lambda is_on=is_on: ("S" in (dock.link.status.outputs or "")) is is_on, 20, "the spindle")


def test_what_the_machine_cannot_do_is_said_at_its_button(
    hand: Hand, dock: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    connected(hand)
    moment = type(dock.link).moment.fget

    def lathe(link: Any) -> Any:
        return dataclasses.replace(moment(link), cannot=("hold", "resume", "override"))

    monkeypatch.setattr(type(dock.link), "moment", property(lathe))
    hand.main(dock.refresh)
    for name, words in (
        ("Hold", "cannot be held"),
        ("Resume", "cannot be resumed"),
        ("Override_feed_10", "speeds cannot be changed"),
    ):
        widget = hand.find(f"{D}{name}")
        assert not hand.main(widget.isEnabled) and words in hand.main(widget.toolTip), name


def test_sounds_are_made_at_a_pause_and_can_be_switched_off(hand: Hand, dock: Any, heard: list[str]) -> None:
    hand.main(dock._sound, "pause")
    assert heard == ["pause"]
    hand.main(lambda: places.scroll_to(places.find(f"{D}Sounds")))
    hand.settle()
    hand.click(f"{D}Sounds")
    hand.main(dock._sound, "pause")
    hand.click(f"{D}Sounds")
    assert heard == ["pause"]


def test_a_sound_plays_or_the_computer_beeps(hand: Hand) -> None:
    for name in sounds.NAMES:
        hand.main(sounds.play, name)
