# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulse letters in the window by real clicks, sent to our own controller of a virtual USB board, and led back."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import FreeCADGui
import pytest
from PySide import QtGui

from CNCStepper.control.processes.python_finder import command, environment, find_python
from window_helpers import screen_places as places
from window_helpers.file_dialogs import choose_file
from window_helpers.hand import Hand

D, L = "CNCStepper_Dock_", "CNCStepper_Letters_"
SIDE = 300
LETTERS = "s" + "A" * SIDE + "B" * SIDE + "D" * SIDE + "t" + "E" * SIDE


@pytest.fixture(autouse=True)
def own_sessions(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Machines that other windows on this computer are connected to are none of ours."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))


@pytest.fixture
def board(tmp_path: Path) -> Iterator[str]:
    """The port of a virtual USB board."""
    words = command(find_python(), "CNCStepper.cli.main", "virtual", "board", "--tcp", "127.0.0.1:0")
    process = subprocess.Popen(words, env=environment(), stdout=subprocess.PIPE, encoding="utf-8")
    assert process.stdout
    yield "socket://" + re.split("socket://", process.stdout.readline().strip())[-1]
    process.terminate()
    process.wait(10)


@pytest.fixture
def dock(hand: Hand, board: str) -> Iterator[Any]:
    """The dock's panel, connected to the board."""
    hand.command("CNCStepper_Controller")
    hand.wait(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDockWidget, "CNCStepper_Dock"))
    shown = hand.main(FreeCADGui.getMainWindow().findChild, QtGui.QDockWidget, "CNCStepper_Dock")
    panel = hand.main(shown.widget)
    before = hand.main(lambda: panel.connection.profile)
    hand.main(panel.connection.machine.setCurrentText, "usb-board")
    hand.main(panel.connection.look, board)
    hand.click(f"{D}Connect")
    hand.wait(lambda: panel.link.moment.phase not in ("off", "starting", "connecting"), 180, "an answer")
    assert hand.main(lambda: panel.link.moment.phase) == "idle", hand.main(lambda: panel.link.moment)
    yield panel
    hand.main(panel.link.command, "stop")
    hand.wait(lambda: not panel.link.moment.job_runs, 20)
    hand.main(panel.link.leave)
    hand.main(panel.connection.machine.setCurrentText, before)
    hand.main(shown.close)


@pytest.mark.window("plain", "portuguese")
def test_letters_are_drawn_sent_followed_and_led_back(hand: Hand, dock: Any, tmp_path: Path) -> None:
    from CNCStepper.machine.profile import load_machine

    scale = load_machine("usb-board").axes[0].steps_per_mm

    def stands() -> list[int]:
        return [round(value * scale) for value in dock.link.status.mpos_mm[:2]]

    file = tmp_path / "quadrado.letters"
    file.write_text(LETTERS, "ascii")
    hand.command("CNCStepper_Letters")
    hand.wait(lambda: hand.exists(f"{L}open"), 10, "the window of letters")
    dialog = hand.main(lambda: FreeCADGui.getMainWindow().findChild(QtGui.QDialog, "CNCStepper_Letters"))
    hand.click(f"{L}open")
    choose_file(hand, f"{L}file", file)
    hand.wait(lambda: str(4 * SIDE) in hand.text(f"{L}pulse"), what="the counters")
    hand.shot("letters-open")
    assert not hand.main(lambda: places.find(f"{L}send").isEnabled())  # the board has just restarted
    hand.click(f"{D}ZeroAll")
    hand.wait(lambda: dock.link.status.position_known, 20, "the zero")
    hand.wait(lambda: places.find(f"{L}send").isEnabled(), 10)
    begin = hand.main(stands)
    hand.click(f"{L}send")
    hand.wait(lambda: 0 < dialog.slider.value() < 4 * SIDE, 30, "the pulses")
    hand.shot("letters-sending")
    hand.wait(lambda: dock.link.status.phase == "idle" and dialog.slider.value() == 4 * SIDE, 60, "the end")
    hand.wait(lambda: not dialog._is_sent, 20, "the outcome, which shows the end once more")
    assert hand.main(stands) == begin
    hand.click(f"{L}slider")
    hand.wait(lambda: dialog.slider.value() < 4 * SIDE, 5, "a pulse before the end")
    hand.click(dialog.timeline)
    hand.wait(lambda: abs(dialog.slider.value() - 2 * SIDE) < SIDE / 5, 5, "the pulse in the middle")
    hand.main(dialog.choose, 2 * SIDE)
    hand.wait(lambda: hand.text(f"{L}x") == f"+{SIDE}", what="the place that was chosen")
    hand.choose(f"{L}axis", "Y")
    hand.fill(f"{L}count", "3")
    for button, pulses in (("plus", 3), ("minus", 0)):
        hand.click(f"{L}{button}")
        hand.wait(lambda pulses=pulses: stands() == [begin[0], begin[1] + pulses], 20, button)
        hand.wait(lambda: not dialog.why_not(), 20, "it rests")
    hand.choose(f"{L}axis", "X")
    hand.fill(f"{L}count", "1")
    hand.click(f"{L}plus")
    hand.wait(lambda: stands() == [begin[0] + 1, begin[1]], 20, "one pulse by hand")
    hand.wait(lambda: places.find(f"{L}back").isEnabled(), 20)
    hand.click(f"{L}back")
    hand.wait(lambda: dialog._back_from == 2 * SIDE and dialog._runs, 30, "the way back")
    hand.wait(lambda: dock.link.status.phase == "idle" and dialog.slider.value() == 0, 60, "the begin")
    assert hand.main(stands) == [begin[0] + 1 - SIDE, begin[1] - SIDE]
    hand.shot("letters-back")
    hand.main(dialog.close)
    goes_line_by_line(hand, dock, dialog, file.with_name("linhas.letters"))


def goes_line_by_line(hand: Hand, dock: Any, dialog: Any, file: Path) -> None:
    """Each click of Resume cuts one line; the box, cleared, lets the rest go."""
    file.write_text(("A" * 20 + "\n") * 4 + "B" * 200, "ascii")
    hand.main(lambda: places.scroll_to(places.find(f"{D}ByLine")))
    hand.click(f"{D}ByLine")
    hand.main(lambda: (dialog.show(), dialog.open_file(file)))
    hand.wait(lambda: places.find(f"{L}send").isEnabled(), 20)
    hand.click(f"{L}send")
    hand.wait(lambda: _waits(dock), 30, "the pause before the first line")
    hand.main(dialog.close)  # it may lie over the keys of the dock
    for count in range(2):
        hand.wait(lambda count=count: _waits(dock) and dock.link.status.acknowledged == count, 30, "the stand")
        hand.shot(f"line-by-line-{count}")
        hand.click(f"{D}Resume")
    hand.wait(lambda: _waits(dock) and dock.link.status.acknowledged == 2, 30, "the third line")
    hand.main(lambda: places.scroll_to(places.find(f"{D}ByLine")))
    hand.click(f"{D}ByLine")
    hand.click(f"{D}Resume")
    hand.wait(lambda: dock.link.status.phase == "idle", 60, "the end")


def _waits(dock: Any) -> bool:
    return dock.link.status is not None and dock.link.status.phase == "paused"
