# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of 100 000 short blocks to a controller behind a line of a given rate: time, processor time, and holds.

Each run is beside what it cannot be faster than: the longer of the line's time for the bytes and the blocks' own
time. The controller keeps to the line's rate in both directions, to its receive buffer and to its planner's blocks;
it knows nothing of G-code, so that its own work does not slow the line.
"""

from __future__ import annotations

import multiprocessing
import resource
import select
import socket
import subprocess
import sys
import tempfile
import time
from collections import deque
from contextlib import suppress
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

from CNCStepper.control.outcome import Outcome
from CNCStepper.control.send_job import SendJob
from CNCStepper.control.session import SessionClient

BLOCKS = 100_000
HOLDS = 200
HOLD_EVERY_S = 0.02
LOOK_S = 0.0001  # how long the line rests between two looks
LONGEST_LAG_S = 0.002  # what the system keeps a controller waiting beyond this does not count as time
REALTIME = b"!~?\x18"
GREETING = b"\r\nGrbl 1.1h ['$' for help]\r\n"


@dataclass(frozen=True)
class Kind:
    """A controller: its line's rate, its receive buffer, its planner, and how long a block of the program takes."""

    name: str
    baud: int
    buffer_bytes: int
    planner_blocks: int
    block_s: float


KINDS = (
    Kind("115 200 baud, line is slower", 115_200, 128, 15, 0.001),
    Kind("115 200 baud, blocks are slower", 115_200, 128, 15, 0.0016),
    Kind("1 Mbaud, line is slower", 1_000_000, 1024, 35, 0.0001),
    Kind("1 Mbaud, blocks are slower", 1_000_000, 1024, 35, 0.0002),
)


@dataclass(frozen=True)
class Noted:
    """What the controller saw: seconds from the first byte of the program to the end of its last block, how often
    the planner ran empty on the way, and bytes that its buffer lost."""

    took_s: float
    starved: int
    lost: int


class Controller:
    """The far end of the line; `!` is told through `notes` when its byte has come over the line, then the result."""

    def __init__(self, kind: Kind, notes: Connection):
        self._kind, self._notes = kind, notes
        self._rate = kind.baud / 10
        listener = socket.create_server(("127.0.0.1", 0))
        notes.send("socket://{}:{}".format(*listener.getsockname()))
        self._client, _ = listener.accept()
        self._client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self._client.setblocking(False)
        self._ring = bytearray()
        self._out = bytearray(GREETING)
        self._ends_s: deque[float] = deque()
        self._begun_s = self._end_s = 0.0
        self._starved = self._lost = 0
        self._held_since_s: float | None = None

    def serve(self) -> None:
        """Serve the client until it leaves."""
        last_s, now_s, come, gone = time.monotonic(), 0.0, 0.0, 0.0
        with suppress(ConnectionError):
            while True:
                select.select([self._client], [], [], LOOK_S)
                passed_s, last_s = min(time.monotonic() - last_s, LONGEST_LAG_S), time.monotonic()
                now_s += passed_s
                come, gone = come + passed_s * self._rate, gone + passed_s * self._rate
                come = self._take(int(come), now_s) and come % 1.0
                self._read_lines(now_s)
                gone = self._say(int(gone)) and gone % 1.0
        self._notes.send(Noted(self._end_s - self._begun_s, self._starved, self._lost))

    def _take(self, most: int, now_s: float) -> bool:
        """Take what the line has carried; return whether it was carrying all the time."""
        try:
            data = self._client.recv(most) if most else b""
        except BlockingIOError:
            return False
        if most and not data:
            raise ConnectionResetError
        for byte in (bytes([number]) for number in data if number in REALTIME):
            self._act(byte, now_s)
        self._ring += data.translate(None, REALTIME)
        self._lost += max(len(self._ring) - self._kind.buffer_bytes, 0)
        return len(data) == most

    def _act(self, byte: bytes, now_s: float) -> None:
        if byte == b"!":
            self._notes.send(time.monotonic())
            self._held_since_s = self._held_since_s or now_s
        elif byte == b"~" and self._held_since_s is not None:
            self._ends_s = deque(end_s + now_s - self._held_since_s for end_s in self._ends_s)
            self._held_since_s = None
        elif byte == b"\x18":
            self._ring.clear()
            self._ends_s.clear()
            self._held_since_s = None
            self._out += GREETING
        elif byte == b"?":
            self._out += b"<%s|MPos:0.000,0.000,0.000|Bf:%d,%d|FS:0,0>\r\n" % (
                self._state(),
                self._kind.planner_blocks - len(self._ends_s),
                self._kind.buffer_bytes - 1 - len(self._ring),
            )

    def _state(self) -> bytes:
        return b"Hold:0" if self._held_since_s is not None else b"Run" if self._ends_s else b"Idle"

    def _read_lines(self, now_s: float) -> None:
        """Plan lines while there is room, and answer them."""
        if self._held_since_s is not None:
            return
        while self._ends_s and self._ends_s[0] <= now_s:
            self._end_s = self._ends_s.popleft()
        while len(self._ends_s) < self._kind.planner_blocks and (end := self._ring.find(b"\n")) >= 0:
            line = bytes(self._ring[:end])
            del self._ring[: end + 1]
            if line.startswith(b"$"):
                self._out += b"[VER:1.1h:]\r\n[OPT:V,15,%d]\r\n" % self._kind.buffer_bytes if line == b"$I" else b""
            else:
                self._plan(now_s)
            self._out += b"ok\r\n"

    def _plan(self, now_s: float) -> None:
        self._begun_s = self._begun_s or now_s
        self._starved += bool(self._end_s) and not self._ends_s and now_s > self._end_s + self._kind.block_s
        begin_s = self._ends_s[-1] if self._ends_s else max(self._end_s, now_s - LOOK_S)
        self._ends_s.append(begin_s + self._kind.block_s)

    def _say(self, most: int) -> bool:
        if self._out and most:
            del self._out[: self._client.send(self._out[:most])]
        return bool(self._out)


