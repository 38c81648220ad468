# SPDX-License-Identifier: LGPL-2.1-or-later
"""Resident memory of `cncstepper send`, the sender's process and a service's, with a short program and a long one.

Linux only. Whose programs are to be sent may be said, and how long they are: service sender command 100000 2000000.

The controller answers at once and stands where its last line ends, so that positions are compared with the path.
"""

from __future__ import annotations

import multiprocessing
import os
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import asdict
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

from CNCStepper.control.program.certificate import FORMAT, VERSION, Certificate, digest_of_lines, sendable
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import read_private, sessions
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.state import Start

COUNTS = (100_000, 10_000_000)
STREAMED = 90_000  # lines after which the memory is read
BAUD = 4_000_000  # by which the sender paces itself
LIMIT_S = 600.0
ANSWERS = {
    b"$I": "[VER:1.1h.20190830:]\r\n[OPT:V,35,1024]\r\n",
    b"$$": "$13=0\r\n$100=80.000\r\n$101=80.000\r\n$102=80.000\r\n",
    b"$#": "".join(f"[{name}:0.000,0.000,0.000]\r\n" for name in ("G54", "G92")),
    b"$G": "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]\r\n",
}
PLACE = re.compile(rb"X([\d.]+)Y([\d.]+)")


class Program(Sequence[str]):
    """A program of short moves, to and fro, that takes no memory."""

    def __init__(self, count: int):
        self._count = count

    def __len__(self) -> int:
        return self._count

    def __getitem__(self, index: Any) -> Any:
        if index >= self._count:
            raise IndexError(index)
        return f"G1X{index % 1000 / 10:g}Y{index // 1000 % 1000 / 10:g}" if index else "G21G90G1F6000"


def control(told: Connection) -> None:
    """Be the controller, anew for each client."""
    server = socket.create_server(("127.0.0.1", 0))
    told.send(server.getsockname()[1])
    while True:
        threading.Thread(target=serve, args=(server.accept()[0],), daemon=True).start()


def serve(client: socket.socket) -> None:
    """Answer a client until it leaves."""
    client.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    tail, place, held = b"", (0.0, 0.0), False
    while data := client.recv(4096):
        asked = data.count(b"?")
        *texts, tail = (tail + re.sub(rb"[?!~\x18\x80-\xff]", b"", data)).split(b"\n")
        held = held or b"!" in data
        answer = "Grbl 1.1h ['$' for help]\r\n" if b"\x18" in data else ""
        for text in texts:
            if found := PLACE.search(text):
                place = float(found[1]), float(found[2])
            answer += ANSWERS.get(text, "") + "ok\r\n"
        held = held and b"\x18" not in data
        state = "Hold:0" if held else "Run" if texts else "Idle"
        answer += asked * f"<{state}|MPos:{place[0]:.3f},{place[1]:.3f},0.000|Bf:35,1024|FS:0,0>\r\n"
        client.sendall(answer.encode("ascii"))


def resident(session_file: Path) -> str:
    """Return the memory that the process of a session has, and the most that it has had."""
    content = read_private(session_file)
    assert content
    return resident_of(content["process"])


def resident_of(process: int) -> str:
    """Return the memory that a process has, and the most that it has had."""
    status = Path(f"/proc/{process}/status").read_text("ascii")
    now, most = (int(re.search(rf"{name}:\s+(\d+) kB", status)[1]) / 1000 for name in ("VmRSS", "VmHWM"))
    return f"{now:.1f} MB, at most {most:.1f} MB"


def await_lines(status: Callable[[], SenderStatus]) -> SenderStatus:
    """Wait until enough lines are acknowledged."""
    end_s = time.monotonic() + LIMIT_S
    while (seen := status()).acknowledged < STREAMED:
        assert time.monotonic() < end_s, seen
        time.sleep(0.02)
    return seen


