# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the call of `hold` in a window to the byte on the wire, in a job of 100 000 lines; more and more is busy."""

from __future__ import annotations

import json
import multiprocessing
import socket
import tempfile
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from queue import SimpleQueue

from CNCStepper.control.desk_client import DeskClient
from CNCStepper.control.send_job import SendJob

LINES = 100_000
HOLDS = 200
LINE_S = 0.002
REALTIME = b"!~?\x18"
GREETING = b"\r\nGrbl 1.1h ['$' for help]\r\n"
ANSWERS = {
    b"$I": b"[VER:1.1h.20190830:]\r\n[OPT:V,15,128]\r\n",
    b"$$": b"$13=0\r\n$22=0\r\n",
    b"$#": b"[G54:0.000,0.000,0.000]\r\n[G92:0.000,0.000,0.000]\r\n",
    b"$G": b"[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\n",
}


class Wire:
    """A controller that answers, and stands at 0 while it says that it moves; it notes when `!` came."""

    def __init__(self, notes: Connection):
        self._notes = notes
        self._state = b"Idle"
        self._tail = b""
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._lines: SimpleQueue[bytes] = SimpleQueue()
        notes.send("socket://{}:{}".format(*self._listener.getsockname()))

    def serve(self) -> None:
        """Serve one client until it leaves."""
        connection, _ = self._listener.accept()
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        connection.sendall(GREETING)
        threading.Thread(target=self._obey, args=(connection,), daemon=True).start()
        while data := connection.recv(4096):
            now_s = time.monotonic()
            for byte in (bytes([number]) for number in data if number in REALTIME):
                if byte == b"!":
                    self._notes.send(now_s)
                self._act(byte, connection)
            *lines, self._tail = (self._tail + data.translate(None, REALTIME)).split(b"\n")
            for line in lines:
                self._lines.put(line)

    def _act(self, byte: bytes, connection: socket.socket) -> None:
        self._state = {b"!": b"Hold:0", b"~": b"Run", b"\x18": b"Idle"}.get(byte, self._state)
        if byte == b"?":
            connection.sendall(b"<%s|MPos:0.000,0.000,0.000|FS:0,0>\r\n" % self._state)
        elif byte == b"\x18":
            connection.sendall(GREETING)

    def _obey(self, connection: socket.socket) -> None:
        """Answer the lines one after another, as if each took its time."""
        while True:
            line = self._lines.get()
            if not line.startswith(b"$"):
                self._state = b"Run" if self._state == b"Idle" else self._state
                time.sleep(LINE_S)
            with suppress(OSError):
                connection.sendall(ANSWERS.get(line, b"") + b"ok\r\n")


def serve(notes: Connection) -> None:
    """Be the controller's process."""
    Wire(notes).serve()


def look(client: DeskClient, reached: Callable[[], bool], busy: Callable[[], object]) -> None:
    """Look at the desk as a window does until something is reached."""
    while not reached():
        client.poll()
        busy()
        assert client.phase != "gone", client.error


def measure(busy: Callable[[], object]) -> list[float]:
    """Return the delays of many holds, s, sorted; `busy` is what the window does besides."""
    wire, notes = multiprocessing.Pipe()
    controller = multiprocessing.get_context("spawn").Process(target=serve, args=(notes,), daemon=True)
    controller.start()
    port = wire.recv()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "job.json"
        path.write_text(SendJob("", ["G1X0F1000"] * LINES).to_json(), "utf-8")
        client = DeskClient.launch(port, folder=Path(folder))
        look(client, lambda: client.phase == "connected", busy)
        client.run(path, zero_confirmed=True)
        delays = [hold(client, wire, busy) for _ in range(HOLDS)]
        client.stop()
        look(client, lambda: client.outcome is not None, busy)
        client.leave()
        controller.join()  # the desk has left it
    return sorted(delays)


def hold(client: DeskClient, wire: Connection, busy: Callable[[], object]) -> float:
    """Hold a running job once, and resume it; return the delay of the hold, s."""
    look(client, lambda: client.status.phase == "running", busy)
    called_s = time.monotonic()
    client.hold()
    delay_s = wire.recv() - called_s
    look(client, lambda: client.status.phase == "held", busy)
    client.resume()
    return delay_s


def spin() -> None:
    """Keep a core busy."""
    while True:
        pass


def main() -> None:
    """Print the delays beside each other."""
    flood = json.dumps({"numbers": list(range(20_000))})
    tell("window at rest", measure(lambda: time.sleep(0.002)))
    tell("window kept busy", measure(lambda: json.loads(flood)))
    other = multiprocessing.get_context("spawn").Process(target=spin, daemon=True)
    other.start()
    tell("window and another core kept busy", measure(lambda: json.loads(flood)))
    other.kill()


def tell(case: str, delays_s: list[float]) -> None:
    """Print the sorted delays of a case."""
    half_ms, most_ms, longest_ms = (1000 * delays_s[int(share * (len(delays_s) - 1))] for share in (0.5, 0.99, 1))
    print(f"hold, {case}: median {half_ms:.2f} ms, 99 % within {most_ms:.2f} ms, longest {longest_ms:.2f} ms")


if __name__ == "__main__":
    main()
