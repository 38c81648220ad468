# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drilling: random patterns, tools and styles judged by the product and hole by hole, as blocks and as moves."""

from __future__ import annotations

import math
from random import Random

import numpy as np
import pytest
from pydantic import TypeAdapter

from CNCStepper.cycles.holes.drill import Drill
from CNCStepper.cycles.holes.hole_patterns import Pattern, placed
from CNCStepper.errors import CycleError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import write
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, RAPID, Toolpath
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.seeds import SEEDS

POINTS = {"kind": "points", "points_mm": [(0, 0), (20, 5), (3, 14)]}

ONE = {"kind": "points", "points_mm": [(0, 0)]}
TRIANGLE = from_points([(0, 0), (1, 0), (0, 1)], closed=True)
MANY = {"kind": "grid", "origin_mm": (0, 0), "spacing_mm": (1, 1), "count": (999, 999)}


def drill(diameter_mm: float = 3.0, **changes: object) -> Tool:
    return tool(diameter_mm, shape="drill", **changes)


def random_pattern(random: Random, room_mm: float) -> dict:
    """Return a pattern of a few holes, mostly not closer than they are wide."""
    kind = random.choice(["points", "line", "grid", "bolt_circle", "arc", "circles"])
    x, y, step = random.uniform(-30, 30), random.uniform(-30, 30), random.uniform(0.8, 3) * room_mm
    if kind == "points":
        return {"kind": kind, "points_mm": [(x, y), (x + step, y), (x, y - step)][: random.randint(1, 3)]}
    if kind == "line":
        return {"kind": kind, "start_mm": (x, y), "end_mm": (x + 3 * step, y + step), "count": random.randint(1, 4)}
    if kind == "grid":
        size = (random.randint(1, 3), random.randint(1, 2))
        turned = random.choice([0.0, 30.0])
        return {"kind": kind, "origin_mm": (x, y), "spacing_mm": (step, -step), "count": size, "rotation_deg": turned}
    round_ = {"kind": kind, "centre_mm": (x, y), "radius_mm": 2 * step, "count": random.randint(1, 5)}
    if kind == "bolt_circle":
        return round_ | {"start_deg": random.uniform(-90, 400)}
    if kind == "arc":
        return round_ | {"start_deg": 10, "end_deg": random.choice([-150, 200])}
    return {"kind": kind, "circles": [circle((x, y), room_mm / 2), circle((x + step, y), room_mm / 2)]}


def random_drill(seed: int) -> tuple[Drill, Tool]:
    random = Random(seed)
    diameter_mm = random.choice([0.8, 2.0, 3.0, 6.5, 12.0])
    shape = random.choice(["drill", "drill", "drill", "flat", "v"])
    angle = {"drill": {"point_angle_deg": random.choice([90.0, 118.0, 140.0])}, "v": {"tip_angle_deg": 90.0}}
    depth_mm = random.uniform(0.2, 12.0)
    style = random.choice(["G81", "G82", "G83", "G73"])
    operation = Drill(
        tool=1,
        pattern=random_pattern(random, diameter_mm),
        depth_mm=depth_mm,
        tip=random.choice(["tip", "diameter"]),
        through_mm=random.choice([0.0, 0.0, 1.0]),
        style=style,
        peck_mm=round(max(random.choice([0.3, 0.5, 2.0]) * depth_mm, 0.5), 2) if style in ("G83", "G73") else 0.0,
        dwell_s=0.5 if style == "G82" else 0.0,
        retract=random.choice(["clearance", "retract"]),
        order=random.choice(["short", "given"]),
        offset_mm=random.choice([(0.0, 0.0), (7.5, -3.25)]),
    )
    return operation, tool(diameter_mm, shape=shape, **angle.get(shape, {}))


def places(path: Toolpath) -> np.ndarray:
    """Return where the path goes below the top, to three decimals."""
    low = path.table().end[path.table().end[:, 2] < 0]
    return np.unique(np.round(low[:, :2], 3), axis=0)


def rapids_into_stock_mm(path: Toolpath) -> float:
    """Return how far a rapid goes below what was drilled before at its place."""
    table, begins, drilled, worst = path.table(), path.begins(), {}, 0.0
    for row in range(len(table)):
        place, z = tuple(np.round(table.end[row, :2], 3)), float(table.end[row, 2])
        if table.kind[row] == RAPID:
            same = np.allclose(begins[row, :2], table.end[row, :2], equal_nan=True)
            low = z if same else min(z, float(begins[row, 2]))
            worst = max(worst, drilled.get(place, 0.0) - low)
        else:
            drilled[place] = min(drilled.get(place, 0.0), z)
    return worst


