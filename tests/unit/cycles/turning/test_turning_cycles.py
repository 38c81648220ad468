# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cycles of a lathe, one by one: where the tool goes, and what is refused with the number that would do."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.cycles.turning.nose_path import centre_path, crossings_mm, framed
from CNCStepper.cycles.turning.turned_coordinates import Placement
from CNCStepper.cycles.turning.turning_cycles import cut
from CNCStepper.cycles.turning.turning_moves import TurningMoves
from CNCStepper.cycles.turning.turning_operation import turning_operation_class
from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, from_points
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.state import Start
from CNCStepper.toolpath import RAPID, TableBuilder

CNMG = {"insert": "CNMG 120408"}
SHAFT = from_points([(0, 10), (-20, 10), (-20, 15), (-40, 15)])


def rows_of(cycle: str, tool: dict, profile: Curve | None = None, bore_mm: float = 0.0, **keys):
    """Return kind, z and r of the control point of each row of one operation on a bar of 40 mm, and its answer."""
    named = {} if profile is None else {"profile": "part"}
    operation = turning_operation_class(cycle)(cycle=cycle, tool=1, **named, **keys)
    setup = TurningSetup(TurningTool(number=1, **tool), 20.0, 1.0, bore_mm, (10.0, 30.0), 0.2, 500.0, profile)
    table = TableBuilder(Start(position_mm=(30.0, 0.0, 10.0)))
    answer = cut(1, operation, setup, TurningMoves(table, Placement(), setup))
    rows = table.toolpath().table()
    return [(int(kind), end[2], end[0]) for kind, end in zip(rows.kind, rows.end.tolist(), strict=True)], answer


def feeds(rows):
    return [(round(z, 6), round(r, 6)) for kind, z, r in rows if kind != RAPID]


def test_facing_goes_a_nose_radius_over_the_centre_in_even_passes():
    rows, answer = rows_of("turn_face", CNMG, ap_mm=0.6)
    assert answer.figures["passes"] == 2 and answer.figures["ap_mm"] == 0.5
    assert feeds(rows)[0] == (0.5, -0.8) and feeds(rows)[2] == (0.0, -0.8)
    assert rows[-1][1:] == (10.0, 30.0)


def test_facing_a_tube_ends_in_its_bore():
    rows, _ = rows_of("turn_face", CNMG, bore_mm=12.0, ap_mm=1.0)
    assert feeds(rows)[0] == (0.0, 6.0 - 2 * 0.8)


def test_the_finished_path_is_the_parallel_of_the_profile():
    chamfered = from_points([(0, 8), (-2, 10), (-20, 10)])
    path = centre_path(chamfered, 0.8, 21.8)
    rows, _ = rows_of("turn_finish", CNMG, chamfered)
    points = np.array([(z + 0.8, r + 0.8) for z, r in feeds(rows)])
    assert path.distances_mm(points).max() < 1e-6
    on_profile = chamfered.distances_mm(path.points(1e-5))
    assert abs(on_profile[path.points(1e-5)[:, 1] < 10.79] - 0.8).max() < 1e-4
    assert points[-1, 0] == pytest.approx(-20 + 0.8)  # the wall at the profile's end


LOW_ENDS = [
    (-20.0, 19.6, 180.0, -20 + math.sqrt(0.8**2 - 0.4**2)),  # the nose rolls over an edge half its radius high
    (-20.0, 18.0, 180.0, -20 + 0.8),  # a wall higher than the nose is met by its side
    (-20.0, 20.0, 150.0, -20 + 0.8 * math.sin(math.radians(30.0))),  # a slope that ends at the bar is cut to its end
]


@pytest.mark.parametrize(("z", "r", "way_deg", "last_z"), LOW_ENDS)
def test_a_wall_lower_than_the_nose_is_met_at_its_upper_edge(z, r, way_deg, last_z):
    way = complex(math.cos(math.radians(way_deg)), math.sin(math.radians(way_deg)))
    profile = from_points([(0, r - 4), (z - 5 * way.real, r - 5 * way.imag), (z, r)])
    path = centre_path(profile, 0.8, 22.0, 20.0)
    assert path.xy[-1, 0] == pytest.approx(last_z, abs=2e-4)
    edge_mm = path.distances_mm(np.array([(z, 20.0)]))
    assert edge_mm[0] == pytest.approx(0.8, abs=2e-4)


def test_levels_are_even_and_every_pass_ends_at_the_stock_to_leave():
    rows, answer = rows_of("turn_rough", CNMG, SHAFT, ap_mm=2.0, stock_to_leave_mm=0.5)
    assert answer.figures == {"passes": 5.0, "ap_mm": 1.9, "feed_mm_rev": 0.2, "rpm": 500.0}
    straight = [z for (kind, z, r), before in zip(rows[1:], rows, strict=False) if kind != RAPID and before[2] == r]
    assert max(straight) < 1.0
    assert min(z for z, _ in feeds(rows)) == pytest.approx(-39.5)
    lowest = min(r for _, r in feeds(rows))
    assert lowest == pytest.approx(10.5)


