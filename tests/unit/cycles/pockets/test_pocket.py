# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pocket: the plate's one, entries in any room, links over what is cut, odd shapes, and refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import LineString, buffer, difference, get_parts, union_all
from shapely import box as rectangle

from CNCStepper.cycles.clearing.reachable_regions import corners_of
from CNCStepper.cycles.cycle import Answer
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.errors import CNCStepperError, CycleError, GeometryError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.curve_columns import complex_of, xy_of
from CNCStepper.toolpath import RAPID, Toolpath
from helpers.cycles.product_verdict import cut, tool
from helpers.cycles.random_pockets import box, slot
from helpers.cycles.sweep_judge import Wanted, flattened, gouge_mm, left_mm, rows_of, swept

OUTLINE = [(30, 25), (70, 22), (85, 40), (120, 30), (130, 60), (100, 85), (60, 70), (35, 85)]
ISLANDS = (circle((60, 48), 7), from_points([(90, 50), (104, 48), (106, 62), (92, 64)], True))
KEYS = {"tool": 1, "depth_mm": 1.0, "stepdown_mm": 1.0, "stepover_mm": 2.4}
TOLERANCE_MM = 0.0105


def plate(**changes: object) -> Pocket:
    return Pocket(**(KEYS | {"outlines": [from_points(OUTLINE, True)], "islands": ISLANDS, "depth_mm": 4.0} | changes))


def odd(*outlines: Curve, **changes: object) -> Pocket:
    return Pocket(**(KEYS | {"outlines": outlines} | changes))


def require_exact(path: Toolpath, answer: Answer, radius_mm: float = 3.0) -> None:
    """Assert that what is wanted and can be reached is gone at the bottom, and nothing else."""
    (removal,) = answer.removals
    assert gouge_mm(path, radius_mm, [Wanted(removal.region, removal.bottom_mm)]) <= TOLERANCE_MM
    assert left_mm(removal.reachable, swept(path, radius_mm, removal.bottom_mm)) <= TOLERANCE_MM


def lifts(path: Toolpath) -> int:
    """Return how often the tool comes down to the retract height."""
    table, begins = path.table(), path.begins()
    return int(((table.kind == RAPID) & (table.end[:, 2] < begins[:, 2])).sum())


def spans(path: Toolpath, kind: str) -> list:
    return sorted((span for span in path.spans if span.kind == kind), key=lambda span: span.first)


def test_the_plates_pocket_is_one_run_with_one_entry_a_level() -> None:
    path, answer = cut(plate(stepdown_mm=2.0))
    require_exact(path, answer)
    assert lifts(path) <= 2 and [span.name for span in spans(path, "entry")] == ["helix", "helix"]
    assert answer.figures["levels"] == 2 and answer.figures["ap_mm"] == 2.0 and answer.figures["rooms"] == 1
    assert len(path) < 340


def test_corners_that_the_tool_cannot_reach_are_told_with_their_size() -> None:
    _, answer = cut(odd(box(0, 0, 30, 20)))
    figures = answer.figures
    assert figures["rest_corners"] == 4
    assert figures["rest_corner_mm"] == pytest.approx(3 * (math.sqrt(2) - 1), abs=1e-3)
    assert figures["rest_area_mm2"] == pytest.approx(4 * 9 * (1 - math.pi / 4), abs=0.02)
    assert "4 corners" in answer.warnings[0] and answer.warnings[0].count("1.243 mm (1.933 mm²) at X") == 4
    assert {tuple(np.round(corner.place_mm, 2)) for corner in answer.corners} == {(0, 0), (30, 0), (30, 20), (0, 20)}
    assert cut(odd(slot(40, 20)))[1].warnings == []


def test_corners_that_slivers_along_the_wall_join_are_told_apart() -> None:
    wanted = rectangle(0, 0, 30, 20)
    reached = rectangle(0.004, 0.004, 29.996, 19.996).buffer(-3).buffer(3, quad_segs=200)
    assert len(get_parts(difference(wanted, reached))) == 1
    corners = corners_of(wanted, reached, 0.01)
    assert {corner.place_mm for corner in corners} == {(0, 0), (30, 0), (30, 20), (0, 20)}
    assert [corner.area_mm2 for corner in corners] == pytest.approx([9 * (1 - math.pi / 4)] * 4, abs=0.06)
    assert [corner.thick_mm for corner in corners] == pytest.approx([3 * (math.sqrt(2) - 1)] * 4, abs=0.01)


