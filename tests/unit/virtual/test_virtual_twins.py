# SPDX-License-Identifier: LGPL-2.1-or-later
"""The virtual published machines as processes: ports, recordings, traces, faults, and a client that goes."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
import serial

from CNCStepper.errors import JobError
from CNCStepper.machine.profile import load_machine
from CNCStepper.virtual.faults.host_faults import plan_for_server
from CNCStepper.virtual.parport.machine import Parport
from CNCStepper.virtual.server.ports import TcpPort
from CNCStepper.virtual.server.step_trace import StepTrace
from CNCStepper.virtual.server.twin_faults import PARPORT_KINDS, TWIN_KINDS
from CNCStepper.virtual.server.twin_server import Notes, TwinServer
from helpers.cli.command_line import called, command, forked

LIMIT_S = 20.0
STEPS_PER_MM = 40
PROFILE = f"""
name = "wired"
controller = "thesis-a"
[planner]
junction_deviation_mm = 0.02
arc_tolerance_mm = 0.002
[axis.x]
steps_per_mm = {STEPS_PER_MM}
max_rate_mm_min = 1800
acceleration_mm_s2 = 100
travel_min_mm = 0
travel_max_mm = 1000
[axis.y]
steps_per_mm = {STEPS_PER_MM}
max_rate_mm_min = 1800
acceleration_mm_s2 = 100
travel_min_mm = 0
travel_max_mm = 600
[signals]
motors = ["x", "y"]
pins = {{ x_step = 2, x_direction = 3, y_step = 4, y_direction = 5, enable = 17 }}
"""
ON = 0b0011  # control register: pins 1 and 14 low, the enable on 17 high: all three are turned round


@contextmanager
def twin(*options: str, stdin: int | None = None) -> Iterator[tuple[str, subprocess.Popen[str]]]:
    """Yield the address of a virtual machine in a process of its own; it must end well."""
    pipe = subprocess.PIPE
    words = ("virtual", *options)
    pipes = {"stdout": pipe, "stderr": pipe, "stdin": stdin, "text": True}
    running = subprocess.Popen(command(*words), preexec_fn=forked(*words), **pipes)
    try:
        assert running.stdout
        line = running.stdout.readline()
        assert line.startswith(f"virtual {options[0]} at "), running.stderr and running.stderr.read()
        yield line.split()[-1], running
    finally:
        if "--until-left" not in options:
            running.terminate()
        try:
            _, errors = running.communicate(timeout=LIMIT_S)
        finally:
            running.kill()
    assert (running.returncode, errors) == (0, "")


def rows(trace: Path) -> np.ndarray:
    return np.loadtxt(trace, delimiter=",", skiprows=1, ndmin=2)


def files(folder: Path) -> tuple[str, ...]:
    return "--trace", str(folder / "trace.csv"), "--record", str(folder / "bytes")


def wired(folder: Path) -> tuple[str, str]:
    (folder / "wired.toml").write_text(PROFILE)
    return "--machine", str(folder / "wired.toml")


def connect(address: str) -> socket.socket:
    host, _, port = address.removeprefix("socket://").rpartition(":")
    return socket.create_connection((host, int(port)), LIMIT_S)


def test_lathe_over_tcp_runs_its_program_to_the_end_after_its_client_has_left(tmp_path):
    options = ("--tcp", "127.0.0.1:0", "--speed", "50", "--until-left", *files(tmp_path))
    program = b"YN30 G00 X-10. # N40 Z-50. # N50 X5000 Z50. #?"
    with twin("lathe", *options) as (address, _), connect(address) as client:
        client.sendall(program)
    assert (tmp_path / "bytes").read_bytes() == program
    assert (tmp_path / "trace.csv").read_text().startswith("t_s,x_mm,z_mm\n0.000000,0.000000,0.000000\n")
    path = rows(tmp_path / "trace.csv")
    assert path[-1, 1:].tolist() == path[-2, 1:].tolist() == [-9.5, 0.0]  # the last row is at rest
    assert (np.diff(path[:, 0]) >= 0).all() and path[:, 2].min() == -50.0


@pytest.mark.skipif(sys.platform == "win32", reason="pseudo-terminals are Unix's")
def test_lathe_on_a_pseudo_terminal(tmp_path):
    link = tmp_path / "lathe"
    with (
        twin("lathe", "--pty", str(link), "--speed", "50", "--until-left", *files(tmp_path)) as (address, _),
        serial.Serial(address, 9600) as client,
    ):
        client.write(b"YG00 X-1. #?")
        client.flush()
        time.sleep(0.5)
    assert rows(tmp_path / "trace.csv")[-1, 1:].tolist() == [-1.0, 0.0]
    assert not link.is_symlink()


def test_board_over_tcp_takes_the_published_bytes(tmp_path):
    data = bytes.fromhex("0A 10 09 10 05 10 06 10 05 10 09")
    options = ("--tcp", "127.0.0.1:0", "--until-left", "--machine", "table-a", *files(tmp_path))
    with twin("board", *options) as (address, _), connect(address) as client:
        for byte in data:
            client.sendall(bytes((byte,)))
            time.sleep(0.01)
    assert (tmp_path / "bytes").read_bytes() == data
    steps = rows(tmp_path / "trace.csv")[:, 1] * load_machine("table-a").axes[0].steps_per_mm
    assert np.round(steps).tolist() == [0, 1, 2, 3, 4, 3, 2, 2]


def test_a_killed_twin_leaves_what_it_had(tmp_path):
    options = ("--tcp", "127.0.0.1:0", "--machine", "table-a", *files(tmp_path))
    running = subprocess.Popen(command("virtual", "board", *options), stdout=subprocess.PIPE, text=True)
    assert running.stdout
    with connect(running.stdout.readline().split()[-1]) as client:
        client.sendall(bytes.fromhex("0A 10 09"))
        end = time.monotonic() + LIMIT_S
        while len((tmp_path / "trace.csv").read_text().splitlines()) < 4 and time.monotonic() < end:
            time.sleep(0.05)
        running.kill()
    running.communicate(timeout=LIMIT_S)
    assert (tmp_path / "bytes").read_bytes() == bytes.fromhex("0A 10 09")
    assert rows(tmp_path / "trace.csv")[-1, 1] > 0


@contextmanager
def parport(tmp_path: Path, *options: str) -> Iterator[tuple[socket.socket, subprocess.Popen[str]]]:
    base = ("--tcp", "127.0.0.1:0", "--until-left", *wired(tmp_path), *files(tmp_path), *options)
    with twin("parport", *base, stdin=subprocess.PIPE) as (address, running), connect(address) as client:
        yield client, running


def pulses(count: int) -> bytes:
    return b"".join(bytes((data, ON)) for _ in range(count) for data in (1, 0))


def test_parport_over_tcp_counts_every_pulse_and_sends_its_inputs(tmp_path):
    with parport(tmp_path, "--typed") as (client, running):
        assert client.recv(1) == b"\x80"  # the status register, as it is when a client comes
        client.sendall(bytes((0, ON)) + pulses(5000))
        assert running.stdin
        running.stdin.write("press 13\n")
        running.stdin.flush()
        assert client.recv(1) == b"\x90"
    path = rows(tmp_path / "trace.csv")
    assert path[-1, 1] * STEPS_PER_MM == pytest.approx(5000) and (np.diff(path[:, 1]) >= 0).all()
    assert (tmp_path / "bytes").stat().st_size == 2 + 4 * 5000


def test_a_closed_port_is_a_fault_and_another_client_may_come(tmp_path):
    plan = tmp_path / "plan.toml"
    plan.write_text('[[fault]]\nkind = "close"\nat_byte = 8\n[[fault]]\nkind = "dead_pin"\npin = 2\nat_byte = 40\n')
    options = ("--tcp", "127.0.0.1:0", "--faults", str(plan), *wired(tmp_path), *files(tmp_path))
    with twin("parport", *options) as (address, running):
        with connect(address) as client:
            client.sendall(bytes((0, ON)) + pulses(2))
            assert client.recv(1) == b"\x80" and client.recv(1) == b""  # hung up
        with connect(address) as client:
            assert client.recv(1) == b"\x80"
            for _ in range(3):
                client.sendall(pulses(8))
                time.sleep(0.2)
        assert running.stdout
        told = [running.stdout.readline() for _ in range(2)]
    assert ["close at byte 8" in told[0], "dead_pin 2 at byte 40" in told[1]] == [True, True]
    assert 2 <= rows(tmp_path / "trace.csv")[-1, 1] * STEPS_PER_MM < 26


@pytest.mark.parametrize(
    ("fault", "kinds", "what"),
    [
        ('kind = "alarm"', TWIN_KINDS, "no fault 'alarm'"),
        ('kind = "dead_pin"\npin = 2', TWIN_KINDS, "no fault 'dead_pin'"),
        ('kind = "stall"', PARPORT_KINDS, "a stall needs its motor"),
        ('kind = "dead_pin"', PARPORT_KINDS, "give the pin"),
        ('kind = "swapped_pins"\npin = 2', PARPORT_KINDS, "give other_pin"),
    ],
)
def test_faults_that_a_machine_cannot_have_are_refused(tmp_path, fault, kinds, what):
    plan = tmp_path / "plan.toml"
    plan.write_text(f"[[fault]]\nat_s = 1.0\n{fault}\n")
    with pytest.raises(JobError, match=what):
        plan_for_server(plan, kinds)


def test_grbl_has_no_motors_to_stall(tmp_path):
    plan = tmp_path / "plan.toml"
    plan.write_text('[[fault]]\nat_s = 1.0\nkind = "stall"\nmotor = "x"\n')
    with pytest.raises(JobError, match="no fault 'stall'"):
        plan_for_server(plan)


def test_each_option_of_a_port_is_needed_once(tmp_path):
    for options in ((), ("--pty", str(tmp_path / "p"), "--tcp", "127.0.0.1:0")):
        run = called("virtual", "lathe", *options)
        assert run.returncode == 2 and "either --pty PATH or --tcp" in run.stderr


def test_a_trace_tells_rests_and_ends_at_rest(tmp_path):
    trace = StepTrace(tmp_path / "t.csv", ("x", "z"))
    trace.note([np.array([[1.0, 0.5, 0.0], [1.01, 1.0, 0.0]]), np.array([[3.0, 1.5, 0.0]])])
    trace.rest(4.0, (1.5, 0.0))
    trace.rest(5.0, (1.5, 0.0))
    trace.close()
    want = [[0, 0], [0.95, 0], [1, 0.5], [1.01, 1], [2.95, 1], [3, 1.5], [4, 1.5]]
    assert rows(tmp_path / "t.csv")[:, :2] == pytest.approx(np.array(want))


def test_the_same_note_is_told_once_and_then_counted(monkeypatch):
    now, told = [0.0], list[str]()
    monkeypatch.setattr("time.monotonic", lambda: now[0])
    notes = Notes(lambda time_s, text: told.append(f"{time_s:g} {text}"))
    for n in range(5):
        notes.note(float(n), "motor x loses a pulse")
    notes.note(5.0, "flood on")
    notes.sum_up(5.0)
    assert told == ["0 motor x loses a pulse", "5 flood on"]
    now[0] = 1.5
    notes.sum_up(6.0)
    notes.note(7.0, "flood on")
    notes.sum_up(8.0, ends=True)
    assert told[2:] == ["6 motor x loses a pulse (4 times more)", "7 flood on"]


def test_server_reads_with_the_spans_of_its_looks(tmp_path):
    """The span of a batch begins before the look that found nothing, and ends behind the one that read it."""
    spans: list[tuple[float, float]] = []

    class Noting(Parport):
        def receive(self, data: bytes, since_s: float, now_s: float) -> None:
            spans.append((since_s, now_s))
            super().receive(data, since_s, now_s)
            if len(spans) == 3:
                server.stop()

    port = TcpPort("127.0.0.1", 0)
    server = TwinServer(Noting(load_machine("thesis-table")), port)
    with connect(port.address) as client:
        client.sendall(b"\0\0")
        sent = iter((b"\1\0", b"\0\0"))
        server._each_step = lambda: client.sendall(next(sent, b"")) if spans else None
        server.run()
    port.close()
    assert len(spans) == 3
    assert all(since <= now for since, now in spans)
    assert all(later[0] <= later[1] and earlier[1] <= later[1] for earlier, later in pairwise(spans))
    assert spans[-1][1] - spans[-1][0] < 1.0
