# SPDX-License-Identifier: LGPL-2.1-or-later
"""A session lives as long as its process does, whatever becomes of its file, of the clock and of its connections."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.control.journal import store
from CNCStepper.control.journal.replay import read_replay
from CNCStepper.control.journal.writer import JournalFile
from CNCStepper.control.processes import process_file
from CNCStepper.control.processes.process_file import ProcessFile, is_alive
from CNCStepper.control.program.send_job import SendJob
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.service.connection_session import ConnectionSession, jobs_running
from CNCStepper.control.service.port_owner import check_free
from CNCStepper.control.session import client as session
from CNCStepper.control.session import files
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import (  # fmt: skip
    KEPT,
    LOG,
    OUTCOME,
    RECENT_S,
    SERVICE,
    SESSION,
    WIRE,
    new_session,
    read_private,
    running_services,
    session_at,
    sessions,
)
from CNCStepper.control.session.status import STOPPED
from CNCStepper.errors import CNCStepperError, JobError, LinkError, MachineRefusal
from CNCStepper.workers import connection_service
from helpers.control.fake_controller import FakeServer

LIMIT_S = 20.0
OWNER = """
import sys, time; from pathlib import Path; from CNCStepper.control.processes.process_file import ProcessFile
own = ProcessFile(Path(sys.argv[1])); own.write({"machine_port": "COM3"})
print("", flush=True); time.sleep(1000)
"""
MANY_DIGITS = "7" * 5000


@contextlib.contextmanager
def owner_of(path: Path) -> Iterator[subprocess.Popen]:
    """Another process that has a file of its own."""
    with subprocess.Popen([sys.executable, "-c", OWNER, str(path)], stdout=subprocess.PIPE) as process:
        assert process.stdout
        process.stdout.readline()
        yield process
        process.kill()


@contextlib.contextmanager
def cutting(folder: Path) -> Iterator[SessionClient]:
    """A session in a process of its own, with a client; it must be stopped by a client in the end."""
    with FakeServer(line_s=0.05) as server:
        job = SendJob(server.url, [f"G1X{number}F600" for number in range(400)], zero_confirmed=True)
        client = SessionClient.start(job, python=sys.executable, folder=folder)
        try:
            yield client
            client.stop()
            assert client.wait(limit_s=LIMIT_S).kind == STOPPED
        finally:
            client._process.kill()
            client._process.wait()


def until(reached: Callable[[], object]) -> None:
    end_s = time.monotonic() + LIMIT_S
    while not reached():
        assert time.monotonic() < end_s
        time.sleep(0.02)


def spoiled(path: Path, how: str) -> None:
    """Make of a file what nobody of ours has written."""
    texts = {
        "empty": b"",
        "cut": b'{"token": "abc", "proc',
        "no JSON": b"hello",
        "not UTF-8": b'{"token": "\xff\xfe"}',
        "a list": b"[1, 2]",
        "wrong types": b'{"token": 5, "process": "x", "port": [], "status": 7, "kind": {}, "error": 5}',
        "5000 digits": f'{{"token": "t", "process": {MANY_DIGITS}, "error": {MANY_DIGITS}}}'.encode(),
        "4000 digits": f'{{"token": "t", "process": {MANY_DIGITS[:4000]}, "port": 5}}'.encode(),
        "deep": b"[" * 100_000,
    }
    if how in texts:
        path.write_bytes(texts[how])
        return
    path.unlink(missing_ok=True)
    if how == "a directory":
        path.mkdir()
    elif how == "a FIFO":
        os.mkfifo(path)


SPOILED = (
    "empty", "cut", "no JSON", "not UTF-8", "a list", "wrong types", "5000 digits", "4000 digits", "deep",
    "a directory", *(["a FIFO"] if hasattr(os, "mkfifo") else []),
)  # fmt: skip


# --- who lives ---------------------------------------------------------------------------------


def test_a_process_is_alive_until_it_is_killed_whatever_the_clock_says(tmp_path):
    path = tmp_path / f"a{SESSION}"
    with owner_of(path) as process:
        for changed_s in (-1e6, 1e6):
            os.utime(path, (time.time() + changed_s, time.time() + changed_s))
            assert is_alive(path) and sessions(tmp_path) == [path] and session_at("COM3", tmp_path) == path
            new_session(tmp_path)
            assert path.exists()
        process.kill()
        process.wait()
        assert path.exists() and not is_alive(path) and sessions(tmp_path) == []
        new_session(tmp_path)
        assert not path.exists()


def test_the_number_of_a_dead_process_that_another_one_got_keeps_nothing_alive(tmp_path):
    path = tmp_path / f"a{SESSION}"
    path.write_text(json.dumps({"token": "t", "process": os.getpid(), "host": "127.0.0.1", "port": 9}))
    assert not is_alive(path) and sessions(tmp_path) == []
    with pytest.raises(LinkError, match="not there, or was killed"):
        SessionClient.attach(path)
    assert path.exists()  # no client's to remove


def test_many_may_look_at_once(tmp_path):
    path = tmp_path / f"a{SESSION}"
    wrong: list[bool] = []
    path.write_text("{}")

    def look() -> None:
        wrong.extend(filter(None, (is_alive(path) for _ in range(300))))

    threads = [threading.Thread(target=look) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong or sys.platform == "win32"


def test_its_own_process_removes_it(tmp_path):
    own = ProcessFile(tmp_path / f"a{SERVICE}")
    own.write({})
    own.remove()
    own.keep()
    own.remove()
    assert not list(tmp_path.iterdir())


def held_open(self: Path, missing_ok: bool = False) -> None:
    """What `Path.unlink` does on Windows while another process has the file open."""
    raise PermissionError(13, "The process cannot access the file because it is being used by another process")


def test_its_process_ends_also_where_a_client_never_closes_it(tmp_path, monkeypatch):
    own = ProcessFile(tmp_path / f"a{SESSION}")
    own.write({"machine_port": "COM3"})
    monkeypatch.setattr(process_file, "REMOVE_LIMIT_S", 0.1)
    monkeypatch.setattr(Path, "unlink", held_open)
    own.remove()
    assert not is_alive(tmp_path / f"a{SESSION}")


def test_a_file_that_a_client_looks_at_is_removed_when_it_was_closed(tmp_path, monkeypatch):
    own, path, unlink, tries = ProcessFile(tmp_path / f"a{SESSION}"), tmp_path / f"a{SESSION}", Path.unlink, []

    def held_at_first(self: Path, missing_ok: bool = False) -> None:
        tries.append(self)
        held_open(self) if len(tries) < 4 else unlink(self, missing_ok)

    own.write({"machine_port": "COM3"})
    monkeypatch.setattr(Path, "unlink", held_at_first)
    own.remove()
    assert len(tries) == 4 and not path.exists()


def test_a_service_leaves_nothing_where_the_disk_takes_no_outcome(tmp_path, monkeypatch):
    def full(path: Path, content: object) -> None:
        raise OSError(28, "No space left on device")

    for name in ("stop_on_signals", "go_first"):
        monkeypatch.setattr(connection_service, name, lambda *arguments: None)
    monkeypatch.setattr(sys, "setswitchinterval", lambda seconds: None)
    monkeypatch.setattr(connection_service, "_run", lambda service, service_file: None)
    monkeypatch.setattr(connection_service, "write_private", full)
    tmp_path.chmod(0o700)
    with pytest.raises(OSError, match="No space"):
        connection_service.main([str(tmp_path / f"a{SERVICE}"), str(tmp_path / "port"), "115200"])
    assert not [path for path in tmp_path.iterdir() if path.suffix in (SERVICE, WIRE, ".sock")]


@pytest.mark.parametrize("how", [*(how for how in SPOILED if how != "a directory"), "removed"])
def test_its_process_mends_it(tmp_path, monkeypatch, how):
    monkeypatch.setattr(process_file, "LOOK_EVERY_S", 0.0)
    path = tmp_path / f"a{SERVICE}"
    own = ProcessFile(path)
    own.write({"machine_port": "COM3"})
    path.unlink() if how == "removed" else spoiled(path, how)
    own.keep()
    assert read_private(path) == {"machine_port": "COM3"} and is_alive(path)
    own.remove()
    assert not path.exists()


def test_nothing_of_a_living_one_is_pruned_and_nothing_that_is_young(tmp_path, monkeypatch):
    old_s = time.time() - RECENT_S - 1
    names = [f"{number:03}" for number in range(KEPT + 10)]
    for name in names:
        for kind in (OUTCOME, LOG, WIRE):
            (tmp_path / f"{name}{kind}").write_text("{}")
            os.utime(tmp_path / f"{name}{kind}", (old_s, old_s))
    own = ProcessFile(tmp_path / f"000{SERVICE}")  # the oldest, as after days
    own.write({})
    (tmp_path / f"001{LOG}").write_text("of a process that begins, after the clock was put back")
    new_session(tmp_path)
    assert {path.name for path in tmp_path.glob("000*")} == {f"000{kind}" for kind in (SERVICE, OUTCOME, LOG, WIRE)}
    assert [path.name for path in tmp_path.glob("001*")] == [f"001{LOG}"]
    assert not list(tmp_path.glob("002*")) and len(list(tmp_path.glob(f"*{OUTCOME}"))) == KEPT + 1
    own.remove()


def test_files_begun_within_one_second_sort_by_their_beginning(tmp_path):
    names = []
    for _ in range(20):
        names.append(new_session(tmp_path).name)
        time.sleep(2e-6)  # names count microseconds
    assert names == sorted(names)


def test_a_journal_that_is_being_written_is_not_pruned(tmp_path, monkeypatch):
    monkeypatch.setattr(store, "KEPT_JOBS", 0)
    path = tmp_path / "20261123-000000-a.journal"
    journal = JournalFile(path)
    os.utime(path, (0, 0))  # the clock was put forward by years
    store.prune(tmp_path)
    assert path.exists()
    journal.close()
    store.prune(tmp_path)
    assert not path.exists()


@pytest.mark.parametrize("how", SPOILED)
def test_a_damaged_journal_is_refused_and_waited_for_by_nobody(tmp_path, how):
    spoiled(tmp_path / "a.journal", how)
    assert list(store.replays(tmp_path)) == []
    with pytest.raises(JobError, match="journal"):
        read_replay(tmp_path / "a.journal")


# --- damaged files -----------------------------------------------------------------------------


@pytest.mark.parametrize("how", SPOILED)
def test_damaged_files_of_dead_sessions_are_no_sessions(tmp_path, how):
    for kind in (SESSION, SERVICE):
        spoiled(tmp_path / f"a{kind}", how)
    assert sessions(tmp_path) == [] and running_services(tmp_path) == [] and jobs_running(tmp_path) == []
    check_free("COM3", tmp_path)
    for attach in (SessionClient.attach, ConnectionSession.attach):
        with pytest.raises(LinkError, match="not there, or was killed"):
            attach(tmp_path / f"a{SESSION if attach == SessionClient.attach else SERVICE}")
    new_session(tmp_path)
    assert how == "a directory" or not list(tmp_path.iterdir())


@pytest.mark.parametrize("how", SPOILED)
def test_an_outcome_that_cannot_be_read_is_told_in_a_sentence(tmp_path, how):
    spoiled(tmp_path / f"a{OUTCOME}", how)
    with pytest.raises(LinkError, match=r"outcome cannot be read.*position is unknown"):
        SessionClient.attach(tmp_path / f"a{SESSION}")
    service = ConnectionClient.attach(tmp_path / f"a{SERVICE}")
    service.poll()
    assert service.phase == "gone" and isinstance(service.error, CNCStepperError)


@pytest.mark.slow
@pytest.mark.parametrize("how", SPOILED)
def test_a_session_whose_file_is_damaged_while_it_cuts_is_reached(tmp_path, how):
    with cutting(tmp_path) as client:
        spoiled(client.session_file, how)
        if how == "a directory":
            client.session_file.rmdir()  # which its process does not do
        with attached_again(client) as second:
            second.hold()
            until(lambda: second.status().phase == "held")
        assert sessions(tmp_path) == [client.session_file]


def attached_again(client: SessionClient) -> SessionClient:
    """One more client of a session, as soon as its process has mended its file."""
    until(lambda: is_alive(client.session_file))
    return SessionClient.attach(client.session_file)


# --- a process that does not answer ------------------------------------------------------------


@pytest.fixture
def impatient(monkeypatch):
    for module, name in ((session, "ANSWER_LIMIT_S"), (session, "WELCOME_LIMIT_S")):
        monkeypatch.setattr(module, name, 0.5)
    monkeypatch.setattr(files, "MEND_LIMIT_S", 0.5)


@pytest.mark.slow
@pytest.mark.skipif(not hasattr(signal, "SIGSTOP"), reason="a process that is stopped by a signal")
def test_a_process_that_does_not_answer_is_no_job_that_has_ended(tmp_path, impatient):
    with cutting(tmp_path) as client:
        content = read_private(client.session_file) or {}
        client._process.send_signal(signal.SIGSTOP)
        os.waitpid(client._process.pid, os.WUNTRACED)  # until it stands
        try:
            with pytest.raises(LinkError, match=rf"runs, but its process does not answer.*kill {content['process']}"):
                SessionClient.attach(client.session_file)
            with pytest.raises(MachineRefusal, match="held by a process of yours that does not answer"):
                check_free(content["machine_port"], tmp_path)
            assert client.session_file.exists() and sessions(tmp_path) == [client.session_file]
        finally:
            client._process.send_signal(signal.SIGCONT)


@pytest.mark.slow
def test_a_living_process_with_a_damaged_file_keeps_ports_from_being_opened(tmp_path, impatient):
    path = tmp_path / f"a{SESSION}"
    with owner_of(path):
        path.write_bytes(b"{")  # its process has no thread that would mend it
        with pytest.raises(LinkError, match="cannot be read"):
            check_free("COM4", tmp_path)
        with pytest.raises(LinkError, match="does not answer"):
            SessionClient.attach(path)
    assert session_at("COM4", tmp_path) is None


@pytest.mark.slow
def test_a_connection_that_breaks_is_made_again_while_the_process_lives(tmp_path):
    with cutting(tmp_path) as client:
        client._connection.shutdown(2)
        client.hold()
        until(lambda: client.status().phase == "held")
        client.resume()
