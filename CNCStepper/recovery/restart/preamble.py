# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lines that lead a machine, whatever it holds, to the entrance and into the state that the program has there.

(restart of part.nc at line 812)  (begin operation: pocket)
M5 M9                        nothing runs while the tool goes up
G21 G17 G90 ... G54  G92.1   known modes; offsets of G92 are set again below
G43.1 Z..                    the length of the tool
G0 Z12.                      up
T2 M6                        where tools are changed so
G0 X10. Y5.                  over
G92 X.. Y.. Z..              where the program had one in force
S12000 M3  M8  G4 P3         a beam is switched on down there
G1 Z-2. F200                 down
G2 X.. Y.. I.. J..           the rest of a move that is entered in its middle
G91 G18 F800                 the modes of the place
"""

from __future__ import annotations

from collections.abc import Sequence
from math import isnan
from pathlib import PurePath

from CNCStepper.errors import Text
from CNCStepper.gcode.dialects.codes import AXES, CODE_OF_PLANE, MOTION_NAMES, NO_MOTION, PLANE_CODES, UNIT_CODES
from CNCStepper.gcode.edit.line_tokens import tokens_of
from CNCStepper.gcode.edit.word_values import MOST_DECIMALS, dialect_decimals, number_text
from CNCStepper.gcode.interpreter.state.interpreter_state import Model
from CNCStepper.gcode.interpreter.state.modal_state_stack import OVERRIDES, PATH_MODES, RETRACT_MODES, modal_words
from CNCStepper.gcode.writer.block_emitter import comment_lines
from CNCStepper.gcode.writer.state_changes import SPINDLE_CODES
from CNCStepper.recovery.restart.approach import Approach
from CNCStepper.recovery.restart.entry_point import EntryPoint
from CNCStepper.recovery.restart.interrupted_program import Program
from CNCStepper.tolerances import SAME_MM
from CNCStepper.toolpath import LINE, PLANE_AXES
from CNCStepper.units import UNIT_MM

MORE_DECIMALS = {"mm": 2, "inch": 3}  # than programs have, so that a place within a move lies on it
CENTRES = "IJK"
_MODES = tuple(sorted(PATH_MODES | RETRACT_MODES | OVERRIDES))


class EntryWriter:
    """Writes the entry of one program; `model`: what holds before the first of the program's own lines that follow."""

    def __init__(self, program: Program, entrance: EntryPoint, approach: Approach, model: Model):
        self.program = program
        self.entrance = entrance
        self.approach = approach
        self.model = model
        self.state = model.state
        self.dialect = program.dialect
        self.unit_mm = UNIT_MM[self.state.units]
        self.decimals = dialect_decimals(self.dialect, self.state.units) + MORE_DECIMALS[self.state.units]

    def lines(self, marks: int = 0) -> list[str]:
        """Return the lines, in their order; `marks`: how many lines come before them."""
        switched = self._switched_on()
        before, after = ([], self._pierced(switched)) if self.approach.is_beam else (switched, [])
        found = ["M5 M9", *self._modes(), *self._up(), *self._tool(), *self._over(), *self._outputs()]
        found += [*before, *self._down(), *after, *self._rest_of_move(), *self._modes_there()]
        found = [line for line in found if line]
        return [*self._title(marks + len(found)), *found]

    def _title(self, more: int) -> list[str]:
        """Return the comments before an entry; `more`: the lines that stand before the program's own beside them."""
        program, name = self.program, PurePath(self.program.file).name or "a program"
        title = comment_lines(
            Text("restart of {name} at line {file_line}", name=name, file_line=program.file_line(self.entrance.row))
        )
        operations = [Text("begin operation: {name}", name=name) for name in self.model.operations]
        if self.entrance.first_line <= len(program.lines):
            own = len(title) + len(operations) + 1 + more + 1
            title.append(
                Text(
                    "line {own} here is its line {file_line}",
                    own=own,
                    file_line=program.file_lines[self.entrance.first_line - 1],
                )
            )
        return [f"({text})" for text in (*title, *operations)]

    def _modes(self) -> list[str]:
        """Return the modes of a fresh controller, with the units and the work system of the place."""
        assert self.dialect.writing is not None  # `read_program` has asked
        units = UNIT_CODES[self.state.units]
        header = [line.format(units=units) for line in self.dialect.writing.header]
        shifted = any(self.state.g92_mm) or any(self.program.start.g92_mm)
        return [*header, self.state.work_system, "G92.1" * shifted, *modal_words(self.model, self._said())]

    def _said(self) -> set[str]:
        """Return which of the modes that no row shows the program names."""
        likely = (line for line in self.program.lines if "G6" in line or "G9" in line or "M4" in line or "M5" in line)
        return {token.name for line in likely for token in tokens_of(line)}.intersection(_MODES)

    def _up(self) -> list[str]:
        """Return the tool's length, and the rapid that lifts it."""
        length_mm = self.state.tool_length_mm
        by_word = "G43.1" in self.dialect.codes
        length = f"G43.1 Z{self._number(length_mm)}" if by_word else f"G43 H{self.state.tool}"
        safe = "" if isnan(self.approach.safe_mm) else f"G0 Z{self._number(self._unshifted(2, self.approach.safe_mm))}"
        return [length * bool(length_mm), safe]

    def _tool(self) -> list[str]:
        """Return the words that name the tool; an M6 only where a T does not change it."""
        tool, selected = self.state.tool, self.model.selected_tool
        if not tool:
            return [f"T{selected}"] if selected and "T" in self.dialect.letters else []
        changes = "M6" in self.dialect.codes and not self.dialect.tool_word_changes
        later = f"T{selected}" if selected not in (0, tool) else ""
        return [f"T{tool} M6" if changes else f"T{tool}", later]

    def _over(self) -> list[str]:
        """Return the rapid to above the entrance, and the G92 that is in force there.

        The same place in the numbers of that G92 follows: a circle that begins there must close to the last bit.
        """
        x, y, _ = self.approach.at_mm
        over = [self._unshifted(0, x), self._unshifted(1, y)]
        found = [" ".join(["G0", *self._words(over)])]
        if any(self.state.g92_mm):
            place = self.model.work((x, y, self.approach.safe_mm))
            found += [" ".join(["G92", *self._words(place)]), " ".join(["G0", *self._words(place[:2])])]
        return found

    def _outputs(self) -> list[str]:
        """Return the last word for each output that the program has switched."""
        last: dict[str, str] = {}
        first = self.entrance.first_line
        for event in self.program.path.events:
            if event.kind == "output" and event.line < first:
                code, number, *_ = event.text.split()
                last[code[:2] + number] = event.text
        return list(last.values())

    def _switched_on(self) -> list[str]:
        """Return spindle or beam and coolant as they are at the place, and the wait for them."""
        state, dialect = self.state, self.dialect
        has_speed = state.spindle_rpm and dialect.power == "speed"
        speed = f"S{number_text(state.spindle_rpm, 3)}" if has_speed else ""
        on = SPINDLE_CODES.get(state.spindle, "")
        coolant = ["M7"] * state.mist + ["M8"] * state.flood
        wait_s = self.approach.dwell_s
        wait = f"G4 {dialect.dwell_letter}{number_text(wait_s / dialect.dwell_unit_s, 3)}" if wait_s else ""
        return [" ".join(word for word in (on, speed) if word), *coolant, wait]

    def _down(self) -> list[str]:
        if not self.approach.plunge_mm_min:
            return []
        return [self._down_to(self.approach.pierce_mm)]

    def _pierced(self, switched: list[str]) -> list[str]:
        """Return the lines that switch a beam on, and those from its pierce height down to the cut."""
        z = self.approach.at_mm[2]
        return [*switched, self._down_to(z)] if self.approach.pierce_mm > z + SAME_MM else switched

    def _down_to(self, z_mm: float) -> str:
        feed = self.approach.plunge_mm_min or float(self.program.table.feed[self.entrance.row])
        return f"G1 Z{self._number(self._work(2, z_mm))} F{self._feed(feed)}"

    def _rest_of_move(self) -> list[str]:
        """Return the rest of the move that is entered in its middle, in absolute coordinates."""
        row, table = self.entrance.row, self.program.table
        if not self.entrance.share:
            return []
        kind, plane = int(table.kind[row]), int(table.plane[row])
        end = self.model.work(tuple(table.end[row, :3].tolist()))
        feed = f"F{self._feed(float(table.feed[row]))}"
        if kind == LINE:
            return [" ".join(["G1", *self._words(end), feed])]
        to_centre = table.centre[row] - self.approach.at_mm
        arms = [f"{CENTRES[axis]}{self._number(to_centre[axis])}" for axis in sorted(PLANE_AXES[plane][:2])]
        return [" ".join([PLANE_CODES[plane], MOTION_NAMES[kind], *self._words(end), *arms, feed])]

    def _modes_there(self) -> list[str]:
        """Return the modes in which the program's own lines are to be read."""
        state, model = self.state, self.model
        wanted = [
            CODE_OF_PLANE[state.plane],
            "G90" if model.absolute else "G91",
            "G90.1" if state.arc_centres == "absolute" else "G91.1",
            "G93" if state.feed_mode == "inverse_time" else "G94",
        ]
        row, in_arc = self.entrance.row, self.entrance.share and self.program.table.kind[self.entrance.row] > LINE
        held = {PLANE_CODES[int(self.program.table.plane[row])] if in_arc else "G17", "G90", "G91.1", "G94"}
        words = [word for word in wanted if word not in held and word in self.dialect.codes]
        return [self._feed_there(), " ".join(words), "G80" * (model.motion == NO_MOTION)]

    def _feed_there(self) -> str:
        """Return the F of the place, which G93 would no longer take, where the entry has not just said it."""
        row, wanted = self.entrance.row, self.state.feed_mm_min
        held = float(self.program.table.feed[row]) if self.entrance.share else self.approach.plunge_mm_min
        return f"F{self._feed(wanted)}" if wanted and wanted != held else ""

    # numbers of the text

    def _work(self, axis: int, machine_mm: float) -> float:
        """Return a machine coordinate as a work coordinate, mm."""
        return machine_mm - self.state.offset_mm[axis]

    def _unshifted(self, axis: int, machine_mm: float) -> float:
        """Return a machine coordinate as a work coordinate without G92, mm."""
        return self._work(axis, machine_mm) + self.state.g92_mm[axis]

    def _words(self, place: Sequence[float]) -> list[str]:
        """Return the words of a place, mm, for the axes along which it is known."""
        known = [(AXES[axis], value) for axis, value in enumerate(place) if not isnan(value)]
        return [f"{letter}{self._number(value)}" for letter, value in known if letter in self.dialect.letters]

    def _number(self, length_mm: float) -> str:
        return number_text(length_mm / self.unit_mm, self.decimals)

    def _feed(self, feed_mm_min: float) -> str:
        return number_text(feed_mm_min / self.unit_mm, MOST_DECIMALS)
