# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's interface thread, seen from the thread in which pytest runs."""

from __future__ import annotations

import gc
import os
import queue
import sys
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache, partial
from pathlib import Path
from typing import Any

from PySide import QtCore

from window_helpers.processor_speed import slowness

CALL_LIMIT_S = 30.0
TICK_MS = 2


NO_PYTHON = "(no Python)"


def interface_stack() -> str:
    """Return what the interface thread is doing at this moment, as a traceback shows it."""
    frame = sys._current_frames().get(threading.main_thread().ident or 0)
    return "".join(traceback.format_stack(frame)) if frame else NO_PYTHON


class Interface(QtCore.QObject):
    """Runs functions on the interface thread, also while a modal dialog or another loop is open there.

    `while_asked` runs there after each of them, while pytest's thread still waits for the answer.

    FreeCAD 0.20 keeps Python's lock in a modal dialog that Python has opened: pytest's thread gets it only when Python
    runs there. A timer sees to that.
    """

    LET_GO_EVERY_MS = 50
    _asked = QtCore.Signal(object)

    def __init__(self) -> None:
        """Make it on the interface thread: that is where the functions will run."""
        super().__init__()
        self.while_asked: Callable[[], None] = lambda: None
        self.watchdogs: list[EventWatchdog] = []  # those that leave out what the tests ask here
        self._timer = QtCore.QTimer(self)
        self._timer.timeout.connect(lambda: time.sleep(0))
        self._timer.start(self.LET_GO_EVERY_MS)
        self._asked.connect(self._answer, QtCore.Qt.ConnectionType.QueuedConnection)

    @QtCore.Slot(object)
    def _answer(self, task: Callable[[], None]) -> None:
        task()

    def call(self, function: Callable[..., Any], *arguments: Any, limit_s: float = CALL_LIMIT_S) -> Any:
        """Return the function's result; what it raises is raised here. TimeoutError when the thread does not answer."""
        if threading.current_thread() is threading.main_thread():
            return function(*arguments)
        answers: queue.Queue[tuple[Any, BaseException | None]] = queue.Queue()

        def task() -> None:
            for watchdog in self.watchdogs:
                watchdog.end_block()
            try:
                answer = (function(*arguments), None)
            except BaseException as error:
                answer = (None, error)
            self.while_asked()
            for watchdog in self.watchdogs:
                watchdog.begin_block()
            answers.put(answer)
            del answer  # an error and this frame would keep each other, and with them all widgets that were looked at

        self._asked.emit(task)
        try:
            result, error = answers.get(timeout=limit_s)
        except queue.Empty:
            raise TimeoutError(
                f"the interface thread did not answer within {limit_s} s; it is in\n{interface_stack()}"
            ) from None
        try:
            if error is not None:
                raise error
            return result
        finally:
            del error


class Keeper:
    """Lets what the tests leave behind be deleted on the interface thread, as Qt demands of what belongs to it.

    A callable that was connected to a signal, or a widget in a cycle of garbage, would otherwise be deleted in
    pytest's thread, whenever a test's function returns or Python happens to collect: a crash, now and then.

    Python 3.11 itself crashes where one thread collects garbage while another is in generators that a profile function
    watches. So garbage is collected only while pytest's thread waits for an answer.
    """

    MANY = 2000  # young objects since the last collection; Python's own threshold has the same order

    def __init__(self, folders: tuple[str, ...], interface: Interface) -> None:
        """Keep the locals of functions in the files of these folders."""
        self._folders = folders
        self._kept: list[Any] = []
        gc.disable()
        interface.while_asked = self._collect

    @contextmanager
    def watching(self) -> Iterator[None]:
        """Keep the locals of functions that return in this thread meanwhile."""
        sys.setprofile(self._watch)
        try:
            yield
        finally:
            sys.setprofile(None)

    def _watch(self, frame: Any, event: str, _: Any) -> None:
        if event == "return" and frame.f_code.co_filename.startswith(self._folders):
            self._kept.append(dict(frame.f_locals))

    def let_go(self) -> None:
        """Delete what was kept, also by the last error's traceback; runs on the interface thread."""
        self._kept.clear()
        for name in ("last_exc", "last_type", "last_value", "last_traceback"):
            vars(sys).pop(name, None)
        gc.collect()

    def _collect(self) -> None:
        if gc.get_count()[0] > self.MANY:
            gc.collect(1)


