# SPDX-License-Identifier: LGPL-2.1-or-later
"""Path modes on the emitted steps: exact stops stand, blended corners keep to their tolerance and to the limits."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.chunk_window import ChunkWindow
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import duration_s, step_events, times_s
from CNCStepper.state import Start, State
from CNCStepper.toolpath import COLUMNS, Chunk, TableBuilder
from helpers.motion.chunks import in_chunks

LIMITS = replace(Limits.of(load_machine("table-a")), steps_per_mm=(1000.0,) * 3, acceleration_mm_s2=(250.0,) * 3)
SQUARE = [(10, 0, 0), (10, 10, 0), (0, 10, 0), (0, 0, 0)]
EXACT, STOP, BLEND = State(), State(path_mode="exact_stop"), State(path_mode="blend", blend_mm=0.2)


def table_of(points, state, feed=2400):
    table = TableBuilder(Start.at_zero(), state)
    for point in points:
        table.feed(point, feed)
    return table.toolpath()


def places_mm(toolpath):
    """Return times and positions of all steps."""
    times, positions = (np.concatenate(columns) for columns in zip(*step_events(toolpath, LIMITS), strict=True))
    return times, positions / 1000.0


def test_a_chunk_without_rows_changes_nothing():
    """As a table has that is read in pieces of which one holds no move."""
    pieces = in_chunks(table_of(SQUARE, BLEND), 2)
    empty = in_chunks(table_of(SQUARE[:1], BLEND), 1).chunks[0]
    empty = Chunk(2, *(getattr(empty, name)[:0] for name in COLUMNS))
    wanted = places_mm(pieces)
    for chunks in ([*pieces.chunks[:1], empty, *pieces.chunks[1:]], [empty, *pieces.chunks, empty]):
        for held in (chunks, ChunkWindow(chunks)):
            assert np.array_equal(places_mm(replace(pieces, chunks=held))[0], wanted[0])


def lround(value):
    """Return the whole number nearest to a value, a half away from 0, as the firmware's lround() has it."""
    return math.copysign(math.floor(abs(value) + 0.5), value)


def deviation_mm(points, way):
    """Return the greatest distance of any point from a polyline that begins at 0."""
    begins = np.vstack([np.zeros((1, 3)), way[:-1]])
    nearest = np.full(len(points), np.inf)
    for begin, end in zip(begins, np.array(way, float), strict=True):
        along = np.clip((points - begin) @ (end - begin) / max((end - begin) @ (end - begin), 1e-12), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(points - begin - along[:, None] * (end - begin), axis=1))
    return float(nearest.max())


def test_an_exact_stop_stands_at_every_corner():
    way = [(10, 0, 0), (20, 0, 0), (20, 10, 0)]
    alone = duration_s(table_of(way[:1], EXACT), LIMITS)
    assert duration_s(table_of(way, STOP), LIMITS) == pytest.approx(3 * alone, abs=0.04)
    assert duration_s(table_of(way, EXACT), LIMITS) < 2.6 * alone


def test_an_exact_stop_of_one_row_holds_at_its_end_only():
    table = TableBuilder(Start.at_zero(), EXACT)
    table.feed((10, 0, 0), 2400)
    table.set_state(STOP)
    table.feed((20, 0, 0), 2400)
    table.set_state(EXACT)
    table.feed((30, 0, 0), 2400)
    lengths = [duration_s(table_of([(length, 0, 0)], EXACT), LIMITS) for length in (20, 10)]
    assert duration_s(table.toolpath(), LIMITS) == pytest.approx(sum(lengths), abs=0.03)


def test_blending_is_faster_and_stays_within_its_tolerance():
    exact, blended = (places_mm(table_of(SQUARE, state)) for state in (EXACT, BLEND))
    assert blended[0][-1] < exact[0][-1] - 0.015
    assert deviation_mm(exact[1], SQUARE) <= 0.0015
    assert 0.13 < deviation_mm(blended[1], SQUARE) <= 0.2 + 0.0015


@pytest.mark.slow
@example([(0.0, 0.0, 0.0), (0.0, 0.0, 0.0625)], 0.02, 200.0)  # 62.5 steps
@example([(0.0, 0.0, 0.0), (0.0, 0.0, -0.0625)], 0.02, 200.0)
@settings(max_examples=40, deadline=None)
@given(
    st.lists(st.tuples(st.floats(-8, 8), st.floats(-8, 8), st.floats(-2, 2)), min_size=2, max_size=9),
    st.sampled_from([0.02, 0.1, 0.5, 5.0]),
    st.floats(200, 5000),
)
def test_random_ways_keep_to_tolerance_limits_and_target(points, allowed_mm, feed):
    toolpath = table_of(points, replace(BLEND, blend_mm=allowed_mm), feed)
    if not np.rint(np.array(points) * 1000).any():
        return
    times, places = places_mm(toolpath)
    assert np.rint(places[-1] * 1000).tolist() == [lround(np.float32(end) * np.float32(1000)) for end in points[-1]]
    assert deviation_mm(places, points) <= allowed_mm + 0.002
    grid = np.arange(times[0] - 0.1, times[-1] + 0.1, 0.04)
    at = np.vstack([np.zeros((1, 3)), places])[np.searchsorted(times, grid, side="right")]
    speeds = np.diff(at, axis=0) / 0.04
    corner = 2 * math.sqrt(250 * LIMITS.junction_deviation_mm * 10)
    assert np.abs(np.diff(speeds, axis=0)).max() <= 250 * 0.08 + corner + 0.1
    assert np.all(np.abs(speeds).max(axis=0) <= np.array(LIMITS.max_speed_mm_s) * 1.001 + 0.1)


@pytest.mark.parametrize("size", [1, 2, 5])
def test_split_chunks_give_the_same_times(size):
    for state in (STOP, BLEND):
        toolpath = table_of(SQUARE * 3, state)
        assert times_s(in_chunks(toolpath, size), LIMITS).tolist() == times_s(toolpath, LIMITS).tolist()


def test_a_corner_with_a_dwell_or_a_rapid_behind_it_is_not_cut():
    table = TableBuilder(Start.at_zero(), BLEND)
    table.feed((10, 0, 0), 2400)
    table.event("dwell", 0.1)
    table.feed((10, 10, 0), 2400)
    table.rapid((0, 10, 0))
    assert deviation_mm(places_mm(table.toolpath())[1], [(10, 0, 0), (10, 10, 0), (0, 10, 0)]) <= 0.0015


def test_a_tolerance_within_the_junction_deviation_changes_nothing():
    fine = replace(BLEND, blend_mm=LIMITS.junction_deviation_mm)
    assert times_s(table_of(SQUARE, fine), LIMITS).tolist() == times_s(table_of(SQUARE, EXACT), LIMITS).tolist()
