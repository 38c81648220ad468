# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lathe jobs in Fanuc's and Mach's languages: read back they are the moves and feeds that LinuxCNC's program makes."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import numpy as np
import pytest
import shapely

from CNCStepper.errors import CNCStepperError, ProgramError
from CNCStepper.gcode.edit.feed_scaling import scale_feeds
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.lathe.diameter_mode import x_is
from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.prove_turning import prove_turning
from CNCStepper.job.turning.turning_job import TurningJob, turning_job_of
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath
from helpers.cycles.seeds import SEEDS
from helpers.job.random_turning import random_job

LANGUAGES = ("fanuc-lathe", "mach-turn")
WAYS = [{}, {"inside": True}, {"along": "x"}]
THREAD = """
machine = "linuxcnc-lathe"
process = "turning"
x_is = "radius"
start = [32, 8]
stock = { diameter_mm = 50, length_mm = 120 }
tool = [{ number = 2, kind = "threading", insert = "16ER AG60", spindle_rpm = 90 }]
profile = [{ name = "part", points = [[20, 0], [25, -100]] }]
[[operation]]
cycle = "turn_thread"
tool = 2
profile = "part"
thread = "M24"
first_depth_mm = 0.3
diameter_mm = 40
taper_deg = 2.862405
length_mm = 50
pull_out_mm = 2
"""
SURFACE = """
machine = "linuxcnc-lathe"
process = "turning"
stock = { diameter_mm = 60, face_mm = 1, length_mm = 100 }
tool = [{ number = 1, insert = "CNMG 120408", feed_mm_rev = 0.2, feed_max_mm_rev = 0.21, ap_max_mm = 3 }]
profile = [{ name = "part", points = [[50, 0], [50, -30]] }]
operation = [
    { cycle = "turn_face", tool = 1, constant_surface_speed = true, surface_speed_m_min = 120, max_rpm = 2000 },
    { cycle = "turn_finish", tool = 1, profile = "part", spindle_rpm = 800 }]
"""


def machine_of(controller: str) -> Machine:
    if controller in LANGUAGES:
        return load_machine(controller)
    return load_machine("linuxcnc-lathe").model_copy(update={"controller": controller})


def job_of(text: str) -> TurningJob:
    return turning_job_of(tomllib.loads(text), Path("job.toml"))


def made(job: TurningJob, controller: str) -> tuple[str, Toolpath]:
    """Return a job's program and what our reader makes of it."""
    (program,) = make_turning(job, machine_of(controller))
    return program.program, interpret(program.program, Start(), controller)


def assert_same_moves(one: Toolpath, other: Toolpath) -> None:
    """Compare kinds, ends and feeds, within a last digit."""
    first, second = one.table(), other.table()
    assert first.kind.tolist() == second.kind.tolist()
    assert np.allclose(first.end[:, [0, 2]], second.end[:, [0, 2]], atol=0.0011)
    cuts = first.kind > 0
    assert np.allclose(first.feed[cuts], second.feed[cuts], rtol=1e-3)
    rpm = [[path.states[state].spindle_rpm for state in path.table().state[cuts]] for path in (one, other)]
    assert np.allclose(*rpm, rtol=1e-3)


def farthest_mm(one: Toolpath, other: Toolpath) -> float:
    """Return how far the ends of one path are at most from the nearest ends of the other."""
    first, second = (path.table().end[:, [0, 2]] @ (1.0, 1.0j) for path in (one, other))
    return float(np.abs(first[:, None] - second[None, :]).min(axis=1).max())


@pytest.mark.parametrize("seed", SEEDS[::5])
def test_a_random_part_is_the_same_in_every_language(seed):
    job = random_job(seed, "linuxcnc-lathe", **WAYS[seed % len(WAYS)]).model_copy(update={"x_is": "diameter"})
    _, expected = made(job, "linuxcnc")
    for language, code in (("fanuc-lathe", "G99"), ("mach-turn", "G95")):
        text, path = made(job, language)
        assert max(farthest_mm(expected, path), farthest_mm(path, expected)) < 0.0011
        assert x_is(text, language) == "diameter" and text.count(code) == 1
    assert_same_moves(expected, made(job, "fanuc-lathe")[1])  # Mach's has a digit more


