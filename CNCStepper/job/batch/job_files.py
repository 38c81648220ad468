# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of one job that a template made: NAME.toml, NAME.nc, NAME-report.json, NAME-certificate.zip.

A machine on which each tool has a program of its own gets NAME-N-TN.nc, with report and certificate, for each of them.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from CNCStepper.job.make import is_split, make_parts, make_program
from CNCStepper.job.make_certificate import certificate_of
from CNCStepper.job.model import Job
from CNCStepper.job.prove import Proof, prove_job, prove_parts
from CNCStepper.job.templates.drawing_job import DrawingJob
from CNCStepper.machine.profile import Machine
from CNCStepper.output_files import MADE_BY

REPORT = {"format": "CNCStepper report"}
MOST_TOLD = 5


def job_files(name: str, drawn: DrawingJob, machine: Machine, folder: Path) -> tuple[dict[str, bytes], list[Proof]]:
    """Return the files of a job by their names, and the proof of each program.

    folder: exists; for the certificates. Raises CNCStepperError where no program can be made.
    """
    files = {f"{name}.toml": drawn.text.encode("utf-8")}
    proofs = []
    for own, program, proof in _programs(name, drawn.job, machine):
        files[f"{own}.nc"] = program.encode("ascii")
        told = proof.report | {"program": f"{own}.nc"}
        files[f"{own}-report.json"] = (json.dumps(REPORT | told, indent=2, allow_nan=False) + "\n").encode("utf-8")
        certificate = folder / f"{own}-certificate.zip"
        certificate_of(proof).write(certificate)
        files[certificate.name] = certificate.read_bytes()
        proofs.append(proof)
    return files, proofs


def _programs(name: str, job: Job, machine: Machine) -> list[tuple[str, str, Proof]]:
    """Return name, text and proof of each program of a job: one, or one for each tool."""
    title = f"{MADE_BY}: {name}"
    if not is_split(job, machine):
        made = make_program(job, machine, title)
        return [(name, made.program, prove_job(job, machine, made.program, f"{name}.nc", answers=made.answers))]
    parts = make_parts(job, machine, title)
    proofs = list(prove_parts(job, machine, parts, Path()))
    names = [part.file_name.replace("program", name, 1).removesuffix(".nc") for part in parts]
    return [(own, part.program, proof) for own, part, proof in zip(names, parts, proofs, strict=True)]


def refusals(proofs: Sequence[Proof]) -> list[str]:
    """Return the first findings for which programs must not run."""
    errors = [finding for proof in proofs for finding in proof.findings if finding.severity == "error"]
    return [str(finding) for finding in errors[:MOST_TOLD]]
