# SPDX-License-Identifier: LGPL-2.1-or-later
"""Orders of squares and rings for the laser, which are made in a moment, and workers in this process."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from pathlib import Path

from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.job.batch.batch_task import run_task
from CNCStepper.job.batch.local_workers import Result, Task

TEMPLATE = """
machine = "machine.toml"
process = "laser"
material = "plywood"
clearance_mm = 5
retract_mm = 1

[stock]
form = "sheet"
thickness_mm = 3
margin_mm = 3
origin = "{origin}"

[[rule]]
title = "cut"
operation = {{ cycle = "sheet_cut" }}
"""
RATES = """
[rates]
currency = "EUR"
per_hour = 60
per_metre = 0.5
per_pierce = 0.1
per_sheet = 2
per_square_metre = { plywood = 20 }
"""
HEAD = "drawing,template,material,thickness_mm,count\n"
RED = Attributes(layer="CUT", colour="#ff0000")


def write_order(folder: Path, rows: Sequence[str], origin: str = "top-left-front") -> Path:
    """Write an order with these rows, its template, its machine with rates, and a square and a ring."""
    from CNCStepper.machine.files.profile_files import shipped_file

    folder.mkdir(parents=True, exist_ok=True)
    (folder / "laser.toml").write_text(TEMPLATE.format(origin=origin), "utf-8")
    (folder / "machine.toml").write_text(shipped_file("laser-table").read_text("utf-8") + RATES, "utf-8")
    square = Chain(from_points([(0, 0), (20, 0), (20, 10), (0, 10)], closed=True), RED)
    ring = tuple(Chain(circle((0, 0), radius), RED) for radius in (12.0, 4.0))
    (folder / "square.dxf").write_bytes(dxf_bytes(Drawing((square,))))
    (folder / "ring.dxf").write_bytes(dxf_bytes(Drawing(ring)))
    order = folder / "order.csv"
    order.write_text(HEAD + "\n".join(rows) + "\n", "utf-8")
    return order


def jobs_apart(count: int) -> list[str]:
    """Return rows that are not nested together: each of its own thickness, 3 to 5 mm."""
    names = ("square.dxf", "ring.dxf")
    return [f"{names[number % 2]},laser.toml,plywood,{3 + 2 * number / count:.4f},1" for number in range(count)]


def bytes_in(folder: Path) -> dict[str, bytes]:
    """Return the files of an order but its journal, whose lines come as tasks are done, and the DXF drawings.

    ezdxf writes parts of a file's head in another order in each process.
    """
    files = (path for path in folder.iterdir() if path.suffix not in (".jsonl", ".dxf"))
    return {path.name: path.read_bytes() for path in files}


class WorkersHere:
    """Runs tasks in this process, in an order of its own, and is interrupted after some."""

    def __init__(self, seed: int = 0, most: int = 1_000_000):
        self._random, self._most = random.Random(seed), most
        self.done = 0

    def __enter__(self) -> WorkersHere:
        return self

    def __exit__(self, *of: object) -> None:
        """Nothing runs."""

    def results(self, tasks: Sequence[Task]) -> Iterator[tuple[int, Result]]:
        """Yield the result of each task."""
        for number in self._random.sample(range(len(tasks)), len(tasks)):
            if self.done == self._most:
                raise KeyboardInterrupt
            self.done += 1
            yield number, run_task(tasks[number])
