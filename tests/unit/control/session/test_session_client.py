# SPDX-License-Identifier: LGPL-2.1-or-later
"""The sender in a process of its own, with clients that come and go, against a scripted controller on TCP."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import sys
import time
from pathlib import Path

import pytest

from CNCStepper.control.processes import python_finder
from CNCStepper.control.processes.bootstrap import BEHIND, python_version, see_packages
from CNCStepper.control.processes.python_finder import candidates, checked, find_python, find_python_in_background
from CNCStepper.control.program.send_job import SendJob, write_job
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.service.port_owner import check_free
from CNCStepper.control.session.client import WORKER, SessionClient
from CNCStepper.control.session.detached_process import start
from CNCStepper.control.session.files import OUTCOME, RECENT_S, WIRE, new_session, sessions, write_private
from CNCStepper.control.session.local_socket import Address
from CNCStepper.control.session.status import DONE, FAILED, REFUSED, STOPPED
from CNCStepper.errors import LinkError, MachineRefusal, MissingPackage
from helpers.control.fake_controller import FakeServer

LINES = [f"G1X{number}F600" for number in range(40)]
LIMIT_S = 20.0


def started(server: FakeServer, folder: Path, lines=LINES, **job) -> SessionClient:
    job = {"zero_confirmed": True} | job
    return SessionClient.start(SendJob(server.url, lines, **job), python=sys.executable, folder=folder)


def until(client: SessionClient, phase: str) -> None:
    end_s = time.monotonic() + LIMIT_S
    while client.status().phase != phase:
        assert time.monotonic() < end_s, client.status()
        time.sleep(0.01)


@contextlib.contextmanager
def paused(folder: Path):
    """A session that stands at a pause of its program, and its controller."""
    with FakeServer() as server:
        client = started(server, folder, ["G1X1", "M0", *LINES], messages={1: "turn the part"})
        until(client, "paused")
        try:
            yield server, client
        finally:
            client._process.terminate()
            client._process.wait()


@pytest.fixture
def held(tmp_path):
    with paused(tmp_path) as session:
        yield session


@pytest.fixture(scope="module")
def untouched(tmp_path_factory):
    """One session for all tests that must not change it."""
    with paused(tmp_path_factory.mktemp("sessions")) as session:
        yield session


def peer_of(client: SessionClient) -> socket.socket:
    """One more connection to a client's session, which has shown no token yet."""
    return Address.of(json.loads(client.session_file.read_text())).connect(5.0)


@pytest.mark.slow
def test_a_port_that_ones_own_job_has_is_refused_with_its_name(untouched, tmp_path):
    server, client = untouched
    folder = client.session_file.parent
    session = client.session_file.stem
    with pytest.raises(MachineRefusal, match=rf"held by a job of yours.*paused.*cncstepper back --session {session}"):
        check_free(server.url, folder)
    service = ConnectionClient.launch(server.url, folder=folder)
    end_s = time.monotonic() + LIMIT_S
    while service.phase != "gone" and time.monotonic() < end_s:
        service.poll()
        time.sleep(0.01)
    assert service.error and service.error.code == "port-held"
    check_free(server.url, tmp_path)
    check_free("COM3", folder)


def test_a_port_of_a_killed_job_is_free(tmp_path):
    dead = new_session(tmp_path)
    write_private(dead, {"host": "127.0.0.1", "port": 9, "token": "", "machine_port": "COM3"})
    check_free("COM3", tmp_path)


def test_job_runs_in_its_own_process_and_nothing_is_left(tmp_path):
    statuses, events = [], []
    with FakeServer() as server:
        client = started(server, tmp_path)
        outcome = client.wait(statuses.append, lambda *event: events.append(event), limit_s=LIMIT_S)
        assert server.controller.lines == LINES
    assert outcome.kind == DONE and outcome.status.acknowledged == len(LINES)
    assert ("phase", "running") in events and statuses[-1].phase == DONE
    assert client._process.returncode == 0
    assert sessions(tmp_path) == []


@pytest.mark.slow
def test_client_leaves_and_another_comes_back(held):
    server, client = held
    assert client.status().message == "turn the part"
    client.close()
    time.sleep(0.2)
    with SessionClient.attach(client.session_file) as second:
        assert second.status().phase == "paused"
        second.resume()
        outcome = second.wait(limit_s=LIMIT_S)
    assert outcome.done and len(server.controller.lines) == len(LINES) + 1  # no M0
    client._connect()  # the first comes too late: the outcome is kept for it
    assert client.outcome.done
    client._reap()


