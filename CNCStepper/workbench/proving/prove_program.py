# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the commands share that take a job's program further, or one that was edited."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.features.base import named, problem_of
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.message_translation import translated


def why_not() -> str:
    """Return why no program can be taken further, "" when one can."""
    if (edited := targets.program()) is not None:
        return why_not_of(edited)
    return (
        missing_packages.why_not()
        or targets.why_no_panel()
        or targets.why_no_job()
        or targets.why_no_program(targets.job())
    )


def why_not_of(edited: Any) -> str:
    """Return why an edited program cannot be taken further, "" when it can."""
    problem = named(edited, translated(problem_of(edited))) if problem_of(edited) else ""
    return missing_packages.why_not() or targets.why_no_panel() or problem


def meant() -> Any:
    """Return the edited program that is selected, else the job that is meant."""
    return targets.program() or targets.job()


def make(job: Any) -> None:
    """Make a program from the present document; raises JobError when that is impossible."""
    from CNCStepper.workbench import api

    job.Document.recompute()
    api.require_valid(job)
