# SPDX-License-Identifier: LGPL-2.1-or-later
"""The judge nobody here wrote: recordings of the firmware itself, streamed into the virtual grbl."""

from __future__ import annotations

import json
from collections import deque
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.serial_line import Link

DATA = Path(__file__).parents[2] / "data" / "firmware"
RECORDINGS = sorted(DATA.glob("*.json"))
WINDOW = 127
STEP_S = 0.005
LONGEST_S = 300.0
LATEST_S = 0.01


class Streamed:
    """What came of a program that was streamed by character counting."""

    def __init__(self, link: Link, program: list[str]):
        self.board = link.board
        self.answers = 0
        self.times_s: list[float] = []  # ends of the stretches in which the axes moved, with their places
        self.places: list[tuple[int, ...]] = []
        self._last_s = 0.0
        self.pulses = [0, 0, 0]
        self._place = self.board.axes.position_steps
        self.board.on_step = self._note
        self._stream(link, deque(line.encode("ascii") + b"\n" for line in program))

    def _stream(self, link: Link, lines: deque[bytes]) -> None:
        unanswered: deque[int] = deque()
        received = b""
        while lines or unanswered or not link.quiet:
            while lines and sum(unanswered) + len(lines[0]) <= WINDOW:
                unanswered.append(len(lines[0]))
                link.send(lines.popleft())
            link.advance(STEP_S)
            assert self.board.time_s < LONGEST_S
            *answers, received = (received + link.receive()).split(b"\r\n")
            for answer in filter(None, answers):
                assert answer == b"ok"
                unanswered.popleft()
                self.answers += 1

    def _note(self, board: Grbl) -> None:
        before, self._place = self._place, board.axes.position_steps
        if before != self._place:
            if not self.times_s or self._last_s > self.times_s[-1]:
                self._keep(self._last_s, before)
            self._keep(board.time_s, self._place)
            moves = zip(self.pulses, self._place, before, strict=True)
            self.pulses = [pulses + abs(now - then) for pulses, now, then in moves]
        self._last_s = board.time_s

    def _keep(self, time_s: float, place: tuple[int, ...]) -> None:
        self.times_s.append(time_s)
        self.places.append(place)

    @property
    def duration_s(self) -> float:
        return self.times_s[-1] - self.times_s[0]

    def places_at(self, times_s: np.ndarray) -> np.ndarray:
        """Return the position in steps at times after the first move began, float64[n, 3]."""
        clock = np.array(self.times_s) - self.times_s[0]
        return np.column_stack([np.interp(times_s, clock, axis) for axis in zip(*self.places, strict=True)])


def machine_of(recording: dict) -> Machine:
    """Return the machine of a recording; one that is not shipped lies beside the recordings."""
    beside = DATA / f"{recording['machine']}.toml"
    return load_machine(beside if beside.exists() else recording["machine"])


def assert_sampled_places(streamed: Streamed, samples: np.ndarray) -> None:
    """Each recorded place must be passed within LATEST_S of its recorded time, on each axis."""
    around = [streamed.places_at(samples[:, 0] + shift) for shift in np.linspace(-LATEST_S, LATEST_S, 9)]
    assert np.all(samples[:, 1:] >= np.min(around, axis=0) - 1)
    assert np.all(samples[:, 1:] <= np.max(around, axis=0) + 1)


@pytest.mark.slow
@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_a_recorded_program_runs_as_it_did(path: Path) -> None:
    recording = json.loads(path.read_text("utf-8"))
    link = Link(Grbl(machine_of(recording)))
    link.advance(0.1)
    link.receive()
    streamed = Streamed(link, recording["program"])
    assert streamed.answers == len(recording["program"])
    assert list(link.board.axes.position_mm) == pytest.approx(recording["end_mpos_mm"], abs=1e-6)
    assert streamed.duration_s == pytest.approx(recording["duration_s"], abs=STEP_S + 0.001)
    assert link.board.ring.lost == 0
    if "samples_t_s_x_y_z_steps" in recording:
        assert_sampled_places(streamed, np.array(recording["samples_t_s_x_y_z_steps"], float))
    if "pulses" in recording:
        assert streamed.pulses == list(recording["pulses"].values())


@pytest.mark.slow
def test_the_judge_can_fail() -> None:
    recording = json.loads((DATA / "brazil_a.json").read_text("utf-8"))
    link = Link(Grbl(load_machine(recording["machine"])))
    link.advance(0.1)
    link.receive()
    link.board.receive(b"\x91")  # ten percent faster
    streamed = Streamed(link, recording["program"])
    assert streamed.pulses == list(recording["pulses"].values())
    assert streamed.duration_s < 0.99 * recording["duration_s"]
    with pytest.raises(AssertionError):
        assert_sampled_places(streamed, np.array(recording["samples_t_s_x_y_z_steps"], float))