@pytest.mark.slow
def test_answer_to_another_stand_is_refused_with_its_error(held):
    _, client = held
    present = client.status().stand
    client.resume(present - 1)
    refused: list[dict] = []
    end_s = time.monotonic() + LIMIT_S
    while not refused and time.monotonic() < end_s:
        refused += [event for event in client.poll(0.1) if event["event"] == "refused"]
    assert refused[0]["error"].code == "stand-over" and client.status().phase == "paused"
    client.resume(present)
    assert client.wait(limit_s=LIMIT_S).done


@pytest.mark.slow
def test_session_file_and_its_outcome_are_the_users_own(held):
    _, client = held
    content = json.loads(client.session_file.read_text())
    assert len(content["token"]) >= 32
    if os.name == "posix":
        assert client.session_file.stat().st_mode & 0o777 == 0o600
        assert Path(content["socket"]).stat().st_mode & 0o777 == 0o600
        assert Path(content["socket"]).parent.stat().st_mode & 0o777 == 0o700
    else:
        assert content["host"] == "127.0.0.1"
    client.stop()
    assert client.wait(limit_s=LIMIT_S).kind == STOPPED
    if os.name == "posix":
        assert client.session_file.with_suffix(OUTCOME).stat().st_mode & 0o777 == 0o600


@pytest.mark.parametrize(
    "request_text",
    [
        '{"token": "guess", "command": "stop"}',
        '{"command": "stop"}',
        "GET / HTTP/1.1",
        "[1]",
        '"\\ud800"',
        '{"token": "\\u00e9", "command": "stop"}',
        '{"token": "\\ud800", "command": "stop"}',
        "\x00\xff",
        "[" * 4000,
    ],
)
def test_peer_without_the_token_is_refused_and_changes_nothing(untouched, request_text):
    server, client = untouched
    with peer_of(client) as peer:
        peer.sendall(request_text.encode("latin-1") + b"\n")
        said = b""
        while data := peer.recv(4096):
            said += data
    assert b"refused" in said and b"status" not in said
    assert client.status().phase == "paused" and "\x18" not in server.controller.realtime


def test_peer_that_floods_without_a_line_end_is_dropped(untouched):
    _, client = untouched
    with peer_of(client) as peer, pytest.raises(OSError):
        for _ in range(1000):
            peer.sendall(b"x" * 10_000)
            time.sleep(0.001)
    assert client.status().phase == "paused"


def test_sigterm_stops_safely(held):
    server, client = held
    client._process.send_signal(signal.SIGTERM)
    outcome = client.wait(limit_s=LIMIT_S)
    assert outcome.kind == STOPPED and outcome.position_known
    assert [byte for byte in server.controller.realtime if byte != "?"] == ["!", "\x18"]
    assert client._process.returncode == 1


@pytest.mark.slow
def test_session_that_was_killed_is_lost_with_its_position(held):
    _, client = held
    client._process.kill()
    client._process.wait()
    with pytest.raises(LinkError, match="position is unknown"):
        client.wait(limit_s=LIMIT_S)
    with pytest.raises(LinkError, match="not there"):
        SessionClient.attach(client.session_file)


@pytest.mark.slow
def test_hold_resume_and_stop_over_the_session(tmp_path):
    with FakeServer(line_s=0.05) as server:
        client = started(server, tmp_path, LINES * 10)
        until(client, "running")
        client.hold()
        until(client, "held")
        client.resume()
        until(client, "running")
        client.stop()
        outcome = client.wait(limit_s=LIMIT_S)
        assert [byte for byte in server.controller.realtime if byte != "?"] == ["!", "~", "!", "\x18"]
    assert outcome.kind == STOPPED and outcome.position_known


@pytest.mark.slow
def test_error_crosses_the_process_with_its_class_and_place(tmp_path):
    with FakeServer() as server:
        server.controller.on_line[5] = "error:33"
        outcome = started(server, tmp_path, file="map.nc").wait(limit_s=LIMIT_S)
    assert outcome.kind == FAILED and outcome.error.code == "grbl-error-33"
    assert str(outcome.error.place) == "map.nc:6"
    with pytest.raises(MachineRefusal, match="circle"):
        outcome.raise_for_error()


