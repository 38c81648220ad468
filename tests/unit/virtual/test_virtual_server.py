# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual grbl behind a TCP port and a pseudo-terminal, in a process of its own."""

from __future__ import annotations

import contextlib
import json
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import serial

from CNCStepper.errors import LinkError
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.virtual.grbl.machine import Grbl
from CNCStepper.virtual.server import grbl_server as server_module
from CNCStepper.virtual.server.grbl_server import Server, serve
from CNCStepper.virtual.server.path_trace import Trace
from CNCStepper.virtual.server.ports import Port, PtyPort, TcpPort
from CNCStepper.virtual.server.serial_line import Link

LIMIT_S = 10.0
DATA = Path(__file__).parents[2] / "data" / "firmware"
PROGRAM = """
import sys
def ready(address):
    print(address, flush=True)
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.server.grbl_server import serve
serve(load_machine(sys.argv[1]), ready=ready, **eval(sys.argv[2]))
"""


@contextlib.contextmanager
def process(machine: str = "table-a", **options: object) -> Iterator[tuple[str, subprocess.Popen]]:
    """Yield the address of a virtual grbl and its process; it must have ended well afterwards."""
    command = [sys.executable, "-c", PROGRAM, machine, repr(options)]
    running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert running.stdout
        address = running.stdout.readline().strip()
        assert address, running.stderr and running.stderr.read()
        yield address, running
    finally:
        running.send_signal(signal.SIGTERM)
        _, errors = running.communicate(timeout=LIMIT_S)
        assert (running.returncode, errors) == (0, "")


def board_link(baud: int = 115200) -> Link:
    return Link(Grbl(load_machine("table-a")), baud)


@contextlib.contextmanager
def serving(port: Port, speed: float = 1.0, baud: int = 115200) -> Iterator[str]:
    """Yield the address of a virtual grbl that runs in a thread."""
    server = Server(board_link(baud), port, speed)
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        yield port.address
    finally:
        server.stop()
        thread.join(LIMIT_S)
        port.close()
        assert not thread.is_alive()


@pytest.fixture(params=["tcp", "pty"])
def port(request: pytest.FixtureRequest, tmp_path: Path) -> Port:
    return PtyPort(str(tmp_path / "port")) if request.param == "pty" else TcpPort("127.0.0.1", 0)


def read_until(link: serial.SerialBase, last: str) -> str:
    """Read until a line begins with `last`; return all that came."""
    said, end_s = "", time.monotonic() + LIMIT_S
    while not any(line.startswith(last) for line in said.splitlines()) or not said.endswith("\n"):
        assert time.monotonic() < end_s, said
        said += link.read(link.in_waiting or 1).decode("ascii")
    return said


def opened(address: str) -> serial.SerialBase:
    return serial.serial_for_url(address, baudrate=115200, timeout=0.05)


def test_a_conversation(port: Port) -> None:
    with serving(port, speed=20) as address, opened(address) as link:
        read_until(link, "Grbl 1.1h")
        link.write(b"G10 L20 P1 X5\n")
        assert read_until(link, "ok") == "ok\r\n"
        link.write(b"?$I\n")
        assert re.fullmatch(r"<Idle\|MPos:.*>\r\n\[VER.*\r\n\[OPT:V,15,128]\r\nok\r\n", read_until(link, "ok"))


@pytest.mark.slow
def test_a_process_leaves_no_link_behind(tmp_path: Path) -> None:
    path = tmp_path / "port nº 1"
    with process(pty=str(path)) as (address, running):
        assert address == str(path)
        assert os.readlink(path).startswith("/dev/pts/")
        running.send_signal(signal.SIGINT)
        assert running.wait(LIMIT_S) == 0
        assert not path.is_symlink()


def test_a_stale_link_is_replaced_and_a_file_is_not(tmp_path: Path) -> None:
    (tmp_path / "stale").symlink_to("/dev/pts/987654")
    stale = PtyPort(str(tmp_path / "stale"))
    assert os.readlink(tmp_path / "stale") != "/dev/pts/987654"
    stale.close()
    assert not (tmp_path / "stale").is_symlink()
    (tmp_path / "file").write_text("mine")
    with pytest.raises(LinkError, match="no link can be made"):
        PtyPort(str(tmp_path / "file"))
    assert (tmp_path / "file").read_text() == "mine"


