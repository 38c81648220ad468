# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender killed by force in the middle of a contour: what `resume` offers cuts the whole of it, and nothing else.

Machine, `send` and the sender are processes of their own. The machine kills the sender at a byte of its own counting,
so that the kill comes at the same place of the program in every run; its trace of true positions is the judge.
"""

from __future__ import annotations

import shlex
import signal
import subprocess
import sys
import time
from math import pi, sin
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

from CNCStepper.cli.main import group
from CNCStepper.control.session.files import read_private, sessions
from helpers.control.retract_bench import path_of, polyline, worst_distance_mm
from helpers.control.virtual_process import machine_that_kills

DEPTH_MM = 1.5  # deeper than where homing ends
SIDE_MM, RADIUS_MM = 40, 5
NEAR_MM = 0.016  # as on real grbl; a step of both axes at once is 0.0177
SAMPLE_MM = 0.02
LIFT_MM = (0.0, 0.0, 50.0)
KILLS_AT = (1500, 1900)  # bytes, of some 2300
AGAINST = ("--machine", "table-a", "--stock", "100,100,10", "--tool", "flat:2")
SEND = (sys.executable, "-m", "CNCStepper.cli", "send")
LIMIT_S = 120.0
SPEED = "3"  # so that the journal has seconds


def contour() -> list[str]:
    """Return a closed contour of short chords along waves, with an arc at each corner."""
    side = range(1, SIDE_MM + 1)
    wave = {way: f"{sin(way * pi / 10):.3f}" for way in side}
    ahead = [f"G1 X{20 + way} Y{10 + float(wave[way]):.3f}" for way in side]
    up = [f"G1 X{65 + float(wave[way]):.3f} Y{15 + way}" for way in side]
    back = [f"G1 X{60 - way} Y{60 + float(wave[way]):.3f}" for way in side]
    down = [f"G1 X{15 + float(wave[way]):.3f} Y{55 - way}" for way in side]
    arcs = [
        f"G3 X{x} Y{y} I{i} J{j}" for x, y, i, j in ((65, 15, 0, 5), (60, 60, -5, 0), (15, 55, 0, -5), (20, 10, 5, 0))
    ]
    return [line for side, arc in zip((ahead, up, back, down), arcs, strict=True) for line in (*side, arc)]


HEAD = ["G21 G90", "T1", "M3 S12000", "G0 Z5", "X20 Y10", f"G1 Z{-DEPTH_MM} F300", "F600"]
PROGRAM = "\n".join([*HEAD, *contour(), "G0 Z5", "M5", "M2", ""])


def cuts_of(trace: Path) -> list[np.ndarray]:
    """Return the stretches of a trace at the program's depth, as float64[n, 3]."""
    places = np.loadtxt(trace, delimiter=",", skiprows=1)[:, 1:]
    cuts = places[:, 2] < 1e-6 - DEPTH_MM
    edges = np.flatnonzero(np.diff(np.r_[False, cuts, False].astype(int)))
    return [places[begin:end] for begin, end in edges.reshape(-1, 2)]


def dense(line: np.ndarray) -> np.ndarray:
    """Return points along a polyline that are at most SAMPLE_MM apart."""
    ways = np.linalg.norm(np.diff(line, axis=0), axis=1)
    along = np.r_[0.0, np.cumsum(ways)]
    samples = np.linspace(0.0, along[-1], int(along[-1] / SAMPLE_MM) + 2)
    return np.column_stack([np.interp(samples, along, line[:, axis]) for axis in range(3)])


def departures_mm(cuts: list[np.ndarray], program: str) -> tuple[float, float]:
    """Return the largest distance of the cuts from the contour, and of the contour from the cuts."""
    line = polyline(path_of(program))
    line = line[line[:, 2] < 1e-6 - DEPTH_MM]
    lifted = [
        np.vstack([cut[:1] + LIFT_MM, cut, cut[-1:] + LIFT_MM]) for cut in cuts
    ]  # no way leads from one to another
    return worst_distance_mm(np.vstack(cuts), line), worst_distance_mm(dense(line), np.vstack(lifted))


def killed_in_the_middle(folder: Path, at_byte: int) -> str:
    """Home, send and be killed; then go on as `resume` says, and return the command that it has offered."""
    program, pid = folder / "a part ç.nc", folder / "pid"
    program.write_text(PROGRAM, "utf-8")
    with machine_that_kills(folder, at_byte, ("--homing", "--speed", SPEED)) as (_, port):
        words = (*SEND, str(program), "--port", port, *AGAINST, "--zero-confirmed", "--home")
        with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as send:
            end_s = time.monotonic() + LIMIT_S
            while not sessions():
                assert time.monotonic() < end_s and send.poll() is None
                time.sleep(0.05)
            pid.write_text(str(read_private(sessions()[0])["process"]), "utf-8")
            assert send.wait(LIMIT_S) == 1
        *_, offered = CliRunner().invoke(group, ["resume"]).output.splitlines()
        _, restart, *arguments = shlex.split(offered.removeprefix("restart"))
        assert restart == "restart"
        result = CliRunner().invoke(group, [restart, *arguments, "--zero-confirmed"])
        while "[machine-run]" in result.output:  # it still makes what the dead sender has left in its planner
            assert time.monotonic() < end_s + LIMIT_S, result.output
            time.sleep(0.2)
            result = CliRunner().invoke(group, [restart, *arguments, "--zero-confirmed"])
        assert result.exit_code == 0 and "the machine is idle" in result.output, result.output
    return offered


@pytest.mark.slow
@pytest.mark.parametrize("at_byte", KILLS_AT)
def test_the_whole_contour_and_nothing_else_is_cut(tmp_path: Path, at_byte: int, monkeypatch) -> None:
    monkeypatch.setattr(signal, "signal", lambda number, handler: None)
    offered = killed_in_the_middle(tmp_path, at_byte)
    line = int(shlex.split(offered)[shlex.split(offered).index("--line") + 1])
    assert len(HEAD) < line <= len(HEAD) + len(contour()), offered
    cuts = cuts_of(tmp_path / "trace.csv")
    off_mm, missed_mm = departures_mm(cuts, PROGRAM)
    print(f"killed at byte {at_byte}, restarted at line {line}: {off_mm:.4f} mm off, {missed_mm:.4f} mm missed")
    assert len(cuts) == 2, [(len(cut), cut[0], cut[-1]) for cut in cuts]
    assert off_mm <= NEAR_MM and missed_mm <= NEAR_MM
    assert departures_mm(cuts[:1], PROGRAM)[1] > 1.0  # the first has not cut all of it