@pytest.mark.parametrize("seed", SEEDS[:3])
def test_cycles_in_two_blocks_cut_the_part_of_the_moves(seed, tmp_path):
    job = random_job(seed, "linuxcnc-lathe", **WAYS[seed % len(WAYS)]).model_copy(update={"x_is": "diameter"})
    volumes_mm3, texts = [], []
    for canned in (False, True):
        asked, machine = job.model_copy(update={"canned": canned}), machine_of("fanuc-lathe")
        programs = make_turning(asked, machine)
        (proven,) = prove_turning(asked, machine, programs, tmp_path)
        assert [str(found) for found in proven.verdict.findings if found.severity != "info"] == []
        volumes_mm3.append(proven.verdict.report()["volume_mm3"])
        texts.append(programs[0].program)
    assert volumes_mm3[1] == pytest.approx(volumes_mm3[0], rel=2e-5)
    assert ("G71 P101" in texts[1] or job.operation[-2].along == "x") and "P101" not in texts[0]


def test_a_finishing_pass_along_the_roughed_path_is_g70():
    operation = {"tool": 1, "profile": "part", "spindle_rpm": 800}
    rough = {**operation, "cycle": "turn_rough", "ap_mm": 2, "stock_to_leave_mm": 0.0}
    finish = {**operation, "cycle": "turn_finish", "feed_mm_rev": 0.1}
    content = tomllib.loads(SURFACE) | {"operation": [rough, finish], "canned": True}
    text, path = made(turning_job_of(content, Path("job.toml")), "fanuc-lathe")
    lines = text.splitlines()
    at = lines.index("G71 U2. R0.3")
    assert lines[at + 1] == "G71 P101 Q104 U0. W0. F0.2" and lines[at + 2].startswith("N101 ")
    assert "G70 P101 Q104 F0.1" in lines[at + 6 :]
    expanded = made(turning_job_of(content | {"canned": False}, Path("job.toml")), "fanuc-lathe")[1]
    assert path.table().end[:, 0].min() == pytest.approx(expanded.table().end[:, 0].min())
    last_cuts = [one.table().feed[one.table().kind > 0][-3:] for one in (path, expanded)]
    assert np.allclose(*last_cuts) and np.allclose(last_cuts[0], 80.0)


@pytest.mark.parametrize("inside", [False, True])
def test_a_cylindrical_thread_is_g76_in_two_blocks_and_the_part_is_that_of_its_passes(inside, tmp_path):
    content = tomllib.loads(THREAD) | {"x_is": "diameter", "start": [64, 8]}
    content["profile"] = [{"name": "part", "points": [[24, 0], [24, -80]]}]
    content["stock"] |= {"diameter_mm": 24, "form": "bar"}
    operation = content["operation"][0]
    del operation["taper_deg"], operation["diameter_mm"]
    operation["pull_out_mm"] = 0.9  # three tenths of the lead
    if inside:
        content["tool"][0] |= {"kind": "threading", "insert": "16IR AG60"}
        content["stock"] = {"form": "tube", "diameter_mm": 60, "bore_mm": 20.752, "length_mm": 120}
        content["profile"], content["start"] = [{"name": "part", "points": [[20.752, 0], [20.752, -80]]}], [18, 8]
    machine, regions, texts = machine_of("fanuc-lathe"), [], []
    for canned in (False, True):
        job = turning_job_of(content | {"canned": canned}, Path("job.toml"))
        programs = make_turning(job, machine)
        (proven,) = prove_turning(job, machine, programs, tmp_path)
        regions.append(proven.verdict.part.region)
        texts.append(programs[0].program.splitlines())
    first, second = (line.split() for line in texts[1] if line.startswith("G76"))
    assert first == ["G76", "P020360", "Q1", "R0."] and second[-1] == "F3."
    depth, cut = (int(word[1:]) for word in second[3:5])
    assert cut * math.sqrt(math.ceil((depth / 300) ** 2)) >= depth and cut <= 300  # as many passes as G32 makes
    assert not any("G32" in line for line in texts[1]) and any("G32" in line for line in texts[0])
    thread = shapely.box(-49.0, 0.0, 10.0, 100.0)  # the pull-out itself is at 45 degrees
    assert shapely.intersection(shapely.symmetric_difference(*regions), thread).area < 0.02
    assert regions[0].area < job.stock.diameter_mm / 2 * 119
    operation["pull_out_mm"] = 0.2  # less than a tenth of the lead: G76 has no digit for it
    assert "G76" not in made(turning_job_of(content | {"canned": True}, Path("job.toml")), "fanuc-lathe")[0]


