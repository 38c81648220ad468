# SPDX-License-Identifier: LGPL-2.1-or-later
"""Conversations with the virtual grbl: lines and answers, real-time bytes, states, settings."""

from __future__ import annotations

import re

import numpy as np
import pytest

from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.path_trace import Trace

RESET = "\x18"
LOCKED = "[MSG:'$H'|'$X' to unlock]"
BANNER = "Grbl 1.1h ['$' for help]"


def test_greets_and_waits_idle(talk) -> None:
    board = talk()
    assert board.greeting == [BANNER]
    assert board.status() == {
        "": "Idle",
        "MPos": "0.000,0.000,0.000",
        "Bf": "15,128",
        "FS": "0,0",
        "WCO": "0.000,0.000,0.000",
    }


def test_homing_locks_at_power_up(talk) -> None:
    board = talk(homing=True)
    assert board.greeting == [BANNER, LOCKED]
    assert board.status()[""] == "Alarm"
    assert board.line("G0X1") == "error:9"
    assert board.say("$X\n") == ["[MSG:Caution: Unlocked]", "ok"]
    assert board.line("G0X1") == "ok"


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("", ["ok"]),
        ("   ", ["ok"]),
        ("(a comment)", ["ok"]),
        ("; a comment (with another", ["ok"]),
        ("g0 x1 (to the) y2 ; right", ["ok"]),
        ("/G0X1", ["ok"]),
        ("G0 X1 (open", ["ok"]),
        ("$", ["[HLP:$$ $# $G $I $N $x=val $Nx=line $J=line $SLP $C $X $H ~ ! ? ctrl-x]", "ok"]),
        ("$I", ["[VER:1.1h.20190830:]", "[OPT:V,15,128]", "ok"]),
        ("$N", ["$N0=", "$N1=", "ok"]),
        ("$G", ["[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]", "ok"]),
        ("$X", ["ok"]),
        ("$H", ["error:5"]),
        ("$Q", ["error:2"]),
        ("$#1", ["error:3"]),
        ("$IX", ["error:3"]),
        ("$GG", ["error:3"]),
        ("$SL", ["error:3"]),
        ("$J", ["error:3"]),
        ("$RST=x", ["error:3"]),
        ("$RST", ["error:3"]),
        ("$100", ["error:3"]),
        ("$=1", ["error:2"]),
        ("$999=1", ["error:3"]),
        ("$33=1", ["error:3"]),
        ("$103=1", ["error:3"]),
        ("$100=x", ["error:2"]),
        ("$100=1x", ["error:3"]),
        ("$100=-1", ["error:4"]),
        ("$0=2", ["error:6"]),
        ("$20=1", ["error:10"]),
        ("$N2=G0", ["error:3"]),
        ("$N0=G5", ["error:20"]),
        ("%", ["error:1"]),
        ("X" * 79, ["error:2"]),
        ("X" * 80, ["error:11"]),
        (" " * 200 + "G0X1", ["ok"]),
        ("(" + "c" * 100 + ")G0X1", ["ok"]),
    ],
)
def test_a_line_and_its_answer(grbl, line: str, answer: list[str]) -> None:
    said: list[str] = []
    for part in re.findall(r".{1,100}", line) or [""]:  # the ring holds 128 bytes
        said += grbl.say(part)
    assert said + grbl.say("\n") == answer


def test_both_line_ends_count_as_lines(grbl) -> None:
    assert grbl.say("G0X1\r\n") == ["ok", "ok"]


def test_lists_the_profiles_settings(grbl) -> None:
    lines = grbl.say("$$\n")
    settings = dict(line.split("=") for line in lines[:-1])
    assert settings["$100"] == "80.000"
    assert settings["$112"] == "800.000"
    assert settings["$122"] == "50.000"
    assert settings["$130"] == "400.000"
    assert settings["$11"] == "0.010"
    assert settings["$30"] == "24000"
    assert [*map(int, (name[1:] for name in settings))] == sorted(int(name[1:]) for name in settings)
    assert len(settings) == 34


