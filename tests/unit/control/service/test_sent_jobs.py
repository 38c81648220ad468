# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs that a command line lets the connection service run: homed first, counted from a restart; and its end."""

from __future__ import annotations

import pytest

from CNCStepper.control.journal.store import replays
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.status import DONE, REFUSED
from CNCStepper.control.stream.position_trust import LOST, NOTHING_AGAINST
from CNCStepper.virtual.grbl.gcode.block import FIRST_SYSTEM
from helpers.control.service_bench import Visit

MOVES = ("G21G90G94", "G1X-2F3000", "G1X0Y-1")
LONG = ("G21G90G94", *(f"G1X{-(number % 2) * 20}F1500" for number in range(10)))


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path, journals=tmp_path)


def send(visit: Visit, tmp_path, lines=MOVES, name: str = "send", **job) -> None:
    file = tmp_path / "sent.zip"
    write_job(file, SendJob("elsewhere", lines, file="part.nc", **job))
    visit.ask(name, file=str(file), zero_confirmed=True, allow_differences=False)


def test_restarted_machine_is_sent_to_from_its_confirmed_place_and_is_known_then(visit, tmp_path):
    def person():
        assert visit.service.status().position_known is False
        send(visit, tmp_path)
        yield visit.ended(1)
        assert visit.service.status().position_known is True
        send(visit, tmp_path)  # it stands at Y-1 now
        yield visit.ended(2)

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [DONE, DONE]
    assert sorted(story.header["greeted"] for story in replays(tmp_path)) == [False, True]


def test_what_a_window_lets_run_does_not_count_from_a_restart(visit, tmp_path):
    def person():
        send(visit, tmp_path, name="run")
        yield visit.ended(1)

    visit.receive(person)
    assert (visit.outcomes[0].kind, visit.outcomes[0].error.code) == (REFUSED, "position-unknown")


def test_restarted_machine_that_was_moved_since_is_refused(visit, tmp_path):
    def person():
        visit.ask("jog", x_mm=-3.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        send(visit, tmp_path)
        yield visit.ended(1)

    visit.receive(person)
    outcome = visit.outcomes[0]
    assert (outcome.kind, outcome.error.code) == (REFUSED, "position-unknown") and "is not 0" in outcome.text
    assert visit.table.x_mm() == pytest.approx(-3, abs=0.013)


def test_restarted_machine_with_an_older_zero_is_refused_and_stays_unknown(visit, tmp_path):
    visit.table.board.memory.places[FIRST_SYSTEM] = [1.0, 0.0, 0.0]

    def person():
        send(visit, tmp_path)
        yield visit.ended(1)
        assert visit.service.status().position_known is False

    visit.receive(person)
    assert "G54 was set before" in visit.outcomes[0].text


def test_job_that_homes_first_frees_a_locked_machine(tmp_path):
    kept = PositionTrustFile(tmp_path / "a.position")
    visit = Visit(tmp_path, homing=True, journals=tmp_path, kept=kept)

    def person():
        yield visit.at("alarm")
        send(visit, tmp_path, home_first=True)
        yield lambda: bool(visit.outcomes)
        yield visit.at("idle")
        assert visit.service.status().homed is True and visit.service.status().position_known is True

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and ("message", "the machine finds its own zero") in visit.told
    assert kept.trust == NOTHING_AGAINST


def test_homing_that_is_stopped_before_a_job_leaves_the_position_unknown(tmp_path):
    kept = PositionTrustFile(tmp_path / "a.position")
    visit = Visit(tmp_path, homing=True, journals=tmp_path, kept=kept)

    def person():
        yield visit.at("alarm")
        send(visit, tmp_path, home_first=True)
        yield lambda: visit.table.board.state.name == "HOME"
        yield 0.5
        assert kept.trust == LOST
        visit.ask("stop")
        yield lambda: bool(visit.outcomes)
        assert visit.service.status().position_known is False

    visit.receive(person)
    assert not visit.outcomes[0].done and not visit.outcomes[0].position_known
    assert kept.trust == LOST


def test_homing_that_is_not_enabled_costs_nothing(visit, tmp_path):
    def person():
        visit.ask("set_zero", axes="XYZ")
        send(visit, tmp_path, home_first=True)
        yield visit.ended(1)
        assert visit.service.status().position_known is True

    visit.receive(person)
    assert visit.outcomes[0].kind == REFUSED and visit.outcomes[0].error.code == "grbl-error-5"


def test_disconnect_ends_the_service_at_rest_alone(visit, tmp_path):
    def person():
        visit.ask("jog", x_mm=-30.0)
        yield visit.at("jogging")
        visit.ask("disconnect")
        yield visit.at("idle")
        visit.ask("set_zero", axes="XYZ")
        send(visit, tmp_path, LONG)
        yield visit.at("running")
        visit.ask("disconnect")
        yield visit.ended(1)
        visit.ask("disconnect")
        yield lambda: False

    visit.receive(person)
    assert visit.refusals() == ["machine-busy", "job-runs"]
    assert visit.table.closed
