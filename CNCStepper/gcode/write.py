# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the table of moves to program text in one dialect, as controllers want it.

    header   modes, work offset
    tool     comment, T, spindle, coolant, spin-up dwell          again at every tool change, after a pause
    moves    Z to clearance, then the rows: words that stand are not repeated, arcs are complete
    end      Z to clearance, outputs off, M2

Rows, events and states are written in the order in which they happen. Text that is read back and written again
with the same options is the same text.
"""

from __future__ import annotations

from collections import defaultdict

from CNCStepper.errors import ProgramError
from CNCStepper.gcode.ascii import ascii_text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.grid import Grid
from CNCStepper.gcode.options import WriteOptions
from CNCStepper.gcode.page import Page
from CNCStepper.gcode.rows import RowWriter
from CNCStepper.gcode.switches import Switches
from CNCStepper.state import State
from CNCStepper.toolpath import Event, Toolpath

__all__ = ["WriteOptions", "write", "write_split"]

UNIT_CODES = {"mm": "G21", "inch": "G20"}


def write(toolpath: Toolpath, dialect: str | Dialect = "grbl", options: WriteOptions | None = None) -> str:
    """Return the program text of a table whose coordinates are work coordinates (or name their offset).

    Raises ProgramError, with the reason, for what the dialect cannot express.
    """
    options = options or WriteOptions()
    if options.tool_change == "split" and len(_parts(toolpath)) > 1:
        what = "the program needs more than one tool"
        raise ProgramError("tool-change", what, advice="write one program a tool, or pause at tool changes")
    return _Writer(toolpath, dialect_named(dialect), options).program(0, len(toolpath))


def write_split(
    toolpath: Toolpath, dialect: str | Dialect = "grbl", options: WriteOptions | None = None
) -> list[tuple[int, str]]:
    """Return one program for each stretch with the same tool: (tool, text), in the order of the work."""
    options = options or WriteOptions()
    named = dialect_named(dialect)
    return [(tool, _Writer(toolpath, named, options).program(*rows)) for tool, *rows in _parts(toolpath)]


def _parts(toolpath: Toolpath) -> list[tuple[int, int, int]]:
    """Return (tool, first row, last row + 1) of each stretch with one tool; rows before any tool join the first."""
    parts: list[tuple[int, int, int]] = []
    for row, state in enumerate(toolpath.table().state.tolist()):
        tool = toolpath.states[state].tool
        if parts and parts[-1][0] in (tool, 0):
            parts[-1] = (tool, parts[-1][1], row + 1)
        else:
            parts.append((tool, row, row + 1))
    return parts or [(0, 0, 0)]


class _Writer:
    """Writes rows [first, last) of one toolpath."""

    def __init__(self, toolpath: Toolpath, dialect: Dialect, options: WriteOptions):
        if dialect.writing is None:
            what = f"programs are not written in the dialect {dialect.title}"
            raise ProgramError("dialect", what, advice="write for grbl or linuxcnc")
        if options.tool_change not in dialect.writing.tool_change:
            what = f"{dialect.title} cannot change tools by '{options.tool_change}'"
            raise ProgramError("tool-change", what, advice=f"use {' or '.join(dialect.writing.tool_change)}")
        self.path = toolpath
        self.options = options
        self.header_codes = dialect.writing.header
        self.page = Page(dialect, Grid(options.units, dialect.writing.decimals[options.units]))
        self.switches = Switches(self.page, dialect, dialect.writing, options)
        self.rows = RowWriter(toolpath, self.page, dialect, options)
        self.states = toolpath.states
        used = {self.states[index].work_system for index in set(toolpath.table().state.tolist())}
        self._one_system = options.work_offset if len(used) < 2 else ""

    def program(self, first: int, last: int) -> str:
        """Return the text of the rows [first, last) with all that happens at them."""
        self.rows.has_height = self.rows.any_height(first, last)
        self._header(first)
        events = self._events()
        begins, ends = self._operations(first, last)
        row_states = self.path.table().state.tolist()
        for row in range(first, last):
            self._finish(ends[row])
            self._happen(events[row], self.states[row_states[row]], row)
            self._begin(begins[row])
            self.rows.write(row)
        self._finish(ends[last])
        self._at_end(events[last], last)
        return self.page.text()

    # what happens between the rows

    def _happen(self, events: list[Event], state: State, row: int) -> None:
        """Write the events before a row, and bring the machine into the row's state."""
        if state.tool not in (0, self.switches.tool):
            events = self._change_tool(events, state)
        for event in events:
            self.switches.follow(self.states[event.state])
            self._event(event)
        self._offset(state, row)
        self.switches.follow(state)
        self.switches.settle()
        self.rows.lift_first()

    def _change_tool(self, events: list[Event], state: State) -> list[Event]:
        """Write a tool change and return the events that come after it.

        A pause and its message that stand before the change are the change's own: they are not repeated.
        """
        before = [event for event in events if self.states[event.state].tool != state.tool]
        first = self.switches.tool == 0
        own = () if first else ("message", "pause")
        for event in before:
            if event.kind not in own:
                self._event(event)
        messages = [event.text for event in before if event.kind in own and event.text]
        if not first:
            self.rows.lift()
        self.switches.load(state.tool, " ".join(messages))
        self.rows.must_lift = True
        return [event for event in events if event not in before]

    def _offset(self, state: State, row: int) -> None:
        """Select the row's work offset; in another one the machine's place has other numbers."""
        if self.switches.use_work_system(self._one_system or state.work_system):
            self.rows.rebase(row)

    def _event(self, event: Event) -> None:
        if event.kind == "dwell":
            self.switches.dwell(event.value)
        elif event.kind == "message":
            self.page.message(event.text)
        elif event.kind == "comment":
            self.page.comment(event.text)
        elif event.kind in ("pause", "optional_pause"):
            self.switches.settle()
            self.page.stop("M0" if event.kind == "pause" else "M1", event.text)
        elif event.kind not in ("tool_select", "tool_change"):
            what = f"an event '{event.kind}' cannot be written into the program here"
            raise ProgramError("event", what, value=f"before row {event.index}", advice="take it out of the toolpath")

    def _at_end(self, events: list[Event], last: int) -> None:
        """Write what happens after the last row, then retract, switch off and end."""
        if last == len(self.path):
            for event in events:
                if event.kind != "end":
                    self._event(event)
        self.rows.lift()
        self.page.line("M5")
        self.page.line("M9")
        self.page.line("M2")

    # the frame

    def _header(self, first: int) -> None:
        for text in (self.options.title, *self.options.comments):
            self.page.comment(text, own=True)
        plane, *modes = self.header_codes
        self.page.line(UNIT_CODES[self.options.units], plane, *(code for code in modes if code in ("G90", "G91.1")))
        self.page.line(*(code for code in modes if code not in ("G90", "G91.1")))
        rows = self.path.table().state
        state = self.states[int(rows[first])] if len(rows) else State()
        self.switches.use_work_system(self._one_system or state.work_system)

    def _events(self) -> defaultdict[int, list[Event]]:
        by_row: defaultdict[int, list[Event]] = defaultdict(list)
        for event in self.path.events:
            by_row[event.index].append(event)
        return by_row

    def _operations(self, first: int, last: int) -> tuple[defaultdict[int, list[str]], defaultdict[int, list[str]]]:
        """Return the operations that begin at and end before each row, outer ones outside."""
        begins: defaultdict[int, list[str]] = defaultdict(list)
        ends: defaultdict[int, list[str]] = defaultdict(list)
        spans = [span for span in self.path.spans if span.kind == "operation"]
        for span in sorted(spans, key=lambda span: (span.first, -span.last)):
            begin, end = max(span.first, first), min(span.last, last)
            if begin < end:
                begins[begin].append(ascii_text(span.name))
                ends[end].insert(0, ascii_text(span.name))
        return begins, ends

    def _begin(self, names: list[str]) -> None:
        for name in names:
            self.page.lines.append(f"(begin operation: {name})")

    def _finish(self, names: list[str]) -> None:
        for name in names:
            self.page.lines.append(f"(finish operation: {name})")
