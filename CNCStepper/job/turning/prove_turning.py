# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a lathe's programs: each read back from its text, then judged on the part that those before it cut."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from pathlib import Path
from typing import Any

from CNCStepper.errors import Place
from CNCStepper.gcode.dialects import dialect
from CNCStepper.job.prove import Proof, prove, with_findings
from CNCStepper.job.turning.make_turning import TurnedProgram, in_part, placement_of
from CNCStepper.job.turning.report import TurnedVerdict, judge_turning, setup_of
from CNCStepper.job.turning.turning_job import TurningJob
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.prior_programs import followed
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath


@dataclass(frozen=True)
class TurnedProof:
    """A program's proof, with the verdict on the part as cut behind it."""

    program: TurnedProgram
    proof: Proof
    verdict: TurnedVerdict


def prove_turning(
    job: TurningJob, machine: Machine, programs: Sequence[TurnedProgram], folder: Path
) -> Iterator[TurnedProof]:
    """Yield the proof of each program of a job, in their order; `folder` is where their files are."""
    before: list[Toolpath] = []
    done = 0
    for program in programs:
        file = str(folder / program.file_name)
        start = Start(tool=program.answers[0].tool) if "T" not in dialect(machine.language()).letters else None
        proof = prove(program.program, machine, file=file, start=start)
        before.append(in_part(proof.toolpath, placement_of(job, machine)))
        done += len(program.answers)
        so_far = job.model_copy(update={"operation": job.operation[:done]})
        verdict = judge_turning(moves_of(reduce(followed, before)), setup_of(so_far, file), job.x_is)
        found = [*verdict.findings, *_of_answers(program, file)]
        told = replace(proof, report={**proof.report, **verdict.report(), "operations": _operations(proof, program)})
        yield TurnedProof(program, with_findings(told, found), verdict)


def _operations(proof: Proof, program: TurnedProgram) -> list[dict[str, Any]]:
    answers = zip(proof.report["operations"], program.answers, strict=False)
    return [operation | {"figures": answer.figures} for operation, answer in answers]


def _of_answers(program: TurnedProgram, file: str) -> Iterator[Finding]:
    """Yield what the cycles warn of."""
    for answer in program.answers:
        for warning in answer.warnings:
            yield Finding("warning", f"operation-{answer.number}", Place(file, 1, 1), warning)
