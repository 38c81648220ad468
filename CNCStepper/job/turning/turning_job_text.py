# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe's job as the text of a job file, which gives the same job when it is read; numbers have all their digits."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.atomic_file import write_whole
from CNCStepper.job.files.job_text import content_text
from CNCStepper.job.turning.turning_job import TurningJob, TurningSetup
from CNCStepper.output_files import MADE_BY


def write_turning_job(job: TurningJob) -> str:
    """Return the job as the text of a job file; what has its default is left out."""
    return content_text(turning_content(job), f"a job, {MADE_BY}")


def turning_content(job: TurningSetup) -> dict[str, Any]:
    """Return a job, or its set-up alone, as the content of a file; what has its default is left out."""
    head: dict[str, Any] = {"machine": job.machine, "process": job.process, "x_is": job.x_is}
    head |= job.model_dump(mode="json", exclude_defaults=True)
    head["tool"] = [{"number": tool.number} | tool.model_dump(mode="json", exclude_defaults=True) for tool in job.tool]
    return head


def save_turning_job(job: TurningJob, path: Path) -> None:
    """Write the job into a file, as TOML."""
    write_whole(path, write_turning_job(job).encode("utf-8"))
