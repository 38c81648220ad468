# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fault proxy: what a plan says is read whole or refused, and each kind does what its name says, once."""

from __future__ import annotations

import json

import pytest
from click.testing import CliRunner

from CNCStepper.cli.machine.virtual import command
from CNCStepper.errors import JobError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.faults.host_faults import kill_sender, plan_for_server
from CNCStepper.virtual.faults.plan import KINDS, Fault, FaultPlan, read_plan
from CNCStepper.virtual.grbl.machine import STARTS_UP_S, Grbl
from CNCStepper.virtual.grbl.states import State
from CNCStepper.virtual.server.fault_proxy import FaultyLink
from CNCStepper.virtual.server.serial_line import Link

TICK_S = 0.002


class Line:
    """A board behind a faulty line that has said its greeting."""

    def __init__(self, *faults: dict, seed: int = 1, outside=lambda fault: None):
        self.told: list[str] = []
        plan = FaultPlan(seed=seed, fault=tuple(Fault(**fault) for fault in faults))
        self.board = Grbl(load_machine("table-a"))
        self.link = FaultyLink(
            Link(self.board), plan, outside=outside, told=lambda fault, time_s: self.told.append(fault.kind)
        )
        self.greeting = self.wait(0.1)

    def wait(self, seconds: float) -> str:
        heard = b""
        for _ in range(round(seconds / TICK_S)):
            self.link.advance(TICK_S)
            heard += self.link.receive()
        return heard.decode("ascii", "replace")

    def say(self, text: str, wait_s: float = 0.1) -> str:
        self.link.send(text.encode("latin-1"))
        return self.wait(wait_s)


def fault(kind: str, **words) -> dict:
    moment = {} if "at_byte" in words else {"at_s": 0.2}
    return {"kind": kind} | moment | words


def test_line_without_faults_passes_everything():
    line = Line()
    assert "Grbl 1.1h" in line.greeting
    assert line.say("G1X1F600\n", 0.5) == "ok\r\n"
    assert line.link.quiet and not line.link.fired


def test_dropped_bytes_do_not_arrive():
    line = Line(fault("drop", at_byte=3, count=2))
    line.say("G1X125F600\n", 2.0)
    assert line.board.axes.position_mm[0] == 5.0
    assert line.link.ways["in"].damaged == 2 and line.told == ["drop"]


def test_duplicated_bytes_arrive_twice():
    line = Line(fault("duplicate", at_byte=3))
    line.say("G1X1F6000\n", 2.0)
    assert line.board.axes.position_mm[0] == 11.0


def test_corrupted_bits_make_x90_of_x10():
    line = Line(fault("corrupt", at_byte=3, bits=ord("1") ^ ord("9")))
    assert line.say("G1X10F6000\n", 4.0) == "ok\r\n"
    assert line.board.axes.position_mm[0] == 90.0


def test_corruption_left_to_chance_follows_the_seed():
    heard = [Line(fault("corrupt", way="out", at_byte=40, count=9), seed=seed).say("$G\n", 0.2) for seed in (1, 1, 2)]
    assert heard[0] == heard[1] != heard[2]


def test_delayed_bytes_come_late_and_in_order():
    line = Line(fault("delay", way="out", at_byte=28, for_s=0.5))
    assert line.say("G1X1F600\nG1X2\n", 0.4) == "" and not line.link.quiet
    assert line.wait(0.4) == "ok\r\nok\r\n"


def test_withheld_answers_are_never_heard():
    line = Line(fault("withhold", at_s=0.0, count=2))
    assert line.say("G1X1F60\nG1X2\nG1X3\n", 0.5) == "ok\r\n"
    assert line.board.axes.rate_mm_min > 0 and line.told == ["withhold"]


def test_flood_stands_between_whole_lines():
    line = Line(fault("flood", count=3, text="[MSG:Flood]"))
    heard = line.say("?" * 20, 1.0).split("\r\n")
    assert heard.count("[MSG:Flood]") == 3
    assert all(text.startswith("<") and text.endswith(">") for text in heard if text and "Flood" not in text)


@pytest.mark.parametrize(("when", "alarm"), [("motion", True), ("rest", False)])
def test_reset_waits_for_its_moment(when, alarm):
    line = Line(fault("reset", when=when))
    heard = line.say("G1X5F600\n", 1.5)
    assert ("ALARM:3" in heard) is alarm and "Grbl 1.1h" in heard
    assert line.board.axes.position_mm[0] == (pytest.approx(0.5, abs=0.6) if alarm else 5.0)


def test_dead_stop_in_motion_loses_steps_and_one_at_rest_does_not():
    moving, resting = Line(fault("reset", when="motion")), Line(fault("reset", when="rest"))
    before = list(moving.board.axes.lost_steps)
    for line in (moving, resting):
        line.say("G1X5F600\n", 1.5)
    assert moving.board.axes.lost_steps != before == resting.board.axes.lost_steps


