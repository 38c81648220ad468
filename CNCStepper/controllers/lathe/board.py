# SPDX-License-Identifier: LGPL-2.1-or-later
"""The board that a sender meets: grbl 1.1's lines, real-time bytes and status, in front of the mini-lathe.

    Idle ──$J──► Jog ──its time, 0x85, !──► Idle          manual mode
    Idle ──records──► Run ──all is done──► Idle           automatic mode, for good
                       `──!──► Hold:1 ──what it has is done──► Hold:0 ──~──► Run

A hold or a reset sends nothing more; the lathe cuts what it has, and a message says for how long. Positions are
reckoned.
"""

from __future__ import annotations

from collections.abc import Callable

from CNCStepper.control.protocol.lathe.serial_port import LathePort, open_port
from CNCStepper.controllers.lathe.answers import FIRMWARE, Answers
from CNCStepper.controllers.lathe.chunk_sender import Program
from CNCStepper.controllers.lathe.manual import Manual
from CNCStepper.controllers.lathe.outward_line import OutwardLine
from CNCStepper.controllers.lathe.records import RecordReader
from CNCStepper.controllers.lathe.typed_jog import jog_of
from CNCStepper.errors import LinkError, MachineRefusal
from CNCStepper.gcode.dialects import dialect_named
from CNCStepper.machine.lathe_link import LatheLink
from CNCStepper.machine.profile import Machine
from CNCStepper.safe_text import printable
from CNCStepper.units import S_PER_MIN
from CNCStepper.virtual.grbl.alarms_and_errors import ALARM_RESET_IN_MOTION, refused
from CNCStepper.virtual.grbl.realtime import ACTING, DOOR, FIRST_EXTENDED, HOLD, JOG_CANCEL, RESET, START, STATUS
from CNCStepper.virtual.grbl.serial_buffer import TOO_LONG, LineReader, RxRing

CHECK_EVERY_S = 0.1  # of the port
ZERO_STEPS = 2  # so far from the work zero a program may begin: a jog back is no better
OVERFLOW, LOCKED, NOT_IDLE = 11, 9, 8
SWITCH_ON_AGAIN = "switch the lathe off and on, connect again and set its zero"
ONE_WAY = (
    "automatic mode: from here on the link cannot stop the lathe, and only switching it off returns it to manual mode"
)


