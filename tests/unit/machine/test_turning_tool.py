# SPDX-License-Identifier: LGPL-2.1-or-later
"""Inserts by their code, and the outlines of lathe tools about their control point."""

from __future__ import annotations

import math

import numpy as np
import pytest
from pydantic import ValidationError

from CNCStepper.errors import JobError
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.tools.insert_code import insert_of
from CNCStepper.machine.tools.turning_tool import Outline, TurningTool


def curve_of(outline: Outline) -> Curve:
    rows = np.array([*outline, outline[0]])
    return Curve(rows[:, :2], rows[:-1, 2])


@pytest.mark.parametrize(
    ("code", "nose_deg", "clearance_deg", "circle_mm", "edge_mm", "thickness_mm", "nose_mm"),
    [  # as makers' catalogues have them
        ("CNMG 120408", 80, 0, 12.7, 12.9, 4.76, 0.8),
        ("DCMT 11T304", 55, 7, 9.525, 11.6, 3.97, 0.4),
        ("VBMT 160404", 35, 5, 9.525, 16.6, 4.76, 0.4),
        ("TNMG 160408-PM", 60, 0, 9.525, 16.5, 4.76, 0.8),
        ("TCMT110204", 60, 7, 6.35, 11.0, 2.38, 0.4),
        ("WNMG 080412", 80, 0, 12.7, 8.7, 4.76, 1.2),
        ("SCMT 09T308", 90, 7, 9.525, 9.525, 3.97, 0.8),
        ("RCMT 0803M0", 0, 7, 8.0, 0.0, 3.18, 4.0),
        ("RCMT 120400", 0, 7, 12.7, 0.0, 4.76, 6.35),
    ],
)
def test_inserts_are_those_of_catalogues(code, nose_deg, clearance_deg, circle_mm, edge_mm, thickness_mm, nose_mm):
    insert = insert_of(code)
    assert (insert.nose_deg, insert.clearance_deg, insert.circle_mm) == (nose_deg, clearance_deg, circle_mm)
    assert insert.edge_mm == pytest.approx(edge_mm, abs=0.06)
    assert (insert.thickness_mm, insert.nose_radius_mm) == (thickness_mm, nose_mm)


@pytest.mark.parametrize(
    ("code", "says"),
    [
        ("CNMG", "is no insert"),
        ("QNMG 120408", "no shape of ISO 1832"),
        ("CYMG 120408", "no clearance"),
        ("CNMG 130408", "no edge of ISO 1832 (value 13, limit 04, 05, 06"),
        ("CNMG 128808", "no thickness"),
    ],
)
def test_a_wrong_code_is_refused_with_what_there_is(code, says):
    with pytest.raises(JobError) as refusal:
        insert_of(code)
    assert says in str(refusal.value)


def test_threading_inserts_have_side_hand_and_pitch():
    outside, inside = insert_of("16ER 1.5 ISO"), insert_of("11IL AG55")
    assert (outside.inside, outside.hand, outside.pitch_mm, outside.nose_deg) == (False, "right", 1.5, 60.0)
    assert (inside.inside, inside.hand, inside.pitch_mm, inside.nose_deg) == (True, "left", 0.0, 55.0)


@pytest.mark.parametrize(
    ("keys", "tip", "front_deg", "back_deg"),
    [
        ({"insert": "CNMG 120408"}, 2, 85, 5),
        ({"insert": "DCMT 11T304", "lead_deg": 93}, 2, 87, 32),
        ({"insert": "CNMG 120408", "hand": "left"}, 1, 95, 175),
        ({"insert": "CCMT 060204", "kind": "boring"}, 3, -85, -5),
        ({"insert": "CCMT 060204", "kind": "boring", "hand": "left"}, 4, -95, -175),
        ({"insert": "16IR AG60", "kind": "threading"}, 8, -60, -120),
        ({"nose_radius_mm": 0.4, "front_deg": 90, "back_deg": 30, "orientation": 2}, 2, 90, 30),
    ],
)
def test_edges_and_orientation_follow_from_hand_side_and_lead(keys, tip, front_deg, back_deg):
    tool = TurningTool(number=1, **keys)
    assert tool.tip == tip
    assert tool.edges_deg == pytest.approx((front_deg, back_deg))


