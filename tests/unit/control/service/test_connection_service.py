# SPDX-License-Identifier: LGPL-2.1-or-later
"""A service at the virtual grbl in simulated time: jogs, zero, homing, alarms, overrides, jobs over its open link."""

from __future__ import annotations

import pytest

from CNCStepper.control.operator.jog import LAPSE_S
from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines
from CNCStepper.control.protocol.grbl.driver import HOLD, JOG_CANCEL, RESET
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED
from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl import suspend
from CNCStepper.virtual.grbl.states import State
from helpers.control.service_bench import Visit

SQUARE = ("G21G90G94", "G1X-20F1500", "G1Y-20", "G1X0", "G1Y0")


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path)


def keep_pressed(visit: Visit, seconds: float, press: str = "one", x: float = -1.0, feed_mm_min: float = 3000.0):
    """Press a jog button for so long, as a window's timer does it; it is not let go at the end."""
    end_s = visit.table.clock() + seconds
    while visit.table.clock() < end_s:
        visit.ask("jog_on", press=press, x_mm=x, y_mm=0.0, z_mm=0.0, feed_mm_min=feed_mm_min)
        yield 0.1


# --- connecting ------------------------------------------------------------------------------------


def test_locked_machine_is_met_told_and_unlocked(tmp_path):
    visit = Visit(tmp_path, homing=True)
    seen = []

    def person():
        seen.append(visit.service.status())
        visit.ask("unlock")
        yield visit.at("idle")
        seen.append(visit.service.status())

    visit.receive(person)
    locked, free = seen
    assert locked.phase == "alarm" and "home the machine" in locked.message and locked.homing is True
    assert free.phase == "idle" and free.message == "" and free.position_known is False
    assert visit.refused == [] and visit.table.closed


def test_machine_that_just_started_counts_from_where_it_stands(visit):
    visit.receive(lambda: iter(()))
    assert (
        "warning",
        "the controller restarted when its port was opened; it counts from its present position",
    ) in visit.told
    assert visit.service.status().position_known is False


def test_machine_that_moves_is_met_without_disturbing_it(visit):
    board = visit.table.board
    board.receive(b"G1X-10F1500\n")
    for _ in range(20):
        board.advance(0.01)
    board.take_output()
    seen = []

    def person():
        seen.append((visit.phase, b"".join(data for _, data in visit.table.written)))
        yield visit.at("idle")
        yield lambda: visit.service.status().homing is not None  # its settings are read once it stands

    visit.receive(person)
    phase, written = seen[0]
    assert phase == "busy" and set(written) == set(b"?")


def test_service_told_to_end_while_it_connects_sends_nothing(visit):
    visit.service.stop()
    visit.service.run()
    assert set(b"".join(data for _, data in visit.table.written)) <= set(b"?") and visit.table.closed


# --- jogging ---------------------------------------------------------------------------------------


def test_step_goes_its_way_and_ends(visit):
    def person():
        visit.ask("jog", x_mm=-5.0, y_mm=2.5)
        yield visit.at("jogging")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.table.board.axes.position_mm == pytest.approx((-5, 2.5, 0), abs=0.013)
    assert visit.refused == []


def test_steps_pressed_quickly_are_all_made_but_not_without_end(visit):
    def person():
        for _ in range(40):
            visit.ask("jog", x_mm=-1.0, feed_mm_min=600.0)
            yield 0.002
        yield visit.at("jogging")
        yield visit.at("idle")

    visit.receive(person)
    made = 40 - len(visit.refused)
    assert set(visit.refusals()) == {"jog-busy"} and made >= 15
    assert visit.table.x_mm() == pytest.approx(-made, abs=0.02)


def test_step_out_of_travel_is_refused_in_words(tmp_path):
    visit = Visit(tmp_path, settings={20: 1, 22: 1})

    def person():
        visit.ask("jog", x_mm=500.0)
        yield lambda: bool(visit.refused)
        visit.ask("jog", x_mm=-1.0)
        yield visit.at("jogging")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.refusals() == ["grbl-error-15"] and "outside the machine's travel" in str(visit.refused[0][1])
    assert visit.table.x_mm() == pytest.approx(-1, abs=0.013)


