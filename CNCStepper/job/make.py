# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job to program text: the cycles fill one table of moves, the writer puts it into the machine's dialect."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import groupby

from CNCStepper.cycles.cycle import Answer, Cycle, Removal
from CNCStepper.errors import CNCStepperError, Place, Text
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.writer.write import WriteOptions, write, write_split
from CNCStepper.job.chart_tools import as_cut_by
from CNCStepper.job.model import Job
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.profile import Machine
from CNCStepper.state import State
from CNCStepper.toolpath import TableBuilder, Toolpath

NUMBERED = {
    "face": "operation {number} (face)",
    "pocket": "operation {number} (pocket)",
    "rectangular_pocket": "operation {number} (rectangular pocket)",
    "circular_pocket": "operation {number} (circular pocket)",
    "elliptical_pocket": "operation {number} (elliptical pocket)",
    "contour": "operation {number} (contour)",
    "engrave": "operation {number} (engrave)",
    "drill": "operation {number} (drill)",
    "bore": "operation {number} (bore)",
    "thread": "operation {number} (thread)",
    "sheet_cut": "operation {number} (sheet cut)",
    "wire_cut": "operation {number} (wire cut)",
    "turn_face": "operation {number} (turn face)",
    "turn_rough": "operation {number} (turn rough)",
    "turn_finish": "operation {number} (turn finish)",
    "turn_taper": "operation {number} (turn taper)",
    "turn_groove": "operation {number} (turn groove)",
    "turn_part": "operation {number} (turn part)",
    "turn_drill": "operation {number} (turn drill)",
    "turn_bore": "operation {number} (turn bore)",
    "turn_thread": "operation {number} (turn thread)",
}  # whole, so that a translation of a cycle's name never touches a layer or shape that somebody called so


@dataclass(frozen=True)
class Made:
    """A program with the facts that are known before it is read back.

    program: the text in the machine's dialect. toolpath: the cycles' moves, in work coordinates.
    answers: one for each operation, in order.
    """

    program: str
    toolpath: Toolpath
    answers: list[Answer]

    @property
    def removals(self) -> list[Removal]:
        """What all operations together want removed."""
        return _removals(self.answers)


@dataclass(frozen=True)
class Part:
    """One of the programs into which a job is split: its tool, its text and what its operations answered.

    number: from 1, in the order in which they are run.
    """

    number: int
    tool: int
    program: str
    answers: list[Answer]

    @property
    def removals(self) -> list[Removal]:
        """What its operations want removed."""
        return _removals(self.answers)

    @property
    def file_name(self) -> str:
        """The name of its file beside the others, for example program-2-T3.nc."""
        return f"program-{self.number}-T{self.tool}.nc"


def make_program(job: Job, machine: Machine, title: str = "") -> Made:
    """Return the program of `job` for `machine`; raises CycleError, JobError or ProgramError and makes nothing.

    One that must be split, a program a tool, is refused: `make_parts` makes those.
    """
    job = job.on(machine)
    toolpath, answers = cut_operations(job)
    return Made(write(toolpath, dialect(machine.language()), _options(job, machine, title)), toolpath, answers)


def is_split(job: Job, machine: Machine) -> bool:
    """Return whether the job needs more than one program: more than one tool on a machine that wants a file a tool."""
    return machine.tool_change == "split" and len({operation.tool for operation in job.operation}) > 1


def make_parts(job: Job, machine: Machine, title: str = "") -> list[Part]:
    """Return the programs of `job`, one for each stretch of operations with the same tool, in the order of the work.

    Raises as `make_program` does.
    """
    job = job.on(machine)
    toolpath, answers = cut_operations(job)
    texts = write_split(toolpath, dialect(machine.language()), _options(job, machine, title))
    stretches = groupby(zip(job.operation, answers, strict=True), key=lambda pair: pair[0].tool)
    return [
        Part(number, tool, text, [answer for _, answer in pairs])
        for number, ((tool, text), (_, pairs)) in enumerate(zip(texts, stretches, strict=True), start=1)
    ]


def cut_operations(job: Job) -> tuple[Toolpath, list[Answer]]:
    """Return the moves of all operations, in work coordinates, and what each answered."""
    table = TableBuilder(job.begin, State(work_system=job.work_offset))
    answers = [_cut(number, operation, job, table) for number, operation in enumerate(job.operation, start=1)]
    return table.toolpath(), answers


def _removals(answers: list[Answer]) -> list[Removal]:
    return [removal for answer in answers for removal in answer.removals]


def operation_name(cycle: str) -> str:
    """Return a cycle's name for people."""
    return cycle.replace("_", " ")


def numbered(number: int, cycle: str) -> Text:
    """Return an operation's number in its job with its name, for sentences: a job may hold many of a kind."""
    return Text(NUMBERED[cycle], number=number)


def _cut(number: int, operation: Cycle, job: Job, table: TableBuilder) -> Answer:
    """Append one operation; an error names it, for a job may hold many of a kind."""
    tool = job.tools[operation.tool]
    turns = tool.spindle_rpm > 0 and job.cutting.power == "operation"
    table.set_state(
        replace(
            table.state,
            tool=tool.number,
            spindle="cw" if turns else "off",
            spindle_rpm=tool.spindle_rpm if turns else 0.0,
            mist=job.coolant == "mist",
            flood=job.coolant == "flood",
        )
    )
    table.open_span("operation", operation_name(operation.cycle))
    try:
        answer = operation.cut(job.setup(operation), table)
    except CNCStepperError as error:
        if error.place:
            raise
        raise error.at(Place(numbered(number, operation.cycle))) from error
    table.close_span()
    return answer


def _material(job: Job) -> CutData | None:
    """Return the chart's row as the job's tool cuts it."""
    if job.cut_data is None or not job.operation:
        return job.cut_data
    return as_cut_by(job.cut_data, job.tools[job.operation[0].tool])


def _options(job: Job, machine: Machine, title: str) -> WriteOptions:
    return WriteOptions(
        units=job.units,
        work_offset=job.work_offset,
        clearance_mm=job.clearance_mm,
        spin_up_s=machine.spindle.spin_up_s if job.cutting.power == "operation" else 0.0,
        tool_change=machine.tool_change,
        title=title,
        tools={tool.number: tool.words for tool in job.tool},
        tool_length=machine.tool_length,
        tool_lengths_mm=job.tool_lengths_mm,
        rapid_mm_min=machine.fastest_mm_min,
        cut_data=_material(job),
    )
