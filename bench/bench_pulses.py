# SPDX-License-Identifier: LGPL-2.1-or-later
"""The pulse generator of `cncstepper drive`: what a write costs, how fast writes are made, and how late they come.

The first two are processor time. Lateness is a matter of what else the computer does: say so beside its figures.

    python bench/bench_pulses.py [PORT]     a parallel port's device file; a recording in a temporary folder without it
"""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from CNCStepper.control.pulses.pacing import WRITES_A_PULSE, Jitter, come_first, pace, stall_ns
from CNCStepper.control.pulses.ports import Port, is_parallel_port, open_port
from CNCStepper.control.pulses.program import PulseProgram
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.machine.profile import load_machine
from CNCStepper.motion.signals.parallel_port import idle_registers
from CNCStepper.state import Start

PULSES_PER_S = (1000, 5000, 10_000, 25_000, 40_000)
WANTED_PER_S = 25_000 * WRITES_A_PULSE
MEASURED_S = 3.0
WRITES = 500_000
MACHINE = load_machine("table-a")
IDLE = idle_registers(MACHINE.signals)
KEEP_NS = 10_000
IN_OWN_PROCESS = "--here"


def cost_s(port: Port) -> float:
    """Return the processor seconds of a write that need not wait."""
    begun_s = time.process_time()
    pace(((0, *IDLE) for _ in range(WRITES)), port, 0)
    return (time.process_time() - begun_s) / WRITES


def jitter(port: Port, pulses_per_s: float) -> Jitter:
    """Return how late the writes of a steady rate were."""
    interval_ns = 1e9 / (WRITES_A_PULSE * pulses_per_s)
    count = int(MEASURED_S * 1e9 / interval_ns)
    return pace(((int(k * interval_ns), *IDLE) for k in range(count)), port, KEEP_NS)


def made_per_s() -> float:
    """Return the writes of a program that are made in a second of processor time, planned and all."""
    lines = "\n".join(f"G1 X{-(10 + k % 90)} Y{-(5 + 3 * k % 70)} F4000" for k in range(400))
    path = interpret(f"G21 G90\n{lines}\nM2\n", Start.at_zero(), "grbl", "bench.nc")
    program = PulseProgram.of(path, MACHINE, "bench.nc")
    program.pace()  # loads the kernels
    begun_s = time.process_time()
    writes = sum(map(len, program.chunks()))
    return writes / (time.process_time() - begun_s)


def measure(path: Path) -> None:
    """Print all that is measured at a port, in a process that does nothing else."""
    gc.disable()
    if is_parallel_port(path):
        come_first()
    port = open_port(path)
    cost = cost_s(port)
    most = 1 / cost
    print(f"a write costs {cost * 1e6:.2f} us: at most {most:.0f} writes/s, {most / WANTED_PER_S:.1f} times 50 000")
    print("pulses/s    kept      mean us  99 % us  worst us  a stall from us on")
    for rate in PULSES_PER_S:
        told = jitter(port, rate)
        stall_us = stall_ns(WRITES_A_PULSE * rate) / 1000
        kept = told.writes / told.taken_s / WRITES_A_PULSE
        verdict = "stall" if told.worst_us > stall_us else "kept"
        late = f"{told.mean_us:9.1f} {told.p99_us:8.0f} {told.worst_us:9.0f}"
        print(f"{rate:8d} {kept:8.0f} {late} {stall_us:9.0f}  {verdict}")
    port.write(*IDLE)
    port.close()


def main() -> None:
    """Print what is measured in this process and in the port's own."""
    per_s = made_per_s()
    print(f"writes made: {per_s / 1e6:.1f} million/s of processor time, {per_s / WANTED_PER_S:.0f} times 50 000")
    print(f"load of {os.cpu_count()} cores: {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else "", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        path = sys.argv[1] if len(sys.argv) > 1 else str(Path(folder) / "pulses")
        subprocess.run([sys.executable, __file__, IN_OWN_PROCESS, path], check=True)


if __name__ == "__main__":
    if sys.argv[1:2] == [IN_OWN_PROCESS]:
        measure(Path(sys.argv[2]))
    else:
        main()
