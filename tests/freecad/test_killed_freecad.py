# SPDX-License-Identifier: LGPL-2.1-or-later
"""A FreeCAD that is killed while it cuts: the cut goes on without it to its end, exactly, and nothing stays behind."""

from __future__ import annotations

import os
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.journal.store import replays
from CNCStepper.control.processes.python_finder import command, environment, find_python
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.session.files import running_services
from helpers.control.fault_judge import covers
from helpers.control.trace_file import rows_at, rows_of_file

HERE = Path(__file__).parent
ROOT = HERE.parents[1]

START_S, CUT_S, LEFT_S = 120.0, 180.0, 60.0
SPEED = "4"
PLACES = [(number % 5, number % 7, 0) for number in range(300)]


def wait(reached: Callable[[], object], seconds: float, what: str) -> None:
    until_s = time.monotonic() + seconds
    while not reached():
        assert time.monotonic() < until_s, f"waited {seconds} s in vain for {what}"
        time.sleep(0.05)


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[str]:
    """The address of a virtual machine that writes its trace to trace.csv."""
    options = ["virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", SPEED, "--trace", str(tmp_path / "trace.csv")]
    run = command(find_python(), "CNCStepper.cli.main", *options)
    with subprocess.Popen(run, stdout=subprocess.PIPE, text=True, env=environment()) as process:
        assert process.stdout
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            process.terminate()


def kill_a_freecad_that_cuts(machine: str, folder: Path) -> None:
    """Let a FreeCAD of its own begin to cut PLACES, and kill it."""
    lines = ["G21G90G94G17F3000", *(f"G1X{x}Y{y}" for x, y, _ in PLACES)]
    job, cutting = folder / "send.zip", folder / "cutting"
    write_job(job, SendJob(port="", lines=lines, file="part.nc"))
    told = {"CNCSTEPPER_PORT": machine, "CNCSTEPPER_JOB": str(job), "CNCSTEPPER_CUTTING": str(cutting)}
    freecadcmd = shutil.which("freecadcmd") or shutil.which("FreeCADCmd")
    assert freecadcmd
    with (folder / "freecad.log").open("wb") as log:
        freecad = subprocess.Popen(
            [freecadcmd, str(HERE.with_name("helpers") / "freecad" / "cut_and_wait.py"), "-M", str(ROOT)],
            env={**os.environ, **told, "FREECAD_USER_HOME": str(folder / "home"), "XDG_STATE_HOME": str(folder)},
            stdout=log,
            stderr=subprocess.STDOUT,
        )
        try:
            wait(lambda: cutting.exists() or freecad.poll() is not None, START_S, "the cut to begin")
        finally:
            freecad.kill()
            freecad.wait()
    assert cutting.exists(), (folder / "freecad.log").read_text("utf-8", "replace")


def test_a_cut_goes_on_exactly_without_the_freecad_that_began_it(machine: str, tmp_path: Path) -> None:
    kill_a_freecad_that_cuts(machine, tmp_path)
    sessions = tmp_path / "cncstepper" / "sessions"
    [story] = replays(sessions)
    assert not story.is_done and len(running_services(sessions)) == 1
    wait(lambda: not running_services(sessions), CUT_S + LEFT_S, "the cut and the service to end")
    [story] = replays(sessions)
    assert story.is_done and story.finished == len(PLACES) + 1, story
    assert covers(rows_at(PLACES), rows_of_file(tmp_path / "trace.csv"))
