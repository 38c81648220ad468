# SPDX-License-Identifier: LGPL-2.1-or-later
"""One connection service, its commands and jobs, at a board of every family: the sender's side is the same for all.

A family does each as far as it can, and refuses the rest in words: the mini-lathe's program cannot be held, led on,
sped up or stopped over its link.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from CNCStepper.control.journal.replay import read_replay
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED
from CNCStepper.errors import LinkError, ProgramError
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.recovery.restart.prove_restart import restart_program
from CNCStepper.recovery.restart.restart_places import RequestedPlace
from helpers.control.service_bench import Person, Visit
from helpers.controllers.families import FAMILIES, G_CODE, board_of, machine_of, programs_of

SQUARE = G_CODE.square
BRIEF_S = {
    "grbl": 3.0,
    "parport": 6.0,
    "parport-dda": 16.0,
    "board": 6.0,
    "lathe": 3.0,
}  # of the teeth, more than is queued
TEETH = ("G21G90G94", "G1X0F1500", *(f"G1X{number / 2}Y{number % 3 / 4}" for number in range(1, 260)))


class FamilyVisit(Visit):
    """A visit at a board of a family, whose language is that of its jobs."""

    def __init__(self, family: str, tmp_path: Path, **more):
        super().__init__(tmp_path, **{"board": board_of(family)} | more)
        self.programs = programs_of(family)
        self.other_axis = "z_mm" if family == "lathe" else "y_mm"

    def job(self, *lines: str, **job) -> None:
        super().job(*lines, dialect=self.programs.dialect, **job)


@pytest.fixture(params=FAMILIES)
def family(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture
def visit(family: str, tmp_path: Path) -> FamilyVisit:
    return FamilyVisit(family, tmp_path, journals=tmp_path)


def at(visit: Visit, x_mm: float, y_mm: float = 0.0, z_mm: float = 0.0) -> bool:
    return visit.table.board.axes.position_mm == pytest.approx([x_mm, y_mm, z_mm], abs=0.026)


def cannot(visit: FamilyVisit, *commands: str) -> bool:
    """Return whether these, and no others, were refused as what the machine cannot do."""
    return [(name, error.code) for name, error in visit.refused] == [(command, "cannot") for command in commands]


def while_cutting(visit: FamilyVisit, *lines: str, seconds: float = 1.2) -> Person:
    """Begin a job and let it run for a while."""
    visit.job(*(lines or visit.programs.square))
    yield visit.at("running")
    yield seconds


def test_it_is_met_and_a_program_is_cut(visit: FamilyVisit, family: str) -> None:
    def person() -> Person:
        visit.job(*visit.programs.square, expected=expected_settings(machine_of(family)))
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE, visit.outcomes[0].text
    assert visit.outcomes[0].position_known and at(visit, 0.0) and visit.refused == []


def test_settings_that_differ_are_refused_before_the_first_move(visit: FamilyVisit, family: str) -> None:
    def person() -> Person:
        visit.job(*visit.programs.square, expected=expected_settings(machine_of(family)) | {100: 17.0})
        yield visit.ended()

    visit.receive(person)
    assert not visit.outcomes[0].done and "$100" in visit.outcomes[0].text
    assert at(visit, 0.0)


def test_a_hold_and_a_resume_change_nothing_of_the_path(visit: FamilyVisit, family: str) -> None:
    seen: list[bool] = []

    def person() -> Person:
        yield from while_cutting(visit)
        visit.ask("hold")
        if family == "lathe":
            yield lambda: cannot(visit, "hold")
        else:
            yield visit.at("held")
            place = list(visit.table.board.axes.position_mm)
            yield 2.0
            seen.append(visit.table.board.axes.position_mm == place)
            visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    assert seen == [True] * (family != "lathe") and visit.outcomes[0].kind == DONE and at(visit, 0.0)


def test_a_stop_brakes_and_keeps_the_position(visit: FamilyVisit, family: str) -> None:
    def person() -> Person:
        yield from while_cutting(visit)
        visit.ask("stop")
        yield visit.ended()
        visit.job(*visit.programs.to_3)
        yield visit.ended(2)

    visit.receive(person)
    assert visit.outcomes[0].kind == STOPPED
    if family == "lathe":  # what it has it cuts, and there is no way back to its manual mode
        assert visit.refusals() == ["cannot", "lathe-error-9"] and at(visit, -2.0)
        assert visit.outcomes[1].kind == REFUSED and "cannot be stopped" in visit.outcomes[0].text
    else:
        assert visit.outcomes[1].kind == DONE and visit.outcomes[0].position_known and at(visit, 3.0)


def test_overrides_change_the_time_that_a_program_takes(family: str, tmp_path: Path) -> None:
    def cut_s(name: str, *steps: str) -> float:
        (tmp_path / name).mkdir()
        visit = FamilyVisit(family, tmp_path / name)
        times_s: list[float] = []

        def person() -> Person:
            visit.job(*visit.programs.there_and_back)
            yield visit.at("running")
            for step in steps:
                visit.ask("override", kind="feed", step=step)
            begin_s = visit.table.clock()
            yield visit.ended()
            times_s.append(visit.table.clock() - begin_s)

        visit.receive(person)
        assert family != "lathe" or cannot(visit, *["override"] * len(steps))
        return times_s[0]

    usual_s = cut_s("usual")
    changes = family != "lathe"
    assert cut_s("slow", *["-10"] * 5) == pytest.approx((2 if changes else 1) * usual_s, rel=0.2)
    fast_s = cut_s("fast", *["10"] * 10)
    assert fast_s < 0.85 * usual_s if changes else fast_s == pytest.approx(usual_s, rel=0.05)


def test_a_jog_goes_its_way_and_is_cancelled(visit: FamilyVisit) -> None:
    def person() -> Person:
        for way in ({"x_mm": -5.0}, {visit.other_axis: 2.5}):
            visit.ask("jog", feed_mm_min=120.0, **way)
            yield visit.at("jogging")
            yield visit.at("idle")
        assert at(visit, -5.0, **{visit.other_axis: 2.5})
        visit.ask("jog", x_mm=100.0)
        yield visit.at("jogging")
        yield 0.5
        visit.ask("stop")
        yield visit.at("idle")

    visit.receive(person)
    assert -5.0 < visit.table.x_mm() < 60.0 and visit.refused == []


def test_a_zero_is_set_and_programs_count_from_it(visit: FamilyVisit) -> None:
    def person() -> Person:
        visit.ask("jog", x_mm=10.0, feed_mm_min=120.0)
        yield visit.at("jogging")
        yield visit.at("idle")
        visit.ask("set_zero", axes="XYZ")
        axes = "".join(axis for axis in "XYZ" if f"axis-{axis.lower()}" not in visit.service.status().cannot)
        yield lambda: ("message", f"zero of {axes} set in G54") in visit.told
        visit.job(*visit.programs.to_3)
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == DONE and at(visit, 13.0)


def test_a_pause_waits_for_somebody(visit: FamilyVisit, family: str) -> None:
    to_3 = visit.programs.to_3

    def person() -> Person:
        visit.job(*to_3, "M00#" if family == "lathe" else "M0", to_3[-1].replace("X3", "X6"))
        if family != "lathe":
            yield visit.at("paused")
            yield 1.0
            assert at(visit, 3.0)
            visit.ask("resume")
        yield visit.ended()

    visit.receive(person)
    if family == "lathe":  # its language has no pause: the record is refused, and nothing behind it is cut
        assert visit.outcomes[0].kind == FAILED and "M00#" in visit.outcomes[0].text and at(visit, 3.0)
    else:
        assert visit.outcomes[0].kind == DONE and at(visit, 6.0)


def test_a_lost_link_is_told_and_a_reset_in_motion_costs_the_position(visit: FamilyVisit) -> None:
    def person() -> Person:
        yield from while_cutting(visit)
        visit.table.board.receive(b"\x18")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == FAILED and not visit.outcomes[0].position_known


def test_what_the_journal_knows_restarts_the_program(visit: FamilyVisit, family: str, tmp_path: Path) -> None:
    lines = TEETH if family != "lathe" else (*visit.programs.square, "G01X-1.F1.#")

    def person() -> Person:
        yield from while_cutting(visit, *lines, seconds=BRIEF_S[family])
        visit.ask("stop")
        yield visit.ended()

    visit.receive(person)
    journal = max(tmp_path.glob("*.journal"), key=lambda path: path.stat().st_mtime)
    story = read_replay(journal)
    assert 0 < story.finished < len(lines)
    text = "".join(f"{line}\n" for line in lines)
    if family == "lathe":
        with pytest.raises(ProgramError, match="send the whole program"):
            restart_program(text, machine_of(family), RequestedPlace(line=story.finished + 1))
        again = FamilyVisit(family, tmp_path)  # a lathe that was switched off and on
        job_lines: Sequence[str] = lines
    else:
        mill = {"controller": "grbl", "processes": ("milling",), "spindle": load_machine("table-a").spindle}
        machine = machine_of(family).model_copy(update=mill)  # in the language of the wire
        proven = restart_program(text, machine, RequestedPlace(line=story.finished + 1), file="part.nc")
        again = FamilyVisit(family, tmp_path, board=visit.table.board)
        job_lines = certificate_of(proven.proof).send_job().lines

    def second() -> Person:
        again.job(*job_lines)
        yield again.ended()

    again.receive(second)
    assert again.outcomes[0].kind == DONE, again.outcomes[0].text
    end_mm = (-1.0, 0.0) if family == "lathe" else (129.5, 0.25)
    assert again.table.board.axes.position_mm[:2] == pytest.approx(end_mm, abs=0.026)


OWN = [name for name in FAMILIES if name not in ("grbl", "lathe")]  # whose pulses this computer makes


@pytest.mark.parametrize("own", OWN)
def test_the_journal_of_a_short_job_names_the_line_in_which_it_was_stopped(own: str, tmp_path: Path) -> None:
    visit = FamilyVisit(own, tmp_path, journals=tmp_path)

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
    visit = FamilyVisit(own, tmp_path, board=board)

    def person() -> Person:
        yield from while_cutting(visit)
        board.output.error = LinkError("pulses-late", "a pulse came 4 ms late", advice="home the machine")
        yield visit.ended()

    visit.receive(person)
    assert visit.outcomes[0].kind == FAILED and not visit.outcomes[0].position_known
    assert visit.outcomes[0].error.code.endswith("-alarm-3")
    assert any("a pulse came 4 ms late" in text for _, text in visit.told)
