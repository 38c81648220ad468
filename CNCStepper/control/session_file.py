# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a session, readable by their owner only: how to reach it, how it ended, what it logged.

NAME.session   port, token and process, while it runs       NAME.outcome   afterwards       NAME.log
NAME.wire      the lines to send, while it runs; of a desk, those of its last job
NAME.desk      the same of a desk, touched every second     (one that nobody touches is a killed desk's)
"""

from __future__ import annotations

import json
import os
import secrets
import time
from collections.abc import Iterable, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any, TextIO

from CNCStepper.control.long_json import pieces
from CNCStepper.errors import MissingPackage

KEPT = 20  # sessions whose outcome and log are kept
SESSION, DESK, OUTCOME, LOG, WIRE = ".session", ".desk", ".outcome", ".log", ".wire"
FRESH_S, TOUCH_S = 10.0, 1.0


def session_folder() -> Path:
    """Return the user's folder of sessions, made when it is not there; raises MissingPackage without platformdirs."""
    try:
        from platformdirs import user_state_path
    except ImportError as error:
        raise MissingPackage(
            "platformdirs-missing",
            "platformdirs is not installed",
            advice="install it: python -m pip install platformdirs",
        ) from error
    folder = user_state_path("cncstepper", appauthor=False) / "sessions"
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    return folder


def new_session(folder: Path | None = None, kind: str = SESSION) -> Path:
    """Return the path for the file of a new session or desk, and remove what old ones left."""
    folder = folder or session_folder()
    _prune(folder)
    return folder / f"{time.strftime('%Y%m%d-%H%M%S')}-{secrets.token_hex(4)}{kind}"


def sessions(folder: Path | None = None) -> list[Path]:
    """Return the files of the sessions that run, oldest first; one may have been killed."""
    return sorted((folder or session_folder()).glob(f"*{SESSION}"))


def session_at(machine_port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the session that has this port; None where none has."""
    return _having(machine_port, sessions(folder))


def running_desks(folder: Path | None = None) -> list[Path]:
    """Return the files of the desks that run, oldest first."""
    return [path for path in sorted((folder or session_folder()).glob(f"*{DESK}")) if is_fresh(path)]


def desk_at(machine_port: str, folder: Path | None = None) -> Path | None:
    """Return the file of the desk that has this port; None where none has."""
    return _having(machine_port, running_desks(folder))


def is_fresh(path: Path) -> bool:
    """Return whether the desk of this file runs, to judge by when it last touched it."""
    try:
        return abs(time.time() - path.stat().st_mtime) < FRESH_S
    except OSError:
        return False


class DeskFile:
    """The file of a desk, in the hands of its own process."""

    def __init__(self, path: Path):
        self._path = path
        self._content: Mapping[str, Any] = {}
        self._touched_s = 0.0

    def write(self, content: Mapping[str, Any]) -> None:
        """Write it for the first time."""
        self._content = content
        self._touched_s = time.monotonic()
        write_private(self._path, content)

    def keep_fresh(self) -> None:
        """Touch it when that is due; one that was taken for a killed desk's and removed is written again."""
        if time.monotonic() - self._touched_s < TOUCH_S:
            return
        self._touched_s = time.monotonic()
        try:
            os.utime(self._path)
        except OSError:
            write_private(self._path, self._content)

    def elder(self, machine_port: str) -> Path | None:
        """Return the file of a desk that was before this one at the same port."""
        for path in running_desks(self._path.parent):
            if path.name < self._path.name and (read_private(path) or {}).get("machine_port") == machine_port:
                return path
        return None

    def remove(self) -> None:
        """Remove it: the desk has ended."""
        self._path.unlink(missing_ok=True)


def write_private(path: Path, content: Mapping[str, Any]) -> None:
    """Write JSON that only its owner can read, long lists as `pieces` does; a reader finds it whole or not at all."""
    draft = _draft_of(path)
    with _new_private(draft) as file:
        file.writelines(pieces(content, json.JSONEncoder()))
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
    """Return the JSON of `write_private`, or None when there is no such file."""
    try:
        return json.loads(path.read_text("utf-8"))
    except FileNotFoundError:
        return None


def _having(machine_port: str, files: Iterable[Path]) -> Path | None:
    return next((path for path in files if (read_private(path) or {}).get("machine_port") == machine_port), None)


def _draft_of(path: Path) -> Path:
    return path.with_name(f"{path.name}.{secrets.token_hex(4)}")


def _new_private(path: Path) -> TextIO:
    return open(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w", encoding="utf-8")


def _prune(folder: Path) -> None:
    for kind in (OUTCOME, LOG, WIRE):
        for old in sorted(folder.glob(f"*{kind}"))[:-KEPT]:
            with suppress(OSError):  # another program prunes too
                old.unlink()
    for killed in folder.glob(f"*{DESK}"):
        if not is_fresh(killed):
            with suppress(OSError):
                killed.unlink()
