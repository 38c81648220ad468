# SPDX-License-Identifier: LGPL-2.1-or-later
"""A position that was lost stays lost for whoever connects next, until the machine is homed or all zeros are set."""

from __future__ import annotations

from pathlib import Path

import pytest

from CNCStepper.control.protocol.grbl.driver import RESET, RESUME
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session import files
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED
from CNCStepper.control.stream.position_trust import LOST, NOTHING_AGAINST
from CNCStepper.errors import LinkError
from helpers.control.service_bench import Person, Table, Visit
from helpers.control.workshop import LINES, Workshop

UNKNOWN = "position-unknown"


class Killed(BaseException):
    """The end of a process without a word."""


@pytest.fixture
def shop(tmp_path: Path) -> Workshop:
    workshop = Workshop(tmp_path)
    workshop.greet_nobody()
    return workshop


def reset_in_motion(table: Table) -> Person:
    yield lambda: table.board.state.value == "Run"
    table.board.receive(RESET)


def killed_in_motion(table: Table) -> Person:
    yield lambda: table.board.state.value == "Run"
    raise Killed


def unlock(visit: Visit) -> Person:
    if visit.phase == "alarm":
        visit.ask("unlock")
        yield visit.at("idle")


def zero(visit: Visit, axes: str = "XYZ") -> Person:
    before = len(visit.told)
    visit.ask("set_zero", axes=axes)
    yield lambda: any(text.startswith("zero of") for _, text in visit.told[before:])


def look(visit: Visit) -> Person:
    visit.known = visit.service.status().position_known
    return iter(())


def lose(shop: Workshop) -> None:
    """Let a job be reset in motion, and the lock be taken away."""
    assert shop.send(reset_in_motion).kind == FAILED
    shop.visit(unlock)


def test_after_a_reset_in_motion_no_word_lets_the_next_job_go(shop):
    lose(shop)
    for _ in range(2):
        blind = shop.send()
        assert blind.kind == REFUSED and blind.error.code == UNKNOWN and not blind.position_known
        assert "home it" in blind.text and "set the zero of all axes" in blind.text


def test_the_next_service_takes_a_jog_but_no_line_and_no_job(shop):
    lose(shop)

    def person(visit: Visit) -> Person:
        yield from look(visit)
        visit.ask("line", text="G0 X-6")
        yield lambda: bool(visit.refused)
        visit.job(*LINES, zeroed=False)
        yield visit.ended()
        visit.ask("jog", x_mm=-1.0)
        yield visit.at("jogging")
        yield visit.at("idle")

    visit = shop.visit(person)
    assert visit.known is False and visit.refusals() == [UNKNOWN]
    assert visit.outcomes[0].error.code == UNKNOWN and visit.table.x_mm() != 0


def test_zero_of_all_axes_makes_it_known_for_those_who_come_later(shop):
    lose(shop)
    shop.visit(zero)
    assert shop.visit(look).known is None and shop.send().kind == DONE
    assert shop.kept.trust == NOTHING_AGAINST and not list(shop.folder.glob("*.position"))


def test_zeros_may_be_set_one_after_another(shop):
    lose(shop)
    shop.visit(lambda visit: zero(visit, "XY"))
    assert shop.send().error.code == UNKNOWN
    shop.visit(lambda visit: zero(visit, "Z"))
    assert shop.send().kind == DONE


def test_after_its_sender_was_killed_a_machine_takes_no_job(shop):
    shop.visit(zero)
    with pytest.raises(Killed):
        shop.send(killed_in_motion)
    shop.board.advance(5.0)
    shop.greet_nobody()
    assert shop.send().error.code == UNKNOWN
    shop.visit(zero)
    assert shop.send().kind == DONE


def test_after_its_service_was_killed_in_a_job_a_machine_takes_none(shop):
    def person(visit: Visit) -> Person:
        visit.job(*LINES)
        yield visit.at("running")
        raise Killed

    with pytest.raises(Killed):
        shop.visit(person)
    assert PositionTrustFile.of_port(shop.folder, "table").trust == LOST


def test_a_locked_machine_is_unknown_also_when_it_was_unlocked_by_those_before(tmp_path):
    shop = Workshop(tmp_path, homing=True)  # its greeting is heard by the first who comes
    shop.visit(unlock)

    def person(visit: Visit) -> Person:
        visit.ask("line", text="G0 X-6")
        yield lambda: bool(visit.refused)

    assert shop.visit(person).refusals() == [UNKNOWN]
    assert shop.send().error.code == UNKNOWN


@pytest.mark.parametrize("first", [lambda shop: shop.visit(unlock), lambda shop: shop.send()])
def test_a_machine_met_in_alarm_without_a_greeting_is_unknown(tmp_path, first):
    shop = Workshop(tmp_path, homing=True)
    shop.greet_nobody()
    first(shop)
    assert shop.kept.trust == LOST


