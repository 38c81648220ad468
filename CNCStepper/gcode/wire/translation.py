# SPDX-License-Identifier: LGPL-2.1-or-later
"""The wire text of a program in another language than its controller's: each row of its path is one line of grbl's.

    thesis A                         sent                          file's line
    g90                              G17G21G90G94G54               2
    y-80                             M3                            2
    G2 x-80 y0 i0 j0                 G1Y-80F900                    2
                                     G2X-80Y0I0J80                 3
                                     M2                            3

Places are those of the program's own work system; G92 and tool lengths are in the coordinates already, and centres
count from the begin of the arc. What was written is read back at once, in the language in which it is sent, and
compared row by row with the path: only the read-back is planned, checked and proven.
"""

from __future__ import annotations

import hashlib
import math
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from CNCStepper.errors import Place, ProgramError, Text
from CNCStepper.gcode.dialects import Dialect, dialect_named
from CNCStepper.gcode.dialects.codes import MOTION_NAMES
from CNCStepper.gcode.interpreter.interpret import interpret
from CNCStepper.gcode.interpreter.line_interpreter import Interpreter
from CNCStepper.gcode.interpreter.program_file import FileReading
from CNCStepper.gcode.wire.translated_backlash import MotorRows, differs
from CNCStepper.gcode.wire.wire_text import WireLines, WireText, check_wire_line
from CNCStepper.machine.backlash import Backlash
from CNCStepper.state import ZERO3, Start, State
from CNCStepper.tolerances import SAME_SUM_MM, SAME_TRANSLATED_FEED
from CNCStepper.toolpath import (
    ARC_CCW,
    LINE,
    PLANE_AXES,
    PLANE_NAMES,
    RAPID,
    XYZ,
    Chunk,
    Event,
    TableBuilder,
    Toolpath,
    begins_of,
    join_chunks,
    require_straight_axes,
)

AXES, CENTRES = "XYZ", "IJK"
DECIMALS = 5  # of a mm: grbl keeps seven digits
ROUNDED_END_MM = 2.1 * 10.0**-DECIMALS  # of an end or a centre, whose begin is rounded too
SMALLEST_RAD = 2e-6  # twice what grbl takes for a full circle
PLANE_WORDS = dict(zip(PLANE_NAMES, ("G17", "G18", "G19"), strict=True))
SPINDLES = {"off": "M5", "cw": "M3", "ccw": "M4"}
STOPS = {"pause": "M0", "optional_pause": "M1", "end": "M2"}
PASSED_OVER = ("comment", "warning", "tool_select", "override", "material")  # the path has what they mean
TAKEN_AWAY = "the machine's controller does not have it: take it out, or cut the program in two there"
HAPPENS = ("dwell", "pause", "optional_pause", "output")  # state that the read-back must have too


class Translation(NamedTuple):
    """wire: the lines sent. toolpath: the program's path with the positions that are read back from the wire.

    With backlash compensation it is the path of the motors.
    """

    wire: WireText
    toolpath: Toolpath


def translate(
    text: str,
    source: str | Dialect,
    target: str | Dialect,
    file: str = "",
    start: Start | None = None,
    share: Callable[[float], None] = lambda share: None,
    play: Backlash | None = None,
) -> Translation:
    """Return the wire text of a program in `source`, as lines of `target`, grbl's language with a machine's settings.

    share: called with the share of the lines that is read. play: of the axes, to be compensated in the lines. Raises
    ProgramError for what cannot be read or sent.
    """
    path = require_straight_axes(interpret(text, start, source, file, share), file)
    language = dialect_named(target)
    translator = WireTranslator(language, path.start, file)
    motors = MotorRows(play, language, path.start, file) if play else None
    events = iter(path.events)
    translated = [translator.translated(chunk, path.states, events) for chunk in path.chunks]
    translated.append((translator.ended(path.states, events), _no_rows()))
    if motors is None:
        read = [chunk for _, chunk in translated[:-1]]
        return Translation(_joined(wire for wire, _ in translated), replace(path, chunks=read))
    sent = [motors.compensated(*one) for one in translated]
    chunks = [chunk for _, some in sent for chunk in some]
    return Translation(_joined(wire for wire, _ in sent), replace(motors.renumbered(path), chunks=chunks))


