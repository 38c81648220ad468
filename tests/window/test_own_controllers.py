# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parallel port, USB board and mini-lathe under a real hand: their profiles, the machine test, a job line by line."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCAD
import pytest
from test_dock import D, own_sessions, says  # noqa: F401
from test_machines import FIELD, M, cut_off, dialog, machines, show  # noqa: F401

from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.machine.files.profile_files import own_folder
from CNCStepper.machine.profile import load_machine
from window_helpers import screen_places as places
from window_helpers.docks import opened_dock
from window_helpers.hand import Hand
from window_helpers.tables import click_tab
from window_helpers.twin import Twin

T = "CNCStepper_MachineTest_"
PROFILES = {"parport": "thesis-table", "board": "usb-board", "lathe": "mini-lathe"}
LINES = ["G21G90G94", "G1X20F300", "G1Y15", "G1X0"]


@pytest.fixture
def dock(hand: Hand) -> Iterator[Any]:
    """The dock's panel, disconnected at the end, with the profile that it had."""

    def at_end(panel: Any) -> None:
        panel.by_line.setChecked(False)

    with opened_dock(hand, at_end) as panel:
        yield panel
        hand.main(panel.link.command, "stop")
        hand.wait(lambda: not panel.link.moment.job_runs, 20)
    hand.main(lambda: [FreeCAD.closeDocument(name) for name in list(FreeCAD.listDocuments())])
    hand.settle()


def connect(hand: Hand, kind: str, twin: Twin) -> None:
    """Choose the profile, type the address, and connect."""
    hand.choose(f"{D}Machine", PROFILES[kind])
    hand.fill(f"{D}Port", twin.address)
    hand.click(f"{D}Connect")
    says(hand, "Idle", 90)


def open_test(hand: Hand, kind: str) -> Any:
    """Open the machines' dialog, choose the profile and its last tab, and return the tab."""
    hand.command("CNCStepper_Machines")
    hand.wait(lambda: dialog() and dialog().isVisible(), what="the dialog")
    hand.item(f"{M}_list", PROFILES[kind])
    hand.wait(lambda: dialog().name == PROFILES[kind], what="the profile")
    tabs = hand.main(lambda: dialog().tabs)
    click_tab(hand, tabs, hand.main(tabs.count) - 1)
    test = hand.main(lambda: dialog().test)
    hand.wait(lambda: test.bench.status is not None, 20, "the machine")
    return test


def close_dialog(hand: Hand) -> None:
    hand.click(f"{M}_close")
    hand.wait(lambda: not dialog().isVisible(), what="the dialog's end")


def press(hand: Hand, name: str) -> None:
    hand.main(lambda: places.scroll_to(places.find(f"{T}{name}")))
    hand.settle()
    hand.click(f"{T}{name}")


def rests(hand: Hand, test: Any) -> None:
    hand.wait(lambda: not test.bench.why_not() or test.bench.trouble, 30, "the end of the test")
    assert hand.main(lambda: test.bench.trouble) == ""


def drive(hand: Hand, test: Any, axis: str, pulses: int, button: str) -> None:
    hand.choose(f"{T}axis", axis)
    hand.fill(f"{T}pulses", str(pulses))
    press(hand, button)


@pytest.mark.parametrize("kind", PROFILES)
def test_a_profile_of_each_machine_is_copied_changed_and_saved(hand: Hand, machines: Any, kind: str) -> None:  # noqa: F811
    hand.item(f"{M}_list", PROFILES[kind])
    hand.wait(lambda: machines.name == PROFILES[kind], what="the profile")
    for tab in range(hand.main(machines.tabs.count)):
        click_tab(hand, machines.tabs, tab)
        hand.shot(f"own-{kind}-{tab}", M)
        assert not hand.main(lambda: machines.tabs.currentWidget().horizontalScrollBar().isVisible())
        assert hand.main(cut_off) == []
    hand.click(f"{M}_copy")
    hand.fill(f"{M}_question_name", f"my-{kind}")
    hand.click(f"{M}_question_ok")
    hand.wait(lambda: dialog().name == f"my-{kind}", what="the copy")
    click_tab(hand, machines.tabs, 1)
    hand.fill(f"{FIELD}_axis_x_travel_max_mm", "123.5")
    hand.wait(lambda: machines.save_button.isEnabled(), what="a whole machine")
    hand.click(f"{M}_save")
    hand.wait(lambda: not machines.draft.is_changed, what="it is saved")
    saved, before = load_machine(f"my-{kind}"), load_machine(PROFILES[kind])
    assert saved.axis["x"].travel_max_mm == 123.5
    assert (saved.controller, saved.signals) == (before.controller, before.signals)


def test_the_port_is_tried_out(hand: Hand, dock: Any, twins: Any) -> None:
    twin = twins("parport", "--machine", "thesis-table", "--typed")
    connect(hand, "parport", twin)
    test = open_test(hand, "parport")
    press(hand, "relay_oxygen")
    hand.wait(lambda: "position is unknown" in hand.text("CNCStepper_MachineTest_error"), 10, "a refusal in words")
    assert not hand.main(test._relays["oxygen"].isChecked)
    hand.shot("own-test-parport", M)
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: test.bench.status.position_known, 10, "the zero")
    drive(hand, test, "Y", 80, "forward")
    hand.wait(lambda: twin.place_mm() == (0.0, 2.0, 0.0), 10, "80 pulses of 40 a mm")
    rests(hand, test)
    drive(hand, test, "X", 40, "back")
    hand.wait(lambda: twin.place_mm() == (-1.0, 2.0, 0.0), 10, "40 pulses back")
    rests(hand, test)
    press(hand, "relay_oxygen")
    hand.wait(lambda: twin.has_told("output_0 on"), 10, "the torch's relay")
    rests(hand, test)
    assert hand.main(test._relays["oxygen"].isChecked)
    hand.shot("own-test-parport-relay", M)
    press(hand, "relay_oxygen")
    hand.wait(lambda: twin.has_told("output_0 off"), 10, "the relay is off")
    rests(hand, test)
    twin.press("press 15")
    hand.wait(lambda: "15" in hand.text(f"{T}inputs"), 10, "the input")
    assert hand.main(test.port.words, 15) == "Pin 15: input, back along the cut, high"
    assert hand.main(test.port.words, 14) == "Pin 14: output, wire, low"
    hand.shot("own-test-parport-input", M)
    twin.press("release 15")
    hand.wait(lambda: "15" not in hand.text(f"{T}inputs"), 10, "the input is off")
    close_dialog(hand)


