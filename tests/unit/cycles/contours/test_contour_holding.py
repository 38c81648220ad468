# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tabs hold the part as wide and as high as asked, and leads touch nothing that is to stay: measured by shapely."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, StockForm, load_job
from CNCStepper.job.prove import prove_job
from CNCStepper.machine.profile import load_machine
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID, TableBuilder, Toolpath
from helpers.cycles.ellipse_judge import runs
from helpers.cycles.product_verdict import Verdict, cut, judged, tool
from helpers.cycles.sweep_judge import swept

BOX = from_points([(-20, -15), (20, -15), (20, 15), (-20, 15)], closed=True)
ELL = from_points([(-25, -20), (25, -20), (25, 0), (5, 0), (5, 20), (-25, 20)], closed=True)
TABS = {"count": 4, "width_mm": 5.0, "height_mm": 1.5}
ARC = {"kind": "arc", "radius_mm": 4.0}
R = 3.0
JOBS = Path(__file__).parents[4] / "examples" / "jobs" / "cycles"
ROUND = [circle((0, 0), 15), BOX, ELL, Curve(BOX.xy, np.array([0.0, 0.5, 0.0, -0.2]))]


def contour(*curves: Curve, **changes: object) -> Contour:
    return Contour(**({"tool": 1, "curves": curves or (BOX,), "depth_mm": 4.0, "stepdown_mm": 1.5} | changes))


def bridges(path: Toolpath, curve: Curve, z_mm: float) -> list[BaseGeometry]:
    """Return what stands at a height in the band round a part, one piece for each tab."""
    part = shapely.Polygon(curve.points(1e-4))
    around = part.buffer(2 * R - 0.02, quad_segs=90).difference(part.buffer(0.02, quad_segs=90))
    pieces = shapely.get_parts(around.difference(swept(path, R, z_mm)))
    far = part.buffer(2 * R - 0.03, quad_segs=90)
    return [piece for piece in pieces if piece.area > 0.5 and not far.covers(piece)]  # no bridge: rests in corners


def narrow_mm(bridge: BaseGeometry, others: list[BaseGeometry], curve: Curve) -> float:
    """Return how wide a bridge is at its narrowest: shrunk by half of that it still holds the part."""
    part = shapely.Polygon(curve.points(1e-4))
    outside = part.buffer(30.0).difference(part.buffer(2 * R - 0.05, quad_segs=90))
    solid = shapely.union_all([part.buffer(0.05), outside, bridge])
    low, high = 0.0, 20.0
    for _ in range(12):
        middle = (low + high) / 2
        holds = shapely.get_num_geometries(solid.buffer(-middle / 2, quad_segs=32)) == 1
        low, high = (middle, high) if holds else (low, middle)
    return low


@pytest.mark.slow
@pytest.mark.parametrize("shape", range(len(ROUND)))
@pytest.mark.parametrize(
    "changes", [{}, {"ramp_deg": 4.0, "lead_in": ARC, "lead_out": ARC}, {"finish_stepover_mm": 0.5}]
)
def test_tabs_stand_as_wide_and_high_as_asked(shape: int, changes: dict) -> None:
    curve = ROUND[shape]
    found = judged(contour(curve, tabs=TABS, **changes), tool(2 * R), thick_mm=4.0)
    assert found.clean and max(found.gouge_mm, found.left_mm) <= 0.01
    low, high = (bridges(found.toolpath, curve, z_mm) for z_mm in (-4.0, -2.5))
    assert len(low) == 4 and high == [] and found.answer.figures["tabs"] == 4
    assert bridges(found.toolpath, curve, -2.51) != []
    for bridge in low:
        assert 5.0 <= narrow_mm(bridge, low, curve) + 0.01 <= 5.6


def test_tabs_on_a_box() -> None:
    path, answer = cut(contour(tabs=TABS))
    assert len(bridges(path, BOX, -4.0)) == 4 and answer.figures["tabs"] == 4
    assert all(5.0 <= narrow_mm(one, [], BOX) + 0.01 <= 5.1 for one in bridges(path, BOX, -4.0))
    lifted = {round(float(run.xyz[0, 2]), 9) for run in runs(path)[2:] if run.kind != RAPID and run.run_mm}
    assert lifted == {round(-4 / 3, 9), round(-8 / 3, 9), -4.0, -2.5}  # only below the tabs' top they are spared


@pytest.mark.parametrize("curve", [BOX, ELL])
def test_no_tab_stands_on_a_corner_or_at_the_entry(curve: Curve) -> None:
    path, _ = cut(contour(curve, tabs={"count": 6, "width_mm": 3.0, "height_mm": 1.0}, lead_in=ARC, lead_out=ARC))
    standing = bridges(path, curve, -4.0)
    corners = shapely.MultiPoint(curve.xy)
    entry = shapely.Point(next(run.xyz[-1, :2] for run in runs(path)[2:]))
    for bridge in standing:
        foot = bridge.intersection(shapely.LinearRing(curve.xy).buffer(0.1))
        assert foot.distance(corners) > 0 and bridge.distance(entry) >= R


