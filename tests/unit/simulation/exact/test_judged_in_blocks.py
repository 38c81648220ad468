# SPDX-License-Identifier: LGPL-2.1-or-later
"""A path that is judged block by block from the disk has the judgement of the whole path at once."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.cycle import Removal
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.exact import (
    cutting_path,
    gouge,
    remaining_material,
    segment_blocks,
    stored_cuts,
    voronoi_corners,
)
from CNCStepper.simulation.exact.segment_blocks import Blocks
from CNCStepper.simulation.exact.stored_cuts import StoredCuts
from CNCStepper.simulation.exact.swept_area import Judgement, judge
from CNCStepper.simulation.stock import HeightField, Stock
from CNCStepper.simulation.tip_segments import Segments
from helpers.simulation.programs import Program, begun

SEEDS = range(1, 1 + max(4, int(os.environ.get("CNCSTEPPER_CASES", "0")) // 8))
SMALL = 40  # segments a block
TOOLS = {
    1: Tool(number=1, shape="flat", diameter_mm=6),
    2: Tool(number=2, shape="ball", diameter_mm=4),
    3: Tool(number=3, shape="v", diameter_mm=6, tip_angle_deg=60),
}
STOCK = Stock((60, 50, 20))


@dataclass(frozen=True)
class Case:
    """A random program with the removals that it was to cut, or nearly, and the stock."""

    program: Program
    removals: list[Removal]
    stock: Stock


def raster(program: Program, box: tuple[float, ...], z_mm: float, step_mm: float, draw: np.random.Generator) -> None:
    """Clear a box in short moves; some rows are left out, some are cut twice, so that islands stand and rows tie."""
    low_x, low_y, high_x, high_y = box
    program.rapid(low_x, low_y, 5).feed(low_x, low_y, z_mm)
    for row, y in enumerate(np.arange(low_y, high_y + 1e-9, step_mm)):
        if draw.random() < 0.15:
            continue
        xs = np.linspace(low_x, high_x, int(draw.integers(2, 30)))
        for x in xs if row % 2 == 0 else xs[::-1]:
            program.feed(float(x), float(y), z_mm)
    program.rapid(high_x, high_y, 5)


def case(seed: int) -> Case:
    draw = np.random.default_rng(seed)
    program, removals = begun(), []
    for _ in range(int(draw.integers(2, 4))):
        tool = TOOLS[1 + int(draw.integers(len(TOOLS)))]
        program.set(tool=tool.number)
        x, y = draw.uniform(-20, 5), draw.uniform(-18, 3)
        box = (x, y, x + draw.uniform(8, 20), y + draw.uniform(6, 15))
        depths = -np.sort(draw.uniform(0.5, 6, int(draw.integers(1, 4))))
        for z_mm in depths:
            raster(program, box, float(z_mm), draw.uniform(0.4, 1.1) * tool.diameter_mm, draw)
        grown = shapely.box(*box).buffer(tool.diameter_mm / 2 + draw.choice([-0.3, 0.0, 0.4]))
        if draw.random() < 0.5:
            grown = grown.difference(shapely.Point(x + 5, y + 4).buffer(2.0))  # a boss that the raster gouges
        removals.append(Removal(grown, 0.0, float(depths[-1]), tolerance_mm=0.01))
    if draw.random() < 0.5:
        line = shapely.LineString([(-25, 20), (-5, 22), (20, 19)])
        removals.append(Removal(line, 0.0, -0.4, tolerance_mm=0.01))
        program.set(tool=3).rapid(-25, 20, 5).feed(-25, 20, -0.4)
        for share in np.linspace(0, 1, 40):
            place = line.interpolate(share, normalized=True)
            program.feed(place.x, place.y + draw.choice([0.0, 0.02]), -0.4)
        program.rapid(20, 19, 5)
    for step in range(30):  # a ramp in short parts
        program.feed(-10 + step * 0.3, -5, 0.5 - step * 0.1)
    program.rapid(0, 0, 9)
    heights = 18 + 2 * draw.random((6, 7))
    stock = HeightField((60, 50, float(heights.max())), heights_mm=heights) if seed % 3 == 0 else STOCK
    return Case(program, removals, stock)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> Iterator[Counter[str]]:
    """Let every block be small, and count what is split."""
    seen: Counter[str] = Counter()
    monkeypatch.setattr(stored_cuts, "BLOCK", SMALL)
    monkeypatch.setattr(segment_blocks, "MOST_HELD", 2 * SMALL)
    monkeypatch.setattr(remaining_material, "MOST_HELD", 10 * SMALL)
    monkeypatch.setattr(remaining_material, "RUN_POINTS", 7)
    monkeypatch.setattr(remaining_material, "MOST_AREAS", 3)
    monkeypatch.setattr(voronoi_corners, "MOST_POINTS", 600)
    monkeypatch.setattr(gouge, "MOST_PARTS", 60)
    corners, begin_of_open_run, behind = (
        voronoi_corners._corners,
        remaining_material._begin_of_open_run,
        gouge.Ranked.behind,
    )

    def counted(*words):
        seen["halved"] += 1
        return corners(*words)

    def open_run(pieces: Segments) -> int:
        begin = begin_of_open_run(pieces)
        seen["chain over a border"] += begin < len(pieces)
        return begin

    monkeypatch.setattr(voronoi_corners, "_corners", counted)
    monkeypatch.setattr(remaining_material, "_begin_of_open_run", open_run)
    monkeypatch.setattr(gouge.Ranked, "behind", lambda self: seen.update(behind=1) or behind(self))
    yield seen


def in_blocks(one: Case) -> Judgement:
    """Return the judgement of the path as parts of a few rows have laid it on the disk."""
    judged = cutting_path.JudgedPath(TOOLS, one.stock)
    judged.see(one.program.toolpath())
    verdict = judged.judged(one.removals)
    judged.close()
    return verdict


def places(worst: gouge.Worst) -> list[float]:
    return [worst.depth_mm, *(worst.place_mm or ())]


def sorted_islands(verdict: Judgement) -> np.ndarray:
    """Return the islands by place: some are as thick as others, but for the last digit."""
    found = [[*island.place_mm, island.thickness_mm] for island in verdict.islands]
    return np.array(sorted(found, key=lambda row: np.round(row, 4).tolist())).reshape(-1, 4)


def assert_same(whole: Judgement, parts: Judgement) -> None:
    for one, other in zip(
        [whole.gouge, whole.left_over, *(left.worst for left in whole.removals)],
        [parts.gouge, parts.left_over, *(left.worst for left in parts.removals)],
        strict=True,
    ):
        assert places(other) == pytest.approx(places(one), abs=1e-6)
        assert other.row == one.row
    assert parts.gouge_tolerance_mm == whole.gouge_tolerance_mm
    islands, own = (sorted_islands(one) for one in (whole, parts))
    assert len(own) == len(islands) and np.abs(own - islands).max(initial=0.0) < 1e-6
    levels = [[(level.z_mm, level.path_mm, level.gouge_at_most_mm) for level in one.levels] for one in (whole, parts)]
    assert np.array(levels[1]) == pytest.approx(np.array(levels[0]), abs=1e-6)


@pytest.mark.slow
def test_blocks_from_the_disk_are_judged_as_the_whole_path(small: Counter[str], monkeypatch) -> None:
    met: Counter[str] = Counter()
    for seed in SEEDS:
        one = case(seed)
        with monkeypatch.context() as large:
            large.setattr(voronoi_corners, "MOST_POINTS", 30_000)
            large.setattr(segment_blocks, "MOST_HELD", 1_000_000)
            large.setattr(remaining_material, "MOST_HELD", 1_000_000)
            whole = judge(one.program.toolpath(), TOOLS, one.removals, one.stock)
        parts = in_blocks(one)
        print(f"seed {seed}: gouge {whole.gouge_mm:.4f}, left {whole.left_over_mm:.4f}, {len(whole.islands)} islands")
        assert_same(whole, parts)
        met["gouges"] += whole.gouge_mm > 0.05
        met["islands"] += len(whole.islands) > 0
        met["levels"] += len(whole.levels) > 2
        met["tools"] += len(np.unique([state.tool for state in one.program.toolpath().states])) > 1
        met["lines"] += any(removal.region.area == 0 for removal in one.removals)
    assert min(met[name] for name in ("gouges", "islands", "levels", "tools", "lines")) >= 2, met
    assert small["halved"] > 100 and small["chain over a border"] > 100, small


def test_blocks_of_every_length_have_the_same_runs() -> None:
    draw = np.random.default_rng(5)
    points = np.cumsum(draw.uniform(-1, 1, (2000, 3)), axis=0)
    broken = draw.random(1999) < 0.002
    pieces = Segments(points[:-1] + 1e-3 * broken[:, None], points[1:], np.arange(1999))
    (whole,) = remaining_material._runs(Blocks([pieces]))
    assert max(map(len, whole)) == remaining_material.RUN_POINTS and len(whole) > 5
    for length in (1, 7, 398, 399, 400, 401, 1000):
        blocks = Blocks([pieces[first : first + length] for first in range(0, 1999, length)])
        parts = [run for runs in remaining_material._runs(blocks) for run in runs]
        assert len(parts) == len(whole) and all(map(np.array_equal, parts, whole)), length


@pytest.mark.parametrize("most", [64, 192])
def test_gouges_beyond_those_that_are_ranked_at_once(monkeypatch: pytest.MonkeyPatch, most: int) -> None:
    """Two removals that nearly touch: each move along the seam may enter the sliver between them, which is nothing."""
    halves = [Removal(shapely.box(-20, low, 20, high), 0, -4) for low, high in ((-15, 0), (0.0003, 15))]
    program = begun().rapid(-17, 0, 5).feed(-17, 0, -4)
    for x in np.linspace(-17, 17, 600):
        program.feed(float(x), 0, -4)
    program.feed(17.4, 0, -4).rapid(17.4, 0, 5)
    whole = judge(program.toolpath(), TOOLS, halves, STOCK)
    monkeypatch.setattr(gouge, "MOST_RANKED", most)
    monkeypatch.setattr(stored_cuts, "BLOCK", SMALL)
    pages: list[int] = []
    behind = gouge.Ranked.behind

    def counted(self: gouge.Ranked) -> gouge.Ranked | None:
        pages.append(self._seen)
        return behind(self)

    monkeypatch.setattr(gouge.Ranked, "behind", counted)
    parts = in_blocks(Case(program, halves, STOCK))
    assert pages
    assert parts.gouge_mm == pytest.approx(whole.gouge_mm, abs=1e-6) and parts.gouge_mm == pytest.approx(0.4, abs=0.001)
    assert parts.gouge.row == whole.gouge.row


def test_parts_of_a_path_are_read_as_blocks_of_each_cutter(monkeypatch: pytest.MonkeyPatch) -> None:
    program = case(3).program
    monkeypatch.setattr(stored_cuts, "BLOCK", 40)
    kept = StoredCuts()
    (path,) = [cutting_path.cutting_path(program.toolpath(), TOOLS, 0.0, STOCK)]
    for first in range(0, max(len(pieces) for _, pieces in path), 9):  # blocks of the cutters by turns
        kept.add([(cutter, pieces[first : first + 9]) for cutter, pieces in path])
    for (cutter, pieces), (same, blocks) in zip(path, kept.by_cutter(), strict=True):
        found = list(blocks)
        assert same == cutter and [len(one) for one in found[:-1]] == [36] * (len(found) - 1)
        assert np.array_equal(segment_blocks.joined(found).end, pieces.end)
    kept.close()


def test_the_corners_of_few_points_at_once_are_those_of_all(monkeypatch: pytest.MonkeyPatch) -> None:
    """Points on a lattice, where many lie on one circle, and a wide hole among them."""
    x, y = np.meshgrid(np.arange(0, 30, 0.25), np.arange(0, 20, 0.4))
    points = np.column_stack([x.ravel(), y.ravel()])
    points = points[np.hypot(*(points - (12, 9)).T) > 5]
    area = shapely.union_all([shapely.Point(12, 9).buffer(4.9), shapely.box(20, 2, 29.9, 2.5), shapely.box(1, 1, 3, 6)])
    everything = voronoi_corners.voronoi_corners(points)
    everything = everything[shapely.contains_xy(area, everything)]
    monkeypatch.setattr(voronoi_corners, "MOST_POINTS", 500)
    some = voronoi_corners.Places()
    some.add(points)
    assert not some.are_few and sum(map(len, some)) == len(points)
    near = segment_blocks.EdgeTree(np.stack([points, points], axis=1))
    found = voronoi_corners.corners_within(area, some, near.distance)
    one, other = (np.unique(np.round(corners, 5), axis=0) for corners in (everything, found))
    assert len(one) > 200
    assert shapely.hausdorff_distance(shapely.multipoints(one), shapely.multipoints(other)) < 1e-4