class LatheBoard:
    """The mini-lathe at a port, on the caller's clock: call `advance` every 2 ms while it moves."""

    def __init__(self, machine: Machine, port: LathePort):
        axes = machine.own_axes
        self._per_mm = (axes["x"].steps_per_mm, axes["z"].steps_per_mm)
        self._machine, self._line = machine, OutwardLine(port)
        link = machine.link or LatheLink()
        dialect = dialect_named(machine.language())
        index_s = S_PER_MIN / max(machine.spindle.min_rpm, 1.0) if dialect.waits_for_index else 0.0
        self._reader = RecordReader(dialect, self._per_mm, link.ahead_bytes - 1)
        self.manual = Manual(self._line, self._per_mm)
        self.program = Program(self._line, link, self._reader.first_modes(), index_s)
        self._answers = Answers(machine)
        self._ring, self._lines = RxRing(FIRMWARE.receive_bytes), LineReader(FIRMWARE)
        self._line_in_hand: str | None = None
        self.time_s, self._checked_s = 0.0, 0.0
        self._jog_said = ""  # of the last jog: a held one comes in many pieces
        self._was_refused = self._lost = False  # a record, until a reset; the port, for good
        self._output = bytearray()
        self._greet()
        if port.note:
            self._say(port.note)
        self._say("switch the lathe on in manual mode before it moves; its position is reckoned, nothing reports it")

    # -- the outside ---------------------------------------------------------------------------------

    def receive(self, data: bytes) -> None:
        """Take bytes from the sender."""
        for part in filter(None, ACTING.split(data)):
            if part[0] in self._acting:
                self._guarded(self._acting[part[0]])
            elif part[0] < FIRST_EXTENDED:
                self._ring.put(part)
        self._guarded(self._work)

    def advance(self, dt_s: float) -> None:
        """Take note that `dt_s` seconds have passed."""
        self.time_s += dt_s
        self._guarded(self._work)

    def take_output(self) -> bytes:
        """Return the bytes that the board has sent since the last call."""
        output = bytes(self._output)
        self._output.clear()
        return output

    @property
    def quiet(self) -> bool:
        """Whether it only waits for bytes: nothing moves, no line is in hand."""
        busy = self.manual.active or self.program.moving or (self.program.waits and not self.program.held)
        return not busy and self._ring.empty and self._line_in_hand is None

    @property
    def at_rest(self) -> bool:
        """Whether all bytes are sent: the lathe runs a program that it has received by itself."""
        return self._lost or (not self.manual.active and self._line.is_empty(self.time_s))

    def come_to_rest(self) -> None:
        """Release a jog and send nothing more of a program, for the end of the process."""
        self._guarded(self._stop)

    def close(self) -> None:
        """Release a jog and give the port back."""
        self.come_to_rest()
        self._line.close()

    # -- its state -----------------------------------------------------------------------------------

    @property
    def state(self) -> str:
        """The state as a status report has it."""
        if self._lost:
            return "Alarm"
        if self.manual.active:
            return "Jog"
        if self.program.held:
            return "Hold:1" if self.program.moving else "Hold:0"
        return "Run" if self.program.moving or self.program.waits else "Idle"

    @property
    def places_mm(self) -> tuple[float, float, float]:
        """Where X (as a radius), Y (always 0) and Z are reckoned to be, from where they began."""
        x, z = self.manual.places_at(self.time_s)
        x_more, z_more = self.program.place_at(self.time_s)
        return (x + x_more) / self._per_mm[0], 0.0, (z + z_more) / self._per_mm[1]

    # -- real-time bytes -----------------------------------------------------------------------------

    @property
    def _acting(self) -> dict[int, Callable[[], None]]:
        return {
            STATUS: self._report,
            HOLD: self._hold,
            DOOR: self._hold,
            JOG_CANCEL: self._cancel_jogs,
            START: self._go_on,
            RESET: self._reset,
        }

    def _report(self) -> None:
        speed_mm_s = self.manual.speed_mm_s(self.time_s) + self.program.speed_mm_s(self.time_s, self._per_mm)
        left_s = self.program.left_s(self.time_s)
        queued = None if self._lost else self.program.queued_lines
        self._send(self._answers.status(self.state, self.places_mm, speed_mm_s * 60.0, self._ring.free, left_s, queued))

    def _cancel_jogs(self) -> None:
        """End the jog under way; jogs that came behind it are answered, and not made."""
        self.manual.stop(self.time_s)
        while (line := self._read_line()) is not None and line.startswith("$J"):
            self._line_in_hand = None
            self._send("ok")

    def _hold(self) -> None:
        self._cancel_jogs()
        if self.program.moving or self.program.waits:
            self.program.held = True
            self._say_what_is_left()

    def _go_on(self) -> None:
        self.program.held = False

    def _reset(self) -> None:
        if self.program.moving:
            self._say_what_is_left()
        self._stop()
        self._ring.clear()
        self._lines.clear()
        self._line_in_hand, self._was_refused = None, False
        self._greet()

    def _stop(self) -> None:
        self.manual.stop(self.time_s)
        self.program.forget()

    def _say_what_is_left(self) -> None:
        left_s = self.program.left_s(self.time_s)
        if left_s > 0.0:
            x, z = self._program_end_mm()
            self._say(f"the lathe cannot be stopped over its link: it runs on for {left_s:.1f} s, to X{x:.3f} Z{z:.3f}")

    def _program_end_mm(self) -> tuple[float, float]:
        """Return the work position of the lathe after all moves that it has."""
        here, end = self.manual.places, self.program.end_place
        zero = self._answers.zero_mm
        x, z = ((a + b) / per_mm for a, b, per_mm in zip(here, end, self._per_mm, strict=True))
        return x - zero[0], z - zero[2]

    # -- lines ---------------------------------------------------------------------------------------

    def _work(self) -> None:
        """Do what time has made due, and take the lines for which there is room."""
        if self._lost:
            return
        if self.time_s - self._checked_s > CHECK_EVERY_S:
            self._checked_s = self.time_s
            self._line.check()
        self.manual.advance(self.time_s)
        self.program.advance(self.time_s)
        while (line := self._next_line()) is not None:
            self._answer(line)
        self.program.advance(self.time_s)

    def _next_line(self) -> str | None:
        """Return the next line that can be taken now, None where there is none."""
        line = self._read_line()
        if line is None or not self._has_room(line):
            return None
        self._line_in_hand = None
        return line

    def _read_line(self) -> str | None:
        """Return the line in hand, the next one of the buffer where there is none; None where that has none."""
        if self._line_in_hand is None:
            self._line_in_hand = self._lines.next_line(self._ring)
        return self._line_in_hand

    def _has_room(self, line: str) -> bool:
        """Return whether there is room for the records of a line."""
        if line.startswith("$J"):
            return self.program.begun or self.manual.has_room(self.time_s)
        return line.startswith("$") or self.program.has_room

    def _answer(self, line: str) -> None:
        try:
            self._carry_out(line)
        except MachineRefusal as refusal:
            self._send(refusal.code)
        else:
            self._send("ok")

    def _carry_out(self, line: str) -> None:
        if line == TOO_LONG:
            raise refused(OVERFLOW)
        if line.startswith("$J="):
            self._jog(line)
        elif line.startswith("$"):
            for answer in self._answers.command(line, self.state):
                self._send(answer)
        elif "#" in line:
            self._take_records(line)
        elif line:
            self._set_zero(line)

    def _jog(self, line: str) -> None:
        if self.program.begun:
            self._say(f"the lathe is in automatic mode and cannot be jogged: {SWITCH_ON_AGAIN}")
            raise refused(LOCKED)
        if self.state not in ("Idle", "Jog"):
            raise refused(NOT_IDLE)
        jog, said = jog_of(line, self._machine, self._answers.zero_mm, self.places_mm)
        if said and said != self._jog_said:
            self._say(said)
        self._jog_said = said
        if jog:
            self.manual.add(jog, self.time_s)

    def _take_records(self, line: str) -> None:
        if self.manual.active:
            raise refused(LOCKED)
        if self._was_refused or self.program.over:
            why = "its program has ended with M02" if self.program.over else "a record was refused: reset first"
            self._say(f"nothing more is sent to the lathe: {why}")
            raise refused(LOCKED)
        try:
            records = self._reader.read(line, self.program.modes)
            if not self.program.begun and not self.program.waits:
                self._begin_program()
        except MachineRefusal:
            self._was_refused = self.program.begun or self.program.waits
            raise
        self.program.add(records)

    def _begin_program(self) -> None:
        """Tell what automatic mode means; raises MachineRefusal where the tool is not at the work zero."""
        away = [
            abs(place - zero) * per_mm
            for place, zero, per_mm in zip(self.places_mm[::2], self._answers.zero_mm[::2], self._per_mm, strict=True)
        ]
        if max(away) > ZERO_STEPS + 0.01:
            self._say("the tool is not at the work zero, where a program begins: jog it there, or set the zero here")
            raise refused(LOCKED)
        self._say(ONE_WAY)

    def _set_zero(self, line: str) -> None:
        if self.state != "Idle":
            raise refused(LOCKED)
        if self.program.begun:
            self._say(f"the zero of the lathe can be set in manual mode only: {SWITCH_ON_AGAIN}")
            raise refused(LOCKED)
        self._answers.set_zero(line, self.places_mm)

    # -- output --------------------------------------------------------------------------------------

    def _greet(self) -> None:
        self._send(f"\r\n{FIRMWARE.banner}")

    def _say(self, text: str) -> None:
        self._send(f"[MSG:{text}]")

    def _send(self, line: str) -> None:
        self._output += line.encode("ascii", "replace") + b"\r\n"

    def _guarded(self, action: Callable[[], None]) -> None:
        """Call a function with the port; at its loss report that and lock the board: the position is lost."""
        try:
            action()
        except LinkError as error:
            if not self._lost:
                self._lost = True
                self._say(printable(str(error), 300))
                self._send(f"ALARM:{ALARM_RESET_IN_MOTION}")


def open_lathe(machine: Machine, port: str) -> LatheBoard:
    """Return the board of the mini-lathe at a port; raises LinkError where the port cannot be had."""
    return LatheBoard(machine, open_port(port))