def test_a_valley_is_entered_down_its_flank():
    valley = from_points([(0, 18), (-10, 18), (-25, 12), (-35, 12), (-40, 18), (-45, 18)])
    rows, _ = rows_of("turn_rough", {"insert": "DCMT 11T304", "lead_deg": 93.0}, valley, ap_mm=1.5)
    deep = [r for kind, _, r in rows if kind == RAPID and r < 17.0]
    assert deep == [] or min(deep) > 12.0
    assert min(r for _, r in feeds(rows)) == pytest.approx(12.0, abs=1e-6)


def test_crossings_alternate_and_touching_is_none():
    arch = Curve(np.array([(0, 0), (-10, 0), (-20, 0.0)]), np.array([-1.0, 1.0]))
    assert [up for _, up in crossings_mm(arch, 1.0)] == [True, False]
    assert crossings_mm(arch, 5.0) == [] or len(crossings_mm(arch, 5.0)) == 2
    assert crossings_mm(from_points([(0, 0), (-5, 1), (-10, 0)]), 1.0) == []


def test_a_bore_is_the_mirror_image():
    bore = from_points([(0, 15), (-20, 15), (-20, 12), (-30, 12)])
    rows, answer = rows_of("turn_bore", {"insert": "CCMT 060204", "kind": "boring"}, bore, 20.0, ap_mm=1.0)
    assert answer.inside and max(r for _, r in feeds(rows)) == pytest.approx(15.0)
    assert min(z for z, _ in feeds(rows)) == pytest.approx(-30.0)
    assert framed(bore, -1.0).xy[:, 1].tolist() == [-15, -15, -12, -12]


def test_grooves_step_from_wall_to_wall():
    blade = {"kind": "parting", "width_mm": 3.0, "nose_radius_mm": 0.1, "reach_mm": 20.0}
    keys = {"z_mm": -30.0, "width_mm": 8.0, "diameter_mm": 30.0, "top_diameter_mm": 40.0}
    rows, answer = rows_of("turn_groove", blade, **keys)
    places = sorted({z for z, r in feeds(rows) if r == 15.0})
    assert places[0] == -30.0 and places[-1] == -25.0 and max(np.diff(places)) <= 2.8 * 0.9
    assert answer.figures["plunges"] == len(places)


def test_parting_keeps_the_length_and_pecks():
    rows, _ = rows_of("turn_part", {"kind": "parting", "width_mm": 3.0}, z_mm=-30.0, peck_mm=6.0)
    assert {z for z, _ in feeds(rows)} == {-33.0}
    assert [r for _, r in feeds(rows)][:3] == [15.0, 15.3, 9.0] and min(r for _, r in feeds(rows)) == 0.0


@pytest.mark.parametrize(("retract", "outs"), [("full", 3), ("chip", 1)])
def test_drilling_pecks_out_of_the_hole_or_breaks_the_chip(retract, outs):
    keys = {"depth_mm": 20.0, "peck_mm": 8.0, "retract": retract}
    rows, answer = rows_of("turn_drill", {"kind": "drill", "diameter_mm": 8.0}, **keys)
    assert answer.figures["pecks"] == 3 and feeds(rows)[-1] == (-20.0, 0.0)
    assert sum(1 for kind, z, r in rows[2:] if kind == RAPID and z == 2.0 and r == 0.0) == outs


HOLLOW = Curve(
    np.array([(0.0, 10.0), (-10.0, 10.0), (-10.5, 10.5), (-20.0, 10.5)]), np.array([0, -math.tan(math.pi / 8), 0])
)


