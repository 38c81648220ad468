# SPDX-License-Identifier: LGPL-2.1-or-later
"""The guard through which Qt and FreeCAD call us: nothing passes it, and nothing is lost in it."""

from __future__ import annotations

import pytest

from CNCStepper.errors import JobError
from CNCStepper.workbench.services import messages


@pytest.fixture
def told(monkeypatch: pytest.MonkeyPatch) -> list[BaseException]:
    """What the guard told, in order."""
    problems: list[BaseException] = []
    monkeypatch.setattr(messages, "error", problems.append)
    return problems


def test_what_is_raised_is_told_and_none_returned(told: list[BaseException]) -> None:
    def refuse() -> int:
        raise JobError("bad", "no")

    assert messages.guarded(refuse)() is None
    assert [str(problem) for problem in told] == ["no [bad]"]


def test_the_answer_and_the_arguments_pass(told: list[BaseException]) -> None:
    assert messages.guarded(lambda a, b=2: a + b)(1, b=5) == 6
    assert not told


@pytest.mark.parametrize("sent", [(), (True,), (True, 3)])
def test_surplus_arguments_of_a_signal_are_dropped(told: list[BaseException], sent: tuple[object, ...]) -> None:
    class Panel:
        @messages.guarded
        def clicked(self) -> str:
            return "done"

    assert Panel().clicked(*sent) == "done"
    assert not told


def test_a_slot_that_takes_any_number_gets_all(told: list[BaseException]) -> None:
    assert messages.guarded(lambda *sent: sent)(1, 2) == (1, 2)


def test_what_is_asked_all_the_time_tells_each_fault_once(told: list[BaseException]) -> None:
    faults = iter([ValueError("one"), ValueError("one"), ValueError("two")])

    def ask() -> bool:
        raise next(faults)

    asked = messages.polled(ask)
    assert [asked(), asked(), asked()] == [None] * 3
    assert [str(problem) for problem in told] == ["one", "two"]


def test_a_click_tells_the_same_fault_again(told: list[BaseException]) -> None:
    def fail() -> None:
        raise ValueError("one")

    clicked = messages.guarded(fail)
    clicked()
    clicked()
    assert len(told) == 2


def test_the_end_of_the_program_is_no_error(told: list[BaseException]) -> None:
    def leave() -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        messages.guarded(leave)()
    assert not told
