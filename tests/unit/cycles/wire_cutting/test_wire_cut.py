# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire: where it comes in and goes out, holes and slits, corners, kerf, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import shapely
from shapely import Point, Polygon

from CNCStepper.cycles.cycle import Answer, Setup
from CNCStepper.cycles.wire_cutting.wire_cut import WireCut
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.state import Start, State
from CNCStepper.toolpath import LINE, RAPID, TableBuilder, Toolpath
from helpers.cycles.wire_judge import crosses_nowhere, holes_while_it_hangs, path_of

KERF_MM = 1.2
TOOL = Tool(number=1, shape="wire", diameter_mm=KERF_MM, feed_mm_min=300, plunge_mm_min=300)
ROW = CutData(
    process="hot-wire",
    material="eps",
    thickness_mm=20,
    feed_mm_min=300,
    kerf_mm=KERF_MM,
    pierce_delay_s=5.0,
)
SETUP = Setup(
    TOOL,
    10,
    2,
    rectangle((0, 0), (100, 60)),
    thickness_mm=20.0,
    process=PROCESSES["hot-wire"],
    cut_data=ROW,
    has_z=False,
    power_s=800.0,
)


def box(x: float, y: float, wide: float, high: float) -> Curve:
    return rectangle((x, y), (x + wide, y + high))


def cut(*curves: Curve, setup: Setup = SETUP, start: Start | None = None, **values: Any) -> tuple[Toolpath, Answer]:
    table = TableBuilder(start or Start(), State())
    answer = WireCut(tool=1, curves=curves, **values).cut(setup, table)
    return table.toolpath(), answer


def refused(code: str, *curves: Curve, setup: Setup = SETUP, **values: Any) -> CycleError:
    table = TableBuilder(Start(), State())
    with pytest.raises(CycleError) as caught:
        WireCut(tool=1, curves=curves, **values).cut(setup, table)
    assert caught.value.code == code, str(caught.value)
    assert not len(table.toolpath()), "rows before the refusal"
    return caught.value


@pytest.mark.parametrize(
    ("side", "axis", "place"), [("left", 0, -1.0), ("right", 0, 101.0), ("front", 1, -1.0), ("back", 1, 61.0)]
)
def test_it_comes_in_from_the_side_that_is_asked_for(side: str, axis: int, place: float) -> None:
    path, _ = cut(box(40, 25, 10, 10), enter_from=side)
    begin = path.table().end[0]
    assert abs(begin[axis] - place) < KERF_MM
    assert (begin[axis] < place) == (place < 0), "it begins outside of the sheet"
    assert np.allclose(path.table().end[-1], begin)


def test_without_a_side_it_takes_the_shortest_way_in() -> None:
    path, answer = cut(box(80, 25, 10, 10))
    assert path.table().end[0, 0] > 100.0
    assert answer.figures["link_mm"] == pytest.approx(2 * (101.7 - 90.6))


@pytest.mark.parametrize("off_mm", [-1e-12, 0.0, 1e-12])
def test_of_two_ways_in_as_short_rounding_does_not_choose(off_mm: float) -> None:
    part = box(40, 25 + off_mm, 20, 10)
    assert cut(part)[0].table().end[0, 1] < 0.0


def test_it_leaves_on_the_shortest_way_to_an_edge() -> None:
    parts = (box(10, 25, 10, 10), box(80, 8, 10, 10))
    path, answer = cut(*parts, enter_from="left", leave="edge")
    assert path.table().end[-1, 1] < 0.0
    assert answer.figures["link_mm"] < cut(*parts, enter_from="left")[1].figures["link_mm"] - 30.0


def test_power_and_heat_come_before_the_first_feed_and_end_after_the_last() -> None:
    path, _ = cut(box(40, 25, 10, 10))
    table = path.table()
    assert table.kind.tolist().count(RAPID) == 1
    assert table.kind[0] == RAPID
    assert [path.states[state].spindle for state in table.state] == ["off"] + ["cw"] * (len(table) - 1)
    assert {path.states[state].spindle_rpm for state in table.state[1:]} == {800.0}
    assert [(event.index, event.kind, event.value) for event in path.events] == [(1, "dwell", 5.0)]
    assert path.states[-1].spindle == "off"


