# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines that a person types at a service: which go to the machine, what comes back, and when they are done."""

from __future__ import annotations

import pytest

from CNCStepper.control.operator.console import HOME, JOG, PROGRAM, QUESTION, SETTING, UNLOCK, kind_of
from CNCStepper.errors import MachineRefusal
from helpers.control.service_bench import Visit


@pytest.fixture
def visit(tmp_path):
    return Visit(tmp_path)


def typed(visit: Visit, text: str):
    """Type a line and wait until it is answered or refused."""
    before = len(answers(visit)) + len(visit.refused)
    visit.ask("line", text=text)
    yield lambda: len(answers(visit)) + len(visit.refused) > before


def answers(visit: Visit) -> list[str]:
    return [text for kind, text in visit.told if kind == "answer"]


def said(visit: Visit) -> list[str]:
    return [text for kind, text in visit.told if kind == "console"]


def known_position(visit: Visit):
    visit.ask("set_zero", axes="XYZ")
    yield lambda: visit.service.status().position_known is True


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("$h", HOME),
        ("$X", UNLOCK),
        ("$", QUESTION),
        ("$$", QUESTION),
        ("$#", QUESTION),
        ("$G", QUESTION),
        ("$/report_inches", QUESTION),
        ("$J=G91X1F100", JOG),
        ("$110 = 500.5", SETTING),
        ("g0 x1", PROGRAM),
        ("M3S1000", PROGRAM),
    ],
)
def test_kinds_of_lines_are_told_apart(text, kind):
    assert kind_of(text) == kind


@pytest.mark.parametrize("text", ["$C", "$SLP", "$RST=*", "$N0=G0X1", "$I=mine", "$FOO", "$J", "$110", "$/a=1"])
def test_commands_that_a_console_does_not_pass_on_are_refused_with_a_reason(text):
    with pytest.raises(MachineRefusal) as refused:
        kind_of(text)
    assert refused.value.code == "console-command" and refused.value.advice


def test_question_is_answered_with_the_controllers_words(visit):
    def person():
        yield from typed(visit, "$G")
        yield from typed(visit, "$$")

    visit.receive(person)
    assert answers(visit) == ["ok", "ok"] and not visit.refused
    assert said(visit)[0].startswith("[GC:G0 G54") and "$110=5000" in said(visit)


def test_after_a_greeting_only_homing_jog_and_unlock_move_the_machine(visit):
    def person():
        assert visit.service.status().position_known is False
        yield from typed(visit, "G0X-5")
        yield from typed(visit, "$J=G91X-2F3000")

    visit.receive(person)
    assert [error.code for _, error in visit.refused] == ["position-unknown"]
    assert answers(visit) == ["ok"] and visit.table.x_mm() == pytest.approx(-2.0, abs=0.02)


def test_line_is_done_when_the_machine_stands(visit):
    seen = []

    def person():
        yield from known_position(visit)
        yield from typed(visit, "G0X-20")
        seen.append(visit.table.x_mm())

    visit.receive(person)
    assert seen == [pytest.approx(-20.0, abs=0.02)] and answers(visit) == ["ok"]


def test_line_that_the_controller_refuses_is_told_in_words(visit):
    def person():
        yield from known_position(visit)
        yield from typed(visit, "G1X5")

    visit.receive(person)
    assert answers(visit)[0].startswith("error:22 no feed rate was set; give an F word")


@pytest.mark.parametrize("text", ["G0X1!", "G0X1?", "(ф)", "G0X1~", "G0" + "X1" * 40])
def test_bytes_that_act_and_lines_too_long_do_not_reach_the_wire(visit, text):
    def person():
        yield from known_position(visit)
        visit.table.written.clear()
        yield from typed(visit, text)

    visit.receive(person)
    assert len(visit.refused) == 1
    assert not any(data not in (b"?",) and b"G0" in data for _, data in visit.table.written)


def test_second_line_waits_and_a_held_move_goes_on_or_is_stopped(visit):
    def person():
        yield from known_position(visit)
        visit.ask("line", text="G1X-40F1500")
        yield visit.at("busy")
        visit.ask("line", text="G0X0")
        yield lambda: len(visit.refused) == 1
        visit.ask("hold")
        yield lambda: visit.service.status().machine_state == "Hold:1"
        visit.ask("resume")
        yield lambda: len(visit.refused) == 2
        yield lambda: visit.service.status().machine_state == "Hold:0"
        visit.ask("resume")
        yield visit.at("busy")
        visit.ask("stop")
        yield visit.at("idle")

    visit.receive(person)
    assert [error.code for _, error in visit.refused] == ["machine-busy", "machine-slowing"]
    assert answers(visit) == ["given up: the controller was reset or is locked"]
    assert visit.service.status().position_known is True


def test_setting_is_taken_over_and_other_steps_cost_the_position(visit):
    known = []

    def person():
        yield from known_position(visit)
        for text in ("$110=4000", "$100=81"):
            yield from typed(visit, text)
            known.append(visit.service.status().position_known)

    visit.receive(person)
    assert known == [True, False] and answers(visit) == ["ok", "ok"]


@pytest.mark.slow
def test_home_and_unlock_are_the_services_own(tmp_path):
    visit = Visit(tmp_path, homing=True)

    def person():
        yield from typed(visit, "$X")
        yield visit.at("idle")
        visit.ask("line", text="$H")
        yield visit.at("homing")
        yield visit.at("idle")

    visit.receive(person)
    assert visit.service.status().homed and not visit.refused


def test_long_dwell_is_no_missing_answer(visit):
    def person():
        yield from known_position(visit)
        yield from typed(visit, "G4P15")

    visit.receive(person)
    assert answers(visit) == ["ok"]


def test_no_line_is_taken_while_a_job_runs(visit):
    def person():
        visit.job("G21G90G94", "G1X-20F1500", "G1X0")
        yield visit.at("running")
        visit.ask("line", text="G0X1")
        yield visit.ended()

    visit.receive(person)
    assert [error.code for _, error in visit.refused] == ["job-runs"]


def test_report_that_nobody_asked_for_is_told_and_the_services_own_questions_are_not(visit):
    def person():
        yield from known_position(visit)
        yield 1.0  # the service asks $# and $G anew
        visit.table.board.send("[PRB:1.000,2.000,3.000:1]")
        yield lambda: bool(said(visit))

    visit.receive(person)
    assert said(visit) == ["[PRB:1.000,2.000,3.000:1]"] and not answers(visit)
