# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a session, readable by their owner only: how to reach it, how it ended, what it logged.

NAME.session   address, token and process, locked while it runs     NAME.outcome   afterwards       NAME.log
NAME.service   the same of a connection service                     NAME.sock      where it listens
NAME.wire      the job, while it runs; of a service, its last one

Nobody but its own process removes what belongs to a living one; whether it lives says its lock (`own_file`). A file
that this user may not open keeps no port here and is never removed; `closed_files` has those, to be told of.
"""

from __future__ import annotations

import json
import os
import secrets
import stat
import time
from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, TextIO

from CNCStepper.control.processes.process_file import LOOK_EVERY_S, ProcessFile, is_alive, is_closed
from CNCStepper.control.session.local_socket import is_abandoned, make_private, socket_paths
from CNCStepper.control.transport.port_identity import PortIdentity, identify, read_identity
from CNCStepper.errors import JobError, LinkError, Text, missing_package

KEPT = 20  # sessions whose outcome and log are kept
RECENT_S = 600.0  # younger files are kept in any case: a client may be about to read them
SESSION, SERVICE, OUTCOME, LOG, WIRE = ".session", ".service", ".outcome", ".log", ".wire"
LARGEST_BYTES = 10_000_000  # of a file of `write_private` that is read whole
MEND_LIMIT_S = 3 * LOOK_EVERY_S  # within which a living process has mended its file
_Compare = Callable[[PortIdentity, PortIdentity], bool]


def session_folder() -> Path:
    """Return the user's folder of sessions, made when it is not there, and closed to other users.

    Raises MissingPackage without platformdirs, JobError for a folder that cannot be used.
    """
    try:
        from platformdirs import user_state_path
    except ImportError as error:
        raise missing_package("platformdirs") from error
    folder = user_state_path("cncstepper", appauthor=False) / "sessions"
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        make_private(folder)
    except OSError as error:
        raise JobError(
            "session-folder",
            Text("the folder of sessions cannot be used: {error}", error=error.strerror or error),
            value=str(folder),
            advice="see that it is a folder, that it is yours, and that you may write there",
        ) from error
    return folder


def new_session(folder: Path | None = None, kind: str = SESSION) -> Path:
    """Return the path for a new session or service file, and remove stale ones; names sort by their time, in us."""
    folder = folder or session_folder()
    _prune(folder)
    seconds, rest_ns = divmod(time.time_ns(), 1_000_000_000)
    begun = time.strftime("%Y%m%d-%H%M%S", time.localtime(seconds))
    return folder / f"{begun}-{rest_ns // 1000:06d}-{secrets.token_hex(4)}{kind}"


def sessions(folder: Path | None = None) -> list[Path]:
    """Return the files of the sessions that run, oldest first."""
    return _alive(folder, SESSION)


def session_at(machine_port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the session that has this port; None where none has."""
    return _having(machine_port, sessions(folder))


