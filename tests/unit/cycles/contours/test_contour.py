# SPDX-License-Identifier: LGPL-2.1-or-later
"""Contours by hand: which way round, in what order, ramps, overcut, finishing, dog-bones, cutters, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.cycles.cycle import Setup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CW, LINE, RAPID, TableBuilder, Toolpath
from helpers.cycles.ellipse_judge import runs, spans
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.sweep_judge import Wanted, gouge_mm, swept

BOX = from_points([(-20, -15), (20, -15), (20, 15), (-20, 15)], closed=True)
HOLE = circle((0.0, 0.0), 9.0)
LINE_UP = from_points([(0, 0), (30, 0), (30, 20)])
ARC = {"kind": "arc", "radius_mm": 3.0}
SQUARE = from_points([(-10, -10), (10, -10), (10, 10), (-10, 10)], closed=True)
ROUNDED = Curve(
    np.array([(-5, -6), (5, -6), (10, -1), (10, 1), (5, 6), (-5, 6), (-10, 1), (-10, -1), (-5, -6)]),
    np.array([0.0, math.tan(math.pi / 8)] * 4),
)


def contour(*curves: Curve, **changes: object) -> Contour:
    return Contour(**({"tool": 1, "curves": curves or (BOX,), "depth_mm": 4.0} | changes))


def floor(path: Toolpath, z_mm: float) -> np.ndarray:
    """Return the points of the level moves at a height, in order, float64[n, 2]."""
    level = [run for run in runs(path) if run.kind != RAPID and np.allclose(run.xyz[:, 2], z_mm) and run.run_mm]
    return np.vstack([run.xyz[:, :2] for run in level])


def area(points: np.ndarray) -> float:
    return float(from_points(points, closed=True).area_mm2)


@pytest.mark.parametrize("side, direction, turns", [
    ("outside", "climb", -1), ("outside", "conventional", 1), ("inside", "climb", 1), ("inside", "conventional", -1),
])  # fmt: skip
def test_climb_has_the_part_on_the_right(side: str, direction: str, turns: int) -> None:
    """A right-hand spindle climbs clockwise round a part and counter-clockwise in a hole."""
    path, _ = cut(contour(side=side, direction=direction))
    assert math.copysign(1, area(floor(path, -4.0))) == turns
    far = shapely.distance(shapely.LinearRing(BOX.xy[:-1]), shapely.points(floor(path, -4.0)))
    assert far == pytest.approx(3.0) and shapely.Polygon(BOX.xy).contains(shapely.Point(floor(path, -4.0)[0])) == (
        side == "inside"
    )


@pytest.mark.parametrize("side, direction, forth", [
    ("left", "climb", True), ("left", "conventional", False),
    ("right", "climb", False), ("right", "conventional", True),
])  # fmt: skip
def test_an_open_contour_runs_beside_its_line(side: str, direction: str, forth: bool) -> None:
    path, _ = cut(contour(LINE_UP, side=side, direction=direction))
    points = floor(path, -4.0)
    begin, end = ((0, 3), (27, 20)) if side == "left" else ((0, -3), (33, 20))
    assert points[0 if forth else -1] == pytest.approx(begin) and points[-1 if forth else 0] == pytest.approx(end)


def test_an_outside_corner_is_an_arc_round_it() -> None:
    rows = cut(contour())[0].table()
    arcs = rows.centre[rows.kind == ARC_CW][:, :2]
    assert sorted(map(tuple, np.round(arcs, 6).tolist())) == sorted(map(tuple, BOX.xy[:-1].tolist()))


def test_what_is_inside_is_cut_first() -> None:
    island = circle((2.0, 0.0), 2.0)
    path, answer = cut(contour(BOX, HOLE, island, depth_mm=1), tool(2))
    sizes = []
    for span in spans(path, "contour"):
        points = np.vstack([run.xyz[:, :2] for run in runs(path, span.first, span.last)])
        sizes.append(float(np.nanmax(points[:, 0]) - np.nanmin(points[:, 0])))
    assert sizes == pytest.approx([6.0, 16.0, 42.0]) and answer.figures["contours"] == 3
    assert area(floor(path, -1.0)[-20:]) < 0


def test_levels_are_equal_and_the_last_is_the_finishing_one() -> None:
    path, answer = cut(contour(depth_mm=5.0, stepdown_mm=2.0, finish_stepdown_mm=0.5))
    depths = {round(float(run.xyz[-1, 2]), 9) for run in runs(path) if run.kind != RAPID and run.run_mm}
    assert sorted(depths) == [-5.0, -4.5, -3.0, -1.5] and answer.figures["levels"] == 4
    assert (path.table().kind == RAPID).sum() == 3


def test_a_ramp_goes_round_and_ends_with_a_level_lap() -> None:
    path, answer = cut(contour(stepdown_mm=3.0, ramp_deg=1.0))
    length_mm = answer.figures["length_mm"]
    falls = [run for run in runs(path) if run.kind != RAPID and run.run_mm and run.fall_mm > 1e-9]
    steepest = max(math.degrees(math.atan2(run.fall_mm, run.run_mm)) for run in falls)
    assert answer.figures["levels"] == 2 and steepest <= 1.0
    straight = [run for run in runs(path)[2:] if run.kind == LINE and not run.run_mm]
    assert min(run.xyz[-1, 2] for run in straight) == 0.0  # never straight down into the stock
    level_mm = sum(run.run_mm for run in runs(path) if run.kind != RAPID and run.xyz[0, 2] == run.xyz[-1, 2] == -4.0)
    assert level_mm == pytest.approx(length_mm)


def test_a_steep_ramp_is_slow() -> None:
    path, _ = cut(contour(ramp_deg=45.0, depth_mm=100.0), tool(plunge_mm_min=100, feed_mm_min=2000))
    for run in runs(path)[3:]:
        if run.fall_mm > 1e-9 and run.run_mm:
            assert run.feed_mm_min * run.fall_mm / math.hypot(run.fall_mm, run.run_mm) <= 100 + 1e-6


def test_an_open_ramp_comes_down_backwards_and_cuts_level_forwards() -> None:
    found = judged(contour(LINE_UP, side="left", ramp_deg=4.0, stepdown_mm=2.0))
    assert found.clean and max(found.gouge_mm, found.left_mm) < 0.01
    ends = floor(found.toolpath, -4.0)
    assert ends[0] == pytest.approx((0, 3), abs=1e-3) and ends[-1] == pytest.approx((27, 20), abs=1e-3)


def test_the_cut_runs_on_past_its_start() -> None:
    plain, longer = (
        sum(run.run_mm for run in runs(cut(contour(overcut_mm=mm))[0]) if run.kind != RAPID) for mm in (0.0, 2.5)
    )
    assert longer == pytest.approx(plain + 2.5)


def test_roughing_first_then_a_finishing_pass_on_the_wall() -> None:
    path, _ = cut(contour(finish_stepover_mm=0.5, finish_feed_mm_min=300.0, stock_to_leave_mm=0.1, stepdown_mm=2.0))
    wall = shapely.LinearRing(BOX.xy[:-1])
    far, feeds = [], []
    for span in spans(path, "contour"):
        level = [run for run in runs(path, span.first, span.last) if run.kind != RAPID and run.run_mm]
        far.append(float(shapely.distance(wall, shapely.points(np.vstack([run.xyz[:, :2] for run in level]))).min()))
        feeds.append({run.feed_mm_min for run in level})
    assert far == pytest.approx([3.6, 3.1]) and feeds == [{800.0}, {300.0}]


def test_on_its_line_a_closed_curve_goes_round_and_an_open_one_to_and_fro() -> None:
    path, answer = cut(contour(HOLE, side="on", stepdown_mm=2.0))
    assert (path.table().kind == RAPID).sum() == 3 and area(floor(path, -4.0)) > 0
    assert answer.removals[0].region.area == pytest.approx(math.pi * (12**2 - 6**2), rel=1e-4)
    path, _ = cut(contour(LINE_UP, side="on", stepdown_mm=2.0))
    assert floor(path, -4.0)[0] == pytest.approx((30, 20)) and (path.table().kind == RAPID).sum() == 3


@pytest.mark.parametrize("overcut_mm", [9.0, 45.0])
@pytest.mark.parametrize("closed", [SQUARE, ROUNDED])
def test_on_its_line_a_closed_curve_with_overcut_is_left_at_no_level(closed: Curve, overcut_mm: float) -> None:
    path, _ = cut(contour(closed, side="on", stepdown_mm=1.5, overcut_mm=overcut_mm))
    low = [run.xyz[:, :2] for run in runs(path)[2:] if run.kind != RAPID and run.xyz[:, 2].min() < 0]
    middles = [(xy[1:] + xy[:-1]) / 2.0 for xy in low]
    assert closed.distances_mm(np.vstack([*low, *middles])).max() < 0.003


@pytest.mark.parametrize("overcut_mm", [0.0, 5.0, 45.0])
@pytest.mark.parametrize("lead", [{"kind": "none"}, ARC])
@pytest.mark.parametrize("tabs", [None, {"count": 4, "width_mm": 3.0, "height_mm": 3.0}])
def test_a_ramp_cuts_dog_bones_by_steps(overcut_mm: float, lead: dict, tabs: dict | None) -> None:
    """Beyond the wall no lap goes deeper than the stepdown below the one before."""
    hole = from_points([(-20, -20), (20, -20), (20, 20), (-20, 20)], closed=True)
    keys = {"side": "inside", "depth_mm": 6.0, "stepdown_mm": 2.0, "ramp_deg": 3.0, "dogbones": "corner"}
    path, answer = cut(contour(hole, lead_out=lead, overcut_mm=overcut_mm, tabs=tabs, **keys))
    ends = np.array([run.xyz[-1] for run in runs(path)[2:] if run.kind != RAPID])
    for corner in hole.xy[:-1]:
        heights = ends[np.hypot(*(ends[:, :2] - corner).T) < 3.001, 2]
        assert heights.min() == -6.0 and -np.diff([0.0, *heights]).min() <= 2.0 + 1e-9
    assert answer.figures["levels"] == 3


def test_above_tabs_a_contour_is_not_cut_in_pieces() -> None:
    tabs = {"count": 4, "width_mm": 5.0, "height_mm": 1.5}
    for changes in ({}, {"ramp_deg": 3.0}, {"overcut_mm": 2.0}):
        plain, held = (cut(contour(stepdown_mm=1.0, tabs=each, **changes))[0] for each in (None, tabs))
        above = [[run.xyz[-1].tolist() for run in runs(path) if run.xyz[-1, 2] >= -2.0] for path in (plain, held)]
        rise = [place for place in above[1] if place[2] < 2.0]
        assert rise == [place for place in above[0] if place[2] < 2.0] and len(held) > len(plain)


@pytest.mark.parametrize("kind", ["corner", "side"])
def test_dog_bones_make_room_for_square_corners(kind: str) -> None:
    """A square peg as large as the drawn hole goes in, to the tolerance."""
    plain, boned = (judged(contour(side="inside", dogbones=each)) for each in ("none", kind))
    peg = shapely.Polygon(BOX.xy).buffer(-0.012, join_style="mitre")
    hole = [swept(found.toolpath, 3.0, -4.0).union(shapely.box(-17, -12, 17, 12)) for found in (plain, boned)]
    assert not hole[0].covers(peg) and hole[1].covers(peg)
    assert plain.answer.figures["rest_mm"] == pytest.approx(3 * (math.sqrt(2) - 1), abs=1e-3)
    assert boned.clean and max(boned.gouge_mm, boned.left_mm) < 0.01 and not boned.answer.warnings
    beyond = {"corner": 3 - 3 / math.sqrt(2), "side": 3.0}[kind]
    assert gouge_mm(boned.toolpath, 3.0, [Wanted(shapely.Polygon(BOX.xy), -4.0)]) == pytest.approx(beyond, abs=0.01)
    if kind == "side":  # the longer sides, along X, go on past the corner: nothing is cut above and below them
        bounds = swept(boned.toolpath, 3.0, -4.0).bounds
        assert bounds[3] == pytest.approx(15, abs=0.005) and bounds[2] == pytest.approx(23, abs=0.005)


CUTTERS = [
    ("ball", {}), ("bullnose", {"corner_radius_mm": 1.0}), ("v", {"tip_angle_deg": 60.0}),
    ("engraver", {"tip_angle_deg": 30.0, "tip_diameter_mm": 0.5}), ("jet", {"taper_deg": 2.0}), ("wire", {}),
]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("shape, keys", CUTTERS)
def test_every_cutter_that_cuts_sideways_leaves_the_part_as_drawn(shape: str, keys: dict) -> None:
    cutter = tool(4.0, shape=shape, **keys)
    stock_mm = 4.0 if shape in ("jet", "wire") else 0.0
    found = judged(contour(BOX, HOLE, lead_in=ARC), cutter, thick_mm=stock_mm)
    faults = [fault for fault in found.faults if "[rapid-in-stock]" not in fault]  # thermal cutting switches beams off
    assert faults == [] and max(found.gouge_mm, found.left_mm) < 0.011


def test_the_kerf_decides_how_far_beside_the_line_a_jet_runs() -> None:
    path, answer = cut(contour(kerf_mm=0.4), tool(0.3, shape="jet"))
    far = shapely.distance(shapely.LinearRing(BOX.xy[:-1]), shapely.points(floor(path, -4.0)))
    assert far == pytest.approx(0.2) and "a kerf of 0.4 mm" in answer.warnings[0]
    assert answer.removals[0].tolerance_mm == pytest.approx(0.06)


def test_a_mills_kerf_is_its_diameter_but_for_wear() -> None:
    with pytest.raises(CycleError) as caught:
        cut(contour(kerf_mm=2.0), tool(6.0))
    assert caught.value.code == "kerf-far" and caught.value.limit == "5.4 to 6.6 mm"
    for kerf_mm in (5.4, 6.6):
        assert cut(contour(kerf_mm=kerf_mm), tool(6.0))[1].removals[0].tolerance_mm == pytest.approx(0.31)
    with pytest.raises(CycleError):
        cut(contour(kerf_mm=6.7), tool(6.0))


def test_a_kerf_of_a_v_tool_is_held_against_its_width_at_the_depth() -> None:
    cutter = tool(20.0, shape="v", tip_angle_deg=90.0, tip_diameter_mm=0.0)
    assert cut(contour(kerf_mm=8.2), cutter)[1].removals[0].tolerance_mm == pytest.approx(0.11)
    with pytest.raises(CycleError) as caught:
        cut(contour(kerf_mm=20.0), cutter)
    assert caught.value.limit == "7.2 to 8.8 mm"


@pytest.mark.parametrize("gap_mm", [0.5, 3.0, 5.9])
def test_a_gap_too_narrow_for_the_tool_gets_no_dog_bone(gap_mm: float) -> None:
    parts = circle((0.0, 0.0), 15.0), circle((19.0 + gap_mm, 0.0), 4.0)
    plain, boned = (cut(contour(*parts, dogbones=each))[0] for each in ("none", "corner"))
    assert len(boned) == len(plain)


@pytest.mark.parametrize("wide_mm", [0.1, 0.4, 2.0])
@pytest.mark.parametrize("kind", ["corner", "side"])
def test_a_slit_gets_no_dog_bone_at_its_end(wide_mm: float, kind: str) -> None:
    """The slit's own walls lead to its end, but not on the way that the tool takes past its mouth."""
    mouth, end = wide_mm / 2.0, [(-8.0, 20.0), (-20.0, 20.0), (-20.0, -20.0), (20.0, -20.0), (20.0, 20.0), (8.0, 20.0)]
    slit = from_points([*end, (mouth, 20.0), (mouth, 12.0), (-mouth, 12.0), (-mouth, 20.0)], closed=True)
    plain, boned = (cut(contour(slit, dogbones=each)) for each in ("none", kind))
    assert len(boned[0]) == len(plain[0])
    told = "material stays in 1 gap(s) between walls that are narrower than the tool, the deepest one before X0.000 Y"
    assert [answer.warnings[0].startswith(told) for _, answer in (plain, boned)] == [True, True]
    assert len(plain[1].warnings) == len(boned[1].warnings) == 1


