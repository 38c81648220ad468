# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the folder of a proof holds of a lathe's program, in place of job.json and of the heights of a part.

    turning.json     the request: {"job": job, "part": 2, "title": text}, part: which of its programs, from 1;
                     or of a G-code file {"bar": bar, "tools": [tool, …]}
    section.npz      the answer: the part as cut in half section, rings of z and radius
    placement.json   where the program's zero lies on the part, and the sign of its Z

The other files are those of `job/proof_folder.py`; moves and lines lie on the part: X is the radius, Z its own.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.cycles.turning.turned_coordinates import Placement
from CNCStepper.job.proof_folder import ProgramAnswer, read_program_answer, write_program, write_program_answer

if TYPE_CHECKING:
    from CNCStepper.control.program.certificate import Certificate
    from CNCStepper.job.prove import Proof
    from CNCStepper.job.turning.prove_program import TurnedBar
    from CNCStepper.job.turning.report import TurnedVerdict
    from CNCStepper.job.turning.turning_job import TurningJob
    from CNCStepper.machine.profile import Machine
    from CNCStepper.machine.tools.turning_tool import TurningTool
    from CNCStepper.state import Start
    from CNCStepper.toolpath import Toolpath

QUESTION, SECTION, PLACEMENT = "turning.json", "section.npz", "placement.json"


@dataclass(frozen=True)
class TurnedAnswer(ProgramAnswer):
    """What the proof of a lathe's program answered.

    rings: of the part as cut, each float64[n, 2] of z and radius. placement: of the program on the part.
    """

    rings: tuple[np.ndarray, ...]
    placement: Placement


@dataclass(frozen=True)
class TurnedQuestion:
    """The proof of a request.

    on_part: the moves on the part. first_row: their first one in the verdict's moves. placement: which puts them there.
    """

    proof: Proof
    verdict: TurnedVerdict
    on_part: Toolpath
    first_row: int
    placement: Placement


def write_job_question(folder: Path, program: str, job: TurningJob, machine: Machine, part: int, title: str) -> None:
    """Write the request for one of the programs of a job; title: with which the job's programs are made."""
    write_program(folder, program, machine)
    content = {"job": job.model_dump(mode="json", exclude_none=True), "part": part, "title": title}
    (folder / QUESTION).write_text(json.dumps(content), encoding="utf-8")


def write_file_question(
    folder: Path, program: str, bar: TurnedBar, tools: Sequence[TurningTool], machine: Machine
) -> None:
    """Write the request for a program that no job has made, cut out of a bar with these tools."""
    write_program(folder, program, machine)
    content = {"bar": asdict(bar), "tools": [tool.model_dump(mode="json", exclude_none=True) for tool in tools]}
    (folder / QUESTION).write_text(json.dumps(content), encoding="utf-8")


def is_turned(folder: Path) -> bool:
    """Return whether a folder holds the request for a lathe's program."""
    return (folder / QUESTION).exists()


def prove_question(folder: Path, program: str, machine: Machine, name: str, start: Start | None) -> TurnedQuestion:
    """Return the proof of the program of a request; raises what the core raises."""
    from CNCStepper.gcode.dialects import dialect
    from CNCStepper.job.turning.make_turning import in_part
    from CNCStepper.job.turning.prove_program import TurnedBar, prove_turned
    from CNCStepper.machine.profile import validated
    from CNCStepper.machine.tools.turning_tool import TurningTool

    content = json.loads((folder / QUESTION).read_text("utf-8"))
    if "bar" not in content:
        return _of_job(content, program, machine, name, start)
    tools = [validated(TurningTool, raw, name) for raw in content["tools"]]
    by_number = {tool.number: tool for tool in tools}
    proof, verdict = prove_turned(program, machine, TurnedBar(**content["bar"]), by_number, file=name, start=start)
    placement = Placement(z_sign=dialect(machine.language()).z_sign)
    return TurnedQuestion(proof, verdict, in_part(proof.toolpath, placement), 0, placement)


def _of_job(content: dict[str, Any], program: str, machine: Machine, name: str, start: Start | None) -> TurnedQuestion:
    """Return the same of a program of a job: behind those that come before it, and in place of its own text."""
    from CNCStepper.job.turning.make_turning import make_turning, placement_of
    from CNCStepper.job.turning.prove_turning import prove_turning
    from CNCStepper.job.turning.turning_job import turning_job_of

    job, number = turning_job_of(content["job"], Path(name)), content["part"]
    made = make_turning(job, machine, content["title"])[:number]
    programs = [*made[:-1], replace(made[-1], program=program)]
    *_, proven = prove_turning(job, machine, programs, Path(), name, start)
    placement = placement_of(job, machine)
    return TurnedQuestion(proven.proof, proven.verdict, proven.path, proven.first_row, placement)


def write_turned_answer(folder: Path, proven: TurnedQuestion, certificate: Certificate) -> None:
    """Write the answer to a request."""
    import shapely

    region = proven.verdict.part.section.region
    rings = [np.asarray(ring.coords)[:, :2] for ring in shapely.get_rings(shapely.get_parts(region))]
    named: dict[str, Any] = {f"{number}": ring for number, ring in enumerate(rings)}
    np.savez(folder / SECTION, **named)
    (folder / PLACEMENT).write_text(json.dumps(asdict(proven.placement)), encoding="utf-8")
    write_program_answer(folder, proven.on_part, proven.proof, certificate)


def read_turned_answer(folder: Path) -> TurnedAnswer:
    """Return the answer; raises the error that was written instead, or CNCStepperError when there is neither."""
    common = read_program_answer(folder)
    with np.load(folder / SECTION, allow_pickle=False) as arrays:
        rings = tuple(arrays[name] for name in sorted(arrays, key=int))
    placement = Placement(**json.loads((folder / PLACEMENT).read_text("utf-8")))
    return TurnedAnswer(**common.shared(), rings=rings, placement=placement)