def show_sender(port: str, count: int, folder: Path) -> None:
    """Print the memory of the process that `cncstepper send` starts."""
    job = SendJob(port, Program(count), baud=BAUD, zero_confirmed=True)
    with SessionClient.start(job, folder=folder) as client:
        seen = await_lines(client.status)
        print(f"sender, {count} lines, after {seen.acknowledged}: {resident(client.session_file)}", flush=True)
        client.stop()
        client.wait(limit_s=LIMIT_S)


def write_certificate(file: Path, count: int) -> None:
    """Write the certificate of a program, with all that a sender needs of it."""
    program, start = Program(count), Start.at_zero()
    sha256 = digest_of_lines(program)
    content: dict[str, Any] = {"format": FORMAT, "version": VERSION, "findings": []}
    content |= {"program": {"sha256": sha256}, "wire": {"sha256": sha256, "dialect": "grbl"}}
    content["start"] = {"sha256": start.sha256(), "state": asdict(start)}
    content["send"] = {"file": "long.nc"}
    Certificate(content, program, range(1, count + 1)).write(file)


def show_service(port: str, count: int, folder: Path) -> None:
    """Print the memory of a service with the certificate of a program, and how long reading it takes."""
    file = folder / "job.zip"
    write_certificate(file, count)
    client = ConnectionClient.launch(port, BAUD, folder)

    def status() -> SenderStatus:
        for event in client.poll():
            assert event["event"] not in ("refused", "outcome"), (event, client.outcome)
        return client.status

    while status().phase != "idle":
        time.sleep(0.02)
    client.run(file, zero_confirmed=True)
    seen = await_lines(status)
    print(f"service, {count} lines, after {seen.acknowledged}: {resident(client.session_file)}", flush=True)
    client.stop()
    client.leave()
    begin_s = time.monotonic()
    sendable(file, port=port)
    print(f"its file, {count} lines: read in {time.monotonic() - begin_s:.2f} s", flush=True)


def show_command(port: str, count: int, folder: Path) -> None:
    """Print the memory of `cncstepper send --certificate`, until the program is on its way and at its end."""
    file, program = folder / "certificate.zip", folder / "long.nc"
    write_certificate(file, count)
    with program.open("w", encoding="ascii") as out:
        out.writelines(f"{line}\n" for line in Program(count))
    words = (
        "send",
        program,
        "--port",
        port,
        "--baud",
        BAUD,
        "--certificate",
        file,
        "--zero-confirmed",
        "--keep-open",
        "0",
    )
    here = os.environ | {"XDG_STATE_HOME": str(folder)}
    begin_s = time.monotonic()
    with subprocess.Popen([sys.executable, "-m", "CNCStepper.cli", *map(str, words)], env=here) as command:
        while not (running := sessions(folder / "cncstepper" / "sessions")):
            assert command.poll() is None
            time.sleep(0.02)
        until_s = time.monotonic() - begin_s
        with SessionClient.attach(running[0]) as client:
            seen = await_lines(client.status)
            print(f"command, {count} lines, until the first {until_s:.0f} s, after {seen.acknowledged}: ", end="")
            print(resident_of(command.pid), f"its sender: {resident(running[0])}", sep="; ", flush=True)
            client.stop()


SHOWN = {"service": show_service, "sender": show_sender, "command": show_command}


def main(shown: list[str], counts: list[int]) -> None:
    """Print the memory of each with each program."""
    here, there = multiprocessing.Pipe()
    process = multiprocessing.get_context("spawn").Process(target=control, args=(there,), daemon=True)
    process.start()
    port = f"socket://127.0.0.1:{here.recv()}"
    for name in shown:
        for count in counts:
            with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
                SHOWN[name](port, count, Path(folder))


if __name__ == "__main__":
    named = [word for word in sys.argv[1:] if word in SHOWN]
    main(named or list(SHOWN), [int(word) for word in sys.argv[1:] if word not in SHOWN] or list(COUNTS))
