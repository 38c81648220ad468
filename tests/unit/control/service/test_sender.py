# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender against a scripted controller in memory, in a time of its own."""

from __future__ import annotations

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from CNCStepper.control.preflight.checks import check_zero_here
from CNCStepper.control.program.bundle import write_bundle
from CNCStepper.control.program.send_job import SendJob, read_job, write_job
from CNCStepper.control.protocol.grbl.connect import ControllerInfo
from CNCStepper.control.protocol.grbl.driver import Grbl
from CNCStepper.control.protocol.grbl.readiness import state_refusal
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.protocol.grbl.status_reports import parse
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED
from CNCStepper.control.stream.overrides import override_byte
from CNCStepper.errors import JobError, LinkError, MachineRefusal, Place, ProgramError
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.machine.profile import load_machine
from helpers.control.sender_bench import LINES, Bench


def test_job_is_done_when_all_lines_are_acknowledged_and_the_machine_is_idle():
    bench = Bench()
    outcome = bench.run()
    assert outcome.kind == DONE and outcome.done and outcome.position_known
    assert bench.controller.lines == list(LINES)
    assert outcome.status.sent == outcome.status.acknowledged == outcome.status.total == len(LINES)
    assert bench.phases() == ["running", "finishing", "done"]
    assert bench.link.closed
    assert outcome.status.mpos_mm == (-41.0, -47.0, -10.0)
    assert outcome.status.wpos_mm == (59.0, 3.0, 10.0)
    outcome.raise_for_error()


def test_done_waits_for_the_motion_after_the_last_ok():
    bench = Bench()
    bench.controller.keep_moving_s = 3.0
    begin_s = bench.clock()
    assert bench.run().done
    assert bench.clock() - begin_s > 3.0


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(
    lengths=st.lists(st.integers(1, 79), min_size=1, max_size=60),
    seed=st.integers(0, 2**32),
    line_s=st.sampled_from([0.0, 0.0001, 0.003, 0.02]),
    rx_bytes=st.sampled_from([128, 255, 1024]),
)
def test_window_never_overruns_and_never_starves(lengths, seed, line_s, rx_bytes):
    lines = [("G1X1." + "1" * 79)[:length] for length in lengths]  # a machine does not report 1e76 mm
    bench = Bench(lines, seed=seed, line_s=line_s, rx_bytes=rx_bytes)
    outcome = bench.run()
    assert outcome.done, outcome.text
    assert bench.controller.lines == lines
    assert bench.controller.most_bytes <= rx_bytes - 1


def test_window_is_used_in_full():
    bench = Bench(["G1X1"] * 400, line_s=0.01)
    assert bench.run().done
    assert 120 <= bench.controller.most_bytes <= 127


def test_larger_buffer_in_the_status_widens_the_window():
    bench = Bench(["G1X1"] * 400, line_s=0.01)
    bench.controller.report_extra = "|Bf:100,1023"
    assert bench.run().done
    assert 1000 < bench.controller.most_bytes <= 1022


def test_counting_test_can_fail():
    bench = Bench(["G1X1"] * 100, line_s=0.01)
    bench.controller.report_extra = "|Bf:100,1023"  # a controller that lies about its 128 bytes
    bench.run()
    assert bench.controller.most_bytes > 127


def test_lines_that_store_are_sent_alone():
    lines = ["G1X1", "G1X2", "G10 L20P1X0", "G1X3", "G28.1", "G1X4", "$100=80", "G1X5"]
    bench = Bench(lines, line_s=0.01)
    assert bench.run().done
    assert bench.controller.alone_broken == 0


def test_error_stops_feeding_holds_resets_and_names_the_line():
    bench = Bench(file_lines=tuple(range(101, 161)))
    bench.controller.on_line[7] = "error:20"
    outcome = bench.run()
    assert outcome.kind == FAILED
    assert isinstance(outcome.error, MachineRefusal)
    assert outcome.error.code == "grbl-error-20"
    assert outcome.error.place.line == 108
    assert "does not know this command" in outcome.text and "part.nc:108" in outcome.text
    realtime = [byte for byte in bench.controller.realtime if byte != "?"]
    assert realtime == ["!", "\x18"]
    assert outcome.position_known and "kept" in outcome.text
    assert outcome.status.acknowledged < outcome.status.sent < len(LINES)
    with pytest.raises(MachineRefusal):
        outcome.raise_for_error()


