# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks planned and step events streamed a second of processor time, first pulse and memory of long programs.

Planning is all of it: table of moves to timed segments, as `cncstepper time` does. Streamed steps are planned in the
same run, and stand beside the closed form of every tick (`timeline.step_table`), which says the same.
`python bench/bench_motion.py` prints the lines of docs/benchmarks.md.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
from collections import deque
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from CNCStepper.gcode.interpreter.program_file import FileReading, interpret_file
from CNCStepper.kernels import njit
from CNCStepper.machine.backlash import Backlash
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.planner.backlash_moves import motor_chunks
from CNCStepper.motion.planner.buffers import Planner, is_full, new_planner, new_segments
from CNCStepper.motion.planner.look_ahead import push_line
from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.motion.planner.plan import Run, step_events
from CNCStepper.motion.planner.s_curve_look_ahead import plan_entries
from CNCStepper.motion.planner.segment_generator import next_segment
from CNCStepper.motion.signals.pulse_stream import PulseStream, moved_steps, pulse_stream
from CNCStepper.state import Start, State
from CNCStepper.toolpath import CHUNK_ROWS, LINE, Chunk, Toolpath

MACHINE = load_machine("table-a")
START = Start.at_zero()
SHORT, LONG = 1_000_000, 10_000_000  # lines of the programs that are read
QUEUED = 4000  # blocks of a deep look-ahead
GROWING = (1000, 10_000, 100_000, 1_000_000, LONG)
AGAIN = 3  # calls, of which the fastest counts
WANTED_BLOCKS, WANTED_EVENTS = 5e6, 50e6  # a second


def table_of(end_mm: np.ndarray, feed_mm_min: float) -> Toolpath:
    """Return the table of straight feeds through points, float64[n, 3]."""
    chunks = []
    for first in range(0, len(end_mm), CHUNK_ROWS):
        end = end_mm[first : first + CHUNK_ROWS]
        rows = len(end)
        zeros = (np.zeros(rows, kind) for kind in (np.uint8, np.uint16, np.int32, np.int32))
        plane, turns, state, line = zeros
        kind, feed = np.full(rows, LINE, np.uint8), np.full(rows, feed_mm_min)
        chunks.append(Chunk(first, kind, end, np.zeros((rows, 3)), plane, turns, feed, state, line))
    return Toolpath(START, chunks, [State()])


def spiral(count: int, first: int = 0) -> np.ndarray:
    """Return a spiral of lines from 0.05 mm on, as a post-processor rounds them, from point `first` on."""
    n = np.arange(first, count)
    radius, angle = 5 + n % SHORT * 2e-5, n * 0.01
    return np.round(np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(len(n), -1.0)]), 3)


def wandering(count: int) -> np.ndarray:
    """Return lines of some 0.4 mm in any direction."""
    return np.cumsum(np.random.default_rng(7).normal(0, 0.3, (count, 3)) * (1, 1, 0.05), axis=0)


def across(count: int) -> np.ndarray:
    """Return long lines across the table, with a whole trapezoid each."""
    return np.random.default_rng(3).uniform(-100, 100, (count, 3)) * (1, 1, 0.1)


def fastest(work: Callable[[], int]) -> tuple[int, float]:
    """Return what `work` counts, and that a second of processor time, in the fastest of AGAIN calls after one more."""
    rates = []
    for _ in range(AGAIN + 1):
        begun = time.process_time()
        count = work()
        rates.append(count / (time.process_time() - begun))
    return count, max(rates[1:])


def plan(name: str, end_mm: np.ndarray, feed_mm_min: float) -> None:
    """Print how many blocks are planned a second."""
    path = table_of(end_mm, feed_mm_min)
    segments = sum(len(piece) for piece in Run(path, MACHINE).segments())

    def work() -> int:
        for _ in Run(path, MACHINE).segments():
            pass
        return len(path)

    count, rate = fastest(work)
    print(f"planning, {name}: {count} blocks of {segments / count:.1f} segments: {rate / 1e6:.1f} million/s, ", end="")
    print(f"{rate / WANTED_BLOCKS:.1f} times what is wanted")