@pytest.mark.parametrize("insert", ["CNMG 120408", "DCMT 11T304", "VBMT 160404", "TNMG 160408", "SCMT 09T308"])
@pytest.mark.parametrize("kind", ["turning", "boring"])
@pytest.mark.parametrize("hand", ["right", "left"])
def test_outline_is_the_rounded_insert_and_the_control_point_touches_it(insert, kind, hand):
    tool = TurningTool(number=1, insert=insert, kind=kind, hand=hand)
    outline, data = curve_of(tool.outline()), insert_of(insert)
    sharp = {
        "T": math.sqrt(3) / 4 * data.edge_mm**2,
    }.get(data.shape, data.edge_mm**2 * math.sin(math.radians(data.nose_deg)))
    half, nose = math.radians(data.nose_deg) / 2, data.nose_radius_mm
    lost = nose**2 * (1 / math.tan(half) - (math.pi / 2 - half))
    assert outline.area_mm2 == pytest.approx(sharp - lost, rel=1e-9)
    assert outline.nearest(np.array([tool.nose_centre]))[0][0] == pytest.approx(nose)
    points = outline.points(1e-5)
    if insert.startswith(("C", "T")) and kind == "turning":  # both edges lie within the quarter of the orientation
        assert abs(points[:, 1].min()) < 0.01 * nose + 0.1


def test_round_inserts_blades_and_drills():
    disc = curve_of(TurningTool(number=1, insert="RCMT 1003M0").outline())
    assert disc.area_mm2 == pytest.approx(math.pi * 25)
    blade = curve_of(TurningTool(number=2, kind="parting", width_mm=3, nose_radius_mm=0.2, reach_mm=20).outline())
    assert blade.area_mm2 == pytest.approx(60 - 2 * 0.04 * (1 - math.pi / 4))
    inner = TurningTool(number=3, kind="parting", width_mm=3, reach_mm=20, nose_radius_mm=0.2, inside=True)
    assert curve_of(inner.outline()).area_mm2 == pytest.approx(blade.area_mm2)
    assert curve_of(inner.outline()).box_mm[3] == pytest.approx(0.0)
    drill = curve_of(TurningTool(number=4, kind="drill", diameter_mm=10, point_angle_deg=90, reach_mm=40).outline())
    assert drill.area_mm2 == pytest.approx(10 * 35 + 25)


def test_a_bar_stays_within_its_smallest_bore():
    tool = TurningTool(number=1, kind="boring", insert="CCMT 060204", smallest_bore_mm=12, bar_mm=8, reach_mm=40)
    box = curve_of(tool.holder_outline()).box_mm
    assert box[1] == -10 and box[3] == -2 and box[2] == 40


@pytest.mark.parametrize(
    ("keys", "says"),
    [
        ({"kind": "turning"}, "needs insert"),
        ({"kind": "parting"}, "needs width_mm"),
        ({"kind": "drill", "diameter_mm": 8, "width_mm": 3}, "has no width_mm"),
        ({"insert": "CNMG 999999"}, "of ISO 1832"),
        ({"insert": "16ER 1.5 ISO"}, "is no insert of a turning tool"),
        ({"nose_radius_mm": 0.4, "front_deg": 30, "back_deg": 90}, "must fill 1 to 179 degrees"),
        ({"insert": "CCMT 060204", "kind": "boring", "bar_mm": 12, "smallest_bore_mm": 12}, "below smallest_bore_mm"),
        ({"insert": "CNMG 120408", "feed_min_mm_rev": 0.3, "feed_max_mm_rev": 0.2}, "must not exceed"),
    ],
)
def test_keys_that_do_not_fit_are_refused(keys, says):
    with pytest.raises(ValidationError) as refusal:
        TurningTool(number=1, **keys)
    assert says in str(refusal.value)
