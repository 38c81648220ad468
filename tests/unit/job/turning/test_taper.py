# SPDX-License-Identifier: LGPL-2.1-or-later
"""A cone as an operation of its own: cut, read back and judged; the same as a profile of its points."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from CNCStepper.errors import CNCStepperError
from CNCStepper.job.turning.make_turning import make_turning, turned_moves
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import TurningJob, turning_job_of
from CNCStepper.machine.profile import load_machine

JOB = """
machine = "linuxcnc-lathe"
process = "turning"
stock = { diameter_mm = 50, face_mm = 0, length_mm = 90 }
tool = [
    { number = 1, insert = "DNMG 110404", lead_deg = 93, spindle_rpm = 500, feed_mm_rev = 0.2 },
    { number = 2, kind = "boring", insert = "CCMT 060204", spindle_rpm = 500, feed_mm_rev = 0.1 },
]
"""
CONE: dict[str, Any] = {"cycle": "turn_taper", "tool": 1, "diameter_mm": 30, "length_mm": 25, "last_pass_mm": 0.2}
BY_DIAMETERS = CONE | {"end_diameter_mm": 40}
INSIDE = CONE | {"tool": 2, "end_diameter_mm": 24, "ap_mm": 0.5}
TUBE = {"stock": {"form": "tube", "diameter_mm": 50, "bore_mm": 20, "face_mm": 0, "length_mm": 90}}


def job_of(operation: dict[str, Any], **changes: Any) -> TurningJob:
    return turning_job_of(tomllib.loads(JOB) | changes | {"operation": [operation]}, Path("job.toml"))


def cut(operation: dict[str, Any], folder: Path, **changes: Any) -> Any:
    """Return the verdict on the program of one cone, in which nothing is found."""
    job, machine = job_of(operation, **changes), load_machine("linuxcnc-lathe")
    (proven,) = prove_turning(job, machine, make_turning(job, machine), folder)
    assert [str(found) for found in proven.verdict.findings if found.severity == "error"] == []
    return proven.verdict


def test_a_cone_has_its_diameters_at_any_z(tmp_path: Path) -> None:
    verdict = cut(BY_DIAMETERS, tmp_path)
    for z_mm in (-1.0, -12.5, -23.0):
        assert verdict.dimension_at(z_mm)[0] == pytest.approx(30 - z_mm * 10 / 25, abs=0.01)
    assert verdict.dimension_at(-26.0)[0] == pytest.approx(50)


@pytest.mark.parametrize("canned", [False, True])
def test_a_cone_by_its_angle_is_that_by_its_diameters(canned: bool) -> None:
    machine = load_machine("linuxcnc-lathe")
    by_angle = CONE | {"by": "angle", "angle_deg": 11.309932474020215}
    texts = [make_turning(job_of(one, canned=canned), machine)[0].program for one in (BY_DIAMETERS, by_angle)]
    assert texts[0] == texts[1] and (not canned or ("G71" in texts[0] and "G70" in texts[0]))


def test_a_cone_in_a_bore_narrows_towards_the_chuck(tmp_path: Path) -> None:
    verdict = cut(INSIDE, tmp_path, **TUBE)
    for z_mm in (-2.0, -12.5, -23.0):
        assert verdict.dimension_at(z_mm)[1] == pytest.approx(30 + z_mm * 6 / 25, abs=0.01)


def test_corners_are_cut_and_rounded(tmp_path: Path) -> None:
    verdict = cut(BY_DIAMETERS | {"begin_chamfer_mm": 1, "end_fillet_mm": 2}, tmp_path)
    sharp = 30 + 0.2 * 10 / 25
    assert verdict.dimension_at(-0.2)[0] < sharp - 1
    assert verdict.dimension_at(-24.5)[0] > 39.8 + 0.5
    inside = cut(INSIDE | {"begin_fillet_mm": 1, "end_fillet_mm": 0.5}, tmp_path, **TUBE)
    assert inside.dimension_at(-0.2)[1] > 30.2


@pytest.mark.parametrize(
    ("operation", "code"),
    [
        (CONE | {"by": "angle", "angle_deg": -40}, "taper-axis"),
        (BY_DIAMETERS | {"end_diameter_mm": 60}, "taper-wide"),
        (BY_DIAMETERS | {"length_mm": 95}, "chuck-reach"),
        (BY_DIAMETERS | {"z_mm": 40}, "taper-outside"),
        (CONE | {"end_diameter_mm": 5, "diameter_mm": 40}, "insert-back"),
        (BY_DIAMETERS | {"end_fillet_mm": 0.2}, "nose-radius"),
        (BY_DIAMETERS | {"begin_chamfer_mm": 20}, "profile-corner"),
    ],
)
def test_a_cone_that_cannot_be_is_refused(operation: dict[str, Any], code: str) -> None:
    with pytest.raises(CNCStepperError) as refusal:
        turned_moves(job_of(operation), load_machine("linuxcnc-lathe"))
    assert refusal.value.code == code and refusal.value.place


def test_a_corner_is_one_thing() -> None:
    with pytest.raises(CNCStepperError, match="begin_chamfer_mm or begin_fillet_mm"):
        job_of(BY_DIAMETERS | {"begin_chamfer_mm": 1, "begin_fillet_mm": 1})