def waited_for_a_core_s(thread: int) -> float:
    """Return how long a thread was ready to run while the system let others run in its place (Linux)."""
    words = Path(f"/proc/self/task/{thread}/schedstat").read_text("ascii").split()
    return int(words[1]) / 1e9


class Watchdog:
    """Measures how long the interface thread is kept from its events: `with hand.watchdog() as watch:`.

    `max_ms` is the longest time between two ticks of a 2 ms timer there. On a busy machine it grows, so it is also
    told apart: `max_cpu_ms` is the most processor time that the interface thread itself used between two ticks, and
    `max_waited_ms` the longest that it waited there for something else than a free core: a lock, a file, another
    process. `where` is what it was doing in the longest one, `where_cpu` in the one that used most. `max_python_ms` is
    the most processor time between two ticks in which Python was seen at work; the rest is Qt's and FreeCAD's own,
    such as painting a large panel. Processor times count as on the machine on which the limits were set: at the end
    they are divided by `slowness`.
    """

    def __init__(self, interface: Interface) -> None:
        self._interface = interface
        self.max_ms = self.max_cpu_ms = self.max_waited_ms = self.max_python_ms = 0.0
        self.slowness = 1.0
        self._saw_python = False  # since the last tick
        self.where = self.where_cpu = ""
        self._stack = ""  # seen since the last tick

    def __enter__(self) -> Watchdog:
        self._slow_before = self._interface.call(slowness)
        self._interface.call(self._start)
        self._ended = threading.Event()
        self._looker = threading.Thread(target=self._look, daemon=True)
        self._looker.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self._ended.set()
        self._looker.join()
        self._interface.call(self._stop)
        self.slowness = (self._slow_before + self._interface.call(slowness)) / 2.0
        self.max_cpu_ms, self.max_python_ms = self.max_cpu_ms / self.slowness, self.max_python_ms / self.slowness

    def _start(self) -> None:
        self._thread = threading.get_native_id()
        self._seen_s, self._cpu_s = time.perf_counter(), time.thread_time()
        self._queued_s = waited_for_a_core_s(self._thread)
        self._timer = QtCore.QTimer()
        self._timer.setTimerType(QtCore.Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)
        self._timer.start(TICK_MS)

    def _stop(self) -> None:
        self._tick()
        self._timer.stop()
        self._timer.deleteLater()

    def key_seen(self) -> None:
        """End the block here, in the interface thread: keys that wait in a row there are several blocks, not one."""
        self._tick()

    def _tick(self) -> None:
        now_s, cpu_s, queued_s = time.perf_counter(), time.thread_time(), waited_for_a_core_s(self._thread)
        took_ms, cpu_ms = 1000 * (now_s - self._seen_s), 1000 * (cpu_s - self._cpu_s)
        self.max_ms = max(self.max_ms, took_ms)
        self.max_waited_ms = max(self.max_waited_ms, took_ms - cpu_ms - 1000 * (queued_s - self._queued_s))
        if cpu_ms > self.max_cpu_ms:
            self.max_cpu_ms, self.where_cpu = cpu_ms, self._stack
        if self._saw_python:
            self.max_python_ms = max(self.max_python_ms, cpu_ms)
        self._stack, self._saw_python = "", False
        self._seen_s, self._cpu_s, self._queued_s = now_s, cpu_s, queued_s

    def _look(self) -> None:
        """Keep the stack of the longest block, looked at while it lasts."""
        longest_s = 0.02
        while not self._ended.wait(0.01):
            blocked_s = time.perf_counter() - self._seen_s
            if blocked_s > 0.02:
                self._stack = interface_stack()
                self._saw_python |= NO_PYTHON not in self._stack and "in _tick" not in self._stack
            if blocked_s > longest_s:
                longest_s, self.where = blocked_s, self._stack

    def __str__(self) -> str:
        return (
            f"longest block {self.max_ms:.0f} ms ({self.max_cpu_ms:.0f} ms of its own work, "
            f"{self.max_python_ms:.0f} ms "
            f"with Python in it, on a processor {self.slowness:.1f} times as slow as usual; "
            f"{self.max_waited_ms:.0f} ms of waiting) in\n{self.where}\n"
            f"the most of its own work in\n{self.where_cpu}"
        )


