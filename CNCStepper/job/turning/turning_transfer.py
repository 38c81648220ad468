# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jobs of a lathe as the window and its processes hand them to each other, and what they make of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from CNCStepper.errors import CNCStepperError
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.job.cut_transfer import machine_content, machine_from
from CNCStepper.job.path_commands import commands, gcode
from CNCStepper.job.turning.cutting_warnings import preset_speed_warnings
from CNCStepper.job.turning.make_turning import in_part, make_turning, placement_of, turned_moves
from CNCStepper.job.turning.turning_job import TurningJob, turning_job_of
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

JOB, MACHINE = "job", "machine"


def content_of(job: TurningJob, machine: Machine) -> dict[str, Any]:
    """Return a job and its machine as plain data."""
    return {JOB: job.model_dump(mode="json", exclude_none=True), MACHINE: machine_content(machine)}


def job_from(content: dict[str, Any]) -> tuple[TurningJob, Machine]:
    """Return job and machine of `content_of`; raises JobError."""
    return turning_job_of(content[JOB], Path("job")), machine_from(content[MACHINE])


def program_texts(job: TurningJob, machine: Machine, title: str) -> list[tuple[str, str]]:
    """Return the names and texts of a job's programs: one without a name, or one a tool."""
    made = make_turning(job, machine, title)
    return [(one.file_name, one.program) for one in made] if len(made) > 1 else [("", made[0].program)]


def last_cut(job: TurningJob, machine: Machine) -> tuple[dict[str, float], tuple[str, ...]]:
    """Return figures and warnings of a job's last operation; its refusal names no place, as it is asked for alone."""
    try:
        _, answers = turned_moves(job, machine)
    except CNCStepperError as error:
        raise error.at(None) from error
    last = answers[-1]
    return last.figures, last.warnings + preset_speed_warnings(job.operation[-1], last.figures["rpm"], job, machine)


def last_time_s(job: TurningJob, machine: Machine) -> float:
    """Return the planned time of a job's last operation, s."""
    return operation_times_s(job, machine)[-1]


def operation_times_s(job: TurningJob, machine: Machine) -> list[float]:
    """Return the planned time of each operation of a job, s."""
    from CNCStepper.motion.planner.plan import begun, times_s  # its kernels load late

    moves, _ = turned_moves(job, machine)
    ends_s = np.concatenate([[0.0], times_s(begun(moves), machine)])
    spans = [span for span in moves.spans if span.kind == "operation"]
    return [float(ends_s[span.last] - ends_s[span.first]) for span in spans]


def read_back(job: TurningJob, machine: Machine, text: str, file: str) -> Toolpath:
    """Return the moves of a program's text on the part: X the radius, Z of a right-handed lathe."""
    return in_part(interpret(text, Start(), dialect=machine.language(), file=file), placement_of(job, machine))


def path_text(job: TurningJob, machine: Machine, text: str, file: str) -> str:
    """Return a program's moves on the part as FreeCAD's Path reads them."""
    return gcode(commands(read_back(job, machine, text, file)))