@pytest.mark.slow
def test_a_setting_is_kept_over_a_reset_and_restored(grbl) -> None:
    assert grbl.line("$110=1234.5") == "ok"
    grbl.say(RESET)
    assert "$110=1234.500" in grbl.say("$$\n")
    assert grbl.say("$RST=$\n") == ["[MSG:Restoring defaults]", "ok", BANNER]
    assert "$110=5000.000" in grbl.say("$$\n")


def test_switching_homing_off_switches_soft_limits_off(grbl) -> None:
    assert [grbl.line(line) for line in ("$22=1", "$20=1", "$22=0")] == ["ok"] * 3
    assert "$20=0" in grbl.say("$$\n")


def test_steps_per_mm_change_the_reported_place(grbl) -> None:
    grbl.line("G0X8")
    grbl.until_idle()
    assert grbl.line("$100=160") == "ok"
    assert grbl.status()["MPos"] == "4.000,0.000,0.000"
    grbl.say(RESET)
    grbl.line("G0X8")
    grbl.until_idle()
    assert grbl.board.axes.position_steps[0] == 1280


def test_position_is_reported_as_settings_say(grbl) -> None:
    grbl.say("G10L2P1X5\n")
    grbl.line("$10=0")
    assert grbl.status()["WPos"] == "-5.000,0.000,0.000"
    assert "Bf" not in grbl.status()
    grbl.line("$13=1")
    assert grbl.status()["WPos"] == "-0.1969,0.0000,0.0000"


def test_offsets_come_now_and_then_and_after_a_change(grbl) -> None:
    fields = [set(grbl.status()) for _ in range(12)]
    assert ["WCO" in report for report in fields] == [True] + [False] * 9 + [True, False]
    assert ["Ov" in report for report in fields] == [False, True] + [False] * 9 + [True]
    grbl.line("G92X1")
    assert grbl.status()["WCO"] == "-1.000,0.000,0.000"


def test_parameters(grbl) -> None:
    for line in ("G10L2P2X1Y2Z3", "G55", "G43.1Z4", "G10L20P1X10", "G92Y5"):
        assert grbl.line(line) == "ok"
    said = grbl.say("$#\n")
    assert said[0] == "[G54:-10.000,0.000,0.000]"
    assert said[1] == "[G55:1.000,2.000,3.000]"
    assert said[6:] == [
        "[G28:0.000,0.000,0.000]",
        "[G30:0.000,0.000,0.000]",
        "[G92:0.000,-7.000,0.000]",
        "[TLO:4.000]",
        "[PRB:0.000,0.000,0.000:0]",
        "ok",
    ]
    grbl.say(RESET)
    said = grbl.say("$#\n")
    assert said[1] == "[G55:1.000,2.000,3.000]"  # kept
    assert said[8] == "[G92:0.000,0.000,0.000]"  # forgotten
    assert grbl.say("$RST=#\n")[0] == "[MSG:Restoring defaults]"
    assert grbl.say("$#\n")[1] == "[G55:0.000,0.000,0.000]"


def test_modal_state_and_program_end(grbl) -> None:
    grbl.say("G91 G20 G18 G55 G93 M3 S5000 M8 F10 T3\n")
    assert grbl.say("$G\n")[0] == "[GC:G0 G55 G18 G20 G91 G93 M3 M8 T3 F0 S5000]".replace("F0", "F10")
    assert grbl.say("M2\n") == ["[MSG:Pgm End]", "ok"]
    assert grbl.say("$G\n")[0] == "[GC:G1 G54 G17 G20 G90 G94 M5 M9 T0 F0 S5000]"
    assert grbl.status()["FS"] == "0,0"


