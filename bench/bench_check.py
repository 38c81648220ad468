# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper check` on programs of rising length, and on three lines: processor time and the memory of the process.

A long program's memory is compared with that of the shortest, its time with LinuxCNC's `rs274 -g` reading the same
text; a short one's with a bare Python that imports numpy and click. Another process each time: nothing is kept but the
compiled kernels. Which of these is to be shown may be said: long raster pauses short growth.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

from growth import draw_growth

LENGTHS = (100_000, 1_000_000, 10_000_000)
GROWING = tuple(10**power for power in range(3, 8))
RASTER_LENGTHS = (500_000, 2_000_000)
PAUSE_LENGTHS = (300_000, 3_000_000)
RASTER_ROWS = 1000
SHORT_RUNS = 10
SHORT = {"check": True, "time": True, "hold": False, "stop": False}  # verbs, and whether they take a program
MACHINE = ["--machine", "table-a"]
STOCK = ["--stock", "120,120,20", "--tool", "flat:6"]
VERB = "import sys; from CNCStepper.cli.main import main; sys.argv[0] = 'cncstepper'; main()"
JOB = """
units = "mm"
machine = "table-a"
clearance_mm = 10
retract_mm = 2
stock = { size_mm = [220, 160, 20], origin = "top-left-front" }

[[tool]]
number = 1
shape = "flat"
diameter_mm = 6.0
feed_mm_min = 900
plunge_mm_min = 200
spindle_rpm = 12000

[[operation]]
cycle = "rectangular_pocket"
tool = 1
corner_a_mm = [7, 7]
corner_b_mm = [213, 153]
depth_mm = 1
stepdown_mm = 1
stepover_mm = 2.6
"""
MEASURED = """
import resource, subprocess, sys
subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime, used.ru_maxrss / 1024)
"""


def measured(words: list[str]) -> tuple[float, float]:
    """Return the processor time in s and the greatest memory in MB of a command."""
    output = subprocess.run([sys.executable, "-c", MEASURED, *words], capture_output=True, text=True, check=True)
    spent_s, most_mb = map(float, output.stdout.split())
    return spent_s, most_mb


def write_program(path: Path, lines: int) -> None:
    """Write a program of short moves in all directions."""
    with path.open("w", encoding="ascii") as file:
        file.write("G21 G90 G17\nG0 Z5\nG0 X0 Y0\nM3 S10000\nG4 P3\nG1 Z-1 F600\n")
        file.writelines(f"G1 X{index % 97 * 0.5:.3f} Y{index % 89 * 0.5:.3f}\n" for index in range(lines))
        file.write("G0 Z5\nM5\nM2\n")


def write_raster(path: Path, lines: int) -> None:
    """Write the rows of the job's pocket, each in short moves."""
    row_lines = lines // RASTER_ROWS
    xs_mm = [10 + 200 * index / (row_lines - 1) for index in range(row_lines)]
    with path.open("w", encoding="ascii") as file:
        file.write("G21 G90 G17 G54\nT1\nM3 S12000\nG4 P3\nG0 Z10\nG0 X10 Y10\nG1 Z-1 F200\nF900\n")
        for row in range(RASTER_ROWS):
            y_mm = 10 + row * 140 / (RASTER_ROWS - 1)
            file.writelines(f"G1 X{x_mm:.3f} Y{y_mm:.3f}\n" for x_mm in xs_mm[:: -1 if row % 2 else 1])
        file.write("G0 Z10\nM5\nM2\n")


def write_pauses(path: Path, lines: int) -> None:
    """Write a program of dwells, stops and messages by turns, without a move."""
    with path.open("w", encoding="ascii") as file:
        file.write("G21 G90\n")
        file.writelines(("G4 P0.1\n", "M0\n", f"(MSG, look {index})\n")[index % 3] for index in range(lines))
        file.write("M2\n")


