# SPDX-License-Identifier: LGPL-2.1-or-later
"""Job to program text: the cycles fill one table of moves, the writer puts it into the machine's dialect."""

from __future__ import annotations

from dataclasses import dataclass, replace

from CNCStepper.cycles.form import Answer, Cycle, Removal
from CNCStepper.gcode.dialects import dialect
from CNCStepper.gcode.write import WriteOptions, write
from CNCStepper.job.model import Job
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder, Toolpath


@dataclass(frozen=True)
class Made:
    """A program and what is known of it before it is read back.

    program: the text in the machine's dialect. toolpath: what the cycles made, in work coordinates.
    answers: one for each operation, in order.
    """

    program: str
    toolpath: Toolpath
    answers: list[Answer]

    @property
    def removals(self) -> list[Removal]:
        """What all operations together want removed."""
        return [removal for answer in self.answers for removal in answer.removals]


def make_program(job: Job, machine: Machine, title: str = "") -> Made:
    """Return the program of `job` for `machine`; raises CycleError, JobError or ProgramError and makes nothing."""
    table = TableBuilder(Start(), State(work_system=job.work_offset))
    answers = [_cut(operation, job, table) for operation in job.operation]
    toolpath = table.toolpath()
    return Made(write(toolpath, dialect(machine.controller), _options(job, machine, title)), toolpath, answers)


def operation_name(operation: Cycle) -> str:
    """Return the words by which a person knows the operation."""
    return operation.cycle.replace("_", " ")


def _cut(operation: Cycle, job: Job, table: TableBuilder) -> Answer:
    tool = job.tools[operation.tool]
    table.set_state(
        replace(
            table.state,
            tool=tool.number,
            spindle="cw" if tool.spindle_rpm else "off",
            spindle_rpm=tool.spindle_rpm,
            mist=job.coolant == "mist",
            flood=job.coolant == "flood",
        )
    )
    table.open_span("operation", operation_name(operation))
    answer = operation.cut(job.setup(operation), table)
    table.close_span()
    return answer


def _options(job: Job, machine: Machine, title: str) -> WriteOptions:
    return WriteOptions(
        units=job.units,
        work_offset=job.work_offset,
        clearance_mm=job.clearance_mm,
        spin_up_s=machine.spindle.spin_up_s,
        tool_change=machine.tool_change,
        title=title,
        tools={tool.number: tool.words for tool in job.tool},
    )
