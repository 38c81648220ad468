# SPDX-License-Identifier: LGPL-2.1-or-later
"""The three ramps on fine steps, random programs for them, and the speeds that their emitted steps have."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import strategies as st

from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.step_wait_tables import accelerated_s
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import step_events
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder

TRAPEZOID = replace(Limits.of(load_machine("table-a")), steps_per_mm=(800.0, 800.0, 800.0))
S_CURVE = replace(TRAPEZOID, ramp="s_curve", jerk_mm_s3=(4000.0, 4000.0, 1000.0))
TABLE = replace(TRAPEZOID, ramp="table", waits_s=accelerated_s(250 * 800.0, 4000))
RAMPS = [pytest.param(limits, id=limits.ramp) for limits in (TRAPEZOID, S_CURVE, TABLE)]
GRID_S = 0.02
WINDOW_S = 0.03  # three segments: in less their paces may differ by more than the acceleration

coordinate = st.floats(-20, 20)
moves = st.lists(
    st.tuples(st.tuples(coordinate, coordinate, st.floats(-4, 4)), st.floats(60, 6000), st.booleans()),
    min_size=1,
    max_size=12,
)


def table_of(rows, state=None):
    table = TableBuilder(Start.at_zero(), state or State())
    for end, feed, rapid in rows:
        table.rapid(end) if rapid else table.feed(end, feed)
    return table.toolpath()


def all_steps(toolpath, limits):
    pieces = list(step_events(toolpath, limits))
    times, positions = (np.concatenate(columns) for columns in zip(*pieces, strict=True))
    return times, np.vstack([np.zeros((1, 3), np.int64), positions])


def speeds_mm_s(toolpath, limits, grid_s=GRID_S):
    """Return the mean speed of every axis in each grid_s, float64[n, axes], from the emitted steps."""
    times, positions = all_steps(toolpath, limits)
    grid = np.arange(times[0] - 3 * grid_s, times[-1] + 3 * grid_s, grid_s)
    places = positions[np.searchsorted(times, grid, side="right")] / np.array(limits.steps_per_mm)
    return np.diff(places, axis=0) / grid_s


def targets(rows, limits):
    exact = np.array([end for end, *_ in rows], np.float32) * np.array(limits.steps_per_mm, np.float32)
    return np.sign(exact) * np.floor(np.abs(exact) + 0.5)  # halves away from zero, as grbl's lround
