# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process of ours behind the window: what it tells, what it is sent, and its end, whatever its way."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from typing import Any

import pytest
from PySide import QtCore

from CNCStepper.control.processes.python_finder import find_python
from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.services.background_process import Worker, start_worker

LIMIT_S = 30.0
ECHO = "import sys\nfor line in sys.stdin.buffer: sys.stdout.buffer.write(line); sys.stdout.flush()"


class Heard:
    """A worker that runs a text of Python, and what it told."""

    def __init__(self, text: str):
        self.application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
        self.lines: list[bytes] = []
        self.ends = 0
        self.worker = start_worker(None, [find_python(), "-c", text], self._on_message, self._end)

    def _on_message(self) -> None:
        self.lines += iter(self.worker.line, b"")

    def _end(self) -> None:
        self.ends += 1

    def wait(self, until: Callable[[], Any]) -> None:
        end_s = time.monotonic() + LIMIT_S
        while not until():
            assert time.monotonic() < end_s, self.lines
            QtCore.QCoreApplication.processEvents()
            time.sleep(0.002)


def test_lines_are_heard_whole_and_in_order_and_then_the_end() -> None:
    heard = Heard("import sys\nfor k in range(20000): sys.stdout.write(f'{k} ção\\n'); k % 777 or sys.stdout.flush()")
    heard.wait(lambda: heard.ends)
    assert [int(line.split()[0]) for line in heard.lines] == list(range(20000))
    assert not heard.worker.running and heard.ends == 1 and heard.worker.line() == b""


def test_what_is_sent_never_waits_for_a_process_that_does_not_read() -> None:
    heard = Heard(ECHO)
    heard.worker.write(b"first\n")
    heard.wait(lambda: heard.lines)
    much = b"x" * 2_000_000 + b"\n"  # more than a pipe holds, in and out
    heard.worker.write(much)
    heard.worker.write(b"last\n")
    heard.wait(lambda: len(heard.lines) == 3)
    assert heard.lines == [b"first\n", much, b"last\n"]
    heard.worker.stop()


def test_stop_ends_it_and_nothing_is_heard_any_more() -> None:
    heard = Heard("import time\nprint('begun', flush=True)\nwhile True: print('on', flush=True); time.sleep(0.001)")
    heard.wait(lambda: heard.lines)
    told = len(heard.lines)
    heard.worker.stop()
    assert not heard.worker.running
    for _ in range(20):
        QtCore.QCoreApplication.processEvents()
        time.sleep(0.002)
    assert len(heard.lines) == told and not heard.ends


def test_it_ends_with_what_it_belongs_to() -> None:
    application = QtCore.QCoreApplication.instance() or QtCore.QCoreApplication([])
    parent = QtCore.QObject()
    worker = Worker([find_python(), "-c", ECHO], parent)
    process = worker._process
    parent.deleteLater()
    end_s = time.monotonic() + LIMIT_S
    while process.poll() is None and time.monotonic() < end_s:
        application.sendPostedEvents(None, QtCore.QEvent.Type.DeferredDelete)
        application.processEvents()
        time.sleep(0.002)
    assert process.poll() is not None


def test_what_it_complains_of_is_kept() -> None:
    heard = Heard("raise SystemExit('não pode ser')")
    heard.wait(lambda: heard.ends)
    assert "o pode ser" in heard.worker.complaints() and not heard.lines


def test_a_program_that_is_not_there_is_refused() -> None:
    with pytest.raises(CNCStepperError) as refusal:
        Worker([sys.prefix + "/no such program"])
    assert refusal.value.code == "worker-start" and refusal.value.value