def test_tabs_are_never_farther_apart_than_their_spacing() -> None:
    path, answer = cut(contour(circle((0, 0), 30), tabs={"spacing_mm": 50.0, "width_mm": 4.0, "height_mm": 1.0}))
    assert answer.figures["tabs"] == math.ceil(2 * math.pi * 33 / 50)
    places = sorted(math.atan2(one.centroid.y, one.centroid.x) for one in bridges(path, circle((0, 0), 30), -4.0))
    assert max(np.diff([*places, places[0] + 2 * math.pi])) * 33 < 55


def test_tabs_that_do_not_fit_are_told() -> None:
    _, answer = cut(contour(tabs={"count": 12, "width_mm": 8.0, "height_mm": 1.0}))
    fit = int(answer.figures["tabs"])
    assert 0 < fit < 12 and answer.warnings[0].startswith(f"{fit} of 12 tabs fit")


def test_small_holes_go_without_tabs_but_say_so() -> None:
    _, answer = cut(contour(BOX, circle((0, 0), 4.0), tabs=TABS))
    assert answer.figures["tabs"] == 4 and answer.warnings[0].startswith("0 of 4 tabs fit on the contour that begins")


def test_the_tool_comes_down_beside_a_tab_at_the_plunge_feed() -> None:
    path, _ = cut(contour(tabs=TABS, ramp_deg=3.0), tool(plunge_mm_min=77.0))
    straight = [run for run in runs(path)[2:] if run.kind != RAPID and not run.run_mm]
    assert len(straight) > 8 and {run.feed_mm_min for run in straight} == {77.0}


def lead_room_mm(found: Verdict | tuple[Toolpath, Answer], walls: list[Curve]) -> float:
    """Return how near the tool's rim comes to walls, below the stock's top; negative inside them."""
    path = found.toolpath if isinstance(found, Verdict) else found[0]
    below = [run.xyz[:, :2] for run in runs(path)[2:] if run.xyz[:, 2].min() < -1e-9]
    lines = shapely.MultiLineString([shapely.LineString(xy) if len(xy) > 1 else xy for xy in below])
    return min(shapely.LineString(wall.points(1e-4)).distance(lines) for wall in walls) - R


def with_keep(operation: Contour, *keep: Curve) -> tuple[Toolpath, Answer]:
    table = TableBuilder(Start())
    answer = operation.cut(Setup(tool(2 * R), 10.0, 2.0, keep=keep), table)
    return table.toolpath(), answer


@pytest.mark.parametrize(
    "lead", [ARC, {"kind": "line", "length_mm": 5.0}, {"kind": "line", "length_mm": 6.0, "angle_deg": 30}]
)
@pytest.mark.parametrize("direction", ["climb", "conventional"])
def test_leads_move_to_where_the_neighbours_leave_room(lead: dict, direction: str) -> None:
    """Parts beside each long side leave the cut itself room, but no lead; above one short side there is room."""
    neighbours = [BOX.moved(0, 36.1), BOX.moved(0, -36.1), BOX.moved(46.1, 0)]
    alone, beside = (
        with_keep(contour(lead_in=lead, lead_out=lead, direction=direction), *keep) for keep in ([], neighbours)
    )
    assert lead_room_mm(alone, neighbours) < 0 <= lead_room_mm(beside, [BOX, *neighbours]) + 0.01
    assert beside[1].warnings == []


def test_leads_are_made_smaller_where_they_must() -> None:
    hole = circle((0, 0), 6.0)
    found = with_keep(contour(hole, side="inside", lead_in=ARC, lead_out=ARC))
    assert lead_room_mm(found, [hole]) >= -0.01 and "made smaller" in found[1].warnings[0]


def test_leads_that_fit_nowhere_name_the_closest_obstacle() -> None:
    ring = circle((0, 0), 15 + 2 * R + 0.1)
    with pytest.raises(CycleError) as caught:
        with_keep(contour(circle((0, 0), 15), lead_in=ARC), ring)
    assert caught.value.code == "lead-room" and "a part of another operation at X" in caught.value.what
    assert caught.value.value and caught.value.limit


def test_a_cut_into_a_neighbour_is_told() -> None:
    near, far = (with_keep(contour(), BOX, BOX.moved(40 + gap_mm, 0))[1].warnings for gap_mm in (5.9, 6.1))
    told = "the cut goes into 1 outline(s) that other contours leave standing, most at X25.900 Y-15.000, by 0.100 mm"
    assert near == [told] and far == []


