# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge nobody here wrote: recordings of the firmware itself, streamed into the virtual grbl."""

from __future__ import annotations

import json
from collections import deque
from pathlib import Path

import pytest

from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.grbl.link import Link
from CNCStepper.virtual.grbl.machine import Grbl

RECORDINGS = sorted((Path(__file__).parents[2] / "data" / "firmware").glob("*.json"))
WINDOW = 127
STEP_S = 0.002
LONGEST_S = 300.0


class Streamed:
    """What came of a program that was streamed by character counting."""

    def __init__(self, link: Link, program: list[str]):
        self.board = link.board
        self.answers = 0
        self.moved_s: list[float] = []  # times at which the axes were seen to have moved
        self._stream(link, deque(line.encode("ascii") + b"\n" for line in program))

    def _stream(self, link: Link, lines: deque[bytes]) -> None:
        unanswered: deque[int] = deque()
        received = b""
        place = self.board.axes.position_steps
        while lines or unanswered or not link.quiet:
            while lines and sum(unanswered) + len(lines[0]) <= WINDOW:
                unanswered.append(len(lines[0]))
                link.send(lines.popleft())
            link.advance(STEP_S)
            assert self.board.time_s < LONGEST_S
            if self.board.axes.position_steps != place:
                place = self.board.axes.position_steps
                self.moved_s.append(self.board.time_s)
            *answers, received = (received + link.receive()).split(b"\r\n")
            for answer in filter(None, answers):
                assert answer == b"ok"
                unanswered.popleft()
                self.answers += 1

    @property
    def duration_s(self) -> float:
        return self.moved_s[-1] - self.moved_s[0]


@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_a_recorded_program_runs_as_it_did(path: Path) -> None:
    recording = json.loads(path.read_text("utf-8"))
    link = Link(Grbl(load_machine(recording["machine"])))
    link.advance(0.1)
    link.receive()
    streamed = Streamed(link, recording["program"])
    assert streamed.answers == len(recording["program"])
    assert list(link.board.axes.position_steps) == recording["end_steps"]
    assert streamed.duration_s == pytest.approx(recording["duration_s"], rel=0.002)
    assert link.board.ring.lost == 0