def _no_rows() -> Chunk:
    return TableBuilder(Start()).empty()


class WireTranslator:
    """Writes the lines of a path that comes chunk by chunk, and reads each back."""

    def __init__(self, target: Dialect, start: Start, file: str):
        self._file = file
        self._reader = Interpreter(start, target, file)
        self._lines = _LineWriter(target, start, file)
        self._event: Event | None = None  # the next one
        self._before = np.asarray(start.position_mm[:XYZ], float)

    def translated(self, chunk: Chunk, states: Sequence[State], events: Iterator[Event]) -> tuple[WireText, Chunk]:
        """Return the lines of a chunk, with all events before its rows, and the chunk as it is read back."""
        happened: list[tuple] = []
        begins = begins_of(chunk, self._before)
        for row in range(len(chunk)):
            for event in self._until(events, chunk.first + row):
                self._happen(event, states, happened)
            self._lines.move(chunk, row, begins[row], states[int(chunk.state[row])])
        wire = self._lines.take()
        again = self._read(wire, chunk, states, happened)
        self._before = chunk.end[-1] if len(chunk) else self._before
        return wire, again

    def ended(self, states: Sequence[State], events: Iterator[Event]) -> WireText:
        """Return the lines after the last row; a program without an end code gets one."""
        happened: list[tuple] = []
        for event in self._until(events, None):
            self._happen(event, states, happened)
        self._lines.end()
        wire = self._lines.take()
        self._read(wire, _no_rows(), states, happened)
        return wire

    def _until(self, events: Iterator[Event], row: int | None) -> Iterator[Event]:
        """Yield the events up to a row, all of them for None."""
        while (event := self._event or next(events, None)) is not None:
            self._event = event
            if row is not None and event.index > row:
                return
            self._event = None
            yield event

    def _happen(self, event: Event, states: Sequence[State], happened: list[tuple]) -> None:
        self._lines.event(event, states[event.state])
        if event.kind in HAPPENS:
            happened.append(_sign_of(event, event.index))

    def _read(self, wire: WireText, chunk: Chunk, states: Sequence[State], happened: list[tuple]) -> Chunk:
        """Return a chunk with the places that its lines lead to; raises ProgramError where these are others."""
        reader, first = self._reader, self._reader.table.index
        for line, number in zip(wire.lines, wire.file_lines.tolist(), strict=True):
            reader.line_at(line, number, Place(self._file, number))
        again = join_chunks(reader.table.take())
        events, reader.table.events[:] = list(reader.table.events), []
        found = [_sign_of(event, event.index - first + chunk.first) for event in events if event.kind in HAPPENS]
        if len(again) != len(chunk) or found != [sign if len(chunk) else (0, *sign[1:]) for sign in happened]:
            raise differs(Place(self._file, int(wire.file_lines[0]) if len(wire.file_lines) else 0))
        _compare(chunk, again, states, reader.table.states, self._file)
        return replace(chunk, kind=again.kind, end=again.end, centre=again.centre, feed=again.feed)


def _sign_of(event: Event, index: int) -> tuple:
    value = round(event.value, 3) if event.kind in ("dwell", "output") else 0.0
    return index, event.kind, value, event.text[1:] if event.kind == "output" else ""


def _compare(chunk: Chunk, again: Chunk, states: Sequence[State], again_states: Sequence[State], file: str) -> None:
    """Raise ProgramError at the first row that the wire leads elsewhere, or at which other things are on."""
    end_mm = np.abs(again.end[:, :XYZ] - chunk.end[:, :XYZ])
    arcs = again.kind > LINE
    centre_mm = np.abs(again.centre - chunk.centre)
    for plane, (_, _, normal) in enumerate(PLANE_AXES):
        centre_mm[again.plane == plane, normal] = 0.0
    other = (np.nan_to_num(end_mm) > ROUNDED_END_MM).any(axis=1) | (arcs & (centre_mm > 2 * ROUNDED_END_MM).any(axis=1))
    other |= (again.kind != chunk.kind) & ~((again.kind == LINE) & (chunk.kind > LINE))
    other |= np.abs(again.feed - chunk.feed) > SAME_TRANSLATED_FEED * np.maximum(1.0, chunk.feed)
    pairs, of_row = np.unique(np.stack([chunk.state, again.state], axis=1), axis=0, return_inverse=True)
    switched = [_switched(states[int(one)]) != _switched(again_states[int(two)]) for one, two in pairs]
    other |= np.array(switched, bool)[of_row.ravel()] if len(chunk) else False
    if other.any():
        raise differs(Place(file, int(chunk.line[int(np.argmax(other))])))


