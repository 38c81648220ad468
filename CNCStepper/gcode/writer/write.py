# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the table of moves to program text in one dialect, as controllers want it.

    header   modes, work offset                                    as the dialect's `Writing` has it
    tool     comment, T, length, spindle, coolant, spin-up dwell  again at every tool change, after a pause
    moves    Z to clearance, then the rows: words that stand are not repeated, arcs are complete
    end      Z to clearance, outputs off, M2

Rows, events and states are written in the order in which they happen. Text that is read back and written again
with the same options is the same text.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.errors import Place, ProgramError, Text, one_of
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.writer.block_emitter import BlockEmitter, Grid, ascii_text
from CNCStepper.gcode.writer.canned_cycle_blocks import CycleWriter
from CNCStepper.gcode.writer.move_rows import RowWriter
from CNCStepper.gcode.writer.plasma_words import PlasmaSwitches
from CNCStepper.gcode.writer.profile_cycle_blocks import profile_cycles
from CNCStepper.gcode.writer.state_changes import Switches
from CNCStepper.gcode.writer.thread_blocks import ThreadWriter
from CNCStepper.gcode.writer.turning_words import begin_turning, follow_feed_mode, turned_words
from CNCStepper.gcode.writer.write_options import Note, WriteOptions
from CNCStepper.state import State
from CNCStepper.toolpath import PLANE_NAMES, RAPID, Event, Toolpath

__all__ = ["WriteOptions", "Written", "write", "write_split", "written"]


@dataclass(frozen=True)
class Written:
    """A program's text, and what had to be written differently from the table."""

    text: str
    notes: tuple[Note, ...]


def write(toolpath: Toolpath, dialect: str | Dialect = "grbl", options: WriteOptions | None = None) -> str:
    """Return the program text of a table whose coordinates are work coordinates (or name their offset).

    Raises ProgramError, with the reason, for moves that the dialect cannot express.
    """
    return written(toolpath, dialect, options).text


def written(
    toolpath: Toolpath,
    dialect: str | Dialect = "grbl",
    options: WriteOptions | None = None,
    progress: Callable[[float], None] = lambda share: None,
) -> Written:
    """Return the result of `write`, with notes of features that the dialect lacks and their replacements.

    progress: called with the share of the rows that is written, from 0 to 1.
    """
    options, named = options or WriteOptions(), dialect_named(dialect)
    many = len(_parts(toolpath)) > 1
    if many and options.tool_change == "split":
        what = "the program needs more than one tool"
        raise ProgramError("tool-change", what, advice="write one program a tool, or pause at tool changes")
    if many and named.writing and options.tool_change not in named.writing.tool_change:
        what = Text(
            "{named} cannot change tools by '{tool_change}'", named=named.title, tool_change=options.tool_change
        )
        raise ProgramError("tool-change", what, advice=Text("use {ways}", ways=one_of(named.writing.tool_change)))
    writer = _Writer(toolpath, named, options, progress)
    text = writer.program(0, len(toolpath))
    return Written(text, tuple(writer.page.notes))


def write_split(
    toolpath: Toolpath, dialect: str | Dialect = "grbl", options: WriteOptions | None = None
) -> list[tuple[int, str]]:
    """Return one program for each stretch with the same tool: (tool, text), in the order of the work.

    Each says which of them it is; a later one also what is to be done about its tool's length.
    """
    options, named, parts = options or WriteOptions(), dialect_named(dialect), _parts(toolpath)
    texts = []
    for number, (tool, *rows) in enumerate(parts, start=1):
        own = _options_of_part(options, number, len(parts))
        texts.append((tool, _Writer(toolpath, named, own).program(*rows)))
    return texts


def _options_of_part(options: WriteOptions, number: int, count: int) -> WriteOptions:
    if count == 1:
        return options
    title = f"{options.title}, program {number} of {count}".removeprefix(", ")
    if number == 1 or options.tool_length != "touch_off":
        return replace(options, title=title)
    return replace(options, title=title, comments=(*options.comments, "before it starts set the Z zero with its tool"))