def test_corners_wait_by_their_angle() -> None:
    _, answer = cut(box(40, 25, 10, 10), corner_dwell_s=0.8)
    assert answer.figures["corner_dwells"] == 5  # four corners, and the end
    assert answer.figures["corner_dwell_s"] == pytest.approx(5 * 0.8 * 90 / 180)
    _, blunt = cut(circle((50, 30), 10), corner_dwell_s=0.8)
    assert blunt.figures["corner_dwells"] == 1
    _, none = cut(box(40, 25, 10, 10), corner_dwell_s=0.8, corner_angle_deg=120)
    assert none.figures["corner_dwells"] == 0


def test_the_wire_is_slow_before_and_behind_corners() -> None:
    path, answer = cut(box(40, 25, 10, 10), corner_distance_mm=2.0, corner_feed_share=0.5)
    table, begins = path.table(), path.begins()
    feeds, lengths = np.round(table.feed / TOOL.feed_mm_min, 6), np.hypot(*(table.end - begins)[:, :2].T)
    (contour,) = (span for span in path.spans if span.kind == "contour")
    rows = np.arange(contour.first, contour.last)
    slow = rows[feeds[rows] == 0.5]
    assert set(feeds[rows]) == {0.5, 1.0} and set(feeds[table.kind != RAPID]) == {0.5, 1.0}
    straight = slow[table.kind[slow] == LINE]
    assert lengths[straight].sum() == pytest.approx(4 * 2 * 2.0, abs=1e-6)  # four corners; it begins at one
    corners = np.array([(40.0, 25.0), (50.0, 25.0), (50.0, 35.0), (40.0, 35.0)])
    arcs = rows[table.kind[rows] != LINE]
    assert len(arcs) == 4 and (feeds[arcs] == 0.5).all()
    ends = np.concatenate([begins[slow, :2], table.end[slow, :2]])
    nearest = np.hypot(*(ends[:, None] - np.vstack([corners, begins[rows[:1], :2]])).T).min(axis=0)
    assert nearest.max() < np.hypot(2.0, KERF_MM / 2.0) + 1e-6
    round_mm = 4 * np.pi / 2 * KERF_MM / 2
    assert answer.figures["corner_slow_mm"] == pytest.approx(4 * 2 * 2.0 + round_mm, abs=1e-6)


def test_a_slow_corner_stands_too_and_short_sides_are_slow_all_along() -> None:
    path, both = cut(box(40, 25, 10, 10), corner_distance_mm=2.0, corner_feed_share=0.5, corner_dwell_s=0.8)
    assert (both.figures["corner_dwells"], len(path.events)) == (5, 5 + 1)  # one until the wire is hot
    _, short = cut(box(40, 25, 3, 3), corner_distance_mm=2.0, corner_feed_share=0.5)
    ring_mm = 4 * 3.0 + 2 * np.pi * KERF_MM / 2
    assert short.figures["corner_slow_mm"] == pytest.approx(ring_mm, abs=1e-6)
    _, round_one = cut(circle((50, 30), 10), corner_distance_mm=2.0, corner_feed_share=0.5)
    assert round_one.figures["corner_slow_mm"] == pytest.approx(4.0, abs=1e-6)  # begin and end alone
    _, blunt = cut(box(40, 25, 10, 10), corner_distance_mm=2.0, corner_feed_share=0.5, corner_angle_deg=120)
    assert blunt.figures["corner_slow_mm"] == 0.0


def test_the_kerf_is_the_tools_unless_the_cut_has_its_own() -> None:
    thin = replace(SETUP, tool=TOOL.model_copy(update={"diameter_mm": 0.8}))
    assert cut(box(40, 25, 10, 10))[1].figures["kerf_mm"] == KERF_MM
    assert cut(box(40, 25, 10, 10), setup=thin)[1].figures["kerf_mm"] == 0.8
    assert cut(box(40, 25, 10, 10), setup=thin, kerf_mm=1.0)[1].figures["kerf_mm"] == 1.0


