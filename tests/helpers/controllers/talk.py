# SPDX-License-Identifier: LGPL-2.1-or-later
"""A conversation with a board of ours that plays to a fake output, all in one simulated time."""

from __future__ import annotations

from CNCStepper.machine.profile import Machine
from helpers.controllers.simulated_board import TICK_S, SimulatedBoard


class Talk:
    """Speaks to a board."""

    def __init__(self, machine: Machine, **output):
        self.board = SimulatedBoard(machine, **output)
        self.output = self.board.output
        self.pass_time(0.01)
        self.greeting = self.read()

    def read(self) -> list[str]:
        """Return the lines that came."""
        return [line for line in self.board.take_output().decode("ascii").split("\r\n") if line]

    def pass_time(self, seconds: float) -> None:
        self.board.advance(seconds)

    def say(self, text: str | bytes, wait_s: float = 0.005) -> list[str]:
        """Send `text` as it is, let time pass and return the lines that came."""
        self.board.receive(text.encode("latin-1") if isinstance(text, str) else text)
        self.pass_time(wait_s)
        return self.read()

    def line(self, text: str, wait_s: float = 0.005) -> str:
        """Send one line and return the last line of the answer."""
        return (self.say(text + "\n", wait_s) or [""])[-1]

    def send(self, *lines: str, limit_s: float = 300.0) -> list[str]:
        """Send a program as a sender does that waits for each answer, and let it be cut to its end."""
        said: list[str] = []
        for line in lines:
            answer = self.say(line + "\n", TICK_S)
            end_s = self.output.time_s + limit_s
            while "ok" not in answer:
                assert not [one for one in answer if one.startswith(("error", "ALARM"))], (line, answer)
                assert self.output.time_s < end_s, (line, answer, self.board.state)
                answer += self.say(b"", TICK_S)
            said += answer
        return said + self.until_idle(limit_s)

    def until_idle(self, limit_s: float = 300.0) -> list[str]:
        """Let time pass until nothing moves and no line is in hand."""
        end_s, said = self.output.time_s + limit_s, []
        while not self.board.quiet:
            assert self.output.time_s < end_s, self.board.state
            said += self.say(b"", TICK_S)
        return said

    def status(self) -> dict[str, str]:
        """Ask for a status report and return its fields; the state is under ""."""
        self.board.receive(b"?")
        report = self.read()[-1]
        state, *fields = report[1:-1].split("|")
        return {"": state} | dict(field.split(":", 1) for field in fields)
