# SPDX-License-Identifier: LGPL-2.1-or-later
"""Templates of a lathe's jobs: one saved under a name, and the beginning of a new one; no Qt."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from CNCStepper.job.templates.turning_template import read_turning_template, write_turning_template
from CNCStepper.workbench import api
from CNCStepper.workbench.document.turning.core_turning_job import turning_setup_of
from CNCStepper.workbench.document.turning.turning_files import setup_values, with_whole_machine
from CNCStepper.workbench.features.program_job import CONTENTS, MADE, PROGRAM_PARTS
from CNCStepper.workbench.features.turning.lathe_job import LatheJob
from CNCStepper.workbench.features.turning.turning_tool import keys_of
from CNCStepper.workbench.templates.beginning import Beginning, shop_choices

NOT_OF_TEMPLATES = {entry.key for entry in (*PROGRAM_PARTS, *CONTENTS, *MADE)}


def save(job: Any, path: Path) -> None:
    """Write a lathe's job as a template; raises CNCStepperError for a job that is wrong, or where it cannot."""
    write_turning_template(with_whole_machine(turning_setup_of(job), job), path)


def choices() -> list[tuple[str, str]]:
    """Return the templates that a lathe's job can begin with: paths and words."""
    return shop_choices(of_lathe=True)


class TurningBeginning(Beginning):
    """The beginning of a lathe's job: machine, bar, chuck, tailstock, start and tools."""

    KEYS = tuple(entry.key for entry in LatheJob.PROPERTIES if entry.key not in NOT_OF_TEMPLATES)

    def of_template(self, path: Path) -> tuple[Any, dict[str, Any]]:
        """Return what a template holds, and the values of the job's object."""
        setup = read_turning_template(path)
        return setup, setup_values(setup, setup.machine)

    def add_tool(self, tool: Any) -> None:
        """Add a tool of a template."""
        api.add_tool(self.job, **keys_of(tool))

    def add_first_tool(self) -> None:
        """Add the tool that a job has which begins with no template."""
        api.add_tool(self.job)
