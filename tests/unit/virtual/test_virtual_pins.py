# SPDX-License-Identifier: LGPL-2.1-or-later
"""The input pins of the virtual board, and the hand that presses them."""

from __future__ import annotations

import pytest

from CNCStepper.errors import JobError, MachineRefusal
from CNCStepper.virtual.server.pin_presses import TAP_S, PinPresses


def pins(grbl) -> str:
    return grbl.status().get("Pn", "")


def test_pressed_pins_are_reported_in_the_firmwares_order(grbl):
    for pin in "YPX":
        grbl.board.press(pin)
    assert pins(grbl) == "PXY"
    grbl.board.release("X")
    assert pins(grbl) == "PY"


def test_pin_that_is_not_there_is_refused(grbl):
    with pytest.raises(MachineRefusal, match="no pin 'Q'"):
        grbl.board.press("Q")


def test_control_pins_do_what_the_firmware_does(grbl):
    board = grbl.board
    grbl.say("G1X-20F1500\n", 0.5)
    board.press("H")
    grbl.say(b"", 0.5)
    assert grbl.status()[""] == "Hold:0" and pins(grbl) == "H"
    board.release("H")
    board.press("S")
    assert grbl.status()[""] == "Run"
    board.press("R")
    assert any("ALARM:3" in line for line in grbl.say(b""))


def test_door_stays_shut_out_while_it_is_ajar(grbl):
    board = grbl.board
    board.press("D")
    grbl.say(b"~", 0.1)
    assert grbl.status()[""] == "Door:1"
    board.release("D")
    assert grbl.status()[""] == "Door:0"
    grbl.say(b"~", 0.1)
    assert grbl.status()[""] == "Idle"


def test_limit_switch_locks_only_where_it_is_watched(grbl):
    board = grbl.board
    board.press("X")
    assert grbl.status()[""] == "Idle"
    board.release("X")
    grbl.line("$21=1")
    board.press("X")
    assert "ALARM:1" in grbl.say(b"")


def test_probe_pressed_by_hand_ends_a_probing_move(grbl):
    board = grbl.board
    grbl.say("G38.2Z-20F100\n", 1.0)
    board.press("P")
    said = grbl.until_idle()
    assert (
        any(line.startswith("[PRB:") and line.endswith(":1]") for line in said)
        and -5 < board.axes.position_mm[2] < -0.5
    )


# --- the hand --------------------------------------------------------------------------------------


def test_typed_line_taps_presses_and_releases(grbl):
    told: list[str] = []
    hand = PinPresses(grbl.board, told.append)
    hand.on_message("p")
    assert pins(grbl) == "P"
    grbl.say(b"", TAP_S + 0.1)
    hand.turn()
    assert pins(grbl) == ""
    hand.on_message("press X")
    grbl.say(b"", 5.0)
    hand.turn()
    assert pins(grbl) == "X"
    hand.on_message("release X")
    assert pins(grbl) == ""
    hand.on_message("jump")
    assert (
        told[:3] == ["pins that are on: P", "pins that are on: X", "pins that are on: none"] and "no press" in told[3]
    )


def test_timeline_presses_by_the_boards_clock(grbl, tmp_path):
    path = tmp_path / "presses ç.toml"
    path.write_text('[[press]]\npin = "Y"\nat_s = 1\nfor_s = 0.5\n\n[[press]]\npin = "P"\nat_s = 0.4\n', "utf-8")
    hand = PinPresses(grbl.board)
    hand.plan(path)
    seen = []
    for _ in range(20):
        grbl.say(b"", 0.1)
        hand.turn()
        if not seen or seen[-1] != pins(grbl):
            seen.append(pins(grbl))
    assert seen == ["", "P", "", "Y", ""]


@pytest.mark.parametrize(
    "text",
    [
        "[[press]]\npin = 'Q'\nat_s = 1",
        "[[press]]\npin = 'P'",
        "[[press]]\npin = 'P'\nat_s = -1",
        "[[press]]\npin = 'P'\nat_s = 1\nwhy = 2",
        "[[hit]]\npin = 'P'",
        "press = 3",
        "not toml",
    ],
)
def test_timeline_that_is_none_is_refused_by_name(grbl, tmp_path, text):
    path = tmp_path / "bad timeline"
    path.write_text(text, "utf-8")
    with pytest.raises(JobError, match="bad timeline"):
        PinPresses(grbl.board).plan(path)
