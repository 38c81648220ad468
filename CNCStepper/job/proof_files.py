# SPDX-License-Identifier: LGPL-2.1-or-later
"""The folder in which a proof is asked for and answered, between a window and the process that proves.

    job.json  machine.json  program.nc        what is asked (the job without its machine's name counting)
    result.json  moves.npz  part.npz  send.json   what is answered; or error.json, why there is no answer

Reading an answer takes numpy only.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.control.outcome import error_from_json, error_to_json
from CNCStepper.errors import CNCStepperError
from CNCStepper.simulation.finding import Finding, refused
from CNCStepper.simulation.timeline import Timeline

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.job.prove import Proof
    from CNCStepper.machine.profile import Machine

PROGRAM, JOB, MACHINE = "program.nc", "job.json", "machine.json"
RESULT, MOVES, PART, SEND, ERROR = "result.json", "moves.npz", "part.npz", "send.json", "error.json"


@dataclass(frozen=True)
class Part:
    """The stock after the program, from above; z = 0 is the stock's top.

    heights_mm: float64[rows, columns], rows along y. x_mm, y_mm: the centres of the cells, work coordinates.
    low_mm, high_mm: the corners of the stock.
    """

    heights_mm: np.ndarray
    x_mm: np.ndarray
    y_mm: np.ndarray
    low_mm: np.ndarray
    high_mm: np.ndarray


@dataclass(frozen=True)
class Answer:
    """What a proof answered: report as in `Proof`, the moves in time, and the part that is left."""

    findings: list[Finding]
    report: dict[str, Any]
    moves: Timeline
    part: Part
    send_file: Path

    @property
    def refused(self) -> bool:
        """Whether a finding forbids sending the program."""
        return refused(self.findings)


def write_question(folder: Path, program: str, job: Job, machine: Machine) -> None:
    """Write what is asked."""
    from CNCStepper.job.model import save_job

    (folder / PROGRAM).write_bytes(program.encode("ascii"))
    (folder / MACHINE).write_text(machine.model_dump_json(), encoding="utf-8")
    save_job(job, folder / JOB)


def read_question(folder: Path) -> tuple[str, Job, Machine]:
    """Return program, job and machine; raises JobError for what is not as `write_question` left it."""
    from CNCStepper.job.model import read_job
    from CNCStepper.machine.profile import Machine, validated

    content = json.loads((folder / MACHINE).read_text("utf-8"))
    return (
        (folder / PROGRAM).read_bytes().decode("ascii"),
        read_job(folder / JOB),
        validated(Machine, content, str(folder / MACHINE)),
    )


def write_answer(folder: Path, proof: Proof, send_json: str) -> None:
    """Write the answer; the result, which says that all is there, comes last."""
    assert proof.part is not None
    Timeline.of(proof.toolpath, proof.times_s).save(folder / MOVES)
    stock = proof.part.stock
    np.savez(
        folder / PART,
        heights_mm=proof.part.heights_mm,
        x_mm=proof.part.x_mm,
        y_mm=proof.part.y_mm,
        low_mm=np.array(stock.low_mm),
        high_mm=np.array(stock.high_mm),
    )
    (folder / SEND).write_text(send_json, encoding="utf-8")
    (folder / RESULT).write_text(json.dumps(proof.report, allow_nan=False), encoding="utf-8")


def write_error(folder: Path, error: CNCStepperError) -> None:
    """Write why there is no answer."""
    (folder / ERROR).write_text(json.dumps(error_to_json(error)), encoding="utf-8")


def read_answer(folder: Path) -> Answer:
    """Return the answer; raises the error that was written instead, or CNCStepperError when there is neither."""
    if (folder / ERROR).exists():
        raise error_from_json(json.loads((folder / ERROR).read_text("utf-8")))
    if not (folder / RESULT).exists():
        raise CNCStepperError(
            "proof-lost",
            "the process that proves the program ended without an answer",
            advice="try again; if it stays so, the program may need more memory than there is",
        )
    report = json.loads((folder / RESULT).read_text("utf-8"))
    with np.load(folder / PART, allow_pickle=False) as arrays:
        part = Part(**arrays)
    findings = [Finding.from_dict(content) for content in report["findings"]]
    return Answer(findings, report, Timeline.load(folder / MOVES), part, folder / SEND)
