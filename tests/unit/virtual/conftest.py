# SPDX-License-Identifier: LGPL-2.1-or-later
"""A conversation with a virtual board: say something, let time pass, read the answer."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.machine import Grbl

TICK_S = 0.002


class Talk:
    """Speaks to a board without a serial line; `say` returns the lines of the answer."""

    def __init__(self, board: Grbl):
        self.board = board

    def say(self, text: str | bytes, wait_s: float = 0.01) -> list[str]:
        """Send `text` (a line end is not added), let `wait_s` pass, and return the lines received."""
        self.board.receive(text.encode("latin-1") if isinstance(text, str) else text)
        for _ in range(max(1, round(wait_s / TICK_S))):
            self.board.advance(TICK_S)
        return [line for line in self.board.take_output().decode("ascii").split("\r\n") if line]

    def line(self, text: str, wait_s: float = 0.01) -> str:
        """Send one line and return the last line of the answer."""
        return (self.say(text + "\n", wait_s) or [""])[-1]

    def until_idle(self, limit_s: float = 120.0) -> list[str]:
        """Let time pass until the machine is idle or locked; return what it said."""
        said, end_s = [], self.board.time_s + limit_s
        while self.board.time_s < end_s:
            said += self.say(b"")
            if self.board.quiet:
                return said
        raise AssertionError(f"still {self.board.state} after {limit_s} s")

    def status(self) -> dict[str, str]:
        """Ask for a status report and return its fields; the state is under ''."""
        report = self.say(b"?", 0)[-1]
        assert report.startswith("<") and report.endswith(">")
        state, *fields = report[1:-1].split("|")
        return {"": state} | dict(field.split(":", 1) for field in fields)


@pytest.fixture
def machine() -> Machine:
    return load_machine("table-a")


@pytest.fixture
def talk(machine: Machine) -> Callable[..., Talk]:
    """Return a board that has been switched on and has said its greeting."""

    def switched_on(**options: object) -> Talk:
        talker = Talk(Grbl(options.pop("machine", machine), **options))  # type: ignore[arg-type]
        talker.greeting = talker.say(b"")  # type: ignore[attr-defined]
        return talker

    return switched_on


@pytest.fixture
def grbl(talk: Callable[..., Talk]) -> Talk:
    return talk()
