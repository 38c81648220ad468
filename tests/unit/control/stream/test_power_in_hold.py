# SPDX-License-Identifier: LGPL-2.1-or-later
"""A torch is put out by a hold and pierces again behind it; a hot wire stands hot only as long as it may."""

from __future__ import annotations

from itertools import pairwise
from math import dist
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.control.session.command import Command
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.states import State
from helpers.control.retract_bench import Cut

PROGRAM = "G21 G90\nG0 X-5 Y-5\nM3 S8000\nG4 P0.7\nG1 X-40 F1500\nG2 X-60 Y-25 I0 J-20\nM5\nG0 X0 Y0\nM2\n"
LIFTED = PROGRAM.replace("M3 S8000\nG4 P0.7\n", "G0 Z-6\nM3 S8000\nG4 P0.7\nG1 Z-8 F600\n").replace(
    "M5\n", "M5\nG0 Z0\n"
)


def table(process: str, has_z: bool = True) -> Machine:
    machine = load_machine("table-a")
    axes = {name: axis for name, axis in machine.axis.items() if has_z or name != "z"}
    return machine.model_copy(update={"processes": (process,), "axis": axes})


class Moments:
    """What the spindle output was at each moment, and where: (time, state, rpm, x, y)."""

    def __init__(self, cut: Cut):
        self.seen: list[tuple[float, State, float, float, float]] = []
        self._old = cut.table.board.on_step
        cut.table.board.on_step = self._note

    def _note(self, board) -> None:
        x, y, _ = board.axes.position_mm
        self.seen.append((board.time_s, board.state, board.spindle.rpm, x, y))
        self._old(board)

    def standing_on_s(self) -> float:
        """Return how long the tool stood in a hold with power, after it had come to rest."""
        held = [(time_s, rpm) for time_s, state, rpm, *_ in self.seen if state is State.HOLD]
        return sum(late - early for (early, rpm), (late, _) in pairwise(held) if rpm)


def waits(cut: Cut) -> int:
    """Return how often the tool was waited for."""
    return b"".join(data for _, data in cut.table.written).count(b"G4P0.7\n")


def held(cut: Cut, x_mm: float):
    yield lambda: cut.trace[-1][0] < x_mm
    yield from cut.hold()


@pytest.mark.slow
@pytest.mark.parametrize(("program", "has_z"), [(PROGRAM, True), (PROGRAM, False), (LIFTED, True)])
def test_a_torch_is_out_in_a_hold_and_pierces_again_behind_it(tmp_path: Path, program: str, has_z: bool) -> None:
    cut, at = Cut(tmp_path, program, table("plasma", has_z)), []
    moments = Moments(cut)

    def person():
        yield from held(cut, -20.0)
        yield lambda: cut.table.board.spindle.rpm == 0.0
        at.append(cut.trace[-1])
        cut.sender.ask(Command("resume"))
        yield lambda: cut.sender.status().wanted_rest
        found: list = []
        yield from cut.find(found)
        yield from cut.go(found[0].rest())

    assert cut.run(person).done, cut.refused
    assert moments.standing_on_s() < 0.3
    on = [x for _, state, rpm, x, y in moments.seen if rpm and state is State.RUN and y == pytest.approx(-5.0, abs=0.1)]
    assert min(on) < -39.5
    back = [x for *_, x, y in moments.seen if y == pytest.approx(-5.0, abs=0.1)]
    stop_x = at[0][0]
    pierced = stop_x + PROCESSES["plasma"].run_up_mm
    assert any(abs(x - pierced) < 0.05 for x in back), "it went back along its kerf"
    assert waits(cut) == 2
    dark = [
        x
        for _, state, rpm, x, _ in moments.seen
        if rpm == 0.0 and state is State.RUN and stop_x + 0.1 < x < pierced - 0.1
    ]
    assert dark, "without power"


@pytest.mark.slow
@pytest.mark.parametrize("stands_s", [0.5, 6.0])
def test_a_hot_wire_stands_hot_only_as_long_as_it_may(tmp_path: Path, stands_s: float) -> None:
    cut, rests = Cut(tmp_path, PROGRAM, table("hot-wire", has_z=False)), []
    moments = Moments(cut)

    def person():
        yield from held(cut, -20.0)
        end_s = cut.table.clock() + stands_s
        yield lambda: cut.table.clock() > end_s
        cut.sender.ask(Command("resume"))
        if stands_s > 2.0:
            yield lambda: cut.sender.status().wanted_rest
            found: list = []
            yield from cut.find(found)
            rests.append(found[0].rest())
            yield from cut.go(rests[0])

    assert cut.run(person).done, cut.refused
    most_s = PROCESSES["hot-wire"].stand_s
    assert moments.standing_on_s() < min(stands_s, most_s) + 0.7
    assert moments.standing_on_s() > min(stands_s, most_s) - 0.5
    assert waits(cut) == (2 if rests else 1), "a wire that has cooled heats up again"


@pytest.mark.slow
def test_a_spindle_turns_on_in_a_hold(tmp_path: Path) -> None:
    cut, rpm = Cut(tmp_path, PROGRAM, load_machine("table-a")), []

    def person():
        yield from held(cut, -20.0)
        end_s = cut.table.clock() + 4.0
        yield lambda: cut.table.clock() > end_s
        rpm.append(cut.table.board.spindle.rpm)
        cut.sender.ask(Command("resume"))

    assert cut.run(person).done
    assert rpm == [8000.0]


@pytest.mark.slow
def test_a_hold_in_a_rapid_needs_no_pierce(tmp_path: Path) -> None:
    cut = Cut(tmp_path, PROGRAM, table("plasma"))

    def person():
        yield lambda: dist(cut.trace[-1][:2], (-60.0, -25.0)) < 0.05
        yield lambda: cut.trace[-1][0] > -50.0
        yield from cut.hold()
        cut.sender.ask(Command("resume"))

    assert cut.run(person).done, cut.refused
    assert np.allclose(cut.trace[-1], 0.0, atol=0.02)