def _switched(state: State) -> tuple:
    return state.spindle, round(state.spindle_rpm, 2) if state.spindle != "off" else 0.0, state.mist, state.flood


@dataclass
class _LineWriter:
    """The lines of a wire text in grbl's language, with the controller's modal state."""

    target: Dialect
    start: Start
    file: str
    data: bytearray = field(default_factory=bytearray)
    numbers: list[int] = field(default_factory=list)
    messages: dict[int, str] = field(default_factory=dict)
    _message: str = ""
    _begun: bool = False
    _ended: bool = False
    _line: int = 1
    _system: str = ""
    _plane: str = "XY"
    _spindle: str = "M5"
    _coolant: tuple[bool, bool] = (False, False)
    _feed: str = ""

    def take(self) -> WireText:
        """Return the lines written since the last call."""
        wire = WireText(WireLines(bytes(self.data)), np.array(self.numbers, np.int32), self.messages)
        self.data, self.numbers, self.messages = bytearray(), [], {}
        return wire

    def move(self, chunk: Chunk, row: int, begin_mm: np.ndarray, state: State) -> None:
        """Write a row, and before it what its state switches."""
        self._line = int(chunk.line[row]) or self._line
        self._follow(state)
        kind, end_mm = int(chunk.kind[row]), chunk.end[row, :XYZ]
        base_mm = self._base_mm(state)
        if kind > LINE:
            words = self._arc(chunk, row, begin_mm, end_mm, base_mm)
        else:
            words = MOTION_NAMES[kind] + self._places(begin_mm, end_mm, base_mm, set())
        self._write(words + (self._feed_word(float(chunk.feed[row])) if kind != RAPID else ""))

    def event(self, event: Event, state: State) -> None:
        """Write the events between two rows; raises ProgramError for one that no CNCStepper controller has."""
        self._line = event.line or self._line
        if event.kind == "message":
            self._message = f"{self._message}\n{event.text}".strip()
        elif event.kind == "tool_change":
            self._message = f"{self._message}\n{Text('put in tool {tool:g}', tool=event.value)}".strip()
            self._switch("M5", (False, False))
            self._write("M0")
        elif event.kind not in PASSED_OVER:
            self._follow(state)
            self._write(self._word_of(event))
        self._ended = self._ended or event.kind == "end"

    def end(self) -> None:
        """End a program that has no word for it."""
        if not self._ended:
            self._begin("G54")
            self._write("M2")
            self._ended = True

    def _word_of(self, event: Event) -> str:
        if event.kind in STOPS:
            return STOPS[event.kind]
        if event.kind == "dwell":
            return f"G4P{_number(event.value, 3)}"
        word = event.text.replace(" ", "")
        if event.kind == "output" and word.partition("P")[0] in self.target.codes:
            return word
        what = Text("{what} cannot be sent to a controller of this computer", what=event.text or event.kind)
        raise ProgramError("translate-event", what, advice=TAKEN_AWAY, place=Place(self.file, event.line))

    def _follow(self, state: State) -> None:
        """Bring the controller into a state."""
        self._begin(state.work_system)
        if state.work_system != self._system:
            self._system = state.work_system
            self._write(self._system)
        spindle = SPINDLES[state.spindle]
        if spindle != "M5" and self.target.power != "switch":
            spindle += f"S{_number(state.spindle_rpm, 3)}"
        self._switch(spindle, (state.mist, state.flood))

    def _switch(self, spindle: str, coolant: tuple[bool, bool]) -> None:
        if spindle != self._spindle:
            self._spindle = spindle
            self._write(spindle)
        if coolant != self._coolant:
            if (self._coolant[0] and not coolant[0]) or (self._coolant[1] and not coolant[1]):
                self._write("M9")
            for word, on in zip(("M7", "M8"), coolant, strict=True):
                if on:
                    self._write(word)
            self._coolant = coolant

    def _begin(self, system: str) -> None:
        """Write the modes that all lines take for granted, once."""
        if not self._begun:
            self._begun, self._system = True, system
            self._write(f"G17G21G90G94{system}")

    def _base_mm(self, state: State) -> tuple[float, ...]:
        """Return the place of the work zero in machine coordinates; refuses one that the program has moved itself."""
        start, system = self.start, self.start.work_offsets_mm.get(state.work_system, ZERO3)
        own_mm = [
            offset - g92 - (state.tool_length_mm if axis == XYZ - 1 else 0.0)
            for axis, (offset, g92) in enumerate(zip(state.offset_mm, state.g92_mm, strict=False))
        ]
        if any(abs(own - told) > ROUNDED_END_MM for own, told in zip(own_mm, system, strict=False)):
            what = "the program sets its own work zero (G10)"
            raise ProgramError("translate-zero", what, advice="use G92", place=Place(self.file, self._line))
        return tuple(told + g92 for told, g92 in zip(system, start.g92_mm, strict=False))

    def _places(self, begin_mm: np.ndarray, end_mm: np.ndarray, base_mm: Sequence[float], named: set[int]) -> str:
        """Return the words of the axes that move or are named; of one resting axis where there are none."""
        texts = [_number(float(end - base), DECIMALS) for end, base in zip(end_mm, base_mm, strict=False)]
        known = [axis for axis in range(XYZ) if not np.isnan(end_mm[axis]) and (axis < 2 or self.target.has_z)]
        moved = [axis for axis in known if axis in named or end_mm[axis] != begin_mm[axis]]
        return "".join(AXES[axis] + texts[axis] for axis in moved or known[:1])

    def _arc(
        self,
        chunk: Chunk,
        row: int,
        begin_mm: np.ndarray,
        end_mm: np.ndarray,
        base_mm: Sequence[float],
    ) -> str:
        kind, (first, second, _) = int(chunk.kind[row]), PLANE_AXES[int(chunk.plane[row])]
        if int(chunk.turns[row]) > 1:
            what = "an arc of several turns cannot be sent to a controller of this computer"
            raise ProgramError("translate-turns", what, advice="write each turn", place=Place(self.file, self._line))
        plane = PLANE_NAMES[int(chunk.plane[row])]
        if plane != self._plane:
            self._plane = plane
            self._write(PLANE_WORDS[plane])
        if np.abs(end_mm - begin_mm).max() < SAME_SUM_MM:  # a full circle: the same digits as where it begins
            end_mm = begin_mm
        words = self._places(begin_mm, end_mm, base_mm, {first, second})
        centre = chunk.centre[row]
        if self._is_tiny(begin_mm[[first, second]], end_mm[[first, second]], centre[[first, second]], kind):
            return MOTION_NAMES[LINE] + words  # rounded it would be a full circle
        offsets = (
            CENTRES[axis] + _number(float(centre[axis]) - round(float(begin_mm[axis]), DECIMALS), DECIMALS)
            for axis in sorted((first, second))
        )
        return MOTION_NAMES[kind] + words + "".join(offsets)

    @staticmethod
    def _is_tiny(begin_mm: np.ndarray, end_mm: np.ndarray, centre_mm: np.ndarray, kind: int) -> bool:
        """Return whether an arc is so short that its written ends are one place."""
        (x, y), (to_x, to_y) = begin_mm - centre_mm, end_mm - centre_mm
        turned = math.atan2(x * to_y - y * to_x, x * to_x + y * to_y) * (1 if kind == ARC_CCW else -1)
        return turned > 0.0 and (turned < SMALLEST_RAD or turned * math.hypot(x, y) < ROUNDED_END_MM)

    def _feed_word(self, feed_mm_min: float) -> str:
        text = _number(feed_mm_min, 3)
        if text == self._feed:
            return ""
        self._feed = text
        return f"F{text}"

    def _write(self, line: str) -> None:
        check_wire_line(line, self.target, Place(self.file, self._line))
        if self._message:
            self.messages[len(self.numbers)] = self._message
            self._message = ""
        self.data += f"{line}\n".encode("ascii")
        self.numbers.append(self._line)