@pytest.mark.parametrize(("alarm", "known"), [(1, False), (2, True), (3, False), (5, True), (77, False)])
def test_alarm_ends_the_job_and_says_whether_the_position_is_known(alarm, known):
    bench = Bench()
    bench.controller.on_line[9] = f"ALARM:{alarm}"
    outcome = bench.run()
    assert outcome.kind == FAILED and outcome.error.code == f"grbl-alarm-{alarm}"
    assert outcome.position_known is known
    assert ("unknown" in outcome.text) is not known


@pytest.mark.parametrize(("cause", "code"), [("brownout", "controller-restarted"), ("reset", "grbl-alarm-3")])
def test_greeting_in_the_middle_is_a_lost_position(cause, code):
    bench = Bench()
    bench.controller.on_line[9] = cause
    outcome = bench.run()
    assert outcome.kind == FAILED and outcome.error.code == code
    assert not outcome.position_known
    assert len(bench.controller.lines) < len(LINES)
    assert bench.controller.realtime[-1] in "?\x18" and "\x18" in bench.controller.realtime


def test_greeting_counts_also_where_half_a_line_is_refused_right_after_it():
    bench = Bench()
    bench.controller.actions[9] = lambda: bench.controller.say(f"\r\n{bench.controller.greeting}\r\nerror:1")
    outcome = bench.run()
    assert outcome.kind == FAILED and outcome.error.code == "controller-restarted" and not outcome.position_known


def test_controller_that_restarts_once_more_than_it_was_told_to_has_lost_its_position():
    bench = Bench()
    bench.controller.on_line[9] = "ALARM:2"
    reset = bench.controller.reset

    def reset_and_fail() -> None:
        reset()
        bench.controller.say(bench.controller.greeting)

    bench.controller.reset = reset_and_fail
    outcome = bench.run()
    assert outcome.error.code == "grbl-alarm-2" and not outcome.position_known


def test_lost_link_is_an_error_with_unknown_position():
    bench = Bench()
    bench.controller.on_line[9] = "cut"
    outcome = bench.run()
    assert outcome.kind == FAILED and isinstance(outcome.error, LinkError)
    assert not outcome.position_known and bench.link.closed


def test_missing_answer_while_idle_is_an_error():
    bench = Bench(["G1X1", "G1X2", "G1X3"], timing=Timing(answer_s=2.0))
    bench.controller.on_line[1] = "silent"
    outcome = bench.run()
    assert outcome.kind == FAILED and outcome.error.code == "answer-missing"
    assert "idle" in outcome.text and outcome.position_known


def test_long_dwell_is_not_a_missing_answer():
    bench = Bench(["G1X1", "G1X3", "G4P30"], timing=Timing(answer_s=2.0), line_s=0.0)
    bench.controller.on_line[2] = "silent"
    clock, controller = bench.clock, bench.controller
    end_s = clock() + 25.0
    read = bench.link.read

    def late(wait_s: float) -> bytes:
        if clock() > end_s and len(controller.lines) == 3 and not late.said:
            late.said = True
            controller.say("ok")
        return read(wait_s)

    late.said = False
    bench.link.read = late
    assert bench.run().done
    assert clock() > end_s


def test_controller_that_falls_silent_is_an_error():
    bench = Bench(timing=Timing(answer_s=2.0, hold_s=1.0, wake_s=1.0))

    def fall_silent() -> None:
        bench.controller.mute = True

    bench.controller.actions[20] = fall_silent
    outcome = bench.run()
    assert outcome.kind == FAILED and outcome.error.code == "answer-missing"
    assert not outcome.position_known
    assert "!" in bench.controller.realtime and "\x18" in bench.controller.realtime


def test_stray_answer_is_an_error_and_the_machine_is_stopped():
    bench = Bench(["G1X1"], line_s=0.0)
    bench.controller.on_line[0] = "ok\r\nok\r\nok"
    outcome = bench.run()
    assert outcome.kind == FAILED and outcome.error.code == "answer-stray"
    assert "\x18" in bench.controller.realtime


def test_messages_and_startup_lines_are_not_counted():
    bench = Bench()
    bench.controller.actions[5] = lambda: bench.controller.say(">G54:ok")
    bench.controller.actions[6] = lambda: bench.controller.say("[MSG:Pgm End]")
    bench.controller.actions[7] = lambda: bench.controller.say("\x00garbage")
    assert bench.run().done
    assert ("message", "Pgm End") in bench.told
    assert any(kind == "warning" and "garbage" in text for kind, text in bench.told)


