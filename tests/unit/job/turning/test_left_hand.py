# SPDX-License-Identifier: LGPL-2.1-or-later
"""Left-hand inserts, from a job to its judged part: a neck behind a shoulder, which no right-hand insert reaches."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from CNCStepper.job.turning.make_turning import in_part, make_turning, placement_of, turned_moves
from CNCStepper.job.turning.report import judge_turning, setup_of
from CNCStepper.job.turning.turning_job import turning_job_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.turning.swept_outline import moves_of

LEFT_HAND = """
machine = "linuxcnc-lathe"
process = "turning"
x_is = "radius"
start = [37.5, 6]
stock = { diameter_mm = 55, length_mm = 130 }
tool = [{ number = 1, kind = "turning", hand = "left", lead_deg = 93, spindle_rpm = 500, feed_mm_rev = 0.2 }]
profile = [{ name = "neck", points = [
    [27.5, -20], [21, -20], [21, -30], { to = [23, -33], arc = "cw", radius_mm = 8 }, [23, -35], [27.5, -44]] }]
[[operation]]
cycle = "turn_rough"
tool = 1
profile = "neck"
ap_mm = 1.5
stock_to_leave_mm = 0.2
[[operation]]
cycle = "turn_finish"
tool = 1
profile = "neck"
"""


@pytest.mark.parametrize("along", ["z", "x", "profile"])
@pytest.mark.parametrize(
    "insert",
    [
        {"insert": "VBMT 160404"},
        {"nose_radius_mm": 0.4, "front_deg": 93.0, "back_deg": 130.0, "orientation": 1},
        {"insert": "VBMT 160404", "orientation": 9},
    ],
)
def test_a_neck_behind_a_shoulder_is_cut_by_a_left_hand_insert(insert, along):
    content = tomllib.loads(LEFT_HAND)
    content["tool"][0] |= insert
    content["operation"][0]["along"] = along
    job, machine = turning_job_of(content, Path("left.toml")), load_machine("mini-lathe")
    table, _ = turned_moves(job, machine)
    verdict = judge_turning(moves_of(in_part(table, placement_of(job, machine))), setup_of(job), job.x_is)
    assert [str(finding) for finding in verdict.findings if finding.severity != "info"] == []
    widths_mm = dict(verdict.report()["profile"])
    assert min(widths_mm.values()) == pytest.approx(42.0, abs=0.01)


def test_no_cycle_of_a_controller_goes_away_from_the_chuck():
    content = tomllib.loads(LEFT_HAND) | {"canned": True}
    content["tool"][0]["insert"] = "VBMT 160404"
    (program,) = make_turning(turning_job_of(content, Path("left.toml")), load_machine("linuxcnc-lathe"))
    assert "G71" not in program.program and "G70" not in program.program
