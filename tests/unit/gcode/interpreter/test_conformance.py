# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every program that comes with LinuxCNC, traced by us and by its own `rs274 -g`, call by call.

The calls of rs274 are taken in the test run itself. Where rs274 refuses a program, we do.
"""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.interpreter.canonical_trace import canonical_calls
from helpers.gcode.rs274_runs import run_rs274, same_call

FOLDER = Path("/usr/share/linuxcnc/ncfiles")  # tools/setup.sh installs linuxcnc-uspace
PROGRAMS = sorted(FOLDER.rglob("*.ngc"))
RUN_BY_RS274 = 113
SLOW_BYTES = 400
# Files that may differ, each with the sentence of LinuxCNC's own documents that we follow there.
DIFFERENT: dict[str, str] = {}


def name_of(path: Path) -> str:
    return path.relative_to(FOLDER).as_posix()


def cases():
    for path in PROGRAMS:
        marks = [pytest.mark.slow] if path.stat().st_size > SLOW_BYTES else []
        yield pytest.param(path, id=name_of(path), marks=marks)


def real_calls(path: Path, home: Path) -> tuple[list[str], bool]:
    """Return the calls of rs274, started in the program's folder, where it looks for subroutines."""
    run = run_rs274(home, str(path), folder_of_program=path.parent)
    return [line.rstrip() for line in run.stdout.splitlines() if line.strip()], run.returncode == 0


def our_calls(path: Path) -> list[str]:
    text = path.read_bytes().decode("latin-1")
    return [call.rstrip() for call in canonical_calls(text, file=str(path)) if call.strip()]


def first_difference(ours: list[str], theirs: list[str]) -> str:
    """Return the first two calls that differ, "" when none do."""
    for mine, real in zip(ours, theirs, strict=False):
        if not same_call(mine, real):
            return f"ours {mine}\nreal {real}"
    return "" if len(ours) == len(theirs) else f"{len(ours)} calls of ours, {len(theirs)} of rs274"


@pytest.mark.parametrize("path", list(cases()))
def test_a_program_of_linuxcnc_is_traced_as_rs274_traces_it(path, tmp_path):
    theirs, accepted = real_calls(path, tmp_path)
    if not accepted:
        with pytest.raises(ProgramError):
            our_calls(path)
        return
    difference = first_difference(our_calls(path), theirs)
    assert bool(difference) == (name_of(path) in DIFFERENT), difference or "does not differ any more"


def test_the_package_has_the_programs_that_the_figure_names():
    listed = subprocess.run(["dpkg", "-L", "linuxcnc-uspace"], check=True, capture_output=True, text=True).stdout
    there = {line for line in listed.splitlines() if line.endswith(".ngc") and "/ncfiles/" in line}
    assert there == {str(path) for path in PROGRAMS}
    assert len(PROGRAMS) == 185


def test_few_may_differ_and_each_says_why():
    assert len(DIFFERENT) <= 5
    assert all(len(quote) > 20 for quote in DIFFERENT.values())


@pytest.mark.slow
def test_the_number_of_programs_that_rs274_runs(tmp_path):
    accepted = [path for path in PROGRAMS if real_calls(path, tmp_path)[1]]
    assert len(accepted) == RUN_BY_RS274