def test_go_home_goes_over_the_point_given(grbl) -> None:
    grbl.say("G0X3Y4\nG28.1\nG30.1\nG0X10Y10\n")
    grbl.until_idle()
    assert grbl.line("G28Y20") == "ok"
    grbl.until_idle()
    assert grbl.status()["MPos"] == "10.000,4.000,0.000"
    grbl.line("G30")
    grbl.until_idle()
    assert grbl.status()["MPos"] == "3.000,4.000,0.000"


def test_real_time_bytes_act_wherever_they_stand(grbl) -> None:
    assert grbl.say("G1 X50 F600 (what?)\n", 0.5)[0].startswith("<Idle|")
    grbl.say("( stop ! here )\n", 0.5)
    assert grbl.status()[""] == "Hold:0"
    grbl.say("~")
    assert grbl.status()[""] == "Run"
    grbl.say(b"; \x91 10 % more, in a comment\n")
    assert grbl.status()["Ov"] == "110,100,100"
    assert grbl.say("G0(\xe2\x82\xac)X1\n") == ["ok"]  # bytes above 0x7F never reach a line


def test_bytes_that_find_the_ring_full_are_lost(grbl) -> None:
    grbl.say("G1X1F60\nG4P5\n")  # the dwell waits for the move, so nothing is read
    grbl.board.receive(b"G0X1\n" * 30)
    assert grbl.board.ring.lost == 22
    assert grbl.status()["Bf"].endswith(",0")
    said = grbl.until_idle()
    assert said[:2] == ["ok", "ok"]
    assert len(said) == 1 + 25  # 25 whole lines of 30; of the 26th "G0X" came through
    assert grbl.say("\n") == ["error:2"]


def test_feed_hold_and_cycle_start(grbl) -> None:
    grbl.say("G1X10F600\n", 0.5)
    grbl.say("!")
    assert grbl.status()[""].startswith("Hold:")
    grbl.say(b"", 0.5)
    assert grbl.status()[""] == "Hold:0"
    assert grbl.say("$G\n", 0.2) == []  # a held board reads no lines
    grbl.say("~")
    assert grbl.status()[""] == "Run"
    grbl.until_idle()
    assert grbl.status()["MPos"] == "10.000,0.000,0.000"


def test_a_hold_lengthens_a_dwell(grbl) -> None:
    grbl.say("G4P1\n", 0.5)
    assert grbl.status()[""] == "Idle"
    grbl.say("!", 3.0)
    assert grbl.status()[""] == "Hold:0"
    assert grbl.say("~", 0.4) == []
    assert grbl.say(b"", 0.2) == ["ok"]


def test_program_pause_waits_for_cycle_start(grbl) -> None:
    assert grbl.say("G1X1F600\nM0\nG1X2\n", 3.0) == ["ok"]
    assert {"": "Hold:0", "MPos": "1.000,0.000,0.000"}.items() <= grbl.status().items()
    assert grbl.say("~", 0.1) == ["ok", "ok"]
    grbl.until_idle()
    assert grbl.status()["MPos"] == "2.000,0.000,0.000"


def test_reset_in_motion_loses_the_position(grbl) -> None:
    grbl.say("G1X10F600\n", 0.5)
    assert grbl.say(RESET) == ["ALARM:3", BANNER, LOCKED]
    assert grbl.status()[""] == "Alarm"
    assert grbl.line("G0X1") == "error:9"
    assert grbl.line("$J=X1F100") == "error:8"
    assert grbl.line("$G") == "ok"


def test_reset_in_a_finished_hold_keeps_it(grbl) -> None:
    grbl.say("G1X10F600\n", 0.5)
    grbl.say("!", 1.0)
    place = grbl.status()["MPos"]
    assert grbl.say(RESET) == [BANNER]
    assert {"": "Idle", "MPos": place}.items() <= grbl.status().items()
    grbl.line("G91G0X1")
    grbl.until_idle()
    assert float(grbl.status()["MPos"].split(",")[0]) == pytest.approx(float(place.split(",")[0]) + 1, abs=0.013)