def main(shown: list[str]) -> None:
    """Print all figures, or those that were named."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for what in shown or SHOWN:
            SHOWN[what](folder)


def print_long(folder: Path) -> None:
    """Print time and memory at each length, without and with stock."""
    for name, more in (("without stock", []), ("with stock and tool", STOCK)):
        print_lengths(name, folder / "long.ngc", write_program, LENGTHS, more, beside_rs274)


def print_growth(folder: Path) -> None:
    """Print and draw how time grows with the program's length, with stock and tool, and memory with it."""
    program, points = folder / "growing.nc", list[tuple[int, float, float]]()
    for lines in GROWING:
        write_program(program, lines)
        points.append((lines, *measured([sys.executable, "-c", VERB, "check", str(program), *MACHINE, *STOCK])))
        print(f"check: {lines} lines with stock and tool: {points[-1][1]:.2f} s of processor, ", end="")
        print(f"{points[-1][2]:.0f} MB", flush=True)
    lengths, spent_s, _ = zip(*points, strict=True)
    draw_growth("check-with-stock", "lines of `cncstepper check` with stock and tool", lengths, {"check": spent_s})


def print_raster(folder: Path) -> None:
    """Print time and memory of programs that are checked against a job."""
    job = folder / "job.toml"
    job.write_text(JOB, encoding="ascii")
    print_lengths("of a raster with --job", folder / "raster.nc", write_raster, RASTER_LENGTHS, ["--job", str(job)])


def print_pauses(folder: Path) -> None:
    """Print time and memory of programs that stand still, without and with a certificate."""
    certificate = ["--certificate", str(folder / "certificate.zip"), "--overwrite"]
    for name, more in (("of G4, M0 and (MSG)", []), ("of G4, M0 and (MSG) with --certificate", certificate)):
        print_lengths(name, folder / "pauses.nc", write_pauses, PAUSE_LENGTHS, more)


def print_lengths(
    name: str,
    program: Path,
    write: Callable[[Path, int], None],
    lengths: Sequence[int],
    more: list[str],
    beside: Callable[[Path, float], str] = lambda program, spent_s: "",
) -> None:
    """Print time and memory of `check` at each length; the kernels are compiled before."""
    words = [sys.executable, "-c", VERB, "check", str(program), *MACHINE, *more]
    write(program, lengths[0] // 10)
    measured(words)
    least_mb = 0.0
    for lines in lengths:
        write(program, lines)
        spent_s, most_mb = measured(words)
        least_mb = least_mb or most_mb
        print(f"check: {lines} lines {name}: {spent_s:.1f} s of processor, {most_mb:.0f} MB, ", end="")
        print(f"{most_mb / least_mb:.2f} times the memory of {lengths[0]}{beside(program, spent_s)}", flush=True)


def beside_rs274(program: Path, own_s: float) -> str:
    """Return how our time compares with what LinuxCNC takes only to read the program."""
    if not shutil.which("rs274"):
        return "; rs274 is not there"
    spent_s, _ = measured(["rs274", "-g", str(program)])
    return f"; rs274 reads it in {spent_s:.1f} s, ratio {own_s / spent_s:.2f}"


def print_short(folder: Path) -> None:
    """Print what a verb takes that has hardly anything to do."""
    bare_s, *verbs_s = short_s(folder)
    for name, own_s in zip(SHORT, verbs_s, strict=True):
        print(f"check: {name} of three lines: {own_s:.2f} s of processor, a Python with numpy and click ", end="")
        print(f"{bare_s:.2f} s, ratio {own_s / bare_s:.1f}", flush=True)


def short_s(folder: Path) -> list[float]:
    """Return the least processor time, of runs by turns, of a bare Python and of each verb of SHORT on three lines."""
    program = folder / "short.nc"
    program.write_text("G21 G90\nG1 X10 F300\nG0 X0\n", encoding="ascii")
    verbs = [
        ["-c", VERB, name, *([str(program), *MACHINE] if on_program else [])] for name, on_program in SHORT.items()
    ]
    sides = [["-c", "import numpy, click"], *verbs]
    runs = [[measured([sys.executable, *words])[0] for words in sides] for _ in range(SHORT_RUNS)]
    return [min(side) for side in zip(*runs, strict=True)]


def guarded() -> dict[str, float]:
    """Return how quickly verbs start beside a bare Python with numpy and click."""
    with tempfile.TemporaryDirectory() as folder:
        bare_s, *verbs_s = short_s(Path(folder))
    return {f"start, {name}": bare_s / own_s for name, own_s in zip(SHORT, verbs_s, strict=True)}


os.environ.pop("PYTHONDONTWRITEBYTECODE", None)  # an installed program's modules are compiled
SHOWN = {
    "long": print_long,
    "raster": print_raster,
    "pauses": print_pauses,
    "short": print_short,
    "growth": print_growth,
}

if __name__ == "__main__":
    main([word for word in sys.argv[1:] if word in SHOWN])
