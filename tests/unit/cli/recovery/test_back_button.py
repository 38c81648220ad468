# SPDX-License-Identifier: LGPL-2.1-or-later
"""A table that is led back along the cut and on from its own buttons, while `send` runs and nobody types."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import sessions
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.machine.profile import load_machine
from helpers.cli.command_line import command, forked

pytestmark = [pytest.mark.slow, pytest.mark.skipif(sys.platform == "win32", reason="its pins cannot be typed there")]
PROFILE = Path(load_machine.__code__.co_filename).parent / "profiles" / "table-a.toml"
BUTTONS = '\n[[input]]\npin = "P"\nact = "back"\nback_mm = 3\n\n[[input]]\npin = "S"\nact = "start"\n'
PROGRAM = "G21 G90\nG0 Z-2\nG0 X-5 Y-5\nM3 S8000\nG4 P3\nG1 Z-5 F300\nG1 X-390 F500\nG0 Z-2\nM5\nM2\n"
LIMIT_S, TAP_S = 120.0, 0.5


class Bench:
    """A virtual table whose pins are pressed, and a program that is being sent to it."""

    def __init__(self, table: subprocess.Popen[str], sender: subprocess.Popen[str], client: SessionClient):
        self.table, self.sender, self.client = table, sender, client

    def press(self, pin: str) -> None:
        assert self.table.stdin
        for word in ("press", "release"):
            self.table.stdin.write(f"{word} {pin}\n")
            self.table.stdin.flush()
            time.sleep(TAP_S)

    def until(self, reached: Callable[[SenderStatus], bool]) -> SenderStatus:
        end_s = time.monotonic() + LIMIT_S
        while not reached(status := self.client.status()):
            assert self.client.outcome is None and time.monotonic() < end_s, status
            time.sleep(0.05)
        return status


@pytest.fixture
def bench(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Bench]:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))
    program, machine = tmp_path / "a part ç.nc", tmp_path / "máquina.toml"
    program.write_text(PROGRAM, "utf-8")
    machine.write_text(PROFILE.read_text("utf-8") + BUTTONS, "utf-8")
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "encoding": "utf-8"}
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--speed", "2", "--typed")
    with subprocess.Popen(command(*words), preexec_fn=forked(*words), **pipes) as table:
        assert table.stdout
        port = table.stdout.readline().rpartition(" ")[2].strip()
        arguments = ("send", program, "--port", port, "--machine", machine, "--zero-confirmed")
        pipes["stderr"] = subprocess.DEVNULL
        with subprocess.Popen(command(*arguments), preexec_fn=forked(*arguments), **pipes) as sender:
            while not sessions():
                assert sender.poll() is None
                time.sleep(0.05)
            with SessionClient.attach(sessions()[0]) as client:
                yield Bench(table, sender, client)
            sender.kill()
        table.terminate()


def test_pressed_twice_it_goes_twice_as_far_and_start_goes_on(bench: Bench) -> None:
    bench.until(lambda status: bool(status.mpos_mm) and status.mpos_mm[0] < -15.0)
    bench.press("P")
    first = bench.until(lambda status: status.phase == "retreated")
    bench.press("P")
    second = bench.until(lambda status: status.phase == "retreated" and status.mpos_mm[0] > first.mpos_mm[0] + 2.9)
    assert second.mpos_mm[0] - first.mpos_mm[0] == pytest.approx(3.0, abs=0.02)
    bench.press("S")
    bench.until(lambda status: status.phase == "running" and status.mpos_mm[0] < first.mpos_mm[0] - 1.0)
    bench.client.stop()
    assert "stopped as asked" in bench.sender.communicate()[0]
