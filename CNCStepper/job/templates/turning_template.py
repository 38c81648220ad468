# SPDX-License-Identifier: LGPL-2.1-or-later
"""The template of a lathe: machine, bar, chuck and tools with which a new job begins.

It lies beside the other templates of the shop and is a job file of a lathe without [[profile]] and [[operation]].
"""

from __future__ import annotations

from pathlib import Path

from CNCStepper.errors import Place, placed
from CNCStepper.job.model import machine_path
from CNCStepper.job.templates.template_files import with_whole_paths, write_checked
from CNCStepper.job.turning.turning_job import TurningSetup, require_lathe
from CNCStepper.job.turning.turning_job_text import turning_content
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.profile import load_machine, validated


def read_turning_template(path: Path) -> TurningSetup:
    """Return what a template's file holds, its machine's file by its whole path.

    Raises JobError that names the file, the key and its value, also for a machine that is missing or no lathe.
    """
    with placed(Place(str(path))):
        setup = validated(TurningSetup, with_whole_paths(read_toml(path), path.parent), str(path))
        require_lathe(load_machine(machine_path(setup.machine, path.parent)))
        return setup


def write_turning_template(setup: TurningSetup, path: Path) -> None:
    """Write a lathe's template into a file, its folder too; raises JobError where it cannot be written."""
    write_checked(turning_content(setup), path)