def test_hold_then_resume_loses_nothing():
    bench = Bench()
    bench.controller.actions[10] = bench.sender.hold
    bench.on_phase["held"] = bench.sender.resume
    outcome = bench.run()
    assert outcome.done
    assert bench.controller.lines == list(LINES)
    assert bench.phases() == ["running", "holding", "held", "running", "finishing", "done"]
    assert [byte for byte in bench.controller.realtime if byte != "?"] == ["!", "~"]


def test_resume_asked_while_slowing_down_waits_for_standstill():
    bench = Bench()
    bench.controller.actions[10] = lambda: (bench.sender.hold(), bench.sender.resume())
    assert bench.run().done
    assert [byte for byte in bench.controller.realtime if byte != "?"] == ["!", "~"]


def test_hold_is_written_at_once_and_before_any_further_line():
    bench = Bench()
    written: list[bytes] = []
    write = bench.link.write

    def log(data: bytes) -> None:
        written.append(data)
        write(data)

    bench.link.write = log
    bench.controller.actions[10] = lambda: (written.clear(), bench.sender.hold())
    bench.on_phase["held"] = bench.sender.stop
    bench.run()
    assert written[0] == b"!"


def test_stop_holds_waits_resets_and_keeps_the_position():
    bench = Bench()
    bench.controller.actions[10] = bench.sender.stop
    outcome = bench.run()
    assert outcome.kind == STOPPED and outcome.error is None and outcome.position_known
    assert "kept" in outcome.text and "ALARM" not in outcome.text
    assert [byte for byte in bench.controller.realtime if byte != "?"] == ["!", "\x18"]
    assert bench.controller.state == "Idle"


def test_stop_of_a_machine_that_does_not_stand_still_says_so():
    bench = Bench(timing=Timing(hold_s=1.0))
    bench.controller.deaf_to_hold = True
    bench.controller.keep_moving_s = 100.0
    bench.controller.actions[10] = bench.sender.stop
    outcome = bench.run()
    assert outcome.kind == STOPPED and not outcome.position_known and "unknown" in outcome.text


def test_stop_while_the_link_is_gone_is_a_failure():
    bench = Bench()

    def cut() -> None:
        bench.sender.stop()
        bench.controller.cut = True

    bench.controller.actions[10] = cut
    outcome = bench.run()
    assert outcome.kind == FAILED and isinstance(outcome.error, LinkError) and not outcome.position_known


def test_pause_of_the_program_shows_its_message_and_waits():
    lines = ["G1X1", "M0", "G1X2"]
    bench = Bench(lines, messages={1: "put in tool 2"})
    seen = []

    def at_pause() -> None:
        seen.append((list(bench.controller.lines), bench.sender.status().sent))
        bench.sender.resume()

    bench.on_phase["paused: put in tool 2"] = at_pause
    assert bench.run().done
    assert seen == [(["G1X1"], 1)]  # the sender stands there itself, and nothing follows before it is over
    assert bench.controller.lines == ["G1X1", "G1X2"]


def test_message_before_the_lines_that_lead_to_a_pause_is_shown_at_the_pause():
    lines = ["G1X1", "M5", "M0", "G1X2", "M0", "G1X3"]
    bench = Bench(lines, messages={1: "put in tool 2", 3: "going on"})
    bench.on_phase["paused: put in tool 2"] = bench.sender.resume
    bench.on_phase["paused: going on"] = bench.sender.resume
    assert bench.run().done
    assert [text for kind, text in bench.told if kind == "message"] == ["put in tool 2", "going on"]


def test_job_survives_its_way_to_the_process(tmp_path):
    wire = prepare("(a comment)\nG21\n(MSG, turn it)\nM0\nG1X1F100\n")
    expected = expected_settings(load_machine("table-a"))
    job = SendJob("loop://", wire.lines, "a.nc", wire.file_lines.tolist(), wire.messages, True, expected)
    write_job(tmp_path / "job.zip", job)
    again = read_job(tmp_path / "job.zip")
    assert list(again.lines) == ["G21", "M0", "G1X1F100"] and again.place(2) == job.place(2) == Place("a.nc", 5)
    assert again.messages == {1: "turn it"} and again.expected == expected and again.zero_confirmed


