# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scripted controller of these tests' own: grbl 1.1's manners, without motion; in memory or on a TCP port."""

from __future__ import annotations

import random
import re
import socket
import threading
import time
from collections.abc import Callable

from CNCStepper.errors import LinkError

SETTINGS = {
    13: 0, 32: 0, 100: 80, 101: 80, 102: 400, 110: 5000, 111: 5000, 112: 800, 120: 250, 121: 250, 122: 50,
    130: 400, 131: 400, 132: 80,
}  # fmt: skip
GREETING = "Grbl 1.1h ['$' for help]"
INFO = ("[VER:1.1h.20190830:]", "[OPT:V,15,{rx_bytes}]")


class FakeController:
    """Reads lines at random moments, answers them, and counts what overruns its buffer.

    on_line: what to do instead of `ok`, by the number of the program line from 0: "error:n",
    "ALARM:n", "reset" (as its button does), "brownout" (as its supply does), "silent" (no answer), "cut"
    (the link breaks).
    """

    def __init__(self, clock: Callable[[], float], *, seed: int = 0, line_s: float = 0.002, rx_bytes: int = 128):
        self.clock = clock
        self.random = random.Random(seed)
        self.line_s = line_s
        self.rx_bytes = rx_bytes
        self.rx = bytearray()
        self.out = bytearray()
        self.modes, self.length = "G0 G54 G17 G21 G90 G94", "0.000"  # of `$G`, and the tool's of `$#`
        self.state = "Idle"
        self.place = [10.0, 10.0, 10.0]  # of its work, mm
        self.zero = [-100.0, -50.0, -20.0]  # of its work, G54, in the machine's place
        self.settings = dict(SETTINGS)
        self.info, self.greeting = INFO, GREETING  # of `$I`, and after a reset
        self.named: dict[str, str] = {}  # settings by name, as FluidNC has them
        self.on_line: dict[int, str] = {}
        self.actions: dict[int, Callable[[], None]] = {}
        self.lines: list[str] = []  # read, of the program only
        self.most_bytes = 0
        self.realtime: list[str] = []
        self.alone_broken = 0
        self.cut = False
        self.mute = False
        self.deaf_to_hold = False
        self.keep_moving_s = 0.02  # after the last line was read
        self.report_extra = ""
        self._after_hold = "Idle"
        self._busy_s = 0.0
        self._hold_s = 0.0
        self._next_s = 0.0
        self._wco_countdown = 0

    # --- the wire ------------------------------------------------------------------------------

    def write(self, data: bytes) -> None:
        """Take bytes from the sender."""
        for byte in data:
            if byte in b"?!~\x18" or byte > 0x7F:
                self._act(chr(byte))
            else:
                self.rx.append(byte)
        self.most_bytes = max(self.most_bytes, len(self.rx))

    def read(self) -> bytes:
        """Hand out what is to be said at this moment."""
        if self.cut:
            raise LinkError("link-lost", "the cable is out")
        self._live()
        said, self.out = bytes(self.out), bytearray()
        return b"" if self.mute else said

    def say(self, text: str) -> None:
        self.out += text.encode("latin-1") + b"\r\n"

    # --- its life ------------------------------------------------------------------------------

    def _act(self, byte: str) -> None:
        self.realtime.append(byte)
        if byte == "?":
            self._live()
            self._report()
        elif byte == "!" and self.state in ("Idle", "Run") and not self.deaf_to_hold:
            self._hold_s = self.clock() + (0.05 if self.state == "Run" else 0)
            self.state = "Hold"
        elif byte == "~" and self.state == "Hold" and self._held():
            self.state = "Run"
            self._busy_s = self.clock() + self.keep_moving_s
            self._answer_pause()
        elif byte == "\x18":
            self.reset()

    def reset(self) -> None:
        """Soft reset, as its button or 0x18 do it."""
        moving = self.state == "Run" or (self.state == "Hold" and not self._held())
        self.rx.clear()
        self._paused = False
        if moving:
            self.say("ALARM:3")
        self.state = "Alarm" if moving or self.state == "Alarm" else "Idle"
        self.say("")
        self.say(self.greeting)
        if self.state == "Alarm":
            self.say("[MSG:'$H'|'$X' to unlock]")

    _paused = False

    def _held(self) -> bool:
        return self.clock() >= self._hold_s

    def _answer_pause(self) -> None:
        if self._paused:
            self._paused = False
            self.say("ok")

    def _live(self) -> None:
        while not self.cut and self.state in ("Idle", "Run", "Alarm") and not self._paused and b"\n" in self.rx:
            if self.clock() < self._next_s:
                return
            line, _, self.rx = self.rx.partition(b"\n")
            self._next_s = self.clock() + self.random.expovariate(1 / self.line_s) if self.line_s else 0.0
            self._line(line.decode("ascii"))
        if self.state == "Run" and self.clock() > self._busy_s:
            self.state = "Idle"

    def _line(self, line: str) -> None:
        if line.startswith("$"):
            self._system(line)
            return
        number = len(self.lines)
        self.lines.append(line)
        if any(word in line for word in ("G10 ", "G28.1", "G30.1")) and self.rx:
            self.alone_broken += 1
        action = self.on_line.get(number, "ok")
        if number in self.actions:
            self.actions[number]()
        if self.state == "Alarm":
            action = "error:9"
        elif self.state == "Idle":
            self.state = "Run"
        self._busy_s = self.clock() + self.keep_moving_s
        self._go(line)
        self._do(action, line)

    def _go(self, line: str) -> None:
        """Stand where a line leads, in work coordinates, at once."""
        if not line.startswith(("G10", "G28", "G30")):
            for letter, value in re.findall(r"([XYZ])(-?[0-9.]+)", line):
                self.place["XYZ".index(letter)] = float(value)

    def _do(self, action: str, line: str) -> None:
        if action == "cut":
            self.cut = True
        elif action == "reset":
            self.reset()
        elif action == "brownout":
            self.state = "Idle"
            self.reset()
        elif action.startswith("ALARM"):
            self.say(action)
            self.state = "Alarm"
        elif line == "M0":
            self.state, self._hold_s, self._paused = "Hold", self.clock(), True
        elif action != "silent":
            self.say(action)

    def _system(self, line: str) -> None:
        if "=" in line and self.rx:
            self.alone_broken += 1
        if line == "$I":
            for text in self.info:
                self.say(text.format(rx_bytes=self.rx_bytes))
        elif line in self.named:
            self.say(f"{line}={self.named[line]}")
        elif line == "$$":
            for number, value in self.settings.items():
                self.say(f"${number}={value}")
        elif line == "$#":
            self.say(f"[G54:{_vector(self.zero)}]")
            self.say(f"[TLO:{self.length}]")
            self.say("[PRB:0.000,0.000,0.000:0]")
        elif line == "$G":
            self.say(f"[GC:{self.modes} M5 M9 T0 F0 S0]")
        self.say("error:9" if self.state == "Alarm" else "ok")

    def _report(self) -> None:
        state = self.state
        if state == "Hold":
            state = "Hold:0" if self._held() else "Hold:1"
        self._wco_countdown -= 1
        wco = ""
        if self._wco_countdown < 0:
            self._wco_countdown, wco = 5, f"|WCO:{_vector(self.zero)}"
        unit = 25.4 if self.settings.get(13) else 1.0
        place = _vector([work / unit + zero for work, zero in zip(self.place, self.zero, strict=True)])
        fields = f"MPos:{place}|FS:500,8000{wco}{self.report_extra}"
        self.say(f"<{state}|{fields}>")


