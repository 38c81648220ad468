# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sheets by hand: kerf and arcs, leads, holes, corners, loops, joints, marks, spots, passes, knives, refusals."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
import shapely
from pydantic import ValidationError

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.machine.cut_charts import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.check_context import CheckContext, Cutting
from CNCStepper.simulation.checks.sheet_checks import sheet_findings
from CNCStepper.simulation.exact.free_pieces import sheet_verdict
from CNCStepper.state import Start
from CNCStepper.toolpath import LINE, RAPID, TableBuilder, Toolpath
from helpers.cycles.sheet_judge import strokes

KERF_MM, FEED, DELAY_S = 1.5, 3000.0, 0.4
PLATE = rectangle((0.0, 0.0), (80.0, 60.0))
HOLE = circle((20.0, 30.0), 8.0)
WIDE = circle((55.0, 30.0), 18.0)


def setup(process: str = "plasma", kerf_mm: float = KERF_MM, **changes: object) -> Setup:
    shape = {"drag-knife": "engraver", "scribe": "engraver"}.get(process, "jet")
    tip = {"tip_angle_deg": 60.0} if shape == "engraver" else {}
    tool = Tool(number=1, shape=shape, diameter_mm=kerf_mm, feed_mm_min=FEED, plunge_mm_min=1000.0, **tip)
    data = CutData(process=process, material="mild-steel", thickness_mm=3.0, feed_mm_min=FEED, kerf_mm=kerf_mm,
                   pierce_delay_s=DELAY_S, lead_in_mm=2.0, pierce_height_mm=3.8, cut_height_mm=1.5)  # fmt: skip
    if process in ("laser", "drag-knife", "scribe"):
        data = data.model_copy(update={"lead_in_mm": 0.0, "pierce_height_mm": 0.0, "cut_height_mm": 0.0})
    return replace(Setup(tool, 10.0, 2.0, None, thickness_mm=3.0, process=PROCESSES[process], cut_data=data), **changes)


def cut(*curves: Curve, given: Setup | None = None, **keys: object) -> tuple[Toolpath, Answer]:
    table = TableBuilder(Start())
    answer = SheetCut(curves=curves or (PLATE, HOLE, WIDE), **keys).cut(given or setup(), table)
    return table.toolpath(), answer


def rows_of(path: Toolpath, title: str) -> np.ndarray:
    """Return the rows of a contour behind its pierce."""
    span = next(span for span in path.spans if span.kind == "contour" and span.name == title)
    table = path.table()
    rows = np.arange(span.first, span.last)
    return rows[table.kind[rows] != RAPID]


def powered(path: Toolpath) -> np.ndarray:
    return np.array([state.spindle_rpm if state.spindle_turns else 0.0 for state in path.states])[path.table().state]


def test_the_cut_lies_half_a_kerf_off_and_arcs_stay_arcs() -> None:
    path, answer = cut()
    table = path.table()
    for title, curve in (("hole 2", HOLE), ("part 1", PLATE)):
        rows = rows_of(path, title)
        lead = next(span for span in path.spans if span.kind == "lead-in" and span.name == title)
        rows = rows[rows >= lead.last]
        assert curve.distances_mm(table.end[rows, :2]) == pytest.approx(KERF_MM / 2.0, abs=0.001)
        if title == "hole 2":
            assert (table.kind[rows] != LINE).all()
    assert answer.figures["pierces"] == 3 and len(answer.parts) == 1
    assert answer.parts[0].area == pytest.approx(80 * 60 - math.pi * (8**2 + 18**2), abs=0.2)
    band = answer.removals[0].region
    assert band.area > KERF_MM * (PLATE.length_mm + HOLE.length_mm + WIDE.length_mm) * 0.95


def test_power_is_on_only_while_cutting_with_a_delay_behind_each_pierce() -> None:
    path, _ = cut()
    found = strokes(path)
    assert len(found) == 3 and all(one.dwell_s == DELAY_S for one in found)
    names = [span.name for span in path.spans if span.kind == "contour"]
    assert names[-1] == "part 1" and set(names[:2]) == {"hole 2", "hole 3"}
    assert powered(path)[-1] == 0.0


def test_heights_are_those_of_the_chart_and_none_without_a_z_axis() -> None:
    path, _ = cut()
    assert set(path.table().end[:, 2]) == {10.0, 3.8, 1.5}
    path, _ = cut(given=setup(has_z=False))
    assert set(path.table().end[:, 2]) == {0.0}


