# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands share that take a job's program further."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import missing
from CNCStepper.workbench.commands import choice


def why_not() -> str:
    """Return why no job's program can be taken further, "" when one can."""
    return missing.why_not() or choice.why_no_panel() or choice.why_no_job() or choice.why_no_program(choice.job())


def made_job() -> Any:
    """Return the job that is meant, its program made from what the document says now; raises JobError."""
    job = choice.job()
    make(job)
    return job


def make(job: Any) -> None:
    """Make a job's program from what the document says now; raises JobError when there can be none."""
    from CNCStepper.workbench import api

    job.Document.recompute()
    api.require_valid(job)
