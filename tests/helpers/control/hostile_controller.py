# SPDX-License-Identifier: LGPL-2.1-or-later
"""A controller that begins at some moment to lie, to flood, or to ignore what it is told; on a TCP port."""

from __future__ import annotations

import time

from helpers.control.fake_controller import FakeController, FakeServer, _vector

LONG = "9" * 5000
PLACE = "MPos:-90.000,-40.000,-10.000"
REPORTS = {  # what it answers to `?`
    "invented-state": f"<Foo|{PLACE}|FS:0,0>",
    "homing-state": f"<Home|{PLACE}|FS:0,0>",
    "starting-state": f"<Starting|{PLACE}|FS:0,0>",
    "long-number": f"<Run|MPos:{LONG},0,0|FS:0,0>",
    "nan": "<Run|MPos:nan,0,0|FS:0,0>",
    "infinity": "<Run|MPos:inf,-inf,0|FS:0,0>",
    "huge": "<Run|MPos:1e308,0,0|FS:0,0>",
    "jump": "<Run|MPos:-999999.000,0.000,0.000|FS:0,0>",
    "half": "<Run|MPos:1.0",
}
FLOODS = {  # what it says besides, again and again
    "ok": b"ok\r\n",
    "statuses": f"<Run|{PLACE}|FS:0,0>\r\n".encode(),
    "messages": b"[MSG:\x1b]0;again\x07]\r\n",
    "damaged": f"<Run|MPos:{LONG},0,0>\r\n".encode(),
    "alarms": b"ALARM:\r\n",
    "settings": b"$100=80.000\r\n",
    "noise": b"\xff\x00\x1b[2Jx" * 50,
}
ONCE = {"greeting": b"\r\nGrbl 1.1h ['$' for help]\r\n", "stray-ok": b"ok\r\n" * 60}
FAULTS = (*REPORTS, *FLOODS, *ONCE, "wco")


class HostileController(FakeController):
    """Does what `fault` says as soon as that is set; `heard` is what it was sent, with when."""

    fault = ""

    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.heard: list[tuple[float, bytes]] = []
        self.deaf = False  # says nothing and does nothing
        self.answers_questions = True  # of `$`
        self.homes = True
        self._said_once = False

    def write(self, data: bytes) -> None:
        self.heard.append((time.monotonic(), data))
        if not self.deaf:
            super().write(data)

    def heard_since(self, begin_s: float) -> bytes:
        """Return what it was sent since a moment."""
        return b"".join(data for when_s, data in self.heard if when_s >= begin_s)

    def read(self) -> bytes:
        if self.deaf:
            return b""
        said = super().read()
        if self.fault in FLOODS:
            flood = FLOODS[self.fault]
            said += flood * max(1, 800 // len(flood))
        elif self.fault in ONCE and not self._said_once:
            self._said_once = True
            said += ONCE[self.fault]
        return said

    def _report(self) -> None:
        if self.fault in REPORTS:
            self.say(REPORTS[self.fault])
        elif self.fault == "wco":
            place = _vector([work + zero for work, zero in zip(self.place, self.zero, strict=True)])
            self.say(f"<{self.state}|MPos:{place}|FS:0,0|WCO:-100.000,-49.000,-20.000>")
        elif self.fault == "runs-on":
            self.say(f"<Run|MPos:{time.monotonic() % 100:.3f},0.000,0.000|FS:0,0>")
        elif self.fault == "never-slower":
            self.say(f"<Hold:1|{PLACE}|FS:0,0>")
        else:
            super()._report()

    def _system(self, line: str) -> None:
        if line == "$H" and not self.homes:
            self.state = "Home"
        elif self.answers_questions:
            super()._system(line)


class HostileServer(FakeServer):
    """The same on a TCP port."""

    def __init__(self, **options) -> None:
        super().__init__(**options)
        self.controller = HostileController(time.monotonic, **options)