def test_reset_answers_the_line_in_hand(grbl) -> None:
    grbl.say("G4P10\n")
    assert grbl.say(RESET) == ["ok", BANNER]


def test_ok_waits_for_room_in_the_planner(grbl) -> None:
    lines = [f"G1X{n % 2}F60\n" for n in range(1, 21)]
    said = [answer for line in lines for answer in grbl.say(line)]
    assert said == ["ok"] * 15
    assert grbl.status()["Bf"].startswith("0,")
    assert len(grbl.say(b"", 1.2)) == 1


def test_commands_at_rest_are_refused_while_moving(grbl) -> None:
    grbl.say("G1X10F600\n", 0.1)
    for line in ("$$", "$#", "$I", "$N", "$100=1", "$C", "$SLP", "$J=X1F100", "$RST=*", "$H"):
        assert grbl.line(line) == "error:8", line
    assert grbl.line("$G") == "ok"


def test_jogging(grbl) -> None:
    assert grbl.say("$J=G91 X5 F600\n", 0.1) == ["ok"]
    assert grbl.status()[""] == "Jog"
    assert grbl.line("G0X1") == "error:9"
    assert grbl.line("$J=X7F600") == "ok"
    grbl.until_idle()
    assert grbl.status()["MPos"] == "7.000,0.000,0.000"
    assert grbl.say("$G\n")[0] == "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]"


@pytest.mark.parametrize("byte", [b"\x85", b"!"])
def test_a_jog_is_cancelled_without_losing_the_place(grbl, byte: bytes) -> None:
    grbl.say("$J=X50F1200\n$J=X0F1200\n", 0.5)
    grbl.say(byte, 1.0)
    report = grbl.status()
    assert report[""] == "Idle"
    assert report["Bf"] == "15,128"
    x_mm = float(report["MPos"].split(",")[0])
    assert 1 < x_mm < 20
    grbl.line("G91G0Y1")
    grbl.until_idle()
    assert grbl.status()["MPos"] == f"{x_mm:.3f},1.000,0.000"


def test_jog_cancel_outside_a_jog_does_nothing(grbl) -> None:
    grbl.say("G1X10F600\n", 0.2)
    grbl.say(b"\x85")
    assert grbl.status()[""] == "Run"


def test_soft_limits(talk) -> None:
    board = talk(homing=True)
    assert board.line("$20=1") == "ok"
    board.say("$X\n")
    assert board.line("$J=X1F100") == "error:15"
    assert board.line("G1X-20F600") == "ok"
    board.say(b"", 0.5)
    said = board.say("G1X1\n", 2.0)
    assert said == ["ALARM:2", "[MSG:Reset to continue]"]
    x_mm = float(board.status()["MPos"].split(",")[0])
    assert -20 < x_mm < 0
    assert board.say("$X\n", 0.1) == []
    assert board.say(RESET) == ["ok", BANNER, LOCKED]
    assert board.say("$X\n") == ["[MSG:Caution: Unlocked]", "ok"]


def test_check_mode_reads_without_moving(grbl) -> None:
    assert grbl.say("$C\n") == ["[MSG:Enabled]", "ok"]
    assert grbl.status()[""] == "Check"
    assert grbl.say("G1X10F100\nM3S1000\nG4P60\nM0\nG2X5\nM30\n") == [
        "ok", "ok", "ok", "ok", "error:35", "[MSG:Pgm End]", "ok",
    ]  # fmt: skip
    assert grbl.status()["MPos"] == "0.000,0.000,0.000"
    assert grbl.say("$C\n") == ["[MSG:Disabled]", "ok", BANNER]
    assert grbl.status()[""] == "Idle"


def test_sleep_ends_with_a_reset_in_alarm(grbl) -> None:
    grbl.say("M3S5000\n")
    assert grbl.say("$SLP\n") == ["ok", "[MSG:Sleeping]"]
    assert {"": "Sleep", "FS": "0,0"}.items() <= grbl.status().items()
    assert grbl.say("$X\n~", 0.1) == []
    assert grbl.say(RESET) == [BANNER, LOCKED]


