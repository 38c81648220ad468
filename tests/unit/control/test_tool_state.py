# SPDX-License-Identifier: LGPL-2.1-or-later
"""M6 on grblHAL: the machine waits in the state Tool until a person has changed the tool and resumes."""

from __future__ import annotations

import pytest
from desk_table import Visit

from CNCStepper.control.lines import pauses
from CNCStepper.virtual.grbl.firmware import GRBLHAL

LINES = ("G21G90G94", "G1X-2F1500", "T2M6", "G1X-4")


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path, firmware=GRBLHAL)


def test_job_pauses_says_what_is_wanted_and_acknowledges_only_when_resumed(visit):
    seen = []

    def person():
        visit.job(*LINES, messages={2: "tool 2: drill of 3 mm"})
        yield visit.at("paused")
        yield 2.0
        seen.append((visit.desk.status().message, visit.table.x_mm(), visit.table.sent(b"\xa3")))
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    message, x_mm, acknowledged = seen[0]
    assert message == "tool 2: drill of 3 mm" and x_mm == pytest.approx(-2.0, abs=0.02) and acknowledged == []
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
            yield lambda count=count: visit.phase == "paused" and len(visit.table.sent(b"\xa3")) == count
            visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    lines = b"".join(data for _, data in visit.table.written)
    assert visit.outcomes[0].done and b"M6\n" in lines and b"M0\n" not in lines


def test_typed_tool_change_is_resumed_too(visit):
    def person():
        visit.ask("set_zero", axes="XYZ")
        yield lambda: visit.desk.status().position_known is True
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
