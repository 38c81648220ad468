# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the call of `hold` in a window to its byte at the far end of a serial line that is full of a job's lines; at two
rates, and more and more is busy.
"""

from __future__ import annotations

import json
import multiprocessing
import os
import random
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from itertools import product
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from paced_controller import serve

from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.connection_client import ConnectionClient

BAUDS = (115_200, 1_000_000)
LINES_OVER = ("socket", "terminal")  # see `paced_controller`
LINE = "G1X0.000Y0.000F1000"
HOLDS = 200
FULL_S = 0.03  # after which a job that goes on has filled its line again, and up to twice that
LINES_PER_HOLD = 0.3  # seconds of the line, of which a hold takes less
WAIT_LIMIT_S = 20.0
WINDOW_S = 0.002  # between two looks of a window that has nothing to do
CORES = os.cpu_count() or 1

Busy = Callable[[], object]


class BenchError(Exception):
    """What a benchmark waited for does not come."""


class Window:
    """A window at a service whose port is a paced controller; `busy` is what the window does besides."""

    def __init__(self, port: str, baud: int, folder: Path, notes: Connection, busy: Busy):
        self._client = ConnectionClient.launch(port, baud, folder)
        self._notes = notes
        self._busy = busy
        self._refused = ""

    def cut(self, job_file: Path) -> None:
        """Connect, set the zero, as the controller has restarted, and let a job run."""
        self._until("the service's connection", lambda: self._client.phase == "connected")
        self._client.set_zero()
        self._until("the zero", lambda: self._client.status.position_known is True)
        self._client.run(job_file, zero_confirmed=True)

    def hold(self) -> float:
        """Hold the running job once, and resume it; return the delay of the hold, s."""
        client = self._client
        self._until("the running job", lambda: client.status.phase == "running")
        full_s = time.monotonic() + FULL_S * (1.0 + random.random())
        self._until("the full line", lambda: time.monotonic() > full_s)
        called_s = time.monotonic()
        client.hold()
        self._until("the byte of the hold", self._notes.poll)
        delay_s = self._notes.recv() - called_s
        self._until("the held machine", lambda: client.status.phase == "held")
        if self._notes.poll():
            raise BenchError("a hold was written twice: its delays would be those of other holds")
        client.resume()
        return delay_s

    def stop(self) -> None:
        """End the job."""
        self._client.stop()
        self._until("the job's end", lambda: self._client.outcome is not None, ends=True)

    def leave(self) -> None:
        """Let the service end, and wait until it has: its files go with its folder."""
        self._client.leave()
        end_s = time.monotonic() + WAIT_LIMIT_S
        while (file := self._client.session_file) and file.exists() and time.monotonic() < end_s:
            time.sleep(WINDOW_S)

    def _until(self, what: str, reached: Callable[[], Any], ends: bool = False) -> None:
        """Look at the service as a window does until something is reached; raises BenchError where it cannot be."""
        end_s = time.monotonic() + WAIT_LIMIT_S
        while not reached():
            for event in self._client.poll():
                self._refused = event["text"] if event["event"] == "refused" else self._refused
            self._busy()
            client = self._client
            if client.phase == "gone":
                raise BenchError(f"while {what} was waited for the service ended: {client.error}")
            if client.outcome and not ends:
                raise BenchError(f"while {what} was waited for the job ended: {client.outcome.text}")
            if time.monotonic() > end_s:
                raise BenchError(f"{what} did not come within {WAIT_LIMIT_S:g} s. {self._refused}".strip())


def measure(baud: int, over: str, busy: Busy) -> tuple[list[float], bool]:
    """Return the delays of many holds, s, sorted, and whether the controller went before all other processes."""
    notes, there = multiprocessing.Pipe()
    with process(serve, there, baud, over), tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        if not notes.poll(WAIT_LIMIT_S):
            raise BenchError("the controller does not come up")
        port, goes_first = notes.recv()
        job_file = Path(folder) / "job.json"
        lines = round(HOLDS * LINES_PER_HOLD * baud / 10 / (len(LINE) + 1))
        write_job(job_file, SendJob("", [LINE] * lines))
        window = Window(port, baud, Path(folder), notes, busy)
        try:
            window.cut(job_file)
            delays_s = [window.hold() for _ in range(HOLDS)]
            window.stop()
        finally:
            window.leave()
    return sorted(delays_s), goes_first


@contextmanager
def process(target: Callable[..., None], *arguments: object) -> Iterator[multiprocessing.process.BaseProcess]:
    """A process of the benchmark, which ends with it."""
    started = multiprocessing.get_context("spawn").Process(target=target, args=arguments, daemon=True)
    started.start()
    try:
        yield started
    finally:
        started.kill()


def spin() -> None:
    """Keep a core busy."""
    while True:
        pass


def show(baud: int, over: str, case: str, busy: Busy) -> None:
    """Print the delays of a case."""
    delays_s, goes_first = measure(baud, over, busy)
    half_ms, most_ms, longest_ms = (1000 * delays_s[int(share * (len(delays_s) - 1))] for share in (0.5, 0.99, 1))
    late = "" if goes_first else ", the far end may be late"
    print(
        f"hold at {baud} baud over a {over}, {case}: median {half_ms:.2f} ms, 99 % within {most_ms:.2f} ms, "
        f"longest {longest_ms:.2f} ms, load {os.getloadavg()[0]:.1f} on {CORES} cores{late}",
        flush=True,
    )


def main() -> None:
    """Print the delays beside each other."""
    flood = json.dumps({"numbers": list(range(20_000))})
    for baud, over in product(BAUDS, LINES_OVER):
        show(baud, over, "nothing busy", lambda: time.sleep(WINDOW_S))
        with process(spin):
            show(baud, over, "a core kept busy", lambda: time.sleep(WINDOW_S))
            show(baud, over, "window and a core kept busy", lambda: json.loads(flood))


if __name__ == "__main__":
    try:
        main()
    except BenchError as error:
        sys.exit(f"bench_hold: {error}")
