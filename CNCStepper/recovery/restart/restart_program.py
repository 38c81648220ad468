# SPDX-License-Identifier: LGPL-2.1-or-later
"""A program from a place in its middle on, as a program of its own.

place ─► entrance ─► state there ─► approach ─► entry + the program's own lines ─► read again ─► the same rest?
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.state.model import Model
from CNCStepper.gcode.interpreter.state.parameters import offset_number
from CNCStepper.gcode.interpreter.state.stored_points import stored_point
from CNCStepper.gcode.syntax.words import is_percent_mark
from CNCStepper.recovery.restart.approach import Approach, approach_to
from CNCStepper.recovery.restart.entry_point import EntryPoint, entry_point_of
from CNCStepper.recovery.restart.equivalence import require_same_rest
from CNCStepper.recovery.restart.options import Options
from CNCStepper.recovery.restart.places import RequestedPlace, place_of
from CNCStepper.recovery.restart.preamble import EntryWriter
from CNCStepper.recovery.restart.prior_moves import cut_before
from CNCStepper.recovery.restart.program import Program, read_program
from CNCStepper.recovery.restart.remaining_lines import rest_of
from CNCStepper.state import WORK_SYSTEMS, ZERO3, Start
from CNCStepper.toolpath import Toolpath


@dataclass(frozen=True)
class Restart:
    """A restart program.

    text: the program. start: from which it is read: the work offsets that hold there, G92 none. file_lines: the line of
    the old file that each of its lines is, 0 for those of the entry. cut: the moves that are taken as done, and the
    lift after them. program, entrance, approach: what it was made from.
    """

    text: str
    start: Start
    file_lines: np.ndarray
    cut: Toolpath
    program: Program
    entrance: EntryPoint
    approach: Approach


def restart(
    text: str,
    where: RequestedPlace,
    dialect: str | Dialect = "grbl",
    start: Start | None = None,
    file: str = "",
    options: Options | None = None,
) -> Restart:
    """Return the restart of a program at a place; raises ProgramError with the reason where it cannot be."""
    return restart_of(read_program(text, dialect, start, file), where, options)


def restart_of(program: Program, where: RequestedPlace, options: Options | None = None) -> Restart:
    """Return the restart of a program that is read already, as `restart` does."""
    options = options or Options()
    entrance = entry_point_of(program, place_of(program, where), options.overlap_mm)
    model = program.model_before(entrance.first_line)
    _check_model(program, entrance, model)
    approach = approach_to(program, entrance, model, options)
    rest = rest_of(program.lines[entrance.first_line - 1 :], model, program.dialect)
    marks = ["%"] * any(map(is_percent_mark, rest))
    lines = marks + EntryWriter(program, entrance, approach, model).lines(len(marks)) + rest
    text, begin = "".join(f"{line}\n" for line in lines), _start(program, model)
    own = len(lines) - len(rest)
    require_same_rest(program, entrance, _read(text, begin, program, entrance), own)
    file_lines = np.r_[np.zeros(own, int), program.file_lines[entrance.first_line - 1 :]]
    return Restart(text, begin, file_lines, cut_before(program, entrance, approach), program, entrance, approach)


def _read(text: str, begin: Start, program: Program, entrance: EntryPoint) -> Toolpath:
    """Return the moves of the restart program; raises ProgramError where it cannot stand alone."""
    try:
        return interpret(text, begin, program.dialect)
    except ProgramError as error:
        what = f"entered here, the program does not stand alone: {error.what}"
        advice = "restart at another place, or send the whole program"
        raise program.refusal("restart-differs", what, entrance.row, value=error.value, advice=advice) from error


def _start(program: Program, model: Model) -> Start:
    """Return the start of the restart program: work offsets as the program has left them, the place unknown."""
    systems = {name: stored_point(model.parameters, offset_number(name), model.unit_mm)[:3] for name in WORK_SYSTEMS}
    old = program.start
    offsets = {name: offset for name, offset in systems.items() if any(offset) or name in old.work_offsets_mm}
    nowhere = Start().position_mm
    return replace(old, position_mm=nowhere, work_offsets_mm=offsets, g92_mm=ZERO3, tool=0, spindle_rpm=0.0)


def _check_model(program: Program, entrance: EntryPoint, model: Model) -> None:
    """Refuse states that no entry can bring back."""
    if model.diameter or model.state.surface_m_min or model.state.feed_mode == "per_turn":
        what = "turning (G7, G95, G96) is in force here: no entry is written for a lathe"
        raise program.refusal("restart-lathe", what, entrance.row, advice="send the whole program")
    if np.isnan(program.begins[entrance.row, :2]).any():
        what = "where the tool stands here is not known"
        advice = "give the work zero and the position, or choose a place after the next rapid"
        raise program.refusal("restart-place-unknown", what, entrance.row, advice=advice)
