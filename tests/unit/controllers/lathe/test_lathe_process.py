# SPDX-License-Identifier: LGPL-2.1-or-later
"""The process of the mini-lathe's controller at a pseudo-terminal: a dead sender's jog is released."""

from __future__ import annotations

import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest

from CNCStepper.control.transport.controller_link import open_controller
from CNCStepper.control.transport.link import open_link

LIMIT_S = 60.0
SENDER = """
import sys, time
from CNCStepper.control.transport.link import open_link
link = open_link(sys.argv[1], machine="mini-lathe")
link.write(b"$J=G91Z-100F120\\n")
time.sleep(60)
"""


class Line:
    """The far end of a pseudo-terminal, as the lathe has it."""

    def __init__(self) -> None:
        self._master, self._slave = os.openpty()
        self.name = os.ttyname(self._slave)
        self.heard = b""

    def until(self, end: bytes) -> float:
        """Wait until these bytes end what was heard; return when."""
        end_s = time.monotonic() + LIMIT_S
        while not self.heard.endswith(end):
            assert time.monotonic() < end_s, self.heard
            if select.select([self._master], [], [], 0.1)[0]:
                self.heard += os.read(self._master, 100)
        return time.monotonic()

    def wait(self, seconds: float) -> None:
        """Hear what comes within a time."""
        while select.select([self._master], [], [], seconds)[0]:
            self.heard += os.read(self._master, 100)

    def close(self) -> None:
        os.close(self._master)
        os.close(self._slave)


@pytest.fixture
def line() -> Iterator[Line]:
    opened = Line()
    yield opened
    opened.close()


def test_a_sender_that_is_killed_releases_its_jog(line: Line, tmp_path: Path) -> None:
    sender = subprocess.Popen([sys.executable, "-c", SENDER, line.name])
    try:
        line.until(b"G")
        time.sleep(0.3)
        assert line.heard == b"I2.0000?G"
        killed_s = time.monotonic()
        sender.send_signal(signal.SIGKILL)
        late_s = line.until(b"P") - killed_s
        print(f"released {1000 * late_s:.1f} ms after the kill")
        assert late_s < 1.0 and line.heard == b"I2.0000?GP"
    finally:
        sender.kill()
        sender.wait()


def test_a_controller_that_is_killed_releases_its_jog_too(line: Line) -> None:
    port = open_controller(line.name, "mini-lathe")
    for ended in (b"EP", b"G"):
        port.write(b"$J=G91X-.1F120\n" if ended == b"EP" else b"$J=G91Z-100F120\n")
        line.until(ended)
    time.sleep(0.3)
    port._process.kill()  # of the controller alone: nothing of it can send any more
    line.until(b"P")
    assert line.heard == b"I2.0000?EPGP"
    port.close()


def test_a_controller_that_is_killed_at_rest_sends_nothing(line: Line) -> None:
    port = open_controller(line.name, "mini-lathe")
    port.write(b"$J=G91X-.1F120\n")
    line.until(b"P")
    port._process.kill()
    port.close()
    line.wait(0.5)
    assert line.heard == b"I2.0000?EP"


def test_a_link_that_is_closed_releases_its_jog_and_says_8n1(line: Line) -> None:
    link = open_link(line.name, machine="mini-lathe")
    said, end_s = b"", time.monotonic() + LIMIT_S
    while b"opened 8N1" not in said and time.monotonic() < end_s:
        said += link.read(0.1)
    assert b"Grbl 1.1h" in said and b"opened 8N1" in said
    link.write(b"$J=G91X-100F60\n")
    line.until(b"E")
    link.close()
    line.until(b"P")
    assert line.heard == b"I1.0000?EP"


def test_a_jogs_time_is_kept(line: Line) -> None:
    link = open_link(line.name, machine="mini-lathe")
    link.write(b"$J=G91X-1F120\n")
    begun_s = line.until(b"E")
    lasted_s = line.until(b"P") - begun_s
    link.close()
    print(f"1 mm at 2 mm/s took {lasted_s:.4f} s")
    assert lasted_s == pytest.approx(0.5, abs=0.1)