@pytest.mark.parametrize("way", [{}, {"x_mm": 1.0, "feed_mm_min": 0.0}, {"x_mm": float("inf")}, {"y_mm": 1e9}])
def test_jog_without_way_or_feed_is_refused(visit, way):
    def person():
        visit.ask("jog", **way)
        visit.ask("jog_on", press="p", **({"x_mm": 0.0, "y_mm": 0.0, "z_mm": 0.0, "feed_mm_min": 100.0} | way))
        yield lambda: len(visit.refused) == 2

    visit.receive(person)
    assert visit.refusals() == ["jog-way", "jog-way"] and visit.table.x_mm() == 0


def test_jog_in_alarm_is_refused_once_a_press(tmp_path):
    visit = Visit(tmp_path, homing=True)

    def person():
        visit.ask("jog", x_mm=1.0)
        yield from keep_pressed(visit, 0.5)

    visit.receive(person)
    assert visit.refusals() == ["jog-state", "jog-state"] and visit.table.x_mm() == 0


def test_held_jog_goes_on_evenly_and_brakes_at_once_when_let_go(visit):
    speeds, places = [], []

    def person():
        yield from keep_pressed(visit, 2.0)
        speeds.append(visit.table.board.axes.rate_mm_min)
        yield from keep_pressed(visit, 1.0)
        places.append((visit.table.clock(), visit.table.x_mm()))
        visit.ask("jog_cancel")
        yield visit.at("idle")
        places.append((visit.table.clock(), visit.table.x_mm()))
        yield 1.0
        places.append((visit.table.clock(), visit.table.x_mm()))

    visit.receive(person)
    (let_go_s, at_release), (_, at_rest), (_, later) = places
    braking_mm = 50.0**2 / (2 * 250)
    assert speeds[0] == pytest.approx(3000, rel=0.01)
    assert visit.table.sent(JOG_CANCEL)[0] - let_go_s < 0.003
    prepared_mm = 50 * 0.06  # grbl has steps for so long in hand
    assert at_release - at_rest < braking_mm + prepared_mm and later == at_rest
    assert visit.refused == [] and visit.service.status().machine_state == "Idle"


@pytest.mark.parametrize(("x", "feed_mm_min"), [(-1.0, 5000.0), (-1.0, 10.0), (-1.0, 99_999.0)])
def test_held_jog_that_nobody_renews_stops_by_itself(visit, x, feed_mm_min):
    places = []

    def person():
        yield from keep_pressed(visit, 1.0, x=x, feed_mm_min=feed_mm_min)
        begin_s = visit.table.clock()
        yield visit.at("idle")
        places.append((visit.table.clock() - begin_s, visit.table.x_mm()))
        yield 1.0
        places.append((0.0, visit.table.x_mm()))

    visit.receive(person)
    speed_mm_s = min(feed_mm_min, 5000.0) / 60
    assert places[0][0] < LAPSE_S + speed_mm_s / 250 + 0.2
    assert places[1][1] == places[0][1] < 0
    assert any("button was not heard of" in text for kind, text in visit.told if kind == "warning")


def test_button_that_was_silent_must_be_pressed_anew(visit):
    places = []

    def person():
        yield from keep_pressed(visit, 0.5, "one")
        yield 2.0
        places.append(visit.table.x_mm())
        yield from keep_pressed(visit, 0.5, "one")  # the window thaws, the timer goes on
        places.append(visit.table.x_mm())
        yield from keep_pressed(visit, 0.5, "two")
        places.append(visit.table.x_mm())
        visit.ask("jog_cancel")

    visit.receive(person)
    assert places[1] == places[0] > places[2]


def test_controller_left_alone_in_a_held_jog_stops_within_what_was_planned(visit):
    """The service itself dies: the lines that were sent must not lead far."""
    places = []

    def person():
        yield from keep_pressed(visit, 1.5, feed_mm_min=5000.0)
        places.append(visit.table.x_mm())
        visit.table.cut = True

    with pytest.raises(LinkError, match="cable"):
        visit.receive(person)
    for _ in range(300):
        visit.table.board.advance(0.01)
    speed_mm_s = 5000 / 60
    assert places[0] - visit.table.x_mm() < speed_mm_s * 0.5 + speed_mm_s**2 / 250


def test_press_in_another_direction_turns_round(visit):
    places = []

    def person():
        yield from keep_pressed(visit, 1.0, "one", x=-1.0)
        places.append(visit.table.x_mm())
        yield from keep_pressed(visit, 2.0, "two", x=1.0)
        places.append(visit.table.x_mm())
        visit.ask("jog_cancel")
        yield visit.at("idle")

    visit.receive(person)
    assert places[1] > places[0] + 20


