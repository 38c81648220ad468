# SPDX-License-Identifier: LGPL-2.1-or-later
"""A change of tools at a virtual grblHAL, worked from a second terminal: jogged, zeroed, and resumed in the first."""

from __future__ import annotations

import re
import subprocess
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from CNCStepper.control.session.status import SenderStatus
from helpers.cli.command_line import called
from helpers.cli.running_send import attached, being_sent

PROGRAM = "G21 G90\nG0 Z-2\nG1 X-5 F3000\nM5\nT2 M6\nG1 X-10\nM2\n"
VIRTUAL = ("virtual", "grbl", "--firmware", "grblhal", "--tcp", "127.0.0.1:0")


@pytest.fixture
def sent(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """A program with two tools that is being sent to a virtual grblHAL, and the port of that."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    with being_sent(tmp_path, PROGRAM, VIRTUAL, ("--unchecked", "--dialect", "grblhal")) as sent:
        yield sent


def at_tool(sender: subprocess.Popen[str]) -> SenderStatus:
    """Wait until the job stands at its M6."""
    with attached(sender) as client:
        while (status := client.status()).machine_state != "Tool" or status.phase != "paused":
            assert client.outcome is None
            time.sleep(0.02)
        return status


def shown_wpos_mm(output: str) -> tuple[float, ...]:
    """Return the work position that a verb shows of a machine at its M6.

    It is near the programmed one: the machine may have been held between two steps.
    """
    shown = re.search(r"Tool  X(\S+) Y(\S+) Z(\S+)", output)
    assert shown, output
    return tuple(float(number) for number in shown.groups())


@pytest.mark.slow
def test_tool_is_changed_from_a_second_terminal(sent: tuple[subprocess.Popen[str], str]) -> None:
    sender, port = sent
    assert at_tool(sender).wpos_mm == pytest.approx((-5, 0, -2), abs=0.02)
    jogged = called("jog", "X2", "Z1.5", "--feed", "2000", "--port", port)
    assert jogged.returncode == 0, jogged.stderr
    assert shown_wpos_mm(jogged.stdout) == pytest.approx((-3, 0, -0.5), abs=0.02)
    zeroed = called("zero", "Z", "--port", port)
    assert zeroed.returncode == 0, zeroed.stderr
    x_mm, y_mm, z_mm = shown_wpos_mm(zeroed.stdout)
    assert (x_mm, y_mm) == pytest.approx((-3, 0), abs=0.02) and z_mm == 0
    assert sender.stdin and sender.stdout
    sender.stdin.write("\n")
    sender.stdin.close()
    assert "all 7 lines are cut" in sender.stdout.read()
    assert sender.wait(60) == 0
