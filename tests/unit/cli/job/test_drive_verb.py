# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper drive` as a stranger uses it, with a recording for a port.

The trial and a stall are made harmless here, as a loaded computer must not fail a test; they are tested by a clock
that stands, in tests/unit/control/.
"""

from __future__ import annotations

import dataclasses
import itertools
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.common import terminal_input as typed
from CNCStepper.cli.main import STOPPED, group
from CNCStepper.control.pulses import ports, sender
from CNCStepper.control.pulses import program as pulse_program
from CNCStepper.control.pulses.ports import read_recording
from CNCStepper.control.pulses.sender import Pace
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.signals.parallel_port import idle_registers, pin_levels

SIX = "G21 G90 G17\nM8\nG1 X-0.05 F60\nG1 X-0.025\nM9\nM2\n"  # 80 steps/mm: four steps there, two back
IDLE = idle_registers(load_machine("table-a").signals)
STEP, DIRECTION, FLOOD = 2, 3, 1  # pins


@pytest.fixture
def six(tmp_path: Path) -> Path:
    path = tmp_path / "peça nº 6.nc"
    path.write_text(SIX, encoding="utf-8")
    return path


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    made = pulse_program.PulseProgram.pace

    def slow(program: pulse_program.PulseProgram) -> Pace:
        return dataclasses.replace(made(program), writes_per_s=0.5, trial_s=0.0)

    monkeypatch.setattr(pulse_program.PulseProgram, "pace", slow)


def run(program: Path, port: Path, *more: str, typed: str = "") -> Result:
    arguments = ["drive", str(program), "--machine", "table-a", "--port", str(port), *more]
    return CliRunner().invoke(group, arguments, input=typed)


def test_the_pulses_arrive_at_the_plug(six: Path, tmp_path: Path) -> None:
    made = run(six, tmp_path / "gravação")
    assert made.exit_code == 0, made.output
    assert "tried at" in made.stderr and "writes in" in made.stdout and "the worst by" in made.stdout
    writes = read_recording(tmp_path / "gravação")
    plug = [pin_levels(data, control) for _, data, control in writes]
    rises = [after for before, after in pairwise(plug) if after[STEP] and not before[STEP]]
    assert [pins[DIRECTION] for pins in rises] == [True] * 4 + [False] * 2
    assert all(pins[FLOOD] for pins in rises)
    assert writes[-1][1:] == IDLE


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("G1 X-1 F60\nM0\n", "drive-stop"),
        ("M66 P0 L3 Q5\nG1 X-1 F60\n", "drive-stop"),
        ("M64 P3\nG1 X-1 F60\n", "output_3 is on no pin"),
        ("G1 X-1 F60\nG1 A20\n", "A"),
    ],
)
def test_what_cannot_be_driven_is_refused_and_nothing_is_recorded(tmp_path: Path, text: str, said: str) -> None:
    program = tmp_path / "job.ngc"
    program.write_text(f"G21 G90 G94\n{text}M2\n", "ascii")
    refused = run(program, tmp_path / "pulses", "--dialect", "linuxcnc")
    assert refused.exit_code == 1 and said in f"{refused.exception}{refused.output}"
    assert not (tmp_path / "pulses").exists()


def test_the_end_of_travel_is_a_finding_with_its_line(tmp_path: Path) -> None:
    program = tmp_path / "job.nc"
    program.write_text("G21 G90\nG1 X-1 F60\nX-500\nM2\n", "ascii")
    refused = run(program, tmp_path / "pulses")
    assert refused.exit_code == 1 and "job.nc:3" in refused.stdout and "[travel]" in refused.stdout
    assert not (tmp_path / "pulses").exists()


def test_a_program_is_not_written_over(six: Path) -> None:
    refused = run(six, six)
    assert refused.exit_code == 1 and "--port would write over the program" in str(refused.exception)
    assert six.read_text("utf-8") == SIX


@pytest.mark.parametrize(("typed", "sent"), [("n\n", False), ("", False), ("y\n", True)])
def test_a_parallel_port_is_driven_only_when_somebody_says_where_the_machine_stands(
    six: Path, tmp_path: Path, typed: str, sent: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ports, "is_parallel_port", lambda path: True)
    made = run(six, tmp_path / "pulses", typed=typed)
    assert "is its way free?" in made.stdout
    assert (made.exit_code == 0, (tmp_path / "pulses").exists()) == (sent, sent)
    assert "is its way free?" not in run(six, tmp_path / "pulses", "--zero-confirmed").stdout


def test_a_rate_that_no_computer_keeps_is_refused_at_rest(
    six: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pace = Pace(1e8, IDLE, 0.0, trial_s=0.001)
    monkeypatch.setattr(pulse_program.PulseProgram, "pace", lambda program: pace)
    refused = run(six, tmp_path / "pulses")
    assert refused.exit_code == 1 and "cannot keep the rate" in str(refused.exception)
    assert {(data, control) for _, data, control in read_recording(tmp_path / "pulses")} == {IDLE}


def test_a_hold_is_heard_while_the_pulses_run_and_none_is_lost(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Typed lines come as the pulses are made; what is written in the hold says the same again."""
    program = tmp_path / "job.nc"
    program.write_text("G21 G90\nG1 X-10 F1200\nX0\nM2\n", "ascii")
    lines = {3: "!", 4: "huh", 12: "~", 14: "50", 15: "500"}
    count = itertools.count()

    class Scripted:
        def __init__(self, on_message: Callable[[str], None]):
            self.on_message = on_message

        def wait(self, seconds: float) -> None:
            time.sleep(seconds)
            if line := lines.get(next(count)):
                self.on_message(line)

    monkeypatch.setattr(typed, "TerminalInput", Scripted)
    made = run(program, tmp_path / "pulses")
    assert made.exit_code == 0, made.output
    for said in ("holding", "! holds, ~ goes on", "going on", "50 % of every", "limit 1 to 100 %"):
        assert said in made.stderr
    writes = read_recording(tmp_path / "pulses")
    again = [row for row in range(2, len(writes)) if writes[row][1:] == writes[row - 1][1:]]
    assert len(again) >= 3 and not pin_levels(*writes[again[-1]][1:])[STEP]
    plug = [pin_levels(data, control) for _, data, control in writes]
    assert sum(after[STEP] and not before[STEP] for before, after in pairwise(plug)) == 1600
    assert (writes[-1][0] - writes[0][0]) / 1e9 > 2 * 0.5 + 0.3  # each way takes half a second, unheld


def test_ctrl_c_says_that_steps_may_be_lost(six: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def stopped(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(sender, "_give", stopped)
    made = run(six, tmp_path / "pulses")
    assert made.exit_code == STOPPED and "home the machine" in made.stderr
    assert read_recording(tmp_path / "pulses")[-1][1:] == IDLE