def _vector(values: list[float]) -> str:
    return ",".join(f"{value:.3f}" for value in values)


class FakeClock:
    """Time that passes only where a test lets it."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


class Unqueued:
    """A Link's words about its queue, for a link of a clock's own time in which nothing that is written waits."""

    clock: FakeClock
    woken = False
    machine = ""
    queue_bytes = 40
    filling_bytes = 30

    def rest(self, wait_s: float) -> None:
        self.woken = False
        self.clock.now_s += wait_s

    def waiting_bytes(self) -> int:
        return 0

    def leaving_s(self, count: int) -> float:
        return 0.0


class FakeLink(Unqueued):
    """A Link to a controller in memory, in its clock's time."""

    name = "fake"

    def __init__(self, controller: FakeController, clock: FakeClock):
        self.controller = controller
        self.clock = clock
        self.closed = False
        self._woken = False

    def read(self, wait_s: float) -> bytes:
        end_s = self.clock.now_s + wait_s
        while True:
            said = self.controller.read()
            self.clock.now_s += 0.0005
            if said or self._woken or self.clock.now_s >= end_s:
                self.woken, self._woken = self._woken, False
                return said

    def write(self, data: bytes) -> None:
        if self.controller.cut:
            raise LinkError("link-lost", "the cable is out")
        self.controller.write(data)

    def wake(self) -> None:
        self._woken = True

    def close(self) -> None:
        self.closed = True


class FakeServer:
    """The same controller on a TCP port of its own, in real time."""

    def __init__(self, **options) -> None:
        self.controller = FakeController(time.monotonic, **options)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.url = f"socket://127.0.0.1:{self._listener.getsockname()[1]}"
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._serve, daemon=True)

    def __enter__(self) -> FakeServer:
        self._thread.start()
        return self

    def __exit__(self, *error) -> None:
        self._ended.set()
        self._thread.join(5)
        self._listener.close()

    def _serve(self) -> None:
        self._listener.settimeout(0.05)
        while not self._ended.is_set():
            try:
                connection, _ = self._listener.accept()
            except TimeoutError:
                continue
            with connection:
                self._talk(connection)

    def _talk(self, connection: socket.socket) -> None:
        connection.settimeout(0.001)
        while not self._ended.is_set():
            try:
                data = connection.recv(4096)
                if not data:
                    return
                self.controller.write(data)
            except TimeoutError:
                pass
            except OSError:
                return
            try:
                connection.sendall(self.controller.read())
            except (LinkError, OSError):
                return
