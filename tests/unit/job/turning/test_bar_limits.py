# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a stranger may write into a lathe's job: refused with code, place, value and the number that would do."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.cycles.turning.turning_operation import turning_operation_class
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.turning.make_turning import turned_moves
from CNCStepper.job.turning.turning_job import turning_job_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.workbench.panels.field_errors import key_of

ROOT = Path(__file__).parents[4]
JOB = """
machine = "mini-lathe"
process = "turning"
stock = { diameter_mm = 55, face_mm = 1, length_mm = 130 }
chuck = { diameter_mm = 100, jaw_diameter_mm = 90, jaw_mm = 15 }
tool = [
    { number = 1, insert = "CNMG 120408", spindle_rpm = 500, feed_mm_rev = 0.2 },
    { number = 2, kind = "parting", width_mm = 3, reach_mm = 15, spindle_rpm = 500, feed_mm_rev = 0.1 },
    { number = 3, kind = "drill", diameter_mm = 20, spindle_rpm = 500, feed_mm_rev = 0.1 },
    { number = 4, insert = "CCMT 060204", kind = "boring", spindle_rpm = 500, feed_mm_rev = 0.1 },
    { number = 5, insert = "16ER 1.5 ISO", kind = "threading", spindle_rpm = 90 },
    { number = 6, kind = "drill", diameter_mm = 60, spindle_rpm = 500, feed_mm_rev = 0.1 },
]
profile = [{ name = "part", points = [[40, 0], [40, -60]] }]
"""
FACE = {"cycle": "turn_face", "tool": 1}
ROUGH = {"cycle": "turn_rough", "tool": 1, "profile": "part", "ap_mm": 1.5}
GROOVE = {"cycle": "turn_groove", "tool": 2, "z_mm": -30, "width_mm": 4, "diameter_mm": 30, "top_diameter_mm": 40}
PART = {"cycle": "turn_part", "tool": 2, "z_mm": -60, "to_diameter_mm": 40}
DRILL = {"cycle": "turn_drill", "tool": 3, "depth_mm": 30}
BORE = {"cycle": "turn_bore", "tool": 4, "profile": "part", "ap_mm": 0.5}
THREAD = {"cycle": "turn_thread", "tool": 5, "thread": "M40x1.5", "length_mm": 20}


def refused(operations: list[dict[str, Any]], points: list | None = None, **changes: Any) -> CNCStepperError:
    content = tomllib.loads(JOB) | changes | {"operation": operations}
    if points is not None:
        content["profile"][0]["points"] = points
    threads = any(operation["cycle"] == "turn_thread" for operation in operations)
    machine = load_machine(str(ROOT / "examples/machines/mini-lathe-index.toml") if threads else "mini-lathe")
    with pytest.raises(CNCStepperError) as refusal:
        turned_moves(turning_job_of(content, Path("job.toml")), machine)
    assert refusal.value.place
    return refusal.value


