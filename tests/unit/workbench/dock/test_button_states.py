# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dock says of a moment, and which controls can work then."""

from __future__ import annotations

import pytest

from CNCStepper.workbench.dock.model.button_states import (
    CONNECTED,
    DANGER,
    FACES,
    JOB_RUNS,
    LOST,
    NO_HOMING,
    NOT_CONNECTED,
    RULES,
    STANDING,
    ControllerSnapshot,
    face,
    why_not,
    why_not_connect,
    why_not_disconnect,
    why_not_outline,
)

PHASES = ("off", "starting", "connecting", "unreached", "gone", *sorted(CONNECTED))


def works(phase: str) -> set[str]:
    return {control for control in RULES if not why_not(control, ControllerSnapshot(phase))}


@pytest.mark.parametrize("phase", PHASES)
def test_every_phase_has_a_face_and_a_reason_for_what_is_locked(phase: str) -> None:
    assert phase in FACES and face(ControllerSnapshot(phase)).headline
    for control in RULES:
        reason = why_not(control, ControllerSnapshot(phase))
        assert reason == "" or reason.endswith(".")


@pytest.mark.parametrize(
    ("phase", "expected"),
    [
        ("off", set()),
        ("connecting", set()),
        ("gone", set()),
        ("idle", {"jog", "zero", "home", "override", "console", "relay", "outline"}),
        ("jogging", {"hold", "stop", "jog", "override"}),
        ("homing", {"stop"}),
        ("busy", {"hold", "stop"}),
        ("alarm", {"home", "unlock", "console"}),
        ("running", {"hold", "stop", "override", "back"}),
        ("finishing", {"hold", "stop", "override", "back"}),
        ("holding", {"stop", "override", "back"}),
        ("held", {"resume", "stop", "override", "back", "forward", "aside"}),
        ("retreated", {"resume", "stop", "override", "back", "forward"}),
        ("paused", {"resume", "stop", "override", "back"}),
        ("door", {"resume", "stop", "override"}),
        ("stopping", set()),
    ],
)
def test_a_control_works_exactly_in_its_phases(phase: str, expected: set[str]) -> None:
    assert works(phase) == expected


@pytest.mark.parametrize(
    ("machine_state", "expected"), [("Idle", {"jog", "zero"}), ("Jog", {"jog", "hold"}), ("Hold:0", set())]
)
def test_at_a_pause_an_idle_machine_is_jogged_and_zeroed(machine_state: str, expected: set[str]) -> None:
    can = {
        control
        for control in ("jog", "zero", "hold")
        if not why_not(control, ControllerSnapshot("paused", machine_state))
    }
    assert can == expected


@pytest.mark.parametrize(("machine_state", "expected"), [("Idle", {"jog"}), ("Jog", {"jog", "hold"})])
def test_on_its_cut_a_machine_is_jogged_but_keeps_its_zero(machine_state: str, expected: set[str]) -> None:
    can = {
        control
        for control in ("jog", "zero", "hold")
        if not why_not(control, ControllerSnapshot("retreated", machine_state))
    }
    assert can == expected


def test_without_a_controller_the_reason_is_the_connection() -> None:
    assert why_not("hold", ControllerSnapshot()) == NOT_CONNECTED


def test_a_machine_without_switches_cannot_home_and_says_so() -> None:
    assert why_not("home", ControllerSnapshot("idle", homing=False)) == NO_HOMING
    assert why_not("home", ControllerSnapshot("idle", homing=None)) == ""
    assert why_not("home", ControllerSnapshot("running", homing=True)) == RULES["home"].why_not


def test_the_outline_is_run_wherever_a_job_can_be_sent() -> None:
    assert why_not_outline(ControllerSnapshot("idle", position_known=True)) == ""
    not_homed = ControllerSnapshot("idle", position_known=None)  # by nobody, so nothing is lost either
    assert why_not_outline(not_homed) == ""
    assert why_not_outline(ControllerSnapshot("idle", position_known=False)) == LOST
    assert why_not_outline(ControllerSnapshot("running")) == RULES["outline"].why_not
    assert why_not_outline(ControllerSnapshot()) == NOT_CONNECTED


def test_stop_is_never_called_emergency_stop() -> None:
    assert "not an emergency stop" in RULES["stop"].does
    assert "emergency stop is on the machine" in RULES["stop"].does


@pytest.mark.parametrize("phase", sorted(JOB_RUNS))
def test_a_running_job_is_not_disconnected(phase: str) -> None:
    assert why_not_disconnect(ControllerSnapshot(phase, job=True))


def test_a_machine_may_be_held_without_a_job() -> None:
    assert not ControllerSnapshot("held").job_runs and why_not(
        "resume", ControllerSnapshot("held")
    ) == "" == why_not_disconnect(ControllerSnapshot("held"))


def test_a_lost_position_is_said_while_the_machine_is_idle() -> None:
    assert "home" in face(ControllerSnapshot("idle", position_known=False)).sentence
    assert (
        face(ControllerSnapshot("idle", position_known=None))
        == face(ControllerSnapshot("idle", position_known=True))
        == FACES["idle"]
    )


def test_connecting_is_offered_once() -> None:
    assert (
        why_not_connect(ControllerSnapshot(), "COM3") == ""
        and why_not_connect(ControllerSnapshot("gone"), "COM3") == ""
    )
    assert why_not_connect(ControllerSnapshot("starting"), "COM3") and why_not_connect(
        ControllerSnapshot("idle"), "COM3"
    )
    assert "port" in why_not_connect(ControllerSnapshot(), "")
    assert why_not_disconnect(ControllerSnapshot("starting")) == "" and why_not_disconnect(ControllerSnapshot())


def test_why_no_connection_came_about_stands_in_the_sentence() -> None:
    moment = ControllerSnapshot("unreached", message="no Python has pyserial; install it")
    assert face(moment).sentence == "No Python has pyserial; install it." and why_not_connect(moment, "COM3") == ""


def test_the_words_of_program_and_alarm_are_shown() -> None:
    assert face(ControllerSnapshot("paused", message="change the tool")).sentence == "Change the tool."
    alarm = face(ControllerSnapshot("alarm", message="a limit switch was hit; home it"))
    assert (alarm.tone, alarm.sentence) == (DANGER, "A limit switch was hit; home it.")
    assert face(ControllerSnapshot("running", message="old words")).sentence == FACES["running"].sentence


def test_standing_still_is_part_of_a_job() -> None:
    assert STANDING < JOB_RUNS < CONNECTED