def test_power_loss_counts_from_zero_again():
    line = Line(fault("power", at_s=0.4))
    heard = line.say("G1X5F600\n", 0.6)
    assert "Grbl 1.1h" in heard and "ALARM" not in heard
    assert line.board.axes.position_mm == [0.0, 0.0, 0.0]


def test_board_is_deaf_while_it_starts_up_after_a_power_loss():
    line = Line(fault("power"), fault("reset", at_s=0.21))
    heard = line.wait(0.1) + line.say("G1X5F600\n?", STARTS_UP_S - 0.02)
    assert heard == "" and not line.link.quiet and line.told == ["power"]
    assert line.say("", 0.05).count("Grbl 1.1h") == 2 and line.told == ["power", "reset"]
    line.wait(1.0)
    assert line.board.axes.position_mm[0] == 0.0 and line.link.quiet


def test_alarm_at_the_moment_of_a_power_loss_waits_until_the_board_has_started():
    line = Line(fault("power"), fault("alarm"))
    heard = line.wait(0.3)
    assert heard.index("Grbl 1.1h") < heard.index("ALARM:1") and "Grbl 1.1h" in line.say("\x18")


@pytest.mark.parametrize(("code", "kept"), [(1, False), (2, True)])
def test_alarm_stops_dead_or_after_a_ramp(code, kept):
    line = Line(fault("alarm", code=code, when="motion"))
    before = list(line.board.axes.lost_steps)
    heard = line.say("G1X5F600\n", 1.0)
    assert f"ALARM:{code}" in heard and line.board.state is State.ALARM
    assert (line.board.axes.lost_steps == before) is kept


def test_close_is_told_once_and_loses_what_is_on_the_way():
    line = Line(fault("delay", at_byte=0, for_s=9.0), fault("close"))
    line.say("G1X5F600\n", 0.5)
    assert line.link.take_cut() and not line.link.take_cut()
    line.wait(10.0)
    assert line.board.axes.position_mm[0] == 0.0


@pytest.mark.parametrize("kind", ["kill", "disk"])
def test_faults_of_the_sender_are_left_to_who_has_it_at_hand(kind):
    called = []
    line = Line(fault(kind), outside=called.append)
    line.wait(0.3)
    assert [fault.kind for fault in called] == line.told == [kind]


def test_plan_is_read_from_toml_and_json(tmp_path):
    faults = [{"kind": kind, "at_s": 1.5, "count": 2} for kind in KINDS]
    toml, as_json = tmp_path / "ç plan.toml", tmp_path / "plan.json"
    toml.write_text("seed = 7\n" + "".join(f'[[fault]]\nkind = "{kind}"\nat_s = 1.5\ncount = 2\n' for kind in KINDS))
    as_json.write_text(json.dumps({"seed": 7, "fault": faults}))
    assert read_plan(toml) == read_plan(as_json) == FaultPlan(seed=7, fault=tuple(Fault(**one) for one in faults))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('[[fault]]\nkind = "drop"', "either at_byte or at_s"),
        ('[[fault]]\nkind = "drop"\nat_s = 1\nat_byte = 2', "either at_byte or at_s"),
        ('[[fault]]\nkind = "burn"\nat_s = 1', "kind"),
        ('[[fault]]\nkind = "drop"\nat_s = 1\nbaud = 2', "there is no key fault.0.baud"),
        ("seed = ", "not a TOML file"),
    ],
)
def test_plan_that_makes_no_sense_is_refused(tmp_path, text, said):
    path = tmp_path / "plan.toml"
    path.write_text(text)
    with pytest.raises(JobError, match=said) as caught:
        read_plan(path)
    assert str(path) in str(caught.value)


@pytest.mark.parametrize("content", ["[1]", "{"])
def test_json_that_is_no_plan_is_refused(tmp_path, content):
    path = tmp_path / "plan.json"
    path.write_text(content)
    with pytest.raises(JobError, match="not a"):
        read_plan(path)


@pytest.mark.parametrize("kind", ["kill", "disk"])
def test_command_line_refuses_what_it_cannot_do(tmp_path, kind):
    path = tmp_path / "plan.toml"
    path.write_text(f'[[fault]]\nkind = "{kind}"\nat_s = 1\n')
    with pytest.raises(JobError):
        plan_for_server(path)
    result = CliRunner().invoke(command, ["grbl", "--tcp", "127.0.0.1:0", "--faults", str(path)])
    assert isinstance(result.exception, JobError) and kind in str(result.exception)


def test_kill_of_a_process_that_has_ended_is_no_error_and_a_file_without_one_is(tmp_path):
    path = tmp_path / "service.session"
    path.write_text('{"process": 999999999}')
    kill_sender(Fault(kind="kill", at_s=0, pid_file=str(path)))
    path.write_text("{}")
    with pytest.raises(JobError, match="no process"):
        kill_sender(Fault(kind="kill", at_s=0, pid_file=str(path)))
