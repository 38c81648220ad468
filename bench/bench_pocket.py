# SPDX-License-Identifier: LGPL-2.1-or-later
"""Two pockets beside FreeCAD CAM's Pocket, in one run: time, blocks, plunges, retracts, and both cuts by one judge.

The elliptical pocket 80 × 50 × 10 and the pocket with two islands of the plate: tool 6 mm, stepover 40 %, stepdown
2 mm, offset pattern, climb. CAM's time is that of its operation less what it takes to get the faces out of the
model; its path goes as G-code through our interpreter. Processor time tells more than wall time on a busy machine.
"""

from __future__ import annotations

import json
import subprocess
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from first_call import as_new

from CNCStepper.cycles.cycle import Answer, Cycle, Removal, Setup
from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.writer.write import WriteOptions, write
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.exact.swept_area import judge
from CNCStepper.state import Start, State
from CNCStepper.toolpath import LINE, RAPID, TableBuilder, Toolpath

TOOL = Tool(number=1, shape="flat", diameter_mm=6, feed_mm_min=800, plunge_mm_min=200, spindle_rpm=12000)
CLEARANCE_MM, RETRACT_MM, STEPDOWN_MM, TIMES = 10.0, 2.0, 2.0, 7
WALL_MM = 0.005  # a third of what CAM's wall is off
OUTLINE = [(30, 25), (70, 22), (85, 40), (120, 30), (130, 60), (100, 85), (60, 70), (35, 85)]
BOSS = [(90, 50), (104, 48), (106, 62), (92, 64)]
ELLIPSE = EllipticalPocket(
    tool=1, radius_x_mm=40, radius_y_mm=25, depth_mm=10, stepdown_mm=STEPDOWN_MM, stepover_mm=2.4, tolerance_mm=WALL_MM
)
PLATE = Pocket(
    tool=1,
    outlines=(from_points(OUTLINE, closed=True),),
    islands=(circle((60, 48), 7), from_points(BOSS, closed=True)),
    depth_mm=4,
    stepdown_mm=STEPDOWN_MM,
    stepover_mm=2.4,
    tolerance_mm=WALL_MM,
)
THEIRS = """
import json, os, time
import FreeCAD, Part
from FreeCAD import Vector
import PathScripts.PathJob as PathJob
import PathScripts.PathPocketShape as PathPocketShape

def wire(points):
    return Part.makePolygon([Vector(x, y, -{depth}) for x, y in points + points[:1]])

if {plate}:
    islands = [Part.makeCircle(7, Vector(60, 48, -{depth})), wire({boss})]
    faces = [Part.Face(Part.Wire(edges.Edges)) for edges in (wire({outline}), *islands)]
    floor, block = faces[0].cut(Part.makeCompound(faces[1:])), Part.makeBox(160, 110, 8, Vector(0, 0, -8))
else:
    floor = Part.Face(Part.Wire(Part.Ellipse(Vector(0, 0, -{depth}), 40, 25).toShape()))
    block = Part.makeBox(100, 70, 20, Vector(-50, -35, -20))
document = FreeCAD.newDocument("bench")
body = document.addObject("Part::Feature", "Body")
body.Shape = block.cut(floor.extrude(Vector(0, 0, 30)))
document.recompute()
job = PathJob.Create("Job", [body], None)
job.Tools.Group[0].Tool.Diameter = 6
job.Tools.Group[0].HorizFeed, job.Tools.Group[0].VertFeed = 800 / 60, 200 / 60
pocket, model = PathPocketShape.Create("Pocket", None, job), job.Model.Group[0]
heights = [(face.BoundBox.ZMin, face.BoundBox.ZMax) for face in model.Shape.Faces]
at = [index for index, (low, high) in enumerate(heights) if abs(low + {depth}) + abs(high + {depth}) < 1e-6]
pocket.Base = [(model, "Face%d" % (at[0] + 1))]
values = dict(StartDepth=0, FinalDepth=-{depth}, StepDown={stepdown}, ClearanceHeight={clearance}, SafeHeight={retract})
for name, value in values.items():
    pocket.setExpression(name, None)
    setattr(pocket, name, value)
pocket.StepOver, pocket.OffsetPattern, pocket.CutMode = 40, "Offset", "Climb"
imported, get_shapes = [0.0, 0.0], pocket.Proxy.areaOpShapes

def timed_shapes(*given):
    begun, spent = time.perf_counter(), time.process_time()
    try:
        return get_shapes(*given)
    finally:
        imported[0] += time.perf_counter() - begun
        imported[1] += time.process_time() - spent

pocket.Proxy.areaOpShapes = timed_shapes
seconds = []
for _ in range({times}):
    imported[:] = 0.0, 0.0
    begun, spent = time.perf_counter(), time.process_time()
    pocket.Proxy.execute(pocket)
    seconds.append((time.perf_counter() - begun - imported[0], time.process_time() - spent - imported[1]))
commands = [command.toGCode() for command in pocket.Path.Commands]
json.dump({{"seconds": seconds, "commands": commands}}, open({answer!r}, "w"))
os._exit(0)
"""


