# SPDX-License-Identifier: LGPL-2.1-or-later
"""Verbs one after the other at a board that restarts whenever its port is opened: one connection serves them all."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.processes.process_file import is_alive
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.service.connection_session import ConnectionSession
from CNCStepper.control.session.files import running_services, sessions
from CNCStepper.control.session.local_socket import Address
from helpers.cli.command_line import called, command, forked

KEPT = "stays open for 5 min; `cncstepper disconnect` closes it"
LIMIT_S = 40.0
SHORT = "G21G90G94\nG1X-2F3000\nG1X0Y1\n"
LONG = "G21G90G94\n" + "".join(f"G1X{-(number % 2) * 20}F1500\n" for number in range(400))

pytestmark = pytest.mark.slow


@pytest.fixture
def port(tmp_path: Path) -> Iterator[str]:
    """Yield the port of a virtual grbl that restarts at each opening."""
    way = ["--tcp", "127.0.0.1:0"] if os.name == "nt" else ["--pty", tmp_path / "board"]
    words = ("virtual", "grbl", *way, "--restarts", "--speed", "5")
    with subprocess.Popen(command(*words), stdout=subprocess.PIPE, text=True, preexec_fn=forked(*words)) as process:
        assert process.stdout
        try:
            yield process.stdout.readline().split()[-1]
        finally:
            process.kill()


@pytest.fixture(autouse=True)
def _kept(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Connections stay open for 5 min; none outlives its test."""
    monkeypatch.setenv("CNCSTEPPER_KEEP_OPEN", "5")
    yield
    for file in running_services():
        os.kill(process_of(file), signal.SIGTERM)
        until(lambda file=file: not is_alive(file))


def process_of(file: Path) -> int:
    return int(json.loads(file.read_text("utf-8"))["process"])


def until(reached: Callable[[], bool]) -> None:
    end_s = time.monotonic() + LIMIT_S
    while not reached():
        assert time.monotonic() < end_s
        time.sleep(0.02)


def done(*words: str | Path) -> subprocess.CompletedProcess[str]:
    result = called(*words)
    assert result.returncode == 0, (words, result.stdout, result.stderr)
    return result


def program(folder: Path, text: str = SHORT) -> Path:
    path = folder / "part.nc"
    path.write_text(text, "utf-8")
    return path


def send(file: Path, port: str) -> tuple[str | Path, ...]:
    return ("send", file, "--port", port, "--unchecked", "--zero-confirmed")


def test_position_is_kept_from_verb_to_verb(port, tmp_path):
    jogged = done("jog", "X-5", "--port", port)
    assert KEPT in jogged.stderr and port in jogged.stderr
    done("zero", "--port", port)
    done("jog", "X-3", "--port", port)
    assert "X-3.000" in done("jog", "Y-1", "--port", port).stdout
    sent = done(*send(program(tmp_path), port))
    assert "all 3 lines are cut" in sent.stdout and KEPT in sent.stderr
    assert "X0.000 Y1.000" in done("jog", "Z1", "--port", port).stdout
    assert "4 of 4" in done(*send(program(tmp_path, SHORT + "G1X-1\n"), port)).stdout
    assert len(running_services()) == 1 and sessions() == []


def test_without_a_quiet_time_each_verb_opens_the_port_and_the_position_is_lost(port, monkeypatch):
    monkeypatch.setenv("CNCSTEPPER_KEEP_OPEN", "0")
    done("jog", "X-5", "--port", port)
    done("zero", "--port", port)
    assert running_services() == []
    jogged = done("jog", "X-3", "--port", port)
    assert "position unknown" in jogged.stdout and "stays open" not in jogged.stderr


def test_sent_first_the_job_counts_from_the_confirmed_place(port, tmp_path):
    sent = done(*send(program(tmp_path), port))
    assert "all 3 lines are cut" in sent.stdout
    jogged = done("jog", "X-1", "--port", port)
    assert "X-1.000 Y1.000" in jogged.stdout and "unknown" not in jogged.stdout


def test_quiet_time_ends_it(port):
    done("jog", "X-1", "--port", port, "--keep-open", "0.05")
    (file,) = running_services()
    begin_s = time.monotonic()
    done("jog", "X-1", "--port", port, "--keep-open", "0.05")
    assert running_services() == [file]
    until(lambda: not is_alive(file))
    assert time.monotonic() - begin_s > 2.5


def test_disconnect_ends_it_and_says_where_there_is_nothing(port):
    done("zero", "--port", port)
    assert f"{port} is disconnected" in done("disconnect", "--port", port).stdout
    assert running_services() == []
    assert "no connection to" in done("disconnect", "--port", port).stderr
    done("zero", "--port", port)
    assert f"{port} is disconnected" in done("disconnect").stdout
    assert "no connection is open" in done("disconnect").stderr


