# SPDX-License-Identifier: LGPL-2.1-or-later
"""The verbs that move, scale, turn and mirror the path of a program, or write it in the other unit.

Puts the path of a program elsewhere by changing words in place: comments, order and form stay as they are written.

    G1 X10.5 Y#1 (edge)    offset by X 2   ->   G1 X12.5 Y#1 (edge)
    G91 X0.333             scale by 2      ->   G91 X0.666      what rounding leaves is carried to the next way

An axis is *free* until the program gives it a work coordinate: it stays at the machine's start, which no edit moves.
"""

from __future__ import annotations

import numpy as np

from CNCStepper.errors import CNCStepperError, Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import UNIT_CODES
from CNCStepper.gcode.edit import path_transforms
from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.line_edits import Line
from CNCStepper.gcode.edit.line_states import EXPAND, Meaning, Source
from CNCStepper.gcode.edit.line_tokens import changed
from CNCStepper.gcode.edit.path_transforms import Map, TransformState
from CNCStepper.gcode.edit.verification import verified
from CNCStepper.gcode.interpreter.state.interpreter_state import model_at
from CNCStepper.gcode.lathe.diameter_mode import is_lathe_program
from CNCStepper.gcode.syntax.words import split_line
from CNCStepper.state import Start


def transformed(source: Source, where: Map) -> Edited:
    """Return the program whose path lies where the map puts it; raises ProgramError naming the line that cannot."""
    state = TransformState(source, where)
    lines = [_line(state, number, text, meaning) for number, text, meaning in source]
    return verified(source, source.lines.edited(lines), where, state.free_rows, state.step_mm)


def _line(state: TransformState, number: int, text: str, meaning: Meaning | None) -> str:
    """Return the new text of a line."""
    source = state.source
    if meaning is None:
        _check_skipped(source, number)
        return text
    tokens = source.tokens(number)
    if number in source.doubtful and any(token.letter in "XYZIJKRQ" for token in tokens):
        what = "this line is executed in modes that differ from one time to the next"
        raise source.refusal(number, "edit-doubtful", what, value=text.strip()[:40], advice=EXPAND)
    edits = Line(state, number, meaning, tokens).edits()
    state.free_rows[number] = tuple(state.free)
    return changed(text, edits) if edits else text


def _check_skipped(source: Source, number: int) -> None:
    text = source.lines.lines[number - 1]
    if text.strip() != "%" and any(token.letter in "XYZIJKRF" for token in source.tokens(number)):
        what = "this line is not executed (deleted, after the end, or never reached), so that its meaning is unknown"
        raise source.refusal(number, "edit-skipped", what, value=text.strip()[:40], advice="take it out")


def offset(
    text: str,
    x_mm: float = 0.0,
    y_mm: float = 0.0,
    z_mm: float = 0.0,
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
) -> Edited:
    """Return the program with its path moved; raises ProgramError for a line that cannot be."""
    return transformed(Source(text, dialect, start, file), path_transforms.moved(x_mm, y_mm, z_mm))


def scale(
    text: str,
    x: float,
    y: float | None = None,
    z: float | None = None,
    about_mm: tuple[float, ...] = (0.0, 0.0, 0.0),
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
) -> Edited:
    """Return the program with its path scaled about a point, all axes by `x` where the others are not given.

    Feeds stay. Raises ProgramError for a line that cannot be scaled: arcs need one factor in their plane.
    """
    where = path_transforms.scaled(x, x if y is None else y, x if z is None else z, about_mm)
    return transformed(Source(text, dialect, start, file), where)


def rotate(
    text: str,
    angle_deg: float,
    about_mm: tuple[float, ...] = (0.0, 0.0),
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
) -> Edited:
    """Return the program with its path turned counter-clockwise about Z; refuses arcs of G18 and G19."""
    return transformed(Source(text, dialect, start, file), path_transforms.rotated(angle_deg, about_mm))


def mirror(
    text: str,
    axis: str,
    at_mm: float = 0.0,
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
) -> Edited:
    """Return the mirror image: X (or Y) changes its sign, seen from where it is `at_mm`; arcs turn the other way.

    Raises ProgramError for the X of a lathe's program.
    """
    if axis.upper() == "X" and is_lathe_program(text, dialect_named(dialect).name):
        what = "the mirror image of a lathe's X lies over the axis"
        advice = "a turret in front of the axis takes the same program; to move the path use offset"
        raise ProgramError("edit-mirror", what, value="X", advice=advice, place=Place(file, 1, 1))
    return transformed(Source(text, dialect, start, file), path_transforms.mirrored(axis, at_mm))


def convert_units(
    text: str, units: str, dialect: str | Dialect = "grbl", start: Start | None = None, file: str = ""
) -> Edited:
    """Return the program in "mm" or "inch", with G21 or G20 before its first words where it has none there.

    Raises ProgramError for a dialect that has one unit only, and for a line whose lengths cannot be told.
    """
    language = dialect_named(dialect)
    if UNIT_CODES[units] not in language.codes:
        what = Text("programs of {language} are in one unit only", language=language.title)
        raise ProgramError("edit-units", what, value=UNIT_CODES[units], advice="leave its unit as it is")
    source = Source(text, language, start, file)
    at = _place_of_unit_word(source)
    if at is None:
        return transformed(source, Map(np.eye(3), np.zeros(3), units))
    lines = list(source.lines.lines)
    lines.insert(at, UNIT_CODES[start_units(source)])
    said = Source(source.lines.edited(lines).text, language, start, file)
    try:
        edited = transformed(said, Map(np.eye(3), np.zeros(3), units))
    except ProgramError as error:
        raise _without_line(error, at + 1, file) from None
    origins = [*range(1, at + 1), at + 1, *range(at + 1, len(lines))]
    return Edited(text, edited.text, tuple(origins))


def _without_line(error: ProgramError, number: int, file: str) -> CNCStepperError:
    """Return a refusal with its place in the text that lacks a line, the inserted one."""
    place = error.place
    if place is None or place.file != file or place.line <= number:
        return error
    return error.at(Place(place.file, place.line - 1, place.column))


def start_units(source: Source) -> str:
    """Return the units in which a program begins."""
    return model_at(source.start or Start(), source.dialect).state.units


def _place_of_unit_word(source: Source) -> int | None:
    """Return before which line (from 0) a unit word is needed; None where the program has one in time."""
    first = None
    for number, text, _ in source:
        code = split_line(text).code.strip()
        if not code or code == "%":
            continue
        first = number - 1 if first is None else first
        tokens = source.tokens(number)
        says = any(token.name in UNIT_CODES.values() for token in tokens)
        if says and not (any(token.letter == "F" for token in tokens) and not source.dialect.feed_in_new_units):
            return None
        if any(token.letter in "XYZUVWIJKRQDPF" for token in tokens) or not source.firsts:
            return first
    return None
