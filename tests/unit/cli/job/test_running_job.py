# SPDX-License-Identifier: LGPL-2.1-or-later
"""`hold`, `go`, `override` and `stop` at a job whose own terminal is none."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import sessions
from CNCStepper.control.session.status import SenderStatus
from helpers.cli.command_line import called
from helpers.cli.running_send import attached, being_sent

PROGRAM = "G21 G90\nG0 Z-2\nG1 X-30 F600\n(MSG, change to tool 2)\nM0\nG1 X-300 F600\nM2\n"
VIRTUAL = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "2")
LIMIT_S = 60.0


@pytest.fixture
def sent(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[subprocess.Popen[str]]:
    """A program that is being sent to a virtual grbl, with nobody at its terminal."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    nobody = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
    with being_sent(tmp_path, PROGRAM, VIRTUAL, pipes=nobody) as (sender, _):
        yield sender


def until(reached: Callable[[SenderStatus], bool]) -> None:
    end_s = time.monotonic() + LIMIT_S
    with SessionClient.attach(sessions()[0]) as client:
        while not reached(client.status()):
            assert client.outcome is None and time.monotonic() < end_s
            time.sleep(0.02)


@pytest.mark.slow
def test_job_is_held_led_on_and_stopped_without_its_terminal(sent: subprocess.Popen[str]) -> None:
    attached(sent).close()
    until(lambda status: (status.mpos_mm or (0.0,))[0] < -5.0)
    held = called("hold")
    assert held.returncode == 0 and held.stdout.startswith("held: The machine holds"), held.stderr
    assert called("override", "feed", "-10").stdout == "90/100/100 %\n"
    assert "there is no override" in called("override", "feed", "7").stderr
    assert called("go").stdout == "the job goes on\n"
    assert "the job is not held" in called("go").stderr
    until(lambda status: status.phase == "paused")
    refused = called("go")
    assert refused.returncode == 1 and "change to tool 2" in refused.stderr and "go --pause" in refused.stderr
    until(lambda status: status.phase == "paused")
    assert called("go", "--pause").returncode == 0
    stopped = called("stop")
    assert stopped.returncode == 0 and "stopped as asked" in stopped.stdout
    assert sent.stdout
    said = " ".join(sent.stdout.read().split())  # as it is broken into lines
    assert sent.wait(LIMIT_S) == 1 and "stopped as asked" in said
    assert "`cncstepper go` goes on" in said and "`cncstepper go --pause` goes on" in said


@pytest.mark.parametrize("words", [("hold",), ("go",), ("stop",), ("override", "feed", "+10")])
def test_without_a_job_each_says_what_to_do(words, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    refused = called(*words)
    assert refused.returncode == 1 and "cncstepper send" in refused.stderr
