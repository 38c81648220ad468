# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is called finished is finished, judged by a planner of these tests' own."""

from __future__ import annotations

import random

import pytest

from CNCStepper.control.stream.executed_lines import finished_lines

STEPS_PER_MM = 80
WORDS = (
    "G0X{x}Y{y}", "G1X{x}F600", "X{x}", "Y{y}", "Z{y}", "G0Z5", "S9000", "F{x}", "G91", "G90", "M3", "G10L20P1X{x}",
    "G92X{x}", "X{x}", "X{x}Y{y}", "M0", "G4P0.5", "G20", "G21", "x{x}", "G2X{x}Y{y}I1", "G43.1Z1",
)  # fmt: skip


class Planner:
    """Takes lines as a controller does and knows which of them still have moves in its queue of `size`."""

    def __init__(self, size: int):
        self.size = size
        self.queue: list[int] = []
        self.work = dict.fromkeys("XYZ", 0.0)
        self.scale, self.relative = 1.0, False

    def take(self, index: int, text: str) -> None:
        text = text.replace(" ", "").upper()
        self.scale = {"G20": 25.4, "G21": 1.0}.get(text, self.scale)
        self.relative = {"G91": True, "G90": False}.get(text, self.relative)
        if text in ("M0", "G4P0.5"):
            self.queue.clear()
        elif text.startswith(("G10", "G92")):
            self.work["X"] = float(text.partition("X")[2])
        elif text[0] in "XYZG" and not text.startswith("G43"):
            self._move(index, text)

    def _move(self, index: int, text: str) -> None:
        before = dict(self.work)
        for axis in "XYZ":
            number = text.partition(axis)[2]
            digits = "".join(c for c in number[: next((i for i, c in enumerate(number) if c.isalpha()), None)])
            if digits:
                value = float(digits) * self.scale
                self.work[axis] = self.work[axis] + value if self.relative else value
        if any(round(self.work[a] * STEPS_PER_MM) != round(before[a] * STEPS_PER_MM) for a in "XYZ"):
            self.queue = [*self.queue, index][-self.size :]


@pytest.mark.parametrize("seed", range(40))
def test_no_line_whose_move_may_be_queued_is_called_finished(seed):
    rng = random.Random(seed)
    planner = Planner(size := rng.choice([1, 4, 27]))
    step = rng.choice([0.005, 0.1, 3.0])
    lines, told = [], 0
    for index in range(400):
        word = rng.choice(WORDS if rng.random() < 0.3 else WORDS[:4])
        place = f"{rng.randrange(-20, 20) * step:.3f}"
        lines.append(word.format(x=place, y=f"{rng.randrange(3) * step:.3f}"))
        planner.take(index, lines[index])
        finished = finished_lines(lines, index + 1, size, 1 / STEPS_PER_MM)
        told = max(told, finished)
        assert finished <= (planner.queue[0] if planner.queue else index + 1), (seed, index, lines[: index + 1])
    assert told > 0 or step < 0.1, seed


def test_plain_lines_lag_by_what_the_planner_holds():
    lines = [f"G1X{number}F600" for number in range(100)]
    assert finished_lines(lines, 80, 27, 0.0125) == 52
    assert finished_lines(lines, 20, 27, 0.0125) == 0


def test_lines_without_a_way_do_not_count():
    lines = ["G0Z5", "G0Z5", "S1000", *(f"X{number}" for number in (1, 2, 2, 2, 3)), "S900"]
    assert finished_lines(lines, 9, 2, 0.0125) == 4


def test_a_pause_that_was_answered_ends_all_before_it():
    lines = ["G1X1F600", "G1X2", "M0", "G1X3"]
    assert finished_lines(lines, 4, 27, 0.0125) == 3


@pytest.mark.parametrize("pause", ["M0", "G4P0.5"])
def test_a_pause_that_a_reset_may_have_answered_ends_nothing(pause):
    assert finished_lines(["G1X1F600", "G1X2", pause, "G1X3"], 3, 27, 0.0125) == 0