def _number(value: float, decimals: int) -> str:
    text = f"{value:.{decimals}f}"
    text = text.rstrip("0").rstrip(".") if "." in text else text
    return "0" if text == "-0" else text


def _joined(pieces: Iterable[WireText]) -> WireText:
    data, numbers, messages = bytearray(), [np.zeros(0, np.int32)], dict[int, str]()
    leads: list[np.ndarray] = []
    count = 0
    for piece in pieces:
        data += piece.lines.data
        numbers.append(piece.file_lines)
        messages |= {index + count: text for index, text in piece.messages.items()}
        count += len(piece.lines)
        leads += [] if piece.leads is None else [piece.leads]
    flags = np.concatenate(leads) if leads else None
    return WireText(WireLines(bytes(data)), np.concatenate(numbers), messages, flags)


class _SourceTable(TableBuilder):
    """The table of the program, whose events are kept apart: all of them are translated, few are kept."""

    def __init__(self, table: TableBuilder, motors: MotorRows | None):
        super().__init__(table.start)
        self._table, self._motors = table, motors
        self.states, self.spans = table.states, table.spans

    def span_marks(self, kind: str) -> Iterator[int]:
        """Yield the rows at which spans of a kind begin and end, as far as they have."""
        marks = self._table.span_marks(kind)
        return marks if self._motors is None else map(self._motors.row, marks)

    def end(self) -> None:
        """Let the spans name the rows of the motors: all have come."""
        if self._motors is not None:
            self.spans[:] = map(self._motors.span, self.spans)
            self._motors = None


