# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools from the user's library into a job, and back."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from CNCStepper.machine.libraries.tool_library import keep_tool, library_tools
from CNCStepper.machine.tools.stored_tool import StoredTool
from CNCStepper.workbench import api
from CNCStepper.workbench.document.undo_steps import undo_step
from CNCStepper.workbench.features.tool import model_of

__all__ = ["add", "add_as_one_step", "keep", "library_tools"]


def add(job: Any, stored: Sequence[StoredTool]) -> list[Any]:
    """Return new tools of the job; a number that the job has already becomes the next free one."""
    return [api.add_stored_tool(job, each) for each in stored if each.tool is not None]


def add_as_one_step(job: Any, stored: Sequence[StoredTool], title: str) -> int:
    """Add tools as one undo step, and return how many."""
    with undo_step(job.Document, title):
        count = len(add(job, stored))
    job.Document.recompute()
    return count


def keep(tool: Any) -> int:
    """Put a copy of a tool object into the library, and return its number there; raises JobError."""
    return keep_tool(str(tool.Label), model_of(tool))