def test_held_jog_against_the_end_of_travel_says_it_once_and_stays_inside(tmp_path):
    visit = Visit(tmp_path, settings={20: 1, 22: 1})

    def person():
        visit.ask("jog", x_mm=-5.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        yield from keep_pressed(visit, 2.0, x=1.0)
        visit.ask("jog_cancel")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.refusals() == ["grbl-error-15"] and -5 < visit.table.x_mm() <= 0


def test_cancel_with_steps_on_their_way_leaves_none_behind(visit):
    places = []

    def person():
        for _ in range(4):
            visit.ask("jog", x_mm=-20.0)
        yield visit.at("jogging")
        visit.ask("jog_cancel")
        yield visit.at("idle")
        yield 0.5
        places.append(visit.table.x_mm())
        yield 2.0
        places.append(visit.table.x_mm())

    visit.receive(person)
    assert places[0] == places[1] > -20


def test_hold_and_stop_end_a_jog_too(visit):
    def person():
        for command in ("hold", "stop"):
            visit.ask("jog", x_mm=-100.0)
            yield visit.at("jogging")
            visit.ask(command)
            yield visit.at("idle")

    visit.receive(person)
    assert visit.table.x_mm() > -20 and not visit.table.sent(RESET)


# --- zero, homing, locks ---------------------------------------------------------------------------


def test_zero_is_set_for_the_axes_asked_in_the_system_in_force(visit):
    seen = []

    def person():
        visit.job("G55", "G1X-10Y-20F2000")
        yield visit.ended()
        visit.ask("set_zero", axes="xz")
        yield lambda: ("message", "zero of XZ set in G55") in visit.told
        yield 0.3
        seen.append(visit.service.status())

    visit.receive(person)
    assert seen[0].wpos_mm == pytest.approx((0, -20, 0), abs=0.013)
    places = visit.table.board.memory.places
    assert places[55] == pytest.approx([-10, 0, 0], abs=0.013) and places[54] == [0, 0, 0]
    assert visit.refused == []


def test_zero_of_two_axes_leaves_the_position_unknown(visit):
    def person():
        visit.ask("set_zero", axes="xz")
        yield lambda: ("message", "zero of XZ set in G54") in visit.told

    visit.receive(person)
    assert visit.service.status().position_known is False


def test_zero_of_all_axes_makes_the_position_known_also_with_offsets_in_the_way(visit):
    def person():
        visit.job("G92X7", "G43.1Z3", "G1X-10F2000")
        yield visit.ended()
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().wpos_mm == (0, 0, 0) and visit.service.status().position_known

    visit.receive(person)
    assert visit.refused == []


def test_zero_is_set_where_reports_are_in_inches(tmp_path):
    visit = Visit(tmp_path, settings={13: 1})

    def person():
        visit.ask("jog", x_mm=-12.3)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().position_known is True

    visit.receive(person)
    assert visit.refused == [] and visit.table.board.memory.places[54][0] == pytest.approx(-12.3, abs=0.013)


def test_zero_that_was_not_taken_over_is_told(visit):
    write = visit.table.write
    visit.table.write = lambda data: write(data.replace(b"G10L20P1", b"G10L20P2"))

    def person():
        visit.ask("jog", x_mm=-5.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.ask("set_zero", axes="X")
        yield lambda: bool(visit.refused)

    visit.receive(person)
    assert visit.refusals() == ["zero-not-set"] and "-5.000 mm" in str(visit.refused[0][1])


@pytest.mark.parametrize(("axes", "code"), [("", "axes"), ("XX", "axes"), ("A", "axes"), ("X0Y", "axes")])
def test_zero_of_no_axis_is_refused(visit, axes, code):
    def person():
        visit.ask("set_zero", axes=axes)
        yield lambda: bool(visit.refused)

    visit.receive(person)
    assert visit.refusals() == [code] and b"G10" not in b"".join(data for _, data in visit.table.written)


def test_zero_while_jogging_is_refused(visit):
    def person():
        visit.ask("jog", x_mm=-50.0)
        yield visit.at("jogging")
        visit.ask("set_zero", axes="X")
        visit.ask("home")
        visit.ask("unlock")
        yield lambda: len(visit.refused) == 3

    visit.receive(person)
    assert visit.refusals() == ["machine-busy"] * 3


@pytest.mark.slow
def test_homing_takes_its_time_and_makes_the_position_known(tmp_path):
    visit = Visit(tmp_path, homing=True, timing=Timing(answer_s=2.0))
    seen = []

    def person():
        visit.ask("home")
        yield visit.at("homing")
        visit.ask("jog", x_mm=1.0)
        begin_s = visit.table.clock()
        yield visit.at("idle")
        seen.append(visit.table.clock() - begin_s)

    visit.receive(person)
    assert seen[0] > 2.0 and visit.refusals() == ["jog-state"]
    assert visit.service.status().position_known is True and ("message", "the machine is homed") in visit.told


def test_homing_can_be_stopped_and_costs_the_position(tmp_path):
    visit = Visit(tmp_path, homing=True)

    def person():
        visit.ask("home")
        yield visit.at("homing")
        yield 0.5
        visit.ask("stop")
        yield visit.at("alarm")
        yield lambda: "interrupted" in visit.service.status().message

    visit.receive(person)
    assert len(visit.table.sent(RESET)) == 1 and visit.service.status().position_known is False


def test_homing_that_finds_no_switch_is_none_though_it_is_answered_ok(tmp_path):
    visit = Visit(tmp_path, homing=True)

    def person():
        visit.ask("home")
        yield visit.at("homing")
        yield 0.5
        visit.table.board.fail(1)
        yield visit.at("alarm")
        yield 0.5

    visit.receive(person)
    status = visit.service.status()
    assert "found no limit switch" in status.message
    assert status.position_known is False and not status.homed
    assert ("message", "the machine is homed") not in visit.told


@pytest.mark.parametrize("other", [b"$X\n", b"$I\n", b"\n"])
def test_homing_that_reached_the_machine_as_another_line_is_not_believed(tmp_path, other):
    visit = Visit(tmp_path, homing=True)
    to_board = visit.table._wire.send
    visit.table._wire.send = lambda data: to_board(data.replace(b"$H\n", other))

    def person():
        visit.ask("home")
        yield lambda: bool(visit.refused)
        yield visit.at("alarm", "idle")

    visit.receive(person)
    assert visit.refusals() == ["homing-not-made"]
    status = visit.service.status()
    assert status.position_known is False and not status.homed
    assert ("message", "the machine is homed") not in visit.told


def test_homing_that_is_not_set_up_is_refused_in_words(visit):
    def person():
        visit.ask("home")
        yield lambda: bool(visit.refused)
        yield visit.at("idle")

    visit.receive(person)
    assert visit.refusals() == ["grbl-error-5"] and "$22=1" in str(visit.refused[0][1])


def test_after_a_soft_limit_in_a_job_the_machine_is_unlocked_and_jogs(tmp_path):
    visit = Visit(tmp_path, settings={20: 1, 22: 1})

    def person():
        visit.job("G21G90", "G1X-5F1000", "G1X500")
        yield visit.ended()
        visit.ask("unlock")
        yield visit.at("idle")
        visit.ask("jog", x_mm=-1.0)
        yield visit.at("jogging")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.outcomes[0].error.code == "grbl-alarm-2" and visit.refused == []


def test_jog_onto_a_switch_is_an_alarm_that_wants_a_reset_before_the_unlock(tmp_path):
    visit = Visit(tmp_path, settings={21: 1})
    seen = []

    def person():
        visit.ask("jog", x_mm=-300.0, feed_mm_min=5000.0)
        yield visit.at("alarm")
        yield 0.3
        seen.append(visit.service.status())
        visit.ask("unlock")
        yield visit.at("idle")

    visit.receive(person)
    assert "limit switch" in seen[0].message and seen[0].pins == "X" and seen[0].position_known is False
    assert len(visit.table.sent(RESET)) == 1 and visit.refused == [] and visit.service.status().message == ""


def test_sleeping_machine_is_woken_and_unlocked(visit):
    def person():
        suspend.sleep(visit.table.board)
        yield visit.at("alarm")
        assert "sleeps" in visit.service.status().message
        visit.ask("unlock")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.refused == []


@pytest.mark.parametrize("name", ["unlock", "hold", "resume", "stop"])
def test_what_makes_no_sense_at_rest_is_refused_in_words(visit, name):
    def person():
        visit.ask(name)
        yield lambda: bool(visit.refused)

    visit.receive(person)
    assert visit.refused[0][0] == name and visit.refused[0][1].advice and not visit.table.sent(HOLD)


# --- jobs ------------------------------------------------------------------------------------------


@pytest.mark.slow
def test_jobs_run_one_after_another_over_one_link(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        yield visit.ended(1)
        visit.job(*SQUARE, "G1X-7")
        yield visit.ended(2)

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [DONE, DONE]
    assert visit.outcomes[1].status.file == "part.nc" and visit.outcomes[1].status.total == 6
    assert visit.table.x_mm() == pytest.approx(-7, abs=0.013)
    phases = [text for kind, text in visit.told if kind == "phase"]
    assert phases == ["running", "finishing", "done", "idle"] * 2


def test_job_can_be_held_resumed_and_stopped_and_the_service_stays(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        yield 0.5
        visit.ask("hold")
        yield visit.at("held")
        visit.ask("resume")
        yield visit.at("running", "finishing")
        visit.ask("stop")
        yield visit.ended()
        visit.ask("jog", x_mm=-1.0)
        yield visit.at("jogging")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.outcomes[0].kind == STOPPED and visit.outcomes[0].position_known and visit.refused == []


def test_other_wishes_are_refused_while_a_job_runs_and_change_nothing(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        visit.ask("jog", x_mm=5.0)
        yield from keep_pressed(visit, 0.3)
        visit.ask("jog_cancel")
        for name in ("home", "unlock"):
            visit.ask(name)
        visit.ask("set_zero", axes="XYZ")
        visit.job("G1X-99")
        yield visit.ended()

    visit.receive(person)
    assert set(visit.refusals()) == {"job-runs"}
    assert {"jog", "jog_on", "home", "unlock", "set_zero", "run"} == {name for name, _ in visit.refused}
    assert visit.outcomes[0].done and not visit.table.sent(JOG_CANCEL)
    assert visit.table.board.axes.position_mm == pytest.approx((0, 0, 0), abs=0.013)


def duration_s(visit: Visit, *steps: str) -> float:
    """Return how long a job takes with these steps of feed override."""

    def person():
        for step in steps:
            visit.ask("override", kind="feed", step=step)
            yield 0.05
        visit.job("G21G90G94", "G1X-100F1500", "G1X0")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].done and visit.refused == []
    return visit.outcomes[0].status.elapsed_s


@pytest.mark.slow
def test_override_changes_the_measured_duration(tmp_path):
    plain_s = duration_s(Visit(tmp_path))
    slow, fast = Visit(tmp_path), Visit(tmp_path)
    assert duration_s(slow, *["-10"] * 5) == pytest.approx(2 * plain_s, rel=0.1)
    assert duration_s(fast, *["10"] * 5, "reset", *["10"] * 10) == pytest.approx(plain_s / 2, rel=0.2)
    assert slow.outcomes[0].status.overrides == (50, 100, 100)
    assert fast.outcomes[0].status.overrides == (200, 100, 100)


def test_overrides_are_set_while_a_job_runs_and_shown(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        for kind, step in (("feed", "1"), ("rapid", "25"), ("spindle", "-10"), ("spindle", "-1")):
            visit.ask("override", kind=kind, step=step)
            yield 0.05
        yield lambda: visit.service.status().overrides == (101, 25, 89)
        visit.ask("override", kind="feed", step="7")
        yield visit.ended()

    visit.receive(person)
    assert visit.refusals() == ["override"]


def test_job_is_refused_in_alarm_and_after_the_unlock_it_runs(tmp_path):
    visit = Visit(tmp_path, homing=True)

    def person():
        visit.job(*SQUARE)
        yield visit.ended(1)
        visit.ask("unlock")
        yield visit.at("idle")
        visit.job(*SQUARE)
        yield visit.ended(2)

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [REFUSED, DONE]
    assert visit.outcomes[0].error.code == "machine-alarm"


def test_job_is_compared_with_settings_read_anew(visit):
    def person():
        visit.job(*SQUARE, expected=expected_settings(load_machine("table-a")))
        yield visit.ended(1)
        visit.table.board.memory.settings.values[120] = 30.0
        visit.job(*SQUARE, expected=expected_settings(load_machine("table-a")))
        yield visit.ended(2)

    visit.receive(person)
    assert visit.outcomes[0].done and visit.outcomes[1].error.code == "settings-differ"
    assert visit.phase == "idle"


@pytest.mark.slow
@pytest.mark.parametrize("text", ["", "[1, 2]", '"x"', "{}", '{"lines": 5}', "\x00"])
def test_file_that_holds_no_job_is_refused(visit, tmp_path, text):
    file = tmp_path / "broken.json"
    file.write_text(text)

    def person():
        visit.ask("set_zero", axes="XYZ")
        visit.ask("run", file=str(file), zero_confirmed=True, allow_differences=False)
        yield visit.ended(1)
        visit.ask("run", file=str(tmp_path / "none.json"), zero_confirmed=True, allow_differences=False)
        yield visit.ended(2)

    visit.receive(person)
    assert {outcome.kind for outcome in visit.outcomes} == {REFUSED}
    assert visit.outcomes[1].error.code == "send-job"


def test_zero_must_be_confirmed_whatever_the_file_says(visit, tmp_path):
    def person():
        visit.job(*SQUARE, zero_confirmed=True)
        yield visit.ended(1)
        visit.ask("run", file=str(tmp_path / "a job ç.json"), zero_confirmed=False, allow_differences=False)
        yield visit.ended(2)

    visit.receive(person)
    assert visit.outcomes[1].error.code == "zero-not-confirmed"


def test_controller_reset_in_the_middle_costs_the_position_not_the_service(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        yield 0.5
        visit.table.board.receive(RESET)
        yield visit.ended()
        yield visit.at("alarm")
        visit.ask("unlock")
        yield visit.at("idle")

    visit.receive(person)
    outcome = visit.outcomes[0]
    assert outcome.kind == FAILED and not outcome.position_known and "unknown" in outcome.text
    assert visit.service.status().position_known is False


def test_reset_button_at_rest_is_told_by_its_consequence(visit):
    def person():
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().position_known is True
        visit.table.board.receive(RESET)
        yield lambda: visit.service.status().position_known is False

    visit.receive(person)


def test_lost_link_ends_job_and_service(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        yield 0.5
        visit.table.cut = True

    with pytest.raises(LinkError, match="cable"):
        visit.receive(person)
    assert visit.outcomes[0].kind == FAILED and not visit.outcomes[0].position_known and visit.table.closed


def test_controller_that_falls_silent_ends_the_service(tmp_path):
    visit = Visit(tmp_path, timing=Timing(answer_s=1.0))

    def person():
        visit.table.board.send = lambda line: None
        yield lambda: False

    with pytest.raises(LinkError, match="does not answer any more"):
        visit.receive(person)


# --- the end ---------------------------------------------------------------------------------------


def test_service_ends_alone_but_not_while_a_job_runs(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        visit.alone_s = 60.0
        yield lambda: False

    visit.receive(person)
    assert visit.outcomes[0].done


def test_service_ends_alone_also_at_a_machine_in_check_mode(visit):
    def person():
        visit.table.board.state = State.CHECK
        yield lambda: visit.service.status().machine_state == "Check"
        visit.alone_s = 60.0
        yield lambda: False

    visit.receive(person)
    assert visit.table.closed


def test_service_ends_alone_but_not_while_it_jogs(visit):
    def person():
        visit.ask("jog", x_mm=-30.0)
        yield visit.at("jogging")
        visit.alone_s = 60.0
        yield lambda: False

    visit.receive(person)
    assert visit.table.x_mm() == pytest.approx(-30, abs=0.013)


def test_end_asked_in_a_job_stops_it_safely(visit):
    def person():
        visit.job(*SQUARE)
        yield visit.at("running")
        yield 0.5

    visit.receive(person)
    assert visit.outcomes[0].kind == STOPPED and visit.outcomes[0].position_known
    assert visit.table.board.axes.idle


def test_end_asked_in_a_jog_brakes_first(visit):
    def person():
        visit.ask("jog", x_mm=-100.0)
        yield visit.at("jogging")

    visit.receive(person)
    assert len(visit.table.sent(JOG_CANCEL)) >= 1 and visit.table.board.axes.idle and visit.table.x_mm() > -20


def certificate(findings=(), lines=SQUARE, **send) -> Certificate:
    wire = {"sha256": digest_of_lines(SQUARE), "dialect": "grbl"}
    content = {"format": FORMAT, "version": VERSION, "wire": wire, "findings": list(findings)}
    return Certificate(content | {"send": {"file": "part.nc"} | send}, lines)


ERROR = {"severity": "error", "file": "part.nc", "line": 3, "column": 1, "text": "the spindle stands still"}
CERTIFICATES = {
    "done": certificate(),
    "start-differs": certificate(work_offsets_mm={"G54": [-1.0, 0.0, 0.0]}, work_system="G54"),
    "certificate-errors": certificate([ERROR]),
    "certificate-changed": certificate(),
    "certificate-wire": certificate(lines=[*SQUARE, "G0X1"]),
}


@pytest.mark.parametrize("code", CERTIFICATES)
def test_certificate_is_run_when_it_holds_and_refused_when_not(code, visit, tmp_path):
    file = tmp_path / "send.zip"
    CERTIFICATES[code].write(file)
    if code == "certificate-changed":
        file.write_bytes(file.read_bytes().replace(b"part.nc", b"tarp.nc"))

    def person():
        visit.ask("set_zero", axes="XYZ")
        visit.ask("run", file=str(file), zero_confirmed=True, allow_differences=False)
        yield visit.ended(1)

    visit.receive(person)
    (outcome,) = visit.outcomes
    assert (DONE if outcome.done else outcome.error.code) == code
    assert visit.phase == "idle"


# --- never blind ---------------------------------------------------------------------------------------------------


def reset_in_motion(visit):
    visit.job(*SQUARE)
    yield visit.at("running")
    yield 0.5
    visit.table.board.receive(RESET)
    yield visit.ended()


def hard_limit_in_motion(visit):
    visit.job(*SQUARE)
    yield visit.at("running")
    yield 0.5
    visit.table.board.fail(1)
    yield visit.ended()


def supply_lost_in_motion(visit):
    visit.job(*SQUARE)
    yield visit.at("running")
    yield 0.5
    visit.table.board.power_up()
    yield visit.ended()


def greeting_at_rest(visit):
    visit.ask("set_zero", axes="XYZ")
    yield lambda: visit.service.status().position_known is True
    yield 0.5
    visit.table.board.power_up()
    yield lambda: visit.service.status().position_known is False


@pytest.mark.slow
@pytest.mark.parametrize("loses", [reset_in_motion, hard_limit_in_motion, supply_lost_in_motion, greeting_at_rest])
def test_machine_whose_position_is_unknown_takes_no_program_until_its_zero_is_set(visit, loses):
    def person():
        yield from loses(visit)
        before = len(visit.outcomes)
        if visit.phase == "alarm":
            visit.ask("unlock")
            yield visit.at("idle")
        visit.job(*SQUARE, zeroed=False)
        yield visit.ended(before + 1)
        visit.ask("jog", x_mm=-1.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.job(*SQUARE)  # its zero is set first
        yield visit.ended(before + 2)

    visit.receive(person)
    blind, again = visit.outcomes[-2:]
    assert blind.kind == REFUSED and blind.error.code == "position-unknown" and not blind.position_known
    assert again.kind == DONE and visit.refusals() == []


@pytest.mark.slow
@pytest.mark.parametrize("old_mm", [0.0, -3.0])
def test_after_a_greeting_no_job_begins_before_the_zero_is_set_and_a_stop_does_not_cost_it(visit, old_mm):
    visit.table.board.memory.places[54][0] = old_mm

    def person():
        visit.job(*SQUARE, zeroed=False)
        yield visit.ended(1)
        visit.job(*SQUARE)  # the zero is set first
        yield visit.at("running")
        visit.ask("stop")  # its own reset at rest costs nothing
        yield visit.ended(2)
        visit.job(*SQUARE, zeroed=False)
        yield visit.ended(3)

    visit.receive(person)
    blind, stopped, done = visit.outcomes
    assert blind.kind == REFUSED and blind.error.code == "position-unknown" and not blind.position_known
    assert [stopped.kind, done.kind] == [STOPPED, DONE] and done.position_known


def test_controller_that_restarts_while_a_job_asks_it_takes_no_job_before_its_zero_is_set(visit):
    def person():
        visit.ask("set_zero", axes="XYZ")
        visit.ask("jog", x_mm=5.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.table.on_write = lambda data: b"$#" in data and visit.table.board.power_up()
        visit.job("G21G90", "G1X1F1000")
        yield visit.ended()
        visit.table.on_write = lambda data: None
        visit.job("G21G90", "G1X1F1000", zeroed=False)
        yield visit.ended(2)

    visit.receive(person)
    restarted, after = visit.outcomes
    assert restarted.kind == after.kind == REFUSED
    assert restarted.error.code == "controller-restarted" and not restarted.position_known
    assert after.error.code == "position-unknown" and visit.service.status().position_known is False