@pytest.mark.parametrize(
    ("operation", "profile", "code", "value", "limit"),
    [
        (FACE | {"to_z_mm": -125}, None, "chuck-reach", "z -125 mm", "z -115 mm"),
        (FACE | {"to_diameter_mm": 80}, None, "face-diameter", "80 mm", "below 55 mm"),
        (FACE | {"to_z_mm": 20}, None, "face-outside", "z 20 mm", "z 1 mm at most"),
        (FACE | {"spindle_rpm": 1}, None, "speed-low", "1 rpm", "90 rpm"),
        (FACE | {"spindle_rpm": 50_000}, None, "speed-high", "50000 rpm", "2000 rpm"),
        (ROUGH, [[80, 0], [80, -60]], "profile-outside", "80 mm", "55 mm"),
        (ROUGH, [[40, 0], [40, -120]], "profile-chuck", "z -120 mm", "z -115 mm"),
        (ROUGH, [[40, 60], [40, 20]], "profile-outside", "z 20 mm", "below z 1 mm"),
        (ROUGH, [[40, -40], [40, -60]], "profile-begin", "z -40 mm", "z 1 mm"),
        (ROUGH, [[40, 0], [40, 0]], "profile-short", "0 mm long", "above 0 mm"),
        (ROUGH | {"stock_to_leave_mm": 100}, None, "leave-all", "100 mm", "below 7.566 mm"),
        (ROUGH | {"ap_mm": 0.001}, [[0, 1], [40, -60]], "passes-many", None, None),
        (GROOVE | {"width_mm": 2}, None, "blade-width", "3 mm", "2 mm"),
        (GROOVE | {"diameter_mm": 1}, None, "blade-reach", "19.5 mm", "15 mm"),
        (GROOVE | {"diameter_mm": 50}, None, "groove-depth", "-5 mm deep", "above 0 mm"),
        (GROOVE | {"z_mm": -120}, None, "chuck-reach", "z -120 mm", "z -115 mm"),
        (GROOVE | {"z_mm": 50}, None, "groove-outside", "z 50 mm", "below z 1 mm"),
        (GROOVE | {"z_mm": -2}, None, "groove-width", "4 mm", "3 mm"),
        (PART | {"to_diameter_mm": 0}, None, "blade-reach", "27.5 mm", "15 mm"),
        (PART | {"z_mm": -114}, None, "chuck-reach", "z -114 mm", "z -112 mm"),
        (PART | {"z_mm": 20}, None, "part-outside", "z 20 mm", "below z 1 mm"),
        (PART | {"to_diameter_mm": 80}, None, "groove-depth", "-12.5 mm deep", "above 0 mm"),
        (PART | {"to_diameter_mm": 28, "peck_mm": 0.001}, None, "passes-many", None, None),
        (DRILL | {"depth_mm": 140}, None, "drill-deep", "140 mm", "130 mm"),
        (DRILL | {"tool": 6}, None, "drill-wide", "60 mm", "55 mm"),
        (DRILL | {"peck_mm": 0.001}, None, "passes-many", "0.001 mm", "at least 0.0031 mm"),
        (BORE, None, "bore-missing", "0 mm", "above 0 mm"),
        (THREAD | {"thread": "M80x1.5"}, None, "thread-wide", "79.85 mm", "55 mm"),
        (THREAD | {"length_mm": 180}, None, "chuck-reach", "z -180 mm", "z -115 mm"),
        (THREAD | {"z_mm": 50}, None, "thread-outside", "z 30 mm", "below z 1 mm"),
        (THREAD | {"thread": "M40x3"}, None, "thread-insert", "1.5 mm", "3 mm"),
        (THREAD | {"profile": "part", "length_mm": 80}, None, "thread-cylinder", "80 mm", "60 mm"),
        (THREAD | {"spindle_rpm": 2000}, None, "thread-speed", "3000 mm/min", "1389 mm/min"),
    ],
)  # fmt: skip
def test_an_operation_that_cannot_be_is_refused_with_the_number_that_would_do(operation, profile, code, value, limit):
    error = refused([operation], profile)
    assert error.code == code and ("operation 1" in str(error) or code == "profile-short")
    assert value is None or (error.value, error.limit) == (value, limit)