def test_the_machine_goes_on_while_its_client_is_away(port: Port) -> None:
    with serving(port, speed=10) as address:
        with opened(address) as link:
            read_until(link, "Grbl")
            link.write(b"G1 X10 F600\n")
            read_until(link, "ok")
        time.sleep(1.0)  # 10 s of the machine's time, where 1 s would do: this machine may be busy
        with opened(address) as link:
            link.write(b"?")
            said = read_until(link, "<")
            assert said.startswith("<Idle|MPos:10.000,")  # no greeting: opening does not reset


def test_a_second_client_is_turned_away() -> None:
    with serving(TcpPort("127.0.0.1", 0)) as address, opened(address) as link:
        place = address.removeprefix("socket://").split(":")
        read_until(link, "Grbl")
        with socket.create_connection((place[0], int(place[1])), timeout=LIMIT_S) as second:
            assert second.recv(100) == b""
        link.write(b"?")
        read_until(link, "<Idle")


@pytest.mark.slow
def test_bytes_take_their_time_on_the_line() -> None:
    with serving(TcpPort("127.0.0.1", 0), baud=1200) as address, opened(address) as link:
        read_until(link, "Grbl")
        begin_s = time.monotonic()
        link.write(b"(" + b"c" * 30 + b")\n")  # 33 bytes and 4 back at 120 a second
        read_until(link, "ok")
        assert 0.28 < time.monotonic() - begin_s < 1.5


def test_speed_scales_time() -> None:
    with serving(TcpPort("127.0.0.1", 0), speed=20) as address, opened(address) as link:
        read_until(link, "Grbl")
        begin_s = time.monotonic()
        link.write(b"G4 P10\n")
        read_until(link, "ok")
        assert 0.45 < time.monotonic() - begin_s < 2.0


@pytest.mark.slow
def test_trace_is_complete_after_the_end(tmp_path: Path) -> None:
    path = tmp_path / "trace.csv"
    with process(tcp="127.0.0.1:0", speed=20, trace=str(path)) as (address, _), opened(address) as link:
        read_until(link, "Grbl")
        link.write(b"G1 X3 Y4 F600\nG4 P0\n")
        said = read_until(link, "ok")
        while said.count("ok") < 2:
            said += read_until(link, "ok")
    lines = path.read_text("ascii").splitlines()
    assert lines[0] == "t_s,x_mm,y_mm,z_mm"
    rows = [tuple(map(float, line.split(","))) for line in lines[1:]]
    assert rows[0][1:] == (0.0, 0.0, 0.0)
    assert rows[-1][1:] == (3.0, 4.0, 0.0)
    assert all(abs(4 * x - 3 * y) / 5 < 0.0125 for _, x, y, _ in rows)
    assert all(before[0] <= after[0] for before, after in pairwise(rows))


@pytest.mark.parametrize(
    ("options", "what"),
    [
        ({}, "needs one port"),
        ({"pty": "a", "tcp": "b"}, "needs one port"),
        ({"tcp": "nowhere"}, "not an address"),
        ({"tcp": "127.0.0.1:99999"}, "not an address"),
        ({"tcp": "127.0.0.1:0", "speed": 0}, "speed"),
        ({"tcp": "127.0.0.1:0", "speed": float("nan")}, "speed"),
        ({"tcp": "127.0.0.1:0", "baud": 1}, "baud"),
        ({"tcp": "127.0.0.1:0", "trace": "/no/such/folder/x.csv"}, "cannot be written"),
        ({"pty": "/no/such/folder/port"}, "no link can be made"),
    ],
)
def test_bad_options_are_refused(machine: Machine, options: dict, what: str) -> None:
    with pytest.raises(LinkError, match=what):
        serve(machine, **options)


def test_a_port_in_use_is_refused(machine: Machine) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken, pytest.raises(LinkError, match="cannot listen"):
        serve(machine, tcp=f"127.0.0.1:{taken.getsockname()[1]}")


def test_the_path_of_another_virtual_machine_is_refused_until_that_has_ended(tmp_path: Path) -> None:
    path = tmp_path / "peça um"
    first = PtyPort(str(path))
    try:
        with pytest.raises(LinkError, match="in use") as refusal:
            PtyPort(str(path))
        assert refusal.value.code == "pty-busy" and path.is_symlink() and path.exists()
    finally:
        first.close()
    path.symlink_to("/dev/pts/99999")  # as a killed one leaves it
    PtyPort(str(path)).close()
    assert not path.is_symlink()