def control(kind: Kind, notes: Connection) -> None:
    """Be the controller's process."""
    Controller(kind, notes).serve()


def job(port: str, baud: int, blocks: int) -> SendJob:
    """Return a job of short blocks."""
    lines = [f"G1X{number % 90 + 10}.{number % 1000:03}Y1.5" for number in range(blocks)]
    return SendJob(port, lines, baud=baud, zero_confirmed=True)


def bound_s(sent: SendJob, block_s: float) -> float:
    """Return the time that no sender can go below."""
    return max(sum(len(line) + 1 for line in sent.lines) * 10 / sent.baud, len(sent.lines) * block_s)


def run(sent: SendJob, holds: Connection | None = None) -> tuple[Outcome, float, list[float]]:
    """Send a job; return its outcome, the sender's processor time from its start, s, and the delays of holds, s."""
    with tempfile.TemporaryDirectory() as folder:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        client = SessionClient.start(sent, folder=Path(folder))
        delays = [_hold(client, holds) for _ in range(HOLDS)] if holds else []
        if holds:
            client.stop()
        outcome = client.wait()
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return outcome, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, delays


def _hold(client: SessionClient, wire: Connection) -> float:
    """Hold a running job once, and resume it; return the delay of the hold, s."""
    while client.status().phase != "running" or client.status().acknowledged < 200:
        time.sleep(0.001)
    time.sleep(HOLD_EVERY_S)
    called_s = time.monotonic()
    client.hold()
    delay_s = wire.recv() - called_s
    while client.status().phase != "held":
        time.sleep(0.001)
    client.resume()
    return delay_s


def start(kind: Kind) -> tuple[multiprocessing.process.BaseProcess, Connection, str]:
    """Start a controller; return its process, its notes and its port."""
    here, there = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=control, args=(kind, there), daemon=True)
    process.start()
    return process, here, here.recv()


def show_stream(kind: Kind) -> None:
    """Print one run's time beside its bound."""
    process, notes, port = start(kind)
    sent = job(port, kind.baud, BLOCKS)
    outcome, cpu_s, _ = run(sent)
    noted = notes.recv()
    process.join()
    assert outcome.done, outcome.text
    bound = bound_s(sent, kind.block_s)
    print(
        f"{kind.name}: {noted.took_s:.2f} s, not below {bound:.2f} s, ratio {noted.took_s / bound:.4f}, planner empty "
        f"{noted.starved} times, bytes lost {noted.lost}, sender {100 * cpu_s / noted.took_s:.1f} % of a core",
        flush=True,
    )


def show_holds(kind: Kind) -> None:
    """Print the delays from the call of `hold` to its byte at the far end of the line, while a core is kept busy."""
    process, notes, port = start(kind)
    with subprocess.Popen([sys.executable, "-c", "while True: pass"]) as busy:
        _, _, delays = run(job(port, kind.baud, 20 * BLOCKS), notes)
        busy.kill()
    process.join()
    delays = sorted(1000 * delay_s for delay_s in delays)
    print(
        f"hold at {kind.baud} baud at full rate, a core kept busy: median {delays[HOLDS // 2]:.2f} ms, "
        f"99 % within {delays[int(0.99 * HOLDS)]:.2f} ms, longest {delays[-1]:.2f} ms",
        flush=True,
    )


def main() -> None:
    """Print every run, then the holds."""
    for kind in KINDS:
        show_stream(kind)
    for kind in KINDS[::2]:
        show_holds(kind)


if __name__ == "__main__":
    main()