@pytest.mark.parametrize(
    ("profile", "code", "value", "limit"),
    [
        ([[70, 0], [70, -20]], "profile-outside", "70 mm", "55 mm"),
        ([[10, 0], [10, -20]], "bore-wide", "10 mm", "above 20 mm"),
        ([[30, 0], [30, -60]], "bore-deep", "z -60 mm", "z -23.99 mm"),  # the drill's point is not as wide
    ],
)
def test_a_bore_goes_into_the_hole_that_is_there(profile, code, value, limit):
    error = refused([FACE, DRILL, BORE], profile)
    assert (error.code, error.value, error.limit) == (code, value, limit)
    assert "operation 3 (turn bore)" in str(error)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"stock": {"diameter_mm": -5, "length_mm": 100}}, "stock.diameter_mm must be a number within its bounds"),
        ({"stock": {"diameter_mm": float("nan"), "length_mm": 100}}, "value nan mm, limit 0.001 to 100000 mm"),
        ({"stock": {"diameter_mm": 50, "bore_mm": 60, "form": "tube", "length_mm": 9}}, "below diameter_mm, 50 mm"),
        ({"chuck": {"jaw_diameter_mm": 90, "jaw_mm": 150}}, "jaw_mm must be below 131 mm"),
        ({"start": [-60, 10]}, "the start lies over the axis: its x is -30 mm"),
        ({"start": [60, -120]}, "the start is in the chuck: its z must be at least -115 mm, or its x outside 100 mm"),
        ({"material": "cheese"}, "no material of turning is called 'cheese': it may be"),
        ({"profile": [{"name": "part", "points": [[float("inf"), 0], [9, -9]]}]}, "profile.0.points.0.point.0 must be"),
        ({"profile": [{"name": "part", "points": [[9, 0], {"to": [9, -9], "arc": "cw", "radius_mm": 0}]}]},
         "profile.0.points.1.corner.radius_mm must be"),
        ({"profile": [{"name": "part", "points": []}]}, "at least 2 values"),
    ],
)  # fmt: skip
def test_a_job_whose_parts_cannot_be_is_refused(changes, says):
    assert says in str(refused([FACE, ROUGH], **changes))


REFUSED_FIELDS = [
    (FACE | {"to_z_mm": -125}, None, "to_z_mm"),
    (FACE | {"to_diameter_mm": 80}, None, "to_diameter_mm"),
    (FACE | {"to_z_mm": 20}, None, "to_z_mm"),
    (FACE | {"spindle_rpm": 1}, None, "spindle_rpm"),
    (ROUGH, [[80, 0], [80, -60]], "drawings"),
    (ROUGH, [[40, 0], [40, -120]], "drawings"),
    (ROUGH, [[40, -40], [40, -60]], "drawings"),
    (ROUGH | {"stock_to_leave_mm": 100}, None, "stock_to_leave_mm"),
    (ROUGH | {"ap_mm": 0.001}, [[0, 1], [40, -60]], "ap_mm"),
    (GROOVE | {"width_mm": 2}, None, "width_mm"),
    (GROOVE | {"diameter_mm": 1}, None, "tool"),
    (GROOVE | {"diameter_mm": 50}, None, "diameter_mm"),
    (GROOVE | {"z_mm": -120}, None, "z_mm"),
    (PART | {"z_mm": -114}, None, "z_mm"),
    (PART | {"to_diameter_mm": 28, "peck_mm": 0.001}, None, "peck_mm"),
    (DRILL | {"depth_mm": 140}, None, "depth_mm"),
    (DRILL | {"tool": 6}, None, "tool"),
    (DRILL | {"peck_mm": 0.001}, None, "peck_mm"),
    (BORE, None, "tool"),
    (THREAD | {"thread": "M80x1.5"}, None, "diameter_mm"),
    (THREAD | {"length_mm": 180}, None, "length_mm"),
    (THREAD | {"z_mm": 50}, None, "z_mm"),
    (THREAD | {"thread": "M40x3"}, None, "tool"),
    (THREAD | {"spindle_rpm": 2000}, None, "spindle_rpm"),
]


@pytest.mark.parametrize(("operation", "profile", "field"), REFUSED_FIELDS)
def test_a_refusal_stands_at_the_field_that_it_speaks_of(operation, profile, field):
    drawn = ("drawings",) if operation["cycle"] in ("turn_bore", "turn_rough", "turn_thread") else ()
    fields = [each for each in turning_operation_class(operation["cycle"]).model_fields if each != "profile"]
    assert key_of(refused([operation], profile), (*fields, *drawn)) == field


def test_a_cycle_that_follows_a_profile_needs_one():
    assert "turns the profile '', which the job does not have" in str(refused([ROUGH | {"profile": ""}]))
