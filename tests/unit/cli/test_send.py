# SPDX-License-Identifier: LGPL-2.1-or-later
"""`send` to `virtual grbl`, each a process of its own, as two terminals of a newcomer."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

PROGRAM = "G21 G90\nG0 Z5\nG0 X10 Y0\nG1 Z-1 F300\n(MSG, look)\nM0\nG3 X10 Y0 I-10 J0 F2000\nG0 Z5\nM2\n"


def command(*arguments: str | Path) -> list[str]:
    return [sys.executable, "-m", "CNCStepper.cli", *map(str, arguments)]


@pytest.fixture
def table(tmp_path: Path) -> Iterator[tuple[str, Path]]:
    """A running virtual grbl: its port and its trace."""
    trace = tmp_path / "trace.csv"
    process = subprocess.Popen(
        command("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "20", "--trace", trace),
        stdout=subprocess.PIPE,
        encoding="utf-8",
    )
    assert process.stdout
    said = process.stdout.readline().strip()
    yield f"socket://{said.rpartition(' ')[2].removeprefix('socket://')}", trace
    process.terminate()
    assert process.wait(10) == 0


def send(path: Path, port: str, *more: str, answer: str = "") -> subprocess.CompletedProcess[str]:
    line = command("send", path, "--port", port, "--machine", "table-a", *more)
    return subprocess.run(line, input=answer, capture_output=True, encoding="utf-8", timeout=60)


@pytest.fixture
def program(tmp_path: Path) -> Path:
    path = tmp_path / "círculo 1.nc"
    path.write_text(PROGRAM, encoding="utf-8")
    return path


def test_a_program_is_cut_to_its_end(program: Path, table: tuple[str, Path]) -> None:
    port, trace = table
    sent = send(program, port, "--zero-confirmed", "--resume-pauses")
    assert sent.returncode == 0, sent.stderr
    assert "8 of 8 lines acknowledged" in sent.stdout
    again = send(program, port, "--zero-confirmed", answer="\n")
    assert again.returncode == 0, again.stderr
    assert "look" in again.stderr
    path = np.loadtxt(trace, delimiter=",", skiprows=1)
    assert trace.read_text("ascii").startswith("t_s,x_mm,y_mm,z_mm\n")
    cutting = path[path[:, 3] <= -1 + 1e-9]
    assert abs(np.hypot(cutting[:, 1], cutting[:, 2]) - 10).max() < 2 / 80


def test_a_stop_at_the_pause_is_exit_1(program: Path, table: tuple[str, Path]) -> None:
    sent = send(program, table[0], "--zero-confirmed", answer="s\n")
    assert sent.returncode == 1
    assert "stop" in sent.stdout.lower()


def test_nobody_to_ask_means_no_cut(program: Path, table: tuple[str, Path]) -> None:
    sent = send(program, table[0])
    assert sent.returncode == 1
    assert "--zero-confirmed" in sent.stderr and "Traceback" not in sent.stderr


def test_a_port_that_is_not_there(program: Path) -> None:
    sent = send(program, "/dev/no-such-port", "--zero-confirmed")
    assert sent.returncode == 1
    assert "/dev/no-such-port" in sent.stderr and "Traceback" not in sent.stderr


def test_a_machine_in_alarm_is_refused(program: Path, tmp_path: Path) -> None:
    process = subprocess.Popen(
        command("virtual", "grbl", "--tcp", "127.0.0.1:0", "--homing"), stdout=subprocess.PIPE, encoding="utf-8"
    )
    assert process.stdout
    port = "socket://" + process.stdout.readline().strip().rpartition(" ")[2].removeprefix("socket://")
    sent = send(program, port, "--zero-confirmed")
    process.terminate()
    process.wait(10)
    assert sent.returncode == 1
    assert "alarm" in sent.stderr.lower() and "Traceback" not in sent.stderr


def test_a_program_that_does_not_fit_the_machine_is_not_sent(tmp_path: Path) -> None:
    path = tmp_path / "large.nc"
    path.write_text("G21 G90\nG0 Z5\nG0 X0 Y0\nG1 X500 F500\nM2\n", encoding="ascii")
    sent = send(path, "socket://127.0.0.1:9", "--zero-confirmed")
    assert sent.returncode == 1
    assert "large.nc:4" in sent.stdout


def test_only_enter_alone_goes_on(program: Path, table: tuple[str, Path]) -> None:
    sent = send(program, table[0], "--zero-confirmed", answer="x\nwhat\nstop\n")
    assert sent.returncode == 1
    assert sent.stderr.count("is neither") == 2
