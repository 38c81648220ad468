# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a person waits for the first picture: of a command line, of a million moves, of the workbench's proof."""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from bench_removal import spiral

from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.gcode.wire.read_back import read_back
from CNCStepper.job.make import make_program
from CNCStepper.job.model import load_job
from CNCStepper.job.proof_folder import write_question
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.views.quick_picture import save_first_picture

POCKET = Path(__file__).parents[1] / "examples" / "jobs" / "elliptical-pocket.toml"
RUNS = 5
MOVES, SHEET_MM = 1_000_000, 300.0
TOLD = """
import sys, time
from CNCStepper.cli.main import main
from CNCStepper.simulation.views import quick_picture
save = quick_picture.save_first_picture
def told(*what):
    save(*what)
    print("PICTURE", time.time(), time.process_time())
quick_picture.save_first_picture = told
main()
"""


def command_line(folder: Path) -> tuple[list[float], list[float]]:
    """Return wall and processor seconds from the start of `cncstepper simulate` until the first picture is a file."""
    job, machine = load_job(POCKET)
    program = folder / "program.nc"
    program.write_text(make_program(job, machine).program, encoding="ascii")
    line = [sys.executable, "-c", TOLD, "simulate", str(program), "--job", str(POCKET), "--out", str(folder / "p.png")]
    wall, cpu = [], []
    for _ in range(RUNS + 1):
        begun = time.time()
        said = subprocess.run(line, capture_output=True, text=True, check=True).stdout
        at, used = said.split("PICTURE ")[1].split()[:2]
        wall.append(float(at) - begun)
        cpu.append(float(used))
    return wall[1:], cpu[1:]  # the first compiles


def million(folder: Path) -> tuple[float, float]:
    """Return wall and processor seconds from a million moves that are read to the picture of their part."""
    points = spiral(MOVES, SHEET_MM)
    lines = ["G21 G90", "T1", "M3 S10000", "G0 Z5", "G0 X{:.3f} Y{:.3f}".format(*points[0]), "G1 Z-2 F1000"]
    lines += [f"X{x:.3f} Y{y:.3f}" for x, y, _ in points[1:].tolist()]
    text = "\n".join([*lines, "G0 Z5", "M2", ""])
    toolpath = read_back(prepare(text, "grbl"), text, None, "grbl")
    tool, stock = Tool(number=1, shape="flat", diameter_mm=6), Stock((SHEET_MM, SHEET_MM, 6))
    height_map(toolpath, tool, stock, SHEET_MM)  # loads the kernels
    begun, cpu = time.perf_counter(), time.process_time()
    save_first_picture(folder / "million.png", height_map(toolpath, tool, stock))
    return time.perf_counter() - begun, time.process_time() - cpu


def proof_stages(folder: Path, ready: str) -> dict[str, float]:
    """Return when each stage of the workbench's proof of the pocket begins, and its end, in wall seconds: medians.

    ready: what the process prints before it is asked; "" for one that is started for the question.
    """
    job, machine = load_job(POCKET)
    program = make_program(job, machine).program
    seen: dict[str, list[float]] = {}
    for run in range(RUNS):
        asked = folder / f"proof {run} {ready}"
        asked.mkdir()
        write_question(asked, program, job, machine)
        begun = time.perf_counter()
        line = [sys.executable, "-m", "CNCStepper.workers.proof"]
        with subprocess.Popen(line, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdin and process.stdout
            if ready:
                assert process.stdout.readline().strip() == ready
                begun = time.perf_counter()
            process.stdin.write(json.dumps([str(asked), "pocket.nc"]) + "\n")
            process.stdin.flush()
            for stage in process.stdout:
                seen.setdefault(stage.strip(), []).append(time.perf_counter() - begun)
            process.wait()
        seen.setdefault("answered", []).append(time.perf_counter() - begun)
    return {stage: statistics.median(times) for stage, times in seen.items()}


def main() -> None:
    """Print the three waits."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        wall, cpu = command_line(folder)
        print(
            f"first picture of the pocket, from the start of the command: {statistics.median(wall):.2f} s, ",
            end="",
        )
        print(f"{statistics.median(cpu):.2f} s of processor time (least {min(cpu):.2f})")
        wall_s, cpu_s = million(folder)
        print(f"first picture of {MOVES} moves that are read, kernels loaded: {wall_s:.2f} s, processor {cpu_s:.2f} s")
        for process, ready in (("started for it", ""), ("that has waited", "ready")):
            stages = ", ".join(f"{stage} {at_s:.2f}" for stage, at_s in proof_stages(folder, ready).items())
            print(f"the workbench's proof of the pocket by a process {process}, begin of each stage in s: {stages}")


if __name__ == "__main__":
    main()
