# SPDX-License-Identifier: LGPL-2.1-or-later
"""The journals of a user, NAME.journal beside the session files, and which of them are kept."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from CNCStepper.control.journal.replay import RUNNING, JobReplay, read_replay
from CNCStepper.control.processes.file_lock import is_locked
from CNCStepper.control.processes.process_file import is_closed
from CNCStepper.control.session.files import session_folder
from CNCStepper.control.transport.port_identity import THIS_COMPUTER, PortIdentity, identify, read_identity
from CNCStepper.errors import CNCStepperError

JOURNAL = ".journal"
PROFILE = ".profile.json"  # a copy of the machine's profile, for the restart that `resume` offers
KEPT_JOBS = 50
KEPT_BYTES = 50_000_000
RECENT_S = 30 * 86_400.0  # an unfinished job is kept so long in any case


def journals(folder: Path | None = None) -> list[Path]:
    """Return the journals, the latest first."""
    return sorted((folder or session_folder()).glob(f"*{JOURNAL}"), reverse=True)


def latest_unfinished(folder: Path | None = None) -> JobReplay | None:
    """Return the latest job that runs, was killed or ended before its time; None when all were cut to their end."""
    return next((story for story in replays(folder) if not story.is_done), None)


def unfinished_at(port: str, folder: Path | None = None) -> JobReplay | None:
    """Return the last job of the machine at a port where it was killed or ended before its time, else None."""
    identity = identify(port)
    for story in replays(folder):
        unfinished = not story.is_done and story.end != RUNNING
        if _is_of(story.header, port, identity):
            return story if unfinished else None
        if unfinished and identity.is_near(read_identity(story.header, story.header["port"])):
            return story
    return None


def _is_of(header: Mapping[str, Any], port: str, identity: PortIdentity) -> bool:
    """Return whether a job's machine was that of a port, as far as can be known.

    On this computer only virtual machines listen, each start at another number.
    """
    other = read_identity(header, header["port"])
    virtual = THIS_COMPUTER in identity.names and THIS_COMPUTER in other.names
    return header["port"] == port or virtual or identity.is_same(other)


def replays(folder: Path | None = None) -> Iterator[JobReplay]:
    """Yield the replay of each journal, the latest first; unreadable ones are left out."""
    for path in journals(folder):
        with suppress(CNCStepperError):  # `resume JOURNAL` reports its error
            yield read_replay(path)


def prune(folder: Path, now_s: float | None = None) -> None:
    """Remove the oldest journals beyond KEPT_JOBS and KEPT_BYTES, but none that is unfinished and recent."""
    now_s = time.time() if now_s is None else now_s
    kept_bytes = 0
    ours = (path for path in journals(folder) if not is_closed(path))  # another user's take no room from these
    for count, path in enumerate(ours, 1):
        with suppress(OSError):  # another program prunes too
            kept_bytes += path.stat().st_size
            if (count > KEPT_JOBS or kept_bytes > KEPT_BYTES) and not _is_needed(path, now_s):
                path.unlink()
                path.with_suffix(PROFILE).unlink(missing_ok=True)


def _is_needed(path: Path, now_s: float) -> bool:
    if is_locked(path):  # its job runs; the clock may be wrong
        return True
    if abs(now_s - path.stat().st_mtime) > RECENT_S:
        return False
    try:
        return not read_replay(path).is_done
    except CNCStepperError:
        return False  # nobody can read it