def test_no_dog_bone_is_cut_where_the_tool_only_turns_before_a_gap() -> None:
    """Between the plate's long edge and the island's tip a gap stays: what is seen there is no corner of a wall."""
    plate = from_points([(0, 0), (60, 0), (60, 40), (0, 40)], closed=True)
    island = from_points([(20, 20), (58, 19), (20, 30)], closed=True)
    path, answer = cut(contour(plate, island, side="inside", dogbones="side"), tool(2 * R))
    tip = shapely.Polygon(island.points(1e-4)).buffer(-0.01)
    assert swept(path, R, -4.0).intersection(tip).area == 0.0
    assert any("2 gap(s) between walls" in told for told in answer.warnings)


@pytest.mark.slow
@pytest.mark.parametrize("count", [3, 4, 5])
def test_no_tab_keeps_a_neighbours_dog_bone_from_being_cut(count: int) -> None:
    """A disc in the notch of an L, so near that a tab on its lower left would stand before the L's inside corner."""
    tabs = {"count": count, "width_mm": 1.0, "height_mm": 1.5}
    found = judged(contour(ELL, circle((16.1, 11.1), 5.0), dogbones="corner", tabs=tabs), tool(2 * R))
    assert found.clean and max(found.gouge_mm, found.left_mm) <= 0.01
    corner = shapely.Point(5.0, 0.0).buffer(0.01)
    assert swept(found.toolpath, R, -4.0).covers(corner.difference(shapely.Polygon(ELL.xy)))
    assert found.answer.figures["tabs"] >= 2 * count - 1


def test_a_dog_bone_into_a_neighbour_is_told() -> None:
    beyond = circle((22, 17), 3.0)  # 0.17 mm within reach of the dog-bone in the corner
    told, bare = (
        with_keep(contour(side="inside", dogbones=kind), BOX, beyond)[1].warnings for kind in ("corner", "none")
    )  # the box itself is another operation's outline too: its corners are to be cut
    assert any("1 outline(s) that other contours leave standing" in one and "by 0.1" in one for one in told), told
    assert not any("leave standing" in one for one in bare)


def beside_part(operation: Contour, *parts: tuple[Curve, ...]) -> Answer:
    return operation.cut(Setup(tool(2 * R), 10.0, 2.0, parts=parts), TableBuilder(Start()))


def test_a_cut_into_the_part_of_another_contour_is_refused_with_place_and_depth() -> None:
    with pytest.raises(CycleError) as caught:
        beside_part(contour(), (BOX.moved(45, 0),))
    assert caught.value.code == "part-cut" and caught.value.value == "1.000 mm deep"
    assert "X25.000 Y" in caught.value.what and caught.value.advice
    with pytest.raises(CycleError) as caught:
        beside_part(contour(), (BOX.moved(41, 0),))  # the tool's centre runs inside the other part
    assert caught.value.value == "5.000 mm deep"
    assert beside_part(contour(), (BOX.moved(46, 0),)).figures["contours"] == 1


def test_a_part_within_a_hole_is_kept_and_features_of_a_part_are_cut() -> None:
    large = from_points(BOX.xy[:-1] * 2.0, closed=True)
    inside = contour(large, side="inside")
    with pytest.raises(CycleError) as caught:
        beside_part(inside, (BOX.moved(16, 0),))  # 4 mm from the hole's wall
    assert caught.value.code == "part-cut" and caught.value.value == "2.000 mm deep"
    assert beside_part(inside, (BOX,)).figures["contours"] == 1
    for feature in (contour(), contour(circle((0, 0), 9.0), side="inside"), contour(BOX, side="on")):
        assert beside_part(feature, (large,)).figures["contours"] == 1  # a tenon, a hole and a groove of a plate


def test_tabs_are_spread_over_all_sides_before_they_avoid_corners() -> None:
    box = from_points([(20, 20), (70, 20), (70, 60), (20, 60)], closed=True)
    tabs = {"count": 4, "width_mm": 5.0, "height_mm": 2.0}
    path, answer = cut(contour(box, side="inside", dogbones="corner", tabs=tabs, ramp_deg=2.0))
    part = shapely.Polygon(box.xy)
    standing = part.difference(part.buffer(-2 * R + 0.02)).difference(swept(path, R, -4.0))
    places = np.array([each.centroid.coords[0] for each in shapely.get_parts(standing) if each.area > 15.0])
    assert answer.figures["tabs"] == len(places) == 4
    for axis, low, high in ((0, 20, 70), (1, 20, 60)):
        assert sorted(((places[:, axis] < low + 2 * R).sum(), (places[:, axis] > high - 2 * R).sum())) == [1, 1]
    corners = shapely.MultiPoint(box.xy)
    assert min(shapely.distance(corners, shapely.points(places))) > 10.0