@pytest.mark.slow
def test_refusal_crosses_the_process(tmp_path):
    with FakeServer() as server:
        server.controller.state = "Alarm"
        outcome = started(server, tmp_path).wait(limit_s=LIMIT_S)
        assert outcome.kind == REFUSED and outcome.error.code == "machine-alarm" and not server.controller.lines


def test_missing_port_is_a_refusal_not_a_crash(tmp_path):
    job = SendJob("/dev/no-such-port", LINES, zero_confirmed=True)
    outcome = SessionClient.start(job, python=sys.executable, folder=tmp_path).wait(limit_s=LIMIT_S)
    assert outcome.kind == REFUSED and outcome.error.code == "port-missing"


def test_worker_that_ends_at_once_names_its_log(tmp_path):
    client = SessionClient(new_session(tmp_path))
    broken = SendJob("x", ["G1"])
    object.__setattr__(broken, "baud", "fast")
    object.__setattr__(broken, "expected", {"no number": 1})
    write_job(client.session_file.with_suffix(WIRE), broken)
    client._process = start(sys.executable, WORKER, client.session_file)
    with pytest.raises(LinkError, match=r"\.log"):
        client._await_start()
    assert "not a job to send" in client.session_file.with_suffix(".log").read_text()


def test_a_real_python_is_found(monkeypatch):
    find_python.cache_clear()
    assert checked(find_python())[0]
    monkeypatch.setattr(sys, "executable", "/usr/bin/freecad")
    assert "/usr/bin/freecad" not in list(candidates())


def test_python_that_was_asked_for_and_does_not_serve_is_named(monkeypatch):
    find_python.cache_clear()
    monkeypatch.setenv(python_finder.VARIABLE, "/no/such/python")
    with pytest.raises(MissingPackage, match="/no/such/python"):
        find_python()
    monkeypatch.setattr(python_finder, "CHECK", "import no_such_serial")
    monkeypatch.setenv(python_finder.VARIABLE, sys.executable)
    with pytest.raises(MissingPackage, match="no_such_serial"):
        find_python()
    find_python.cache_clear()


def test_old_outcomes_are_pruned(tmp_path):
    old_s = time.time() - RECENT_S - 1
    for number in range(50):
        (tmp_path / f"{number:03}{OUTCOME}").write_text("{}")
        os.utime(tmp_path / f"{number:03}{OUTCOME}", (old_s, old_s))
    new_session(tmp_path)
    assert len(list(tmp_path.glob(f"*{OUTCOME}"))) == 20 and (tmp_path / f"049{OUTCOME}").exists()


def test_packages_of_the_starting_process_stand_behind_those_of_the_started(monkeypatch, tmp_path):
    (tmp_path / "only_seen_here.py").write_text("")
    (tmp_path / "json.py").write_text("raise ImportError('the started Python has its own')")
    needs = ("only_seen_here", "json")
    assert "only_seen_here" in checked(sys.executable, needs)[1]
    monkeypatch.setattr(sys, "path", [*sys.path, str(tmp_path)])
    assert checked(sys.executable, needs)[0]
    monkeypatch.setattr(python_finder, "python_version", lambda: "3.0")
    assert "only_seen_here" in checked(sys.executable, needs)[1]


def test_a_python_that_lacks_nothing_keeps_to_its_own_packages(monkeypatch, tmp_path):
    monkeypatch.setenv(BEHIND, os.pathsep.join([python_version(), str(tmp_path)]))
    monkeypatch.setattr(sys, "path", list(sys.path))
    see_packages("json", "click")
    see_packages()
    assert str(tmp_path) not in sys.path
    see_packages("json", "only_seen_there")
    assert sys.path[-1] == str(tmp_path)


@pytest.mark.slow
def test_a_python_is_sought_without_waiting(monkeypatch):
    find_python.cache_clear()
    begin_s = time.monotonic()
    answer = find_python_in_background()
    assert time.monotonic() - begin_s < 0.05
    assert answer.result(LIMIT_S) == find_python()
    find_python.cache_clear()
    monkeypatch.setenv(python_finder.VARIABLE, "/no/such/python")
    with pytest.raises(MissingPackage, match="pyserial"):
        find_python_in_background().result(LIMIT_S)
    find_python.cache_clear()
