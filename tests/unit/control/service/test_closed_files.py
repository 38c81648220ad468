# SPDX-License-Identifier: LGPL-2.1-or-later
"""A file that this user may not open, as the administrator's, keeps no port, is told by name and is never removed."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from CNCStepper.cli.job.running_job import session_file
from CNCStepper.cli.main import main
from CNCStepper.control.journal import store
from CNCStepper.control.processes import file_lock, process_file
from CNCStepper.control.processes.process_file import ProcessFile, is_alive, is_closed
from CNCStepper.control.service import connection_session
from CNCStepper.control.service.connection_client import ConnectionClient
from CNCStepper.control.service.connection_session import jobs_running
from CNCStepper.control.service.port_owner import check_free, warn_of_closed
from CNCStepper.control.service.position_trust_file import PositionTrustFile
from CNCStepper.control.session.files import (  # fmt: skip
    KEPT,
    LOG,
    OUTCOME,
    RECENT_S,
    SERVICE,
    SESSION,
    WIRE,
    closed_files,
    new_session,
    running_services,
    service_at,
    session_at,
    session_folder,
    sessions,
)
from CNCStepper.control.stream.position_trust import AT_HOME, LOST
from CNCStepper.errors import JobError, LinkError

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the list of locks")
fcntl = pytest.importorskip("fcntl")
KINDS = ((SESSION, session_at, sessions), (SERVICE, service_at, running_services))
NOBODY = 65534
LOOK = """
import sys; from pathlib import Path
from CNCStepper.control.processes.process_file import is_alive, is_closed
from CNCStepper.control.session.files import new_session, session_at
path = Path(sys.argv[1])
new_session(path.parent)
print(is_closed(path), is_alive(path), path.exists(), session_at("COM3", path.parent))
"""


@pytest.fixture
def close(monkeypatch: pytest.MonkeyPatch) -> Callable[[Path], Path]:
    """Close a file to this user, also to the administrator, whom no mode of a file keeps out."""
    shut: set[str] = set()
    system_open = os.open

    def refuse(path: object, *arguments: object, **more: object) -> int:
        if str(path) in shut:
            raise PermissionError(13, "Permission denied", str(path))
        return system_open(path, *arguments, **more)  # type: ignore[arg-type]

    def shut_it(path: Path) -> Path:
        path.touch()
        shut.add(str(path))
        return path

    monkeypatch.setattr(os, "open", refuse)
    return shut_it


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The user's folder of sessions."""
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    return session_folder()


@pytest.fixture
def locked() -> Iterator[Callable[[Path], None]]:
    """Lock a file as its living process does, from elsewhere than the code under test."""
    held = []

    def lock_it(path: Path) -> None:
        held.append(open(path, "rb"))  # noqa: SIM115 - closed below
        fcntl.flock(held[-1], fcntl.LOCK_EX)

    yield lock_it
    for file in held:
        file.close()


# --- whose port ------------------------------------------------------------------------------------


@pytest.mark.parametrize(("kind", "at", "running"), KINDS, ids=["session", "service"])
@pytest.mark.parametrize("lives", [True, False], ids=["lives", "has ended"])
def test_a_closed_file_keeps_no_port_and_hides_nobody_elses(folder, close, locked, kind, at, running, lives):
    other = close(folder / f"a{kind}")
    if lives:
        locked(other)
    own = ProcessFile(folder / f"b{kind}")
    own.write({"machine_port": "COM3"})
    begin_s = time.monotonic()
    assert at("COM3", folder) == folder / f"b{kind}" and at("COM4", folder) is None
    assert running(folder) == [folder / f"b{kind}"] and closed_files(folder) == [other]
    assert time.monotonic() - begin_s < 1.0  # nobody waits for it to be mended
    check_free("COM4", folder)
    own.remove()


def test_a_file_that_is_closed_between_two_looks_is_no_session(folder, close, monkeypatch):
    own = ProcessFile(folder / f"a{SESSION}")
    own.write({"machine_port": "COM3"})
    monkeypatch.setattr("CNCStepper.control.session.files.sessions", lambda folder: [own._path])
    close(own._path)
    assert session_at("COM4", folder) is None
    own.remove()


@pytest.mark.parametrize("lives", [True, False], ids=["lives", "has ended"])
def test_whoever_finds_no_job_is_told_of_the_closed_file(folder, close, locked, lives):
    other = close(folder / f"a{SESSION}")
    if lives:
        locked(other)
    for name in (None, "a"):
        with pytest.raises(JobError, match="belongs to") as caught:
            session_file(name)
        assert str(other) in str(caught.value) and other.owner() in str(caught.value)
        assert f"{'end that session' if lives else 'remove the file'} as {other.owner()}" in str(caught.value)
    with pytest.raises(JobError) as caught:
        session_file("b")
    assert "belongs to" not in str(caught.value)
    assert jobs_running(folder) == []


@pytest.mark.parametrize("verb", ["hold", "stop", "go", "back"])
def test_verbs_tell_of_it_in_a_sentence(folder, close, monkeypatch, capsys, verb):
    other = close(folder / f"a{SESSION}")
    monkeypatch.setattr(sys, "argv", ["cncstepper", verb])
    with pytest.raises(SystemExit):
        main()
    said = "".join(capsys.readouterr().err.split())  # as it is broken into lines
    assert "nojobruns" in said and str(other) in said and f"removethefileas{other.owner()}" in said


def test_hold_works_beside_it(folder, close):
    close(folder / f"a{SESSION}")
    own = ProcessFile(folder / f"b{SESSION}")
    own.write({"machine_port": "COM3"})
    assert session_file(None) == session_file("b") == folder / f"b{SESSION}"
    own.remove()


