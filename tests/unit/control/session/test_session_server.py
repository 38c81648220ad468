# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who is let in by a session's server, and what a client hears that does not read."""

from __future__ import annotations

import json
import os
import socket
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing
from math import inf
from pathlib import Path

import pytest

from CNCStepper import text_json
from CNCStepper.control.session import local_socket
from CNCStepper.control.session.command import Command
from CNCStepper.control.session.event_queue import LIMIT_BYTES, LIMIT_COUNT, TEXT_LIMIT, Backlog, EventQueue, line_of
from CNCStepper.control.session.files import new_session
from CNCStepper.control.session.local_socket import (  # fmt: skip
    LOOPBACK,
    TRANSPORT,
    Address,
    close_in_order,
    make_private,
    socket_paths,
)
from CNCStepper.control.session.server import KNOWN_LIMIT, UNAUTHENTICATED_LIMIT, SessionServer
from CNCStepper.control.session.status import DONE, Outcome, SenderStatus
from CNCStepper.errors import Text

LIMIT_S = 10.0
posix = pytest.mark.skipif(os.name != "posix", reason="Unix sockets, owners and modes of files")


class Job:
    """What is served here: it counts what it is asked, and its status is what a test sets."""

    commands = ("hold", "stop")

    def __init__(self) -> None:
        self.asked: list[str] = []
        self.stopped = False
        self.shown = SenderStatus(phase="running")
        self.on_status: Callable[[], object] = lambda: None  # called once, in the server's thread

    def ask(self, command: Command) -> None:
        self.asked.append(command.name)

    def stop(self) -> None:
        self.stopped = True

    def status(self) -> SenderStatus:
        on_status, self.on_status = self.on_status, lambda: None
        on_status()
        return self.shown


class Served:
    """A server in this process, on one transport."""

    def __init__(self, folder: Path):
        self.job = Job()
        self.server = SessionServer(folder / "a.session")
        self.content = self.server.address("COM3")
        self.address = Address.of(self.content)
        self.server.start(self.job)

    def connected(self) -> socket.socket:
        return self.address.connect(LIMIT_S)

    def ask(self, connection: socket.socket, command: str, **values: object) -> None:
        connection.sendall(json.dumps({"token": self.address.token, "command": command, **values}).encode() + b"\n")