def test_a_gap_is_not_called_a_corner_too_sharp_for_a_dog_bone() -> None:
    parts = circle((0.0, 0.0), 15.0), circle((22.0, 0.0), 4.0)
    for kind in ("none", "corner"):
        warnings = cut(contour(*parts, dogbones=kind))[1].warnings
        assert any("gap(s) between walls" in told for told in warnings)
        assert not any("inside corner" in told for told in warnings)


def test_what_dog_bones_take_does_not_rest() -> None:
    assert cut(contour(side="inside"))[1].figures["rest_mm"] == pytest.approx(1.243, abs=1e-3)
    assert cut(contour(side="inside", dogbones="corner"))[1].figures["rest_mm"] == 0.0


def test_a_pass_deeper_than_the_tool_is_wide_is_told() -> None:
    deep = cut(contour(depth_mm=6.5), tool(6.0))[1].warnings
    assert deep == ["one pass is 6.5 mm deep, deeper than the tool's diameter of 6 mm; give stepdown_mm"]
    for changes in ({"depth_mm": 6.0}, {"depth_mm": 6.5, "stepdown_mm": 4.0}, {"depth_mm": 6.5, "ramp_deg": 1.0}):
        assert cut(contour(**changes), tool(6.0))[1].warnings == []
    assert cut(contour(depth_mm=6.5), tool(0.3, shape="jet"))[1].warnings == []