def test_a_small_hole_is_slow_and_runs_on_without_power() -> None:
    path, _ = cut(small_holes={"diameter_mm": 20.0, "torch_off_mm": 1.0, "over_run_mm": 3.0})
    table, on = path.table(), powered(path) > 0
    small, wide = rows_of(path, "hole 2"), rows_of(path, "hole 3")
    assert set(table.feed[small[2:]]) == {0.6 * FEED} and set(table.feed[wide[2:]]) == {FEED}
    lengths = np.hypot(*np.diff(np.vstack([path.begins()[small, :2], table.end[small[-1:], :2]]), axis=0).T)
    assert lengths[~on[small]].sum() == pytest.approx(4.0, abs=0.2) and on[wide].all()


@pytest.mark.parametrize("rule, slow", [
    ({"diameter_mm": 0.0, "thickness_ratio": 6.0}, True), ({"diameter_mm": 0.0, "thickness_ratio": 5.0}, False),
    ({"diameter_mm": 0.0, "length_mm": 51.0}, True), ({"diameter_mm": 0.0, "length_mm": 50.0}, False),
])  # fmt: skip
def test_holes_are_small_by_thickness_or_length_too(rule: dict[str, float], slow: bool) -> None:
    path, _ = cut(small_holes=rule)
    assert (path.table().feed[rows_of(path, "hole 2")[3]] < FEED) == slow


def test_corners_and_arcs_are_slow() -> None:
    plate = rectangle((0.0, 0.0), (80.0, 60.0), 4.0)
    path, _ = cut(plate, corners={"angle_deg": 60.0, "distance_mm": 2.0}, arcs={"radius_mm": 5.0, "feed_share": 0.7})
    rows = rows_of(path, "part 1")
    assert set(np.round(path.table().feed[rows[2:]] / FEED, 3)) == {0.7, 1.0}
    path, _ = cut(PLATE, corners={"angle_deg": 60.0, "distance_mm": 2.0})
    table, rows = path.table(), rows_of(path, "part 1")
    slow = table.feed[rows] == 0.5 * FEED
    lengths = np.hypot(*(table.end[rows, :2] - path.begins()[rows, :2]).T)[slow & (table.kind[rows] == LINE)]
    assert lengths.sum() == pytest.approx(4 * 2 * 2.0, abs=0.01)


def test_sharp_outside_corners_get_a_loop_in_scrap_and_none_where_there_is_no_room() -> None:
    path, answer = cut(PLATE, loops={"radius_mm": 2.0})
    assert answer.figures["loops"] == 4 and not answer.warnings
    line = shapely.union_all([one.line for one in strokes(path)])
    part = shapely.Polygon(PLATE.xy)
    assert line.distance(part) == pytest.approx(KERF_MM / 2.0, abs=0.001)
    corner = shapely.Point(80.0 + KERF_MM / 2.0, 60.0 + KERF_MM / 2.0)
    assert line.distance(corner) < 0.001
    _, answer = cut(PLATE, PLATE.moved(84.0, 0.0), loops={"radius_mm": 2.0})
    assert answer.figures["loops"] == 4 and "4 corner(s)" in answer.warnings[0]


def test_micro_joints_leave_their_width_and_the_part_is_not_free() -> None:
    path, answer = cut(PLATE, given=setup("laser", 0.2, power_s=800.0), tabs={"count": 3, "width_mm": 0.5})
    assert (answer.figures["parts"], answer.figures["held_parts"]) == (0, 1) and len(strokes(path)) == 4
    band = shapely.union_all([one.line.buffer(0.1) for one in strokes(path)])
    left = shapely.box(-20, -20, 100, 80).difference(band)
    assert left.geom_type == "Polygon"  # the part hangs on the sheet
    bridges = left.difference(shapely.union_all([shapely.box(0, 0, 80, 60), shapely.box(-20, -20, 100, 80).difference(
        shapely.box(-0.2, -0.2, 80.2, 60.2))]))  # fmt: skip
    round_ends = 0.2**2 - math.pi * 0.1**2  # of each joint; as much stays outside at each two corners of the path
    assert bridges.area == pytest.approx(3 * (0.5 * 0.2 + round_ends) + (4 - math.pi) * 0.2**2, abs=0.003)