def test_safety_door(grbl) -> None:
    grbl.say("M3S5000\nM8\nG1X10F600\n", 0.5)
    assert grbl.say(b"\x84")[0] == "[MSG:Check Door]"
    grbl.say(b"", 0.5)
    assert {"": "Door:0", "FS": "0,0"}.items() <= grbl.status().items()
    grbl.say("~", 1.0)
    assert {"": "Door:3", "FS": "0,5000"}.items() <= grbl.status().items()
    grbl.say(b"", 4.2)
    assert grbl.status()[""] == "Run"
    grbl.until_idle()
    assert grbl.status()["MPos"] == "10.000,0.000,0.000"


def test_overrides_stop_at_their_ends(grbl) -> None:
    grbl.say(b"\x91" * 15 + b"\x96" + b"\x9b" * 20)
    grbl.status()
    assert grbl.status()["Ov"] == "200,50,10"
    grbl.say(b"\x94\x95\x9c")
    assert grbl.status()["Ov"] == "199,100,11"
    grbl.say(b"\x90\x97\x99")
    assert grbl.status()["Ov"] == "100,25,100"
    grbl.say("M30\n")
    grbl.status()
    assert grbl.status()["Ov"] == "100,100,100"


def test_feed_override_changes_the_speed(grbl) -> None:
    grbl.say("G1X100F600\n", 1.0)
    assert grbl.status()["FS"] == "600,0"
    grbl.say(b"\x91\x91", 0.5)
    assert grbl.status()["FS"] == "720,0"


@pytest.mark.parametrize(("laser", "held_rpm"), [(0, 8000), (1, 0)])
def test_laser_is_off_while_it_is_held_and_a_spindle_is_not(grbl, laser: int, held_rpm: int) -> None:
    grbl.line(f"$32={laser}")
    grbl.line("M3 S8000")
    grbl.say(b"M0\n", 0.1)
    assert grbl.status()[""] == "Hold:0" and grbl.board.spindle.rpm == held_rpm
    grbl.say(b"~", 0.1)
    assert grbl.status()[""] == "Idle" and grbl.board.spindle.rpm == 8000


def test_spindle_stop_only_in_hold(grbl) -> None:
    grbl.say("M4S8000\n")
    grbl.say(b"\x9e")
    assert grbl.status()["FS"] == "0,8000"
    grbl.say("!")
    grbl.say(b"\x9e")
    assert grbl.status()["FS"] == "0,0"
    assert grbl.say("~") == ["[MSG:Restoring spindle]"]
    grbl.status()
    report = grbl.status()
    assert report["FS"] == "0,8000"


def test_accessories_are_reported(grbl) -> None:
    grbl.say("M3S8000\nM8\n")
    grbl.status()
    assert grbl.status()["A"] == "SF"
    grbl.say(b"\xa0")
    assert grbl.status()["A"] == "S"
    assert " M9 " in grbl.say("$G\n")[0]


def test_spindle_speed_is_kept_within_its_limits(grbl) -> None:
    for programmed, told in ((50000, 24000), (10, 1000), (0, 0), (12000, 12000)):
        grbl.line(f"M3S{programmed}")
        assert grbl.status()["FS"] == f"0,{told}"


def test_startup_lines_run_at_reset(grbl) -> None:
    assert grbl.line("$N0=G91 G20") == "ok"
    assert grbl.line("$N1=G55") == "ok"
    assert grbl.say(RESET) == [BANNER, ">G91G20:ok", ">G55:ok"]
    assert "G55 G17 G20 G91" in grbl.say("$G\n")[0]
    assert grbl.say("$N\n") == ["$N0=G91G20", "$N1=G55", "ok"]
    grbl.line("$I=MY TABLE")
    assert grbl.say("$I\n")[0] == "[VER:1.1h.20190830:MYTABLE]"
    assert grbl.say("$RST=*\n")[-1] == BANNER
    assert grbl.say("$N\n") == ["$N0=", "$N1=", "ok"]


