# SPDX-License-Identifier: LGPL-2.1-or-later
"""Blocks a second of processor time: our interpreter beside LinuxCNC's `rs274 -g`, same programs, same run.

Beside it `cncstepper trace`, which prints the same calls, as a process of its own. Then a file of ten times the blocks,
read in processes of their own: how much memory a block takes, whole and as a stream, with progress and cancel.
`python bench/bench_interpreter.py` prints the lines of docs/benchmarks.md.
"""

from __future__ import annotations

import math
import resource
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

BLOCKS = 1_000_000
LARGE = 10_000_000
GROWING = (1000, 10_000, 100_000, 1_000_000, LARGE)
AGAIN = 3  # warm calls, of which the fastest counts


def lines(count: int) -> Iterator[str]:
    """Yield a spiral of short lines."""
    yield from ("G21 G90 G17", "G0 Z2", "G1 Z-1 F600")
    for n in range(count):
        radius, angle = 5 + n * 2e-5, n * 0.01
        yield f"G1 X{radius * math.cos(angle):.3f} Y{radius * math.sin(angle):.3f}"
    yield "M2"


def arcs(count: int) -> Iterator[str]:
    """Yield half circles to and fro, by centre and by radius."""
    yield from ("G21 G90 G17", "G0 X0 Y0 Z2", "G1 Z-1 F600")
    for n in range(count // 2):
        radius = 5 + n % 1000 * 0.001
        yield f"G2 X{2 * radius:.3f} Y0 I{radius:.3f} J0"
        yield f"G3 X0 Y0 R{radius:.3f}"
    yield "M2"


def numbered(count: int) -> Iterator[str]:
    """Yield the spiral with N and F words on every line, the feed another one each time."""
    yield from ("N1 G21 G90 G17", "N2 G0 Z2", "N3 G1 Z-1 F600")
    for n in range(count):
        radius, angle = 5 + n * 2e-5, n * 0.01
        yield f"N{n + 4} G1 X{radius * math.cos(angle):.3f} Y{radius * math.sin(angle):.3f} F{600 + n % 97}"
    yield "M2"


def write(path: Path, program: Iterator[str]) -> None:
    """Write a program to a file, line by line."""
    with path.open("w", encoding="ascii") as file:
        file.writelines(f"{line}\n" for line in program)


def ours_s(text: str) -> float:
    """Return the seconds of processor time that our interpreter takes."""
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.state import Start

    begun = time.process_time()
    path = interpret(text, Start.at_zero(), "linuxcnc")
    taken = time.process_time() - begun
    assert len(path) >= BLOCKS
    return taken


def process_s(*command: str) -> float:
    """Return the seconds of processor time that a program takes, its start included."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def compare(folder: Path) -> dict[str, float]:
    """Print both sides for each kind of program; return how many times as fast as LinuxCNC's we are."""
    first, ratios = 0.0, {}
    for program in (lines, arcs, numbered):
        path = folder / f"{program.__name__}.ngc"
        write(path, program(BLOCKS))
        text = path.read_text("ascii")
        first = first or ours_s(text)
        ours, theirs = min(ours_s(text) for _ in range(AGAIN)), process_s("rs274", "-g", str(path), "/dev/null")
        print(f"interpreter, {program.__name__}: {BLOCKS} blocks: ours {BLOCKS / ours / 1e6:.2f} million/s, ", end="")
        print(f"rs274 {BLOCKS / theirs / 1e6:.3f} million/s, ratio {theirs / ours:.1f}")
        traced = process_s(sys.executable, "-m", "CNCStepper.cli", "trace", str(path))
        print(f"trace, {program.__name__}: {BLOCKS} blocks: cncstepper {traced:.2f} s, rs274 {theirs:.2f} s, ", end="")
        print(f"starts included, ratio {theirs / traced:.1f}")
        ratios |= {f"interpreter, {program.__name__}": theirs / ours, f"trace, {program.__name__}": theirs / traced}
    print(f"interpreter, first call of the process: {BLOCKS / first / 1e6:.2f} million/s")
    return ratios


def print_growth(folder: Path) -> None:
    """Print and draw how processor time grows with the blocks, with the start of a process for each verb."""
    from growth import draw_growth  # its libraries would count in the memory of other processes

    series: dict[str, list[float]] = {"cncstepper trace": [], "rs274 -g": []}
    for count in GROWING:
        path = folder / "growing.ngc"
        write(path, lines(count))
        words = ((sys.executable, "-m", "CNCStepper.cli", "trace", str(path)), ("rs274", "-g", str(path), "/dev/null"))
        for name, command in zip(series, words, strict=True):
            series[name].append(process_s(*command))
            print(f"growth, {name}: {count} blocks: {series[name][-1]:.3f} s of processor", flush=True)
    draw_growth("trace", "blocks of short lines, starts included", GROWING, series)


def guarded() -> dict[str, float]:
    """Return the ratios that `make bench-guard` compares."""
    with tempfile.TemporaryDirectory() as name:
        return compare(Path(name))


def large(path: Path, how: str) -> None:
    """Print time and memory of a large file, which is the only thing that this process reads."""
    from CNCStepper.errors import ProgramError
    from CNCStepper.gcode.interpreter.program_file import FileReading, interpret_file
    from CNCStepper.state import Start

    start, shares, begun = Start.at_zero(), [0.0], time.process_time()
    if how == "cancelled":
        try:
            interpret_file(path, start, "linuxcnc", progress=shares.append, cancelled=lambda: shares[-1] > 0.5)
        except ProgramError as error:
            print(f"interpreter, file: [{error.code}] at {shares[-1]:.0%}, {time.process_time() - begun:.2f} s")
        return
    if how == "stream":
        rows = sum(len(chunk) for chunk in FileReading(path, start, "linuxcnc", progress=shares.append).chunks())
    else:
        rows = len(interpret_file(path, start, "linuxcnc", progress=shares.append))
    taken, peak = time.process_time() - begun, resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    print(f"interpreter, file {how}: {rows} blocks, {rows / taken / 1e6:.2f} million/s, ", end="")
    print(f"{len(shares)} reports, peak of the process {peak / 1e6:.0f} MB, {peak / rows:.0f} bytes a block")


def main() -> None:
    """Compare, then measure the large file in a process of its own."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        compare(folder)
        print_growth(folder)
        write(folder / "large.ngc", lines(LARGE))
        for how in ("stream", "whole", "cancelled"):
            subprocess.run([sys.executable, __file__, str(folder / "large.ngc"), how], check=True)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        large(Path(sys.argv[1]), sys.argv[2])
    else:
        main()
