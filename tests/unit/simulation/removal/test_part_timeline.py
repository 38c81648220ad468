# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part at any moment: the same bytes whichever way it is reached, and those of a program that ends there."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner import plan
from CNCStepper.simulation.removal import timeline as module
from CNCStepper.simulation.removal.heightmap import HeightMap, Tile, height_map
from CNCStepper.simulation.removal.timeline import Timeline
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW, ZX
from helpers.simulation.programs import BALL, FLAT, begun, square_pocket

STOCK = Stock((60, 50, 20))
CELL_MM = 0.4


def curved():
    """Return a program of lines, ramps, a helix, an arc of another plane, plunges and a row that takes no time."""
    program = begun().feed(0, 0, -1).arc(ARC_CCW, (0, 0, -4), (4, 0, -1), turns=3).feed(10, 3, -4).feed(10, 3, -4)
    program.feed(12, 9, -2).feed(12, 9, 1).rapid(-15, 0, 1).feed(-15, 0, -1).arc(ARC_CCW, (-7, 0, -1), (-11, 0, -1), ZX)
    return program.feed(-9, 8, -3)


def data(part: HeightMap) -> bytes:
    return part.heights_mm.tobytes() + part.part.means_mm().tobytes()


def made(program, tool=FLAT):
    toolpath = program.toolpath()
    ends_s = np.cumsum(np.random.default_rng(1).uniform(0.1, 2.0, len(toolpath)))
    return toolpath, Timeline(toolpath, ends_s, tool, STOCK, CELL_MM)


@pytest.fixture
def near_check_points(monkeypatch) -> None:
    monkeypatch.setattr(module, "WORK_CELLS", 3000)


@pytest.mark.parametrize("tool", [FLAT, BALL], ids=["flat", "ball"])
@pytest.mark.parametrize("program", [square_pocket, curved])
def test_any_way_to_a_moment_gives_the_same_bytes(program, tool, monkeypatch) -> None:
    toolpath, far = made(program(), tool)
    monkeypatch.setattr(module, "WORK_CELLS", 3000)
    near = Timeline(toolpath, far.ends_s, tool, STOCK, CELL_MM)
    assert len(far.parts) == 1 < len(near.parts)
    times_s = np.random.default_rng(7).uniform(0, far.duration_s, 25)
    first = [data(near.at(time_s)) for time_s in times_s]
    again = [data(near.at(time_s)) for time_s in times_s[::-1]][::-1]
    assert first == again == [data(far.at(time_s)) for time_s in times_s]


def test_the_end_is_the_whole_program_and_the_begin_the_stock(near_check_points) -> None:
    toolpath, timeline = made(curved())
    assert data(timeline.at(timeline.duration_s)) == data(height_map(toolpath, FLAT, STOCK, CELL_MM))
    assert data(timeline.at(0.0)) == data(HeightMap(STOCK, CELL_MM))
    assert timeline.at(1e9).removed_volume_mm3 == timeline.after_row(len(toolpath)).removed_volume_mm3


def test_after_each_row_the_part_is_that_of_the_shorter_program(near_check_points) -> None:
    program = begun()
    shorter = []
    for x, y, z in ((0, 0, -1), (9, 2, -1), (12, -4, -3), (12, -4, 2), (-8, -8, 2), (-8, -8, -2), (3, -9, -2)):
        program.feed(x, y, z)
        shorter.append(data(height_map(program.toolpath(), FLAT, STOCK, CELL_MM)))
    toolpath, timeline = made(program)
    first = len(toolpath) - len(shorter)
    assert [data(timeline.after_row(first + k)) for k in range(len(shorter))] == shorter
    assert [data(timeline.at(timeline.ends_s[first + k])) for k in range(len(shorter))] == shorter


def test_more_and_more_is_removed() -> None:
    _, timeline = made(curved())
    volumes = [timeline.at(t).removed_volume_mm3 for t in np.linspace(0, timeline.duration_s, 60)]
    assert (np.diff(volumes) >= 0).all() and (np.diff(volumes) > 0).sum() > 30


