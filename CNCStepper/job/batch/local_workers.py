# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs tasks in processes of their own on this computer: `CNCStepper.workers.batch_worker`.

tasks ──► one thread for each process ──► JSON line ──► process ──► JSON line ──► results, as they are done
                 └── the process ended: a new one, and the task once more, at most MOST_TRIES times
"""

from __future__ import annotations

import base64
import json
import subprocess
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import suppress
from queue import Empty, SimpleQueue
from types import TracebackType
from typing import Any, Protocol

from CNCStepper.control.processes.python_finder import PROOF, command, environment, find_python
from CNCStepper.control.session.status import error_to_json
from CNCStepper.errors import CNCStepperError

MODULE = "CNCStepper.workers.batch_worker"
MOST_TRIES = 8  # of a task whose process ends
LOOK_EVERY_S = 0.2
Task = dict[str, Any]
Result = dict[str, Any]


class Workers(Protocol):
    """What runs tasks: processes here, or a cluster."""

    def __enter__(self) -> Workers:
        """Begin."""

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        """End all that runs."""

    def results(self, tasks: Sequence[Task]) -> Iterator[tuple[int, Result]]:
        """Yield the number of each task and its result, as they are done."""


def encoded(content: dict[str, Any]) -> bytes:
    """Return a task or a result as a line of JSON, the bytes of its files in base 64."""
    files = {name: base64.b64encode(data).decode("ascii") for name, data in content.get("files", {}).items()}
    return json.dumps({**content, "files": files}).encode("utf-8") + b"\n"


def decoded(line: bytes | str) -> dict[str, Any]:
    """Return the task or result of a line; raises ValueError for a broken one."""
    content: dict[str, Any] = json.loads(line)
    content["files"] = {name: base64.b64decode(data) for name, data in content["files"].items()}
    return content


class LocalWorkers:
    """Processes on this computer that run tasks; one that ends is started anew."""

    def __init__(self, count: int):
        self._processes: list[subprocess.Popen[bytes] | None] = [None] * count
        self._over = threading.Event()
        self._python = ""

    def __enter__(self) -> LocalWorkers:
        self._python = find_python(PROOF)
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, at: TracebackType | None) -> None:
        self._over.set()
        for number in range(len(self._processes)):
            self._end(number)

    @property
    def pids(self) -> list[int]:
        """The ids of the processes that run."""
        return [process.pid for process in self._processes if process is not None]

    def results(self, tasks: Sequence[Task]) -> Iterator[tuple[int, Result]]:
        """Yield the number of each task and its result, as they are done."""
        waiting: SimpleQueue[int] = SimpleQueue()
        for number in range(len(tasks)):
            waiting.put(number)
        done: SimpleQueue[tuple[int, Result | BaseException]] = SimpleQueue()
        for place in range(min(len(self._processes), len(tasks))):
            threading.Thread(target=self._serve, args=(place, tasks, waiting, done), daemon=True).start()
        for _ in tasks:
            number, result = _next(done)
            if isinstance(result, BaseException):
                raise result
            yield number, result

    def _serve(
        self,
        place: int,
        tasks: Sequence[Task],
        waiting: SimpleQueue[int],
        done: SimpleQueue[tuple[int, Result | BaseException]],
    ) -> None:
        with suppress(Empty):
            while not self._over.is_set():
                number = waiting.get_nowait()
                try:
                    done.put((number, self._ask(place, tasks[number])))
                except BaseException as error:  # a process that cannot be started: the caller's thread raises it
                    done.put((number, error))

    def _ask(self, place: int, task: Task) -> Result:
        """Return the result of a process, of a new one where it ends."""
        question = encoded(task)
        for _ in range(MOST_TRIES):
            process = self._started(place)
            assert process.stdin and process.stdout
            with suppress(OSError, ValueError):  # it ended, or its last line is torn
                process.stdin.write(question)
                process.stdin.flush()
                return decoded(process.stdout.readline())
            self._end(place)
            if self._over.is_set():
                break
        what, advice = "the process of this task ended each time", "look at this drawing alone: cncstepper job"
        return {"error": error_to_json(CNCStepperError("batch-worker", what, value=f"{MOST_TRIES}", advice=advice))}

    def _started(self, place: int) -> subprocess.Popen[bytes]:
        """Return the process of a place, a new one where there is none."""
        process = self._processes[place]
        if process is None:
            arguments = command(self._python, MODULE)
            process = self._processes[place] = subprocess.Popen(
                arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE, env=environment(), **_apart()
            )
        return process

    def _end(self, place: int) -> None:
        process, self._processes[place] = self._processes[place], None
        if process is not None:
            process.kill()
            process.wait()
            for stream in (process.stdin, process.stdout):
                with suppress(OSError):  # what it has not read is lost, and asked again
                    assert stream
                    stream.close()


def _next(done: SimpleQueue[tuple[int, Result | BaseException]]) -> tuple[int, Result | BaseException]:
    """Return what is done next; Ctrl+C ends the wait."""
    while True:
        with suppress(Empty):
            return done.get(timeout=LOOK_EVERY_S)


def _apart() -> dict[str, Any]:
    """Return what keeps Ctrl+C of our terminal from a process: this one ends it."""
    if sys.platform == "win32":
        return {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW}
    return {"start_new_session": True}