class TranslatedFile:
    """One reading of a program's file through the wire in another language; as `wire_file.WireFile`."""

    def __init__(
        self,
        path: Path,
        start: Start | None,
        source: str | Dialect,
        target: str | Dialect,
        play: Backlash | None = None,
        *,
        sink: Callable[[WireText], None] = lambda wire: None,
        progress: Callable[[float], None] = lambda share: None,
        name: str = "",
    ):
        self._name, self._sink, self._digest = name or str(path), sink, hashlib.sha256()
        self._reading = FileReading(path, start, source, progress=progress, name=name)
        source_table = self._reading.interpreter.table
        language, begin = dialect_named(target), source_table.start
        self._translator = WireTranslator(language, begin, self._name)
        self._motors = MotorRows(play, language, begin, self._name) if play else None
        self.table = _SourceTable(source_table, self._motors)
        self._waiting = deque[Event]()  # of rows to come
        self.count = 0

    @property
    def sha256(self) -> str:
        """The fingerprint of what was sent so far."""
        return self._digest.hexdigest()

    def chunks(self) -> Iterator[Chunk]:
        """Read the file and yield its chunks as they are read back; raises ProgramError at the file's line."""
        states = self.table.states
        for chunk in self._reading.chunks():
            require_straight_axes(Toolpath(self.table.start, [chunk], states), self._name)
            yield from self._sent(*self._translator.translated(chunk, states, self._events()))
        self._sent(self._translator.ended(states, self._events()), _no_rows())
        self.table.end()

    def take_events(self) -> list[Event]:
        """Take the events that were translated."""
        events, self.table.events = list(self.table.events), []
        if self._motors is None:
            return events
        known = self._motors.known
        self.table.events = [event for event in events if event.index > known]
        return [self._motors.event(event) for event in events if event.index <= known]

    def _events(self) -> Iterator[Event]:
        """Yield the program's events, which leave its table."""
        own = self._reading.interpreter.table.events
        self._waiting.extend(own)
        own.clear()
        while self._waiting:
            event = self._waiting.popleft()
            self.table.events.append(event)
            yield event

    def _sent(self, wire: WireText, chunk: Chunk) -> list[Chunk]:
        """Pass the wire text of a chunk on, and return the rows that it makes."""
        chunks = [chunk]
        if self._motors is not None:
            wire, chunks = self._motors.compensated(wire, chunk)
        self._hand_on(wire)
        return chunks

    def _hand_on(self, wire: WireText) -> None:
        self._digest.update(wire.lines.data)
        self._sink(wire)
        self.count += len(wire.lines)
