# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job that a template begins: its machine, material, stock and tools, without a drawing and operations."""

from __future__ import annotations

import copy

from CNCStepper.errors import Place, placed
from CNCStepper.job.model import Job, job_of_content, machine_path
from CNCStepper.job.templates.drawing_job import stock_content
from CNCStepper.job.templates.template import Template
from CNCStepper.job.templates.template_files import with_whole_paths
from CNCStepper.machine.profile import load_machine


def begun_job(template: Template, size_mm: tuple[float, float]) -> Job:
    """Return the job, its files by their whole paths; size_mm: X and Y of a stock that the template gives none.

    Raises JobError that names the template's file for values that are wrong, and for a machine that there is not or
    that does not cut so.
    """
    folder = template.path.parent
    content = with_whole_paths(copy.deepcopy(template.job), folder)
    stock = stock_content(template.stock, template.stock.size_mm or size_mm)
    job = job_of_content(content | {"stock": stock}, template.path)
    with placed(Place(str(template.path))):
        load_machine(machine_path(job.machine, folder)).process(job.process)
    return job