@pytest.mark.slow
def test_inches_give_the_same_part() -> None:
    operation = contour(BOX, HOLE, ramp_deg=3.0, lead_out=ARC, tabs={"count": 3, "width_mm": 4, "height_mm": 1})
    inch, metric = (judged(operation, units=units) for units in ("inch", "mm"))
    assert inch.clean and max(inch.gouge_mm, inch.left_mm) < 0.01 and "G20" in " ".join(inch.lines[:5])
    for z_mm in (-4.0, -2.0):
        one, other = (swept(found.toolpath, 3.0, z_mm) for found in (inch, metric))
        assert one.hausdorff_distance(other) < 0.01


def test_parts_too_near_each_other_for_the_tool_are_told() -> None:
    _, answer = cut(contour(BOX, BOX.moved(43, 0)))
    told = next(warning for warning in answer.warnings if warning.startswith("1 piece(s) stay joined"))
    assert "the tightest place is at X21.500 Y" in told
    island = cut(contour(BOX, circle((15, 0), 3), side="inside"), tool(3.0))[1].warnings
    assert any("the tightest place is at X19.000 Y0.000" in warning for warning in island)
    assert not any("joined" in warning for warning in cut(contour(BOX, BOX.moved(47, 0)))[1].warnings)


def test_a_corner_too_sharp_for_a_dog_bone_is_told() -> None:
    wedge = from_points([(0, 0), (50, 0), (0, 8)], closed=True)
    found = cut(contour(wedge, side="inside", dogbones="corner"))[1]
    assert found.warnings == [
        "more than 9.000 mm of material stays in 1 inside corner(s) that are sharper than the tool; a dog-bone would "
        "be too long"
    ]