def bottom_mm(operation: Drill, cutter: Tool) -> float:
    """Return how deep the tip has to go, from the tool's angles."""
    angle = {"drill": cutter.point_angle_deg or 118.0, "v": cutter.tip_angle_deg}.get(cutter.shape)
    point_mm = cutter.radius_mm / math.tan(math.radians(angle / 2)) if angle else 0.0
    return -(operation.depth_mm + operation.through_mm + point_mm * (operation.tip == "diameter"))


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_random_holes_are_drilled_and_nothing_else(seed):
    operation, cutter = random_drill(seed)
    found = judged(operation, cutter)
    assert found.clean, found.faults
    assert found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    holes, _ = placed(operation.pattern, operation.order, operation.offset_mm)
    np.testing.assert_allclose(places(found.toolpath), sorted((h.x_mm, h.y_mm) for h in holes), atol=1.1e-3)
    assert abs(found.toolpath.table().end[:, 2].min() - bottom_mm(operation, cutter)) < 1e-3
    assert rapids_into_stock_mm(found.toolpath) <= 0.0


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_blocks_and_moves_cut_the_same_part(seed):
    operation, cutter = random_drill(seed)
    path, _ = cut(operation, cutter)
    blocks = interpret(write(path, "linuxcnc"), Start.with_work_zero((0.0, 0.0, 0.0)), "linuxcnc")
    moves = interpret(write(path, "grbl"), Start.with_work_zero((0.0, 0.0, 0.0)), "grbl")
    assert [span.name for span in blocks.spans if span.kind == "cycle"] == [operation.style] * len(places(path))
    stock = Stock((120.0, 120.0, 15.0))
    one, other = (height_map(each, cutter, stock) for each in (blocks, moves))
    assert np.array_equal(one.heights_mm, other.heights_mm)
    np.testing.assert_allclose(blocks.table().end, moves.table().end, atol=0.02)  # Q is rounded, the floor is not


def test_a_bolt_circle_in_pecks():
    pattern = {"kind": "bolt_circle", "centre_mm": (20, 10), "radius_mm": 8, "count": 3, "start_deg": 90}
    found = judged(Drill(tool=1, pattern=pattern, depth_mm=4, style="G83", peck_mm=2.5), drill())
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    first = found.lines.index("X20.000 Y18.000")
    strokes = ["Z2.000", "G1 Z-0.500", "G0 Z2.000", "Z-0.246", "G1 Z-3.000", "G0 Z2.000", "Z-2.746", "G1 Z-4.000"]
    assert found.lines[first + 1 : first + 10] == [*strokes, "G0 Z10.000"]
    assert found.answer.figures == {"holes": 3, "depth_mm": 4.0}


def test_the_tip_or_the_full_diameter_reaches_the_depth():
    tip = cut(Drill(tool=1, pattern=POINTS, depth_mm=4), drill())[1]
    full = cut(Drill(tool=1, pattern=POINTS, depth_mm=4, tip="diameter", through_mm=0.5), drill())[1]
    assert tip.figures["depth_mm"] == 4.0
    assert full.figures["depth_mm"] == pytest.approx(4.5 + 1.5 / math.tan(math.radians(59)))


def test_holes_keep_their_order_when_it_is_locked():
    points = [(0, 0), (50, 0), (1, 0), (51, 0)]
    pattern = {"kind": "points", "points_mm": points}
    spans = {
        order: [(span.words["X"], span.words["Y"]) for span in path.spans if span.kind == "cycle"]
        for order in ("given", "short")
        for path in [cut(Drill(tool=1, pattern=pattern, depth_mm=1, order=order), drill())[0]]
    }
    assert spans["given"] == points
    assert spans["short"] == [(0, 0), (1, 0), (50, 0), (51, 0)]


def test_the_retract_between_holes():
    for retract, heights in (("clearance", {10.0}), ("retract", {2.0})):
        path, _ = cut(Drill(tool=1, pattern=POINTS, depth_mm=1, retract=retract), drill())
        table, begins = path.table(), path.begins()
        moving = np.hypot(*(table.end - begins)[:, :2].T) > 0
        assert set(table.end[moving, 2]) == heights
        assert table.end[-1, 2] == 10.0


def test_what_stands_twice_is_drilled_once_and_said():
    pattern = {"kind": "grid", "origin_mm": (0, 0), "spacing_mm": (0, 5), "count": (2, 3)}
    path, answer = cut(Drill(tool=1, pattern=pattern, depth_mm=1), drill())
    assert len(places(path)) == 3 and "3 of the 6 holes" in answer.warnings[0]


@pytest.mark.parametrize(("depth_mm", "peck_mm", "pecks"), [(3, 0.05, 100), (1, 0.05, 60), (4, 0.6, 10), (4, 7, 1)])
def test_pecks_that_end_at_the_floor_are_no_more_than_meant(depth_mm, peck_mm, pecks):
    operation = Drill(tool=1, pattern=ONE, depth_mm=depth_mm, style="G83", peck_mm=peck_mm)
    path, _ = cut(operation, drill())
    assert int((path.table().kind == LINE).sum()) == pecks
    assert f"G83 X0.000 Y0.000 Z-{depth_mm}.000 R2.000 Q{peck_mm:.3f}" in write(path, "linuxcnc")


