# SPDX-License-Identifier: LGPL-2.1-or-later
"""Check and Send act on the program that is open in front, and say which: the editor's file or the job of the tree."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCADGui
from test_dock import D, dock, own_sessions, pocket  # noqa: F401
from test_editor import NAME, no_editor_stays, opened  # noqa: F401

from CNCStepper.workbench.document import program_file
from CNCStepper.workbench.features.base import proxy_type
from window_helpers.hand import Hand

START_S = 240
TEXT = "G21 G90\nT1\nM3 S9000\nG4 P3\nG0 Z5\nX-20 Y0\nG1 Z-1 F200\nX20 F800\nG0 Z5\nM5\nM2\n"


def tooltip(hand: Hand, command: str) -> str:
    return str(hand.main(lambda: FreeCADGui.Command.get(command).getAction()[0].toolTip()))


def says_program(hand: Hand, words: str) -> None:
    for command in ("CNCStepper_Simulate", "CNCStepper_Send"):
        hand.wait(lambda command=command: words in tooltip(hand, command), 10, f"{words} in the tooltip of {command}")


def closed(hand: Hand) -> None:
    hand.button("Close")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 10)


def test_check_and_send_take_the_program_in_front(hand: Hand, dock: Any, tmp_path: Path) -> None:  # noqa: F811
    job = pocket(hand)
    says_program(hand, "Program: Pocket job<")
    file = tmp_path / "peça.nc"
    panel = opened(hand, file, TEXT)
    says_program(hand, "Program: peça.nc, in the editor")
    hand.shot("front-editor")
    hand.command("CNCStepper_Simulate")
    hand.wait(lambda: hand.exists("CNCStepper_Findings_list"), START_S, "the findings of the file")
    assert hand.text("CNCStepper_Simulation_name") == "peça.nc"
    hand.shot("front-simulated")
    closed(hand)
    hand.main(panel.edit.go_to, 8, 1)
    hand.main(panel.edit.setFocus)
    hand.type("G1 ")
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{NAME}save_first"), 10, "the question whether it is saved")
    hand.shot("front-save-first")
    hand.click(f"{NAME}save_first_cancel")
    assert not hand.exists(f"{D}Flow") and file.read_text("utf-8") == TEXT
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{NAME}save_first"), 10, "the question whether it is saved")
    hand.click(f"{NAME}save_first_save")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Connect" in hand.text(f"{D}FlowTitle"), START_S, "the proof")
    assert "peça.nc" in hand.text(f"{D}FlowTitle") and "Pocket job" not in hand.text(f"{D}FlowTitle")
    made = hand.main(lambda: [obj for obj in job.Document.Objects if proxy_type(obj) == "CNCStepper_Program"])
    assert len(made) == 1 and "G1 X20 F800" in hand.main(program_file.load, made[0])
    hand.shot("front-sent")
    hand.click(f"{D}Cancel")
    hand.tree("Pocket job")
    says_program(hand, "Program: Pocket job<")
    hand.command("CNCStepper_Send")
    hand.wait(lambda: hand.exists(f"{D}Start") and "Connect" in hand.text(f"{D}FlowTitle"), START_S, "the proof")
    assert "Pocket job" in hand.text(f"{D}FlowTitle")
    hand.click(f"{D}Cancel")
