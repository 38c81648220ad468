# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the board says and takes as each firmware, where they differ."""

from __future__ import annotations

import pytest

from CNCStepper.virtual.grbl.firmware import FIRMWARES, FLUIDNC, GRBL, GRBLHAL
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.serial_line import Link


@pytest.mark.parametrize(
    ("firmware", "greeting", "told"),
    [
        (GRBL, "Grbl 1.1h ['$' for help]", "[OPT:V,15,128]"),
        (GRBLHAL, "GrblHAL 1.1f ['$' or '$HELP' for help]", "[FIRMWARE:grblHAL]"),
        (FLUIDNC, "Grbl 3.7 [FluidNC v3.7.8 (wifi) '$' for help]", "[VER:3.7 FluidNC v3.7.8:]"),
    ],
)
def test_each_greets_and_says_what_it_is(talk, firmware, greeting, told):
    board = talk(firmware=firmware)
    assert greeting in board.greeting
    assert told in board.say(b"$I\n")


def slowly(board, line: bytes) -> list[str]:
    """Send a line in pieces that the smallest receive buffer takes."""
    return [answer for at in range(0, len(line), 100) for answer in board.say(line[at : at + 100])]


@pytest.mark.parametrize("firmware", FIRMWARES.values(), ids=lambda firmware: firmware.name)
def test_each_has_its_own_longest_line(talk, firmware):
    board = talk(firmware=firmware)
    longest = b"G4P0." + b"0" * (firmware.line_characters - 5)
    assert slowly(board, longest + b"\n") == ["ok"]
    assert slowly(board, longest + b"0\n") == ["error:11"]


def test_blanks_count_on_fluidnc_alone(talk):
    line = b"G4P0." + b"0" * 60 + b" " * 200 + b"\n"
    assert slowly(talk(firmware=FLUIDNC), line) == ["error:11"]
    assert slowly(talk(firmware=GRBLHAL), line) == ["ok"]


@pytest.mark.parametrize("firmware", FIRMWARES.values(), ids=lambda firmware: firmware.name)
def test_each_has_its_own_receive_buffer(talk, firmware):
    board = talk(firmware=firmware)
    assert board.status()["Bf"].endswith(f",{firmware.receive_bytes}")
    board.board.receive(b"!" + b"(" * (firmware.receive_bytes + 7))
    assert board.board.ring.lost == 7


def test_settings_of_fluidnc_are_few_and_can_only_be_read(talk):
    board = talk(firmware=FLUIDNC)
    listed = [line.partition("=")[0] for line in board.say(b"$$\n")]
    assert "$100" in listed and "$32" in listed and "$13" not in listed
    assert board.say(b"$100=81\n") == ["error:162"]
    assert board.say(b"$/report_inches\n") == ["$/report_inches=false", "ok"]
    assert talk().say(b"$/report_inches\n") != ["$/report_inches=false", "ok"]


def test_messages_of_fluidnc_are_marked(talk):
    assert "[MSG:INFO: '$H'|'$X' to unlock]" in talk(firmware=FLUIDNC, homing=True).greeting


def test_grblhal_takes_shorter_pulses_and_larger_tools(talk):
    for firmware, answer in ((GRBL, "error:6"), (GRBLHAL, "ok")):
        assert talk(firmware=firmware).say(b"$0=2\n") == [answer]
    for firmware, answer in ((GRBL, "error:38"), (GRBLHAL, "ok")):
        assert talk(firmware=firmware).say(b"T300\n") == [answer]


def test_modes_and_tool_length_of_grblhal_are_written_its_way(talk):
    board = talk(firmware=GRBLHAL)
    assert "[GC:G0 G54 G17 G21 G90 G94 G49 G98 G50 M5 M9 T0 F0 S0.]" in board.say(b"$G\n")
    assert "[TLO:0.000,0.000,0.000]" in board.say(b"$#\n")


def test_tool_change_is_answered_at_once_and_ended_by_a_cycle_start(talk):
    board = talk(firmware=GRBLHAL)
    assert board.say(b"T2M6\n", 0.1) == ["ok"] and board.status()[""] == "Tool"
    assert board.say(b"G1X1F600\n", 0.1) == [] and board.status()[""] == "Tool"
    assert board.say(b"~", 0.1) == ["ok"]
    board.until_idle()
    assert board.board.axes.position_mm[0] == pytest.approx(1.0, abs=0.02)


def test_acknowledged_tool_change_takes_jogs_and_zeros_and_then_what_waited(talk):
    board = talk(firmware=GRBLHAL)
    board.say(b"M3S9000\nM6\nG0X-1\n", 0.1)
    assert board.say(b"\xa3$J=G91G21Z-2F900\n", 0.1) == ["ok"] and board.status()[""] == "Jog"
    assert board.line("G10L20P1Z0") == "error:9"
    assert board.say(b"", 1.0) == [] and board.status()[""] == "Tool"
    assert board.say(b"G10L20P1Z0\n$G\n$#\n", 0.1)[-1] == "ok"
    assert board.line("G0X-5") == "error:40"
    assert board.board.memory.places[54] == pytest.approx([0, 0, -2], abs=0.01)
    assert board.board.spindle.rpm == 9000 and board.board.axes.position_mm[0] == 0
    assert board.say(b"~", 0.1) == ["ok"]
    board.until_idle()
    assert board.board.axes.position_mm == pytest.approx([-1, 0, -2], abs=0.02)


