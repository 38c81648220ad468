# SPDX-License-Identifier: LGPL-2.1-or-later
"""Helical bores: random sizes judged by the product and by an independent sweep; no core, no ring, no gouge."""

from __future__ import annotations

import math
import tracemalloc
from random import Random

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.holes.bore import Bore
from CNCStepper.cycles.holes.hole_patterns import placed
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import circle
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.toolpath import ARC_CCW, ARC_CW, Toolpath
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, gouge_mm, left_mm, swept

POINTS = {"kind": "points", "points_mm": [(0, 0), (40, 5)]}


def random_bore(seed: int) -> tuple[Bore, Tool]:
    """Return a bore whose tool is 0.1 to 1.0 of its diameter wide."""
    random = Random(seed)
    diameter_mm = random.choice([2.0, 6.0, 11.0, 24.0])
    tool_mm = diameter_mm * random.choice([0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 0.95, 1.0])
    step = random.choice([0.0, 0.3, 0.5, 0.95, 1.2 if random.random() < 0.3 else 0.6])
    operation = Bore(
        tool=1,
        pattern={"kind": "line", "start_mm": (3.3, -7), "end_mm": (30, 20), "count": random.randint(1, 2)},
        diameter_mm=diameter_mm,
        depth_mm=random.uniform(0.5, 5.0),
        through_mm=random.choice([0.0, 0.5]),
        pitch_mm=random.choice([0.7, 2.0]),
        stepover_mm=step * tool_mm,
        finish_stepover_mm=random.choice([0.0, 0.1, 0.3]) * tool_mm,
        direction=random.choice(["climb", "conventional"]),
    )
    return operation, tool(round(tool_mm, 3))


def refused(seed: int) -> bool:
    try:
        cut(*random_bore(seed))
    except CycleError:
        return True
    return False


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_bore_is_exact(seed):
    operation, cutter = random_bore(seed)
    if refused(seed):
        assert cutter.diameter_mm >= operation.diameter_mm / 1.05 - 1e-9 or operation.stepover_mm > cutter.diameter_mm
        return
    found = judged(operation, cutter)
    assert all("pitch_mm is lowered" in fault for fault in found.faults), found.faults
    assert found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    assert steepest_deg(cut(operation, cutter)[0]) <= 10.0 + 1e-9
    holes, _ = placed(operation.pattern, "given")
    discs = shapely.union_all([shapely.Point(hole[:2]).buffer(operation.diameter_mm / 2, 400) for hole in holes])
    floor_mm = -(operation.depth_mm + operation.through_mm)
    assert gouge_mm(found.toolpath, cutter.radius_mm, [Wanted(discs, floor_mm)]) <= 0.01
    assert left_mm(discs, swept(found.toolpath, cutter.radius_mm, floor_mm)) <= 0.01


def steepest_deg(path: Toolpath) -> float:
    """Return how steep the steepest turn falls."""
    table, begins = path.table(), path.begins()
    arcs = np.flatnonzero(np.isin(table.kind, (ARC_CW, ARC_CCW)))
    fall_mm = (begins - table.end)[arcs, 2]
    radius_mm = np.hypot(*(table.end - table.centre)[arcs, :2].T)
    return float(np.degrees(np.arctan2(fall_mm, 2.0 * math.pi * radius_mm)).max())


def test_a_helix_falls_no_more_than_the_tool_may_and_says_so():
    for cutter, limit_deg in ((tool(6), 10.0), (tool(6, ramp_max_deg=2), 2.0)):
        path, answer = cut(Bore(tool=1, pattern=POINTS, diameter_mm=8, depth_mm=9, pitch_mm=10), cutter)
        assert steepest_deg(path) <= limit_deg + 1e-9
        steepest_mm = 2.0 * math.pi * math.tan(math.radians(limit_deg))  # 1 mm from the middle
        assert answer.figures["pitch_mm"] == pytest.approx(11 / math.ceil(11 / steepest_mm))
        assert f"pitch_mm is lowered to {answer.figures['pitch_mm']:.3f} mm" in answer.warnings[0]
    _, answer = cut(Bore(tool=1, pattern=POINTS, diameter_mm=8, depth_mm=9, pitch_mm=1), tool(6))
    assert answer.figures["pitch_mm"] == 1.0 and not answer.warnings


def test_a_finish_leaves_the_roughing_helix_room():
    bore = Bore(tool=1, pattern=POINTS, diameter_mm=6.9, depth_mm=2, pitch_mm=1, finish_stepover_mm=0.4)
    assert cut(bore, tool(6))[1].figures["passes"] == 1


