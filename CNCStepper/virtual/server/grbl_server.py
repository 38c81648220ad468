# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual grbl as a program: a board, its serial line and its clock behind a port.

The board is powered up when the first client comes, so that the client reads the greeting. Later clients find it as the
last one left it: opening the port does not reset it. With `restarts` it does, as on a board whose reset is wired to the
adapter's DTR line.

Simulated time runs `speed` times as fast as the clock on the wall, in small steps with a look at the
port between them. A server that was kept waiting by the system does not make up for the time lost,
or its client could not follow.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from math import inf
from pathlib import Path

from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import Machine
from CNCStepper.virtual.faults.host_faults import kill_sender
from CNCStepper.virtual.faults.plan import Fault, FaultPlan
from CNCStepper.virtual.grbl.firmware import GRBL, Firmware
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server.fault_proxy import FaultyLink
from CNCStepper.virtual.server.path_trace import Trace
from CNCStepper.virtual.server.ports import Port
from CNCStepper.virtual.server.serial_line import Link
from CNCStepper.virtual.server.serving import check_port_choice, open_server_port, stopped_by_signals

SHORTEST_STEP_S, LONGEST_STEP_S = 0.001, 0.01  # of simulated time
STEP_S = 0.0001  # of real time, within those bounds
QUIET_WAIT_S = 0.02
POWER_UP_S = 0.1  # a client that opens a port throws away what came before
LONGEST_LAG_S = 0.0015  # of real time, made up for at once: less than the 2 ms that a client keeps before a quick line
NOBODY_CAME_S = 30.0  # after which a server that serves until it is left ends


class Server:
    """Runs a board behind a port until `stop` is called or, with `until_left`, its client has left or none came.

    each_step: called between two steps of the board. reopened: called when a later client opens the port.
    """

    def __init__(
        self,
        link: Link | FaultyLink,
        port: Port,
        speed: float = 1.0,
        trace: Trace | None = None,
        until_left: bool = False,
        each_step: Callable[[], None] = lambda: None,
        reopened: Callable[[], None] = lambda: None,
    ):
        self._link = link
        self._port = port
        self._speed = speed
        self._trace = trace
        self._until_left = until_left
        self._each_step = each_step
        self._reopened = reopened
        self._is_open = True  # once the first client has come
        self._stopping = False
        self._step_s = min(max(STEP_S * speed, SHORTEST_STEP_S), LONGEST_STEP_S)

    def stop(self) -> None:
        """Let `run` return; may be called from a signal handler or another thread."""
        self._stopping = True

    def run(self) -> None:
        """Serve until stopped."""
        self._wait_for_first_client()
        due_s, last = 0.0, time.monotonic()
        while not self._stopping and not self._was_left:
            self._exchange(QUIET_WAIT_S if self._link.quiet else max(self._step_s - due_s, 0.0) / self._speed)
            now = time.monotonic()
            due_s += min(now - last, LONGEST_LAG_S) * self._speed
            last = now
            due_s = self._advance(due_s)
            self._look_who_is_there()
            if isinstance(self._link, FaultyLink) and self._link.take_cut():
                self._port.hang_up()
            if self._trace and self._link.quiet:
                self._trace.flush()

    def _look_who_is_there(self) -> None:
        connected = self._port.connected
        if connected and not self._is_open:
            self._reopened()
        self._is_open = connected

    @property
    def _was_left(self) -> bool:
        return self._until_left and not self._port.connected

    def _wait_for_first_client(self) -> None:
        end_s = time.monotonic() + (NOBODY_CAME_S if self._until_left else inf)
        while not self._stopping and not self._port.connected and not self._port.wait(QUIET_WAIT_S):
            if time.monotonic() > end_s:
                return
        time.sleep(POWER_UP_S)

    def _advance(self, due_s: float) -> float:
        """Let the time due pass; return what is left, less than a step."""
        while due_s >= self._step_s and not self._stopping:
            step_s = due_s if self._link.quiet else self._step_s
            self._link.advance(step_s)
            due_s -= step_s
            self._exchange(0.0)
            self._each_step()
        return due_s

    def _exchange(self, timeout_s: float) -> None:
        """Send what has come from the board, then take what the client has for it."""
        output = self._link.receive()
        if output:
            self._port.write(output)
        room = self._link.room
        if not room:
            time.sleep(timeout_s)
        elif self._port.wait(timeout_s):
            self._link.send(self._port.read(room))


def serve(
    machine: Machine,
    *,
    pty: str | Path | None = None,
    tcp: str | None = None,
    speed: float = 1.0,
    baud: int = 115200,
    trace: str | Path | None = None,
    homing: bool = False,
    probe_height_mm: float | None = None,
    until_left: bool = False,
    restarts: bool = False,
    firmware: Firmware = GRBL,
    ready: Callable[[str], None] | None = None,
    faults: FaultPlan | None = None,
    told: Callable[[Fault, float], None] = lambda fault, time_s: None,
    visit: Callable[[Grbl], Callable[[], None]] = lambda board: _nothing,
) -> None:
    """Be a board on `machine` until SIGTERM or SIGINT comes.

    With `until_left` it also ends when its client has left, or none has come within 30 s; with `restarts` the board
    powers up anew at each opening of its port.

    pty: path that becomes a link to a pseudo-terminal. tcp: "HOST:PORT", port 0 for any that is free.
    speed: simulated seconds in a real one. baud: of the serial line, in simulated time. trace: CSV file
    for the path of the axes. homing: $22=1, locked at power-up. probe_height_mm: machine height of a
    probe plate. firmware: what it greets, answers and refuses as. ready: called with the address (path,
    or socket://HOST:PORT) once clients may come. faults: what goes wrong on the way; told hears of each as it
    happens, with the simulated time in s. visit: gets the board and returns what is called between two of its
    steps, for a hand at its pins.
    Raises LinkError when the port cannot be opened or a value makes no sense; nothing is left behind.
    """
    check_port_choice(speed, pty, tcp)
    if not 300 <= baud <= 10_000_000:
        what, advice = "the baud rate is out of range", "give a rate within the limit"
        raise LinkError("baud", what, value=str(baud), limit="300 to 10000000", advice=advice)
    with contextlib.ExitStack() as stack:
        _compile(machine)
        board = Grbl(machine, homing=homing, probe_height_mm=probe_height_mm, firmware=firmware)
        each_step = visit(board)
        record = stack.enter_context(contextlib.closing(Trace(trace, board))) if trace else None
        port = open_server_port(pty, tcp)
        stack.callback(port.close)
        line = Link(board, baud)
        link = FaultyLink(line, faults, outside=kill_sender, told=told) if faults else line
        server = Server(link, port, speed, record, until_left, each_step, board.power_up if restarts else _nothing)
        stack.enter_context(stopped_by_signals(server.stop))
        if ready:
            ready(port.address)
        server.run()


def _nothing() -> None:
    """Nobody is at the board."""


def _compile(machine: Machine) -> None:
    """Let a scratch board make every kind of move, so that no kernel is compiled under a client's eyes."""
    board = Grbl(machine)
    for data in (b"G1X1F600\nG2X2I.5\n", b"\x91!", b"~", b"\x18"):
        board.receive(data)
        for _ in range(10):
            board.advance(0.02)
