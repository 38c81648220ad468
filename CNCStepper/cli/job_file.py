# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job file that a verb reads, with a word on how far it is: the drawings that it names may take a minute."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from CNCStepper.cli.common.progress import Progress
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.machine.profile import Machine


def is_turning_file(path: Path) -> bool:
    """Return whether a job file is a lathe's; one that is no TOML file is not, and is refused where it is read."""
    from CNCStepper.errors import JobError
    from CNCStepper.machine.files.toml_reader import read_toml
    from CNCStepper.machine.processes import is_turning

    if path.suffix.lower() == ".json":
        return False
    try:
        return is_turning(read_toml(path))
    except JobError:
        return False


def machine_of_turning(path: Path) -> Machine:
    """Return the machine of a lathe's job file."""
    from CNCStepper.job.turning.turning_job import load_turning_job

    return load_turning_job(path)[1]


def job_of(path: Path) -> Job:
    """Return the job of a file, without looking for its machine."""
    from CNCStepper.job.model import read_job

    with Progress(Text("reading {name}", name=path.name)) as progress:
        return read_job(path, progress.share)


def job_and_machine(path: Path) -> tuple[Job, Machine]:
    """Return the job of a file and its machine."""
    from CNCStepper.job.model import load_job

    with Progress(Text("reading {name}", name=path.name)) as progress:
        return load_job(path, progress.share)
