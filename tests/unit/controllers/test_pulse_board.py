# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a board of ours says and takes beside moves: relays, switches, its own lines, and the end of its output."""

from __future__ import annotations

import itertools
import json

import pytest

from CNCStepper.control.protocol.grbl import status_reports
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.controllers.pulse_board import PulseBoard
from CNCStepper.errors import LinkError, MachineRefusal
from CNCStepper.machine.profile import Machine, load_machine, validated
from helpers.controllers.fake_output import FakeOutput
from helpers.controllers.talk import Talk

PINS = {
    "x_step": 2,
    "x_direction": 3,
    "y_step": 4,
    "y_direction": 5,
    "spindle_cw": 14,
    "flood": 1,
    "mist": 8,
    "output_0": 6,
    "output_1": 7,
}
RELAYS = ("spindle_cw", "flood", "mist", "output_0", "output_1")


def wired(**changes) -> Machine:
    content = load_machine("thesis-table").model_dump(mode="json", exclude={"axis"}, exclude_none=True)
    axes = {name: axis.model_dump(exclude_none=True) for name, axis in load_machine("thesis-table").axis.items()}
    signals = content.pop("signals") | {"pins": PINS}
    return validated(Machine, content | {"axis": axes, "signals": signals} | changes, "thesis-table")


@pytest.fixture
def talk() -> Talk:
    return Talk(wired(), wired=RELAYS)


def test_it_says_what_it_is_and_cannot_do(talk: Talk) -> None:
    assert talk.greeting == ["Grbl 1.1h ['$' for help]"]
    said = talk.say("$I\n")
    assert said[0] == "[VER:1.1h.20190830:]"
    cannot = [f"[CANNOT:{what}]" for what in ("home", "probe", "axis-z")]
    assert said[2:] == ["[FIRMWARE:CNCStepper parport]", *cannot, "ok"]


def test_its_settings_are_the_profiles(talk: Talk) -> None:
    said = talk.say("$$\n", 0.05)
    assert {"$100=40.000", "$110=1800.000", "$121=100.000", "$130=1000.000", "$22=0"} <= set(said)


def test_a_machine_without_z_reports_z_as_0_and_refuses_its_moves(talk: Talk) -> None:
    assert talk.status()["MPos"] == "0.000,0.000,0.000"
    talk.send("G21G90G94F900", "G1X1Z0", "G10L20P1Z5")
    assert talk.line("G1X2Z1") == "error:20"
    assert talk.line("$J=G91Z1F100") == "error:20"
    assert talk.line("G18G2X3Z6R5") == "error:20"
    talk.until_idle()
    assert talk.output.position_steps == (40, 0, 0)


def test_it_does_not_home_and_a_probe_never_moves(talk: Talk) -> None:
    assert talk.line("$H") == "error:5"
    assert talk.line("$22=1") == "error:5"
    assert "ALARM:4" in talk.say("G38.2X5F100\n")
    assert not talk.output.played


def test_relays_switch_at_a_standstill(talk: Talk) -> None:
    talk.send("G21G90G94F900", "M3S1", "G1X5", "M7", "M8", "G1X0", "M62P0", "M64P1", "G1X1", "M63P0M9", "M5")
    switched = talk.output.switched
    assert [(device, on) for _, device, on in switched] == [
        ("spindle_cw", True),
        ("mist", True),
        ("flood", True),
        ("output_0", True),
        ("output_1", True),
        ("flood", False),
        ("mist", False),
        ("output_0", False),
        ("spindle_cw", False),
    ]
    first_s, last_s = talk.output.played[0][0], talk.output.played[-1][0]
    assert switched[0][0] <= first_s
    assert switched[-1][0] >= last_s
    in_motion = [
        (before[0], after[0])
        for before, after in zip(talk.output.played, talk.output.played[1:], strict=False)
        if after[0] - before[0] < 0.01
    ]
    assert len(in_motion) > 300
    assert not [one for one in switched for begin_s, end_s in in_motion if begin_s < one[0] < end_s]


@pytest.mark.parametrize(("line", "answer"), [("M62P2", "error:39"), ("M62", "error:28"), ("M64P0.5", "error:23")])
def test_an_output_that_is_not_there_is_refused(talk: Talk, line: str, answer: str) -> None:
    assert talk.line(line) == answer
    assert not talk.output.switched


def test_a_reset_and_the_end_switch_everything_off(talk: Talk) -> None:
    talk.send("M3S1", "M8", "M64P0")
    assert talk.output.on == {"spindle_cw", "flood", "output_0"}
    talk.say(b"\x18", 0.01)
    assert not talk.output.on
    talk.send("M8")
    talk.board.close()
    assert talk.output.closed and talk.output.switched[-1][1:] == ("flood", False)


