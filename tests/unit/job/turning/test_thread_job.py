# SPDX-License-Identifier: LGPL-2.1-or-later
"""Threads as jobs: made, proven, read by rs274, cut by the virtual lathe; a cylinder, a cone, a bore; refusals."""

from __future__ import annotations

import tomllib
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.cycles.turning.thread_standards import thread_named
from CNCStepper.cycles.turning.turn_thread import thread_form
from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from CNCStepper.job.turning.make_turning import in_part, make_turning, placement_of, turned_moves
from CNCStepper.job.turning.report import judge_turning, setup_of
from CNCStepper.job.turning.turning_job import load_turning_job, turning_job_of
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.virtual.lathe.machine import Lathe
from helpers.control.twin_bench import send
from helpers.gcode.rs274_runs import NUMBER, rs274_calls, same_call

ROOT = Path(__file__).parents[4]
INDEX = "mini-lathe:thread_start=index"
HEAD = """
machine = "mini-lathe"
process = "turning"
x_is = "radius"
start = [32, 8]
stock = { diameter_mm = 50, length_mm = 120 }
tool = [{ number = 2, kind = "threading", insert = "16ER AG60", spindle_rpm = 90 }]
"""
CYLINDER = 'profile = [{ name = "part", points = [[24.93, 0], [24.93, -60], [25, -60]] }]'
CONE = 'profile = [{ name = "part", points = [[20, 0], [25, -100]] }]'
THREAD = 'cycle = "turn_thread", tool = 2, profile = "part", thread = "M50x1.5", first_depth_mm = 0.3'
TAPER = THREAD.replace("M50x1.5", "M24") + ", diameter_mm = 40, taper_deg = 2.862405, length_mm = 50"
JOBS = {
    "cylinder": (CYLINDER, THREAD + ", length_mm = 40, pull_out_mm = 2"),
    "two starts": (CYLINDER, THREAD + ', length_mm = 30, starts = 2, infeed = "radial"'),
    "cone": (CONE, TAPER),
}


def machine_of(controller: str) -> Machine:
    return load_machine("mini-lathe").model_copy(update={"controller": controller, "tool_change": "pause"})


def job_of(profile: str, operation: str, more: str = ""):
    return turning_job_of(tomllib.loads(f"{HEAD}{more}\n{profile}\noperation = [{{ {operation} }}]"), ROOT / "job.toml")


@pytest.mark.parametrize("name", JOBS)
def test_a_thread_is_cut_to_its_floor_and_no_deeper(name):
    job, machine = job_of(*JOBS[name]), machine_of(INDEX)
    table, (answer,) = turned_moves(job, machine)
    verdict = judge_turning(moves_of(in_part(table, placement_of(job, machine))), setup_of(job), job.x_is)
    refusals = [finding for finding in verdict.findings if finding.severity == "refusal"]
    # the bar of a cone's job was not roughed: its thread is cut out of the full diameter
    assert not refusals or (name == "cone" and all("deep" in str(one) or "rapid" in str(one) for one in refusals)), (
        refusals
    )
    operation = job.operation[0]
    floor_mm = answer.figures["floor_diameter_mm"]
    slope = 0.1 if name == "cone" else 0.0  # of the diameter
    profile = np.array(verdict.report()["profile"])
    inside = profile[(profile[:, 0] < -2.0) & (profile[:, 0] > -operation.length_mm + 4.0)]
    depths = inside[:, 1] - (floor_mm - slope * inside[:, 0])
    assert depths.min() == pytest.approx(0.0, abs=0.01)
    pitch = thread_named(operation.thread).pitch_mm
    floors = inside[depths < 0.02, 0]
    gaps = np.diff(np.sort(floors))
    assert gaps[gaps > pitch / 2].mean() == pytest.approx(pitch, rel=0.1)