def test_the_board_is_tried_out(hand: Hand, dock: Any, twins: Any) -> None:
    twin = twins("board")
    connect(hand, "board", twin)
    test = open_test(hand, "board")
    hand.shot("own-test-board", M)
    drive(hand, test, "Z", 40, "back")
    hand.wait(lambda: twin.place_mm() == (0.0, 0.0, -2.0), 10, "40 pulses of 20 a mm")
    rests(hand, test)
    drive(hand, test, "X", 20, "forward")
    hand.wait(lambda: twin.place_mm() == (1.0, 0.0, -2.0), 10, "20 pulses")
    close_dialog(hand)


def test_the_lathe_is_tried_out_as_far_as_it_can(hand: Hand, dock: Any, twins: Any) -> None:
    twin = twins("lathe")
    connect(hand, "lathe", twin)
    hand.shot("own-lathe-connected")
    test = open_test(hand, "lathe")
    hand.shot("own-test-lathe", M)
    axes = hand.main(lambda: [test.axis.itemText(place) for place in range(test.axis.count())])
    assert axes == ["X", "Z"] and not hand.main(lambda: test._relays)
    said = hand.text(f"{T}state")
    assert "cannot be stopped" in said and "does not report its position" in said
    for name in ("square", "circle", "corner_1"):
        assert not hand.main(lambda name=name: places.find(f"{T}{name}").isEnabled())
        assert "need the axes X and Y" in hand.main(lambda name=name: places.find(f"{T}{name}").toolTip())
    assert not hand.main(test.size.isEnabled)
    hand.main(test._lock_plane, load_machine("thesis-table"))
    assert hand.main(test.size.isEnabled) and not hand.main(test.size.toolTip), "the next machine has X and Y"
    drive(hand, test, "Z", 40, "back")
    hand.wait(lambda: twin.place_mm() == pytest.approx((0.0, -0.5), abs=0.1), 10, "40 pulses of 80 a mm")
    rests(hand, test)
    press(hand, "along")  # 100 mm along X at feed: longer than anybody waits
    hand.wait(lambda: test.bench.is_busy, 5, "it begins")
    press(hand, "stop")
    hand.wait(lambda: not test.bench.why_not(), 20, "the jog's end")
    assert hand.main(lambda: test.bench.trouble) == ""
    close_dialog(hand)


def test_a_job_on_the_port_goes_line_by_line_and_its_lines_are_shown(
    hand: Hand, dock: Any, twins: Any, tmp_path: Path
) -> None:
    twin = twins("parport", "--machine", "thesis-table")
    connect(hand, "parport", twin)
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: dock.link.status.position_known, 10, "the zero")
    test = open_test(hand, "parport")
    hand.main(lambda: (dialog().move(0, 0), dialog().resize(1000, dialog().height())))  # beside the dock
    hand.main(lambda: places.scroll_to(test.port))
    hand.click(f"{D}ByLine")
    file = tmp_path / "send.zip"
    write_job(file, SendJob(port="", lines=LINES, file="lines.nc"))
    hand.main(lambda: dock.link.command("run", file, zero_confirmed=True, by_line=dock.by_line.isChecked()))
    hand.wait(lambda: dock.link.status.phase == "paused", 30, "the first line")
    resumed(hand, dock)  # the modes
    hand.shot("own-paused")
    for step, place in ((2, (20.0, 0.0)), (4, (20.0, 15.0))):
        hand.click(f"{D}Resume")
        hand.wait(lambda step=step: test.port.words(step).endswith("pulsing"), 10, "its step line")
        hand.shot(f"own-pulsing-{step}", M)
        hand.wait(lambda: dock.link.status.phase == "paused", 30, "the next line")
        assert hand.main(test.port.words, step + 1).endswith("low")
        hand.wait(lambda place=place: twin.place_mm()[:2] == place, 10, "the place")
    hand.click(f"{D}ByLine")
    hand.click(f"{D}Resume")
    hand.wait(lambda: test.port._levels.get(3) is True, 10, "X goes back")
    assert hand.main(test.port.words, 3) == "Pin 3: output, X direction, high"
    hand.shot("own-pulsing-back", M)
    hand.wait(lambda: dock.link.status.phase == "idle", 30, "the end")
    assert twin.place_mm()[:2] == (0.0, 15.0) and hand.main(lambda: test.port._pulsing) == frozenset()
    close_dialog(hand)


def resumed(hand: Hand, dock: Any) -> None:
    """Click Resume, and wait for the next pause."""
    before = hand.main(lambda: dock.link.status.stand)
    hand.click(f"{D}Resume")
    hand.wait(lambda: dock.link.status.phase == "paused" and dock.link.status.stand != before, 20, "the next line")


@pytest.fixture(autouse=True)
def no_profiles_of_ours() -> Iterator[None]:
    """The folder of a person's own profiles is empty before and after."""
    shutil.rmtree(own_folder(), ignore_errors=True)
    yield
    shutil.rmtree(own_folder(), ignore_errors=True)
