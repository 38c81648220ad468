# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tools as a table; and the user's: a tool library of FreeCAD's own form, CONFIG/cncstepper/tools/library.fctl.

Imports and exports are those of `machine/tools/tool_files.py`: `.fctb` and `.fctl` of FreeCAD, `.tbl` of LinuxCNC.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from CNCStepper.errors import Text
from CNCStepper.input_file import is_there
from CNCStepper.machine.files.profile_files import config_folder
from CNCStepper.machine.libraries.table_draft import Column, Problems, Values, doubled, model_problem
from CNCStepper.machine.profile import validated
from CNCStepper.machine.tools.freecad_tool_bits import WRITTEN, bit_files
from CNCStepper.machine.tools.stored_tool import StoredTool
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_files import ENDINGS, read_tools, write_tools

NUMBER, NAME = "number", "name"
WHOLE = ("number", "flutes")
MADE_OF = ("carbide", "hss")
NEEDED = ("number", "shape", "diameter_mm")
NEW = {"shape": "flat", "diameter_mm": 6.0, "made_of": "carbide"}


def tool_columns(shapes: Sequence[str], needed: Sequence[str] = NEEDED) -> tuple[Column, ...]:
    """Return a column for each key of a job file's `[[tool]]`, the number first."""
    choices = {"shape": tuple(shapes), "made_of": MADE_OF}
    return tuple(
        Column(
            key,
            "choice" if key in choices else "whole" if key in WHOLE else "number",
            choices.get(key, ()),
            key in needed,
        )
        for key in Tool.model_fields
    )


LIBRARY_COLUMNS = tool_columns(tuple(WRITTEN))


class ToolTable:
    """Tools as a table, a row a tool by the keys of a job file's `[[tool]]`: new rows, what is wrong, other files."""

    ENDINGS: tuple[str, ...] = ENDINGS

    def new_row(self, rows: Sequence[Values]) -> Values:
        """Return a mill with the next free number."""
        numbers = [row[NUMBER] for row in rows if row.get(NUMBER) is not None]
        return {NUMBER: max(numbers, default=0) + 1, **NEW}

    def judge(self, rows: Sequence[Values]) -> Problems:
        """Return what is wrong with tools: their values, and numbers that two have."""
        problems = doubled(rows, NUMBER)
        for number, row in enumerate(rows):
            if found := model_problem(Tool, given_values(row)):
                place, sentence = found
                problems.setdefault((number, place[0] if place else _named_key(sentence)), sentence)
        return problems

    def read(self, path: Path) -> tuple[list[tuple[Values, Any]], list[str]]:
        """Return the tools of a file with their own content, and notes on those that are left out; raises JobError."""
        stored = read_tools(path)
        notes: list[str] = [
            Text("{tool}: {note}", tool=each.name or each.number, note=note) for each in stored for note in each.notes
        ]
        return [(_values(each), each) for each in stored if each.tool is not None], notes

    def write(self, rows: Sequence[tuple[Values, Any]], path: Path) -> list[str]:
        """Write tools into a file of another program, and return notes on what it does not hold; raises JobError."""
        return write_tools([_stored(values, kept) for values, kept in rows], path)


class ToolLibrary(ToolTable):
    """The user's tools, with their names."""

    columns: tuple[Column, ...] = (LIBRARY_COLUMNS[0], Column(NAME, "text"), *LIBRARY_COLUMNS[1:])

    def rows(self) -> list[tuple[Values, Any]]:
        """Return the tools of the user's library; none where there is no file. Raises JobError for a bad one."""
        return self.read(library_path())[0] if is_there(library_path()) else []

    def save(self, rows: Sequence[tuple[Values, Any]]) -> Path:
        """Write the library whole, and delete the bits of tools that are not in it any more."""
        path = library_path()
        path.parent.mkdir(parents=True, exist_ok=True)
        stored = [_stored(values, kept) for values, kept in rows]
        write_tools(stored, path)
        for bit in set(path.parent.glob("*.fctb")) - set(bit_files(stored, path)):
            bit.unlink()
        return path


def library_path() -> Path:
    """Return the file of the user's tools, which need not be there; raises MissingPackage without platformdirs."""
    return config_folder() / "tools" / "library.fctl"


def library_tools() -> list[StoredTool]:
    """Return the user's tools in the order of the library; raises JobError for a bad file."""
    return [kept for _, kept in ToolLibrary().rows()]


def keep_tool(name: str, tool: Tool) -> int:
    """Add a tool to the user's library, under the next free number where its own is taken; return its number."""
    library = ToolLibrary()
    rows = library.rows()
    taken = [values for values, _ in rows]
    free = tool.number
    if any(values[NUMBER] == free for values in taken):
        free = library.new_row(taken)[NUMBER]
    stored = StoredTool(free, name, tool.model_copy(update={NUMBER: free}))
    library.save([*rows, (_values(stored), stored)])
    return free


def _values(stored: StoredTool) -> Values:
    """Return the values of a row; those that a tool does not give are None."""
    tool = stored.required(stored.name)
    fields = Tool.model_fields
    given = {key: value for key, value in tool.model_dump().items() if value != fields[key].default or key in NEW}
    return {**given, NUMBER: stored.number, NAME: stored.name}


def _stored(values: Values, kept: Any) -> StoredTool:
    tool = validated(Tool, given_values(values), f"tool {values[NUMBER]}")
    before = kept or StoredTool(tool.number, "", None)
    return replace(before, number=tool.number, name=values.get(NAME) or tool.words, tool=tool)


def given_values(values: Values) -> Values:
    """Return the keys of a `[[tool]]` that a row gives."""
    return {key: value for key, value in values.items() if value is not None and key != NAME}


def _named_key(sentence: str) -> str:
    """Return the key that a sentence about a whole tool names first."""
    named = [key for key in Tool.model_fields if key in sentence]
    return min(named, key=sentence.index, default=NUMBER)