def test_a_program_for_fanuc_is_proven_as_any_other(tmp_path):
    job, machine = random_job(4, "linuxcnc-lathe").model_copy(update={"x_is": "diameter"}), machine_of("fanuc-lathe")
    (proven,) = prove_turning(job, machine, make_turning(job, machine), tmp_path)
    assert [str(found) for found in proven.verdict.findings if found.severity != "info"] == []


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_control_set_to_radii_gets_radii(language):
    job = random_job(1, "linuxcnc-lathe")
    _, path = made(job, f"{language}:x=radius")
    assert farthest_mm(made(job, "linuxcnc")[1], path) < 0.0011
    for controller, meaning in ((language, "radius"), (f"{language}:x=radius", "diameter")):
        with pytest.raises(ProgramError) as refusal:
            made(job.model_copy(update={"x_is": meaning}), controller)
        assert refusal.value.code == "diameter" and f"{language}:x={meaning}" in str(refusal.value)


@pytest.mark.parametrize("x_is", ["radius", "diameter"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_conical_thread_is_written_as_g32_with_its_lead_along_z(language, x_is):
    job = job_of(THREAD).model_copy(update={"x_is": x_is})
    controller = language if x_is == "diameter" else f"{language}:x=radius"
    text, path = made(job, controller)
    passes = [line for line in text.splitlines() if line.startswith("G32")]
    assert len(passes) > 5 and all(line.split()[-1] in ("F3", "F3.") for line in passes)  # M24 has 3 mm
    expected = made(job, "linuxcnc")[1]
    assert_same_moves(expected, path)
    leads = [[event.value for event in one.events if event.kind == "synchronised"] for one in (expected, path)]
    assert np.allclose(*leads, rtol=3e-4)  # of ends that are rounded
    with pytest.raises(ProgramError, match="lead of the thread"):
        scale_feeds(text, 2.0, controller, Start())


def test_fanuc_limits_the_speed_of_g96_by_g50():
    text, path = made(job_of(SURFACE), "fanuc-lathe")
    lines = text.splitlines()
    at = lines.index("G50 S2000")
    assert lines[at + 1] == "G96 S120" and lines.index("G97 S800") > at and "G21 G18" in lines
    assert_same_moves(made(job_of(SURFACE), "linuxcnc")[1], path)


def test_mach_has_no_word_for_the_limit_of_g96():
    with pytest.raises(CNCStepperError) as refusal:
        made(job_of(SURFACE), "mach-turn")
    assert refusal.value.code == "surface-speed" and "spindle_rpm = " in str(refusal.value)


@pytest.mark.parametrize(
    ("line", "advice"),
    [
        ("G76 P1.5 X18.16 Z-30 H0.3 I29 C2", "each pass as G32 with the lead in F"),
        ("G77 X20 Z-10 F0.2", "its moves as G0 and G1"),
        ("G78 X20 Z-10 F0.2", "its moves as G0 and G1"),
    ],
)
def test_the_cycles_of_mach_that_are_macros_of_the_machine_are_refused_by_name(line, advice):
    with pytest.raises(ProgramError) as refusal:
        interpret(f"G21 G18 G90\nM3 S500\nG95 F0.2\nG0 X30 Z5\n{line}\nM2\n", Start.at_zero(), "mach-turn")
    assert line.split()[0] in str(refusal.value) and advice in str(refusal.value) and refusal.value.place.line == 5