def test_asleep_nothing_is_on(talk: Talk) -> None:
    talk.send("M3S1", "M8", "M64P0")
    assert talk.output.on == {"spindle_cw", "flood", "output_0"}
    assert talk.line("$SLP", 0.05) and talk.status()[""] == "Sleep"
    assert not talk.output.on
    talk.say(b"\x18", 0.05)
    assert talk.line("$X") == "ok" and not talk.output.on


def test_the_status_names_what_is_on(talk: Talk) -> None:
    talk.send("M3S1", "M7", "M8")
    fields = [talk.status() for _ in range(12)]
    assert "SFM" in {one.get("A") for one in fields}
    assert "M3 M7 M8" in next(line for line in talk.say("$G\n") if line.startswith("[GC:"))


def test_a_relay_is_switched_by_its_name(talk: Talk) -> None:
    assert talk.line("$P=flood") == "ok" and talk.output.on == {"flood"}
    assert talk.line("$P=output_1") == "ok" and talk.output.on == {"flood", "output_1"}
    assert talk.line("$P=-FLOOD") == "ok" and talk.output.on == {"output_1"}
    assert talk.say("$P=lamp\n")[-1] == "error:3"
    talk.send("M9")
    assert talk.output.on == {"output_1"}


def test_a_relay_has_the_name_of_its_profile_too() -> None:
    talk = Talk(wired(relay=[{"name": "Main oxygen", "device": "output_0"}]), wired=RELAYS)
    assert talk.line("$P=main oxygen") == "ok" and talk.output.on == {"output_0"}
    assert talk.line("$P=-OUTPUT_0") == "ok" and not talk.output.on


def test_letters_are_played_at_the_profiles_interval() -> None:
    machine = wired(signals={"motors": ["x", "y"], "pins": PINS, "pulse_us": 400, "gap_us": 600})
    talk = Talk(machine, wired=RELAYS)
    talk.send("G21G90G94F900", "G1X1")
    first = len(talk.output.played)
    talk.send("$L=AAAADD", "$L=BMN")
    pulses = talk.output.played[first:]
    assert [(step, back) for _, step, back, _ in pulses] == [(1, 0)] * 4 + [(1, 1)] * 2 + [(2, 0), (3, 2), (3, 1)]
    waits_s = [after[0] - before[0] for before, after in itertools.pairwise(pulses)]
    assert waits_s[:5] == pytest.approx([0.001] * 5, abs=1e-6)
    talk.send("G1X0Y0")
    assert talk.output.position_steps == (0, 0, 0)


def test_letters_of_an_axis_that_is_not_there_are_refused(talk: Talk) -> None:
    assert talk.line("$L=AC") == "error:20"
    assert talk.line("$L=A5") == "error:3"
    talk.pass_time(0.1)
    assert not talk.output.played


def test_pulses_of_one_axis_are_counted(talk: Talk) -> None:
    talk.send("$N=+X200", "$N=-Y50")
    assert talk.output.position_steps == (200, -50, 0)
    assert talk.line("$N=Z5") == "error:20"
    assert talk.line("$N=5") == "error:3"
    assert talk.line("$N0=G21") == "ok"


def test_a_trial_is_answered_and_one_that_fails_says_why(talk: Talk) -> None:
    said = talk.say("$T=25000\n", 0.2)
    assert said[-1] == "ok" and said[0].startswith("[MSG:Trial 25000 pulses/s late mean 1.0 us worst 3.0 us")
    said = talk.say("$T=90000\n", 0.2)
    assert said[-1] == "error:90" and "cannot keep the rate" in said[0]
    talk.line("G21G91G1X20F900")
    assert talk.line("$T=1000") == "error:8"


SWITCHES = [
    {"pin": 10, "act": "pause", "debounce_ms": 10.0},
    {"pin": 11, "act": "start", "debounce_ms": 10.0},
    {"pin": 12, "act": "limit", "debounce_ms": 0.0},
    {"pin": 13, "act": "door", "level": "low", "debounce_ms": 5.0},
    {"pin": 15, "act": "back", "debounce_ms": 5.0},
]
NOTHING_PRESSED = frozenset({13})


@pytest.fixture
def with_switches() -> Talk:
    talk = Talk(wired(input=SWITCHES), wired=RELAYS)
    press(talk, set())
    return talk


def press(talk: Talk, pins: set[int]) -> None:
    talk.output.high = NOTHING_PRESSED ^ frozenset(pins)
    talk.pass_time(0.05)


def test_buttons_pause_and_start(with_switches: Talk) -> None:
    talk = with_switches
    talk.line("G21G91G1X50F900")
    talk.pass_time(0.5)
    press(talk, {10})
    assert talk.status()[""] == "Hold:1"
    press(talk, set())
    talk.pass_time(0.5)
    assert talk.status()[""] == "Hold:0"
    press(talk, {11})
    assert talk.status()[""] == "Run"
    talk.until_idle()
    assert talk.output.position_steps == (2000, 0, 0)


