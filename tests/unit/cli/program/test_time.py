# SPDX-License-Identifier: LGPL-2.1-or-later
"""`time` and the reports of `run` and `check` give one figure for one program."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from helpers.cli.command_line import called

ROOT = Path(__file__).parents[4]
EXAMPLES = ROOT / "examples" / "jobs"
PROGRAMS = {
    "a rise first": "G21 G90\nG0 Z5\nG0 X10 Y0\nG1 Z-1 F300\nX40\nG0 Z5\nM2\n",
    "a way first": "G21 G90\nG0 X-10 Y5\nG0 Z5\nG1 Z-1 F300\nG2 X4 Y5 I7 J0\nG0 Z5\nM2\n",
    "one axis, and then the others": "G21 G90\nG1 Z-3 F200\nG1 X30\nX0\nY12.3456\nX7 Y2 Z0\nM2\n",
    "a place of the machine": "G21 G90\nG53 G0 Z-5\nG0 X10 Y5\nG1 Z-1 F300\nX40\nG0 Z5\nM2\n",
    "another work system": "G21 G90 G55\nG0 Z5\nG0 X10 Y5\nG1 Z-1 F300\nG92 X0\nX40\nM2\n",
    "dwells and a pause": "G21 G90\nM3 S1000\nG4 P2\nG0 Z5\nM0\nG0 X1\nG4 P0.5\nM2\n",
    "inches": "G20 G90\nG0 Z0.2\nG0 X1\nG1 X2 F30\nM2\n",
    "no move": "G21 G90\nM2\n",
}
STARTS = {"": (), "work zero": ("--work-zero", "-200,-150,-40"), "position": ("--position", "-20,-10,-3")}


def time_of(program: Path, *options: str) -> str:
    """What `time` says, s."""
    said = called("time", program, *options)
    assert said.returncode == 0, said.stderr
    return said.stdout.split()[-1]


def reported(file: Path) -> str:
    return f"{json.loads(file.read_text('utf-8'))['time_s']:.3f}"


@pytest.mark.parametrize("start", STARTS.values(), ids=STARTS)
@pytest.mark.parametrize("name", PROGRAMS)
def test_time_and_check_agree(name: str, start: tuple[str, ...], tmp_path: Path) -> None:
    program, report = tmp_path / "p.nc", tmp_path / "report.json"
    program.write_text(PROGRAMS[name])
    options = ("--machine", "table-a", *start)
    called("check", program, "--json", report, *options)
    assert time_of(program, *options) == reported(report)


@pytest.mark.parametrize("name", PROGRAMS)
def test_they_agree_where_play_is_taken_up(name: str, tmp_path: Path) -> None:
    profile = (ROOT / "CNCStepper" / "machine" / "profiles" / "table-a.toml").read_text("utf-8")
    machine, program, report = tmp_path / "m.toml", tmp_path / "p.nc", tmp_path / "report.json"
    machine.write_text(profile.replace("backlash_mm = 0.0", "backlash_mm = 0.1"), "utf-8")
    program.write_text(PROGRAMS[name])
    called("check", program, "--machine", machine, "--json", report)
    assert time_of(program, "--machine", str(machine)) == reported(report)


@pytest.mark.slow
@pytest.mark.parametrize("job", ["brazil-engraving", "plate", "cycles/drill", "cycles/contour"])
def test_time_and_the_report_of_a_job_agree(job: str, tmp_path: Path) -> None:
    assert called("run", EXAMPLES / f"{job}.toml", "--out", tmp_path).returncode == 0
    assert time_of(tmp_path / "program.nc", "--machine", "table-a") == reported(tmp_path / "report.json")


def test_a_program_that_begins_with_an_increment_has_a_time_too(tmp_path: Path) -> None:
    program, absolute = tmp_path / "p.nc", tmp_path / "absolute.nc"
    program.write_text("G21 G91\nG0 Z5\nG90 G0 X10 Y5\nM2\n")
    absolute.write_text("G21 G90\nG0 Z5\nG90 G0 X10 Y5\nM2\n")
    options = ("--machine", "table-a")
    assert time_of(program, *options) == time_of(absolute, *options) > "0"
