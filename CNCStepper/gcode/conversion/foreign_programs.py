# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which conversion makes a program of another controller one that a machine's own controller reads.

A CAM program with M6, "%" or words of axes that never turn is refused by grbl; read as LinuxCNC, ISO or Mach means it
and rewritten it is the same work.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.conversion.convert import Converted, convert
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.syntax.words import program_lines
from CNCStepper.gcode.wire.read_back import refused_lines
from CNCStepper.state import Start
from CNCStepper.toolpath import Toolpath

NOTHING = Converted("", (), Toolpath(Start(), [], []))
SOURCES = ("linuxcnc", "iso", "mach")  # in which a foreign program is tried to be read, in this order


@dataclass(frozen=True)
class Conversion:
    """A conversion that was tried and whose result is read without a refusal. source: the dialect it was read in.

    tool_length: "" where the lengths of tools are kept as they are.
    """

    source: str
    target: str
    tool_change: str
    tool_length: str
    made: Converted


def conversion_of(
    text: str,
    target: str,
    start: Start | None = None,
    file: str = "",
    tool_change: str = "pause",
    tool_length: str = "none",
) -> Conversion | None:
    """Return what converts a program that `target` refuses, None for one that it reads as it is.

    tool_change: the machine's rule, "pause", "split" or "m6". tool_length: its rule too; "touch_off" lets the operator
    zero each tool, so that a program may name tools whose lengths nobody has said. Raises the ProgramError of the first
    dialect that can read the program where no conversion helps, such as real moves of a rotary axis.
    """
    if next(refused_lines(text, start, target, file), None) is None:
        return None
    reasons = list[ProgramError]()
    for source in (name for name in SOURCES if name != target):
        for lengths in ("", "touch_off") if tool_length == "touch_off" else ("",):
            found = _tried(Conversion(source, target, tool_change, lengths, NOTHING), text, start, file)
            if isinstance(found, Conversion):
                return found
            reasons.append(found)
            if found.code != "tool-length":
                break
    raise reasons[0]


def _tried(wanted: Conversion, text: str, start: Start | None, file: str) -> Conversion | ProgramError:
    """Return a conversion with what it makes, or why it is none."""
    more: dict[str, Any] = {"tool_length": wanted.tool_length} if wanted.tool_length else {}
    try:
        made = convert(text, wanted.source, wanted.target, start, file, tool_change=wanted.tool_change, **more)
        refused = next(refused_lines(made.text, start, wanted.target, file), None)
    except ProgramError as error:
        return error
    return refused or replace(wanted, made=made)


def converted(
    text: str,
    dialect: str = "grbl",
    start: Start | None = None,
    file: str = "",
    tool_change: str = "pause",
    tool_length: str = "none",
) -> Edited:
    """Return the edit that makes a foreign program one of `dialect`; a program that needs none stays as it is.

    Raises ProgramError as `conversion_of` does.
    """
    try:
        found = conversion_of(text, dialect, start, file, tool_change, tool_length)
    except ProgramError as error:
        what = Text(
            "no conversion makes this a program for {dialect_named}: {error}",
            dialect_named=dialect_named(dialect).title,
            error=error.sentence,
        )
        advice = "change that, or let the CAM program write it for this controller"
        raise ProgramError("not-convertible", what, place=error.place or Place(file), advice=advice) from error
    lines = program_lines(text)
    made = text if found is None else found.made.text
    origins = (min(number, len(lines)) for number in range(1, len(program_lines(made)) + 1))
    return Edited(text, made, tuple(origins))
