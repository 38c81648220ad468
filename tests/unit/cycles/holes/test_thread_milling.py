# SPDX-License-Identifier: LGPL-2.1-or-later
"""Thread milling: hand, side and sense, judged by what the tool's disc sweeps."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.cycles.cycle import Cycle
from CNCStepper.cycles.holes.drill import Drill
from CNCStepper.cycles.holes.hole_patterns import placed
from CNCStepper.cycles.holes.thread_milling import Thread
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import circle
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.toolpath import ARC_CCW, ARC_CW, Toolpath
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, gouge_mm, left_mm, swept

POINTS = {"kind": "points", "points_mm": [(0, 0), (60, 5)]}
ONE = {"kind": "points", "points_mm": [(0, 0)]}
METRIC = [(3.0, 0.5), (6.0, 1.0), (10.0, 1.5), (20.0, 2.5), (36.0, 4.0)]


def random_thread(seed: int) -> tuple[Thread, Tool]:
    random = Random(seed)
    major_mm, pitch_mm = random.choice(METRIC)
    operation = Thread(
        tool=1,
        pattern={"kind": "points", "points_mm": [(1.5, -2.25), (90, 3)][: random.randint(1, 2)]},
        major_diameter_mm=major_mm,
        pitch_mm=pitch_mm,
        depth_mm=pitch_mm * random.uniform(1.5, 4.0),
        side=random.choice(["inside", "outside"]),
        hand=random.choice(["right", "left"]),
        passes=random.randint(1, 3),
        direction=random.choice(["climb", "conventional"]),
    )
    share = random.choice([0.1, 0.3, 0.6, 0.9, 1.0])
    if operation.side == "outside":
        return operation, tool(random.choice([1.0, 4.0, 10.0]))
    return operation, tool(round(share * (major_mm - 1.0825 * pitch_mm), 3))


def helix_hand(path: Toolpath) -> tuple[str, bool]:
    """Return the hand of the first full turn and whether it goes up."""
    table, begins = path.table(), path.begins()
    arcs = np.isin(table.kind, (ARC_CW, ARC_CCW)) & (np.abs(table.end - begins)[:, 2] > 1e-6)
    row = int(np.flatnonzero(arcs)[0])
    up = table.end[row, 2] > begins[row, 2]
    return ("right" if up == (table.kind[row] == ARC_CCW) else "left"), bool(up)


def made_ready(
    operation: Thread, cutter: Tool, room_mm: float = 1.0, depth_mm: float = 0.0
) -> list[tuple[Cycle, Tool]]:
    """Return what must come before: the holes drilled, or a ring of the tool's width and `room_mm` cut round bosses."""
    holes, _ = placed(operation.pattern, "given")
    depth_mm = depth_mm or operation.depth_mm
    if operation.inside:
        minor_mm = operation.major_diameter_mm - 1.0825 * operation.pitch_mm
        return [(Drill(tool=2, pattern=operation.pattern, depth_mm=depth_mm), tool(minor_mm, number=2))]
    bosses = tuple(circle(hole[:2], operation.major_diameter_mm / 2) for hole in holes)
    round_them = Contour(tool=2, curves=bosses, side="outside", depth_mm=depth_mm, stepdown_mm=depth_mm)
    return [(round_them, tool(cutter.diameter_mm + room_mm, number=2))]


def ring(place: tuple[float, float], inner_mm: float, outer_mm: float):
    point = shapely.Point(place)
    return point.buffer(outer_mm, 300).difference(point.buffer(max(inner_mm, 0.0), 300))


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_thread_is_cut_to_its_depth(seed):
    operation, cutter = random_thread(seed)
    minor_mm = operation.major_diameter_mm - (1.0825 if operation.side == "inside" else 1.2269) * operation.pitch_mm
    if operation.side == "inside" and cutter.diameter_mm > minor_mm - 0.02:
        with pytest.raises(CycleError, match="tool-wide"):
            cut(operation, cutter)
        return
    found = judged(operation, cutter, before=made_ready(operation, cutter))
    assert found.clean, found.faults
    assert found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    path, _ = cut(operation, cutter)
    assert helix_hand(path)[0] == operation.hand
    holes, _ = placed(operation.pattern, "given")
    r, radius = cutter.radius_mm, operation.major_diameter_mm / 2
    path_mm = radius - r if operation.side == "inside" else minor_mm / 2 + r
    cut_out = shapely.union_all([ring(hole[:2], path_mm - r, path_mm + r) for hole in holes])
    full_mm = -operation.depth_mm + operation.pitch_mm
    assert left_mm(cut_out, swept(path, r, full_mm)) <= 0.01
    kept = 0.0 if operation.side == "inside" else minor_mm / 2
    far = radius if operation.side == "inside" else radius + 2 * r + 0.5
    allowed = shapely.union_all([ring(hole[:2], kept, far) for hole in holes])
    assert gouge_mm(path, r, [Wanted(allowed, -operation.depth_mm)]) <= 0.01


@pytest.mark.slow
@pytest.mark.parametrize(("side", "gouge"), [("inside", 2.5), ("outside", 2.5)])
def test_a_thread_where_nothing_was_made_ready_is_a_gouge(side, gouge):
    operation = Thread(tool=1, pattern=ONE, major_diameter_mm=10, pitch_mm=1.5, depth_mm=6, side=side)
    found = judged(operation, tool(5))
    assert not found.clean and found.gouge_mm >= gouge
    shallow = judged(operation, tool(5), before=made_ready(operation, tool(5), depth_mm=3))
    assert not shallow.clean and shallow.gouge_mm > 1.0