@pytest.fixture(params=[LOOPBACK, pytest.param("unix", marks=posix)])
def served(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    monkeypatch.setenv(TRANSPORT, request.param)
    served = Served(tmp_path)
    assert bool(served.address.path) == (request.param != LOOPBACK)
    yield served
    served.server.finish()
    assert not served.job.stopped
    assert not served.address.path or not os.path.exists(served.address.path)


def until(reached: Callable[[], bool]) -> None:
    end_s = time.monotonic() + LIMIT_S
    while not reached():
        assert time.monotonic() < end_s
        time.sleep(0.005)


def events_until(connection: socket.socket, reached: Callable[[dict], bool]) -> list[dict]:
    events: list[dict] = []
    lines = connection.makefile("rb")
    connection.settimeout(LIMIT_S)
    while not (events and reached(events[-1])):
        events.append(json.loads(lines.readline()))
    return events


def is_open(connection: socket.socket) -> bool:
    connection.settimeout(0)
    try:
        return connection.recv(1) != b""
    except BlockingIOError:
        return True
    except OSError:
        return False


def test_the_oldest_peer_without_the_token_makes_room_and_none_that_has_shown_it(served):
    known = served.connected()
    served.ask(known, "attach")
    events_until(known, lambda event: event["event"] == "status")
    strangers = [served.connected() for _ in range(UNAUTHENTICATED_LIMIT)]
    until(lambda: len(served.server._peers) == UNAUTHENTICATED_LIMIT + 1)
    assert all(map(is_open, strangers))
    late = [served.connected() for _ in range(3)]
    until(lambda: not any(map(is_open, strangers[:3])))
    assert all(map(is_open, [*strangers[3:], *late]))
    served.ask(late[0], "hold")
    until(lambda: served.job.asked == ["hold"])
    served.ask(known, "stop")
    until(lambda: served.job.asked == ["hold", "stop"])
    for connection in (known, *strangers, *late):
        connection.close()


def test_a_token_that_is_on_its_way_counts_before_its_peer_makes_room(served, monkeypatch):
    """The server was busy while it came: it looks once more."""
    monkeypatch.setattr(served.server, "_turn", lambda: time.sleep(0.005))
    first = served.connected()
    others = [served.connected() for _ in range(UNAUTHENTICATED_LIMIT + 10)]
    served.ask(first, "hold")
    monkeypatch.undo()
    until(lambda: served.job.asked == ["hold"])
    for connection in (first, *others):
        connection.close()


def test_one_more_client_than_can_be_served_is_told_so_and_the_others_stay(served):
    clients = []
    for number in range(KNOWN_LIMIT + 1):
        clients.append(served.connected())
        served.ask(clients[-1], "status")
        first = events_until(clients[-1], lambda event: True)[0]
        assert first["event"] == ("refused" if number == KNOWN_LIMIT else "status")
    assert is_open(clients[0])
    for client in clients:
        client.close()


def test_a_client_that_does_not_read_gets_the_newest_in_bounded_room_and_is_not_dropped(served):
    slow = served.connected()
    served.ask(slow, "attach")
    until(lambda: any(peer.attached for peer in served.server._peers.values()))
    for number in range(20_000):
        served.server.tell("message", f"flood {number} " + "x" * 200)
        if number % 1000 == 0:
            served.job.shown = SenderStatus(phase="running", sent=number)
            served.server.tell("phase", str(number))
            time.sleep(0.002)
    served.job.shown = SenderStatus(phase="held")
    time.sleep(0.2)  # several turns of the server
    (peer,) = served.server._peers.values()
    assert sum(len(entry.line) for entry in peer.backlog._texts.entries) <= LIMIT_BYTES
    served.ask(slow, "hold")
    until(lambda: served.job.asked == ["hold"])  # it is heard although it does not hear
    heard = events_until(slow, lambda event: event["event"] == "accepted")
    statuses = [event["status"] for event in heard if event["event"] == "status"]
    assert statuses[-1]["phase"] == "held" and len(statuses) < 20
    assert sum(map(len, map(line_of, heard))) < 1_000_000  # of 4.6 MB
    assert [event["text"] for event in heard if event["event"] == "phase"] == [str(n * 1000) for n in range(20)]
    messages = [event["text"] for event in heard if event["event"] == "message"]
    assert messages[-1].startswith("flood 19999 ")
    left_out = [int(event["text"].split()[0]) for event in heard if event["event"] == "warning"]
    assert sum(left_out) + len(messages) == 20_000
    slow.close()


def test_a_command_is_heard_while_the_machine_floods(served):
    over = threading.Event()

    def flood() -> None:
        while not over.is_set():
            served.server.tell("message", "flood")

    flooding = threading.Thread(target=flood)
    flooding.start()
    try:
        begin_s = time.monotonic()
        client = served.connected()
        served.ask(client, "attach")
        served.ask(client, "hold")
        events_until(client, lambda event: event["event"] == "accepted")
        assert time.monotonic() - begin_s < 2.0 and served.job.asked == ["hold"]
        client.close()
    finally:
        over.set()
        flooding.join()


@pytest.mark.parametrize("has_read", [True, False])
def test_a_command_of_a_client_that_has_closed_is_heard_before_it_is_dropped(served, has_read):
    """It asks and closes between the server's look at its peers and what the server has to tell them."""
    connection = attached_to(served)
    has_gone = threading.Event()

    def stop_and_go() -> None:
        served.job.shown = SenderStatus(phase="paused")  # so that a status is sent, to a closed connection
        served.ask(connection, "stop")
        connection.setblocking(False)
        close_in_order(connection) if has_read else connection.close()
        has_gone.set()

    served.job.on_status = stop_and_go
    assert has_gone.wait(LIMIT_S)
    until(lambda: not served.server._peers)
    assert served.job.asked == ["stop"]


def test_whoever_comes_late_hears_the_phases_first_and_the_present_last(served):
    for number in range(3 * LIMIT_COUNT):
        served.server.tell("message", f"flood {number}")
    served.server.tell("phase", "paused")
    served.server.tell("message", "the last")
    until(lambda: b"the last" in b"".join(entry.line for entry in served.server._history._texts.entries))
    with closing(served.connected()) as client:
        served.ask(client, "attach")
        heard = events_until(client, lambda event: event["event"] == "status")
    texts = [event["text"] for event in heard[:-1]]
    assert texts[-2:] == ["paused", "the last"] and len(texts) <= LIMIT_COUNT + 1


# --- the place where it listens ----------------------------------------------------------------


def attached_to(served: Served, **values: object) -> socket.socket:
    connection = served.connected()
    served.ask(connection, "attach", **values)
    events_until(connection, lambda event: event["event"] == "status")
    return connection


def test_a_client_that_crashed_is_waited_for_also_where_another_has_left(served):
    with closing(attached_to(served)) as left, closing(attached_to(served)) as crashed:
        served.ask(left, "leave")
        until(lambda: len(served.server._peers) == 1)
        crashed.close()
        until(lambda: served.server.alone_s() > 0.0)
        assert served.server.alone_s() < LIMIT_S


def test_nobody_is_waited_for_when_the_last_client_has_left(served):
    with closing(attached_to(served)) as crashed, closing(attached_to(served)) as left:
        crashed.close()
        until(lambda: len(served.server._peers) == 1)
        served.ask(left, "leave")
        until(lambda: served.server.alone_s() == inf)


@pytest.mark.parametrize("end", ["leave", "crash"])
def test_connection_is_kept_for_as_long_as_a_client_that_is_gone_wanted(served, end):
    begin_s = time.monotonic()
    with closing(attached_to(served, keep_s=0.5)) as client:
        if end == "leave":
            served.ask(client, "leave")
    until(lambda: not served.server._peers)
    assert served.server.alone_s() == 0.0 or time.monotonic() - begin_s > 0.5
    until(lambda: served.server.alone_s() > 0.0)
    assert time.monotonic() - begin_s >= 0.5
    assert (served.server.alone_s() == inf) == (end == "leave")


def test_a_client_that_keeps_nothing_open_leaves_what_another_wanted(served):
    with closing(attached_to(served, keep_s=60)) as first, closing(attached_to(served, keep_s=0)) as second:
        served.ask(first, "leave")
        served.ask(second, "leave")
        until(lambda: not served.server._peers)
    assert served.server.alone_s() == 0.0


def test_a_window_that_disconnects_last_ends_what_others_wanted(served):
    with closing(attached_to(served, keep_s=60)) as terminal, closing(attached_to(served)) as window:
        served.ask(terminal, "leave")
        until(lambda: len(served.server._peers) == 1)
        served.ask(window, "leave")
        until(lambda: served.server.alone_s() == inf)


def test_time_begins_anew_when_a_job_ends(served):
    with closing(attached_to(served, keep_s=0.3)) as client:
        served.ask(client, "leave")
    until(lambda: served.server.alone_s() == inf)
    served.server.notify_outcome(Outcome(DONE, "cut", True, SenderStatus()))
    assert served.server.alone_s() == 0.0
    until(lambda: served.server.alone_s() == inf)


@pytest.mark.parametrize("keep_s", [-1, "60", True, None, [], float("nan"), {}])
def test_a_time_that_is_none_keeps_nothing(served, keep_s):
    with closing(attached_to(served, keep_s=keep_s)) as client:
        served.ask(client, "leave")
        until(lambda: served.server.alone_s() == inf)


@posix
def test_a_folder_that_is_open_to_others_is_closed(tmp_path):
    open_folder = tmp_path / "state"
    open_folder.mkdir()
    open_folder.chmod(0o755)
    make_private(open_folder)
    assert open_folder.stat().st_mode & 0o777 == 0o700
    make_private(tmp_path / "new")
    assert (tmp_path / "new").stat().st_mode & 0o777 == 0o700


@posix
def test_a_folder_of_another_user_is_no_place(tmp_path, monkeypatch):
    monkeypatch.setattr(local_socket.os, "geteuid", lambda: os.getuid() + 1)
    with pytest.raises(PermissionError):
        make_private(tmp_path)


@posix
def test_under_a_long_path_the_socket_is_in_a_short_folder_that_is_closed(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    short = tmp_path / f"cncstepper-{os.geteuid()}"
    short.mkdir(mode=0o755)
    deep = tmp_path / ("ç" * 60)
    deep.mkdir()
    assert socket_paths(deep / "a.session") == [short / "a.sock"]
    listener = local_socket.Listener(deep / "a.session")
    assert listener.address == {"socket": str(short / "a.sock")}
    assert short.stat().st_mode & 0o777 == 0o700 and (short / "a.sock").stat().st_mode & 0o777 == 0o600
    listener.close()
    assert not list(short.iterdir())


@posix
def test_only_a_socket_that_nobody_listens_at_is_pruned(tmp_path):
    alive, dead = local_socket.Listener(tmp_path / "a.session"), local_socket.Listener(tmp_path / "b.session")
    dead.socket.close()
    for name in ("a", "b"):
        (tmp_path / f"{name}.session").write_text("{}")  # as when it was replaced, and its process has not seen it yet
    new_session(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["a.sock"]
    alive.close()


@posix
def test_a_planted_link_is_no_folder_for_a_socket(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path))
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / f"cncstepper-{os.geteuid()}").symlink_to(tmp_path / "elsewhere")
    deep = tmp_path / ("x" * 100)
    deep.mkdir()
    listener = local_socket.Listener(deep / "a.session")
    assert listener.address["host"] == "127.0.0.1" and not list((tmp_path / "elsewhere").iterdir())
    listener.close()


@pytest.mark.skipif(sys.platform != "linux", reason="the credentials of a peer, as Linux gives them")
def test_another_user_is_not_let_in(tmp_path, monkeypatch):
    served = Served(tmp_path)
    monkeypatch.setattr(local_socket.os, "geteuid", lambda: os.getuid() + 1)
    monkeypatch.setattr(local_socket.struct, "unpack", lambda *_: (1, os.getuid() + 2, 1))
    with closing(socket.socket(socket.AF_UNIX)) as other:
        other.connect(served.address.path)
        until(lambda: not is_open(other))
    with pytest.raises(PermissionError, match="another user"):
        served.connected()
    monkeypatch.undo()
    with closing(served.connected()) as own:
        served.ask(own, "hold")
        until(lambda: served.job.asked == ["hold"])
    served.server.finish()


GOOD = {"token": "t", "process": 7, "host": "127.0.0.1", "port": 4000}


@pytest.mark.parametrize(
    "change",
    [
        {"token": 5},
        {"process": "7"},
        {"process": 0},
        {"process": True},
        {"process": 10**4000},
        {"port": 10**4000},
        {"port": 0},
        {"port": 70_000},
        {"host": "192.0.2.1"},
        {"host": ["127.0.0.1"]},
        {"socket": 5},
        {"socket": "a\0b"},
    ],
)
def test_an_address_that_is_none_is_no_address(change):
    assert Address.of(GOOD).target == ("127.0.0.1", 4000)
    with pytest.raises(ValueError):
        Address.of(GOOD | change)


# --- what waits --------------------------------------------------------------------------------


def test_a_status_takes_the_place_of_the_one_before_and_keeps_its_turn():
    backlog = Backlog()
    backlog.add("phase", b"1\n")
    backlog.add("status", b"old\n")
    backlog.add("phase", b"2\n")
    backlog.add("status", b"new\n")
    assert backlog.take(1) == b"1\n" and backlog.take(1) == b"new\n" and backlog.take(100) == b"2\n"
    assert not backlog and backlog.take(100) == b""


def test_one_text_is_cut_and_bytes_are_bounded_as_well_as_numbers():
    news = EventQueue()
    for _ in range(LIMIT_COUNT):
        news.put({"event": "message", "text": "\x1b" * 10 * TEXT_LIMIT})
    taken = news.take()
    assert sum(len(entry.line) for entry in taken._texts.entries) <= LIMIT_BYTES
    assert taken.left_out + len(taken._texts.entries) == LIMIT_COUNT
    assert not news.take()
    assert len(line_of({"event": "phase", "text": "x" * 10 * TEXT_LIMIT})) > 10 * TEXT_LIMIT


def test_a_status_whose_message_has_values_is_read_back_with_them():
    told = SenderStatus(message=Text("line by line: line {line} is next", line=7))
    read = SenderStatus.from_json(text_json.loads(text_json.dumps({"status": told.to_json()}))["status"])
    assert read == told and read.message.values == {"line": 7}
