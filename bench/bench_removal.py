# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material removal: moves a second beside FreeCAD's PathSimulator (C++), on the same moves and cells in one run."""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

from CNCStepper.machine.tool import Tool
from CNCStepper.simulation.form import form_of
from CNCStepper.simulation.heightmap import height_map
from CNCStepper.simulation.removal_moves import Moves
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tiles import Grid, Part
from CNCStepper.simulation.timeline import Timeline

CELL_MM, STEP_MM, DEPTH_MM = 0.1, 0.25, 2.0
THEIRS = """
import json, sys, time
import FreeCAD, Part, Path, PathSimulator
points, size = json.load(open({points!r})), {size}
stock = Part.makeBox(size, size, 6, FreeCAD.Vector(-size / 2, -size / 2, -6))
simulator = PathSimulator.PathSim()
simulator.BeginSimulation(stock, {cell})
simulator.SetToolShape(Part.makeCylinder(3, 30), {cell})
place = FreeCAD.Placement(FreeCAD.Vector(*points[0]), FreeCAD.Rotation())
commands = [Path.Command("G1", dict(zip("XYZ", point))) for point in points[1:]]
begun, cpu = time.perf_counter(), time.process_time()
for command in commands:
    place = simulator.ApplyCommand(place, command)
print("SECONDS", time.perf_counter() - begun, time.process_time() - cpu)
sys.exit(0)
"""


def spiral(moves: int, size_mm: float) -> np.ndarray:
    """Return the ends of short level moves that fill a disc in a square sheet."""
    length, radius = moves * STEP_MM, size_mm / 2 - 4
    pitch = np.pi * radius**2 / length
    angle = np.sqrt(np.arange(moves + 1) * STEP_MM * 4 * np.pi / pitch)
    out = pitch * angle / (2 * np.pi)
    return np.column_stack([out * np.cos(angle), out * np.sin(angle), np.full(moves + 1, -DEPTH_MM)])


def hilly(points: np.ndarray) -> np.ndarray:
    """Return the same moves over a hilly ground, every one a ramp."""
    return np.column_stack([points[:, :2], -3 + np.sin(points[:, 0] / 9) * np.cos(points[:, 1] / 11)])


def ours(points: np.ndarray, size_mm: float, tool: Tool) -> tuple[float, float, Part]:
    """Return wall and processor seconds of our removal, and the part."""
    moves = Moves.lines(points[:-1], points[1:], form_of(tool))
    begun, cpu = time.perf_counter(), time.process_time()
    part = Part(Grid.of(Stock((size_mm, size_mm, 6)), CELL_MM)).after(moves)
    return time.perf_counter() - begun, time.process_time() - cpu, part


def theirs(points: np.ndarray, size_mm: float) -> tuple[float, float]:
    """Return wall and processor seconds that PathSimulator takes for the moves alone."""
    with tempfile.TemporaryDirectory() as folder:
        places, script = Path(folder) / "points.json", Path(folder) / "simulate.py"
        places.write_text(json.dumps(points.tolist()), encoding="utf-8")
        script.write_text(THEIRS.format(points=str(places), size=size_mm, cell=CELL_MM), encoding="utf-8")
        told = subprocess.run(["freecadcmd", str(script)], capture_output=True, text=True, timeout=600).stdout
    wall_s, cpu_s = told.split("SECONDS")[1].split()[:2]
    return float(wall_s), float(cpu_s)


def slider_ms(path: Path) -> tuple[int, float, float, float]:
    """Return a job's moves, and the seconds to prepare and the median and worst ms of its timeline."""
    from CNCStepper.gcode.interpret import interpret
    from CNCStepper.job.make import make_program
    from CNCStepper.job.model import load_job
    from CNCStepper.motion.plan import times_s
    from CNCStepper.state import Start

    job, machine = load_job(path)
    start = Start.with_work_zero((0.0, 0.0, 0.0))
    toolpath = interpret(make_program(job, machine).program, start, machine.controller)
    ends_s = np.maximum.accumulate(np.nan_to_num(times_s(toolpath, machine)))
    height_map(toolpath, job.tools, job.stock.stock())
    begun = time.perf_counter()
    timeline = Timeline(toolpath, ends_s, job.tools, job.stock.stock())
    prepared_s = time.perf_counter() - begun
    return len(toolpath), prepared_s, *answers_ms(timeline)


def answers_ms(timeline: Timeline) -> tuple[float, float]:
    """Return the median and the worst time of an answer at random times, heights of all cells included."""
    taken = []
    for time_s in np.random.default_rng(5).uniform(0, timeline.duration_s, 40):
        begun = time.perf_counter()
        assert timeline.at(float(time_s)).heights_mm.size
        taken.append((time.perf_counter() - begun) * 1000)
    return float(np.median(taken)), max(taken)


def main() -> None:
    """Print both sides and their ratio, the million moves, and what a slider waits."""
    flat, ball = (Tool(number=1, shape=shape, diameter_mm=6) for shape in ("flat", "ball"))
    for tool in (flat, ball):
        for points in (spiral(2000, 40), hilly(spiral(2000, 40))):
            ours(points, 40, tool)  # compiles
    points = spiral(100_000, 100)
    if shutil.which("freecadcmd"):
        count = len(points) - 1
        for name, own, their in zip(
            ("wall", "processor"), ours(points, 100, flat)[:2], theirs(points, 100), strict=True
        ):
            print(f"removal: {count} short moves, flat 6 mm, {CELL_MM} mm cells, {name} time: ours ", end="")
            print(f"{count / own:,.0f}/s, PathSimulator {count / their:,.0f}/s, ratio {their / own:.1f}")
    for name, tool, million in (
        ("flat, level", flat, spiral(1_000_000, 300)),
        ("ball, level", ball, spiral(1_000_000, 300)),
        ("ball, hilly", ball, hilly(spiral(1_000_000, 300))),
    ):
        wall_s, cpu_s, part = ours(million, 300, tool)
        held = sum(tile.nbytes for tile in part.tiles.values()) / 1e6
        print(f"removal: 1 000 000 moves, 300 × 300 mm, {name}: {wall_s:.2f} s, processor {cpu_s:.2f} s, {held:.0f} MB")
    for path in sorted((Path(__file__).parents[1] / "examples" / "jobs").glob("*.toml")):
        count, prepared_s, median, worst = slider_ms(path)
        print(
            f"timeline: {path.stem}, {count} moves: ready in {prepared_s:.2f} s, {median:.1f} ms, worst {worst:.1f} ms"
        )


if __name__ == "__main__":
    main()
