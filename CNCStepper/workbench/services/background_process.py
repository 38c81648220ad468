# SPDX-License-Identifier: LGPL-2.1-or-later
"""A module of ours in a Python process of its own, which reports to the window by Qt's signals.

Not by QProcess: that copies the window's process first (fork), tens of ms for what FreeCAD may hold in memory.

    window ──► write ──► a queue ──► a thread ──► its input
    told   ◄── queued signal ◄────── a thread ◄── its output; the output's end is the process' end
"""

from __future__ import annotations

import os
import subprocess
import tempfile
from collections.abc import Callable
from contextlib import suppress
from queue import SimpleQueue
from threading import Thread
from typing import Any

from PySide import QtCore

from CNCStepper.control.processes.python_finder import environment
from CNCStepper.errors import CNCStepperError

KILLED_WITHIN_S = 2.0
AT_ONCE_BYTES = 1 << 16

_ending: set[Worker] = set()  # stopped, and not gone yet


class Worker(QtCore.QObject):
    """The process. told: sent for each line of output. ended: sent at its end. `stop` it or let it end by itself.

    Raises CNCStepperError when it cannot be started.
    """

    told = QtCore.Signal()
    ended = QtCore.Signal()
    _arrived = QtCore.Signal(object)
    _over = QtCore.Signal()

    def __init__(self, words: list[str], parent: Any = None):
        super().__init__(parent)
        self._heard = bytearray()
        self._to_write: SimpleQueue[bytes | None] = SimpleQueue()
        self._complaints = tempfile.TemporaryFile()  # noqa: SIM115 - open as long as the process lives
        self._process = _started(words, self._complaints)
        queued = QtCore.Qt.ConnectionType.QueuedConnection
        self._arrived.connect(self._take, queued)
        self._over.connect(self._notify_end, queued)
        self.destroyed.connect(self._process.kill)
        self._stopped = False
        works = (self._read_on, self._write_on)
        self._threads = [Thread(target=work, name=f"{work.__name__}-{self.pid}", daemon=True) for work in works]
        for thread in self._threads:
            thread.start()

    @property
    def pid(self) -> int:
        """The process' number."""
        return self._process.pid

    @property
    def running(self) -> bool:
        """Whether it is not over."""
        return self._process.poll() is None

    @property
    def status(self) -> int:
        """Its exit status, once `ended` is sent."""
        return self._process.wait()

    def write(self, data: bytes) -> None:
        """Send it bytes, as soon as it takes them."""
        self._to_write.put(data)

    def line(self) -> bytes:
        """Return the next whole line of its output, with its end; b"" when there is none yet."""
        end = self._heard.find(b"\n") + 1
        told = bytes(self._heard[:end])
        del self._heard[:end]
        return told

    def complaints(self) -> str:
        """Return what it has written as errors."""
        self._complaints.seek(0)
        return self._complaints.read().decode("utf-8", "replace")

    def stop(self) -> None:
        """End it at once; no further signals are sent.

        The object goes when the thread that reads has told its last: Qt must not delete what a thread is just using,
        nor may a parent meanwhile.
        """
        self._stopped = True
        _ending.add(self)
        self.setParent(None)
        self._process.kill()
        with suppress(subprocess.TimeoutExpired):  # the system ends it as soon as it can
            self._process.wait(KILLED_WITHIN_S)
        self._to_write.put(None)

    @QtCore.Slot(object)
    def _take(self, data: bytes) -> None:
        if not self._stopped:
            self._heard += data
            self.told.emit()

    @QtCore.Slot()
    def _notify_end(self) -> None:
        for thread in self._threads:  # they have told their last, and are about to end
            thread.join(KILLED_WITHIN_S)
        if self._stopped:
            _ending.discard(self)
            self.deleteLater()
        else:
            self.ended.emit()

    def _read_on(self) -> None:
        """Hand on its output until that ends; runs in a thread of its own."""
        output = self._process.stdout
        assert output
        with output:
            while data := os.read(output.fileno(), AT_ONCE_BYTES):
                _tell(self._arrived.emit, data)
        self._process.wait()
        self._to_write.put(None)
        _tell(self._over.emit)

    def _write_on(self) -> None:
        """Write what waits until there is an end of it; runs in a thread of its own."""
        entry = self._process.stdin
        assert entry
        try:
            with entry:
                while (data := self._to_write.get()) is not None:
                    entry.write(data)
                    entry.flush()
        except OSError:  # it reads no more: that it is over is told by its output
            return


def start_worker(parent: Any, words: list[str], heard: Callable[[], None], ended: Callable[[], None]) -> Worker:
    """Start the `words` of `python_finder.command`.

    heard: called when it has told something. ended: when it is over. Raises CNCStepperError when it cannot be started.
    """
    worker = Worker(words, parent)
    worker.told.connect(heard)
    worker.ended.connect(ended)
    return worker


def _started(words: list[str], complaints: Any) -> subprocess.Popen:
    try:
        return subprocess.Popen(
            words,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=complaints,
            env=environment(),
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except OSError as error:
        raise CNCStepperError(
            "worker-start",
            "a process of our own cannot be started",
            value=error.strerror or str(error),
            advice="try again",
        ) from error


def _tell(emit: Callable[..., None], *values: Any) -> None:
    try:
        emit(*values)
    except RuntimeError:  # the window has let go of it
        return
