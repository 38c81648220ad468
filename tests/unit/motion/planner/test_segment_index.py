# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pulses around a moment: those of the whole run, in either direction, from any mark, in little memory."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner import plan
from CNCStepper.motion.planner.plan import Run, begun, step_events
from CNCStepper.motion.planner.segment_index import Pulse, Pulses
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

MACHINE = load_machine("table-a")
PROGRAM = """G21 G90 G94
M3 S10000
G4 P0.3
G1 X0.8 Y0.2 F600
G3 X-0.8 Y0.2 I-0.8 J0.6 F900
G4 P0.2
G1 X-0.8 Y0.2
G1 Z-0.1 F120
M3 S8000
G2 X0 Y0 I0.4 J-0.1 Z-0.2
G0 Z0.2
M5
"""


@pytest.fixture
def toolpath(monkeypatch: pytest.MonkeyPatch) -> Toolpath:
    monkeypatch.setattr(plan, "SEGMENT_ROWS", 7)  # marks in dwells, within arcs, between rows
    return interpret(PROGRAM, Start.at_zero())


def all_pulses(toolpath: Toolpath) -> list[Pulse]:
    return [
        Pulse(float(time_s), tuple(position.tolist()))
        for times_s, positions in step_events(toolpath, MACHINE)
        for time_s, position in zip(times_s, positions, strict=True)
    ]


def test_going_forwards_and_backwards_gives_every_pulse_of_the_run(toolpath: Toolpath) -> None:
    wanted = all_pulses(toolpath)
    pulses = Pulses(toolpath, MACHINE)
    assert len(wanted) > 500
    there, time_s = [], -1.0
    while pulse := pulses.after(time_s):
        there.append(pulse)
        time_s = pulse.time_s
    assert there == wanted
    back, time_s = [], 1e9
    while pulse := pulses.before(time_s):
        back.append(pulse)
        time_s = pulse.time_s
    assert back == wanted[::-1]
    assert len(pulses._pieces) > 8


def test_any_moment_in_any_order(toolpath: Toolpath) -> None:
    wanted = all_pulses(toolpath)
    times_s = np.array([pulse.time_s for pulse in wanted])
    pulses = Pulses(toolpath, MACHINE)
    for time_s in np.random.default_rng(4).uniform(-0.1, times_s[-1] + 0.1, 60):
        later, earlier = np.searchsorted(times_s, time_s, side="right"), np.searchsorted(times_s, time_s) - 1
        assert pulses.after(time_s) == (wanted[later] if later < len(wanted) else None)
        assert pulses.before(time_s) == (wanted[earlier] if earlier >= 0 else None)


def test_a_moment_is_reached_without_the_pulses_before_it(monkeypatch: pytest.MonkeyPatch) -> None:
    lines = "\n".join(f"G1 X{300 * (k % 2)} F1000" for k in range(1, 101))
    toolpath = interpret(f"G21 G90 G94\n{lines}\n", Start.at_zero())
    made = []

    def counted(segments):
        made.append(len(segments))
        return step_table(segments)

    step_table = plan.step_table
    monkeypatch.setattr("CNCStepper.motion.planner.segment_index.step_table", counted)
    pulses = Pulses(toolpath, MACHINE)
    end_s = float(Run(toolpath, MACHINE).times_s()[-1])
    assert end_s > 1000 and pulses.after(0.9 * end_s) and sum(made) <= 2
    assert pulses.before(0.1 * end_s) and sum(made) <= 4


def test_a_program_without_motion_has_no_pulse() -> None:
    pulses = Pulses(begun(interpret("G21 G90\nM3 S1000\n", Start())), MACHINE)
    assert pulses.after(0.0) is None and pulses.before(10.0) is None
