# SPDX-License-Identifier: LGPL-2.1-or-later
"""Program text to proof: read back from the wire text, timed, judged, checked, reported and drawn.

Nothing here looks at what the cycles meant to do, except at the shapes that they want removed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from shapely import union_all

from CNCStepper.cycles.form import Removal
from CNCStepper.errors import JobError, Place
from CNCStepper.gcode.prepare import WireText, prepare
from CNCStepper.gcode.read_back import read_back
from CNCStepper.job.certify import Given
from CNCStepper.job.make import Made, make_program
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tool import Tool
from CNCStepper.motion.plan import begun, times_s
from CNCStepper.simulation.check import check
from CNCStepper.simulation.clamps import Clamp
from CNCStepper.simulation.finding import Finding, refused
from CNCStepper.simulation.heightmap import HeightMap, height_map
from CNCStepper.simulation.report import report
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.sweep import judge
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

if TYPE_CHECKING:
    from CNCStepper.simulation.scene import Scene
    from CNCStepper.simulation.timeline import Moment

ON_EDGE_MM = 0.01  # a shape may end on the stock's edge
STAGES = ("make", "read", "cut", "time", "judge", "check", "report")  # what `tell` hears, in this order
Tell = Callable[[str], None]
See = Callable[[HeightMap], None]


@dataclass(frozen=True)
class Proof:
    """What is known of a program text on a machine.

    wire: what would be sent. toolpath: its moves, naming the file's lines. times_s: end of every row.
    part: the stock after the program, or None without stock and tools. report: plain data for JSON.
    given: what it was proven against.
    """

    wire: WireText
    toolpath: Toolpath
    times_s: np.ndarray
    findings: list[Finding]
    part: HeightMap | None
    report: dict[str, Any]
    given: Given

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending it."""
        return refused(self.findings)

    def scene(self, moment: Moment | None = None, part: HeightMap | None = None) -> Scene:
        """Return what a picture shows of the program's end, or of a moment and the part at that moment.

        Raises JobError for a program that was proven without stock and tools.
        """
        from CNCStepper.simulation.scene import scene_at

        part = part or self.part
        if part is None or self.given.tools is None:
            raise JobError("picture", "there is no part to draw", advice="give the stock and the tools")
        return scene_at(self.toolpath, self.times_s, part, self.given.tools, moment, self.given.machine)

    def draw(self, path: Path, title: str, tools: str) -> None:
        """Draw the cut part and the tool's paths as PNG or SVG; `tools` names the cutters for people."""
        from CNCStepper.simulation.picture import facts_of, save_picture

        scene = self.scene()
        save_picture(path, scene, title, facts_of(scene, tools, self.report["time_s"]))


def prove(
    text: str,
    machine: Machine,
    *,
    file: str = "",
    dialect: str = "",
    start: Start | None = None,
    stock: Stock | None = None,
    tools: dict[int, Tool] | Tool | None = None,
    removals: Sequence[Removal] = (),
    keep_out: Sequence[Clamp] = (),
    edge_mm: float | None = None,
    tell: Tell = lambda stage: None,
    see: See = lambda part: None,
) -> Proof:
    """Return the proof of a program text; raises ProgramError for a text that cannot be read.

    start: where the machine stands; None is a machine whose position and zero are unknown (for the times it then
    begins at the work zero). removals: the shapes wanted, in work coordinates; without them gouge and left-over
    are not judged. keep_out: the clamps. edge_mm: how far from the sheet's edge cuts must stay. tell: called with the
    stage that begins, one of STAGES. see: called with the part once it is cut, before it is judged.
    """
    language = dialect or machine.controller
    tell("read")
    wire = prepare(text, language, file)
    toolpath = read_back(wire, text, start, language, file)
    tell("cut")
    part = height_map(toolpath, tools, stock) if stock is not None and tools is not None else None
    if part is not None:
        see(part)
    tell("time")
    ends_s = times_s(begun(toolpath), machine)
    tell("judge")
    judgement = judge(toolpath, tools, list(removals), stock) if tools is not None and removals else None
    tell("check")
    findings = check(
        toolpath, machine, file=file, stock=stock, tools=tools, judgement=judgement, keep_out=keep_out, edge_mm=edge_mm
    )
    tell("report")
    told = report(toolpath, ends_s, file=file, findings=findings, judgement=judgement, part=part, tools=tools)
    given = Given(text, language, machine, stock, tools, removals, keep_out, edge_mm)
    return Proof(wire, toolpath, ends_s, findings, part, told, given)


def prove_job(
    job: Job,
    machine: Machine,
    text: str,
    file: str = "",
    start: Start | None = None,
    tell: Tell = lambda stage: None,
    dialect: str = "",
    see: See = lambda part: None,
) -> Proof:
    """Return the proof of a job's program text, as `prove` does, against the shapes that the job wants removed."""
    tell("make")
    made = make_program(job, machine)
    proof = prove(
        text,
        machine,
        file=file,
        dialect=dialect,
        start=start,
        stock=job.stock.stock(),
        tools=job.tools,
        removals=made.removals,
        keep_out=job.clamps,
        edge_mm=job.stock.edge_mm,
        tell=tell,
        see=see,
    )
    findings = sorted(
        [*proof.findings, *_warnings(proof, made, job.stock.stock(), file)], key=lambda finding: finding.place.line
    )
    told = proof.report | {
        "operations": [
            operation | {"figures": answer.figures}
            for operation, answer in zip(proof.report["operations"], made.answers, strict=False)
        ],
        "warnings": sum(finding.severity == "warning" for finding in findings),
        "findings": [finding.as_dict() for finding in findings],
    }
    return replace(proof, findings=findings, report=told)


def _warnings(proof: Proof, made: Made, stock: Stock, file: str) -> Iterator[Finding]:
    """Yield what the cycles warn of, and shapes beside the stock, each at the first line of its operation."""
    lines = proof.toolpath.table().line
    operations = [span for span in proof.toolpath.spans if span.kind == "operation"]
    for span, answer in zip(operations, made.answers, strict=False):
        place = Place(file, int(lines[span.first]), 1)
        for warning in answer.warnings:
            yield Finding("warning", "not-exact", place, warning)
        if stock.outline.buffer(ON_EDGE_MM).covers(union_all([removal.region for removal in answer.removals])):
            continue
        advice = "move the shape or the work zero, or take larger stock"
        yield Finding("warning", "beside-stock", place, "part of the drawn shape lies beside the stock", advice)