def test_only_of_one_that_may_live_is_told_where_a_port_is_opened(folder, close, locked):
    told: list[str] = []
    close(folder / f"a{SESSION}")
    locked(close(folder / f"b{SERVICE}"))
    warn_of_closed(told.append)
    assert len(told) == 1 and f"b{SERVICE}" in told[0] and "session-closed" in told[0]


def test_attaching_to_it_is_refused_at_once(folder, close, locked):
    begin_s = time.monotonic()
    for kind in (SESSION, SERVICE):
        locked(close(folder / f"a{kind}"))
        with pytest.raises(LinkError, match=r"belongs to .* \[session-closed\]"):
            connection_session.attach(folder / f"a{kind}")
    assert time.monotonic() - begin_s < 2.0
    client = ConnectionClient.attach(folder / f"a{SERVICE}")
    client.poll()
    assert client.phase == "gone" and client.error and client.error.code == "session-closed"


# --- whether it lives ------------------------------------------------------------------------------


def test_the_list_of_locks_says_whether_it_lives(folder, close, locked):
    other = close(folder / f"a{SESSION}")
    assert is_closed(other) and not is_alive(other)
    locked(other)
    assert is_alive(other)


@pytest.mark.parametrize("how", ["no list", "in a container", "a file system that is not listed"])
def test_where_no_list_says_it_it_may_live(folder, close, monkeypatch, tmp_path, how):
    other = close(folder / f"a{SESSION}")
    if how == "in a container":
        monkeypatch.setattr(file_lock, "ALL_PROCESSES", "pid:[1]")
    else:
        (tmp_path / "locks").write_text("1: FLOCK  ADVISORY  WRITE 9 fe:00:1 0 EOF\n")
        monkeypatch.setattr(file_lock, "LISTED", tmp_path / ("none" if how == "no list" else "locks"))
    assert file_lock.is_listed(other) is None and is_alive(other)


def test_a_socket_that_nobody_serves_says_that_it_has_ended(folder, close, monkeypatch, tmp_path):
    import socket

    other = close(folder / f"a{SESSION}")
    monkeypatch.setattr(file_lock, "LISTED", tmp_path / "none")
    with socket.socket(socket.AF_UNIX) as listener:
        monkeypatch.chdir(folder)
        listener.bind("a.sock")
        monkeypatch.setattr("CNCStepper.control.processes.process_file.socket_paths", lambda path: [Path("a.sock")])
        listener.listen()
        assert is_alive(other)
    assert not is_alive(other)


# --- nobody's to remove ----------------------------------------------------------------------------


def test_no_closed_file_is_ever_removed(folder, close):
    old_s = time.time() - RECENT_S - 1
    kept = [close(folder / f"000{kind}") for kind in (SESSION, SERVICE)]
    beside = [close(folder / f"001{kind}") for kind in (OUTCOME, LOG, WIRE)]
    for number in range(KEPT + 5):
        for kind in (OUTCOME, LOG, WIRE):
            (folder / f"1{number:02}{kind}").touch()
    for path in folder.iterdir():
        os.utime(path, (old_s, old_s))
    new_session(folder)
    assert all(path.exists() for path in (*kept, *beside))
    assert len(list(folder.glob(f"1*{OUTCOME}"))) == KEPT


def test_closed_journals_are_kept_and_take_no_room(folder, close, monkeypatch):
    monkeypatch.setattr(store, "KEPT_JOBS", 1)
    close(folder / "b.journal")
    for name in ("a", "9"):
        (folder / f"{name}.journal").touch()
    for path in folder.iterdir():
        os.utime(path, (0, 0))
    store.prune(folder)
    assert sorted(path.name for path in folder.iterdir()) == ["a.journal", "b.journal"]
    assert list(store.replays(folder)) == []


def test_a_closed_file_of_a_position_stays_and_is_told(folder, close):
    PositionTrustFile.of_port(folder, "COM3").keep(LOST)
    (path,) = folder.iterdir()
    close(path)
    told: list[str] = []
    assert PositionTrustFile.of_port(folder, "COM4").trust.position_known is None
    for trust in (LOST._replace(counts_from_here=True), AT_HOME):
        file = PositionTrustFile.of_port(folder, "COM3")
        assert file.trust == LOST
        file.save_or_warn(trust, lambda kind, text: told.append(text))
    assert list(folder.iterdir()) == [path]
    assert len(told) == 1 and str(path) in told[0] and f"remove it as {path.owner()}" in told[0]


# --- a real user -----------------------------------------------------------------------------------


def as_nobody(*words: str) -> subprocess.CompletedProcess[str]:
    """Run Python as another user."""
    command = [sys.executable, *words]
    return subprocess.run(command, user=NOBODY, group=NOBODY, extra_groups=[], capture_output=True, text=True)


def is_open_to_others() -> bool:
    """Return whether another user may run this Python and read these sources."""
    try:
        return as_nobody("-c", "import sys; open(sys.argv[1]).close()", process_file.__file__).returncode == 0
    except PermissionError:
        return False


@pytest.mark.slow
@pytest.mark.skipif(os.geteuid() != 0, reason="takes the administrator, to act as another user")
@pytest.mark.parametrize("lives", [True, False], ids=["lives", "has ended"])
def test_another_user_does_not_stumble_over_the_administrators_file(tmp_path_factory, locked, lives):
    import tempfile

    if not is_open_to_others():
        pytest.skip("this checkout is closed to other users")
    with tempfile.TemporaryDirectory() as name:
        path = Path(name) / f"a{SESSION}"
        path.touch(0o600)
        os.chown(name, NOBODY, NOBODY)
        if lives:
            locked(path)
        said = as_nobody("-c", LOOK, str(path))
        assert said.stdout.split() == ["True", str(lives), "True", "None"], said.stderr