def count_events(pulses: PulseStream) -> int:
    """Run through a stream of pulses; returns its step events."""
    return sum(len(chunk.ticks) for chunk in pulses)


def stream(name: str, end_mm: np.ndarray, feed_mm_min: float) -> float:
    """Print how many step events are streamed a second, planning included; return how many times the closed form."""
    path = table_of(end_mm, feed_mm_min)
    count, rate = fastest(lambda: count_events(pulse_stream(path, MACHINE)))
    few = table_of(end_mm[: max(1, len(end_mm) // 50)], feed_mm_min)
    _, closed = fastest(lambda: sum(len(clocks) for clocks, _ in step_events(few, MACHINE)))
    moved = sum(moved_steps(chunk, 3) for chunk in pulse_stream(path, MACHINE))
    steps_per_mm = np.array([axis.steps_per_mm for axis in MACHINE.axes])
    assert np.array_equal(moved, np.rint(np.float32(end_mm[-1]) * np.float32(steps_per_mm)).astype(np.int64))
    print(f"steps, {name}: {count} events: {rate / 1e6:.0f} million/s, closed form {closed / 1e6:.1f}, ", end="")
    print(f"ratio {rate / closed:.0f}; {rate / WANTED_EVENTS:.1f} times what is wanted")
    return rate / closed


def new_s_curve_planner() -> Planner:
    """Return an empty planner of S-curves with a deep look-ahead."""
    limits = replace(Limits.of(MACHINE), ramp="s_curve", jerk_mm_s3=(4000.0,) * 3, look_ahead_blocks=QUEUED)
    return new_planner(limits, (0.0,) * 3)


def queue_s_curves(length_mm: float, each: bool) -> float:
    """Return the processor time in s in which QUEUED lines on one way are queued; `each`: all planned at each."""
    planner = new_s_curve_planner()
    begun = time.process_time()
    for number in range(QUEUED):
        push_line(planner, np.array([length_mm * (number + 1), 0.0, 0.0]), 50.0, False, 0)
        if each:
            plan_entries(planner)
    return time.process_time() - begun


def s_curves(length_mm: float) -> float:
    """Print how long a deep look-ahead of S-curves takes to plan; return how many times as fast as at each block."""
    queue_s_curves(1.0, True)
    taken, naive = (min(queue_s_curves(length_mm, each) for _ in range(2)) for each in (False, True))
    print(
        f"S-curves, {QUEUED} lines of {length_mm} mm queued at once: {taken:.2f} s, {QUEUED / taken:.0f} blocks/s; ",
        end="",
    )
    print(f"planned at each {naive:.2f} s, ratio {naive / taken:.0f}")
    return naive / taken


@njit
def _run_full(planner, length_mm, count, segment):
    """Queue `count` lines on one way as places of the ring fall free, and cut them all."""
    target, queued = np.zeros(3), 0
    while True:
        while queued < count and not is_full(planner):
            queued += 1
            target[0] = length_mm * queued
            push_line(planner, target, 50.0, False, queued)
        if not next_segment(planner, segment):
            return queued


def run_s_curves(length_mm: float) -> None:
    """Print how many lines a second are planned and cut while the queue is kept full, from rest to rest."""
    for count in (QUEUED, SHORT // 5):
        _, rate = fastest(lambda count=count: _run_full(new_s_curve_planner(), length_mm, count, new_segments(1, 3)[0]))
        print(f"S-curves, queue of {QUEUED} lines of {length_mm} mm kept full, {count} lines: {rate:,.0f} blocks/s")


def lines(count: int) -> Iterator[str]:
    """Yield the spiral as a program."""
    yield "G21 G90 G94 G17 F3000\n"
    for first in range(0, count, CHUNK_ROWS):
        for x, y, _ in spiral(min(count, first + CHUNK_ROWS), first).tolist():
            yield f"G1 X{x:.3f} Y{y:.3f}\n"
    yield "M2\n"


def first_pulse(file: Path) -> None:
    """Print the time from the end of reading to the first pulse; this process does nothing else before."""
    path = interpret_file(file, START)
    begun = time.perf_counter()
    chunk = next(iter(pulse_stream(path, MACHINE)))
    taken = time.perf_counter() - begun
    assert chunk.step[0]
    print(f"first pulse of {len(path)} blocks: {taken:.2f} s after they are read, kernels loaded in that time")


def memory(file: Path, play: Backlash | None = None) -> None:
    """Print what a program takes that is read, planned and stepped at once."""
    reading = FileReading(file, START)
    table, chunks = reading.interpreter.table, reading.chunks()
    path = Toolpath(START, [], table.states, table.events)
    begun = time.process_time()
    path, chunks = motor_chunks(path, chunks, play) if play else (path, chunks)
    events = count_events(pulse_stream(path, MACHINE, chunks))
    taken = time.process_time() - begun
    print(f"memory{', play taken up' * bool(play)}: {table.index} lines of text to {events} step events ", end="")
    print(f"in {taken:.1f} s, peak {peak_mb():.0f} MB")


def memory_with_play(file: Path) -> None:
    """Print the same of a machine whose axes have 0.05 mm of play."""
    memory(file, Backlash((0.05,) * 3, (-1,) * 3, tuple(axis.steps_per_mm for axis in MACHINE.axes)))


def peak_mb() -> float:
    """Return the most memory that this process has had; `getrusage` would count its parent's."""
    line = next(line for line in Path("/proc/self/status").read_text().splitlines() if line.startswith("VmHWM"))
    return int(line.split()[1]) * 1024 / 1e6


def print_growth() -> None:
    """Print and draw how processor time grows with the blocks that are planned, and planned and stepped."""
    from growth import draw_growth  # its libraries would count in the memory of other processes

    grown = {"planned, spiral": spiral, "planned, any direction": wandering, "planned and stepped, spiral": spiral}
    series: dict[str, list[float]] = {name: [] for name in grown}
    for count in GROWING:
        for name, points in grown.items():
            path = table_of(points(count), 600)
            begun = time.process_time()
            if "stepped" in name:
                count_events(pulse_stream(path, MACHINE))
            else:
                deque(Run(path, MACHINE).segments(), maxlen=0)
            series[name].append(time.process_time() - begun)
            print(f"growth, {name}: {count} blocks: {series[name][-1]:.4f} s of processor", flush=True)
    draw_growth("motion", "short lines", GROWING, series)


def guarded() -> dict[str, float]:
    """Return the ratios that `make bench-guard` compares."""
    return {
        "steps, long lines": stream("long lines", across(4000), 3000),
        "steps, short lines": stream("spiral of short lines", spiral(SHORT // 5), 600),
        "S-curves, 0.1 mm": s_curves(0.1),
        "S-curves, 0.02 mm": s_curves(0.02),
    }


def main() -> None:
    """Measure the kernels here, and the files in processes of their own."""
    plan("spiral of short lines", spiral(SHORT), 600)
    plan("short lines in any direction", wandering(SHORT // 5), 1500)
    guarded()
    for length_mm in (0.1, 0.02):
        run_s_curves(length_mm)
    print_growth()
    with tempfile.TemporaryDirectory() as name:
        for count in (SHORT, LONG):
            file = Path(name) / f"{count}.ngc"
            with file.open("w", encoding="ascii") as text:
                text.writelines(lines(count))
            for what in ("memory", "first_pulse", *["memory_with_play"] * (count == SHORT)):
                subprocess.run([sys.executable, __file__, what, str(file)], check=True)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        measured = {"memory": memory, "first_pulse": first_pulse, "memory_with_play": memory_with_play}
        measured[sys.argv[1]](Path(sys.argv[2]))
    else:
        main()