def test_of_many_corners_the_worst_are_told_and_all_are_answered() -> None:
    teeth = [(x, y) for k in range(12) for x, y in ((12 * k, 0), (12 * k + 10, -15 - k), (12 * k + 10, 0))]
    _, answer = cut(odd(from_points([*teeth, (142, 30), (0, 30)], closed=True)), tool(4.0))
    thick_mm = [corner.thick_mm for corner in answer.corners]
    assert len(thick_mm) > 12 and thick_mm == sorted(thick_mm, reverse=True)
    assert answer.figures["rest_corners"] == len(thick_mm)
    assert answer.warnings[0].count(" at X") == 12 and f"and {len(thick_mm) - 12} smaller ones" in answer.warnings[0]


@pytest.mark.parametrize("entry", ["helix", "ramp", "plunge"])
def test_entries_stay_in_the_room_and_end_at_the_first_pass(entry: str) -> None:
    path, answer = cut(plate(entry=entry, stepdown_mm=2.0))
    require_exact(path, answer)
    table = path.table()
    for span in spans(path, "entry"):
        passes = next(one for one in spans(path, "pass") if one.first == span.last)
        first = path.begins()[passes.first]
        assert span.name == entry and np.allclose(first[:2], table.end[span.last - 1, :2])
        assert first[2] == table.end[passes.first, 2]


def test_a_steeper_entry_is_shorter_and_none_falls_steeper_than_asked() -> None:
    rows = {angle: len(cut(plate(entry_angle_deg=angle))[0]) for angle in (1.0, 20.0)}
    assert rows[1.0] > rows[20.0]
    path, _ = cut(plate(entry="ramp", entry_angle_deg=5.0))
    table, begins = path.table(), path.begins()
    for span in spans(path, "entry"):
        fall_mm = begins[span.first : span.last, 2] - table.end[span.first : span.last, 2]
        run_mm = np.abs(complex_of((table.end - begins)[span.first : span.last, :2]))
        sloping = fall_mm > 1e-9
        assert np.degrees(np.arctan2(fall_mm, run_mm)[sloping]).max() <= 5.5


def test_climb_has_the_material_to_its_right_and_conventional_to_its_left() -> None:
    for direction, sign in (("climb", 1), ("conventional", -1)):
        path, _ = cut(odd(box(0, 0, 40, 30), direction=direction))
        last = spans(path, "pass")[-1]
        xy = path.table().end[last.first : last.last, :2]
        assert sign * from_points(xy, True).area_mm2 > 0


def test_the_finishing_pass_has_its_own_feed_and_begins_on_roughed_ground() -> None:
    path, answer = cut(plate(finish_stepover_mm=0.4, finish_feed_mm_min=321.0))
    require_exact(path, answer)
    finishing = [span for span in spans(path, "pass") if span.name.startswith("finishing")]
    assert len(finishing) == 4 * 3
    assert all((path.table().feed[span.first : span.last] == 321.0).all() for span in finishing)
    assert len(spans(path, "entry")) == 4


def test_stock_to_leave_and_offset_move_the_wall() -> None:
    path, answer = cut(odd(slot(40, 20), stock_to_leave_mm=0.5, offset_mm=(7.0, 8.0)))
    require_exact(path, answer)
    assert answer.removals[0].region.bounds == pytest.approx((7 - 29.5, 8 - 9.5, 7 + 29.5, 8 + 9.5), abs=1e-3)


def test_wide_stepovers_leave_no_spots() -> None:
    triangle = from_points([(0, 0), (80, 0), (40, 70)], True)
    for stepover_mm in (3.3, 4.5, 6.0):
        require_exact(*cut(odd(triangle, stepover_mm=stepover_mm)))


WAIST = from_points([(0, 0), (30, 0), (30, 7), (60, 7), (60, 13), (30, 13), (30, 20), (0, 20)], True)
ODD = {
    "a slot just as wide as the tool": [slot(26, 6)],
    "the same askew": [slot(26, 6).rotated(33)],
    "a thousandth too narrow": [slot(26, 5.999)],
    "a hole just as wide as the tool": [circle((5, 5), 3)],
    "a slot just as wide beside a room": [WAIST],
    "a sliver": [from_points([(0, 0), (100, 0), (100, 7)], True)],
    "a neck too narrow": [box(0, 0, 20, 20), box(19, 9, 22, 2), box(40, 0, 20, 20)],
    "one room too narrow": [box(0, 0, 20, 20), box(40, 0, 4, 20)],
    "a bow tie": [from_points([(0, 0), (40, 30), (40, 0), (0, 30)], True)],
    "doubled points": [Curve(np.array([(0, 0), (0, 0), (40, 0), (40, 0), (40, 30), (0, 30), (0, 0)]), np.zeros(6))],
}


