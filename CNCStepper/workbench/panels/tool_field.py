# SPDX-License-Identifier: LGPL-2.1-or-later
"""The field that chooses the tool that cuts an operation."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.operation import jobs_of
from CNCStepper.workbench.panels.choice_labels import words_of
from CNCStepper.workbench.panels.fields import ChoiceField


class ToolField(ChoiceField):
    """One of the job's tools."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the tools of the job that holds the operation."""
        jobs = jobs_of(self.obj)
        return [(tool, tool_words(tool)) for tool in (jobs[0].Tools if jobs else [])]


def tool_words(tool: Any) -> str:
    """Return how a tool is listed: its number, form and diameter, and its own name where it was given one."""
    from CNCStepper.workbench.panels.unit_values import text_of

    diameter = next(entry for entry in tool.Proxy.PROPERTIES if entry.key == "diameter_mm")
    own = "" if tool.Label.startswith("Tool") else f" – {tool.Label}"
    return f"T{tool.Number}  {text_of(tool.Diameter.Value, diameter)}  {words_of(tool.ToolShape)}{own}"
