# SPDX-License-Identifier: LGPL-2.1-or-later
"""The `[[tool]]` tables of a template as rows that are edited; no Qt.

Where the template has `tools = FILE` too, a row may hold only what it says otherwise than that file.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.machine.libraries.table_draft import Problems, Values
from CNCStepper.machine.libraries.tool_library import NEEDED, NUMBER, ToolTable, given_values, tool_columns
from CNCStepper.machine.tools.tool_shapes import SHAPES
from CNCStepper.workbench.templates.draft import Draft

MADE = ("shape", "diameter_mm")  # a row without them takes them from the template's tool file


class TemplateTools(ToolTable):
    """The tools of a template while it is changed; `save` puts them into its draft."""

    def __init__(self, draft: Draft):
        self._draft = draft
        self._may_be_parts = "tools" in draft.content
        self.columns = tool_columns(SHAPES, (NUMBER,) if self._may_be_parts else NEEDED)

    def rows(self) -> list[tuple[Values, Any]]:
        """Return the tools of the draft, each with the keys that no tool has."""
        known = {column.key for column in self.columns}
        return [(tool, {key: tool[key] for key in tool if key not in known}) for tool in self._draft.tools]

    def judge(self, rows: Sequence[Values]) -> Problems:
        """Return what is wrong with tools; of a part only its number, since the file gives the rest."""
        problems = super().judge(rows)
        parts = {number for number, row in enumerate(rows) if any(row[key] is None for key in MADE)}
        return Problems(
            {place: told for place, told in problems.items() if place[0] not in parts or place[1] == NUMBER}
        )

    def save(self, rows: Sequence[tuple[Values, Any]]) -> Path:
        """Put the tools into the draft, and return the template's path."""
        self._draft.put_tools([given_values(values) | (kept or {}) for values, kept in rows])
        return self._draft.path

    def read(self, path: Path) -> tuple[list[tuple[Values, Any]], list[str]]:
        """Return the tools of a file, and notes on those that are left out; raises JobError."""
        rows, notes = super().read(path)
        return [(values, None) for values, _ in rows], notes

    def write(self, rows: Sequence[tuple[Values, Any]], path: Path) -> list[str]:
        """Write tools into a file of another program, and return notes on what it does not hold; raises JobError."""
        return super().write([(values, None) for values, _ in rows], path)