@pytest.mark.slow
@pytest.mark.parametrize("name", ODD)
def test_odd_shapes_are_cut_as_far_as_the_tool_reaches(name: str) -> None:
    require_exact(*cut(odd(*ODD[name])))


def test_a_slot_just_as_wide_as_the_tool_is_reached_to_its_end() -> None:
    _, answer = cut(odd(WAIST))
    assert answer.removals[0].reachable.bounds[2] > 59.9


def test_islands_that_touch_and_nest() -> None:
    islands = [box(10, 10, 10, 10), box(20, 10, 10, 10), circle((40, 20), 5), circle((50, 20), 5), circle((15, 15), 2)]
    require_exact(*cut(odd(box(0, 0, 70, 40), islands=islands)))


@pytest.mark.parametrize(
    "operation, code, words",
    [
        (odd(slot(20, 5)), "tool-wide", "5.000 mm diameter"),
        (odd(box(0, 0, 20, 20), islands=[box(-1, -1, 30, 30)]), "pocket-empty", "nothing to cut"),
        (odd(from_points([(0, 0), (10, 0)], True)), "pocket-empty", "nothing to cut"),
        (odd(box(0, 0, 20, 20), stepover_mm=6.1), "stepover-wide", "islands remain"),
        (odd(box(0, 0, 20, 20), finish_stepover_mm=3.0), "finish-wide", "islands remain"),
        (odd(box(0, 0, 200, 200), stepover_mm=0.001), "passes-many", "stepover_mm"),
        (odd(from_points([(0, 0), (10, 0), (10, 10)])), "region-open", "open"),
    ],
)
def test_what_cannot_be_cut_is_refused_by_name(operation: Pocket, code: str, words: str) -> None:
    with pytest.raises(CNCStepperError) as caught:
        cut(operation)
    assert isinstance(caught.value, (CycleError, GeometryError)) and caught.value.code == code
    assert words in str(caught.value)


def test_a_mill_with_a_core_does_not_plunge() -> None:
    cored = tool(6.0, core_diameter_mm=2.0, ramp_max_deg=4.0)
    with pytest.raises(CycleError, match="does not cut over its centre"):
        cut(odd(circle((0, 0), 3.01), entry="ramp"), cored)
    with pytest.raises(CycleError, match="entry"):
        cut(odd(box(0, 0, 20, 20), entry="plunge"), cored)
    assert spans(cut(odd(box(0, 0, 20, 20)), cored)[0], "entry")[0].name == "helix"


@pytest.mark.slow
def test_links_stay_on_what_is_cut_or_are_steps_of_the_pattern() -> None:
    path, answer = cut(odd(from_points(OUTLINE, True), islands=ISLANDS))
    rows, done, long_links = rows_of(path), [], 0
    for span in sorted(spans(path, "pass") + spans(path, "link"), key=lambda span: span.first):
        chords = flattened(rows.some(slice(span.first, span.last)))
        line = LineString(xy_of(np.append(chords.begin, chords.end[-1])))
        if span.name == "link" and line.length > 4.0:
            long_links += 1
            assert union_all([buffer(one, 3.0) for one in done]).covers(line)
        done += [LineString(pair) for pair in xy_of(np.column_stack([chords.begin, chords.end]))]
    assert answer.figures["rooms"] == 1 and long_links > 2


@pytest.mark.slow
def test_an_outline_of_50_000_points_is_cut_in_few_blocks() -> None:
    t = np.linspace(0, 2 * math.pi, 50_000, endpoint=False)
    wave = 3 * np.sin(9 * t) + 0.5 * np.sin(200 * t)
    outline = from_points(np.column_stack([(40 + wave) * np.cos(t), 30 * np.sin(t)]), True)
    path, answer = cut(odd(outline))
    require_exact(path, answer)
    assert len(path) < 5_000