@pytest.mark.parametrize("name", JOBS)
def test_the_virtual_lathe_begins_every_pass_at_the_same_angle_and_comes_back(name):
    job, machine = job_of(*JOBS[name]), machine_of(INDEX)
    (program,) = make_turning(job, machine)
    twin = Lathe(machine, thread_start=True, spindle_rpm=90.0, buffer_bytes=100_000)
    send(twin, b"Y")
    rows = np.array(send(twin, program.program.encode()))
    assert not twin.refused and twin.places == [0, 0]
    axial = np.diff(rows[:, 2]) > 0.0
    waits = np.diff(rows[:, 0])
    begins = np.flatnonzero(axial & (waits > 1.5 * np.median(waits[axial])))
    turns = (rows[begins + 1, 0] * 90.0 / 60.0 + 0.5) % 1.0 - 0.5
    at_index = (turns > 0.0) & (turns < 0.02)  # a step after it
    form = thread_form(job.operation[0])
    assert at_index.sum() == program.answers[0].figures["passes"] * form.starts
    assert np.ptp(turns[at_index]) < 1e-6


@pytest.mark.parametrize("name", ["cylinder", "two starts"])
@pytest.mark.parametrize("x_is", ["radius", "diameter"])
def test_rs274_and_our_reader_make_the_same_moves_of_g76_and_of_g33(name, x_is, tmp_path):
    traces = []
    for canned in ("true", "false"):
        profile, operation = JOBS[name]
        text = f"{HEAD}canned = {canned}\n{profile}\noperation = [{{ {operation} }}]"
        job = turning_job_of(tomllib.loads(text), ROOT / "job.toml").model_copy(update={"x_is": x_is})
        (program,) = make_turning(job, machine_of("linuxcnc"))
        assert ("G76" in program.program) == (canned == "true")
        calls, accepted = rs274_calls(program.program, tmp_path)
        assert accepted, calls[-1]
        assert all(map(same_call, canonical_calls(program.program), calls))
        found: list[list[float]] = []
        for call in calls:
            if "STRAIGHT_" in call:
                numbers = [float(word) for word in NUMBER.findall(call.split("STRAIGHT_")[1])]
                found += [] if found and found[-1] == numbers else [numbers]
        traces.append(np.array(found))
    assert traces[0].shape == traces[1].shape and np.abs(traces[0] - traces[1]).max() < 0.0011


def test_the_example_is_made_in_two_programs():
    job, machine = load_turning_job(ROOT / "examples" / "jobs" / "lathe-thread.toml")
    first, second = make_turning(job, machine)
    assert "F2.25" in second.program and "turn thread" in second.program and second.answers[0].figures["lead_mm"] == 1.5
    assert "turn finish" in first.program


@pytest.mark.parametrize(
    ("controller", "operation", "code", "words"),
    [
        ("mini-lathe", THREAD + ", length_mm = 40", "no-thread", "thread_start=index"),
        (INDEX, THREAD + ", length_mm = 70", "thread-cylinder", "length_mm = 60"),
        (INDEX, THREAD + ", length_mm = 40, spindle_rpm = 1000", "thread-speed", "at most 925.9 rpm"),
        (INDEX, THREAD.replace("M50x1.5", "M50x1.4") + ", length_mm = 40", "thread-unknown", "1.5"),
        (INDEX, THREAD.replace("M50x1.5", "M50") + ", length_mm = 40", "thread-unknown", "such as M50x1.5"),
        (INDEX, THREAD + ", length_mm = 1, pull_out_mm = 2", "thread-length", "lengthen"),
    ],
)
def test_what_cannot_be_is_refused_with_what_would_do(controller, operation, code, words):
    with pytest.raises(CNCStepperError) as refusal:
        make_turning(job_of(CYLINDER, operation), machine_of(controller))
    assert refusal.value.code == code and words in str(refusal.value)


def test_a_left_hand_insert_is_refused_and_one_pass_for_the_whole_depth_is_told():
    job = job_of(CYLINDER, THREAD.replace("0.3", "5") + ", length_mm = 40")
    (program,) = make_turning(job, machine_of(INDEX))
    (warning,) = (each for each in program.answers[0].warnings if "whole depth" in each)
    assert "0.9062 mm" in warning and "first_depth_mm" in warning
    tool = job.tool[0].model_copy(update={"hand": "left"})
    with pytest.raises(CNCStepperError) as refusal:
        make_turning(job.model_copy(update={"tool": (tool,)}), machine_of(INDEX))
    assert refusal.value.code == "thread-hand" and "ER outside" in str(refusal.value)
