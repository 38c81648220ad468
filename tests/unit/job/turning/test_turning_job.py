# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job file of a lathe: what it holds, and what of it is refused with the number that would do."""

from __future__ import annotations

import math
import re
import tomllib
from pathlib import Path

import numpy as np
import pytest
from shapely import LineString, Point

from CNCStepper.errors import JobError
from CNCStepper.job.turning.turning_job import TurningJob, load_turning_job, turning_job_of
from helpers.cycles.seeds import SEEDS

ROOT = Path(__file__).parents[4]
HEAD = """
machine = "mini-lathe"
process = "turning"
stock = { diameter_mm = 55, face_mm = 1, length_mm = 170 }
tool = [{ number = 1, insert = "CNMG 120408", spindle_rpm = 500, feed_mm_rev = 0.2 }]
operation = [{ cycle = "turn_finish", tool = 1, profile = "part" }]
"""


def job_of(points: str, head: str = HEAD) -> TurningJob:
    text = f'{head}\n[[profile]]\nname = "part"\npoints = {points}\n'
    return turning_job_of(tomllib.loads(text), ROOT / "job.toml")


def test_the_example_is_a_job_in_the_lathes_own_coordinates():
    job, machine = load_turning_job(ROOT / "examples" / "jobs" / "lathe-cylinder.toml")
    assert machine.is_lathe and job.start_zr == (6.0, 32.5)
    assert job.curves["cylinder"].xy.tolist() == [[0, 25], [-152, 25]]


def test_x_is_a_diameter_where_nothing_is_said():
    assert job_of("[[40, 0], [40, -10]]").curves["part"].xy[:, 1].tolist() == [20, 20]
    radius = job_of("[[20, 0], [20, -10]]", HEAD + 'x_is = "radius"')
    assert radius.curves["part"].xy[:, 1].tolist() == [20, 20]


def test_corners_arcs_and_chamfers_are_exact():
    points = """[[0, 0], {to = [30, 0], chamfer_mm = 1}, {to = [30, -40], fillet_mm = 2},
        [40, -40], {to = [50, -45], arc = "ccw", radius_mm = 5}, [50, -80]]"""
    curve = job_of(points).curves["part"]
    expected = [(0, 0), (0, 14), (-1, 15), (-38, 15), (-40, 17), (-40, 20), (-45, 25), (-80, 25)]
    assert np.allclose(curve.xy, expected)
    quarter = math.tan(math.pi / 8)
    assert curve.bulge == pytest.approx([0, 0, 0, -quarter, 0, quarter, 0], abs=1e-9)
    assert curve.centres[3].tolist() == pytest.approx([-38, 17]) and curve.centres[5].tolist() == pytest.approx(
        [-45, 20]
    )


def test_an_arc_about_its_centre_is_that_of_its_radius():
    by_radius = job_of('[[40, -40], {to = [50, -45], arc = "ccw", radius_mm = 5}]').curves["part"]
    by_centre = job_of('[[40, -40], {to = [50, -45], arc = "ccw", centre = [40, -45]}]').curves["part"]
    assert by_centre.bulge == pytest.approx(by_radius.bulge)


@pytest.mark.parametrize(
    ("points", "code", "says"),
    [
        ("[[-1, 0], [40, 0]]", "profile-axis", "radius -0.5 mm at z 0 mm, limit radius 0 mm"),
        ("[[40, 0], [40, -10], [50, -5], [50, -30]]", "profile-undercut", "from z -10 mm by 5 mm, limit z -10 mm"),
        (
            "[[20, 0], [20, -30], [60, -30], [60, -10], [10, -10]]",
            "profile-crossing",
            "at z -10 mm, radius 10 mm, limit 2 points fewer",
        ),
        (
            "[[30, 0], [30, -10], [36, -10], [32, -10], [32, -30]]",
            "profile-crossing",
            "move its point at z -10 mm, radius 18",
        ),
        ('[[20, 0], {to = [40, 0], arc = "cw", radius_mm = 4}]', "profile-arc", "limit at least 5 mm"),
        ("[[0, 0], {to = [30, 0], chamfer_mm = 20}, [30, -40]]", "profile-corner", "limit 15 mm"),
        ('[[40, 0], {to = [50, -5], arc = "cw", centre = [41, -5]}]', "profile-arc", "0.005 mm apart"),
    ],
)
def test_profiles_that_cannot_be_turned_are_refused_with_the_number_that_would_do(points, code, says):
    with pytest.raises(JobError) as refusal:
        job_of(points)
    assert refusal.value.code == code and says in str(refusal.value)


PLACE = r"z (\S+) mm, radius (\S+) mm"


@pytest.mark.parametrize("seed", SEEDS)
def test_the_change_that_a_crossing_profile_is_told_makes_it_one_that_can_be_turned(seed):
    """The place lies on the profile; the point that is named, moved or left out, is enough."""
    random = np.random.default_rng(seed)
    radii, places = random.uniform(5, 20, 6).round(3).tolist(), (-np.cumsum(random.uniform(2, 6, 6))).round(3).tolist()
    corners = [list(pair) for pair in zip(radii, places, strict=True)]
    one = int(random.integers(1, 4))
    corners[one], corners[one + 1] = corners[one + 1], corners[one]
    radius = HEAD + 'x_is = "radius"'
    with pytest.raises(JobError) as caught:
        job_of(str(corners), radius)
    refusal = caught.value
    assert refusal.code in ("profile-crossing", "profile-undercut")
    if refusal.code == "profile-undercut":
        return
    at = [float(number) for number in re.findall(PLACE, refusal.value)[0]]
    assert LineString([(z, r) for r, z in corners]).distance(Point(at)) < 1e-3
    named = [float(number) for number in re.findall(PLACE, refusal.advice)[0]]
    number = next(n for n, (r, z) in enumerate(corners) if (z, r) == tuple(named))
    if "move" in refusal.advice:
        z, r = map(float, re.findall(PLACE, refusal.limit)[0])
        corners[number] = [r, z]
    else:
        fewer = int(refusal.limit.split()[0])
        del corners[number + 1 : number + 1 + fewer]
    job_of(str(corners), radius)


@pytest.mark.parametrize(
    ("head", "says"),
    [
        (HEAD.replace('"part"', '"shaft"'), "which the job does not have: it has part"),
        (HEAD.replace("tool = 1, p", "tool = 7, p"), "uses tool 7, which the job does not have: it has 1"),
        (HEAD.replace("face_mm = 1", "bore_mm = 20"), "belongs to a stock of the form 'tube'"),
        (HEAD + "start = [40, 0]", "its z must be at least 1 mm, or its x outside 55 mm"),
        (HEAD.replace("turn_finish", "turn_mill"), "a lathe has no cycle 'turn_mill'"),
        (HEAD.replace('profile = "part"', 'profile = "part", ap = 3'), "ap"),
    ],
)
def test_jobs_whose_parts_do_not_fit_are_refused(head, says):
    with pytest.raises(JobError) as refusal:
        job_of("[[40, 0], [40, -10]]", head)
    assert says in str(refusal.value)