@pytest.mark.parametrize("tabs", [{"count": 4, "width_mm": 2.0}, {"spacing_mm": 75.0, "width_mm": 3.0}])
@pytest.mark.parametrize("process", ["plasma", "waterjet"])
def test_a_torch_pierces_anew_behind_each_tab_and_the_part_hangs_on_the_sheet(process: str, tabs: dict) -> None:
    path, answer = cut(given=setup(process), tabs=tabs)
    found = strokes(path)
    assert len(found) == 2 + 4 and answer.figures["pierces"] == 6
    assert (answer.figures["parts"], answer.figures["held_parts"], len(answer.parts)) == (0, 1, 1)
    assert all(one.dwell_s == DELAY_S for one in found)
    band = shapely.union_all([one.line.buffer(KERF_MM / 2.0, quad_segs=64) for one in found])
    left = shapely.box(-20, -20, 100, 80).difference(band)
    (held,) = (piece for piece in shapely.get_parts(left) if piece.contains(shapely.Point(5, 5)))
    assert held.contains(shapely.Point(-15, -15))
    part = answer.parts[0]
    assert band.intersection(part.buffer(-0.01)).area == 0.0  # chords of the arcs lie a trifle inside
    pierces = shapely.points([one.line.coords[0] for one in found])
    assert (shapely.distance(pierces, part) >= 2.0 - 0.001).all()
    ring = shapely.Polygon(part.exterior)
    bridges = ring.buffer(KERF_MM * 0.9).difference(ring.buffer(KERF_MM * 0.1)).difference(band)
    bridges = [piece for piece in shapely.get_parts(bridges) if piece.area > 0.2]
    widths = [piece.intersection(ring.buffer(KERF_MM / 2.0).exterior.buffer(0.01)).area / 0.02 for piece in bridges]
    assert widths == pytest.approx([tabs["width_mm"]] * 4, abs=0.1)


def test_the_checks_know_that_tabs_hold_a_part_and_that_pierces_keep_off_it() -> None:
    given = setup()
    for tabs, free in (({}, 1), ({"tabs": {"count": 3, "width_mm": 2.0}}, 0)):
        path, answer = cut(given=given, **tabs)
        cutting = Cutting(given.process, given.cut_data, answer.parts)
        verdict = sheet_verdict(CheckContext.of(path, load_machine("torch-table"), ""), cutting, given.tool, None)
        assert sum(one.shape.area > 2000.0 for one in verdict.free) == free and len(verdict.free) == 2 + free
        subject = CheckContext.of(path, load_machine("torch-table"), "")
        assert [one.code for one in sheet_findings(subject, verdict.cuts, verdict.freed)] == []
        nearer = replace(cutting, parts=[answer.parts[0].buffer(3.2)])
        moved = sheet_verdict(subject, nearer, given.tool, None)
        assert "pierce-on-part" in {one.code for one in sheet_findings(subject, moved.cuts, moved.freed)}


