# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is too weak for a lathe's cut is said at its operation, with the number that would do."""

from __future__ import annotations

import tomllib
from pathlib import Path

from CNCStepper.job.turning.make_turning import make_turning
from CNCStepper.job.turning.turning_job import TurningJob, turning_job_of
from CNCStepper.job.turning.turning_transfer import last_cut
from CNCStepper.machine.materials import material
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.turning_forces import TurningCut

JOB = """
machine = "mini-lathe"
process = "turning"
material = "{material}"
stock = {{ diameter_mm = {diameter}, face_mm = 1, length_mm = {length} }}
chuck = {{ grip_n = {grip} }}
tool = [{{ number = 1, insert = "CNMG 120408", spindle_rpm = {rpm}, feed_mm_rev = 0.3 }}]
operation = [{{ cycle = "turn_rough", tool = 1, profile = "part", ap_mm = 0.5 }}]
profile = [{{ name = "part", points = [[28, 0], [28, -60]] }}]
"""
STRONG = {"material": "pvc", "diameter": 40, "length": 100, "grip": 5000, "rpm": 500}


def warnings(power_w: float = 5000, **changes: object) -> tuple[str, ...]:
    job, machine = made(power_w, changes)
    (program,) = make_turning(job, machine)
    return program.answers[0].warnings


def made(power_w: float, changes: dict[str, object]) -> tuple[TurningJob, Machine]:
    machine = load_machine("mini-lathe")
    strong = machine.model_copy(update={"spindle": machine.spindle.model_copy(update={"power_w": power_w})})
    return turning_job_of(tomllib.loads(JOB.format(**STRONG | changes)), Path("job.toml")), strong


def test_a_cut_that_all_bear_is_not_warned_of() -> None:
    assert warnings() == ()


def test_a_weak_motor_chuck_and_bar_are_each_said_with_the_number_that_would_do() -> None:
    (program,) = make_turning(*made(5000, {}))
    cut = TurningCut(material("pvc").turning_data(), 40.0, program.answers[0].figures["ap_mm"], 0.3, 500.0)
    (motor,) = warnings(power_w=20)
    assert "more power than the motor has" in motor and f"{cut.power_w:.4g} W, limit 20 W" in motor
    (chuck,) = warnings(grip=20)
    assert "may turn in the chuck" in chuck and f"{cut.torque_nm:.4g} Nm" in chuck
    slender, bends = warnings(length=165)
    assert "the bar is slender" in slender and "at most 160 mm" in slender and "cut 0.2" in bends
    assert warnings(power_w=1, material="") == ()


def test_the_window_hears_of_the_nearest_preset_speed() -> None:
    (said,) = last_cut(*made(5000, {"rpm": 480}))[1]
    assert said == "the spindle turns at 500 rpm, the nearest of the machine's speeds to 480 rpm"
    assert last_cut(*made(5000, {}))[1] == ()
