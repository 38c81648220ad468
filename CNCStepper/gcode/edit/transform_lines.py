# SPDX-License-Identifier: LGPL-2.1-or-later
"""Puts the path of a program elsewhere by changing words in place: comments, order and form stay as they are written.

    G1 X10.5 Y#1 (edge)    offset by X 2   ->   G1 X12.5 Y#1 (edge)
    G91 X0.333             scale by 2      ->   G91 X0.666      what rounding leaves is carried to the next way

An axis is *free* until a coordinate of the work is said for it: it stands where the machine stood, which no edit moves.
"""

from __future__ import annotations

from CNCStepper.gcode.edit.edit_result import Edited
from CNCStepper.gcode.edit.executed_lines import EXPAND, Meaning, Source
from CNCStepper.gcode.edit.line_edits import Line
from CNCStepper.gcode.edit.line_tokens import changed
from CNCStepper.gcode.edit.path_transforms import Map
from CNCStepper.gcode.edit.transform_state import TransformState
from CNCStepper.gcode.edit.verification import verified


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
        what = "this line is not executed (deleted, after the end or not led to): what it means is not known"
        raise source.refusal(number, "edit-skipped", what, value=text.strip()[:40], advice="take it out")