@pytest.mark.parametrize("head", [b"", b"[]", b"{}", b'{"port": "x", "speed": 3}', b'{"port": 1'])
def test_job_that_is_none_is_refused(head, tmp_path):
    with (tmp_path / "job.zip").open("wb") as file:
        write_bundle(file, {"job.json": [head], "wire.txt": [b"G0\n"]})
    with pytest.raises(JobError, match="not a job"):
        read_job(tmp_path / "job.zip")


def test_line_map_must_fit_the_lines():
    with pytest.raises(JobError, match="line map"):
        SendJob("x", ["G0"], file_lines=[1, 2])


def test_hold_asked_while_connecting_acts_before_the_first_line():
    bench = Bench()
    bench.sender.hold()
    bench.on_phase["held"] = bench.sender.resume
    assert bench.run().done
    assert bench.phases()[:3] == ["running", "holding", "held"]


def test_stop_asked_while_connecting_sends_nothing():
    bench = Bench()
    bench.sender.stop()
    assert bench.run().kind == STOPPED
    assert bench.controller.lines == [] and bench.link.closed


def test_zero_that_nobody_confirmed_is_refused_before_the_port_is_opened():
    bench = Bench(zero_confirmed=False)
    bench.sender._opener = None
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "zero-not-confirmed"
    assert "--zero-confirmed" in outcome.text


@pytest.mark.parametrize("state", ["Alarm", "Door", "Run", "Check", "Sleep", "Jog", "Home"])
def test_machine_that_is_not_idle_is_refused_untouched(state):
    bench = Bench()
    bench.controller.state = state
    bench.controller._busy_s = 1e9
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == f"machine-{state.lower()}"
    assert outcome.error.advice
    assert set(bench.controller.realtime) == {"?"} and not bench.controller.lines


def test_machine_that_answers_alarm_is_refused_in_words():
    bench = Bench()
    bench.controller.state = "Alarm"
    bench.controller.say("ALARM:1")
    outcome = bench.run()
    assert outcome.kind == REFUSED and "limit switch" in outcome.text
    assert not outcome.position_known


def restarted(*lines: str, zero=(0.0, 0.0, 0.0), place=(0.0, 0.0, 0.0), **job) -> Bench:
    """A controller that restarts when its port is opened: work zero, and where it says that it stands."""
    bench = Bench(lines or LINES, **job)
    bench.controller.zero, bench.controller.place = list(zero), list(place)
    bench.controller.reset()
    return bench


def test_after_a_greeting_on_opening_a_word_counts_where_the_tool_stands_on_the_zero():
    bench = restarted()
    assert bench.run().done
    assert any("restarted when its port was opened" in text for _, text in bench.told)


@pytest.mark.parametrize(
    ("bench", "said"),
    [
        (restarted(zero=(-10.0, 0.0, 0.0), place=(10.0, 0.0, 0.0)), "G54 was set before"),
        (restarted(place=(5.0, 0.0, 0.0)), "machine position is not 0"),
        (restarted("G90", "G28 X0"), "the program has G28"),
        (restarted("G53 G0 Z0"), "the program has G53"),
        (restarted("G0X1", zero=(-10.0, 0.0, 0.0), place=(10.0, 0.0, 0.0), allow_differences=True), "G54"),
    ],
)
def test_after_a_greeting_on_opening_no_word_makes_an_unknown_position_known(bench, said):
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "position-unknown" and said in outcome.text
    assert not outcome.position_known and "set the zero of all axes" in outcome.text
    assert not bench.controller.lines


def test_only_the_work_systems_that_a_program_uses_are_looked_at():
    offsets = {"G54": (0.0, 0.0, 0.0), "G55": (1.0, 2.0, 3.0), "G59.1": (4.0, 0.0, 0.0)}
    found = ControllerInfo("", offsets=offsets, modes="G0 G54")
    bench = restarted()
    driver = Grbl(bench.link, bench.clock)
    driver.settings[13] = 0.0  # reports in mm
    check_zero_here(["G0 X55", "G1 G54 X1"], driver, found)
    for line, name in (("G 55 X1", "G55 was set"), ("g59.1", "G59.1 was set"), ("G56", "G56 is not reported")):
        with pytest.raises(MachineRefusal, match=name):
            check_zero_here(["G54", line], driver, found)


