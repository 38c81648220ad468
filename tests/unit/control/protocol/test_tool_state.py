# SPDX-License-Identifier: LGPL-2.1-or-later
"""M6 on grblHAL: the machine waits in the state Tool until a person has changed the tool and resumes."""

from __future__ import annotations

import pytest

from CNCStepper.control.program.wire_line import pauses
from CNCStepper.virtual.grbl.firmware import GRBLHAL
from CNCStepper.virtual.grbl.states import State
from helpers.control.service_bench import Visit

LINES = ("G21G90G94", "G1X-2F1500", "T2M6", "G1X-4")


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path, firmware=GRBLHAL)


def test_job_pauses_and_says_what_is_wanted_until_it_is_resumed(visit):
    seen = []

    def person():
        visit.job(*LINES, messages={2: "tool 2: drill of 3 mm"})
        yield visit.at("paused")
        yield 2.0
        seen.append((visit.service.status().message, visit.table.x_mm(), visit.table.sent(b"~")))
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    message, x_mm, started = seen[0]
    assert message == "tool 2: drill of 3 mm" and x_mm == pytest.approx(-2.0, abs=0.02) and started == []
    assert len(visit.table.sent(b"\xa3")) == 1
    assert visit.outcomes[0].done and visit.table.x_mm() == pytest.approx(-4.0, abs=0.02)


def test_job_stopped_at_a_tool_change_keeps_its_position(visit):
    def person():
        visit.job(*LINES)
        yield visit.at("paused")
        visit.ask("stop")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == "stopped" and visit.outcomes[0].position_known


def test_tool_change_is_sent_and_a_bare_pause_is_not(visit):
    def person():
        visit.job("G21G90G94", "M6", "M0", "G1X-4F1500")
        for count in (0, 1):
            yield lambda count=count: visit.phase == "paused" and len(visit.table.sent(b"~")) == count
            visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    lines = b"".join(data for _, data in visit.table.written)
    assert visit.outcomes[0].done and b"M6\n" in lines and b"M0\n" not in lines


def test_typed_tool_change_is_resumed_too(visit):
    def person():
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.service.status().position_known is True
        visit.ask("line", text="M6")
        yield visit.at("held")
        visit.ask("resume")
        yield lambda: ("answer", "ok") in visit.told

    visit.receive(person)
    assert not visit.refused


@pytest.mark.parametrize(
    ("text", "waits"), [("M6", True), ("T1M06", True), ("M60", False), ("M0", True), ("M62P1", False)]
)
def test_lines_that_wait_for_a_person_are_known(text, waits):
    assert pauses(text) == waits


# --- jogged, zeroed and taken back while the tool is changed -----------------------------------------


def at_tool(visit):
    """Wait until the job stands at its M6 and the controller can be jogged."""
    yield lambda: visit.phase == "paused" and len(visit.table.sent(b"\xa3")) > 0
    yield lambda: visit.service.status().machine_state == "Tool"


def jogged(visit, **way):
    visit.ask("jog", **way)
    yield lambda: visit.table.board.state is State.JOG
    yield lambda: visit.service.status().machine_state == "Tool" and visit.table.board.state is State.TOOL


def test_who_jogs_while_the_tool_is_changed_is_taken_back_before_the_change_ends(visit):
    seen = []

    def person():
        visit.job(*LINES)
        yield from at_tool(visit)
        yield from jogged(visit, x_mm=6.0, z_mm=2.0)
        seen.append(visit.table.board.axes.position_mm)
        visit.table.on_write = lambda data: data == b"~" and seen.append(visit.table.board.axes.position_mm)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    away, started = seen
    assert away == pytest.approx((4, 0, 2), abs=0.02) and started == pytest.approx((-2, 0, 0), abs=0.02)
    assert visit.refused == [] and visit.outcomes[0].done
    assert visit.table.board.axes.position_mm == pytest.approx((-4, 0, 0), abs=0.02)


def test_zero_of_the_new_tool_moves_what_follows(visit):
    def person():
        visit.job(*LINES, "G1Z-1")
        yield from at_tool(visit)
        yield from jogged(visit, z_mm=-3.0)
        visit.ask("set_zero", axes="Z")
        yield lambda: ("message", "zero of Z set in G54") in visit.told
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.refused == [] and visit.outcomes[0].done
    assert visit.table.board.axes.position_mm == pytest.approx((-4, 0, -4), abs=0.02)


def test_cycle_start_at_the_machine_resumes_with_the_way_back(visit):
    def person():
        visit.job(*LINES)
        yield from at_tool(visit)
        yield from jogged(visit, x_mm=6.0)
        visit.table.board.receive(b"~")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].done and visit.table.sent(b"~") == []
    assert visit.table.x_mm() == pytest.approx(-4.0, abs=0.02)


def test_nothing_follows_a_tool_change_before_its_end(visit):
    def person():
        visit.job(*LINES, *(f"G1X-{number}" for number in range(5, 20)))
        yield from at_tool(visit)
        assert visit.service.status().sent == visit.service.status().acknowledged == 3
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].done and visit.table.x_mm() == pytest.approx(-19.0, abs=0.02)


def test_way_back_is_refused_while_the_tool_is_changed_and_the_job_goes_on(visit):
    def person():
        visit.job(*LINES)
        yield from at_tool(visit)
        visit.ask("tell_place", file="nowhere.json")
        yield lambda: bool(visit.refused)
        assert visit.table.board.state is State.TOOL
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.refusals() == ["tool-change"] and visit.outcomes[0].done


def test_controller_that_wants_more_than_a_cycle_start_is_told_of(visit):
    visit.table.board.end_tool_change = lambda: None  # as with $341=1, before $TPW

    def person():
        visit.job(*LINES)
        yield from at_tool(visit)
        visit.ask("resume")
        yield lambda: bool(visit.refused)
        assert visit.phase == "paused" and len(visit.table.sent(b"~")) == 1
        del visit.table.board.end_tool_change
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.refusals() == ["tool-change"] and visit.outcomes[0].done
