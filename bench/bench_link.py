# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job of 100 000 short blocks to the virtual machine behind a line of a given rate: time, processor time, and holds.

Each run is beside what it cannot be faster than: the longer of the line's time for the bytes and the time of the moves
at their feed. Times are the virtual machine's own, so that a computer that keeps it waiting does not count.
"""

from __future__ import annotations

import math
import multiprocessing
import os
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path

from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.status import Outcome
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl import realtime
from CNCStepper.virtual.grbl.firmware import FIRMWARES
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.grbl_server import serve

BLOCKS = 100_000
HOLDS = 200
HOLD_EVERY_S = 0.02
RADIUS_MM = 30.0  # of the circle that is cut again and again
QUICK = {"steps_per_mm": 400, "max_rate_mm_min": 12_000, "acceleration_mm_s2": 20_000}  # so that the line can be slower


@dataclass(frozen=True)
class Kind:
    """A controller, its line's rate and its planner, and the program: length and speed of its blocks."""

    name: str
    firmware: str
    baud: int
    planner_blocks: int
    block_mm: float
    feed_mm_min: float

    @property
    def machine(self) -> Machine:
        """The profile of the machine."""
        machine = load_machine("table-a")
        axes = {name: axis.model_copy(update=QUICK) for name, axis in machine.axis.items()}
        planner = machine.planner.model_copy(update={"look_ahead_blocks": self.planner_blocks})
        return machine.model_copy(update={"axis": axes, "planner": planner})

    def lines(self, blocks: int) -> list[str]:
        """Return a program of short lines round a circle."""
        angles = (number * self.block_mm / RADIUS_MM for number in range(blocks))
        places = (f"X{RADIUS_MM * math.sin(a):.3f}Y{RADIUS_MM * (1 - math.cos(a)):.3f}" for a in angles)
        return [f"G21G90G1F{self.feed_mm_min:g}", *places]


KINDS = (
    Kind("115 200 baud, line is slower", "grbl", 115_200, 15, 0.1, 6000),
    Kind("115 200 baud, blocks are slower", "grbl", 115_200, 15, 0.1, 3000),
    Kind("1 Mbaud, line is slower", "grblhal", 1_000_000, 35, 0.01, 6000),
    Kind("1 Mbaud, blocks are slower", "grblhal", 1_000_000, 35, 0.01, 2400),
)


@dataclass
class Seen:
    """What the machine has seen, in s of its own time and of this computer's: first to last motion, how often its
    planner ran empty between, and bytes that its buffer lost."""

    begin_s: float = 0.0
    end_s: float = 0.0
    begin_real_s: float = 0.0
    end_real_s: float = 0.0
    starved: int = 0
    lost: int = 0
    cpu_s: float = 0.0  # of the machine's process, compiling and all
    was_empty: bool = True

    def look(self, board: Grbl) -> None:
        """Look at a board after each of its steps."""
        empty = board.axes.room == board.memory.settings.machine.planner.look_ahead_blocks
        if not empty:
            if not self.begin_s:
                self.begin_s, self.begin_real_s = board.time_s, time.monotonic()
            elif self.was_empty:
                self.starved += 1
            self.end_s, self.end_real_s, self.lost = board.time_s, time.monotonic(), board.ring.lost
        self.was_empty = empty


def control(kind: Kind, notes: Connection) -> None:
    """Be the virtual machine's process: tell its port, when the byte of each hold has come, and what was seen."""
    seen = Seen()
    hold = realtime.COMMANDS[realtime.HOLD]

    def note_hold(board: Grbl, byte: int) -> None:
        notes.send(time.monotonic())
        hold(board, byte)

    def visit(board: Grbl) -> Callable[[], None]:
        board.on_step = seen.look
        realtime.COMMANDS[realtime.HOLD] = note_hold
        return lambda: None

    serve(
        kind.machine,
        tcp="127.0.0.1:0",
        baud=kind.baud,
        firmware=FIRMWARES[kind.firmware],
        until_left=True,
        ready=notes.send,
        visit=visit,
    )
    seen.cpu_s = time.process_time()
    notes.send(seen)


def moves_s(kind: Kind, lines: list[str]) -> float:
    """Return how long the moves of a program take at the feed, s."""
    return len(lines) * kind.block_mm / kind.feed_mm_min * 60


def line_s(kind: Kind, lines: list[str]) -> float:
    """Return how long the line takes for a program, s."""
    return sum(len(line) + 1 for line in lines) * 10 / kind.baud


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
    """Start a virtual machine; return its process, its notes and its port."""
    here, there = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=control, args=(kind, there), daemon=True)
    process.start()
    return process, here, here.recv()


def show_stream(kind: Kind, blocks: int) -> None:
    """Print one run's time beside its bound."""
    lines = kind.lines(blocks)
    bound_s = max(line_s(kind, lines), moves_s(kind, lines))
    process, notes, port = start(kind)
    outcome, cpu_s, _ = run(SendJob(port, lines, baud=kind.baud, zero_confirmed=True))
    seen = notes.recv()
    process.join()
    assert outcome.done, outcome.text
    took_s, real_s = seen.end_s - seen.begin_s, seen.end_real_s - seen.begin_real_s
    print(
        f"{kind.name}: {took_s:.2f} s, not below {bound_s:.2f} s, ratio {took_s / bound_s:.4f}, planner empty "
        f"{seen.starved} times, bytes lost {seen.lost}, sender {cpu_s:.2f} s, {100 * cpu_s / took_s:.1f} % of a core; "
        f"the machine {seen.cpu_s:.2f} s of processor, "
        f"{real_s:.2f} s by this computer's clock, load {os.getloadavg()[0]:.1f}",
        flush=True,
    )


def show_holds(kind: Kind, blocks: int) -> None:
    """Print the delays from the call of `hold` to its byte at the far end of the line, while a core is kept busy."""
    process, notes, port = start(kind)
    with subprocess.Popen([sys.executable, "-c", "while True: pass"]) as busy:
        _, _, delays = run(SendJob(port, kind.lines(blocks), baud=kind.baud, zero_confirmed=True), notes)
        busy.kill()
    process.join()
    delays = sorted(1000 * delay_s for delay_s in delays)
    print(
        f"hold at {kind.baud} baud at full rate, a core kept busy: median {delays[HOLDS // 2]:.2f} ms, "
        f"99 % within {delays[int(0.99 * HOLDS)]:.2f} ms, longest {delays[-1]:.2f} ms, load {os.getloadavg()[0]:.1f}",
        flush=True,
    )


def main(blocks: int) -> None:
    """Print every run, then the holds."""
    for kind in KINDS:
        show_stream(kind, blocks)
    for kind in KINDS[::2]:
        show_holds(kind, 20 * blocks)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else BLOCKS)