def test_two_rims_of_one_hole_are_drilled_once():
    rims = {"kind": "circles", "circles": [circle((4, 5), 2), circle((4, 5), 5), circle((9, 5), 2)]}
    path, answer = cut(Drill(tool=1, pattern=rims, depth_mm=1), drill())
    assert places(path).tolist() == [[4, 5], [9, 5]] and "1 of the 3 holes" in answer.warnings[0]
    pattern = TypeAdapter(Pattern).validate_python(rims)
    assert [hole.diameter_mm for hole in placed(pattern, "given", own_diameters=True)[0]] == [4, 10, 4]


def test_neighbours_are_one_by_their_distance():
    def kept(*points_mm: tuple[float, float]) -> list[tuple[float, float]]:
        pattern = TypeAdapter(Pattern).validate_python({"kind": "points", "points_mm": points_mm})
        return [hole[:2] for hole in placed(pattern, "given")[0]]

    edge_mm = 1.0005  # a place that rounds up, beside one that rounds down
    assert kept((edge_mm + 1e-6, 0), (edge_mm - 1e-6, 0)) == [(edge_mm + 1e-6, 0)]
    assert kept((0.9999, -0.0001), (1.0001, 0.0001)) == [(0.9999, -0.0001)]
    assert len(kept((0, 0), (0.0012, 0), (0, -0.0012))) == 3


def test_a_mill_with_a_core_is_warned_of():
    _, answer = cut(Drill(tool=1, pattern=POINTS, depth_mm=1), tool(6, core_diameter_mm=2))
    assert "does not cut over its centre" in answer.warnings[0]


def test_a_job_in_inches_cuts_the_same():
    found = judged(
        Drill(tool=1, pattern=POINTS, depth_mm=4, style="G73", peck_mm=1.5, tip="diameter"), drill(), units="inch"
    )
    assert found.lines[0].startswith("G20")
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01


@pytest.mark.parametrize(
    ("code", "changes", "cutter"),
    [
        ("tool-shape", {}, tool(6, shape="ball")),
        ("feed-missing", {}, drill(plunge_mm_min=0)),
        ("peck-missing", {"style": "G83"}, drill()),
        ("peck-missing", {"style": "G73"}, drill()),
        ("dwell-missing", {"style": "G82"}, drill()),
        ("peck-idle", {"peck_mm": 2}, drill()),
        ("peck-idle", {"style": "G82", "dwell_s": 1, "peck_mm": 2}, drill()),
        ("dwell-idle", {"dwell_s": 1}, drill()),
        ("dwell-idle", {"style": "G83", "peck_mm": 2, "dwell_s": 1}, drill()),
        ("blocks-many", {"style": "G73", "peck_mm": 0.001, "depth_mm": 5000}, drill()),
        ("hole-shape", {"pattern": {"kind": "circles", "circles": [TRIANGLE]}}, drill()),
        ("holes-many", {"pattern": MANY}, drill()),
    ],
)
def test_what_cannot_be_drilled_is_refused_before_any_row(code, changes, cutter):
    with pytest.raises(CycleError) as caught:
        cut(Drill(**({"tool": 1, "pattern": POINTS, "depth_mm": 5.0} | changes)), cutter)
    assert caught.value.code == code


def test_patterns_stand_where_they_are_meant():
    def at(**pattern: object) -> list[tuple[float, float]]:
        holes = TypeAdapter(Pattern).validate_python(pattern).holes()
        return [(round(hole.x_mm, 6) + 0.0, round(hole.y_mm, 6) + 0.0) for hole in holes]

    assert at(kind="line", start_mm=(0, 0), end_mm=(6, 3), count=4) == [(0, 0), (2, 1), (4, 2), (6, 3)]
    assert at(kind="grid", origin_mm=(16, 16), spacing_mm=(0, 20), count=(1, 3)) == [(16, 16), (16, 36), (16, 56)]
    turned = at(kind="grid", origin_mm=(1, 1), spacing_mm=(2, 3), count=(2, 2), rotation_deg=90)
    assert turned == [(1, 1), (1, 3), (-2, 1), (-2, 3)]
    assert at(kind="bolt_circle", centre_mm=(5, 5), radius_mm=2, count=4) == [(7, 5), (5, 7), (3, 5), (5, 3)]
    assert at(kind="arc", centre_mm=(0, 0), radius_mm=2, start_deg=0, end_deg=-180, count=3) == [
        (2, 0),
        (0, -2),
        (-2, 0),
    ]
    assert at(kind="circles", circles=[circle((4, 5), 2), circle((1, 1), 9).reversed()]) == [(4, 5), (1, 1)]
