# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper check` on programs of rising length, and on three lines: processor time and the memory of the process.

A long program's memory is compared with that of the shortest, its time with LinuxCNC's `rs274 -g` reading the same
text; a short one's with a bare Python that imports numpy and click. Another process each time: nothing is kept but the
compiled kernels.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

LENGTHS = (100_000, 1_000_000, 10_000_000)
SHORT_RUNS = 5
MACHINE = ["--machine", "table-a"]
STOCK = ["--stock", "120,120,20", "--tool", "flat:6"]
VERB = "import sys; from CNCStepper.cli.main import main; sys.argv[0] = 'cncstepper'; main()"
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


def main() -> None:
    """Print all figures."""
    with tempfile.TemporaryDirectory() as folder:
        print_long(Path(folder) / "long.ngc")
        print_short(Path(folder) / "short.nc")


def print_long(program: Path) -> None:
    """Print time and memory at each length, without and with stock."""
    for name, more in (("without stock", []), ("with stock and tool", STOCK)):
        least_mb = 0.0
        for lines in LENGTHS:
            write_program(program, lines)
            spent_s, most_mb = measured([sys.executable, "-c", VERB, "check", str(program), *MACHINE, *more])
            least_mb = least_mb or most_mb
            print(f"check: {lines} lines {name}: {spent_s:.1f} s of processor, {most_mb:.0f} MB, ", end="")
            print(
                f"{most_mb / least_mb:.2f} times the memory of {LENGTHS[0]}{beside_rs274(program, spent_s)}", flush=True
            )


def beside_rs274(program: Path, own_s: float) -> str:
    """Return how our time compares with what LinuxCNC takes only to read the program."""
    if not shutil.which("rs274"):
        return "; rs274 is not there"
    spent_s, _ = measured(["rs274", "-g", str(program)])
    return f"; rs274 reads it in {spent_s:.1f} s, ratio {own_s / spent_s:.2f}"


def print_short(program: Path) -> None:
    """Print what a verb takes that has hardly anything to do."""
    program.write_text("G21 G90\nG1 X10 F300\nG0 X0\n", encoding="ascii")
    bare_s = least_s(["-c", "import numpy, click"])
    for name, words in (("check", [str(program), *MACHINE]), ("time", [str(program), *MACHINE]), ("hold", [])):
        own_s = least_s(["-c", VERB, name, *words])
        print(f"check: {name} of three lines: {own_s:.2f} s of processor, a Python with numpy and click ", end="")
        print(f"{bare_s:.2f} s, ratio {own_s / bare_s:.1f}", flush=True)


def least_s(words: list[str]) -> float:
    """Return the least processor time of several runs of Python."""
    return min(measured([sys.executable, *words])[0] for _ in range(SHORT_RUNS))


if __name__ == "__main__":
    main()
