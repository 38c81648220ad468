# SPDX-License-Identifier: LGPL-2.1-or-later
"""Common lines of random parts a kerf apart: each part comes free with its own size, and nothing is cut twice.

The parts are what random straight lines leave of a rectangle, some of them taken out; shapely judges the cuts.
"""

from __future__ import annotations

import itertools
import math
import random

import numpy as np
import pytest
import shapely
import shapely.ops
from shapely import LineString, Polygon, affinity
from shapely.geometry.polygon import orient

from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.nesting.common_lines import CRUMB, CommonCuts, common_cuts
from CNCStepper.nesting.edge_snapping import edge_to_edge
from CNCStepper.nesting.nesting_model import Budget, Item, Placement, Sheet, Spacing, placed
from CNCStepper.nesting.sheet_filling import Room, Shapes
from CNCStepper.tolerances import COMMON_LINE_MM
from helpers.cycles.seeds import SEEDS

SHEET = shapely.box(-100.0, -100.0, 300.0, 300.0)
NEAR_MM = 2.0 * COMMON_LINE_MM


def random_parts(seed: int) -> tuple[list[Polygon], float]:
    """Return rectangles, trapezoids and other convex parts, exactly a kerf from their neighbours, and the kerf."""
    chance = random.Random(seed)
    kerf_mm = chance.choice([0.2, 0.5, 1.5])
    pieces = [shapely.box(0.0, 0.0, 120.0, 80.0)]
    while len(pieces) < chance.choice([4, 8, 14]):
        largest = pieces.pop(max(range(len(pieces)), key=lambda number: pieces[number].area))
        pieces += split(largest, chance)
    kept = chance.sample(pieces, max(3, round(len(pieces) * chance.choice([1.0, 0.8]))))
    parts = [piece.buffer(-kerf_mm / 2.0, join_style="mitre", mitre_limit=50.0) for piece in kept]
    angle = chance.choice([0.0, 0.0, 37.0])
    return [affinity.rotate(part, angle, origin=(0.0, 0.0)) for part in parts if part.area > 20.0], kerf_mm


def split(piece: Polygon, chance: random.Random) -> list[Polygon]:
    """Return the two pieces into which a level, upright or slanting line divides one."""
    left, low, right, high = piece.bounds
    way = 0.0 if high - low > right - left else 90.0
    way += chance.choice([0.0, 0.0, 0.0, 12.0, -20.0])
    x, y = piece.centroid.x + chance.uniform(-4.0, 4.0), piece.centroid.y + chance.uniform(-4.0, 4.0)
    reach = 300.0 * np.array([math.cos(math.radians(way)), math.sin(math.radians(way))])
    line = LineString([np.array([x, y]) - reach, np.array([x, y]) + reach])
    return [part for part in shapely.get_parts(shapely.ops.split(piece, line)) if isinstance(part, Polygon)]


def curve_of(polygon: Polygon) -> Curve:
    return from_points(np.asarray(orient(polygon).exterior.coords)[:-1], closed=True)


def cuts_of(parts: list[Polygon], kerf_mm: float) -> CommonCuts:
    return common_cuts([curve_of(part) for part in parts], parts, [0] * len(parts), SHEET, kerf_mm)


def paths_of(parts: list[Polygon], cuts: CommonCuts, kerf_mm: float) -> list[LineString]:
    """Return where the middle of the beam runs: outside of outlines, inside of holes, on lines."""
    half_mm = kerf_mm / 2.0
    paths = [part.buffer(half_mm).exterior for number, part in enumerate(parts) if number not in cuts.parts]
    for block in cuts.blocks:
        outer, *holes = [Polygon(loop.points(0.001)) for loop in block.loops]
        paths += [outer.buffer(half_mm).exterior, *(hole.buffer(-half_mm).exterior for hole in holes)]
        paths += [LineString(line.points(0.001)) for line in block.lines]
    return [LineString(path.coords) for path in paths]


