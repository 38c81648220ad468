# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender at the mini-lathe's controller and the judge behind it, in simulated time, with what goes wrong there."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.settings import expected_settings
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import Outcome
from CNCStepper.errors import LinkError
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.machine.profile import load_machine
from helpers.control.fake_controller import FakeClock, Unqueued
from helpers.controllers.lathe_judge import LatheBench

STEP_S = 0.005
LIMIT_S = 300.0


class Killed(BaseException):
    """The end of the sender's process."""


class LatheLink(Unqueued):
    """A link to a board at a judge, in simulated time; during: called at each look with the time in s.

    sender_killed_s, controller_killed_s: when these processes end. starved_s: from when to when the controller's
    process gets no time.
    """

    name = "lathe"

    def __init__(self, during: Callable[[float], None] = lambda time_s: None):
        self.clock = FakeClock()
        self.bench = LatheBench()
        self.sender_killed_s = self.controller_killed_s = inf
        self.starved_s = (inf, inf)
        self._during = during
        self._heard = self.bench.said.encode("ascii")
        self.begin_s = self.clock()

    @property
    def time_s(self) -> float:
        """Time since the link was opened."""
        return self.clock() - self.begin_s

    def read(self, wait_s: float) -> bytes:
        end_s = self.clock() + wait_s
        while not self._heard and self.clock() < end_s:
            self._check()
            self._heard = self._pass_time()
            self.clock.now_s += STEP_S
            self._during(self.time_s)
            if self.time_s > LIMIT_S:
                raise LinkError("test", "the test takes too long")
        heard, self._heard = self._heard, b""
        return heard

    def write(self, data: bytes) -> None:
        self._check()
        self.bench.board.receive(data)

    def wake(self) -> None:
        """Nobody waits."""

    def close(self) -> None:
        if self.time_s < self.controller_killed_s:
            self.bench.board.close()

    def _pass_time(self) -> bytes:
        if self.starved_s[0] <= self.time_s < self.starved_s[1]:
            self.bench.time_s += STEP_S  # the lathe works on, nothing is sent
            return b""
        return self.bench.wait(STEP_S, STEP_S).encode("ascii")

    def _check(self) -> None:
        if self.time_s >= self.sender_killed_s:
            raise Killed
        if self.time_s >= self.controller_killed_s:
            raise LinkError("link-lost", "the controller's process has ended")


def sent(
    program: str, told: list[str], during: Callable[[float, Sender], None] | None = None, link: LatheLink | None = None
) -> tuple[LatheLink, Outcome]:
    """Send a program; return its link and the outcome. Raises Killed where the sender was killed."""
    link = link or LatheLink()
    job = SendJob(
        "lathe",
        list(prepare(program, "mini-lathe").lines),
        zero_confirmed=True,
        dialect="mini-lathe",
        expected=expected_settings(load_machine("mini-lathe")),
    )
    sender = Sender(job, opener=lambda name, baud: link, clock=link.clock, tell=lambda kind, text: told.append(text))
    if during:
        link._during = lambda time_s: during(time_s, sender)
    return link, sender.run()
