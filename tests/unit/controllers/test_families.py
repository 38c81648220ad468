# SPDX-License-Identifier: LGPL-2.1-or-later
"""One connection service, its commands and jobs, at a board of every family: the sender's side is the same for all."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from CNCStepper.control.journal.replay import read_replay
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.session.status import DONE, FAILED, STOPPED
from CNCStepper.errors import LinkError
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.recovery.restart.prove_restart import restart_program
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from helpers.control.service_bench import Person, Visit
from helpers.controllers.families import FAMILIES, board_of, machine_of

SQUARE = ("G21G90G94", "G1X20F1500", "G1Y20", "G1X0", "G1Y0")
BRIEF_S = {"grbl": 3.0, "parport": 6.0, "parport-dda": 16.0, "board": 6.0}  # of the teeth, more than is queued
TEETH = ("G21G90G94", "G1X0F1500", *(f"G1X{number / 2}Y{number % 3 / 4}" for number in range(1, 260)))


@pytest.fixture(params=FAMILIES)
def family(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture
def visit(family: str, tmp_path: Path) -> Visit:
    return Visit(tmp_path, board=board_of(family), journals=tmp_path)


def at(visit: Visit, x_mm: float, y_mm: float = 0.0) -> bool:
    return visit.table.board.axes.position_mm == pytest.approx([x_mm, y_mm, 0.0], abs=0.026)


def while_cutting(visit: Visit, *lines: str, seconds: float = 1.2) -> Person:
    """Begin a job and let it run for a while."""
    visit.job(*(lines or SQUARE))
    yield visit.at("running")
    yield seconds


def test_it_is_met_and_a_program_is_cut(visit: Visit, family: str) -> None:
    def person() -> Person:
        visit.job(*SQUARE, expected=expected_settings(machine_of(family)))
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE, visit.outcomes[0].text
    assert visit.outcomes[0].position_known and at(visit, 0.0) and visit.refused == []


def test_settings_that_differ_are_refused_before_the_first_move(visit: Visit, family: str) -> None:
    def person() -> Person:
        visit.job(*SQUARE, expected=expected_settings(machine_of(family)) | {100: 17.0})
        yield visit.ended()

    visit.receive(person)
    assert not visit.outcomes[0].done and "$100" in visit.outcomes[0].text
    assert at(visit, 0.0)


def test_a_hold_and_a_resume_change_nothing_of_the_path(visit: Visit) -> None:
    seen: list[Callable[[], bool]] = []

    def person() -> Person:
        yield from while_cutting(visit)
        visit.ask("hold")
        yield visit.at("held")
        place = list(visit.table.board.axes.position_mm)
        yield 2.0
        seen.append(visit.table.board.axes.position_mm == place)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert seen == [True] and visit.outcomes[0].kind == DONE and at(visit, 0.0)


def test_a_stop_brakes_and_keeps_the_position(visit: Visit) -> None:
    def person() -> Person:
        yield from while_cutting(visit)
        visit.ask("stop")
        yield visit.ended()
        visit.job("G21G90G94", "G1X5Y5F1500")
        yield visit.ended(2)

    visit.receive(person)
    assert [outcome.kind for outcome in visit.outcomes] == [STOPPED, DONE]
    assert visit.outcomes[0].position_known and at(visit, 5.0, 5.0)


def test_overrides_change_the_time_that_a_program_takes(family: str, tmp_path: Path) -> None:
    def cut_s(name: str, *steps: str) -> float:
        visit = Visit(tmp_path / name, board=board_of(family))
        (tmp_path / name).mkdir()
        times_s: list[float] = []

        def person() -> Person:
            visit.job("G21G90G94", "G1X15F600", "G1X0")
            yield visit.at("running")
            for step in steps:
                visit.ask("override", kind="feed", step=step)
            begin_s = visit.table.clock()
            yield visit.ended()
            times_s.append(visit.table.clock() - begin_s)

        visit.receive(person)
        return times_s[0]

    usual_s = cut_s("usual")
    assert cut_s("slow", *["-10"] * 5) == pytest.approx(2 * usual_s, rel=0.2)
    assert cut_s("fast", *["10"] * 10) < 0.85 * usual_s


def test_a_jog_goes_its_way_and_is_cancelled(visit: Visit) -> None:
    def person() -> Person:
        visit.ask("jog", x_mm=-5.0, y_mm=2.5)
        yield visit.at("jogging")
        yield visit.at("idle")
        assert at(visit, -5.0, 2.5)
        visit.ask("jog", x_mm=100.0)
        yield visit.at("jogging")
        yield 0.5
        visit.ask("stop")
        yield visit.at("idle")

    visit.receive(person)
    assert -5.0 < visit.table.x_mm() < 60.0 and visit.refused == []


def test_a_zero_is_set_and_programs_count_from_it(visit: Visit) -> None:
    def person() -> Person:
        visit.ask("jog", x_mm=10.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.ask("set_zero", axes="XYZ")
        axes = "XYZ" if "axis-z" not in visit.desk.status().cannot else "XY"  # all that the machine has
        yield lambda: ("message", f"zero of {axes} set in G54") in visit.told
        visit.job("G21G90G94", "G1X3F1500")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and at(visit, 13.0)


def test_a_pause_waits_for_somebody(visit: Visit) -> None:
    def person() -> Person:
        visit.job("G21G90G94", "G1X3F1500", "M0", "G1X6")
        yield visit.at("paused")
        yield 1.0
        assert at(visit, 3.0)
        visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and at(visit, 6.0)


def test_a_lost_link_is_told_and_a_reset_in_motion_costs_the_position(visit: Visit) -> None:
    def person() -> Person:
        yield from while_cutting(visit)
        visit.table.board.receive(b"\x18")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == FAILED and not visit.outcomes[0].position_known


def test_what_the_journal_knows_restarts_the_program(visit: Visit, family: str, tmp_path: Path) -> None:
    def person() -> Person:
        yield from while_cutting(visit, *TEETH, seconds=BRIEF_S[family])
        visit.ask("stop")
        yield visit.ended()

    visit.receive(person)
    journal = max(tmp_path.glob("*.journal"), key=lambda path: path.stat().st_mtime)
    story = read_replay(journal)
    assert 0 < story.finished < len(TEETH)
    text = "".join(f"{line}\n" for line in TEETH)
    mill = {"controller": "grbl", "processes": ("milling",), "spindle": load_machine("table-a").spindle}
    machine = machine_of(family).model_copy(update=mill)  # in the language of the wire
    proven = restart_program(text, machine, RequestedPlace(line=story.finished + 1), file="part.nc")
    job = certificate_of(proven.proof).send_job()
    again = Visit(tmp_path, board=visit.table.board)

    def second() -> Person:
        again.job(*job.lines)
        yield again.ended()

    again.receive(second)
    assert again.outcomes[0].kind == DONE, again.outcomes[0].text
    assert again.table.board.axes.position_mm[:2] == pytest.approx([129.5, 0.25], abs=0.026)


OWN = [name for name in FAMILIES if name != "grbl"]


@pytest.mark.parametrize("own", OWN)
def test_the_journal_of_a_short_job_names_the_line_in_which_it_was_stopped(own: str, tmp_path: Path) -> None:
    visit = Visit(tmp_path, board=board_of(own), journals=tmp_path)

    def person() -> Person:
        visit.job(*SQUARE)
        yield lambda: visit.table.board.axes.position_mm[1] > 5.0
        visit.ask("stop")
        yield visit.ended()

    visit.receive(person)
    story = read_replay(next(tmp_path.glob("*.journal")))
    assert (story.finished, story.first_line) == (2, 3), "G1Y20 was under way"


@pytest.mark.parametrize("own", OWN)
def test_why_the_pulses_ended_reaches_outcome_and_messages(own: str, tmp_path: Path) -> None:
    board = board_of(own)
    visit = Visit(tmp_path, board=board)

    def person() -> Person:
        yield from while_cutting(visit)
        board.output.error = LinkError("pulses-late", "a pulse came 4 ms late", advice="home the machine")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == FAILED and not visit.outcomes[0].position_known
    assert visit.outcomes[0].error.code.endswith("-alarm-3")
    assert any("a pulse came 4 ms late" in text for _, text in visit.told)