@pytest.mark.parametrize("seed", SEEDS)
def test_parts_come_free_in_their_size_and_nothing_is_cut_twice(seed: int) -> None:
    parts, kerf_mm = random_parts(seed)
    cuts = cuts_of(parts, kerf_mm)
    assert cuts.left == 0 and cuts.blocks and cuts.saved_mm > 0.0
    paths = paths_of(parts, cuts, kerf_mm)
    assert min(path.distance(part) for path in paths for part in parts) >= kerf_mm / 2.0 - NEAR_MM
    band = shapely.union_all([path.buffer((0.5 + CRUMB) * kerf_mm + NEAR_MM) for path in paths])
    assert all(band.covers(part.exterior) for part in parts), "each part's contour is cut"
    pieces = list(shapely.get_parts(SHEET.difference(band)))
    for part in parts:
        own = next(piece for piece in pieces if piece.covers(part.representative_point()))
        assert part.buffer(NEAR_MM).covers(own), "the part hangs on to nothing"
    for one, other in itertools.combinations(paths, 2):
        assert one.intersection(other.buffer(0.05 * kerf_mm)).length < kerf_mm, "no line runs along another one"


def test_a_common_line_lies_in_the_middle_of_the_kerf() -> None:
    parts = [shapely.box(0, 0, 30, 20), shapely.box(30.4, 0, 60, 20)]
    cuts = cuts_of(parts, 0.4)
    (block,) = cuts.blocks
    (line,) = block.lines
    assert line.xy[:, 0] == pytest.approx([30.2, 30.2]) and sorted(line.xy[:, 1]) == pytest.approx([-3.2, 23.2])
    assert block.loops[0].area_mm2 == pytest.approx(60.0 * 20.0)
    assert cuts.saved_mm == pytest.approx(100.0 + 99.2 - 160.0 - 26.4)


def test_a_grid_is_cut_by_straight_lines_and_its_rim() -> None:
    parts = [shapely.box(20.5 * x, 10.5 * y, 20.5 * x + 20, 10.5 * y + 10) for x in range(4) for y in range(3)]
    (block,) = cuts_of(parts, 0.5).blocks
    assert (len(block.loops), len(block.lines)) == (1, 5)
    assert cuts_of(parts, 0.5).saved_pierces == 6


def test_edges_that_are_no_kerf_apart_and_parts_of_other_layers_share_nothing() -> None:
    parts = [shapely.box(0, 0, 30, 20), shapely.box(30.41, 0, 60, 20)]
    assert not cuts_of(parts, 0.4).blocks
    near = [parts[0], shapely.box(30.4, 0, 60, 20)]
    assert not common_cuts([curve_of(part) for part in near], near, ["CUT", "THIN"], SHEET, 0.4).blocks
    discs = [shapely.Point(0, 0).buffer(5.0), shapely.Point(10.4, 0).buffer(5.0)]
    assert not common_cuts([circle((0, 0), 5.0), circle((10.4, 0), 5.0)], discs, [0, 0], SHEET, 0.4).blocks


def test_a_part_in_a_gap_of_a_block_keeps_its_outline() -> None:
    frame = [shapely.box(0, 0, 60, 10), shapely.box(0, 50.6, 60, 60), shapely.box(0, 10.3, 9, 50.3),
             shapely.box(51, 10.3, 60, 50.3)]  # fmt: skip
    guest = shapely.box(20, 20, 40, 40)
    cuts = cuts_of([*frame, guest], 0.3)
    (block,) = cuts.blocks
    assert block.parts == (0, 1, 2, 3) and len(block.loops) == 2
    assert Polygon(block.loops[1].xy).covers(guest)


def test_parts_that_lie_a_little_apart_are_moved_edge_to_edge() -> None:
    trapezoid = Polygon([(0, 0), (30, 0), (22, 20), (8, 20)])
    items = [Item("t", trapezoid, trapezoid, 2, (0.0, 180.0)), Item("r", box := shapely.box(0, 0, 20, 20), box)]
    sheet = Sheet("plate", shapely.box(0, 0, 100, 60))
    places = [Placement(0, 0, 5.0, 5.0, 0.0), Placement(0, 0, 58.0, 25.0, 180.0), Placement(0, 1, 8.0, 26.5, 0.0)]
    shapes = Shapes(items, Spacing(0.4, 2.0))
    moved = edge_to_edge(Room(0, sheet, Spacing(0.4, 2.0)), shapes, places, Budget(10.0))
    parts = [placed(items[each.item].exact, each) for each in moved]
    assert len(cuts_of(parts, 0.4).blocks[0].parts) == 3
    locked = [Item("t", trapezoid, trapezoid, 2, (0.0, 180.0), locked=tuple(places[:2])), items[1]]
    kept = edge_to_edge(Room(0, sheet, Spacing(0.4, 2.0)), Shapes(locked, Spacing(0.4, 2.0)), places, Budget(10.0))
    assert kept[:2] == places[:2]
