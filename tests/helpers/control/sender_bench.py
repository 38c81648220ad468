# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender and a scripted controller, both in memory and in simulated time."""

from __future__ import annotations

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.protocol.grbl.timeouts import Timing
from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.status import Outcome
from helpers.control.fake_controller import FakeClock, FakeController, FakeLink

LINES = tuple(f"G1X{number}Y{number % 7}F600" for number in range(60))


class Bench:
    """One sender and one controller in memory."""

    def __init__(self, lines=LINES, *, timing: Timing | None = None, seed=0, line_s=0.002, rx_bytes=128, **job):
        self.clock = FakeClock()
        self.controller = FakeController(self.clock, seed=seed, line_s=line_s, rx_bytes=rx_bytes)
        self.link = FakeLink(self.controller, self.clock)
        self.told: list[tuple[str, str]] = []
        job = {"zero_confirmed": True, "file": "part.nc"} | job
        self.sender = Sender(
            SendJob("fake", lines, **job),
            opener=lambda name, baud: self.link,
            timing=timing,
            clock=self.clock,
            tell=self.tell,
        )
        self.on_phase: dict[str, object] = {}

    def tell(self, kind: str, text: str) -> None:
        self.told.append((kind, text))
        action = self.on_phase.pop(text, None) if kind == "phase" else None
        if action:
            action()

    def phases(self) -> list[str]:
        return [text for kind, text in self.told if kind == "phase"]

    def run(self) -> Outcome:
        return self.sender.run()