PACKAGE = str(Path(__file__).resolve().parents[2] / "CNCStepper") + os.sep
LONGEST_MS = 50.0  # so much of its processor time may our package use in one event of the window, at usual speed
KEPT_MS = 25.0  # shorter blocks are forgotten

Sample = tuple[tuple[str, int, str], ...]  # file, line and function of each of our calls, the innermost first


@dataclass(frozen=True)
class Block:
    """What kept the interface thread from its events: the processor time of our package in it, and where that was."""

    ours_ms: float
    cpu_ms: float
    where: Sample

    def __str__(self) -> str:
        calls = "\n".join(f"  {path.removeprefix(PACKAGE)}:{line} {name}" for path, line, name in self.where)
        return f"{self.ours_ms:.0f} ms of our own in a block of {self.cpu_ms:.0f} ms, most often in\n{calls}"


class EventWatchdog(Watchdog):
    """A watchdog over what events do in the window: what tests ask the interface thread for is left out.

    `blocks` has those that used most. Of each, that share of the processor time is our package's in which samples saw
    it at work: the rest is FreeCAD's and Qt's own. `ControlOfFreeCAD` leaves out what FreeCAD does for us.
    """

    SAMPLE_S = 0.005

    def __init__(self, interface: Interface) -> None:
        super().__init__(interface)
        self.blocks: list[Block] = []
        self._samples: list[Sample] = []
        self._is_asked = False  # the tests' own work is going on, whatever events FreeCAD lets in meanwhile

    def __enter__(self) -> EventWatchdog:
        super().__enter__()
        self._interface.watchdogs.append(self)
        return self

    def __exit__(self, *error: object) -> None:
        self._interface.watchdogs.remove(self)
        super().__exit__(*error)
        self.blocks = [replace(block, ours_ms=block.ours_ms / self.slowness) for block in self.blocks]

    @property
    def longest(self) -> Block:
        """The block in which our package used most."""
        return max(self.blocks, key=lambda block: block.ours_ms, default=Block(0.0, 0.0, ()))

    def end_block(self) -> None:
        """End a block where the tests' own work begins."""
        self._tick()
        self._is_asked = True

    def begin_block(self) -> None:
        """Begin a block behind the tests' own work."""
        self._is_asked = False
        self._samples = []
        self._seen_s, self._cpu_s = time.perf_counter(), time.thread_time()

    def _tick(self) -> None:
        if self._is_asked:
            return
        samples, self._samples = self._samples, []
        cpu_ms = 1000 * (time.thread_time() - self._cpu_s)
        ours = [sample for sample in samples if sample] if cpu_ms > KEPT_MS else []
        if ours:
            self.blocks.append(Block(cpu_ms * len(ours) / len(samples), cpu_ms, max(ours, key=ours.count)))
        super()._tick()

    def _look(self) -> None:
        while not self._ended.wait(self.SAMPLE_S):
            self._samples.append(our_calls())


def our_calls() -> Sample:
    """Return the calls of our package that the interface thread is in."""
    frame, calls = sys._current_frames().get(threading.main_thread().ident or 0), []
    while frame is not None:
        path = plain_path(frame.f_code.co_filename)
        if path.startswith(PACKAGE):
            calls.append((path, frame.f_lineno, frame.f_code.co_name))
        frame = frame.f_back
    return tuple(calls)


class ControlOfFreeCAD:
    """FreeCAD's `FreeCADGui.Control`, whose long calls are no work of ours.

    showDialog: Qt lays out and paints a panel. closeDialog: FreeCAD deletes it and shows its tree again.
    """

    LONG = ("showDialog", "closeDialog")

    def __init__(self, control: Any, interface: Interface) -> None:
        self._control, self._interface = control, interface

    def __getattr__(self, name: str) -> Any:
        method = getattr(self._control, name)
        return partial(self._call, method) if name in self.LONG else method

    def _call(self, method: Callable[..., Any], *arguments: Any) -> Any:
        for watchdog in self._interface.watchdogs:
            watchdog.end_block()
        try:
            return method(*arguments)
        finally:
            for watchdog in self._interface.watchdogs:
                watchdog.begin_block()


@cache
def plain_path(path: str) -> str:
    """Return a path without the dots that FreeCAD puts into it."""
    return os.path.normpath(path)
