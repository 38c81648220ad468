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
    """A program's proof, with the verdict on the part as cut behind it.

    path: its moves in the part's coordinates; first_row: its first one in the verdict's moves.
    """

    program: TurnedProgram
    proof: Proof
    verdict: TurnedVerdict
    path: Toolpath
    first_row: int


def prove_turning(
    job: TurningJob,
    machine: Machine,
    programs: Sequence[TurnedProgram],
    folder: Path,
    name: str = "",
    start: Start | None = None,
    last_dialect: str = "",
) -> Iterator[TurnedProof]:
    """Yield the proof of each program of a job, in their order; `folder` is where their files are.

    name: of all of them in findings, "" for their files'. start: of the machine, where it is known. last_dialect: of
    the last program, where it is not the machine's.
    """
    before: list[Toolpath] = []
    done = rows = 0
    for program in programs:
        file = name or str(folder / program.file_name)
        language = last_dialect if program is programs[-1] else ""
        proof = prove(program.program, machine, file=file, dialect=language, start=start_of(program, machine, start))
        before.append(in_part(proof.toolpath, placement_of(job, machine)))
        done += len(program.answers)
        so_far = job.model_copy(update={"operation": job.operation[:done]})
        verdict = judge_turning(moves_of(reduce(followed, before)), setup_of(so_far, file), job.x_is)
        found = [*verdict.findings, *_of_answers(program, file)]
        operations = _operations(proof, program, verdict, rows)
        told = replace(proof, report={**proof.report, **verdict.report(rows), "operations": operations})
        yield TurnedProof(program, with_findings(told, found), verdict, before[-1], rows)
        rows += len(proof.toolpath)


def start_of(program: TurnedProgram, machine: Machine, start: Start | None) -> Start | None:
    """Return the start of a program: where its text names no tool, with the one that it is for."""
    if "T" in dialect(machine.language()).letters:
        return start
    return replace(start or Start(), tool=program.answers[0].tool)


def whole_report(proofs: Sequence[TurnedProof]) -> dict[str, Any]:
    """Return the report of the finished part where several programs make it, one after the other.

    It has what each program's report says of the part, all operations, and the sums of times, lengths and findings.
    """
    reports = [one.proof.report for one in proofs]
    summed = ("time_s", "cut_length_mm", "air_length_mm", "rapid_length_mm", "errors", "warnings")
    return {
        "programs": [report["program"] for report in reports],
        **proofs[-1].verdict.report(),
        **{key: sum(report[key] for report in reports) for key in summed},
        "operations": [operation for report in reports for operation in report["operations"]],
    }


def _operations(proof: Proof, program: TurnedProgram, verdict: TurnedVerdict, rows: int) -> list[dict[str, Any]]:
    """Return the report's operations with the cycles' figures; rows: of the programs before this one."""
    spans = [span for span in proof.toolpath.spans if span.kind == "operation"]
    found = zip(proof.report["operations"], spans, program.answers, strict=False)
    return [
        operation | verdict.lengths(rows + span.first, rows + span.last) | {"figures": answer.figures}
        for operation, span, answer in found
    ]


def _of_answers(program: TurnedProgram, file: str) -> Iterator[Finding]:
    """Yield what the cycles warn of."""
    for answer in program.answers:
        for warning in answer.warnings:
            yield Finding("warning", f"operation-{answer.number}", Place(file, 1, 1), warning)