def test_disconnect_is_refused_while_a_job_runs_and_other_verbs_hold_and_stop_it(port, tmp_path):
    words = (*send(program(tmp_path, LONG), port), "--machine", "table-a")
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
    with subprocess.Popen(command(*words), preexec_fn=forked(*words), **pipes) as sender:
        until(lambda: running_services() != [])
        (file,) = running_services()
        with ConnectionSession.attach(file) as session:
            until(lambda: session.status().phase == "running")
        refused = called("disconnect", "--port", port)
        assert refused.returncode == 1 and "held by a job of yours" in refused.stderr
        second = called(*send(program(tmp_path), port))
        assert second.returncode == 1 and "held by a job of yours" in second.stderr
        assert "held" in done("hold").stdout
        jogged = done("jog", "Z2", "--port", port)
        assert "Z2.000" in jogged.stdout
        done("back", "--resume")
        done("override", "feed", "+10")
        done("stop")
        out, _ = sender.communicate(timeout=LIMIT_S)
    assert sender.returncode == 1 and "stopped" in out
    assert "unknown" not in done("jog", "Z1", "--port", port).stdout


def test_two_terminals_and_a_window_share_one_connection(port):
    done("zero", "--port", port)
    window = ConnectionClient.launch(port)
    until(lambda: window.poll() is not None and window.phase == "connected")
    assert not window.started_service
    console = command("console", "--port", port)
    with subprocess.Popen(console, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as other:
        assert other.stdin and other.stdout
        other.stdin.write("jog X-4\n?\n")
        other.stdin.flush()
        lines = [other.stdout.readline() for _ in range(3)]
        assert "X-4.000" in lines[-1], lines
        assert "X-4.000 Y2.000" in done("jog", "Y2", "--port", port).stdout
        until(lambda: window.poll() is not None and (window.status.wpos_mm or ())[:2] == (-4.0, 2.0))
        assert len(running_services()) == 1
        other.stdin.close()
    window.detach()
    assert "X-4.000 Y2.000 Z1.000" in done("jog", "Z1", "--port", port).stdout


def test_window_that_disconnects_ends_what_verbs_have_left_open(port):
    done("zero", "--port", port)
    (file,) = running_services()
    window = ConnectionClient.launch(port)
    until(lambda: window.poll() is not None and window.phase == "connected")
    window.leave()
    until(lambda: not is_alive(file))


def test_after_a_killed_service_the_position_is_unknown(port):
    done("zero", "--port", port)
    assert "unknown" not in done("jog", "X-3", "--port", port).stdout
    (file,) = running_services()
    os.kill(process_of(file), signal.SIGTERM if os.name == "nt" else signal.SIGKILL)
    until(lambda: not is_alive(file))
    assert "position unknown" in done("jog", "X1", "--port", port).stdout


def test_flood_of_idle_clients_neither_keeps_it_open_nor_delays_a_verb(port):
    done("jog", "X-1", "--port", port, "--keep-open", "0.1")
    (file,) = running_services()
    address = Address.of(json.loads(file.read_text("utf-8")))
    idle = [address.connect(1.0) for _ in range(150)]
    try:
        begin_s = time.monotonic()
        assert "X-2.000" in done("jog", "X-1", "--port", port, "--keep-open", "0.1").stdout
        assert time.monotonic() - begin_s < LIMIT_S / 4
        until(lambda: not is_alive(file))
    finally:
        for connection in idle:
            connection.close()


def test_another_machine_than_the_one_connected_is_refused(port):
    done("zero", "--port", port)
    done("jog", "X-1", "--port", port, "--machine", "table-a")  # with a firmware of its own
    refused = called("jog", "X-1", "--port", port, "--machine", "thesis-table")
    assert refused.returncode == 1 and "not as thesis-table" in refused.stderr and "disconnect --port" in refused.stderr


def test_a_machine_that_this_computer_controls_keeps_its_connection_too(tmp_path):
    port = f"record:{tmp_path / 'writes.csv'}"
    started = done("jog", "X1", "--port", port, "--machine", "thesis-table")
    assert "X1.000" in started.stdout and KEPT in started.stderr
    assert "X2.000 Y1.000" in done("jog", "X1", "Y1", "--port", port).stdout
    refused = called("jog", "X1", "--port", port, "--machine", "table-a")
    assert refused.returncode == 1 and "connected as thesis-table, not as table-a" in refused.stderr
    done("disconnect")
    assert (tmp_path / "writes.csv").read_text("utf-8").startswith("t_s,")


def test_home_first_is_done_by_the_service(tmp_path):
    words = ("virtual", "grbl", "--tcp", "127.0.0.1:0", "--restarts", "--homing", "--speed", "50")
    with subprocess.Popen(command(*words), stdout=subprocess.PIPE, text=True, preexec_fn=forked(*words)) as process:
        assert process.stdout
        try:
            port = process.stdout.readline().split()[-1]
            file = program(tmp_path, "G21G90G94\nG53G0X-5Y-5Z-5\n")
            sent = done(*send(file, port), "--home")
            assert "all 2 lines are cut" in sent.stdout and "finds its own zero" in sent.stderr
            assert "machine X-5.000 Y-6.000 Z-5.000" in done("jog", "Y-1", "--port", port).stdout
        finally:
            process.kill()