@pytest.mark.slow
def test_the_way_to_a_boss_stays_beside_it_and_what_it_cuts_of_the_surroundings_is_a_gouge():
    operation = Thread(tool=1, pattern=ONE, major_diameter_mm=10, pitch_mm=1.5, depth_mm=6, side="outside")
    enough = judged(operation, tool(5), before=made_ready(operation, tool(5), room_mm=0.51))
    assert enough.clean and enough.gouge_mm <= 0.01
    narrow = judged(operation, tool(5), before=made_ready(operation, tool(5), room_mm=0.1))
    assert not narrow.clean and 0.3 < narrow.gouge_mm <= 0.41


def test_a_thread_may_cut_its_ring_only_and_reaches_little_beyond():
    for side, minor_mm in (("inside", 10 - 1.0825 * 1.5), ("outside", 10 - 1.2269 * 1.5)):
        operation = Thread(tool=1, pattern=ONE, major_diameter_mm=10, pitch_mm=1.5, depth_mm=6, side=side, passes=2)
        path, answer = cut(operation, tool(5))
        for removal in answer.removals:
            area_mm2 = math.pi / 4 * (10**2 - minor_mm**2)
            assert removal.region.area == pytest.approx(area_mm2, abs=0.1)
        far_mm = np.hypot(*path.table().end[1:, :2].T).max() + 2.5
        assert far_mm == pytest.approx(5.0 if side == "inside" else 5.0 + 5.0 + 0.5)


@pytest.mark.parametrize(
    ("side", "hand", "up"),
    [("inside", "right", True), ("inside", "left", False), ("outside", "right", False), ("outside", "left", True)],
)
def test_climb_milling_decides_where_the_helix_begins(side, hand, up):
    operation = Thread(tool=1, pattern=POINTS, major_diameter_mm=10, pitch_mm=1.5, depth_mm=6, side=side, hand=hand)
    assert helix_hand(cut(operation, tool(5))[0]) == (hand, up)
    against = operation.model_copy(update={"direction": "conventional"})
    assert helix_hand(cut(against, tool(5))[0]) == (hand, not up)


def test_each_turn_rises_by_the_pitch_and_the_ways_in_touch_it():
    operation = Thread(tool=1, pattern=POINTS, major_diameter_mm=10, pitch_mm=1.5, depth_mm=6)
    path, answer = cut(operation, tool(5))
    table, begins = path.table(), path.begins()
    rise = (table.end - begins)[:, 2][np.isin(table.kind, (ARC_CW, ARC_CCW))]
    assert sorted(set(np.round(rise, 9))) == [0.0, 1.5]
    assert answer.figures == {"holes": 2, "passes": 1, "turns": 4, "minor_mm": 10 - 1.0825 * 1.5}
    lead = int(np.flatnonzero(table.kind == ARC_CCW)[0])
    assert math.dist(table.centre[lead, :2], (0, 0)) == pytest.approx(1.25)


@pytest.mark.parametrize("side", ["inside", "outside"])
@pytest.mark.parametrize("passes", [2, 100])
def test_every_arc_begins_as_far_from_its_centre_as_it_ends(side, passes):
    operation = Thread(tool=1, pattern=POINTS, major_diameter_mm=10, pitch_mm=0.5, depth_mm=1, side=side, passes=passes)
    path, _ = cut(operation, tool(3))
    table, begins = path.table(), path.begins()
    arcs = np.isin(table.kind, (ARC_CW, ARC_CCW))
    there, back = ((points - table.centre)[arcs, :2] for points in (begins, table.end))
    assert arcs.sum() == 2 * passes * 4
    np.testing.assert_allclose(np.hypot(*there.T), np.hypot(*back.T), rtol=0, atol=2e-9)


@pytest.mark.slow
def test_an_engraver_stands_for_a_mill_with_a_pointed_tooth():
    operation = Thread(tool=1, pattern=POINTS, major_diameter_mm=20, pitch_mm=2, depth_mm=5)
    cutter = tool(8, shape="engraver", tip_angle_deg=60, tip_diameter_mm=7)
    found = judged(operation, cutter, before=made_ready(operation, cutter))
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01


def test_a_job_in_inches_cuts_the_same():
    operation = Thread(tool=1, pattern=POINTS, major_diameter_mm=10, pitch_mm=1.5, depth_mm=6, passes=2)
    found = judged(operation, tool(5), units="inch", before=made_ready(operation, tool(5)))
    assert found.lines[0].startswith("G20")
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01


@pytest.mark.parametrize(
    ("code", "changes", "cutter"),
    [
        ("tool-wide", {}, tool(8.5)),
        ("tool-shape", {}, tool(4, shape="drill")),
        ("tooth-high", {}, tool(4, shape="v", tip_angle_deg=60)),
        ("tooth-high", {}, tool(4, shape="engraver", tip_angle_deg=60, tip_diameter_mm=2)),
        ("thread-depth", {"minor_diameter_mm": 10}, tool(4)),
        ("thread-depth", {"pitch_mm": 12}, tool(4)),
        ("diameter-missing", {"major_diameter_mm": 0}, tool(4)),
        ("blocks-many", {"pitch_mm": 0.001, "depth_mm": 5000}, tool(4)),
    ],
)
def test_what_cannot_be_threaded_is_refused_before_any_row(code, changes, cutter):
    content = {"tool": 1, "pattern": POINTS, "major_diameter_mm": 10, "pitch_mm": 1.5, "depth_mm": 6}
    with pytest.raises(CycleError) as caught:
        cut(Thread(**(content | changes)), cutter)
    assert caught.value.code == code