def test_jog_that_is_cancelled_leads_back_to_the_tool_change(talk):
    board = talk(firmware=GRBLHAL)
    board.say(b"M6\n", 0.1)
    board.say(b"\xa3$J=G91G21X-50F900\n", 0.3)
    assert board.status()[""] == "Jog"
    board.say(b"\x85", 0.5)
    assert board.status()[""] == "Tool" and board.board.axes.idle


def test_tool_change_can_be_reset_and_is_no_command_of_grbl(talk):
    board = talk(firmware=GRBLHAL)
    board.say(b"M6\n", 0.1)
    board.say(b"\x18", 0.1)
    assert board.status()[""] == "Idle"
    assert talk().say(b"M6\n") == ["error:20"]


def test_each_tells_the_blocks_of_its_planner(machine, talk):
    assert "[OPT:V,15,128]" in talk().say("$I\n")
    planner = machine.planner.model_copy(update={"look_ahead_blocks": 35})
    board = talk(firmware=GRBLHAL, machine=machine.model_copy(update={"planner": planner}))
    assert "[OPT:VNMSL,35,1024,3,0]" in board.say("$I\n")
    assert board.status()["Bf"].startswith("35,")


def test_line_takes_as_many_bytes_as_it_carries(machine):
    link, sent = Link(Grbl(machine, firmware=GRBLHAL), 1_000_000), 0
    for _ in range(10):
        sent += link.room
        link.send(b" " * link.room)
        link.advance(0.001)
    assert sent >= 1000


def ways(board, *lines: str) -> list[tuple[float, ...]]:
    """Return where the straight moves of lines end, rounded."""
    ends: list[tuple[float, ...]] = []
    line = board.board.axes.line
    board.board.axes.line = lambda target, feed, rapid: (
        ends.append(tuple(round(value, 3) for value in target)) or line(target, feed, rapid)
    )
    for text in lines:
        assert board.say(f"{text}\n".encode("ascii"), 20.0) == ["ok"], text
    return [end for number, end in enumerate(ends) if not number or end != ends[number - 1]]


@pytest.mark.parametrize(
    ("line", "heights"),
    [
        ("G98G81X1Z-1R1F3000", (5, 1, -1, 1, 5)),
        ("G99G82X1Z-1R1P0.1F3000", (5, 1, -1, 1)),
        ("G99G83X1Z-1R1Q0.8F3000", (5, 1, 0.2, 1, -0.6, 1, -1, 1)),
        ("G99G73X1Z-1R1Q0.8F3000", (5, 1, 0.2, 0.3, -0.6, -0.5, -1, -0.9, 1)),
        ("G91G98G81X1Z-2R-4F3000", (5, 1, -1, 1, 5)),
    ],
)
def test_grblhal_drills(talk, line, heights):
    assert ways(talk(firmware=GRBLHAL), "G21G90G0Z5", line)[1:] == [(1, 0, height) for height in heights]


def test_words_of_a_drilling_cycle_stick_until_another_motion(talk):
    board = talk(firmware=GRBLHAL)
    ends = ways(board, "G21G90G0Z5", "G99G81X1Z-1R1F3000", "X2", "G91X1L2", "G80")
    assert [end for end in ends if end[2] == -1] == [(1, 0, -1), (2, 0, -1), (3, 0, -1), (4, 0, -1)]
    assert "G80 G54 G17 G21 G91 G94 G49 G99" in board.say(b"$G\n")[0]
    assert board.say(b"G90G81X9F300\n") == ["error:28"] and board.say(b"G81X9Z-1R0F3000\n", 2.0) == ["ok"]
    assert board.say(b"G83X8Q1\n") == ["error:28"]
    assert board.say(b"G81X9Z1R0F300\n") == ["error:54"]


def test_grblhal_has_nine_work_systems(talk):
    board = talk(firmware=GRBLHAL)
    assert board.say(b"G10L2P7X-3\n") == ["ok"] and "[G59.1:-3.000,0.000,0.000]" in board.say(b"$#\n")
    assert board.say(b"G59.1\n") == ["ok"] and "[GC:G0 G59.1 " in board.say(b"$G\n")[0]
    assert board.say(b"G59.4\n") == ["error:23"] and board.say(b"G10L2P10X1\n") == ["error:29"]


@pytest.mark.parametrize("firmware", [GRBL, FLUIDNC], ids=lambda firmware: firmware.name)
def test_grbl_and_fluidnc_neither_drill_nor_have_more_work_systems(talk, firmware):
    board = talk(firmware=firmware)
    for line, error in (("G81X1Z-1R1F300", 20), ("G98", 20), ("G59.1", 23), ("G10L2P7X1", 29), ("X1Q1", 20)):
        assert board.say(f"{line}\n".encode("ascii")) == [f"error:{error}"], line
