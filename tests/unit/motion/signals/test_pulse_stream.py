# SPDX-License-Identifier: LGPL-2.1-or-later
"""The stream of pulses: the same moments and places as the table of steps, in chunks, to the last step.

The steps of single ticks against the closed form of where the axes stand, for one to eight axes.
"""

from dataclasses import replace

import numpy as np
import pytest

from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.buffers import EIGHTHS, TICKS_PER_S, new_segments
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import Run
from CNCStepper.motion.planner.step_timeline import place_in, step_table
from CNCStepper.motion.signals import pulse_stream as module
from CNCStepper.motion.signals.pulse_stream import keep_steps, moved_steps, pulse_stream, write_bits
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder

LIMITS = Limits.of(load_machine("table-a"))


def random_path(seed, moves=60):
    rng = np.random.default_rng(seed)
    table = TableBuilder(Start.at_zero())
    for end in np.cumsum(rng.normal(0, 2.0, (moves, 3)) * (1, 1, 0.1), axis=0):
        table.feed(end, float(rng.choice([20.0, 300.0, 3000.0])))
    return table.toolpath()


def bits_of(mask, axes=3):
    return (mask[:, None].astype(np.int64) >> np.arange(axes)) & 1


def positions_of(stream):
    """Return ticks and positions of all rows of a stream."""
    ticks, moves = [], []
    for chunk in stream:
        ticks.append(chunk.ticks.copy())
        moves.append(bits_of(chunk.step) - 2 * bits_of(chunk.back))
    return np.concatenate(ticks), np.cumsum(np.concatenate(moves), axis=0) + stream.begin_steps


@pytest.mark.parametrize("rows", [7, 1000, module.PULSE_ROWS])
def test_the_stream_makes_the_steps_of_the_table_of_steps(rows, monkeypatch):
    monkeypatch.setattr(module, "PULSE_ROWS", rows)
    path = random_path(3, 60 if rows > 7 else 4)
    tables = [tuple(map(np.copy, step_table(piece))) for piece in Run(path, LIMITS).segments()]
    stream = pulse_stream(path, LIMITS)
    ticks, positions = positions_of(stream)
    np.testing.assert_array_equal(ticks, np.concatenate([clocks for clocks, _ in tables]))
    np.testing.assert_array_equal(positions, np.concatenate([places for _, places in tables]))
    assert (np.diff(ticks) > 0).all()
    assert max(len(chunk) for chunk in pulse_stream(path, LIMITS)) <= rows


@pytest.mark.parametrize("seed", range(6))
def test_the_sum_of_the_pulses_is_the_target(seed):
    print("seed", seed)
    path = random_path(seed)
    total = sum(moved_steps(chunk, 3) for chunk in pulse_stream(path, LIMITS))
    np.testing.assert_array_equal(total, np.rint(path.table().end[-1] * LIMITS.steps_per_mm))


PROGRAM = """G21 G90
M3 S10000
G4 P3
G0 X1
M8
G1 X2 F300
S5000
G1 X3
M5
M64 P2
G4 P1
M9
M2
"""


def test_devices_switch_between_the_pulses_of_the_moves_around_them():
    path = interpret(PROGRAM, Start.at_zero(), "linuxcnc", "job.ngc")
    chunks = [replace(chunk, ticks=chunk.ticks.copy()) for chunk in pulse_stream(path, LIMITS)]
    before = np.cumsum([0] + [len(chunk) for chunk in chunks])
    made = [
        (before[k] + switch.row, switch.device, switch.on, switch.rpm)
        for k, chunk in enumerate(chunks)
        for switch in chunk.switches
    ]
    assert made == [
        (0, "spindle_cw", True, 10000),
        (80, "flood", True, 0),
        (160, "spindle_cw", True, 5000),
        (240, "spindle_cw", False, 0),
        (240, "output_2", True, 0),
        (240, "flood", False, 0),
    ]


def test_a_dwell_parts_the_switches_around_it_and_the_move_from_them():
    path = interpret(PROGRAM, Start.at_zero(), "linuxcnc", "job.ngc")
    ticks, switches = [], []
    for chunk in pulse_stream(path, LIMITS):
        ticks += chunk.ticks.tolist()
        switches += chunk.switches
    on, flood, _, off, output, dry = (switch.tick for switch in switches)
    assert 3 * TICKS_PER_S <= ticks[0] - on < 3.2 * TICKS_PER_S
    assert ticks[79] < flood < ticks[80]
    assert ticks[-1] < off <= output and dry - output == TICKS_PER_S


@pytest.mark.parametrize("moves", [3, pytest.param(210, marks=pytest.mark.slow)])
def test_steps_do_not_drift_in_a_long_job(moves):
    rng = np.random.default_rng(11)
    limits = Limits((5000.3, 3333.33, 123.4567), (6000.0,) * 3, (2000.0,) * 3, 0.01, 0.002)
    table = TableBuilder(Start.at_zero())
    for k in range(moves):
        table.feed((1000.0 * (k % 2 == 0) + rng.uniform(0, 1), rng.uniform(-300, 300), rng.uniform(-9, 9)), 6000)
    path = table.toolpath()
    total, rows = np.zeros(3, np.int64), 0
    for chunk in pulse_stream(path, limits):
        total += moved_steps(chunk, 3)
        rows += len(chunk)
    assert rows > (1_000_000_000 if moves > 200 else 14_000_000)
    np.testing.assert_array_equal(total, np.rint(path.table().end[-1] * limits.steps_per_mm))


SEED = 20261122


def random_segment(rng, axes):
    """Return a segment somewhere within a block of any size."""
    segment = new_segments(1, axes)[0]
    most = int(rng.choice([3, 40, 5000, 2**30]))
    segment.steps[:] = rng.integers(-most, most + 1, axes)
    segment.steps[rng.integers(axes)] = most
    segment.begin[:] = rng.integers(-(10**9), 10**9, axes)
    segment.events = most
    segment.unit = rng.choice([1, 2, 4, 8])
    done = int(rng.integers(0, most))
    segment.eighths = EIGHTHS * done
    segment.ticks = min((most - done) * EIGHTHS // segment.unit, int(rng.integers(1, 300)))
    segment.start, segment.cycles = rng.integers(0, 10**12), rng.integers(400, 65_535)
    return segment


def positions(segment, first, last):
    places = np.empty((last - first + 1, len(segment.steps)), np.int64)
    for row in range(len(places)):
        place_in(segment, first + row, places[row])
    return places


@pytest.mark.slow
@pytest.mark.parametrize("axes", range(1, 9))
def test_every_tick_steps_as_the_closed_form_says(axes):
    rng = np.random.default_rng(SEED + axes)
    for _ in range(60):
        segment = random_segment(rng, axes)
        last = int(segment.ticks)
        first = int(rng.integers(0, last))
        bits = np.empty(last - first, np.uint8)
        write_bits(segment, first, last, bits)
        moved = np.diff(positions(segment, first, last), axis=0)
        assert (bits[:, None] >> np.arange(axes) & 1).tolist() == np.abs(moved).tolist()
        rows = (np.empty(last - first, np.int64), np.empty_like(bits), np.empty_like(bits))
        count = keep_steps(segment, first, last, bits, *rows, 0)
        ticks, step, back = (column[:count] for column in rows)
        on = np.flatnonzero(bits)
        assert ticks.tolist() == (segment.start + (first + 1 + on) * segment.cycles).tolist()
        assert step.tolist() == bits[on].tolist()
        assert (back[:, None] >> np.arange(axes) & 1).tolist() == (moved[on] < 0).tolist()
