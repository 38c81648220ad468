# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is switched rather than moved while a program is written: tool, spindle, coolant, work offset."""

from __future__ import annotations

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.ascii import comment_lines
from CNCStepper.gcode.dialects import Dialect, Writing
from CNCStepper.gcode.options import WriteOptions
from CNCStepper.gcode.page import Page
from CNCStepper.state import State

SPINDLE_CODES = {"cw": "M3", "ccw": "M4"}


class Switches:
    """Writes the words that bring the machine from what it holds to what a state wants."""

    def __init__(self, page: Page, dialect: Dialect, writing: Writing, options: WriteOptions):
        self.page = page
        self.dialect = dialect
        self.writing = writing
        self.options = options
        self.tool = 0
        self.work_system = ""
        self._spindle = ("off", 0.0)
        self._coolant = (False, False)  # mist, flood
        self._owed_s = 0.0  # dwell that the spindle still needs
        for number, description in options.tools.items():
            page.own_comments.update(comment_lines(_tool_comment(number, description)))

    def follow(self, state: State) -> None:
        """Switch spindle and coolant as `state` has them."""
        self._turn_spindle(state)
        on = state.spindle != "off"
        mist = state.mist or (on and self.options.coolant == "mist")
        flood = state.flood or (on and self.options.coolant == "flood")
        self._pour(mist, flood)

    def use_work_system(self, name: str) -> bool:
        """Select a work offset; whether it was another one."""
        if name == self.work_system:
            return False
        if name not in self.writing.work_systems:
            what = f"{self.dialect.title} has no work offset {name}"
            raise ProgramError("work-system", what, value=name, advice=f"use {', '.join(self.writing.work_systems)}")
        self.work_system = name
        self.page.line(name)
        return True

    def load(self, tool: int, message: str) -> None:
        """Change to `tool`; the first one is named only, for later ones the operator is asked."""
        if tool > self.dialect.largest_tool:
            limit = f"at most {self.dialect.largest_tool}"
            raise ProgramError("tool-number", "the tool number is too large", value=f"T{tool}", limit=limit)
        description = self.options.tools.get(tool, "")
        first = self.tool == 0
        # where only M6 makes T the tool in the spindle, M6 itself is the pause
        by_machine = self.options.tool_change == "m6" or not self.dialect.tool_word_changes
        if not first:
            self.all_off()
        if not first and not by_machine:
            self.page.message(message or f"change to tool {tool}" + f": {description}" * bool(description))
            self.page.line("M0")
        if description:
            self.page.comment(_tool_comment(tool, description), own=True)
        self.page.line(f"T{tool}", "M6" if by_machine else "")
        self.page.forget()  # the operator or the tool changer may have moved the axes
        self.tool = tool

    def dwell(self, seconds: float) -> None:
        """Wait, at least as long as the spindle still needs."""
        seconds, self._owed_s = max(seconds, self._owed_s), 0.0
        self.page.line("G4", f"P{_number(seconds)}")

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
        if state.spindle == "off":
            if spindle != "off":
                self.page.line("M5")
            self._spindle, self._owed_s = ("off", 0.0), 0.0
            return
        if state.spindle != spindle:
            self.page.line(SPINDLE_CODES[state.spindle], f"S{_number(state.spindle_rpm)}")
            self._owed_s = self.options.spin_up_s
        elif state.spindle_rpm != rpm:
            self.page.line(f"S{_number(state.spindle_rpm)}")
        self._spindle = (state.spindle, state.spindle_rpm)

    def _pour(self, mist: bool, flood: bool) -> None:
        had_mist, had_flood = self._coolant
        if (had_mist and not mist) or (had_flood and not flood):
            self.page.line("M9")
            had_mist = had_flood = False
        if mist and not had_mist:
            self.page.line("M7")
        if flood and not had_flood:
            self.page.line("M8")
        self._coolant = (mist, flood)


def _tool_comment(tool: int, description: str) -> str:
    return f"tool {tool}: {description}"


def _number(value: float) -> str:
    """Return a number with at most three decimals and no trailing zeros."""
    return f"{value:.3f}".rstrip("0").rstrip(".")
