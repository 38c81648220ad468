# SPDX-License-Identifier: LGPL-2.1-or-later
"""The motor's torque against what a move asks of it, worked out by hand."""

import math
import tomllib
from dataclasses import replace
from pathlib import Path

import pytest

from CNCStepper.machine.profile import Machine, Motor, load_machine
from CNCStepper.simulation.checks.check_program import check
from CNCStepper.state import Start
from helpers.simulation.programs import begun

MACHINES = Path(__file__).parents[4] / "docs" / "user-guide" / "machines.md"
MACHINE = load_machine("table-a")  # X: 5000 mm/min, 250 mm/s²
LOAD = {"travel_per_turn_mm": 10.0, "mass_kg": 8.0, "inertia_kg_m2": 5e-5, "force_n": 40.0, "efficiency": 0.8}
NEEDED = 5e-5 * 0.25 / (0.01 / math.tau) + (8 * 0.25 + 40) * 0.01 / math.tau / 0.8  # Nm while X speeds up


def with_motor(axis: str = "x", **changes) -> Machine:
    motor = Motor(**LOAD | {"torque": ((0, 1.0), (300, 0.8), (600, 0.0))} | changes)
    axes = dict(MACHINE.axis)
    axes[axis] = axes[axis].model_copy(update={"motor": motor})
    return MACHINE.model_copy(update={"axis": axes})


def found(program, machine):
    return check(program.toolpath(), machine, file="p.nc")


def test_the_load_of_a_motor():
    motor = with_motor().axes[0].motor
    assert motor.needed_nm(250) == pytest.approx(NEEDED)
    assert motor.rpm_at(50) == pytest.approx(300)
    speeds = (0, 150, 300, 450, 600, 601)
    assert [motor.torque_at_nm(rpm) for rpm in speeds] == pytest.approx([1, 0.9, 0.8, 0.4, 0, 0])


def test_a_speed_that_leaves_too_little_torque_is_found_at_its_line():
    # 0.0914 Nm are needed: they are there up to 565 rpm, that is 94.3 mm/s; X reaches 83.3 mm/s
    program = begun().rapid(100, 0, 5).feed(0, 0, 5, 3000)
    assert found(program, with_motor()) == []
    weak = with_motor(torque=((0, 1.0), (300, 0.8), (420, 0.05)))  # enough up to 414 rpm, 69 mm/s
    (finding,) = found(program, weak)
    assert (finding.code, finding.severity, finding.place.line, finding.count) == ("motor-torque", "warning", 3, 1)
    assert finding.value == pytest.approx(NEEDED)
    assert (finding.limit, finding.unit) == (0, "Nm")
    assert "of X may lose steps: at 83." in finding.text


def test_what_counts_is_the_speed_that_the_planner_reaches():
    weak = with_motor(torque=((0, 1.0), (300, 0.8), (420, 0.05)))
    short = begun()
    for k in range(1, 20):
        short.rapid(10 * (k % 2), 0, 5)  # 250 mm/s² over 5 mm: 50 mm/s, 300 rpm
    assert found(short, weak) == []
    assert [f.code for f in found(begun().rapid(60, 0, 5), weak)] == ["motor-torque"]


def test_a_slanted_move_asks_less_of_the_axis():
    weak = with_motor(torque=((0, 1.0), (300, 0.8), (420, 0.05)))
    assert found(begun().feed(100, 100, 5, 4900), weak) == []  # 57.7 mm/s in X
    assert [f.code for f in found(begun().feed(100, 1, 5, 4900), weak)] == ["motor-torque"]


def test_acceleration_alone_can_be_too_much():
    weak = with_motor(torque=((0, NEEDED * 0.99), (900, NEEDED * 0.99)))
    assert [f.code for f in found(begun().feed(10, 0, 5, 60), weak)] == ["motor-torque"]
    assert found(begun().feed(10, 0, 5, 60), with_motor(torque=((0, NEEDED * 1.01), (900, NEEDED * 1.01)))) == []


def test_an_unknown_start_and_a_table_without_moves():
    assert found(begun(), with_motor()) == []
    path = begun().rapid(1, 0, 5).toolpath()
    assert check(replace(path, start=Start()), with_motor())[0].code == "place-unknown"


@pytest.mark.parametrize("torque", [(), ((100, 1), (50, 1)), ((0, -1.0),)])
def test_a_torque_curve_rises_in_speed(torque):
    with pytest.raises(ValueError):
        with_motor(torque=torque)


def test_the_motor_of_the_machines_page_is_read():
    examples = [part.split("```")[0] for part in MACHINES.read_text("utf-8").split("```toml\n")[1:]]
    (text,) = (part for part in examples if part.startswith("[axis.x.motor]"))
    motor = Motor(**tomllib.loads(text)["axis"]["x"]["motor"])
    assert motor.torque_at_nm(450) == pytest.approx(0.75)
