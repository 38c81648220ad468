# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tool files of other programs by their ending: `.fctb` and `.fctl` of FreeCAD, `.tbl` of LinuxCNC."""

from __future__ import annotations

from pathlib import Path

from CNCStepper.errors import JobError, Text, joined
from CNCStepper.machine.tools.freecad_tool_bits import bit_files, read_bit, read_library, write_bit, write_library
from CNCStepper.machine.tools.linuxcnc_tool_table import read_table, write_table
from CNCStepper.machine.tools.stored_tool import StoredTool

ENDINGS = (".fctb", ".fctl", ".tbl")


def read_tools(path: Path, unit_mm: float = 1.0) -> list[StoredTool]:
    """Return the tools of a file; `unit_mm` is the length of the unit of a `.tbl`, which does not say it.

    Raises JobError for a file that is none of these.
    """
    ending = _ending(path)
    if ending == ".tbl":
        return read_table(path, unit_mm)
    return read_library(path) if ending == ".fctl" else [read_bit(path)]


def write_tools(tools: list[StoredTool], path: Path, unit_mm: float = 1.0) -> list[str]:
    """Write tools into a file, a library with its bits; return what of them the file does not hold.

    Raises JobError for a file that is none of these, and for several tools in one `.fctb`.
    """
    ending = _ending(path)
    unknown: list[str] = [
        Text(
            "tool {each_number} '{each}' is left out: {notes}",
            each_number=each.number,
            each=each.name,
            notes=joined("; ", each.notes),
        )
        for each in _foreign(tools, ending)
    ]
    kept = [each for each in tools if each not in _foreign(tools, ending)]
    if ending == ".tbl":
        return unknown + write_table(kept, path, unit_mm)
    if ending == ".fctl":
        write_library(kept, path)
    elif len(kept) == 1:
        write_bit(kept[0], path)
    else:
        advice = "write a library, with the ending .fctl"
        raise JobError("tool-bit", "a tool bit is one tool", value=f"{len(kept)} tools", limit="1", advice=advice)
    return unknown


def files_of(tools: list[StoredTool], path: Path) -> list[Path]:
    """Return every file that `write_tools` writes: a library has one more a tool."""
    ending = _ending(path)
    kept = [each for each in tools if each not in _foreign(tools, ending)]
    return [path, *(bit_files(kept, path) if ending == ".fctl" else ())]


def _foreign(tools: list[StoredTool], ending: str) -> list[StoredTool]:
    """Return the tools that we do not understand and that come from a file of another kind."""
    own = "words" if ending == ".tbl" else "parameter"
    return [each for each in tools if each.tool is None and own not in each.raw]


def _ending(path: Path) -> str:
    ending = path.suffix.lower()
    if ending not in ENDINGS:
        advice = Text("give a file that ends in {endings}", endings=", ".join(ENDINGS))
        raise JobError("tools-kind", Text("'{path}' is no tool file that is known", path=path.name), advice=advice)
    return ending
