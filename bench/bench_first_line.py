# SPDX-License-Identifier: LGPL-2.1-or-later
"""From the start of `cncstepper send --certificate` to the program's first line on the wire of the virtual grbl.

How long the program is may be said: 100000 1000000. Each length is sent several times, and the least counts.
"""

from __future__ import annotations

import os
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

LENGTHS = (100, 100_000, 1_000_000)
RUNS = 3
LIMIT_S = 60.0
FIRST = b"G21G90G17"  # nothing else that is sent holds it
COMMAND = [sys.executable, "-m", "CNCStepper.cli"]
MACHINE = ["--machine", "table-a"]


class Relay:
    """A line to the virtual controller that notes when the program's first line passes, and is closed then."""

    def __init__(self, port: int):
        self._port = port
        self._server = socket.create_server(("127.0.0.1", 0))
        self.passed = threading.Event()
        self.passed_s = 0.0
        threading.Thread(target=self._serve, daemon=True).start()

    @property
    def url(self) -> str:
        """Where a sender finds it."""
        return f"socket://127.0.0.1:{self._server.getsockname()[1]}"

    def _serve(self) -> None:
        client, _ = self._server.accept()
        with client, socket.create_connection(("127.0.0.1", self._port)) as controller:
            for one in (client, controller):
                one.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            threading.Thread(target=_answers, args=(controller, client), daemon=True).start()
            said = b""
            while data := client.recv(4096):
                said = said[-len(FIRST) :] + data
                if FIRST in said:
                    self.passed_s = time.monotonic()
                    self.passed.set()
                    return
                controller.sendall(data)


def _answers(controller: socket.socket, client: socket.socket) -> None:
    """Relay what the controller says until either has left."""
    try:
        while data := controller.recv(4096):
            client.sendall(data)
    except OSError:
        return


def write_program(path: Path, lines: int) -> None:
    """Write a program of short moves in all directions."""
    with path.open("w", encoding="ascii") as file:
        file.write("G21 G90 G17\nG0 Z5\nG0 X0 Y0\nM3 S10000\nG4 P3\nG1 Z-1 F600\n")
        file.writelines(f"G1 X{index % 97 * 0.5:.3f} Y{index % 89 * 0.5:.3f}\n" for index in range(lines))
        file.write("G0 Z5\nM5\nM2\n")


def first_line_s(program: Path, certificate: Path, folder: Path) -> float:
    """Return the time until the first line of a program is sent, s."""
    listen = ["virtual", "grbl", "--tcp", "127.0.0.1:0", *MACHINE]
    with subprocess.Popen([*COMMAND, *listen], stdout=subprocess.PIPE, text=True) as virtual:
        try:
            assert virtual.stdout
            found = re.search(r"127\.0\.0\.1:(\d+)", virtual.stdout.readline())
            assert found
            relay = Relay(int(found[1]))
            begin_s = time.monotonic()
            send(["--port", relay.url, str(program), "--certificate", str(certificate)], folder, relay.passed)
        finally:
            virtual.kill()
    return relay.passed_s - begin_s


def send(words: list[str], folder: Path, passed: threading.Event) -> None:
    """Start the command, and end it once the line has passed; raises where it does not."""
    command = [*COMMAND, "send", *words, "--zero-confirmed", "--keep-open", "0", *MACHINE]
    here = os.environ | {"XDG_STATE_HOME": str(folder)}
    with (folder / "said.txt").open("w+") as said:
        sender = subprocess.Popen(command, env=here, stdin=subprocess.DEVNULL, stdout=said, stderr=said)
        try:
            end_s = time.monotonic() + LIMIT_S
            while not passed.wait(0.05):
                if sender.poll() is not None or time.monotonic() > end_s:
                    raise RuntimeError((folder / "said.txt").read_text())
        finally:
            sender.terminate()
            sender.wait()


def main(lengths: list[int]) -> None:
    """Print the time of each length."""
    least_s = 0.0
    for lines in lengths:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
            folder = Path(name)
            program, certificate = folder / "long.nc", folder / "certificate.zip"
            write_program(program, lines)
            subprocess.run(
                [*COMMAND, "check", str(program), "--certificate", str(certificate), *MACHINE],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            spent_s = [first_line_s(program, certificate, folder) for _ in range(RUNS)]
        least_s = least_s or min(spent_s)
        figures = ", ".join(f"{one_s:.2f}" for one_s in spent_s)
        print(f"first line: {lines} lines: {figures} s, least {min(spent_s):.2f} s, ", end="")
        print(f"{min(spent_s) / least_s:.2f} times that of {lengths[0]}", flush=True)


if __name__ == "__main__":
    main([int(word) for word in sys.argv[1:]] or list(LENGTHS))
