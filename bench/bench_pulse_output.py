# SPDX-License-Identifier: LGPL-2.1-or-later
"""The player of pulses: how late its writes come, and which share of a core its process takes, running and at rest.

A steady rate first; then a published program of the thesis through the controller, to its end, and a hold within it.

Lateness is a matter of what else the computer does: its load is printed beside it. Nothing is asserted.

    python bench/bench_pulse_output.py [PORT]     a parallel port's device file; a recording and a socket without it
"""

from __future__ import annotations

import os
import socket
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path

import numpy as np

from CNCStepper.control.pulses.pulse_player_client import PulseOutput
from CNCStepper.controllers.pulse_axes import load_kernels
from CNCStepper.controllers.pulse_board import PulseBoard
from CNCStepper.errors import CNCStepperError
from CNCStepper.job.wire_round_trip import wire_round_trip
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.planner.buffers import TICKS_PER_S, UNLIMITED

PORT_RATES, BOARD_RATES = (1000, 10_000, 25_000), (100, 500, 1000)
MEASURED_S = 3.0  # of each figure
HOLD_AFTER_S, TICK_S = 0.4, 0.0015  # of a program; between two looks of a controller's process
PROGRAM = """g90|y-80|G2 x-80 y0 i0 j0|G90|x-160 y0|G2 x0 y160 i0 j0|G90|y80|G2 x80 y0 i0 j0|G90|x160|G2 x0 y-160 i0 j0
|g90|y-80"""
CHUNK = 2000
JIFFIES_PER_S = os.sysconf("SC_CLK_TCK") if hasattr(os, "sysconf") else 100


def core_s(process: int) -> float:
    """Return the processor seconds of a process."""
    fields = Path(f"/proc/{process}/stat").read_text("ascii").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / JIFFIES_PER_S


def share(output: PulseOutput, work: Callable[[], None]) -> float:
    """Return which share of a core the player takes during some work."""
    begun_s, begun = core_s(output.process), time.monotonic()
    work()
    return (core_s(output.process) - begun_s) / (time.monotonic() - begun)


def play(output: PulseOutput, rate: float) -> None:
    """Play a steady rate, given a second ahead."""
    ticks = np.arange(1, int(rate * MEASURED_S) + 1, dtype=np.int64) * round(TICKS_PER_S / rate)
    ones = np.ones(CHUNK, np.uint8)
    others = ones, ones * 0, (rate / 80 * ones).astype(np.float32), (UNLIMITED * ones).astype(np.float32), ones < 0
    for first in range(0, len(ticks), CHUNK):
        while output.queued_s > 1.0:
            time.sleep(0.01)
        some = ticks[first : first + CHUNK]
        output.append(some, *(column[: len(some)] for column in others))
    while output.state != "idle":
        output.check()
        time.sleep(0.01)


def rest() -> None:
    """Let nothing move."""
    time.sleep(MEASURED_S)


@contextmanager
def drained() -> Iterator[str]:
    """Give the name of a socket whose other end takes all that comes."""
    with socket.create_server(("127.0.0.1", 0)) as server:

        def take() -> None:
            with server.accept()[0] as connection:
                while connection.recv(65536):
                    pass

        threading.Thread(target=take, daemon=True).start()
        yield f"socket://127.0.0.1:{server.getsockname()[1]}"


@contextmanager
def recorded() -> Iterator[str]:
    """Give the name of a recording in a temporary folder."""
    with tempfile.TemporaryDirectory() as folder:
        yield f"record:{Path(folder) / 'port.csv'}"


def measure(port: str, machine: Machine, rate: int) -> None:
    """Print the figures of one rate, and of the rests behind it."""
    output = PulseOutput.launch(port, machine)
    try:
        runs = share(output, lambda: play(output, rate))
        late = output.jitter()
        idles = share(output, rest)
        output.hold()
        figures = f"{late.mean_us:8.1f} {late.p99_us:8.0f} {late.worst_us:8.0f}"
        print(f"{rate:8d} {figures} {runs:7.1%} {idles:6.1%} {share(output, rest):6.1%}", flush=True)
    except CNCStepperError as error:
        print(f"{rate:8d} {error}", flush=True)
    finally:
        output.close()


