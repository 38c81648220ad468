# SPDX-License-Identifier: LGPL-2.1-or-later
"""Whether the text of a lathe program gives X as a diameter (G7) or as a radius (G8), by the codes of its dialect."""

from __future__ import annotations

from typing import Literal

from CNCStepper.gcode.dialects import dialect as dialect_named
from CNCStepper.gcode.syntax.words import program_lines, scanned_codes, split_line

XIs = Literal["diameter", "radius", "both"]
DIAMETER, RADIUS = "G7", "G8"  # of RS274/NGC; a dialect may have other names for them


def x_is(text: str, dialect: str) -> XIs:
    """Return how a program gives X: "both" where it changes between a radius and a diameter once an X was written.

    Programs begin with the radius, but where the dialect has it otherwise.
    """
    language = dialect_named(dialect)
    meanings = {name: code.name for name, code in language.codes.items()}
    modes = {name for name, meaning in meanings.items() if meaning in (DIAMETER, RADIUS)}
    used, mode = set[str](), DIAMETER if language.diameter else RADIUS
    for line in program_lines(text) if modes else ():
        code = split_line(line).code
        named = [meanings[name] for name in scanned_codes(code) & modes]
        mode = named[-1] if named else mode
        if "X" in code.upper():
            used.add(mode)
    if len(used) > 1:
        return "both"
    return "diameter" if (used or {mode}) == {DIAMETER} else "radius"


def is_lathe_program(text: str, dialect: str) -> bool:
    """Return whether a program is in the language of a lathe, or names G7 or G8, which only lathes have."""
    if dialect_named(dialect).is_lathe:
        return True
    codes = {name for name, code in dialect_named(dialect).codes.items() if code.name in (DIAMETER, RADIUS)}
    return bool(codes) and any(codes & scanned_codes(split_line(line).code) for line in program_lines(text))
