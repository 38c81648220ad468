# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who answers to a stand that is over lets nothing go on, at a service with a virtual table in simulated time."""

from __future__ import annotations

import pytest

from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import DONE
from CNCStepper.control.stream.pause_id import PauseCounter
from CNCStepper.errors import MachineRefusal
from CNCStepper.virtual.grbl.input_pins import DOOR
from helpers.control.service_bench import Visit

TWO_PAUSES = ("G21G90G94", "G1X-4F1500", "M0", "G1X-8", "M0", "G1X-12")
WORDS = {2: "change to tool 1", 4: "change to tool 2"}


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path)


def stand(visit: Visit) -> int:
    return visit.service.status().stand


def test_each_stand_has_its_number_and_only_the_present_one_can_be_answered():
    stands = PauseCounter()
    for phase in ("running", "holding", "held", "held", "running", "paused", "retreated"):
        stands.enter(phase)
    assert stands.number == 3
    for number in (None, 3):
        stands.check(Command("resume", {"stand": number}))
    stands.check(Command("resume"))  # a button of the machine
    for number in (2, 4, 0):
        with pytest.raises(MachineRefusal, match="stand-over"):
            stands.check(Command("resume", {"stand": number}))
    stands.enter("running")
    with pytest.raises(MachineRefusal, match="stand-over"):
        stands.check(Command("resume", {"stand": 3}))


def test_answer_to_a_hold_does_not_end_the_pause_that_came_after_it(visit):
    seen = []

    def person():
        visit.job(*TWO_PAUSES, messages=WORDS)
        yield visit.at("running")
        yield 0.05
        visit.ask("hold")
        yield visit.at("held")
        seen.append(stand(visit))
        visit.ask("resume")  # as by the machine's own button
        yield visit.at("paused")
        visit.ask("resume", stand=seen[0])
        yield lambda: bool(visit.refused)
        seen.append((visit.phase, visit.service.status().message))
        visit.ask("resume", stand=stand(visit))
        yield lambda: visit.service.status().message == "change to tool 2"
        visit.ask("resume", stand=stand(visit) - 1)
        yield lambda: len(visit.refused) == 2
        visit.ask("resume", stand=stand(visit))
        yield visit.ended()

    visit.receive(person)
    assert seen[1] == ("paused", "change to tool 1")
    assert [(name, error.code) for name, error in visit.refused] == [("resume", "stand-over")] * 2
    assert visit.outcomes[0].kind == DONE


@pytest.mark.slow
def test_answer_to_one_job_does_not_let_the_next_one_go_on(visit):
    def person():
        for job in (1, 2):
            visit.job("G21G90G94", "M0", f"G1X-{job}F1500")
            yield visit.at("paused")
            if job == 1:
                first = stand(visit)
            else:
                visit.ask("resume", stand=first)
                yield lambda: bool(visit.refused)
                assert visit.phase == "paused"
            visit.ask("resume", stand=stand(visit))
            yield visit.ended(job)

    visit.receive(person)
    assert [error.code for _, error in visit.refused] == ["stand-over"]
    assert [outcome.kind for outcome in visit.outcomes] == [DONE, DONE]


def test_outputs_that_return_after_a_door_are_no_new_stand(visit):
    restoring = []

    def person():
        visit.job("G21G90G94", "M3S9000", "G4P0.5", "G1X-40F1500")
        yield lambda: visit.table.x_mm() < -2.0
        visit.table.board.press(DOOR)
        yield lambda: visit.service.status().machine_state == "Door:1"
        number = stand(visit)
        visit.table.board.release(DOOR)
        yield lambda: visit.service.status().machine_state == "Door:0"
        visit.ask("resume", stand=number)
        yield lambda: visit.service.status().machine_state == "Door:3"
        yield 0.3
        restoring.append((visit.phase, stand(visit) - number))
        yield visit.ended()

    visit.receive(person)
    assert restoring == [("finishing", 0)] and visit.outcomes[0].kind == DONE
