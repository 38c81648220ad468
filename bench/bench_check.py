# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper check` on programs of rising length, and on three lines: processor time and the memory of the process.

A long program's memory is compared with that of the shortest, its time with LinuxCNC's `rs274 -g` reading the same
text; a short one's with a bare Python that imports numpy and click. Another process each time: nothing is kept but the
compiled kernels. Which of these is to be shown may be said: long raster pauses short.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

LENGTHS = (100_000, 1_000_000, 10_000_000)
RASTER_LENGTHS = (500_000, 2_000_000)
PAUSE_LENGTHS = (300_000, 3_000_000)
RASTER_ROWS = 1000
SHORT_RUNS = 5
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
    program = folder / "short.nc"
    program.write_text("G21 G90\nG1 X10 F300\nG0 X0\n", encoding="ascii")
    bare_s = least_s(["-c", "import numpy, click"])
    for name, words in (("check", [str(program), *MACHINE]), ("time", [str(program), *MACHINE]), ("hold", [])):
        own_s = least_s(["-c", VERB, name, *words])
        print(f"check: {name} of three lines: {own_s:.2f} s of processor, a Python with numpy and click ", end="")
        print(f"{bare_s:.2f} s, ratio {own_s / bare_s:.1f}", flush=True)


def least_s(words: list[str]) -> float:
    """Return the least processor time of several runs of Python."""
    return min(measured([sys.executable, *words])[0] for _ in range(SHORT_RUNS))


SHOWN = {"long": print_long, "raster": print_raster, "pauses": print_pauses, "short": print_short}

if __name__ == "__main__":
    main([word for word in sys.argv[1:] if word in SHOWN])
