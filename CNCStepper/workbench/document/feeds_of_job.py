# SPDX-License-Identifier: LGPL-2.1-or-later
"""Feeds and speeds that the material of a job object gives its tools."""

from __future__ import annotations

from typing import Any

from CNCStepper.errors import Text
from CNCStepper.machine.feeds_and_speeds import remarks_on, with_feeds
from CNCStepper.machine.materials import material
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.workbench.document.machine_of_job import machine_of


def fed(tool: Tool, job: Any) -> Tool:
    """Return a tool with the feeds and the speed that it has none of itself; raises JobError.

    job: the object of its job, None where it has none; without a material the tool stays as it is.
    """
    return with_feeds(tool, material(job.Material), machine_of(job)) if job is not None and job.Material else tool


def remarks(tool: Tool, job: Any) -> tuple[str, ...]:
    """Return what of a tool's feeds and speed is out of the range of the job's material, as sentences."""
    found = remarks_on(tool, material(job.Material), machine_of(job)) if job.Material else ()
    return tuple(
        Text("{remark}; {advice}", remark=remark.text, advice=remark.advice)
        for remark in found
        if remark.severity == "warning"
    )