@pytest.mark.slow
def test_the_cases_are_fairly_spread():
    seeds = range(1, 201)
    shares = [cutter.diameter_mm / operation.diameter_mm for operation, cutter in map(random_bore, seeds)]
    assert sum(share <= 0.2 for share in shares) >= 20 and sum(share >= 0.9 for share in shares) >= 20
    assert sum(map(refused, seeds)) <= 60


def test_a_wide_bore_takes_helices_from_the_middle_out():
    found = judged(
        Bore(tool=1, pattern=POINTS, diameter_mm=14, depth_mm=2, pitch_mm=1, finish_stepover_mm=0.2), tool(4)
    )
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    names = [
        span.name
        for span in cut(Bore(tool=1, pattern=POINTS, diameter_mm=14, depth_mm=2, pitch_mm=1), tool(4))[0].spans
    ]
    assert names[:3] == ["helix 1", "helix 2", "helix 3"]
    assert found.answer.figures["passes"] == 4 and found.answer.figures["ap_mm"] == 1.0


def test_the_circles_of_a_drawing_bring_their_diameters():
    pattern = {"kind": "circles", "circles": [circle((0, 0), 5), circle((30, 0), 8)]}
    _, answer = cut(Bore(tool=1, pattern=pattern, depth_mm=3, pitch_mm=1), tool(6))
    areas = sorted(part.area for part in shapely.get_parts(answer.removals[0].region))
    assert areas == pytest.approx([78.54, 201.06], abs=0.02)


@pytest.mark.parametrize(("given_mm", "count"), [(12, 1), (0, 2)])
def test_two_rims_of_one_hole_are_one_bore_where_the_cycle_says_how_wide(given_mm, count):
    pattern = {"kind": "circles", "circles": [circle((0, 0), 5), circle((0, 0), 8)]}
    _, answer = cut(Bore(tool=1, pattern=pattern, diameter_mm=given_mm, depth_mm=3, pitch_mm=1), tool(6))
    assert answer.figures["holes"] == count and len(answer.warnings) == 2 - count


@pytest.mark.parametrize(("direction", "kind"), [("climb", ARC_CCW), ("conventional", ARC_CW)])
def test_climb_milling_turns_counter_clockwise_in_a_bore(direction, kind):
    operation = Bore(tool=1, pattern=POINTS, diameter_mm=14, depth_mm=2, pitch_mm=1, direction=direction)
    kinds = cut(operation, tool(4))[0].table().kind
    assert set(kinds[np.isin(kinds, (ARC_CW, ARC_CCW))]) == {kind}


def test_a_bore_with_too_many_helices_is_refused_before_they_are_listed():
    tracemalloc.start()
    try:
        with pytest.raises(CycleError, match="blocks-many"):
            cut(Bore(tool=1, pattern=POINTS, diameter_mm=14, depth_mm=2, pitch_mm=0.001, stepover_mm=0.001), tool(4))
        assert tracemalloc.get_traced_memory()[1] < 1e6
    finally:
        tracemalloc.stop()


def test_a_job_in_inches_cuts_the_same():
    found = judged(Bore(tool=1, pattern=POINTS, diameter_mm=11.3, depth_mm=2.4, pitch_mm=1), tool(4), units="inch")
    assert found.lines[0].startswith("G20")
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01


@pytest.mark.parametrize(
    ("code", "changes", "cutter"),
    [
        ("tool-wide", {}, tool(8)),
        ("tool-wide", {}, tool(9)),
        ("tool-wide", {}, tool(7.9)),
        ("tool-shape", {}, tool(4, shape="ball")),
        ("stepover-wide", {"stepover_mm": 5}, tool(4)),
        ("diameter-missing", {"diameter_mm": 0}, tool(4)),
        ("blocks-many", {"pitch_mm": 0.001, "depth_mm": 5000}, tool(4)),
        ("feed-missing", {}, tool(4, feed_mm_min=0)),
    ],
)
def test_what_cannot_be_bored_is_refused_before_any_row(code, changes, cutter):
    content = {"tool": 1, "pattern": POINTS, "diameter_mm": 8, "depth_mm": 3, "pitch_mm": 1}
    with pytest.raises(CycleError) as caught:
        cut(Bore(**(content | changes)), cutter)
    assert caught.value.code == code


@pytest.mark.parametrize("key", ["stepover_mm", "finish_stepover_mm"])
def test_a_step_wider_than_the_tool_is_named_by_its_key(key):
    with pytest.raises(CycleError, match=rf"^{key} \(ae(_acab)?\) is larger than the tool"):
        cut(Bore(tool=1, pattern=POINTS, diameter_mm=14, depth_mm=2, pitch_mm=1, **{key: 4.5}), tool(4))