def test_a_hole_is_refused_without_a_slit_and_cut_through_one() -> None:
    curves = (box(30, 15, 40, 30), circle((45, 30), 8))
    error = refused("wire-hole", *curves)
    assert "entry_slit = true" in error.advice
    assert "X45.000 Y30.000" in error.what
    path, answer = cut(*curves, entry_slit=True)
    slits = [span for span in path.spans if span.kind == "slit"]
    assert len(slits) == 2
    table, begins = path.table(), path.begins()
    there, back = slits
    assert np.allclose(begins[there.first, :2], table.end[back.first, :2])
    assert np.allclose(begins[back.first, :2], table.end[there.first, :2])
    part = Polygon(curves[0].points(0.001)).difference(Polygon(curves[1].points(0.001)))
    assert part.difference(answer.parts[0]).area == pytest.approx(KERF_MM * 7.0, abs=0.3)


def test_what_lies_in_a_hole_falls_before_what_is_round_it() -> None:
    curves = (box(20, 5, 60, 50), circle((50, 30), 20), box(45, 25, 10, 10))
    _, answer = cut(*curves, entry_slit=True)
    assert [round(part.area) for part in answer.parts] == [100, pytest.approx(3000 - 400 * np.pi, abs=30)]


HOLES_AT = {
    # a way to the part behind runs round this one, nearer than a kerf; the slit leads to that way
    "a way": (box(25, 15, 40, 30), circle((45, 22), 5), box(75, 47, 10, 10)),
    # the slit is at the sheet's edge, behind all sides that hold the part
    "the edge": (box(30, 0, 40, 30), circle((58, 8), 4)),
    # two slits at the edge, on both sides of the place where the ring begins
    "the edge, two": (
        from_points([(30, 0.3), (50, 0), (70, 0.3), (70, 30), (30, 30)], closed=True),
        circle((40, 8), 4),
        circle((60, 8), 4),
    ),
}


@pytest.mark.parametrize("where", HOLES_AT)
def test_holes_are_cut_while_the_part_hangs(where: str) -> None:
    curves = HOLES_AT[where]
    side = "front" if where == "the edge, two" else "left"
    path, answer = cut(*curves, enter_from=side, entry_slit=True)
    sheet = Polygon(SETUP.stock.points(0.001))  # type: ignore[union-attr]
    wire = path_of(path)
    assert holes_while_it_hangs(wire, answer, sheet) == 2 * sum(curve.bulge.any() for curve in curves)
    crosses_nowhere(wire)
    part = answer.parts[-1].boundary
    far_mm = shapely.distance(shapely.union_all(wire.lines), shapely.points(shapely.get_coordinates(part)))
    assert far_mm.max() < KERF_MM / 2.0 + 0.02, "the ring is not whole"


def test_a_ring_of_parts_is_not_closed_before_the_part_in_it_is_cut() -> None:
    gap = KERF_MM + 0.2
    ring = (box(20, 5, 60, 8), box(20, 13 + gap, 8, 40), box(28 + gap, 45, 52 - gap, 8 + gap), box(72, 13 + gap, 8, 26))
    _, answer = cut(*ring, circle((50, 28), 6))
    middle = next(number for number, part in enumerate(answer.parts) if part.contains(Point(50, 28)))
    assert middle < len(answer.parts) - 1


def test_an_open_line_is_cut_there_and_back() -> None:
    line = from_points([(40, 30), (60, 35)])
    path, answer = cut(line)
    assert answer.figures["lines"] == 1
    length_mm = sum(2 * [line.length_mm])
    ways = [span for span in path.spans if span.kind == "contour"]
    rows = path.table().end[:, :2] - path.begins()[:, :2]
    run_mm = sum(np.hypot(*rows[span.first : span.last].T).sum() for span in ways)
    assert run_mm == pytest.approx(length_mm)


def test_a_known_start_goes_round_the_sheet() -> None:
    start = Start(position_mm=(-20.0, 30.0, 0.0))
    path, answer = cut(box(80, 25, 10, 10), start=start)
    rapids = path.table().end[path.table().kind == RAPID][:, :2]
    ways = np.vstack([[(-20.0, 30.0)], rapids])
    sheet = Polygon(SETUP.stock.points(0.01))  # type: ignore[union-attr]
    assert len(rapids) > 1
    assert not any(sheet.intersects(Polygon([*pair, pair[0]]).boundary) for pair in pairwise(ways))
    assert not answer.warnings