@dataclass(frozen=True)
class Made:
    """One side's pocket; seconds: wall and processor time of each call, the first one first."""

    seconds: list[tuple[float, float]]
    blocks: int
    toolpath: Toolpath


def ours(operation: Cycle) -> tuple[Made, Answer]:
    """Return our pocket, its program written and read back; the times are those of the cycle alone."""
    setup, seconds = Setup(TOOL, CLEARANCE_MM, RETRACT_MM), []
    for _ in range(TIMES):
        table, new = TableBuilder(Start(), State(tool=1, spindle="cw", spindle_rpm=12000)), as_new(operation)
        begun, spent = time.perf_counter(), time.process_time()
        answer = new.cut(setup, table)
        seconds.append((time.perf_counter() - begun, time.process_time() - spent))
    text = write(table.toolpath(), dialect("grbl"), WriteOptions(units="mm", clearance_mm=CLEARANCE_MM))
    return _made(seconds, text), answer


def theirs(plate: bool, depth_mm: float) -> Made:
    """Return what FreeCAD CAM's Pocket makes of the same shape, with its feeds in mm/min."""
    with tempfile.TemporaryDirectory() as folder:
        script, answer = Path(folder) / "pocket.py", Path(folder) / "answer.json"
        given = {"plate": plate, "outline": OUTLINE, "boss": BOSS, "depth": depth_mm, "stepdown": STEPDOWN_MM}
        given |= {"clearance": CLEARANCE_MM, "retract": RETRACT_MM, "times": TIMES, "answer": str(answer)}
        script.write_text(THEIRS.format(**given), encoding="utf-8")
        subprocess.run(["freecadcmd", str(script)], capture_output=True, text=True, timeout=600, check=True)
        told = json.loads(answer.read_text("utf-8"))
    lines = [line for line in told["commands"] if not line.startswith("(")]
    return _made(told["seconds"], "\n".join(["G21 G90 G17", "T1", "M3 S12000", *map(_with_feed, lines)]) + "\n")


def _with_feed(line: str) -> str:
    """Return a command of CAM with its feed in mm/min for mm/s, and without the K that its arcs need not."""
    words = [word for word in line.split() if word[0] != "K"]
    return " ".join(f"F{float(word[1:]) * 60:.3f}" if word[0] == "F" else word for word in words)


def _made(seconds: list[tuple[float, float]], text: str) -> Made:
    path = interpret(text, Start.with_work_zero((0.0, 0.0, 0.0)), "grbl")
    return Made(seconds, len(path), path)


def motions(path: Toolpath) -> tuple[int, int, int]:
    """Return how often the tool plunges straight into material, is lifted from it, and on how many levels it cuts."""
    rows, begins = path.table(), path.begins()
    straight = np.hypot(*(rows.end - begins)[:, :2].T) < 1e-6
    plunges = straight & (rows.kind == LINE) & (rows.end[:, 2] < -1e-6) & (rows.end[:, 2] < begins[:, 2])
    retracts = (begins[:, 2] < -1e-6) & (rows.end[:, 2] > 0.0)
    level = (rows.kind != RAPID) & ~straight & (rows.end[:, 2] == begins[:, 2]) & (rows.end[:, 2] < 0.0)
    return int(plunges.sum()), int(retracts.sum()), len(np.unique(np.round(rows.end[level, 2], 4)))


def print_side(name: str, side: str, made: Made, removals: list[Removal]) -> float:
    """Print one side, and return its least processor time."""
    (first_s, _), wall_s, cpu_s = made.seconds[0], *(min(column) for column in zip(*made.seconds, strict=True))
    plunges, retracts, levels = motions(made.toolpath)
    verdict = judge(made.toolpath, TOOL, removals)
    print(f"pocket: {name}, {side}: {wall_s * 1e3:.0f} ms (processor {cpu_s * 1e3:.0f}, first call ", end="")
    print(f"{first_s * 1e3:.0f}), {made.blocks} blocks, {plunges} straight plunges, {retracts} retracts ", end="")
    print(f"on {levels} levels, gouge {verdict.gouge_mm:.4f} mm, left {verdict.left_over_mm:.4f} mm", flush=True)
    return cpu_s


def print_both(name: str, operation: Cycle, their: Callable[[], Made]) -> float:
    """Print both sides of one pocket; return how many times as fast as FreeCAD's we are, by processor time."""
    made, answer = ours(operation)
    own_s = print_side(name, "ours", made, answer.removals)
    their_s = print_side(name, "FreeCAD CAM", their(), answer.removals)
    print(f"pocket: {name}: {their_s / own_s:.1f} times as fast by processor time", flush=True)
    return their_s / own_s


def guarded() -> dict[str, float]:
    """Print both pockets; return the ratios that `make bench-guard` compares."""
    return {
        "pocket, ellipse": print_both("ellipse 80 × 50 × 10", ELLIPSE, lambda: theirs(False, ELLIPSE.depth_mm)),
        "pocket, with islands": print_both("the plate's, with islands", PLATE, lambda: theirs(True, PLATE.depth_mm)),
    }


if __name__ == "__main__":
    guarded()
