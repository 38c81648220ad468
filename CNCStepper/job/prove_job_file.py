# SPDX-License-Identifier: LGPL-2.1-or-later
"""The proof of a job's program in a file, which is read piece by piece, against the job's shapes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from CNCStepper.job.findings import findings_of
from CNCStepper.job.model import Job
from CNCStepper.job.prove import answers_of, inputs_of, with_answers, with_findings
from CNCStepper.job.prove_file import FileProof, prove_file
from CNCStepper.machine.profile import Machine
from CNCStepper.state import Start


def prove_job_file(
    job: Job,
    path: Path,
    machine: Machine,
    *,
    name: str = "",
    dialect: str = "",
    start: Start | None = None,
    sent: Path | None = None,
    share: Callable[[float], None] = lambda share: None,
    tell: Callable[[str], None] = lambda stage: None,
) -> FileProof:
    """Return the proof of a job's program, the first of those that it is split into, as `prove_job` does of its text.

    name, sent, share: as `prove_file` takes them. tell: as `prove` does.
    """
    tell("make")
    answers, file = answers_of(job, machine, 0), name or str(path)
    inputs = inputs_of(job, machine, answers, start)
    inputs["removals"] = [removal for answer in answers for removal in answer.removals]
    proof = prove_file(path, machine, dialect=dialect, sent=sent, name=file, share=share, tell=tell, **inputs)
    own = findings_of(job, machine, proof.lines, proof.spans, answers, file)
    return with_findings(with_answers(proof, answers), list(own))