def session_near(machine_port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the session that has this port, or one at a host that shares an address with its host."""
    return _having(machine_port, sessions(folder), PortIdentity.is_near)


def running_services(folder: Path | None = None) -> list[Path]:
    """Return the files of the running connection services, oldest first."""
    return _alive(folder, SERVICE)


def service_at(machine_port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the connection service at this port; None where there is none."""
    return _having(machine_port, running_services(folder))


def closed_files(folder: Path | None = None) -> list[Path]:
    """Return the session and service files that this user cannot open: their ports are unknown."""
    folder = folder or session_folder()
    return sorted(path for kind in (SESSION, SERVICE) for path in folder.glob(f"*{kind}") if is_closed(path))


def service_near(machine_port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the service at this port, or of one at a host that shares an address with its host."""
    return _having(machine_port, running_services(folder), PortIdentity.is_near)


class ServiceFile(ProcessFile):
    """The file of a connection service, owned by its process."""

    def previous_service(self, machine_port: str) -> Path | None:
        """Return the file of a service that was before this one at the same port, as far as that can be known."""
        for path in running_services(self._path.parent):
            if path.name < self._path.name and _having(machine_port, [path], PortIdentity.is_near):
                return path
        return None


def write_private(path: Path, content: Mapping[str, Any]) -> None:
    """Write JSON that only its owner can read; a reader finds it whole or not at all."""
    draft = _draft_of(path)
    with _new_private(draft) as file:
        json.dump(content, file)
    os.replace(draft, path)


def write_durably(path: Path, content: Mapping[str, Any]) -> None:
    """Write as `write_private` does; when this returns it is on the disk, and after an OSError all is as before."""
    draft = _draft_of(path)
    try:
        with _new_private(draft) as file:
            json.dump(content, file)
            file.flush()
            os.fsync(file.fileno())
        os.replace(draft, path)
        sync_folder(path.parent)
    except OSError:
        draft.unlink(missing_ok=True)
        raise


def sync_folder(folder: Path) -> None:
    """Put the names of new files on the disk too, where the system lets a folder be opened."""
    if os.name != "posix":
        return
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def read_private(path: Path) -> dict[str, Any] | None:
    """Return the JSON of `write_private`, or None without such a file; never waits at a pipe or device.

    Raises ValueError, with words, for what `write_private` has not written, OSError when it cannot be read.
    """
    try:
        text = _read_regular(path)
    except FileNotFoundError:
        return None
    try:
        content = json.loads(text)
    except RecursionError as error:
        raise ValueError("nested too deeply") from error
    if not isinstance(content, dict):
        raise ValueError("not an object of JSON")
    return content


def _read_regular(path: Path) -> bytes:
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0))
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise ValueError("not a file")
        with open(descriptor, "rb", closefd=False) as file:
            text = file.read(LARGEST_BYTES + 1)
    finally:
        os.close(descriptor)
    if len(text) > LARGEST_BYTES:
        raise ValueError(Text("larger than {largest_bytes} MB", largest_bytes=LARGEST_BYTES // 1000000))
    return text


def _alive(folder: Path | None, kind: str) -> list[Path]:
    files = (folder or session_folder()).glob(f"*{kind}")
    return sorted(path for path in files if is_alive(path) and not is_closed(path))


def _having(machine_port: str, files: Iterable[Path], is_meant: _Compare = PortIdentity.is_same) -> Path | None:
    return next((path for path in files if _is_at(machine_port, _address_in(path), is_meant)), None)


def _is_at(machine_port: str, content: Mapping[str, Any], is_meant: _Compare) -> bool:
    """Return whether a session's or service's port is this one, whatever it is called."""
    port = str(content.get("machine_port", ""))
    return port == machine_port or (port != "" and is_meant(read_identity(content, port), identify(machine_port)))


def _address_in(path: Path) -> Mapping[str, Any]:
    """Return the content of the file of a running session or service, None where it has ended.

    Raises LinkError where its process lives and does not mend its file.
    """
    end_s = time.monotonic() + MEND_LIMIT_S
    while True:
        try:
            content = read_private(path) or {}
            return {**content, "machine_port": str(content["machine_port"])}
        except (OSError, ValueError, KeyError) as error:
            if not is_alive(path) or is_closed(path):
                return {}
            if time.monotonic() > end_s:
                raise LinkError(
                    "session-damaged",
                    Text(
                        "a process of ours has a machine's port, but its file {path} cannot be read: {error}",
                        path=path.name,
                        error=error,
                    ),
                    advice="look which machine moves, and stop it there",
                ) from error
        time.sleep(MEND_LIMIT_S / 100)


def _draft_of(path: Path) -> Path:
    return path.with_name(f"{path.name}.{secrets.token_hex(4)}")


def _new_private(path: Path) -> TextIO:
    return open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="utf-8")


def _prune(folder: Path) -> None:
    """Remove what sessions have left that do not live any more: all that none needs, of the rest the oldest."""
    for path in _ours(folder, SESSION, SERVICE):
        if not is_alive(path):
            _remove(path, *filter(is_abandoned, socket_paths(path)))
    needed = {path.stem for path in (*sessions(folder), *running_services(folder), *closed_files(folder))}
    for kind in (OUTCOME, LOG, WIRE):
        for old in _ours(folder, kind)[:-KEPT]:
            if old.stem not in needed and not _is_recent(old):
                _remove(old)


def _ours(folder: Path, *kinds: str) -> list[Path]:
    """Return the files of some kinds by name, without those that this user may not open."""
    return sorted(path for kind in kinds for path in folder.glob(f"*{kind}") if not is_closed(path))


def _remove(*paths: Path) -> None:
    for path in paths:
        with suppress(OSError):  # another program prunes too
            path.unlink()


def _is_recent(path: Path) -> bool:
    """Return whether a file is young, whichever way the clock was changed since it was written."""
    try:
        return abs(time.time() - path.stat().st_mtime) < RECENT_S
    except OSError:
        return False