@pytest.mark.parametrize(
    ("cycle", "tool", "profile", "keys", "code", "limit"),
    [
        ("turn_finish", CNMG, from_points([(0, 15), (-10, 10), (-20, 10)]), {}, "insert-back", "at least 26.57 deg"),
        ("turn_finish", {**CNMG, "lead_deg": 75.0}, SHAFT, {}, "insert-front", "at most 90 deg"),
        ("turn_finish", CNMG, HOLLOW, {}, "nose-radius", "0.5 mm"),
        ("turn_rough", {**CNMG, "ap_max_mm": 3.0}, SHAFT, {"ap_mm": 4.0}, "ap-high", "3 mm"),
        ("turn_finish", {**CNMG, "feed_max_mm_rev": 0.1}, SHAFT, {}, "feed-high", "0.1 mm"),
        ("turn_finish", {**CNMG, "feed_min_mm_rev": 0.3}, SHAFT, {}, "feed-low", "0.3 mm"),
        ("turn_finish", {**CNMG, "hand": "left"}, SHAFT, {}, "profile-end", "radius 20 mm"),
        ("turn_finish", {**CNMG, "hand": "left", "kind": "boring"}, SHAFT, {}, "profile-tool", "right-hand"),
        ("turn_finish", CNMG, from_points([(-40, 10), (-50, 10)]), {}, "profile-begin", "z 1 mm"),
        ("turn_finish", {"insert": "CCMT 060204", "kind": "boring"}, SHAFT, {}, "bore-missing", "above 0 mm"),
        (
            "turn_thread",
            {"insert": "16IR 1.5 ISO", "kind": "threading"},
            None,
            {"thread": "M20x1.5", "length_mm": 20.0},
            "bore-missing",
            "above 0 mm",
        ),
        ("turn_face", {**CNMG, "lead_deg": 75.0}, None, {}, "insert-front", "at most 90 deg"),
        ("turn_face", CNMG, None, {"to_z_mm": 3.0}, "face-outside", "z 1 mm at most"),
        ("turn_drill", CNMG, None, {"depth_mm": 5.0}, "drill-tool", "drill"),
        ("turn_part", CNMG, None, {"z_mm": -5.0}, "blade-tool", "parting"),
    ],
)
def test_what_cannot_be_turned_is_refused_with_the_number_that_would_do(cycle, tool, profile, keys, code, limit):
    with pytest.raises(CycleError) as refusal:
        rows_of(cycle, tool, profile, **keys)
    assert refusal.value.code == code and limit in refusal.value.limit


NECK, OPEN = [(0, 18), (-10, 18), (-10, 12)], [(-20, 12), (-40, 20)]
TO_LEFT = "left-hand insert T (60 deg) at an entering angle of 90 to 98.2"
CHOICES = [  # what the tool does not reach, what is advised, and a tool that the advice means
    (
        [*NECK, (-30, 12)],
        {},
        "use an insert V (35 deg) at an entering angle of 0 to 55",
        ("VBMT 160404", "right", 55.0),
    ),
    ([*NECK, *OPEN], {}, TO_LEFT, ("TNMG 160408", "left", 98.0)),
    ([*NECK, *OPEN], {"hand": "left"}, TO_LEFT.removeprefix("left-hand "), ("TNMG 160408", "left", 91.0)),
    (
        [(0, 15), (-10, 10), (-10, 20)],
        {},
        "T (60 deg) at an entering angle of 90 to 93",
        ("TNMG 160408", "right", 93.0),
    ),
    ([(0, 15), (-10, 15), (-10, 18)], {"lead_deg": 75.0}, "C (80 deg) at an entering", ("CNMG 120408", "right", 90.0)),
]


@pytest.mark.parametrize(("points", "tool", "words", "other"), CHOICES)
def test_the_advice_names_an_insert_that_reaches(points, tool, words, other):
    with pytest.raises(CycleError) as refusal:
        rows_of("turn_finish", {**CNMG, **tool}, from_points(points))
    assert refusal.value.code in ("insert-front", "insert-back") and words in refusal.value.advice
    mended = dict(zip(("insert", "hand", "lead_deg"), other, strict=True))
    assert feeds(rows_of("turn_finish", mended, from_points(points))[0])


def test_where_no_insert_reaches_the_advice_names_the_blade_or_the_angle():
    slot, notch = [(-16, 12), (-16, 18), (-30, 18)], [(-12, 18), (-30, 18)]
    for walls, words in ((slot, "a blade of 6 mm or narrower, 8 mm deep"), (notch, "it must fill 18.43 deg or less")):
        with pytest.raises(CycleError) as refusal:
            rows_of("turn_finish", CNMG, from_points([*NECK, *walls]))
        assert words in refusal.value.advice
    keys = {"z_mm": -16.0, "width_mm": 6.0, "diameter_mm": 24.0, "top_diameter_mm": 40.0}
    assert feeds(rows_of("turn_groove", {"kind": "parting", "width_mm": 6.0, "reach_mm": 8.0}, **keys)[0])


def test_a_narrow_groove_a_deep_one_and_a_narrow_hole_are_refused():
    blade, keys = {"kind": "parting", "width_mm": 3.0, "reach_mm": 4.0}, {"z_mm": -30.0, "top_diameter_mm": 40.0}
    for width, floor, code in ((2.0, 36.0, "blade-width"), (4.0, 30.0, "blade-reach"), (4.0, 41.0, "groove-depth")):
        with pytest.raises(CycleError) as refusal:
            rows_of("turn_groove", blade, width_mm=width, diameter_mm=floor, **keys)
        assert refusal.value.code == code
    bar = {"insert": "CCMT 060204", "kind": "boring", "smallest_bore_mm": 12.0, "bar_mm": 8.0}
    with pytest.raises(CycleError) as refusal:
        rows_of("turn_bore", bar, from_points([(0, 8), (-10, 8)]), 10.0, ap_mm=1.0)
    assert refusal.value.code == "bore-narrow" and refusal.value.limit == "12 mm"