def test_half_of_a_line_is_half_of_its_cut() -> None:
    _, timeline = made(begun().feed(0, 0, -2).feed(20, 0, -2))
    before, middle_s = timeline.ends_s[-2], timeline.ends_s[-2:].mean()
    assert timeline.at(middle_s).removed_volume_mm3 - timeline.at(before).removed_volume_mm3 == pytest.approx(
        2 * 6 * 10, rel=2e-3
    )
    assert timeline.moment(middle_s).share == pytest.approx(0.5)


def test_steps_by_move_and_by_line() -> None:
    program = begun().feed(0, 0, -1).feed(4, 0, -1).feed(8, 0, -1)
    _, timeline = made(program)
    timeline.lines = np.array([1, 2, 3, 4, 4])
    ends_s = timeline.ends_s.tolist()
    assert timeline.next_row(ends_s[1]) == ends_s[2]
    assert timeline.next_row(ends_s[2] + 0.01, by_line=True) == ends_s[4]
    assert timeline.row_before(ends_s[4]) == ends_s[3]
    assert timeline.row_before(ends_s[4], by_line=True) == ends_s[2]
    assert (timeline.row_before(0.0), timeline.next_row(1e9)) == (0.0, ends_s[4])
    assert timeline.moment(ends_s[4]).line == 4 and timeline.moment(0.0).row == -1


def test_steps_by_pulse_need_a_machine_and_are_its_planners() -> None:
    toolpath, blind = made(begun().feed(0, 0, -1).feed(0.5, 0, -1))
    with pytest.raises(JobError, match="machine"):
        blind.next_pulse(0.0)
    machine = load_machine("table-a")
    known = plan.begun(toolpath)
    timeline = Timeline(toolpath, plan.times_s(known, machine), FLAT, STOCK, CELL_MM, machine)
    wanted = [float(time_s) for pulses_s, _ in plan.step_events(known, machine) for time_s in pulses_s]
    middle_s = (wanted[-3] + wanted[-2]) / 2
    assert timeline.next_pulse(middle_s).time_s == wanted[-2] and timeline.pulse_before(middle_s).time_s == wanted[-3]
    assert timeline.next_pulse(timeline.duration_s) is None and timeline.pulse_before(0.0) is None


def test_where_memory_is_short_check_points_are_given_up(monkeypatch, near_check_points) -> None:
    toolpath, many = made(square_pocket())
    monkeypatch.setattr(module, "MOST_BYTES", many.bytes_held // 3)
    few = Timeline(toolpath, many.ends_s, FLAT, STOCK, CELL_MM)
    assert few.bytes_held <= many.bytes_held // 3 and 1 < len(few.parts) < len(many.parts)
    assert data(few.at(many.duration_s * 0.7)) == data(many.at(many.duration_s * 0.7))


def test_tiles_tell_what_differs_between_two_moments(near_check_points) -> None:
    toolpath, coarse = made(square_pocket())
    timeline = Timeline(toolpath, coarse.ends_s, FLAT, STOCK, CELL_MM / 5)
    one, other = (timeline.at(timeline.duration_s * share) for share in (0.5, 0.55))
    changed = other.part.changed_since(one.part)
    assert changed == one.part.changed_since(other.part) and changed < other.part.tiles.keys()
    differs = one.heights_mm != other.heights_mm
    seen = {number for number in other.part.tiles if differs[other.part.grid.window(number)].any()}
    assert seen and seen <= changed


def test_a_tile_keeps_only_the_means_that_are_not_its_heights() -> None:
    rng = np.random.default_rng(2)
    heights = rng.uniform(-9, 0, (30, 40)).astype(np.float32)
    means = np.maximum(heights, np.float32(-6))
    rim = rng.random(means.shape) < 0.1
    means[rim] += np.float32(0.25)
    tile = Tile.of(heights, means, -6.0)
    assert (tile.means == means).all() and tile.means.dtype == np.float32
    assert tile.nbytes == heights.nbytes + 6 * rim.sum()
