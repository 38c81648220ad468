# SPDX-License-Identifier: LGPL-2.1-or-later
"""The product's own verdict on a cycle: program text by the writer, read back, planned, judged, every check.

`sweep_judge.py` has the second, independent one: from the table of moves alone, with shapely.

    found = judged(operation, tool(6))
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    assert gouge_mm(found.toolpath, 3.0, [Wanted(region, -4.0)]) <= 0.01
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

from shapely import union_all

from CNCStepper.cycles.cycle import Answer, Cycle, Setup
from CNCStepper.job.make import make_program
from CNCStepper.job.model import Job, StockForm
from CNCStepper.job.prove import prove
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder, Toolpath

BESIDE_MM = 10.0  # stock round what is removed, where a test names none


@dataclass(frozen=True)
class Verdict:
    """What the product says of a program; toolpath: as it was read back from the text, in work coordinates.

    gouge_mm, left_mm: the deepest gouge, the thickest material left. lines: the program's. answer: the cycle's.
    """

    gouge_mm: float
    left_mm: float
    findings: list[Finding]
    lines: list[str]
    toolpath: Toolpath
    answer: Answer

    @property
    def clean(self) -> bool:
        """Whether no check found anything; remarks ("info") do not count."""
        return not self.faults

    @property
    def faults(self) -> list[str]:
        """The findings that are more than remarks, in words."""
        return [str(finding) for finding in self.findings if finding.severity != "info"]


def tool(diameter_mm: float = 6.0, **changes: object) -> Tool:
    """Return a flat tool with feeds and speed."""
    values = {"number": 1, "shape": "flat", "diameter_mm": diameter_mm, "feed_mm_min": 800, "plunge_mm_min": 200}
    return Tool(**(values | {"spindle_rpm": 12000} | changes))


def cut(operation: Cycle, cutter: Tool | None = None, clearance_mm: float = 10.0) -> tuple[Toolpath, Answer]:
    """Return what an operation makes on a fresh table, without the way through text."""
    table = TableBuilder(Start())
    answer = operation.cut(Setup(cutter or tool(), clearance_mm, 2.0), table)
    return table.toolpath(), answer


def judged(
    operation: Cycle,
    cutter: Tool | None = None,
    stock: Stock | None = None,
    units: str = "mm",
    thick_mm: float = 0.0,
    before: Sequence[tuple[Cycle, Tool]] = (),
) -> Verdict:
    """Return the product's verdict on an operation, by way of grbl's program text.

    Without a stock there is one around all that is to be removed, of `thick_mm`, or a millimetre thicker than the
    depth. before: other operations of the same program and their tools, with numbers of their own. Raises what the
    cycle raises.
    """
    cutter = cutter or tool()
    everything = [*before, (operation, cutter)]
    stock = stock or _stock_round([cut(*each)[1] for each in everything], thick_mm)
    job = Job(
        units=units,
        machine="table-a",
        clearance_mm=10.0,
        retract_mm=2.0,
        stock=StockForm(size_mm=stock.size_mm, origin=stock.origin),
        tool=tuple(each for _, each in everything),
        operation=tuple(each for each, _ in everything),
    )
    made = make_program(job, _machine())
    proof = prove(made.program, _machine(), stock=stock, tools=job.tools, removals=made.removals)
    told = proof.report
    gouge_mm, left_mm = told["gouge_mm"] or 0.0, told["left_over_mm"] or 0.0
    return Verdict(gouge_mm, left_mm, proof.findings, made.program.splitlines(), proof.toolpath, made.answers[-1])


@cache
def _machine() -> Machine:
    return load_machine("table-a")


def _stock_round(answers: list[Answer], thick_mm: float) -> Stock:
    removals = [removal for answer in answers for removal in answer.removals]
    left, low, right, high = union_all([removal.region for removal in removals]).bounds
    half = [max(abs(a), abs(b)) + BESIDE_MM for a, b in ((left, right), (low, high))]
    depth_mm = -min(removal.bottom_mm for removal in removals)
    return Stock((math.ceil(2 * half[0]), math.ceil(2 * half[1]), thick_mm or depth_mm + 1.0))