def test_a_limit_switch_stops_and_locks(with_switches: Talk) -> None:
    talk = with_switches
    assert "$21=1" in talk.say("$$\n")
    talk.line("G21G91G1X50F900")
    talk.pass_time(0.5)
    press(talk, {12})
    assert "ALARM:1" in talk.read()
    assert "stop_at_once" in [what for _, what in talk.output.commands]
    here = talk.output.position_steps
    assert talk.status()["Pn"] == "XYZ"
    talk.pass_time(0.5)
    assert talk.output.position_steps == here
    talk.say(b"\x18")
    assert talk.line("$X") == "ok"
    talk.send("G91G1X-1F900")
    assert talk.output.position_steps == (here[0] - 40, 0, 0)


def test_an_open_door_holds_until_it_is_closed(with_switches: Talk) -> None:
    talk = with_switches
    talk.send("M8")
    talk.line("G21G91G1X20F900")
    talk.pass_time(0.5)
    press(talk, {13})
    talk.pass_time(0.5)
    assert talk.status()[""] == "Door:1" and not talk.output.on
    talk.say("~")
    assert talk.status()[""] == "Door:1"
    press(talk, set())
    talk.say("~")
    talk.until_idle()
    assert talk.output.position_steps == (800, 0, 0) and talk.output.on == {"flood"}


@pytest.mark.parametrize("processes", [["plasma"], ["milling"]])
def test_a_torch_on_an_output_goes_off_behind_an_open_door_and_comes_back(processes: list[str]) -> None:
    """grbl leaves M62 on there; on a mill the output may be a clamp."""
    talk = Talk(wired(input=SWITCHES, processes=processes), wired=RELAYS)
    press(talk, set())
    talk.send("M62P0")
    talk.line("G21G91G1X20F900")
    talk.pass_time(0.5)
    press(talk, {13})
    assert talk.output.rate_mm_min > 0 and "output_0" in talk.output.on, "it still brakes"
    talk.pass_time(0.5)
    is_mill = processes == ["milling"]
    assert talk.status()[""] == "Door:1" and talk.output.on == ({"output_0"} if is_mill else set())
    press(talk, set())
    assert talk.output.on == ({"output_0"} if is_mill else set()), "until somebody resumes"
    talk.say("~")
    assert talk.output.on == {"output_0"} and talk.status()[""] == ("Run" if is_mill else "Door:3")
    here = talk.output.position_steps
    talk.pass_time(3.5)
    assert is_mill or talk.output.position_steps == here
    talk.until_idle()
    assert talk.output.position_steps == (800, 0, 0) and talk.output.on == {"output_0"}


def test_a_button_for_the_way_back_is_reported_to_the_sender(with_switches: Talk) -> None:
    press(with_switches, {15})
    assert with_switches.status()["Pn"] == "A"
    press(with_switches, set())
    assert "Pn" not in with_switches.status()


def test_the_port_shows_its_high_pins_and_what_is_on_also_while_it_runs(with_switches: Talk) -> None:
    talk = with_switches
    talk.send("M8", "M62P0")
    talk.send("G1X40F600")
    press(talk, {15})
    fields = talk.status()
    line = f"<Run|MPos:1.000,0.000,0.000|In:{fields['In']}|Out:{fields['Out']}>"
    seen = status_reports.parse(line)
    assert isinstance(seen, status_reports.Status)
    assert set(seen.port_outputs or ()) == {"flood", "output_0"}
    assert set(seen.port_inputs or ()) == set(NOTHING_PRESSED ^ {15})
    status = SenderStatus(port_inputs=seen.port_inputs, port_outputs=seen.port_outputs)
    assert SenderStatus.from_json(json.loads(json.dumps(status.to_json()))) == status
    board = SenderStatus.from_json(json.loads(json.dumps(SenderStatus().to_json())))
    assert board.port_inputs is None and board.port_outputs is None


def test_the_end_of_the_output_is_told_and_locks(talk: Talk) -> None:
    talk.send("M8")
    talk.line("G21G90G1X50F900")
    talk.pass_time(0.5)
    here = talk.output.position_steps
    talk.output.error = LinkError("pulses-late", "a pulse came 4 ms late: ç [µs]", advice="home the machine")
    said = talk.say(b"", 0.01)
    assert said[0].startswith("[MSG:a pulse came 4 ms late: ? (us)") and said[1] == "ALARM:3"
    assert talk.status()[""] == "Alarm" and talk.status()["MPos"].startswith(f"{here[0] / 40:.3f}")
    assert talk.output.closed
    assert talk.say(b"\x18")[-1] == "[MSG:'$H'|'$X' to unlock]"
    assert talk.line("$X") == "error:9" and talk.line("G1X1") == "error:9"


def test_a_laser_is_refused() -> None:
    with pytest.raises(MachineRefusal, match="beam"):
        PulseBoard(load_machine("laser-table"), FakeOutput())