@pytest.mark.slow
def test_homing_makes_it_known(tmp_path):
    shop = Workshop(tmp_path, homing=True)
    shop.visit(unlock)
    assert shop.send(home_first=True).kind == DONE and shop.kept.trust == NOTHING_AGAINST

    def person(visit: Visit) -> Person:
        visit.ask("home")
        yield visit.at("homing")
        assert shop.kept.trust == LOST  # for whoever finds it killed
        yield visit.at("idle")

    shop.visit(person)
    assert shop.kept.trust == NOTHING_AGAINST


def test_homing_that_was_stopped_leaves_it_unknown(tmp_path):
    shop = Workshop(tmp_path, homing=True)
    shop.greet_nobody()

    def person(table: Table) -> Person:
        yield lambda: table.board.state.value == "Home"
        shop.sender.stop()

    assert shop.send(person, home_first=True).kind == STOPPED and shop.kept.trust == LOST


def test_homing_that_is_not_set_up_or_cannot_begin_costs_nothing(shop):
    assert shop.send(home_first=True).kind == REFUSED and shop.kept.trust == NOTHING_AGAINST
    shop.board.receive(b"G1X-5F600\n")
    shop.board.advance(0.1)
    shop.greet_nobody()
    busy = shop.send(home_first=True)
    assert busy.error.code == "machine-run" and shop.kept.trust == NOTHING_AGAINST


def test_a_greeting_mends_nothing_that_was_lost_before(shop):
    lose(shop)
    shop.board.power_up()
    shop.visit(unlock)
    assert shop.send().error.code == UNKNOWN


def test_after_a_greeting_a_word_counts_in_the_connections_that_follow_too(tmp_path):
    shop = Workshop(tmp_path)  # greets
    assert [shop.send().kind for _ in range(2)] == [DONE, DONE]
    shop.board.memory.places[54][0] = -3.0
    old = shop.send()
    assert old.error.code == UNKNOWN and "G54 was set before" in old.text


def test_a_stop_and_a_job_that_was_refused_cost_nothing(shop):
    shop.visit(zero)

    def person(table: Table) -> Person:
        yield lambda: table.board.state.value == "Run"
        shop.sender.stop()

    assert shop.send(person).kind == STOPPED
    assert shop.send(expected={110: 1.0}).error.code == "settings-differ"
    assert shop.kept.trust == NOTHING_AGAINST and shop.send().kind == DONE


def test_a_service_that_loses_its_link_at_rest_has_lost_the_position(shop):
    def person(visit: Visit) -> Person:
        yield from zero(visit)
        visit.table.cut = True

    with pytest.raises(LinkError):
        shop.visit(person)
    assert shop.kept.trust == LOST


def test_what_a_job_left_held_does_not_go_on_where_the_position_is_unknown(shop):
    with pytest.raises(Killed):
        shop.send(killed_in_motion)
    shop.board.receive(b"!")
    shop.board.advance(1.0)

    def person(visit: Visit) -> Person:
        visit.ask("resume")
        yield lambda: bool(visit.refused)
        visit.ask("stop")
        yield visit.at("idle")

    visit = shop.visit(person)
    assert visit.refusals() == [UNKNOWN] and not visit.table.sent(RESUME)


def test_no_job_begins_whose_end_could_not_be_told(shop, monkeypatch):
    def full(descriptor: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(files.os, "fsync", full)
    outcome = shop.send()
    assert outcome.kind == REFUSED and outcome.error.code == "position-unwritable" and "make room" in outcome.text
    assert shop.board.axes.position_mm[0] == 0


GREETING, ALARM = b"\r\nGrbl 1.1h ['$' for help]\r\n", b"\r\nALARM:1\r\n"


@pytest.mark.parametrize("stops", [True, False], ids=["stop", "no stop"])
@pytest.mark.parametrize("said", [GREETING, ALARM], ids=["greeting", "alarm"])
def test_what_the_machine_says_while_a_job_is_prepared_costs_the_position_beside_a_stop_too(shop, said, stops):
    def person(visit: Visit) -> Person:
        read = visit.table.read

        def disturbed(wait_s: float) -> bytes:
            if visit.service._run is None:
                return read(wait_s)
            visit.table.read = read
            if stops:
                visit.ask("stop")
            return read(wait_s) + said

        visit.table.read = disturbed
        visit.job(*LINES, zeroed=False)
        yield lambda: bool(visit.outcomes)
        yield 0.3
        yield from look(visit)

    visit = shop.visit(person)
    assert visit.outcomes[0].kind == (STOPPED if stops else REFUSED)
    assert not visit.outcomes[0].position_known and visit.known is False
    assert shop.kept.trust == LOST and shop.send().error.code == UNKNOWN


def test_a_stop_while_a_job_is_prepared_costs_nothing(shop):
    def person(visit: Visit) -> Person:
        yield from zero(visit)
        visit.job(*LINES)
        visit.ask("stop")
        yield lambda: bool(visit.outcomes)
        yield from look(visit)

    visit = shop.visit(person)
    assert visit.outcomes[0].kind == STOPPED and visit.outcomes[0].position_known and visit.known is True
