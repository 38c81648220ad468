# SPDX-License-Identifier: LGPL-2.1-or-later
"""Material removal: moves a second beside FreeCAD's PathSimulator (C++), on the same moves and cells in one run.

Where the machine has other work, processor time (all threads) tells more than wall time: both are printed.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np
from growth import draw_growth

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.simulation.cutter_solid import Tools
from CNCStepper.simulation.removal.engagement import engagement
from CNCStepper.simulation.removal.heightmap import Grid, Part
from CNCStepper.simulation.removal.removal_moves import Moves
from CNCStepper.simulation.removal.timeline import Timeline
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder, Toolpath

CELL_MM, STEP_MM, DEPTH_MM = 0.1, 0.25, 2.0
GROWING = (1000, 10_000, 100_000, 1_000_000, 4_000_000)
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


def of_job(path: Path) -> tuple[Toolpath, np.ndarray, Tools, Stock, float]:
    """Return what a timeline of a job is made from."""
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.job.make import make_program
    from CNCStepper.job.model import load_job
    from CNCStepper.motion.planner.plan import times_s

    job, machine = load_job(path)
    start = Start.with_work_zero((0.0, 0.0, 0.0))
    toolpath = interpret(make_program(job, machine).program, start, machine.controller)
    ends_s = np.maximum.accumulate(np.nan_to_num(times_s(toolpath, machine)))
    return toolpath, ends_s, job.tools, job.stock.stock(), 0.0


def answers_ms(timeline: Timeline) -> tuple[float, ...]:
    """Return the median and the worst wall ms, then processor ms, of an answer at random times."""
    wall, cpu = [], []
    for time_s in np.random.default_rng(5).uniform(0, timeline.duration_s, 40):
        begun, spent = time.perf_counter(), time.process_time()
        assert timeline.at(float(time_s)).part.tiles is not None
        wall.append((time.perf_counter() - begun) * 1000)
        cpu.append((time.process_time() - spent) * 1000)
    return float(np.median(wall)), max(wall), float(np.median(cpu)), max(cpu)


def tables(points: np.ndarray) -> Toolpath:
    """Return the moves as a program of straight feeds."""
    table = TableBuilder(Start.at_zero(), State(tool=1, spindle="cw"))
    for point in points.tolist():
        table.feed(point, 600)
    return table.toolpath()


def print_timeline(name: str, toolpath: Toolpath, ends_s: np.ndarray, tools: Tools, stock: Stock, cell: float) -> None:
    """Print how soon a timeline is ready, what it holds and how long an answer takes."""
    begun, spent = time.perf_counter(), time.process_time()
    timeline = Timeline(toolpath, ends_s, tools, stock, cell)
    ready_s, cpu_s = time.perf_counter() - begun, time.process_time() - spent
    median, worst, cpu_median, cpu_worst = answers_ms(timeline)
    print(f"timeline: {name}, {len(toolpath)} moves: ready in {ready_s:.2f} s (processor {cpu_s:.2f}), ", end="")
    print(f"{len(timeline.parts)} check-points, {timeline.bytes_held / 1e6:.0f} MB, median {median:.1f} ms ", end="")
    print(f"(processor {cpu_median:.1f}), worst {worst:.1f} ms ({cpu_worst:.1f})", flush=True)


def print_timeline_growth(tool: Tool) -> None:
    """Print and draw how soon a timeline is ready, and how long an answer takes, over the number of moves."""
    series: dict[str, list[float]] = {"ready": [], "an answer, median": []}
    for count in GROWING:
        toolpath, ends_s = tables(spiral(count, 300)), np.arange(count + 1) * 0.01
        spent = time.process_time()
        timeline = Timeline(toolpath, ends_s, tool, Stock((300, 300, 6)), CELL_MM)
        series["ready"].append(time.process_time() - spent)
        series["an answer, median"].append(answers_ms(timeline)[2] / 1000)
        told = ", ".join(f"{name} {spent_s[-1]:.4f} s" for name, spent_s in series.items())
        print(f"timeline: {count} level moves, {tool.shape}: processor {told}", flush=True)
    draw_growth("timeline", "short level moves of a flat tool, 0.1 mm cells", GROWING, series)


def print_engagement(tool: Tool) -> None:
    """Print how long the map of what the tool meets takes."""
    toolpath, stock = tables(spiral(100_000, 100)), Stock((100, 100, 6))
    engagement(tables(spiral(500, 100)), tool, stock)
    begun, spent = time.perf_counter(), time.process_time()
    met = engagement(toolpath, tool, stock)
    wall_s, cpu_s = time.perf_counter() - begun, time.process_time() - spent
    print(f"engagement: {len(met.row)} places, {tool.shape}: {wall_s:.2f} s, processor {cpu_s:.2f} s")


def print_both_sides(points: np.ndarray, tool: Tool) -> dict[str, float]:
    """Print moves a second of both simulators; return how many times as fast ours is by processor time."""
    count, sides = len(points) - 1, (ours(points, 100, tool)[:2], theirs(points, 100))
    for name, own, their in zip(("wall", "processor"), *sides, strict=True):
        print(f"removal: {count} short moves, flat 6 mm, {CELL_MM} mm cells, {name} time: ours ", end="")
        print(f"{count / own:,.0f}/s, PathSimulator {count / their:,.0f}/s, ratio {their / own:.1f}", flush=True)
    return {"removal, short level moves": sides[1][1] / sides[0][1]}


def guarded() -> dict[str, float]:
    """Return the ratios that `make bench-guard` compares."""
    flat = Tool(number=1, shape="flat", diameter_mm=6)
    ours(spiral(2000, 40), 40, flat)  # compiles
    return print_both_sides(spiral(100_000, 100), flat)


def print_growth(tool: Tool) -> None:
    """Print and draw how processor time grows with the number of level moves and of ramps, 300 × 300 mm."""
    series: dict[str, list[float]] = {"level": [], "every move a ramp": []}
    for count in GROWING:
        points = spiral(count, 300)
        for name, ends in zip(series, (points, hilly(points)), strict=True):
            series[name].append(ours(ends, 300, tool)[1])
            print(f"removal: {count} moves, {tool.shape}, {name}: processor {series[name][-1]:.3f} s", flush=True)
    draw_growth("removal", "short moves of a flat tool, 0.1 mm cells", GROWING, series)


def main() -> None:
    """Print both sides and their ratio, the million moves, and what a slider waits."""
    tools = [
        Tool(number=1, shape="flat", diameter_mm=6),
        Tool(number=1, shape="ball", diameter_mm=6),
        Tool(number=1, shape="bullnose", diameter_mm=6, corner_radius_mm=1),
        Tool(number=1, shape="v", diameter_mm=6, tip_angle_deg=90),
    ]
    for tool in tools:
        for points in (spiral(2000, 40), hilly(spiral(2000, 40))):
            ours(points, 40, tool)  # compiles
    if shutil.which("freecadcmd"):
        guarded()
    print_growth(tools[0])
    print_timeline_growth(tools[0])
    level = spiral(1_000_000, 300)
    for tool in tools:
        for name, million in (("level", level), ("every move a ramp", hilly(level))):
            wall_s, cpu_s, part = ours(million, 300, tool)
            held = sum(tile.nbytes for tile in part.tiles.values()) / 1e6
            print(f"removal: 1 000 000 moves, 300 × 300 mm, {tool.shape}, {name}: {wall_s:.2f} s, ", end="")
            print(f"processor {cpu_s:.2f} s, {held:.0f} MB", flush=True)
    million, ends_s = tables(level), np.arange(len(level)) * 0.01
    for tool in tools[:2]:
        print_timeline(f"a million level moves, {tool.shape}", million, ends_s, tool, Stock((300, 300, 6)), CELL_MM)
    for path in sorted((Path(__file__).parents[1] / "examples" / "jobs").glob("*.toml")):
        if path.stem.startswith("lathe-"):
            continue
        print_timeline(path.stem, *of_job(path))
    print_engagement(tools[0])


if __name__ == "__main__":
    main()
