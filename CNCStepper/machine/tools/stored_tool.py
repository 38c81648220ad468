# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tool in another program's file: the keys understood, all keys kept, and notes."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from pydantic import ValidationError

from CNCStepper.errors import JobError, Place, Text, joined
from CNCStepper.machine.files.validation_errors import message_of
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.quantities import ERROR_TYPE, shown


@dataclass(frozen=True)
class StoredTool:
    """One tool of a file. tool: None where it is none of our shapes. raw: the file's own content, kept for writing.

    notes: what of it is not understood, guessed, or not written.
    """

    number: int
    name: str
    tool: Tool | None
    raw: dict[str, Any] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def required(self, file: str) -> Tool:
        """Return the tool; raises JobError where it is none that cuts here."""
        if self.tool is None:
            what = Text(
                "tool {number} '{name}' cannot be used: {notes}",
                number=self.number,
                name=self.name,
                notes=joined("; ", self.notes),
            )
            raise JobError("tool-shape", what, advice="describe it in a [[tool]] table", place=Place(file))
        return self.tool


def tool_or_note(content: dict[str, Any]) -> tuple[Tool | None, tuple[str, ...]]:
    """Return the tool of these keys, or None and why it is none."""
    try:
        return Tool.model_validate(content), ()
    except ValidationError as error:
        first = error.errors()[0]
        key = ".".join(map(str, first["loc"]))
        words = Text("{key}: {what}", key=key, what=message_of(first)) if key else message_of(first)
        words = (
            Text("{what}, not {value}", what=words, value=shown(first["input"]))
            if first["type"] == ERROR_TYPE
            else words
        )
        return None, (words,)


def given_keys(tool: Tool) -> dict[str, Any]:
    """Return the keys of a tool whose values are not the defaults."""
    fields = type(tool).model_fields
    return {key: value for key, value in tool.model_dump().items() if value != fields[key].default}