@pytest.mark.slow
def test_homing_finds_the_switches(talk) -> None:
    board = talk(homing=True)
    assert board.say("$H\n", 1.0) == []
    assert board.status()[""] == "Home"
    assert board.until_idle() == ["ok"]
    assert board.status()["MPos"] == "-1.000,-1.000,-1.000"
    assert "Pn" not in board.status()
    board.line("G53 G0 X0")
    board.until_idle()
    assert board.status()["Pn"] == "X"


def test_homing_does_not_draw_its_new_zero_into_the_trace(machine, tmp_path) -> None:
    board = Grbl(machine, homing=True)
    trace = Trace(tmp_path / "trace.csv", board)
    board.receive(b"$H\n")
    while not board.quiet or b"ok" not in board.take_output():
        board.advance(0.01)
    trace.close()
    rows = np.loadtxt(tmp_path / "trace.csv", delimiter=",", skiprows=1)
    ways_mm = np.max(np.abs(np.diff(rows[:, 1:], axis=0)), axis=1)
    assert np.count_nonzero(ways_mm > 0.02) == 2  # one row each where Z, then X and Y, learn where they are
    assert list(rows[-1, 1:]) == [-1, -1, -1]
    assert np.all(np.diff(rows[:, 0]) >= 0)


def test_homing_is_broken_off_by_a_reset(talk) -> None:
    board = talk(homing=True)
    board.say("$H\n", 1.0)
    assert board.say(RESET) == ["ALARM:6", "ok", BANNER, LOCKED]
    board.say("$H\n", 1.0)
    assert board.say(b"\x84")[0] == "ALARM:7"


@pytest.mark.parametrize("code", [1, 2])
def test_homing_that_fails_finds_no_switch_and_resets_itself(talk, code) -> None:
    board = talk(homing=True)
    board.say("$H\n", 1.0)
    board.board.fail(code)
    assert board.say(b"") == ["ALARM:9", "ok", BANNER, LOCKED]
    assert board.status()[""] == "Alarm"


@pytest.mark.slow
def test_hard_limits(talk) -> None:
    board = talk(homing=True)
    board.say("$H\n")
    board.until_idle()
    board.line("$21=1")
    said = board.say("G1X5F6000\n", 2.0)
    assert said == ["ok", "ALARM:1", "[MSG:Reset to continue]"]
    assert board.say(RESET) == [BANNER, LOCKED]


def test_probing(talk) -> None:
    board = talk(probe_height_mm=-5.0)
    assert board.say("G38.2 Z-20 F100\n", 10.0) == ["[PRB:0.000,0.000,-5.000:1]", "ok"]
    assert board.status()["Pn"] == "P"
    z_mm = float(board.status()["MPos"].split(",")[2])
    assert -5.1 < z_mm <= -5.0
    assert board.say("$#\n")[-2] == "[PRB:0.000,0.000,-5.000:1]"
    assert board.say("G38.2 Z-20\n") == ["ALARM:4", "ok"]
    board.say("$X\n")
    said = board.say("G38.4 Z5\n", 10.0)
    assert said == ["[PRB:0.000,0.000,-4.998:1]", "ok"]
    board.say("G0Z0\n")
    board.until_idle()
    assert board.say("G38.3 Z-2 F100\n", 5.0) == ["[PRB:0.000,0.000,-2.000:0]", "ok"]
    assert board.say("G38.2 Z-3 F100\n", 5.0)[0] == "ALARM:5"
    assert board.status()[""] == "Alarm"


def test_inverse_time_feed(grbl) -> None:
    grbl.say("G93 G1 X20 F30\n", 1.0)  # 2 s
    assert grbl.status()["FS"] == "600,0"
    assert grbl.line("X30") == "error:22"
