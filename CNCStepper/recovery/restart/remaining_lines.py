# SPDX-License-Identifier: LGPL-2.1-or-later
"""The program's own lines from the entry point on, unchanged but for a motion word named before them.

program   G1 X10 F800  /  X20  /  X30           entered at X20, after a plunge or an arc of the entry
rest                      G1 X20  /  X30        the first line that moves names what was modal
"""

from __future__ import annotations

from CNCStepper.canned_drilling import OWN_WORD
from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.dialects.codes import ALL_AXES, CYCLES, MOTION_NAMES, NO_MOTION
from CNCStepper.gcode.edit.line_tokens import Token, changed, first_place, tokens_of
from CNCStepper.gcode.edit.number_format import MOST_DECIMALS, number_text
from CNCStepper.gcode.interpreter.state.model import Model
from CNCStepper.gcode.syntax.words import is_percent_mark, split_line

_MOVING = frozenset((*ALL_AXES, *"IJKR@^"))


def rest_of(lines: list[str], model: Model, dialect: Dialect) -> list[str]:
    """Return the lines that follow the entry; `model`: what holds before them."""
    found = _first_bare_move(lines, dialect)
    if found is None or model.motion == NO_MOTION:
        return lines
    index, tokens = found
    words = " ".join([MOTION_NAMES[model.motion], *_sticky(model, tokens)])
    place = first_place(lines[index])
    return [*lines[:index], changed(lines[index], [(place, place, f"{words} ")]), *lines[index + 1 :]]


def _first_bare_move(lines: list[str], dialect: Dialect) -> tuple[int, list[Token]] | None:
    """Return the first line that moves and its words, where no line up to it names a motion; else None."""
    for index, line in enumerate(lines):
        if is_percent_mark(line) or (dialect.skips_deleted and split_line(line).deleted):
            continue
        try:
            tokens = tokens_of(line)
        except ProgramError:  # the interpreter has read it, so it is no move but a sign of the dialect's own
            continue
        codes = [dialect.codes[token.name] for token in tokens if token.name in dialect.codes]
        if any(code.motion is not None for code in codes):
            return None
        if _MOVING.intersection(token.letter for token in tokens) and not any(code.axes for code in codes):
            return index, tokens
    return None


def _sticky(model: Model, tokens: list[Token]) -> list[str]:
    """Return the words of a modal canned cycle that stick, where the line does not say them itself."""
    if model.motion not in CYCLES or model.run is None:
        return []
    own = OWN_WORD.get(MOTION_NAMES[model.motion], "")
    stuck = {"Z": model.run.z, "R": model.run.r} | ({own: model.run.own} if own else {})
    said = {token.letter for token in tokens}
    return [f"{letter}{number_text(value, MOST_DECIMALS)}" for letter, value in stuck.items() if letter not in said]