def test_a_line_ahead_of_a_thin_wall_does_not_jump_over_it() -> None:
    """A lead whose ends are free but whose middle crosses a sheet of 0.01 mm."""
    thin = from_points([(-40, 22), (40, 22), (40, 22.01), (-40, 22.01)], closed=True)
    lead = {"kind": "line", "length_mm": 14.0}
    path, _ = with_keep(contour(lead_in=lead), thin, thin.moved(0, -44.01))
    assert lead_room_mm((path, _), [thin, BOX]) >= -0.01


@pytest.mark.slow
@pytest.mark.parametrize("lead", [ARC, {"kind": "line", "length_mm": 5.0, "angle_deg": 45}])
def test_leads_are_judged_with_the_contour(lead: dict) -> None:
    found = judged(contour(ELL, circle((-12, 0), 8), lead_in=lead, lead_out=lead, overcut_mm=1.0, ramp_deg=3.0))
    assert found.clean and max(found.gouge_mm, found.left_mm) <= 0.01
    assert lead_room_mm(found, [ELL, circle((-12, 0), 8)]) >= -0.01


def test_a_job_tells_a_contour_of_the_others_and_of_the_stock() -> None:
    job, _ = load_job(JOBS / "contour.toml")
    tenon, holes, outline = job.operation
    setup = job.setup(outline)
    assert setup.keep == (*tenon.curves, *holes.curves) and setup.thickness_mm == 6.0
    assert job.setup(holes).parts == (outline.curves,) and setup.parts == ()  # no other one runs outside
    assert setup.stock == from_points([(0, 0), (150, 0), (150, 100), (0, 100)], closed=True)


@pytest.mark.slow
def test_the_example_is_cut_as_drawn() -> None:
    job, machine = load_job(JOBS / "contour.toml")
    proof = prove_job(job, machine, make_program(job, machine).program)
    assert not proof.refused and {finding.code for finding in proof.findings} == {
        "place-unknown",
        "not-exact",
        "below-stock",
    }
    assert proof.report["gouge_mm"] <= 0.01 and proof.report["left_over_mm"] <= 0.01
    told = [finding.text for finding in proof.findings if finding.code == "not-exact"]
    assert sum("sets a piece free" in text for text in told) == 2  # the holes; the outline has tabs


LOOSE = [("outside", None, 1), ("outside", TABS, 0), ("inside", None, 0)]


@pytest.mark.parametrize(("side", "tabs", "told"), LOOSE)
def test_a_cut_into_a_piece_that_is_loose_is_told_with_both_operations(side, tabs, told):
    through = contour(side=side, depth_mm=5.0, stepdown_mm=2.5, tabs=tabs)
    beside = contour(circle((0, 0), 30.0), side="on", depth_mm=1.0, stepdown_mm=1.0)
    mark = contour(circle((13, 8), 2.0) if side == "outside" else circle((13, 13), 1.0), side="on", depth_mm=1.0)
    keys = {"machine": "table-a", "clearance_mm": 10.0, "retract_mm": 2.0, "tool": (tool(6),)}
    job = Job(**keys, stock=StockForm(size_mm=(90, 90, 5), origin="top-centre"), operation=(through, beside, mark))
    machine = load_machine("table-a")
    found = prove_job(job, machine, make_program(job, machine).program).findings
    loose = [finding for finding in found if finding.code == "piece-loose"]
    assert len(loose) == told
    for finding in loose:
        assert "operation 3 (contour) cuts into a piece that operation 1 (contour) has set free" in finding.text
        assert math.dist(finding.place_mm, (13, 8)) < 6.0 and finding.severity == "warning"
        assert " mm" in str(finding).split("(at ")[1]


@pytest.mark.parametrize(("x_mm", "told"), [(0.0, 0), (16.0, 1), (60.0, 0)])
@pytest.mark.parametrize("elliptical", [False, True])
def test_a_pocket_through_the_edge_of_a_part_is_told_with_its_place(x_mm, told, elliptical):
    levels = {"tool": 1, "depth_mm": 1.0, "stepdown_mm": 1.0, "stepover_mm": 2.0}
    pocket = Pocket(outlines=(circle((x_mm, 0), 8),), **levels)
    if elliptical:
        pocket = EllipticalPocket(centre_mm=(x_mm, 0), radius_x_mm=8, radius_y_mm=6, **levels)
    keys = {"machine": "table-a", "clearance_mm": 10.0, "retract_mm": 2.0, "tool": (tool(6),)}
    job = Job(**keys, stock=StockForm(size_mm=(150, 90, 5), origin="top-centre"), operation=(pocket, contour()))
    warnings = make_program(job, load_machine("table-a")).answers[0].warnings
    edges = [warning for warning in warnings if "through the edge of a part" in warning]
    assert len(edges) == told and all("at X20.000 Y" in warning for warning in edges)
