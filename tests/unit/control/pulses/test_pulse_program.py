# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which programs this computer sends as pulses itself, and how fast: all refusals come before the first pulse."""

from __future__ import annotations

import numpy as np
import pytest

from CNCStepper.control.pulses.program import BUSY_WRITES, PeakRate, PulseProgram
from CNCStepper.errors import JobError, MachineRefusal
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.wiring import Signals
from CNCStepper.state import Start

MACHINE = load_machine("table-a")
XYZ = {f"{axis}_{what}": 2 + 2 * n + k for n, axis in enumerate("xyz") for k, what in enumerate(("step", "direction"))}


def program(text: str, machine: Machine = MACHINE) -> PulseProgram:
    path = interpret("G21 G90 G17 G94\n" + text + "\nM2\n", Start.at_zero(), "linuxcnc", "job.ngc")
    return PulseProgram.of(path, machine, "job.ngc")


def wired(**more: object) -> Machine:
    return MACHINE.model_copy(update={"signals": Signals(**more)})


@pytest.mark.parametrize(
    "line",
    ["M0", "M1", "T1 M6", "M66 P0 L3 Q5", "M19 R90", "S100 M3\nG33 Z-1 K1", "G38.2 Z-1 F50", "M67 E0 Q1", "M68 E0 Q1"],
)
def test_what_waits_or_has_no_line_is_refused_with_its_line(line: str) -> None:
    with pytest.raises(JobError, match="drive-stop") as caught:
        program(f"G0 X1\n{line}")
    assert caught.value.place.line == 3 + line.count("\n")


def test_dwells_outputs_and_messages_pass() -> None:
    job = program("(MSG, olá)\nM64 P0\nG4 P0.5\nT1\nG0 X1\nM65 P0", wired(pins=XYZ | {"output_0": 9}))
    assert sum(map(len, job.chunks())) > 2 * 80


@pytest.mark.parametrize(("line", "device"), [("S100 M3", "spindle_cw"), ("M8", "flood"), ("M64 P1", "output_1")])
def test_a_device_that_is_on_no_pin_is_refused_before_the_first_pulse(line: str, device: str) -> None:
    job = program(f"{line}\nG1 X5 F100", wired(pins=XYZ))
    with pytest.raises(MachineRefusal, match=f"{device} is on no pin"):
        job.pace()
    used = wired(pins=XYZ | {device: 9})
    assert program(f"{line}\nG1 X5 F100", used).pace().idle == (0, 0b1011)


def test_an_output_without_a_line_is_refused_too() -> None:
    with pytest.raises(MachineRefusal, match="output_7 is on no pin"):
        program("M64 P7").pace()


def test_pulses_that_the_signals_cannot_follow_are_refused_by_the_dry_pass() -> None:
    """The last move is the one that is too fast: 3000 mm/min are 4000 pulses/s, and each takes 600 us here."""
    slow = wired(pulse_us=300, gap_us=300)
    assert program("G1 X3 F100", slow).pace().keep_us == 300
    with pytest.raises(MachineRefusal, match="faster than the signals"):
        program("G1 X3 F100\nG1 X90 F3000", slow).pace()


def test_the_pace_is_that_of_the_fastest_stretch() -> None:
    """2400 mm/min at 80 steps/mm are 3200 pulses/s, two writes each; two axes together share their moments."""
    assert MACHINE.axes[0].steps_per_mm == MACHINE.axes[1].steps_per_mm == 80
    assert program("G1 X2 F60\nG1 X40 F2400\nG1 X41 F60").pace().writes_per_s == pytest.approx(6400, rel=0.02)
    assert program("G1 X30 Y30 F2400").pace().writes_per_s == pytest.approx(6400 / 2**0.5, rel=0.03)
    assert program("G1 X1 F60").pace().writes_per_s == 1000.0
    assert program("G4 P1").pace().writes_per_s == 1000.0


def test_pulses_stay_apart_by_the_longest_of_their_times() -> None:
    for name in ("pulse_us", "gap_us", "direction_setup_us"):
        assert program("G1 X1 F60", wired(**{name: 35})).pace().keep_us == 35


@pytest.mark.parametrize("size", [1, 7, 10_000])
def test_the_busiest_stretch_is_found_over_chunks_of_any_size(size: int) -> None:
    ticks = np.cumsum(np.r_[np.full(300, 100), np.full(BUSY_WRITES, 10), np.full(300, 90)])
    busiest = PeakRate()
    for first in range(0, len(ticks), size):
        busiest.add(ticks[first : first + size])
    assert busiest.per_s(1000) == 100
    few = PeakRate()
    few.add(np.array([5, 15, 25]))
    assert few.per_s(1000) == 100 and PeakRate().per_s(1000) == 0


def test_the_checks_of_the_machine_are_of_the_motors() -> None:
    """Travel must leave room for what takes up the backlash."""
    there_and_back = "G1 X-5 F600\nG1 X0"
    assert MACHINE.axes[0].travel_max_mm == 0 and not program(there_and_back).errors()
    first = MACHINE.axes[0].model_copy(update={"backlash_mm": 0.5})
    machine = MACHINE.model_copy(update={"axis": MACHINE.axis | {"x": first}})
    assert [finding.code for finding in program(there_and_back, machine).errors()] == ["travel"]
