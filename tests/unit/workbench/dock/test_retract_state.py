# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the dock knows of the way back along the cut, and when it can be asked for."""

from __future__ import annotations

import pytest

from CNCStepper.control.session.status import SenderStatus
from CNCStepper.workbench.dock.model import retract_state as dock_back
from CNCStepper.workbench.dock.model.button_states import NOT_CONNECTED, RULES, ControllerSnapshot
from CNCStepper.workbench.dock.model.retract_state import (
    ASIDE,
    BACK,
    ENTRY,
    FIND,
    FORWARD,
    LINE,
    RESUME,
    RetractFlow,
    request_of,
    state_text,
    why_not_back,
)

KINDS = (BACK, LINE, ENTRY, FORWARD, ASIDE)
HELD, RUNNING, RETREATED = (ControllerSnapshot(phase, job=True) for phase in ("held", "running", "retreated"))


def stood(behind_mm: float) -> RetractFlow:
    flow = RetractFlow()
    flow.ask(BACK)
    flow.answer({"line": 12, "behind_mm": behind_mm, "doubt": ""})
    return flow


@pytest.mark.parametrize(
    ("phase", "expected"),
    [
        ("running", {BACK, LINE, ENTRY}),
        ("paused", {BACK, LINE, ENTRY}),
        ("held", set(KINDS)),
        ("retreated", set(KINDS) - {ASIDE}),
        ("door", set()),
        ("stopping", set()),
    ],
)
def test_a_way_is_offered_exactly_where_the_machine_can_go_it(phase: str, expected: set[str]) -> None:
    moment = ControllerSnapshot(phase, job=True)
    assert {kind for kind in KINDS if not why_not_back(kind, RetractFlow(), moment)} == expected


def test_every_reason_is_a_sentence() -> None:
    assert why_not_back(BACK, RetractFlow(), ControllerSnapshot()) == NOT_CONNECTED
    assert "no cut" in why_not_back(BACK, RetractFlow(), ControllerSnapshot("idle"))
    assert "no cut" in why_not_back(BACK, RetractFlow(), ControllerSnapshot("held"))  # held without a job
    assert why_not_back(FORWARD, RetractFlow(), RUNNING) == RULES["forward"].why_not


def test_one_way_after_another_but_a_search_does_not_lock() -> None:
    flow = RetractFlow()
    flow.ask(FIND)
    assert not why_not_back(BACK, flow, HELD) and state_text(flow, HELD) == dock_back.FINDING
    flow.ask(BACK)
    assert {why_not_back(kind, flow, HELD) for kind in KINDS} == {dock_back.UNDER_WAY}
    assert state_text(flow, HELD) == dock_back.PROVING and state_text(flow, RUNNING) == dock_back.GOING


def test_a_way_that_is_asked_for_during_the_search_is_under_way_until_its_own_answer() -> None:
    flow = RetractFlow()
    flow.ask(FIND)
    flow.ask(BACK)
    flow.answer({"line": 7, "behind_mm": 0.0, "doubt": ""})
    assert (flow.asked, flow.line) == (BACK, 7)
    flow.answer({"line": 6, "behind_mm": 5.0, "doubt": ""})
    assert (flow.asked, flow.line) == ("", 6)
    flow.ask(FIND)
    flow.ask(BACK)
    assert (flow.refuse("The machine does not stand."), flow.asked) == (FIND, BACK)


def test_nothing_lies_ahead_of_where_the_cut_has_come_to() -> None:
    assert why_not_back(FORWARD, stood(0.0), RETREATED) == dock_back.NOTHING_AHEAD
    assert not why_not_back(FORWARD, stood(3.0), RETREATED) and not why_not_back(FORWARD, RetractFlow(), HELD)
    assert "{1}" in state_text(stood(3.0), RETREATED) and "{1}" not in state_text(stood(0.0), RETREATED)


def test_the_place_is_looked_for_once_when_the_machine_is_held_and_forgotten_when_it_goes_on() -> None:
    flow = RetractFlow()
    assert [flow.follow(moment) for moment in (RUNNING, HELD, HELD)] == [False, True, False]
    flow.ask(FIND)
    flow.answer({"line": 7, "behind_mm": 0.0, "doubt": ""})
    flow.follow(HELD)
    assert flow.line == 7
    flow.follow(RUNNING)
    assert flow.line == 0 and state_text(flow, RUNNING) == dock_back.UNKNOWN


def test_a_machine_held_without_a_job_or_on_a_way_under_way_is_not_searched() -> None:
    assert not RetractFlow().follow(ControllerSnapshot("held"))
    flow = RetractFlow()
    flow.ask(BACK)
    assert not flow.follow(HELD)


def test_a_refusal_is_said_until_the_next_wish_and_keeps_the_place() -> None:
    flow = stood(3.0)
    flow.ask(LINE)
    assert flow.refuse("No move of line 9 lies on the way back.") == LINE
    assert (flow.line, flow.behind_mm) == (12, 3.0) and flow.trouble.startswith("No move") and not flow.asked
    flow.ask(BACK)
    assert not flow.trouble


def test_a_button_of_the_machine_is_heard_once_for_each_press() -> None:
    flow, back = RetractFlow(), request_of(SenderStatus(wanted_back_mm=5.0))
    assert back == (BACK, 5.0) and request_of(SenderStatus()) is None and request_of(None) is None
    assert flow.request_of_machine(None, RUNNING) is None
    assert [flow.request_of_machine(back, RUNNING) for _ in range(2)] == [back, None]
    assert flow.request_of_machine(None, HELD) is None
    assert flow.request_of_machine(back, HELD) == back


def test_the_start_button_cuts_on_from_where_the_tool_was_led() -> None:
    flow, rest = RetractFlow(), request_of(SenderStatus(wanted_rest=True))
    assert rest == (RESUME, True) and flow.request_of_machine(rest, RETREATED) == rest


def test_a_button_of_the_machine_waits_for_the_way_under_way() -> None:
    flow, back = RetractFlow(), (BACK, 5.0)
    flow.ask(BACK)
    assert flow.request_of_machine(back, HELD) is None
    assert flow.request_of_machine(None, HELD) is None  # somebody has asked for the place
    flow.answer({"line": 7, "behind_mm": 5.0, "doubt": ""})
    assert [flow.request_of_machine(None, HELD) for _ in range(2)] == [back, None]


def test_presses_before_the_way_has_begun_add_up() -> None:
    flow = RetractFlow()
    assert flow.request_of_machine((BACK, 2.0), RUNNING) == (BACK, 2.0)
    flow.ask(BACK)
    assert [flow.request_of_machine(wish, HELD) for wish in ((BACK, 4.0), None, (BACK, 2.0), None)] == [None] * 4
    flow.answer({"line": 7, "behind_mm": 2.0, "doubt": ""})
    assert flow.request_of_machine(None, RETREATED) == (BACK, 4.0)


def test_a_button_pressed_in_a_job_that_is_over_moves_nothing() -> None:
    flow = RetractFlow()
    flow.ask(BACK)
    flow.request_of_machine((BACK, 5.0), HELD)
    flow.forget()
    assert flow.request_of_machine((BACK, 5.0), HELD) is None