TURN = np.linspace(0, 2 * math.pi, 50_000, endpoint=False)
WAVES = (40 + 3 * np.sin(9 * TURN)) * np.exp(1j * TURN)
ODD = {
    "twins": (BOX, BOX),
    "edge to edge": (BOX, BOX.moved(40, 0)),
    "corner to corner": (BOX, BOX.moved(40, 30)),
    "touching from within": (BOX, from_points([(-20, -5), (0, -5), (0, 5), (-20, 5)], closed=True)),
    "crossing": (BOX, BOX.moved(13, 11)),
    "bow": (from_points([(0, 0), (30, 30), (30, 0), (0, 30)], closed=True),),
    "tripled points": (Curve(np.repeat(BOX.xy, 3, axis=0), np.zeros(14)),),
    "sliver": (from_points([(0, 0), (50, 0.01), (0, 0.02)], closed=True),),
    "slot as wide as the tool": (BOX, from_points([(-15, -3), (15, -3), (15, 3), (-15, 3)], closed=True)),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", ODD)
@pytest.mark.parametrize("side", ["outside", "inside"])
def test_odd_outlines_are_cut_right_or_refused(name: str, side: str) -> None:
    try:
        found = judged(contour(*ODD[name], side=side))
    except CycleError as error:
        assert error.code == "tool-wide" and name in ("sliver", "slot as wide as the tool")
        return
    assert [fault for fault in found.faults if "not-exact" not in fault] == []
    assert max(found.gouge_mm, found.left_mm) < 0.01


@pytest.mark.slow
def test_fifty_thousand_points_become_few_arcs() -> None:
    outline = from_points(np.column_stack([WAVES.real, WAVES.imag]), closed=True)
    path, answer = cut(contour(outline, tabs={"count": 3, "width_mm": 4, "height_mm": 1}, lead_in=ARC))
    far = shapely.distance(shapely.LineString(outline.xy), shapely.points(floor(path, -4.0)[::7]))
    assert len(path) < 200 and answer.figures["tabs"] == 3
    assert far.min() > 2.99 and np.median(far) == pytest.approx(3.0, abs=0.01)


def test_a_piece_that_comes_free_is_told() -> None:
    operation = contour(depth_mm=5.0)
    for thick_mm, told in ((5.0, 1), (6.0, 0)):
        table = TableBuilder(Start())
        answer = operation.cut(Setup(tool(), 10.0, 2.0, thickness_mm=thick_mm), table)
        assert len(answer.warnings) == told
    held = contour(depth_mm=5.0, tabs={"count": 3, "width_mm": 4, "height_mm": 1})
    assert held.cut(Setup(tool(), 10.0, 2.0, thickness_mm=5.0), TableBuilder(Start())).warnings == []


REFUSED = {
    "tool-shape": ({}, {"shape": "drill"}),
    "curve-open": ({"curves": (LINE_UP,)}, {}),
    "curve-closed": ({"side": "left"}, {}),
    "tool-wide": ({"side": "inside"}, {"diameter_mm": 31.0}),
    "tab-high": ({"tabs": {"count": 1, "width_mm": 2, "height_mm": 4}}, {}),
    "tabs-many": ({"tabs": {"spacing_mm": 1e-3, "width_mm": 2, "height_mm": 1}}, {}),
    "tab-room": ({"tabs": {"count": 1, "width_mm": 39, "height_mm": 1}}, {}),
    "lead-room": ({"side": "inside", "curves": (circle((0, 0), 3.05),), "lead_in": ARC}, {}),
    "lead-side": ({"side": "on", "lead_in": ARC}, {}),
    "wall-side": ({"side": "on", "dogbones": "corner"}, {}),
    "overcut-long": ({"overcut_mm": 500.0}, {}),
    "tool-core": ({}, {"core_diameter_mm": 2.0}),
    "beam-height": ({"ramp_deg": 3.0}, {"shape": "wire"}),
    "feed-missing": ({}, {"feed_mm_min": 0.0}),
    "curve-length": ({"curves": (from_points([(0, 0), (0.001, 0)]),), "side": "on"}, {}),
    "outline-empty": ({"curves": (from_points([(0, 0), (5, 0), (9, 0)], closed=True),)}, {}),
    "finish-large": ({"finish_stepdown_mm": 4.0}, {}),
}


@pytest.mark.parametrize("code", REFUSED)
def test_what_cannot_be_cut_is_refused_before_any_row(code: str) -> None:
    changes, cutter = REFUSED[code]
    table = TableBuilder(Start())
    with pytest.raises(CycleError) as caught:
        contour(**changes).cut(Setup(tool(**cutter), 10.0, 2.0), table)
    assert caught.value.code == code and caught.value.advice and table.index == 0


def test_it_comes_back_from_json_as_it_went() -> None:
    operation = contour(BOX, HOLE, tabs={"spacing_mm": 30, "width_mm": 4, "height_mm": 1}, lead_in=ARC)
    assert Contour.model_validate_json(operation.model_dump_json()) == operation
    assert Contour.model_validate(operation.model_dump()) == operation


@pytest.mark.parametrize("changes", [
    {"tabs": {"width_mm": 4, "height_mm": 1}}, {"tabs": {"count": 2, "spacing_mm": 9, "width_mm": 4, "height_mm": 1}},
    {"lead_in": {"kind": "arc"}}, {"lead_out": {"kind": "line", "radius_mm": 3}}, {"side": "under"}, {"ramp_deg": 60},
])  # fmt: skip
def test_parameters_that_say_nothing_sensible_are_refused(changes: dict) -> None:
    with pytest.raises(ValueError, match="validation error"):
        contour(**changes)
