# SPDX-License-Identifier: LGPL-2.1-or-later
"""The steps of sending a job."""

from __future__ import annotations

import pytest

from CNCStepper.workbench.dock.model.button_states import ControllerSnapshot, why_not
from CNCStepper.workbench.dock.model.send_steps import (
    AWAITED,
    ENDS,
    LAST_NUMBER,
    OUTCOMES,
    STEPS,
    Flow,
    why_not_confirm,
)


def flow_at(*happenings: str) -> Flow:
    flow = Flow()
    flow.begin("Plate")
    for what in happenings:
        assert flow.happen(what), f"{flow.step} does not wait for {what}"
    return flow


def test_the_straight_road() -> None:
    flow = flow_at("clean", "idle", "onward", "cutting")
    assert flow.step == "cutting" and flow.active and not flow.anyway
    flow.end("done", "all 9 lines are cut")
    assert (flow.step, flow.shown.title, flow.detail) == ("ended", OUTCOMES["done"][0], "all 9 lines are cut")
    assert not flow.active


def test_errors_stop_before_any_controller_is_asked_for() -> None:
    flow = flow_at("errors")
    assert flow.step == "refused" and not flow.active and not flow.shown.confirm_step
    assert not any(flow.happen(what) for what in ("idle", "onward", "cutting", "clean"))


def test_warnings_wait_for_a_person() -> None:
    flow = flow_at("warnings")
    assert flow.awaits_answer and not flow.happen("idle")
    assert flow.happen("onward") and flow.step == "connect"


def test_a_controller_set_up_differently_is_sent_to_only_when_somebody_decides() -> None:
    flow = flow_at("clean", "idle", "onward", "differences")
    assert flow.step == "differs" and flow.awaits_answer and not flow.anyway
    assert not flow.happen("cutting")
    flow.happen("onward")
    assert flow.step == "starting" and flow.anyway
    flow.begin("Plate")
    assert not flow.anyway


def test_nothing_starts_without_the_question_for_the_zero() -> None:
    before = {step for (step, what), after in AWAITED.items() if after == "starting"}
    assert before == {"zero", "differs"}
    assert {step for (step, what), after in AWAITED.items() if after == "differs"} == {"starting"}


def test_a_lost_connection_goes_back_or_ends_but_never_goes_on() -> None:
    assert flow_at("clean", "idle", "lost").step == "connect"
    assert flow_at("clean", "idle", "onward", "cutting", "lost").step == "failed"


@pytest.mark.parametrize("outcome", ["done", "stopped", "refused", "failed"])
def test_every_outcome_has_words(outcome: str) -> None:
    flow = flow_at("clean", "idle", "onward")
    flow.end(outcome, "why")
    assert flow.step == "ended" and flow.shown.title == OUTCOMES[outcome][0] and flow.shown.away


def test_an_outcome_of_another_job_changes_nothing() -> None:
    flow = flow_at("clean")
    flow.end("done", "an old one")
    assert flow.step == "connect" and not flow.outcome


def test_the_question_waits_for_an_idle_machine() -> None:
    flow = flow_at("clean", "idle")
    assert why_not_confirm(flow, ControllerSnapshot("idle")) == ""
    assert why_not_confirm(flow, ControllerSnapshot("alarm")) and why_not_confirm(flow, ControllerSnapshot("jogging"))
    connect = flow_at("clean")
    assert why_not_confirm(connect, ControllerSnapshot("off")) == "" and why_not_confirm(
        connect, ControllerSnapshot("connecting")
    )


def test_every_step_can_be_reached_and_left() -> None:
    assert {*AWAITED.values(), "checking"} == set(STEPS)
    assert {step for step, _ in AWAITED} | ENDS == set(STEPS)
    assert all(0 <= step.number <= LAST_NUMBER for step in STEPS.values())


def test_at_the_zero_the_program_may_be_checked_again() -> None:
    flow = flow_at("clean", "idle")
    flow.again = True
    assert "checked with this work zero" in why_not_confirm(flow, ControllerSnapshot("idle"))
    assert not flow.happen("clean")  # the question stands
    assert flow.happen("errors") and flow.step == "refused" and not flow.again
    assert flow_at("clean", "idle", "warnings").step == "warned"
    assert flow_at("clean", "idle", "failure").step == "failed"


def test_a_zero_that_moves_is_asked_for_again_whatever_was_decided_before() -> None:
    flow = flow_at("clean", "idle", "onward", "differences")
    assert flow.happen("moved") and flow.step == "zero" and not flow.anyway


def test_who_gives_up_or_loses_the_machine_waits_for_no_check() -> None:
    for end in (lambda flow: flow.leave(), lambda flow: flow.happen("lost"), lambda flow: flow.begin("Other")):
        flow = flow_at("clean", "idle")
        flow.again = True
        end(flow)
        assert not flow.again


@pytest.mark.parametrize("happenings", [("clean", "idle"), ("clean", "idle", "onward", "differences")])
def test_nothing_starts_while_the_position_is_unknown(happenings) -> None:
    flow = flow_at(*happenings)
    assert "position is unknown" in why_not_confirm(flow, ControllerSnapshot("idle", position_known=False))
    assert not why_not_confirm(flow, ControllerSnapshot("idle", position_known=True))
    assert not why_not_confirm(flow, ControllerSnapshot("idle"))  # nothing speaks against it


def test_what_an_earlier_job_left_held_is_not_resumed_while_the_position_is_unknown() -> None:
    assert "stop the job" in why_not("resume", ControllerSnapshot("held", position_known=False))
    assert not why_not("resume", ControllerSnapshot("held", job=True, position_known=False))
    assert not why_not("resume", ControllerSnapshot("held"))
