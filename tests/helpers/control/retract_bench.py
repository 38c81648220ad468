# SPDX-License-Identifier: LGPL-2.1-or-later
"""A sender at a virtual grbl in simulated time, a person who goes back along the cut, and the machine's own trace."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import count
from math import dist
from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.control.service.sender import Sender
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.status import Outcome
from CNCStepper.control.stream.retract_handover import read_held, write_leg
from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.wire.backlash_compensation import backlash_of
from CNCStepper.gcode.wire.encoder import prepare
from CNCStepper.job.make_certificate import send_job
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.motion.planner.arc_segments import arc_points
from CNCStepper.recovery.retract.path_retract import HeldProgram, held_program
from CNCStepper.recovery.retract.places_on_path import Place, RetractPath
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CW, Toolpath
from helpers.control.service_bench import Person, Table

STANDS = ("held", "paused", "retreated")
STEP_MM = float(np.hypot.reduce([1 / 80, 1 / 80, 1 / 400]))  # of table-a
ROUNDING_MM = 0.003  # the chords' tolerance, and the last digit
FINE_MM, COARSE_MM = 0.0005, 0.05
CORNERS_MM = 1.5  # by which the length measured may be too short; every pass is longer
NEAR_MM, TOGETHER = 0.1, 64  # within which the nearest piece of the way is looked for, and for how many points at once


def loose_table(rng: random.Random) -> Machine:
    """Return table-a with play of its axes, which is taken up in the text; each is true in one sense or the other."""
    machine = load_machine("table-a")
    axes = {
        name: axis.model_copy(
            update={"backlash_mm": round(rng.uniform(0.0, 0.25), 3), "homing": rng.choice(("min", "max"))}
        )
        for name, axis in machine.axis.items()
    }
    return machine.model_copy(update={"axis": axes})


class Tool:
    """Where the tool really is, while the motors step: each axis of it stays until a side of its gap pushes it."""

    def __init__(self, machine: Machine):
        self.at_mm = [0.0, 0.0, 0.0]
        self._gaps_mm = [(0.0, axis.backlash_mm)[:: 1 if axis.homing == "min" else -1] for axis in machine.axes]

    def follow(self, motors_mm: Sequence[float]) -> tuple[float, ...]:
        """Return where it is with the motors there."""
        for axis, (motor_mm, (behind_mm, ahead_mm)) in enumerate(zip(motors_mm, self._gaps_mm, strict=True)):
            self.at_mm[axis] = min(max(self.at_mm[axis], motor_mm - behind_mm), motor_mm + ahead_mm)
        return tuple(self.at_mm)


class Cut:
    """One job from its first line to its end; `trace` is where the tool really was."""

    def __init__(self, folder: Path, program: str, machine: Machine | None = None, by_line: bool = False, **table: Any):
        self.machine = machine or load_machine("table-a")
        self.table = Table(**table)
        self.refused: list[CNCStepperError] = []
        self.told: list[tuple[str, str]] = []
        self.phase = "connecting"
        self._folder = folder
        self._numbers = count()
        self._trace: list[tuple[float, ...]] = [(0.0, 0.0, 0.0)]
        tool = Tool(self.machine)
        self.table.board.on_step = lambda board: self._trace.append(tool.follow(board.axes.position_mm))
        wire = prepare(program, "grbl", "part ç.nc", Start.at_zero(), backlash_of(self.machine, "grbl"))
        self.job = send_job(wire, self.machine, "part ç.nc", None, "grbl")
        self.sender = Sender(
            replace(self.job, port="table", zero_confirmed=True, by_line=by_line),
            opener=lambda name, baud: self.table,
            clock=self.table.clock,
            tell=self._on_message,
            refuse=lambda command, error: self.refused.append(error),
        )

    def run(self, person: Callable[[], Person]) -> Outcome:
        """Let a person come once the job runs, and return how it ended: after all that person does."""

        def visit() -> Person:
            yield lambda: self.phase == "running"
            yield from person()

        self.table.person = visit()
        outcome = self.sender.run()
        assert next(self.table.person, None) is None, "the job has ended before the person was done"
        return outcome

    def mark(self) -> tuple[int, tuple[float, ...], tuple[float, ...]]:
        """Return how long the trace is now, where the tool is, and how far each motor stands ahead of it."""
        tool_mm = self._trace[-1]
        motors_mm = self.table.board.axes.position_mm
        return len(self._trace), tool_mm, tuple(np.subtract(motors_mm, tool_mm))

    @property
    def points(self) -> np.ndarray:
        """The points at which the tool was at each step of a motor, float64[n, 3]."""
        return np.array(self._trace)

    @property
    def trace(self) -> np.ndarray:
        """The points at which the tool was, one after another, float64[n, 3]."""
        points = np.array(self._trace)
        return points[np.r_[True, (points[1:] != points[:-1]).any(axis=1)]]

    @property
    def length_mm(self) -> float:
        """How far the tool has gone, on a scale at which their single steps do not count."""
        length_mm, kept = 0.0, self._trace[0]
        for point in self._trace:
            if (far_mm := dist(point, kept)) > COARSE_MM:
                length_mm, kept = length_mm + far_mm, point
        return length_mm

    def hold(self) -> Person:
        if self.phase not in STANDS:
            self.sender.ask(Command("hold"))
            yield lambda: self.phase in (*STANDS, "done")

    def find(self, found: list[HeldProgram]) -> Person:
        """Put into `found` what a client finds."""
        file = self._folder / f"{next(self._numbers)}.zip"
        self.sender.ask(Command("tell_place", {"file": str(file)}))
        yield file.exists
        found.append(held_program(read_held(file)))

    def go(self, leg: dict[str, Any]) -> Person:
        """Begin a leg."""
        file, before = self._folder / f"{next(self._numbers)}.zip", len(self.refused)
        write_leg(file, leg)
        self.told.clear()
        self.sender.ask(Command("retrace", {"file": str(file)}))
        yield lambda: ("phase", "running") in self.told or len(self.refused) > before

    def arrived(self) -> bool:
        return self.phase in (*STANDS, "done")

    def _on_message(self, kind: str, text: str) -> None:
        self.told.append((kind, text))
        if kind == "phase":
            self.phase = text.partition(":")[0]


def along_mm(way: RetractPath, place: Place) -> float:
    """Return how far a place lies from the begin of the way."""
    before = sum(way.move(row).length_mm for row in range(place.row))
    return before + way.move(place.row).length_mm * place.share


def path_of(program: str) -> Toolpath:
    """Return the moves of a program on a machine at its zero."""
    return interpret(program, Start.at_zero())


def polyline(path: Toolpath) -> np.ndarray:
    """Return the way of a table of moves as points, float64[n, 3]."""
    table, begins = path.table(), path.begins()
    points = [begins[:1]]
    for row in range(len(table)):
        if table.kind[row] < ARC_CW:
            points.append(table.end[row : row + 1])
        else:
            arc = table.centre[row], int(table.kind[row]), int(table.plane[row]), 1, FINE_MM
            points.append(arc_points(begins[row], table.end[row], *arc))
    return np.vstack(points)


def worst_distance_mm(points: np.ndarray, line: np.ndarray) -> float:
    """Return the largest distance of points from a polyline; infinite where all of it is far away."""
    low, high = np.minimum(line[:-1], line[1:]) - NEAR_MM, np.maximum(line[:-1], line[1:]) + NEAR_MM
    worst = 0.0
    for some in np.array_split(points, len(points) // TOGETHER + 1):
        near = ((low <= some.max(axis=0)) & (high >= some.min(axis=0))).all(axis=1)
        begin, way = line[:-1][near], np.diff(line, axis=0)[near]
        length = np.maximum((way**2).sum(axis=1), 1e-18)
        share = np.clip(((some[:, None] - begin) * way).sum(axis=2) / length, 0.0, 1.0)
        far = np.linalg.norm(some[:, None] - begin - share[..., None] * way, axis=2).min(axis=1, initial=np.inf)
        worst = max(worst, float(far.max(initial=0.0)))
    return worst