def test_without_terminals_the_pty_is_refused(machine: Machine, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pty", None)
    with pytest.raises(LinkError, match="--tcp"):
        serve(machine, pty="x")


@pytest.mark.slow
def test_imports_without_terminals() -> None:
    code = (
        "import sys; sys.modules.update(pty=None, tty=None, termios=None, fcntl=None); "
        "import CNCStepper.virtual.server.grbl_server"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


class Streaming:
    """A port whose client streams lines by character counting, and leaves; also the clock, which waits alone move."""

    address = "streaming"
    window_bytes = 127

    def __init__(self, lines: list[bytes]):
        self.now_s = 0.0
        self._waiting, self._unanswered = deque(lines), deque[int]()
        self._out = self._answers = b""

    @property
    def connected(self) -> bool:
        return bool(self._waiting or self._unanswered)

    def wait(self, timeout_s: float) -> bool:
        while self._waiting and sum(self._unanswered) + len(self._waiting[0]) <= self.window_bytes:
            self._unanswered.append(len(self._waiting[0]))
            self._out += self._waiting.popleft()
        if not self._out:
            self.sleep(timeout_s)
        return bool(self._out)

    def read(self, count: int) -> bytes:
        data, self._out = self._out[:count], self._out[count:]
        return data

    def write(self, data: bytes) -> None:
        *answers, self._answers = (self._answers + data).split(b"\r\n")
        for answer in answers:
            assert answer in (b"", b"ok") or answer.startswith(b"Grbl")
            if answer == b"ok":
                self._unanswered.popleft()

    def monotonic(self) -> float:
        return self.now_s

    def sleep(self, wait_s: float) -> None:
        self.now_s += max(wait_s, 1e-6)


@pytest.mark.slow
def test_a_minute_of_cutting_takes_three_seconds_at_speed_20(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    recording = json.loads((DATA / "brazil_b.json").read_text("utf-8"))
    client = Streaming([line.encode("ascii") + b"\n" for line in [*recording["program"], "G4 P0"]])
    monkeypatch.setattr(server_module, "time", client)
    board = Grbl(load_machine("table-b"))
    with contextlib.closing(Trace(tmp_path / "trace.csv", board)) as trace:
        begin_s = time.process_time()
        Server(Link(board), client, speed=20, trace=trace, until_left=True).run()
        assert time.process_time() - begin_s < 2 * recording["duration_s"] / 20
    assert client.now_s == pytest.approx(recording["duration_s"] / 20, rel=0.1)
    rows = np.loadtxt(tmp_path / "trace.csv", delimiter=",", skiprows=2)
    assert rows[-1, 0] - rows[0, 0] == pytest.approx(recording["duration_s"], rel=0.01)
    assert list(rows[-1, 1:]) == recording["end_mpos_mm"]
    assert np.max(np.abs(np.diff(rows[:, 1:], axis=0))) < 1 / 160 + 1e-5  # no step is left out


@pytest.mark.parametrize("address", ["0.0.0.0:0", "192.168.1.1:2300", "127.0.0.1:x"])
def test_only_this_machine_may_connect(address: str, machine: Machine) -> None:
    with pytest.raises(LinkError) as caught:
        serve(machine, tcp=address)
    assert caught.value.code == "tcp-address"


def test_server_that_serves_until_it_is_left_ends_when_its_client_goes(port):
    server = Server(board_link(), port, until_left=True)
    thread = threading.Thread(target=server.run)
    thread.start()
    try:
        with opened(port.address) as link:
            read_until(link, "Grbl")
            assert thread.is_alive()
        thread.join(LIMIT_S)
        assert not thread.is_alive()
    finally:
        server.stop()
        thread.join(LIMIT_S)
        port.close()


def test_server_that_serves_until_it_is_left_ends_when_nobody_comes(port, monkeypatch):
    monkeypatch.setattr(server_module, "NOBODY_CAME_S", 0.2)
    begin_s = time.monotonic()
    Server(board_link(), port, until_left=True).run()
    port.close()
    assert 0.2 <= time.monotonic() - begin_s < LIMIT_S