def test_answers_to_an_earlier_senders_lines_are_not_taken_for_ours():
    bench = Bench()
    bench.controller.out += b"ok\r\nok\r\nerror:2\r\n"
    assert bench.run().done


def test_nothing_there_is_refused():
    bench = Bench()
    bench.controller.mute = True
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "not-grbl"
    assert "baud rate" in outcome.error.advice


@pytest.mark.parametrize("line", ["", "$I"])
def test_a_silent_controller_of_this_computer_is_called_by_its_profile(line):
    """A line: from there on nothing is answered. Where this computer is the controller, no baud rate is wrong."""
    bench = Bench()
    bench.link.machine = "my folder/thesis-table.toml"
    bench.controller.mute = not line
    if line:
        system = bench.controller._system
        bench.controller._system = lambda text: None if text == line else system(text)
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == ("answer-missing" if line else "not-grbl")
    assert "starts the controller of thesis-table anew" in outcome.error.advice and "baud" not in outcome.error.advice


def test_a_locked_machine_that_cannot_home_is_not_told_to_home():
    said = [state_refusal(parse("<Alarm|MPos:0,0,0|FS:0,0>"), cannot).advice for cannot in ((), ("home", "probe"))]
    assert "home the machine ($H)" in said[0] and "$H" not in said[1] and "connect again" in said[1]


def test_settings_of_another_machine_are_refused_naming_setting_value_and_wanted():
    bench = Bench(expected=expected_settings(load_machine("table-a")))
    assert bench.run().done
    bench = Bench(expected=expected_settings(load_machine("table-a")))
    bench.controller.settings[101] = 250
    bench.controller.settings[120] = 30
    outcome = bench.run()
    assert outcome.kind == REFUSED and outcome.error.code == "settings-differ"
    assert "$101 is 250, wanted 80" in outcome.text and "$120 is 30, wanted 250" in outcome.text
    assert not bench.controller.lines


def test_difference_may_be_allowed_and_is_told():
    bench = Bench(expected={110: 4000.0, 999: 1.0}, allow_differences=True)
    assert bench.run().done
    assert ("warning", "$110 is 5000, wanted 4000") in bench.told
    assert any("$999" in text for _, text in bench.told)


def test_positions_in_inches_are_converted():
    bench = Bench()
    bench.controller.settings[13] = 1
    assert bench.run().status.mpos_mm == pytest.approx((59 - 2540.0, 3 - 1270.0, 10 - 508.0), abs=0.02)


@pytest.mark.parametrize("text", ["G1X1!", "(why?)", "G1~", "G1X1\x18", "G1Xф", "G1X1\n", "\x85"])
def test_line_that_may_not_be_sent_is_refused_before_the_port_is_opened(text):
    bench = Bench([*LINES, text])
    bench.sender._opener = None
    outcome = bench.run()
    assert outcome.kind == REFUSED and isinstance(outcome.error, ProgramError)
    assert outcome.error.place.line == len(LINES) + 1


def test_empty_program_is_refused():
    assert Bench([]).run().error.code == "program-empty"


def test_a_fault_of_our_own_still_stops_the_machine():
    bench = Bench()

    def fault() -> None:
        raise ZeroDivisionError

    bench.controller.actions[10] = fault
    with pytest.raises(ZeroDivisionError):
        bench.run()
    assert "!" in bench.controller.realtime and "\x18" in bench.controller.realtime


def test_status_tells_lines_done_and_sent_buffer_outputs_and_what_remains():
    plan = [[number, 2.0 * number] for number in range(1, len(LINES) + 1)]
    bench = Bench(plan=plan, line_s=0.02)
    bench.controller.report_extra = "|Bf:3,60|Ov:100,50,100|A:SF"
    seen = []
    bench.controller.actions[40] = lambda: seen.append(bench.sender.status())
    assert bench.run().done
    status = seen[0]
    assert 0 < status.file_line < status.file_line_sent <= len(LINES)
    assert status.buffer == (3, 60) and status.outputs == "SF" and status.overrides == (100, 50, 100)
    assert 0 < status.done < 1 and status.remaining_s > 0
    end = bench.sender.status()
    assert end.done == 1.0 and end.remaining_s == 0.0


def test_coolant_is_switched_by_its_bytes():
    assert override_byte("coolant", "flood") == b"\xa0" and override_byte("coolant", "mist") == b"\xa1"