def test_a_tab_without_scrap_for_its_pierce_is_refused_with_its_place() -> None:
    close = [PLATE.moved(83.5 * x, 63.5 * y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    error = refusal("tab-lead", *close, tabs={"count": 2, "width_mm": 2.0})
    assert "pierce" in error.what and error.limit and error.advice
    with pytest.raises(CycleError, match="needs no tabs"):
        cut(PLATE, given=setup("drag-knife", 1.0), tabs={"count": 2})


def test_marks_come_first_with_their_own_power_and_spots_stand_for_a_time() -> None:
    mark = from_points([(30.0, 5.0), (50.0, 5.0)])
    given = setup("laser", 0.2, power_s=1000.0)
    path, answer = cut(given=given, marks=(mark,), mark_power=100.0, mark_feed_mm_min=500.0, spot_below_mm=20.0)
    assert [span.name for span in path.spans if span.kind == "contour"][:2] == ["spot 2", "mark 1"]
    assert sorted(set(powered(path))) == [0.0, 100.0, 1000.0]
    assert answer.figures["contours"] == 2
    spot = next(event for event in path.events if event.kind == "dwell")
    assert spot.value == 0.2 and path.table().end[spot.index - 1, :2] == pytest.approx([20.0, 30.0], abs=0.01)


def test_a_laser_cuts_in_passes_with_a_ramp_of_power_and_m4() -> None:
    given = setup("laser", 0.2, power_s=1000.0)
    path, answer = cut(HOLE, given=given, passes=3, dynamic_power=True, power_ramp={"length_mm": 4.0})
    assert {state.spindle for state in path.states} == {"off", "ccw"}
    powers = powered(path)[powered(path) > 0]
    assert powers[0] < 600.0 and powers[-1] == 1000.0 and (np.diff(powers) >= 0).all()
    assert answer.figures["cut_length_mm"] > 3 * math.tau * 7.9


def test_open_curves_are_cut_on_their_line_before_what_holds_them() -> None:
    slit = from_points([(20.0, 10.0), (60.0, 10.0)])
    path, _ = cut(PLATE, slit)
    assert [span.name for span in path.spans if span.kind == "contour"] == ["line 2", "part 1"]
    ends = path.table().end[rows_of(path, "line 2")][:, :2]
    assert slit.distances_mm(ends) == pytest.approx(0.0, abs=1e-9)


def test_a_drag_knife_leads_its_edge_by_the_blade_offset() -> None:
    path, _ = cut(PLATE, given=setup("drag-knife", 1.0), blade_offset_mm=0.5)
    table, rows = path.table(), rows_of(path, "part 1")
    assert table.end[rows, 2] == pytest.approx(-3.0) and (powered(path) == 0.0).all()
    arcs = rows[table.kind[rows] != LINE]
    assert len(arcs) == 4
    assert np.hypot(*(table.end[arcs, :2] - table.centre[arcs, :2]).T) == pytest.approx(0.5)
    corners = {tuple(np.round(centre, 6)) for centre in table.centre[arcs, :2]}
    assert corners == {(0.0, 0.0), (80.0, 0.0), (80.0, 60.0), (0.0, 60.0)}


def test_a_scribe_is_lowered_on_the_line_and_lifted_without_power_or_leads() -> None:
    mark = from_points([(30.0, 5.0), (50.0, 5.0)])
    path, answer = cut(PLATE, HOLE, given=setup("scribe"), marks=(mark,))
    table = path.table()
    assert (powered(path) == 0.0).all() and not path.events
    assert not any("lead" in span.kind for span in path.spans)
    assert [span.name for span in path.spans if span.kind == "contour"] == ["mark 1", "hole 2", "part 1"]
    for title, curve in (("hole 2", HOLE), ("part 1", PLATE), ("mark 1", mark)):
        rows = rows_of(path, title)
        assert table.end[rows, 2] == pytest.approx(-0.2) and curve.distances_mm(table.end[rows, :2]).max() < 1e-6
    sideways = (table.kind == RAPID) & (np.hypot(*(table.end - path.begins())[:, :2].T) > 1e-6)
    assert (table.end[sideways, 2] >= 2.0).all()
    deeper, _ = cut(PLATE, given=setup("scribe"), depth_mm=0.5)
    assert deeper.table().end[:, 2].min() == -0.5 and answer.figures["kerf_mm"] == 0.0
    with pytest.raises(CycleError) as refused:
        cut(PLATE, given=setup("scribe", has_z=False))
    assert refused.value.code == "process-z"


def test_a_lead_out_and_an_overcut_are_run_with_power() -> None:
    path, _ = cut(PLATE, lead_out={"kind": "line", "length_mm": 2.0, "angle_deg": 45.0}, overcut_mm=3.0)
    assert [span.kind for span in path.spans if "lead" in span.kind] == ["lead-in", "lead-out"]
    plain, _ = cut(PLATE)
    longer = sum(one.line.length for one in strokes(path)) - sum(one.line.length for one in strokes(plain))
    assert longer == pytest.approx(5.0, abs=0.001)


def test_curves_drawn_twice_are_cut_once_and_narrow_slots_are_told() -> None:
    slot = [(0, 0), (60, 0), (60, 40), (31, 40), (31, 20), (30, 20), (30, 40), (0, 40)]
    _, answer = cut(from_points(slot, closed=True), from_points(slot, closed=True))
    assert answer.figures["contours"] == 1
    assert "drawn twice" in answer.warnings[0] and "slot" in answer.warnings[1]


def test_no_rapid_leads_over_parts_that_are_free_where_there_is_a_way_round() -> None:
    _, answer = cut(*(PLATE.moved(100.0 * x, 80.0 * y) for x in range(3) for y in range(3)))
    assert answer.figures["rapids_over_free_parts"] == 0 and len(answer.parts) == 9


@pytest.mark.parametrize("curves, keys, code, limit", [
    ((PLATE, circle((40.0, 30.0), 0.7)), {}, "kerf-wide", "1.379"),
    ((PLATE, circle((40.0, 30.0), 1.5)), {}, "lead-room", "1.49"),
    ((PLATE, PLATE.moved(81.0, 0.0)), {}, "gap-narrow", "1.5"),
    ((PLATE, PLATE.moved(40.0, 10.0)), {}, "gap-narrow", "1.5"),
    ((from_points([(0, 0), (40, 30), (40, 0), (0, 30)], closed=True),), {}, "curve-crossing", ""),
    ((from_points([(0, 0), (0.001, 0)]),), {}, "curve-length", ""),
    ((PLATE,), {"lead_in": {"kind": "none"}}, "lead-none", "2"),
    ((PLATE,), {"power_ramp": {"length_mm": 2.0}}, "process-key", ""),
    ((PLATE,), {"blade_offset_mm": 0.5}, "process-key", ""),
])  # fmt: skip
def test_what_cannot_be_cut_is_refused_with_the_number_that_would_do(curves, keys, code: str, limit: str) -> None:
    with pytest.raises(CycleError) as refused:
        cut(*curves, **keys)
    assert refused.value.code == code and limit in refused.value.limit and refused.value.advice
    assert (refused.value.limit != "") == (limit != "")


def refusal(code: str, *curves: Curve, **keys: object) -> CycleError:
    with pytest.raises(CycleError) as refused:
        cut(*curves, **keys)
    assert refused.value.code == code
    return refused.value


def number_in(text: str, name: str) -> float:
    assert isinstance(text, Text)
    return float(text.values[name])


CLOSE = [PLATE.moved(85.0 * x, 65.0 * y) for x in (-1, 0, 1) for y in (-1, 0, 1)]


@pytest.mark.parametrize("curves, keys, code", [
    ((PLATE, circle((40.0, 30.0), 1.5)), {}, "lead-room"),
    ((PLATE, circle((20.0, 30.0), 1.5), circle((60.0, 30.0), 1.2)), {}, "lead-room"),  # both must fit
    (CLOSE, {"tabs": {"count": 2, "width_mm": 2.0}}, "tab-lead"),
])  # fmt: skip
def test_the_pierce_distance_that_is_named_would_do_and_no_larger_one(curves, keys, code: str) -> None:
    most_mm = number_in(refusal(code, *curves, **keys).limit, "most_mm")
    assert KERF_MM / 2.0 < most_mm < 2.0
    cut(*curves, pierce_mm=most_mm, **keys)
    refusal(code, *curves, pierce_mm=most_mm + 0.01, **keys)


def test_where_no_pierce_distance_does_the_scrap_that_would_is_named() -> None:
    close = [PLATE.moved(81.6 * x, 61.6 * y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
    error = refusal("tab-lead", *close, tabs={"count": 2, "width_mm": 2.0})
    scrap_mm = number_in(error.limit, "scrap_mm")
    assert scrap_mm == 2 * 2.0 + KERF_MM and "no smaller pierce_mm does" in error.advice
    apart_mm = scrap_mm + 0.01
    cut(*(PLATE.moved((80 + apart_mm) * x, (60 + apart_mm) * y) for x in (-1, 0, 1) for y in (-1, 0, 1)),
        tabs={"count": 2, "width_mm": 2.0})  # fmt: skip


def test_the_gap_and_the_kerf_that_are_named_would_do() -> None:
    advice = refusal("gap-narrow", PLATE, PLATE.moved(81.0, 0.0)).advice
    cut(PLATE, PLATE.moved(81.0 + number_in(advice, "more_mm"), 0.0), pierce_mm=0.75)
    cut(PLATE, PLATE.moved(81.0, 0.0), kerf_mm=number_in(advice, "gap_mm"))
    narrow = circle((40.0, 30.0), 0.7)
    error = refusal("kerf-wide", PLATE, narrow)
    cut(PLATE, narrow, kerf_mm=number_in(error.limit, "room_mm"), pierce_mm=0.1, lead_in={"kind": "none"})
    cut(PLATE, narrow, spot_below_mm=number_in(error.advice, "diameter_mm") + 0.001)


def test_the_joints_that_are_named_would_do() -> None:
    given, tabs = setup("laser", 0.2), {"count": 80, "width_mm": 2.0}
    advice = refusal("tab-room", PLATE, given=given, tabs=tabs).advice
    cut(PLATE, given=given, tabs=tabs | {"count": int(number_in(advice, "fewer"))})
    cut(PLATE, given=given, tabs=tabs | {"width_mm": number_in(advice.values["narrower"], "width_mm")})


@pytest.mark.parametrize("process", ["milling", "hot-wire"])
def test_other_processes_are_refused_by_name(process: str) -> None:
    given = replace(setup(), process=PROCESSES[process])
    with pytest.raises(CycleError, match="sheet_cut does not cut by"):
        cut(given=given)


def test_too_many_joints_and_joints_counted_twice_are_refused() -> None:
    with pytest.raises(CycleError) as refused:
        cut(PLATE, given=setup("laser", 0.2), tabs={"count": 200, "width_mm": 2.0})
    assert refused.value.code == "tab-room"
    with pytest.raises(ValidationError, match="either count or spacing_mm"):
        SheetCut(curves=(PLATE,), tabs={"count": 2, "spacing_mm": 20.0})
