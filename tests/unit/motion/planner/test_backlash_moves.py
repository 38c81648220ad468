# SPDX-License-Identifier: LGPL-2.1-or-later
"""Motors with play: the pulses that they get, through a gap, bring the tool where the table of moves says."""

from __future__ import annotations

import random
from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.planner import backlash_moves
from CNCStepper.motion.planner.backlash_moves import motor_moves, row_times_s, tool_moves
from CNCStepper.motion.planner.plan import begun, sample, step_events, times_s
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, COLUMNS, RAPID, TableBuilder, Toolpath


def loose(*backlash_mm: float, homing: str = "max") -> Machine:
    machine = load_machine("table-a")
    pairs = zip(machine.axis.items(), backlash_mm, strict=True)
    axes = {name: axis.model_copy(update={"backlash_mm": gap, "homing": homing}) for (name, axis), gap in pairs}
    return machine.model_copy(update={"axis": axes})


def moves_of(random_of: random.Random) -> Toolpath:
    table = TableBuilder(Start.at_zero())
    table.open_span("operation", "all")
    for _ in range(12):
        table.feed([random_of.uniform(-9, 9) for _ in range(3)], 900.0)
    at = np.array(table.toolpath().table().end[-1])
    table = TableBuilder(Start.at_zero())
    table.rapid(at)
    table.event("dwell", 0.1)
    for _ in range(6):
        centre = at + np.array([random_of.uniform(-4, 4), random_of.uniform(-4, 4), 0.0])
        table.arc(random_of.choice((ARC_CW, ARC_CCW)), at, centre, 900.0)
        at = at + [random_of.uniform(-5, 5) for _ in range(3)]
        table.feed(at, 900.0)
    return table.toolpath()


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("homing", ["min", "max"])
def test_every_pulse_through_the_gap_leaves_the_tool_on_its_way(seed: int, homing: str) -> None:
    """The gap is modelled here by itself: the tool is pushed by the one or the other side of what the motor turns."""
    print("seed", seed)
    machine = loose(0.25, 0.1, 0.05, homing=homing)
    path = moves_of(random.Random(seed))
    motors = motor_moves(path, Backlash.of(machine))
    scale = np.array([axis.steps_per_mm for axis in machine.axes])
    gap = np.round(np.array([axis.backlash_mm for axis in machine.axes]) * scale).astype(int)
    tool, places = np.zeros(3, int), []
    low_side, high_side = (np.zeros(3, int), gap) if homing == "max" else (-gap, np.zeros(3, int))
    for _, positions in step_events(motors, machine):
        for position in positions:
            tool = np.clip(tool, position - high_side, position - low_side)
            places.append(tool)
    tool_mm = np.array(places) / scale
    for row, end in enumerate(path.table().end):
        near = np.abs(tool_mm - end).max(axis=1).min()
        assert near < 1.6 / scale.min(), row
    assert np.abs(tool_mm[-1] - path.table().end[-1]).max() < 1.6 / scale.min()
    # no pulse leads away from the way: the times at which the tool moves are those of the tool's own rows
    wanted = sample(path, machine, np.linspace(0, times_s(path, machine)[-1], 4000)) / scale
    for place in tool_mm[::97]:
        assert np.abs(wanted - place).max(axis=1).min() < 0.2


def test_the_rows_lead_back_to_the_tool_s_own() -> None:
    path = moves_of(random.Random(3))
    play = Backlash.of(loose(0.25, 0.1, 0.05))
    motors = motor_moves(path, play)
    tool = tool_moves(motors, play)
    taken_up = np.abs(np.diff(np.vstack([tool.begins()[:1], tool.table().end]), axis=0)).max(axis=1) < 1e-9
    after = np.flatnonzero(taken_up) + 1  # at the feed of the moves that follow, so rapids before rapids alone
    assert taken_up.any() and (motors.table().feed[taken_up] == motors.table().feed[after]).all()
    assert ((motors.table().kind[taken_up] == RAPID) == (motors.table().kind[after] == RAPID)).all()
    as_laser = motor_moves(path, replace(play, beam=True)).table()
    assert (as_laser.kind[taken_up] == RAPID).all()
    ends = {tuple(np.round(end, 6)) for end in tool.table().end.tolist()}
    assert {tuple(np.round(end, 6)) for end in path.table().end.tolist()} <= ends
    assert [event.kind for event in motors.events] == ["dwell"]


def test_rows_take_their_time_with_what_takes_up_play_before_them() -> None:
    machine = loose(0.5, 0.0, 0.0)
    table = TableBuilder(Start.at_zero())
    for x in (-5.0, -2.0, -6.0):
        table.feed((x, 0.0, 0.0), 600.0)
    path = table.toolpath()
    with_play, without = row_times_s(path, machine, Backlash.of(machine)), row_times_s(path, machine)
    assert with_play[0] == pytest.approx(without[0], abs=0.1)
    assert (np.diff(with_play - without) > 0.03).all()
    motors = motor_moves(path, Backlash.of(machine)).table().end[:, 0].tolist()
    assert motors == [-5.0, -4.5, -1.5, -2.0, -6.0]


def test_machines_without_play_move_as_they_did() -> None:
    path = moves_of(random.Random(1))
    assert motor_moves(path, Backlash.of(load_machine("table-a"))) is path
    assert tool_moves(path, Backlash.of(load_machine("table-a"))) is path


def test_an_axis_from_an_unknown_place_comes_in_its_true_sense() -> None:
    table = TableBuilder(Start())
    table.rapid((float("nan"), float("nan"), 5.0))
    motors = motor_moves(table.toolpath(), Backlash.of(loose(0.1, 0.1, 0.1)))
    assert motors.table().end[:, 2].tolist() == [5.1, 5.0]
    assert times_s(begun(motors), loose(0.1, 0.1, 0.1))[-1] > 0


def many_moves(random_of: random.Random) -> Toolpath:
    """Lines that turn back, stand still or make less than a step, rapids, a few arcs, and a begin that is unknown."""
    table = TableBuilder(Start())
    table.rapid((float("nan"), float("nan"), 5.0))
    at = [1.0, 1.0, 5.0]
    table.rapid(at)
    for _ in range(300):
        at = [place + random_of.choice((0, 0, random_of.uniform(-1, 1), 0.001, -0.001)) for place in at]
        if random_of.random() < 0.02:
            centre = (at[0] + random_of.uniform(-4, 4), at[1] + random_of.uniform(-4, 4), at[2])
            table.arc(random_of.choice((ARC_CW, ARC_CCW)), at, centre, 900.0)
        elif random_of.random() < 0.2:
            table.rapid(at)
        else:
            table.feed(at, random_of.choice((300.0, 900.0)))
    return table.toolpath()


@pytest.mark.parametrize("seed", range(8))
def test_rows_in_a_run_become_the_same_as_one_by_one(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    print("seed", seed)
    random_of = random.Random(seed)
    path = many_moves(random_of)
    play = replace(Backlash.of(loose(0.25, 0.0, 0.05)), true_sense=random_of.choice([(1, -1, 1), (-1, 1, -1)]))
    ways = []
    for least in (2, 1_000_000):
        monkeypatch.setattr(backlash_moves, "LEAST_RUN", least)
        table = motor_moves(path, replace(play, beam=seed % 2 == 1)).table()
        ways.append([getattr(table, name).tobytes() for name in COLUMNS])
    assert ways[0] == ways[1]
    kinds = path.table().kind
    assert (kinds == ARC_CW).any() or (kinds == ARC_CCW).any()
    assert len(table) > len(path) + 50  # play is taken up often
