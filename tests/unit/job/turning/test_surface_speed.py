# SPDX-License-Identifier: LGPL-2.1-or-later
"""Constant surface speed: G96 with its limit in the text, times and chips judged with the speed at each X."""

from __future__ import annotations

import tomllib
from math import log, pi
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import turning_job_of
from CNCStepper.machine.profile import load_machine
from CNCStepper.simulation.turning.swept_outline import moves_of
from helpers.gcode.rs274_runs import rs274_calls, same_call

HEAD = """
machine = "linuxcnc-lathe"
process = "turning"
x_is = "{x_is}"
start = [80, 10]
stock = {{ diameter_mm = 60, face_mm = 1, length_mm = 100 }}
tool = [{{ number = 1, insert = "CNMG 120408", feed_mm_rev = 0.2, feed_max_mm_rev = 0.21, ap_max_mm = 3, {tool} }}]
profile = [{{ name = "part", points = [[{x}, 0], [{x}, -30]] }}]
operation = [{{ cycle = "turn_face", tool = 1, ap_mm = 1, {speed} }},
    {{ cycle = "turn_rough", tool = 1, profile = "part", ap_mm = 2, {speed} }},
    {{ cycle = "turn_finish", tool = 1, profile = "part", spindle_rpm = 800 }}]
"""
CONSTANT = "constant_surface_speed = true, surface_speed_m_min = 120, max_rpm = 2000"


def job_of(x_is: str = "diameter", speed: str = CONSTANT, tool: str = "spindle_rpm = 500", **more: object):
    x = 50 if x_is == "diameter" else 25
    content = tomllib.loads(HEAD.format(x_is=x_is, speed=speed, tool=tool, x=x))
    return turning_job_of(content | more, Path("job.toml"))


@pytest.mark.parametrize("canned", [False, True])
@pytest.mark.parametrize("x_is", ["diameter", "radius"])
def test_the_text_has_g96_with_its_limit_and_rs274_reads_the_same(x_is, canned, tmp_path):
    machine = load_machine("linuxcnc-lathe")
    job = job_of(x_is, canned=canned)
    (program,) = make_turning(job, machine)
    lines = program.program.splitlines()
    assert lines.count("G96 D2000 S120") == 1 and lines.count("G97 S800") == 1
    assert lines.index("G96 D2000 S120") < lines.index("M3") < lines.index("G97 S800")
    assert sum("F0.2" in line for line in lines) == 1  # the feed a turn stays, whatever the speed
    theirs, is_taken = rs274_calls(program.program, tmp_path)
    ours = list(canonical_calls(program.program))
    assert is_taken and [pair for pair in zip(ours, theirs, strict=True) if not same_call(*pair)] == []
    (proven,) = prove_turning(job, machine, [program], tmp_path)
    assert [str(found) for found in proven.proof.findings if found.severity == "error"] == []
    assert "chip-load" not in {found.code for found in proven.proof.findings}


def test_a_faced_end_takes_the_time_of_the_speeds_at_its_radii():
    (program,) = make_turning(job_of(), load_machine("linuxcnc-lathe"))
    path = interpret(program.program, None, "linuxcnc")
    table = path.table()
    row = int(np.flatnonzero((table.kind == 1) & (table.end[:, 0] < 0.0))[0])
    begin = path.begins()[row]
    # a turn takes 2 pi r / v down to the radius of the highest speed, then its time: dr / (f n(r))
    slow_mm, outer_mm = 120e3 / (2 * pi * 2000), float(begin[0])
    past_mm = -float(table.end[row, 0])  # over the axis by the nose
    turns_min = (slow_mm + past_mm) / 2000 + (outer_mm**2 - slow_mm**2) * pi / 120e3
    assert (outer_mm + past_mm) / float(table.feed[row]) == pytest.approx(turns_min / 0.2, rel=1e-6)
    assert log(2000 / path.states[int(table.state[row])].spindle_rpm) == pytest.approx(0.0, abs=1e-9)
    assert moves_of(path).feed_mm_turn[row] == pytest.approx(0.2)


def test_too_thick_a_chip_is_found_under_g96_too(tmp_path):
    job, machine = job_of(), load_machine("linuxcnc-lathe")
    (program,) = make_turning(job, machine)
    thick = program.__class__(1, 0, program.program.replace("F0.2", "F0.3"), program.answers)
    (proven,) = prove_turning(job, machine, [thick], tmp_path)
    assert "chip-load" in {found.code for found in proven.proof.findings}


@pytest.mark.parametrize(
    ("speed", "machine", "says"),
    [
        (CONSTANT, "mini-lathe", "spindle_rpm = 710"),
        ("constant_surface_speed = true", "linuxcnc-lathe", "give spindle_rpm or surface_speed_m_min"),
        (CONSTANT + ", spindle_rpm = 300", "linuxcnc-lathe", "take spindle_rpm out"),
    ],
)
def test_what_cannot_keep_its_surface_speed_is_refused_with_what_would_do(speed, machine, says):
    with pytest.raises(CNCStepperError) as refusal:
        make_turning(job_of(speed=speed), load_machine(machine))
    assert says in str(refusal.value)