def test_a_start_over_the_sheet_is_told() -> None:
    _, answer = cut(box(80, 25, 10, 10), start=Start(position_mm=(50.0, 50.0, 0.0)))
    assert any("over the sheet" in warning for warning in answer.warnings)


def test_a_hot_wire_on_the_edge_comes_off_it_by_a_feed() -> None:
    path, answer = cut(box(80, 25, 10, 10), start=Start.at_zero())
    table = path.table()
    assert table.kind[0] != RAPID
    assert answer.removals[0].region.intersects(Polygon([(0, 0), (0.1, 0), (0, 0.1)]))


def test_with_a_z_axis_it_comes_down_beside_the_sheet() -> None:
    path, _ = cut(box(80, 25, 10, 10), setup=replace(SETUP, has_z=True))
    heights = path.table().end[:, 2]
    assert heights[0] == heights[-1] == SETUP.clearance_mm
    assert (heights[1:-1] == 0.0).all()


def test_parts_too_close_are_told_the_kerf_that_would_do() -> None:
    error = refused("wire-gap", box(20, 20, 20, 20), box(41, 20, 20, 20))
    assert error.value == "1.000 mm"
    assert "at most 1.000 mm" in error.advice
    assert "0.200 mm farther" in error.advice
    cut(box(20, 20, 20, 20), box(41, 20, 20, 20), kerf_mm=1.0)
    cut(box(20, 20, 20, 20), box(41.2, 20, 20, 20))


def test_a_hole_narrower_than_the_kerf_is_told_the_kerf_that_would_do() -> None:
    curves = (box(30, 15, 40, 30), box(40, 25, 10, 0.9))
    error = refused("kerf-wide", *curves, entry_slit=True)
    most_mm = float(error.limit.split()[0])
    assert most_mm == pytest.approx(0.9, abs=0.01)
    cut(*curves, entry_slit=True, kerf_mm=0.89)


def test_a_throat_that_the_kerf_closes_is_refused() -> None:
    throat = [
        (30, 15),
        (70, 15),
        (70, 29.5),
        (50, 29.5),
        (50, 22),
        (40, 22),
        (40, 38),
        (50, 38),
        (50, 30.5),
        (70, 30.5),
    ]
    curve = from_points([*throat, (70, 30.5), (70, 45), (30, 45)], closed=True)
    error = refused("kerf-wide", curve)
    assert float(error.limit.split()[0]) == pytest.approx(1.0, abs=0.01)
    cut(curve, kerf_mm=0.98)


def test_no_way_between_parts_is_told_the_margin_that_would_do() -> None:
    walls = (box(10, 5, 80, 10), box(10, 45, 80, 10), box(10, 18, 10, 24), box(80, 18, 10, 24), box(40, 25, 20, 10))
    error = refused("wire-way", *walls, margin_mm=2.0)
    would_do = float(error.advice.split("at most ")[1].split(",")[0])
    assert would_do < 2.0
    cut(*walls, margin_mm=would_do)


def test_parts_beyond_the_sheet_and_lines_into_parts_are_refused() -> None:
    assert refused("wire-sheet", box(95, 20, 10, 10)).value == "5.000 mm beyond"
    assert refused("wire-line", box(40, 20, 20, 20), from_points([(10, 30), (45, 30)])).value == "0.000 mm away"


def test_other_tools_no_feed_and_long_stands_are_refused() -> None:
    jet = TOOL.model_copy(update={"shape": "jet"})
    refused("tool-shape", box(40, 25, 10, 10), setup=replace(SETUP, tool=jet))
    still = TOOL.model_copy(update={"feed_mm_min": 0.0})
    refused("feed-missing", box(40, 25, 10, 10), setup=replace(SETUP, tool=still))
    assert refused("wire-dwell", box(40, 25, 10, 10), corner_dwell_s=3.0).limit == "2 s"
    refused("outline-empty", from_points([(10, 10), (20, 10)], closed=True))


def test_a_slot_narrower_than_the_wire_is_warned_of() -> None:
    slot = [(40, 20), (60, 20), (60, 40), (50.4, 40), (50.4, 30), (49.6, 30), (49.6, 40), (40, 40)]
    _, answer = cut(from_points(slot, closed=True))
    assert answer.corners
    assert any("stays" in warning for warning in answer.warnings)
