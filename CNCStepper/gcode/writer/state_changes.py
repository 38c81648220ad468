# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes changes of state between moves: tool, spindle, coolant, work offset.

A tool change is never a bare T. By the options, after the retract:

    pause    M5 M9   (MSG, change to tool 2: ball 2 mm)   M0   T2      [length]   M3 S   G4
    m6       M5 M9                                             T2 M6   [length]   M3 S   G4

    [length]   touch_off   the message adds: then set the Z zero with it
               table       G43 H2, or G43.1 Z with the length itself where the controller keeps no table
               none        nothing: all tools stand out equally far
"""

from __future__ import annotations

from CNCStepper.errors import ProgramError, Text
from CNCStepper.gcode.dialects import Dialect
from CNCStepper.gcode.writer.block_emitter import BlockEmitter, comment_lines
from CNCStepper.gcode.writer.write_options import WriteOptions
from CNCStepper.state import State

TOUCH_OFF = ", then set the Z zero with it"
SPINDLE_CODES = {"cw": "M3", "ccw": "M4"}
M_PER_FOOT = 0.3048
LASTING = ("spindle", "coolant")  # what stays on over many moves


class Switches:
    """Writes the words that bring the machine from its present state to another one.

    own_lengths: the table's states name the tools' lengths themselves. length_mm: the one that the text has set.
    """

    def __init__(self, page: BlockEmitter, options: WriteOptions, own_lengths: bool = False):
        self.page = page
        self.dialect = dialect = page.dialect
        self.writing = page.writing
        self.options = options
        self.own_lengths = own_lengths and options.tool_length != "touch_off" and has_lengths(dialect)
        self.tool = 0
        self.work_system = ""
        self.length_mm = 0.0
        self._spindle = ("off", 0.0)
        self._surface = (0.0, 0.0)  # m/min of G96, and the highest speed in rpm
        self._coolant = (False, False)  # mist, flood
        self._owed_s = 0.0  # dwell that the spindle still needs
        self.goes_on = False  # whether the next row cuts on
        self._on_at = -1  # lines before the power was wanted, where it is on from the begin
        for number, description in options.tools.items():
            page.own_comments.update(comment_lines(tool_comment(number, description)))

    @property
    def own_events(self) -> tuple[str, ...]:
        """The events before a tool change that belong to it: prompts to the operator."""
        if self.options.tool_change != "m6":
            return "message", "pause"
        return ("message",) if self.options.tool_length == "touch_off" else ()

    def begin(self) -> None:
        """Write the lines after the header."""

    def material(self, text: str) -> None:
        """Write a change of material, where the controller has materials."""

    def before_move(self, kind: int) -> None:
        """Switch what must be so before a row of that kind."""

    def before_end(self) -> None:
        """Switch the outputs that the footer does not."""

    def follow(self, state: State) -> None:
        """Switch spindle, coolant and length offset as `state` has them."""
        self.run(state)
        if self.own_lengths and state.tool_length_mm != self.length_mm:
            self._measure(state.tool, state.tool_length_mm)

    def run(self, state: State) -> None:
        """Switch spindle and coolant as `state` has them: what does not move needs no length."""
        self._turn_spindle(state)
        on = state.spindle != "off"
        mist = state.mist or (on and self.options.coolant == "mist")
        flood = state.flood or (on and self.options.coolant == "flood")
        self._pour(mist, flood)

    def use_work_system(self, name: str) -> bool:
        """Select a work offset; whether it was another one."""
        if name == self.work_system:
            return False
        systems = self.writing.work_systems
        if not systems and not self.work_system:
            self.work_system = name
            return True
        if name not in systems:
            what = Text("{dialect} has no work offset {name}", dialect=self.dialect.title, name=name)
            advice = Text("use {ways}", ways=", ".join(systems)) if systems else "use one work offset"
            raise ProgramError("work-system", what, value=name, advice=advice)
        self.work_system = name
        self.page.line(name)
        return True

    def load(self, tool: int, message: str, length_mm: float, first: bool) -> None:
        """Change to `tool`; the `first` one is named only, for later ones the operator is asked."""
        if tool > self.dialect.largest_tool:
            limit = Text("at most {largest_tool}", largest_tool=self.dialect.largest_tool)
            what, advice = "the tool number is too large", "give the tool a smaller number"
            raise ProgramError("tool-number", what, value=f"T{tool}", limit=limit, advice=advice)
        description = self.options.tools.get(tool, "")
        by_m6 = self.options.tool_change == "m6" or not self.dialect.tool_word_changes
        if by_m6 or not first:
            self.all_off()
        self._ask(tool, description, message, first)
        if description:
            self.page.comment(tool_comment(tool, description), own=True)
        if self.dialect.turret:
            self.page.line(f"T{tool:02d}{tool:02d}")
        elif "T" in self.dialect.letters:
            self.page.line(f"T{tool}", "M6" if by_m6 else "")
        if self.own_lengths:
            self._measure(tool, length_mm)
        elif self.options.tool_length == "table":
            self._measure(tool, self.options.tool_lengths_mm.get(tool))
        self.page.forget()  # the operator or the tool changer may have moved the axes
        self.tool = tool

    def _ask(self, tool: int, description: str, message: str, first: bool) -> None:
        """Let the operator change the tool."""
        touch_off = not first and self.options.tool_length == "touch_off"
        pauses = not first and self.options.tool_change != "m6"
        if touch_off or pauses:
            asked = f"change to tool {tool}" + f": {description}" * bool(description) + TOUCH_OFF * touch_off
            self.page.message(message or asked)
        if pauses and self._has(("M0",), "tool", "tool changes by a pause"):
            self.page.line("M0")

    def rise_mm(self, tool: int) -> float:
        """Return how far above clearance the present tool must be, so that a longer `tool` clears too."""
        lengths = self.options.tool_lengths_mm
        if self.options.tool_length != "table":
            return 0.0
        return max(lengths.get(tool, 0.0) - lengths.get(self.tool, 0.0), 0.0)

    def _measure(self, tool: int, length_mm: float | None) -> None:
        """Select the length offset of a tool; the new tip is at another height."""
        if length_mm == 0 and self.own_lengths:
            if self.length_mm:
                self.page.line("G49")
        else:
            self.page.line(*self._length_words(tool, length_mm))
        if length_mm != self.length_mm or not self.own_lengths:
            self.page.at[2] = None
        self.length_mm = length_mm or 0.0

    def _length_words(self, tool: int, length_mm: float | None) -> tuple[str, ...]:
        """Return G43 H where the machine's table has the length, else G43.1 and the length."""
        codes, known = self.dialect.codes, self.options.tool_lengths_mm.get(tool)
        by_table = "G43" in codes and (not self.own_lengths or known == length_mm)
        if by_table:
            return "G43", f"H{tool}"
        if length_mm is None or "G43.1" not in codes:
            what = Text("the length offset of tool {tool} is not known", tool=tool)
            advice = "give the tool a length_offset_mm, or choose another tool_length for the machine"
            raise ProgramError("tool-length", what, value=f"T{tool}", advice=advice)
        grid = self.page.grid
        return "G43.1", f"Z{grid.text(grid.count(length_mm))}"

    def dwell(self, seconds: float) -> None:
        """Wait, at least as long as the spindle still needs."""
        seconds, self._owed_s = max(seconds, self._owed_s), 0.0
        if self.dialect.power == "always" and len(self.page.lines) == self._on_at:  # the wire is hot already
            return
        if self._has(("G4",), "dwell", "dwells"):
            number = self.page.with_point(_number(seconds / self.dialect.dwell_unit_s))
            self.page.line("G4", f"{self.dialect.dwell_letter}{number}")

    def pause(self, optional: bool, message: str) -> None:
        """Stop until the operator resumes."""
        code = "M1" if optional else "M0"
        if self._has((code,), "pause", "pauses"):
            self.page.stop(code, message)

    def settle(self) -> None:
        """Wait for the spindle where that was not done."""
        if self._owed_s > 0:
            self.dwell(self._owed_s)

    def all_off(self) -> None:
        """Switch everything off that is on."""
        self._turn_spindle(State())
        self._pour(False, False)

    def _turn_spindle(self, state: State) -> None:
        spindle, rpm = self._spindle
        if self.dialect.power == "always":
            self._check_once(state)
            return
        if state.spindle == "off":
            if spindle != "off":
                self.page.line("M5")
            self._spindle, self._owed_s = ("off", 0.0), 0.0
            return
        if not self._has((SPINDLE_CODES[state.spindle],), "spindle", "words for the spindle"):
            return
        if self._keeps_surface(state):
            return
        if state.spindle != spindle:
            if not state.spindle_rpm:
                self.page.notes.add("the spindle is switched on at S0, since no S came before")
            self.page.line(SPINDLE_CODES[state.spindle], self._speed_word(state))
            self._owed_s = self.options.spin_up_s
        elif state.spindle_rpm != rpm and self.dialect.power == "speed":
            self.page.line(*self._speed_words(state))
        self._spindle = (state.spindle, state.spindle_rpm)

    def _keeps_surface(self, state: State) -> bool:
        """Bring G96 or G97 of a lathe's program into force; whether the spindle follows X."""
        surface = (state.surface_m_min, state.largest_rpm)
        is_wanted = bool(state.surface_m_min and self.options.x_is and "G96" in self.dialect.codes)
        if is_wanted and surface != self._surface:
            speed = surface[0] / (1.0 if self.options.units == "mm" else M_PER_FOOT)
            by_word = "G50" not in self.dialect.codes
            if not by_word:
                self.page.line("G50", f"S{_number(surface[1])}")
            self.page.line("G96", f"D{_number(surface[1])}" if by_word else "", f"S{_number(speed)}")
        elif self._surface[0] and not is_wanted:
            self.page.line("G97", self._speed_word(state))
            self._spindle = (self._spindle[0], state.spindle_rpm)
        self._surface = surface if is_wanted else (0.0, 0.0)
        if is_wanted and state.spindle != self._spindle[0]:
            self.page.line(SPINDLE_CODES[state.spindle])
            self._owed_s = self.options.spin_up_s
        if is_wanted:
            self._spindle = (state.spindle, 0.0)
        return is_wanted

    def _check_once(self, state: State) -> None:
        """Refuse to switch power on again where the language has no words for it and it is on from the begin."""
        spindle, _ = self._spindle
        if spindle == "ended" and state.spindle != "off":
            what = Text("{dialect} cannot switch the power off between two cuts", dialect=self.dialect.title)
            advice = "cut it in one way, or with a machine whose language has M3 and M5"
            raise ProgramError("not-expressible", what, value=SPINDLE_CODES[state.spindle], advice=advice)
        if spindle != "off":
            self._spindle = ("ended" if state.spindle == "off" else spindle, 0.0)
        else:
            self._spindle, self._on_at = (state.spindle, 0.0), len(self.page.lines)

    def _speed_words(self, state: State) -> tuple[str, ...]:
        """Return S, behind its code where a line must begin with one."""
        code = () if self.dialect.repeats else (SPINDLE_CODES[state.spindle],)
        return (*code, self._speed_word(state))

    def _speed_word(self, state: State) -> str:
        """Return S; nothing where M3 is a switch."""
        return f"S{_number(state.spindle_rpm)}" if self.dialect.power == "speed" else ""

    def _pour(self, mist: bool, flood: bool) -> None:
        if (mist or flood) and not self._has(("M7",) * mist + ("M8",) * flood, "coolant", "words for this coolant"):
            return
        had_mist, had_flood = self._coolant
        if (had_mist and not mist) or (had_flood and not flood):
            self.page.line("M9")
            had_mist = had_flood = False
        if mist and not had_mist:
            self.page.line("M7")
        if flood and not had_flood:
            self.page.line("M8")
        self._coolant = (mist, flood)

    def _has(self, codes: tuple[str, ...], name: str, what: str) -> bool:
        """Whether the dialect has these codes; what it lacks may be left out only where the options say so."""
        if all(code in self.dialect.codes for code in codes):
            return True
        lacks = Text("{dialect} has no {what}", dialect=self.dialect.title, what=what)
        if name not in self.options.leave_out:
            advice = Text("leave '{name}' out, if the machine's operator does it by hand", name=name)
            raise ProgramError("not-expressible", lacks, value=" ".join(codes), advice=advice)
        if name in LASTING:
            self.page.notes.once(Text("left out: {lacks}", lacks=lacks))
        else:
            self.page.notes.add(Text("left out: {lacks}", lacks=lacks))
        return False


def has_lengths(dialect: Dialect) -> bool:
    """Whether the dialect has words for the length of a tool."""
    return "G43" in dialect.codes or "G43.1" in dialect.codes


def tool_comment(tool: int, description: str) -> str:
    """Return the comment of a program about its tool."""
    return f"tool {tool}: {description}"


def _number(value: float) -> str:
    """Return a number with at most three decimals and no trailing zeros."""
    return f"{value:.3f}".rstrip("0").rstrip(".")
