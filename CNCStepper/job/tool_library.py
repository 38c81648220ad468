# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tools of a job in a file of their own: `tools = "shop.fctl"` beside the `[[tool]]` tables.

    tools = "shop.fctl"                                   FreeCAD's library, or one bit: "mill.fctb"
    tools = { file = "tool.tbl", unit_mm = 25.4 }         LinuxCNC's table; its unit is a mm where nothing is said

The job has those that its operations use. A `[[tool]]` with the number of one of them says more of it, or other than
the file: feeds and speed, which these files do not have.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.machine.profile import validated
from CNCStepper.machine.tools.stored_tool import StoredTool, given_keys
from CNCStepper.machine.tools.tool_files import read_tools
from CNCStepper.quantities import Unit


class ToolFile(BaseModel):
    """The key `tools` of a job file."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    file: str
    unit_mm: Unit = 1.0


def take_tool_file(content: dict[str, Any], path: Path) -> None:
    """Replace the key `tools` of a job's content by `[[tool]]` tables, and note what of them was guessed.

    Raises JobError that names the file, and a tool that an operation uses and that is not there, or is none of ours.
    """
    told = content.pop("tools")
    form = validated(ToolFile, {"file": told} if isinstance(told, str) else told, f"{path} tools")
    own = _by_number(content.get("tool", []), path)
    used = {operation.tool for operation in content["operation"]}
    notes = []
    for stored in read_tools(path.parent / form.file, form.unit_mm):
        if stored.number in used:
            own[stored.number] = _keys(stored, own.get(stored.number, {}), form.file)
            notes += [
                Text(
                    "tool {stored_number} of {form_file}: {note}",
                    stored_number=stored.number,
                    form_file=form.file,
                    note=note,
                )
                for note in stored.notes
            ]
    for number in sorted(used - set(own)):
        what = Text(
            "an operation uses tool {number}, which neither the job nor {form_file} has",
            number=number,
            form_file=form.file,
        )
        raise JobError("tool-missing", what, advice="describe it in a [[tool]] table", place=Place(str(path)))
    content["tool"] = [own[number] for number in sorted(own)]
    content["notes"] = (*content.get("notes", ()), *notes)


def _keys(stored: StoredTool, own: dict[str, Any], file: str) -> dict[str, Any]:
    if "shape" in own and "diameter_mm" in own:
        return own
    return given_keys(stored.required(file)) | own


def _by_number(tables: Any, path: Path) -> dict[int, dict[str, Any]]:
    if not isinstance(tables, list) or not all(isinstance(table, dict) and "number" in table for table in tables):
        raise JobError("bad-value", "tool must be a list of tables with a number", place=Place(str(path)))
    if len({table["number"] for table in tables}) < len(tables):
        raise JobError("bad-value", "two tools have the same number", place=Place(str(path)))
    return {table["number"]: table for table in tables}
