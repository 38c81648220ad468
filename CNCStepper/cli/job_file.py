# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job file that a verb reads, with a word on how far it is: the drawings that it names may take a minute."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from CNCStepper.cli.common.progress import Progress

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.machine.profile import Machine


def job_of(path: Path) -> Job:
    """Return the job of a file, without looking for its machine."""
    from CNCStepper.job.model import read_job

    with Progress(f"reading {path.name}") as progress:
        return read_job(path, progress.share)


def job_and_machine(path: Path) -> tuple[Job, Machine]:
    """Return the job of a file and its machine."""
    from CNCStepper.job.model import load_job

    with Progress(f"reading {path.name}") as progress:
        return load_job(path, progress.share)
