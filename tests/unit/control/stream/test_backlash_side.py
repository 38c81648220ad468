# SPDX-License-Identifier: LGPL-2.1-or-later
"""On which side of its gap a job's lines leave each motor, and the way back to there."""

from __future__ import annotations

import pytest

from CNCStepper.control.stream.backlash_side import BacklashTracker, backlash_tracker
from CNCStepper.control.stream.planned_path import PlannedPath
from CNCStepper.errors import JobError
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.job.make_certificate import send_job
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.state import Start

PLAY = Backlash((0.5, 0.25, 0.125), (-1, 1, -1), (80.0, 80.0, 400.0))


def left_by(*lines: str) -> BacklashTracker:
    gaps = BacklashTracker(PLAY)
    PlannedPath(lines, Start.at_zero(), gaps=gaps).read(len(lines))
    return gaps


def job_on(machine: Machine):
    return send_job(prepare("G1X1F600\nM2\n"), machine, "part ç.nc")


@pytest.mark.parametrize(
    ("lines", "ahead_mm"),
    [
        ((), (0.0, 0.0, 0.0)),
        (("G1X1Y1Z1F600",), (0.5, 0.0, 0.125)),
        (("G1X1Y1Z1F600", "X0.5Y0.75Z0"), (0.0, -0.25, 0.0)),
        (("G1X1F600", "X0.75"), (0.25, 0.0, 0.0)),  # half of its gap
        (("G91G2X5Y5I5F600",), (0.5, 0.0, 0.0)),
    ],
)
def test_motor_is_ahead_on_the_side_to_which_it_went_last(lines: tuple[str, ...], ahead_mm: tuple[float, ...]) -> None:
    assert left_by(*lines).ahead_mm == pytest.approx(ahead_mm)


def test_way_back_moves_no_axis_that_stands_as_it_stood() -> None:
    gaps = left_by("G0Z5", "G1X3Y3Z-1F600", "Z-0.5")
    there_mm = (3.0, 3.0, -0.5)
    assert list(gaps.way_back((3.0, 3.0, -0.5625), there_mm, {2}, 0.0)) == [
        ((None, None, -0.5), 1000.0),
        ((None, None, -0.625), 100.0),
        (there_mm, 100.0),
    ]


def test_way_back_leads_aside_only_where_the_lines_have_been_as_high() -> None:
    gaps = left_by("G0Z5", "G1X3Y3F600", "Z-1")
    assert list(gaps.way_back((3.1, 3.0, -1.0), (3.0, 3.0, -1.0), {0, 2}, -2.0)) == [
        ((None, None, 7.0), 1000.0),
        ((3.0, 3.0, None), 1000.0),
        ((2.5, 3.0, None), 1000.0),
        ((None, None, -1.0), 100.0),
        ((3.0, 3.0, -1.0), 100.0),
    ]


def test_job_without_play_has_no_gaps() -> None:
    assert backlash_tracker(job_on(load_machine("table-a"))) is None


def test_profile_that_nobody_can_read_is_refused() -> None:
    job = job_on(load_machine("table-a"))
    job.retrace["machine"]["axis"]["x"]["backlash_mm"] = 0.1
    assert backlash_tracker(job) is not None
    job.retrace["machine"]["axis"]["x"]["steps_per_mm"] = -1.0
    with pytest.raises(JobError) as caught:
        backlash_tracker(job)
    assert caught.value.code == "machine-profile"