def _parts(toolpath: Toolpath) -> list[tuple[int, int, int]]:
    """Return (tool, first row, last row + 1) of each stretch with one tool; rapids before any tool join the first."""
    parts: list[tuple[int, int, int]] = []
    first_cut = _first_cut(toolpath)
    for row, state in enumerate(toolpath.table().state.tolist()):
        tool = toolpath.states[state].tool
        if parts and (parts[-1][0] == tool or (parts[-1][0] == 0 and row <= first_cut)):
            parts[-1] = (tool, parts[-1][1], row + 1)
        else:
            parts.append((tool, row, row + 1))
    return parts or [(0, 0, 0)]


def _first_cut(toolpath: Toolpath, first: int = 0) -> int:
    """Return the first row from `first` on that is no rapid: a tool named before it is not changed, it is the first."""
    cuts = np.flatnonzero(toolpath.table().kind[first:] != RAPID)
    return first + int(cuts[0]) if len(cuts) else len(toolpath)


class _Writer:
    """Writes rows [first, last) of one toolpath."""

    def __init__(
        self,
        toolpath: Toolpath,
        dialect: Dialect,
        options: WriteOptions,
        progress: Callable[[float], None] = lambda share: None,
    ):
        writing = dialect.writing
        if writing is None:
            what = Text("programs are not written in the dialect {dialect}", dialect=dialect.title)
            raise ProgramError("dialect", what, advice="write for grbl or linuxcnc")
        if options.units not in writing.units:
            what = Text("{dialect} has no programs in {units}", dialect=dialect.title, units=options.units)
            raise ProgramError("units", what, advice=Text("use {units}", units=one_of(writing.units)))
        self.path = toolpath
        self.options = options
        self._progress = progress
        self.writing = writing
        self.states = toolpath.states
        self._first_cut = 0
        self.page = BlockEmitter(dialect, writing, Grid(options.units, writing.decimals[options.units], writing.short))
        used = {self.states[index] for index in set(toolpath.table().state.tolist())}
        lengths = any(state.tool_length_mm for state in used)
        self.switches = (PlasmaSwitches if dialect.plasma else Switches)(self.page, options, lengths)
        keeps_lengths = self.switches.own_lengths or options.tool_length == "touch_off"
        self.rows = RowWriter(toolpath, self.page, options, keeps_lengths)
        self.cycles = CycleWriter(toolpath, self.page, self.rows)
        self.threads = ThreadWriter(toolpath, self.page, self.rows, options.turning_cycles)
        self.profiles = profile_cycles(toolpath, self.page, self.rows, options.turning_cycles)
        one = len({state.work_system for state in used}) < 2
        self._one_system = options.work_offset if one else ""

    def program(self, first: int, last: int) -> str:
        """Return the text of the rows [first, last) with all that happens at them."""
        self._first_cut = _first_cut(self.path, first)
        self.rows.has_height = self.rows.any_height(first, last)
        self._header(first, last)
        events = self._events()
        begins, ends = self._operations(first, last)
        row_states = self.path.table().state.tolist()
        row = first
        try:
            while row < last:
                checkpoint()
                changes = row == first or row_states[row] != row_states[row - 1]
                self._finish(ends[row])
                if events[row] or changes:
                    self._happen(events[row], self.states[row_states[row]], row)
                self._follow_plane(self.states[row_states[row]], row)
                self._begin(begins[row])
                self.switches.before_move(self.rows.kinds[row])
                row = self._row(row, last)
                self._progress(row / last)
        except ProgramError as error:
            line = int(self.path.table().line[row])
            if error.place or not line:
                raise
            raise error.at(Place("", line)) from error
        self._finish(ends[last])
        self._at_end(events[last], last)
        self.page.end_cycle()
        return self.page.text()

    def _row(self, row: int, last: int) -> int:
        """Write a row, or all rows of a hole as a canned cycle; return the next row."""
        after = self.threads.write(row, last) or self.profiles.write(row, last) or self.cycles.write(row, last)
        if after == row:
            self.page.lead_mm = self.threads.lead_mm(row)
            self.rows.write(row)
        return max(after, row + 1)

    # what happens between the rows

    def _happen(self, events: list[Event], state: State, row: int) -> None:
        """Write the events before a row, and bring the machine into the row's state."""
        self.switches.goes_on = self.rows.kinds[row] != RAPID
        if state.tool not in (0, self.switches.tool):
            events = self._change_tool(events, state, row)
        for event in events:
            self.switches.run(self.states[event.state])
            self._event(event)
        self._offset(state, row)
        self.page.distance = state.distance if self.writing.keeps_distance else "absolute"
        self.switches.follow(state)
        self.switches.settle()
        if self.options.x_is:
            follow_feed_mode(self.page, state)
        self.rows.lift_first()

    def _change_tool(self, events: list[Event], state: State, row: int) -> list[Event]:
        """Write a tool change and return the events that come after it.

        A pause and its message that stand before the change are the change's own: they are not repeated.
        """
        before = [event for event in events if self.states[event.state].tool != state.tool]
        first = self.switches.tool == 0 and row <= self._first_cut
        own = () if first else self.switches.own_events
        for event in before:
            if event.kind not in own:
                self._wait_or_comment(event)
        messages = [event.text for event in before if event.kind in own and event.text]
        if not first:
            self.rows.lift(self.switches.rise_mm(state.tool))
        self.switches.load(state.tool, " ".join(messages), state.tool_length_mm, first)
        self.rows.lift_next()
        return [event for event in events if event not in before]

    def _offset(self, state: State, row: int) -> None:
        """Select the row's work offset; in another one the machine's place has other numbers."""
        if self.switches.use_work_system(self._one_system or state.work_system):
            self.rows.rebase(row)

    def _follow_plane(self, state: State, row: int) -> None:
        """Select the plane of a state too where no arc needs it, in a program that is to be as it was."""
        plane = PLANE_NAMES.index(state.plane)
        if not (self.options.retract or self.rows.turns[row]) and self.page.has_plane(plane):
            self.page.select_plane(plane)

    def _wait_or_comment(self, event: Event) -> None:
        """Write an event that no row follows; what waits does so with what runs then, which is often nothing."""
        if event.kind in ("dwell", "pause", "optional_pause"):
            self.switches.run(self.states[event.state])
        self._event(event)

    def _event(self, event: Event) -> None:
        if event.kind == "dwell":
            self.switches.dwell(event.value)
        elif event.kind == "message":
            self.page.message(event.text)
        elif event.kind == "comment":
            self.page.comment(event.text)
        elif event.kind in ("pause", "optional_pause"):
            self.switches.settle()
            self.switches.pause(event.kind == "optional_pause", event.text)
        elif event.kind == "output" and event.text.partition(" ")[0] in self.page.dialect.codes:
            self.page.line(event.text)
        elif event.kind == "material":
            self.switches.material(event.text)
        elif event.kind == "synchronised":
            self.threads.check(event)
        elif event.kind not in ("tool_select", "tool_change", "warning"):
            what = Text(
                "{dialect} programs are written without '{event_kind}'",
                dialect=self.page.dialect.title,
                event_kind=event.kind,
            )
            place = Place("", event.line) if event.line else None
            raise ProgramError("event", what, value=event.text, advice="take it out of the program", place=place)

    def _at_end(self, events: list[Event], last: int) -> None:
        """Write what happens after the last row, then retract, switch off and end."""
        if last == len(self.path):
            for event in events:
                if event.kind != "end":
                    self._wait_or_comment(event)
        self.rows.lift()
        self.switches.goes_on = False
        self.switches.before_end()
        ends = [f"M{event.value:.0f}" for event in self.path.events if event.kind == "end"]
        for line in self.writing.footer:
            as_it_was = not self.options.retract and line == "M2" and ends[-1:] == ["M30"]
            self.page.line("M30" if as_it_was and "M30" in self.page.dialect.codes else line)

    # the frame

    def _header(self, first: int, last: int) -> None:
        for text in (self.options.title, *self.options.comments):
            self.page.comment(text, own=True)
        if self.writing.rapid_feed and not self.options.rapid_mm_min:
            self.page.notes.add("rapids move at the feed in force: no F for them was given")
        for line in self.writing.header:
            words = line.format(units=self.writing.units[self.options.units]).split()
            self.page.line(*(turned_words(words, self.page.dialect, self.options) if self.options.x_is else words))
        if self.options.x_is:
            begin_turning(self.page, self.options)
            self.profiles.declare(first, last)
        self.switches.begin()
        if not self.options.retract and first < last:
            self.rows.begin(first)
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
            self.page.raw(Text("begin operation: {name}", name=name))

    def _finish(self, names: list[str]) -> None:
        for name in names:
            self.page.raw(Text("finish operation: {name}", name=name))
