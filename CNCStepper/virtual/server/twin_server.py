# SPDX-License-Identifier: LGPL-2.1-or-later
"""A published machine without hardware as a program: behind a port, by the clock on the wall.

Its bytes are its clock where the computer makes the pulses (parallel port, board): each read notes between which times
its bytes came. A machine that was delayed catches up, since no client waits for its answers.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from math import inf
from pathlib import Path

from CNCStepper.virtual.server.ports import Port
from CNCStepper.virtual.server.serving import check_port_choice, open_server_port, stopped_by_signals
from CNCStepper.virtual.server.step_trace import ByteRecord, StepTrace
from CNCStepper.virtual.server.twin_faults import FaultyTwin, Twin

WORK_S = 0.005  # of real time, between two looks at what has come
NOBODY_CAME_S = 30.0  # after which a server that serves until it is left ends
FLUSH_S = 0.2
SAME_NOTE_S = 1.0  # of real time: the same note within it is counted and not told again
Tell = Callable[[float, str], None]


class Notes:
    """Prints each note once, then once a second how often it was repeated, so that a reader is not flooded."""

    def __init__(self, tell: Tell):
        self._tell = tell
        self._told: dict[str, tuple[float, int]] = {}  # when, on the wall's clock, and how often since

    def note(self, time_s: float, text: str) -> None:
        """Take a note of a machine's time."""
        if text in self._told:
            told_s, count = self._told[text]
            self._told[text] = told_s, count + 1
        else:
            self._tell(time_s, text)
            self._told[text] = time.monotonic(), 0

    def sum_up(self, time_s: float, ends: bool = False) -> None:
        """Tell how often the notes of a second ago came again; all of them where it ends."""
        now_s = time.monotonic()
        for text, (told_s, count) in list(self._told.items()):
            if ends or now_s - told_s > SAME_NOTE_S:
                del self._told[text]
                if count:
                    self._tell(time_s, f"{text} ({count} times more)")


class TwinServer:
    """Runs a machine behind a port until `stop` is called or, with `until_left`, its client has left or none came.

    note: told what happens, with the machine's time in s. each_step: called between two looks at the port.
    """

    def __init__(
        self,
        twin: Twin,
        port: Port,
        *,
        speed: float = 1.0,
        trace: StepTrace | None = None,
        record: ByteRecord | None = None,
        until_left: bool = False,
        note: Tell = lambda time_s, text: None,
        each_step: Callable[[], None] = lambda: None,
    ):
        self._twin = twin
        self._port = port
        self._speed = speed
        self._trace, self._record = trace, record
        self._until_left = until_left
        self._notes, self._each_step = Notes(note), each_step
        self._stopping = self._ends = self._had_client = self._was_connected = False
        self._begin_s = time.monotonic()
        self._since_s = self._flushed_s = 0.0

    def stop(self) -> None:
        """Let `run` return; may be called from a signal handler or another thread."""
        self._stopping = True

    def run(self) -> None:
        """Serve until stopped."""
        nobody_s = NOBODY_CAME_S if self._until_left else inf
        while not self._stopping:
            self._look(WORK_S)
            self._advance()
            if self._until_left and self._was_left(nobody_s):
                break
        self._ends = True
        self._twin.advance(self._now_s())
        self._write_out()

    def _now_s(self) -> float:
        """The machine's time."""
        return (time.monotonic() - self._begin_s) * self._speed

    def _was_left(self, nobody_s: float) -> bool:
        """Whether the client has gone and what it sent has been done; or none came at all."""
        if not self._had_client:
            return time.monotonic() - self._begin_s > nobody_s
        return not self._port.connected and self._twin.quiet

    def _look(self, seconds: float) -> None:
        """Read what comes within a time."""
        end = time.monotonic() + seconds
        while not self._stopping:
            left = end - time.monotonic()
            room = self._twin.room
            if left <= 0:
                return
            if not room:
                time.sleep(min(left, WORK_S))
                return
            before_s = self._now_s()
            came = self._port.wait(left)
            self._meet_client()
            if came:
                self._read(room)
            else:
                self._since_s = before_s

    def _read(self, room: int) -> None:
        before_s = self._now_s()  # what comes behind this moment may not be read now
        data = self._port.read(room)
        now_s = self._now_s()
        if data:
            self._had_client = True
            if self._record:
                self._record.note(data)
            self._twin.receive(data, self._since_s, now_s)
        self._since_s = before_s

    def _meet_client(self) -> None:
        connected = self._port.connected
        if connected and not self._was_connected:
            self._had_client = True
            self._twin.open()
            self._send()
        self._was_connected = connected

    def _advance(self) -> None:
        self._twin.advance(self._now_s())
        self._each_step()
        self._send()
        if isinstance(self._twin, FaultyTwin) and self._twin.take_cut():
            self._port.hang_up()
            self._was_connected = False
        self._write_out()

    def _send(self) -> None:
        if output := self._twin.take_output():
            self._port.write(output)

    def _write_out(self) -> None:
        """Hand over the path and the notes, and put on disk what a killed machine shall leave."""
        path = self._twin.take_path()
        if self._trace:
            self._trace.note(path)
        for time_s, text in self._twin.take_notes():
            self._notes.note(time_s, text)
        self._notes.sum_up(self._twin.time_s, ends=self._ends)
        rests, now = self._twin.quiet, time.monotonic()
        if self._trace and rests:
            self._trace.rest(self._twin.time_s, self._twin.places_mm)
        if rests or self._ends or now - self._flushed_s > FLUSH_S:
            self._flushed_s = now
            for file in (self._record, self._trace):
                if file:
                    file.flush()


def serve_twin(
    twin: Twin,
    *,
    pty: str | Path | None = None,
    tcp: str | None = None,
    speed: float = 1.0,
    trace: str | Path | None = None,
    record: str | Path | None = None,
    until_left: bool = False,
    ready: Callable[[str], None] = lambda address: None,
    note: Tell = lambda time_s, text: None,
    each_step: Callable[[], None] = lambda: None,
) -> None:
    """Be a machine behind a port until SIGTERM or SIGINT comes.

    With `until_left` it also ends when its client has left and it rests, or when none has come within 30 s.

    pty: path that becomes a link to a pseudo-terminal. tcp: "HOST:PORT", port 0 for any that is free. speed: simulated
    seconds in a real one. trace: CSV file of the axes' places. record: file of the bytes as they come. ready: called
    with the address once clients may come. note: told what happens, with the simulated time in s.
    Raises LinkError when the port or a file cannot be opened; nothing is left behind.
    """
    check_port_choice(speed, pty, tcp)
    with contextlib.ExitStack() as stack:
        rows = stack.enter_context(contextlib.closing(StepTrace(trace, twin.columns))) if trace else None
        raw = stack.enter_context(contextlib.closing(ByteRecord(record))) if record else None
        port = open_server_port(pty, tcp)
        stack.callback(port.close)
        server = TwinServer(
            twin, port, speed=speed, trace=rows, record=raw, until_left=until_left, note=note, each_step=each_step
        )
        stack.enter_context(stopped_by_signals(server.stop))
        ready(port.address)
        server.run()