def quick_table(rate: int) -> Machine:
    """Return the thesis's table with as many pulses a millimetre that a program reaches the rate, at 250 mm/s."""
    table = load_machine("thesis-table")
    top = {"steps_per_mm": rate / 250, "max_rate_mm_min": 15_000, "acceleration_mm_s2": 2000}
    axes = {name: axis.model_copy(update=top) for name, axis in table.axis.items()}
    signals = table.signals.model_copy(update={"pulse_us": 10, "gap_us": 10})
    return table.model_copy(update={"axis": axes, "signals": signals, "feed_mm_min": 15_000, "interpolation": "dda"})


class Cut:
    """A program on its way through a controller of this computer, in the clock of the wall."""

    def __init__(self, port: str, machine: Machine):
        wire, *_ = wire_round_trip(PROGRAM.replace("\n", "").replace("|", "\n"), machine, machine.language(), "1.nc")
        load_kernels(machine)
        self.output = PulseOutput.launch(port, machine)
        self.board = PulseBoard(machine, self.output)
        self._lines, self._last_s = iter(wire.lines), time.monotonic()
        self._waits = False

    def turn(self) -> None:
        """Let the controller work once; give it the next line behind an ok."""
        now_s = time.monotonic()
        self.board.advance(now_s - self._last_s)
        self._last_s = now_s
        self._waits = self._waits and b"ok" not in self.board.take_output()
        if not self._waits and (line := next(self._lines, None)):
            self.board.receive(line.encode("ascii") + b"\n")
            self._waits = True
        time.sleep(TICK_S)

    def run(self, until: Callable[[], bool]) -> float:
        """Run until something holds; return the time that it took."""
        begun = time.monotonic()
        while not until():
            self.turn()
        return time.monotonic() - begun

    def is_done(self) -> bool:
        """Return whether all is cut."""
        return not self._waits and self.board.quiet


def cut(port: str, rate: int) -> None:
    """Print lateness and share of a core of the program at one rate, and how long a hold in it takes to stand."""
    machine = quick_table(rate)
    one = Cut(port, machine)
    try:
        begun_s, begun = core_s(one.output.process), time.monotonic()
        one.run(lambda: time.monotonic() > begun + HOLD_AFTER_S)
        speed = one.output.rate_mm_min / 60.0
        one.board.receive(b"!")
        held_s = one.run(lambda: one.board.at_rest)
        one.turn()  # the board sees that it stands: before that it ignores a cycle start, as grbl does
        one.board.receive(b"~")
        one.run(one.is_done)
        busy = (core_s(one.output.process) - begun_s) / (time.monotonic() - begun)
        late, ramp_s = one.output.jitter(), speed / machine.axes[0].acceleration_mm_s2
        figures = f"{late.mean_us:8.1f} {late.p99_us:8.0f} {late.worst_us:8.0f}"
        hold = f"{1000 * held_s:6.1f} {1000 * ramp_s:6.1f}"
        print(f"{rate:8d} {figures} {busy:7.1%} {hold}   {one.output.sent} pulses", flush=True)
    except CNCStepperError as error:
        print(f"{rate:8d} {error}", flush=True)
    finally:
        one.board.close()


def main() -> None:
    """Print what is measured at each kind of port."""
    table = load_machine("table-a")
    board = table.model_copy(update={"controller": "usb-board"})
    print(f"load of {os.cpu_count()} cores: {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "")
    kinds: list[tuple[str, Callable]] = [("recording", recorded), ("socket", drained)]
    if len(sys.argv) > 1:
        kinds = [(sys.argv[1], lambda: nullcontext(sys.argv[1]))]
    for title, port in kinds:
        for what, machine, rates in (("registers", table, PORT_RATES), ("board", board, BOARD_RATES)):
            print(f"{title}, {what}: pulses/s, late: mean us, 99 %, worst; share of a core: running, idle, held")
            for rate in rates:
                with port() as name:
                    measure(name, machine, rate)
        print(
            f"{title}, program 1: pulses/s, late: mean us, 99 %, worst; share of a core; hold stands after ms, its ramp"
        )
        for rate in PORT_RATES:
            with port() as name:
                cut(name, rate)


if __name__ == "__main__":
    main()
