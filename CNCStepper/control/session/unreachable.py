# SPDX-License-Identifier: LGPL-2.1-or-later
"""Errors of a client without a session or service: ended, killed, closed, or silent."""

from __future__ import annotations

import os
from pathlib import Path

from CNCStepper.control.processes.process_file import is_alive, owner
from CNCStepper.control.session.files import LOG, SERVICE, read_private
from CNCStepper.control.session.local_socket import Address
from CNCStepper.errors import LinkError, Text
from CNCStepper.safe_text import printable

SILENT, GARBLED, CLOSED = "session-silent", "session-garbled", "session-closed"
AT_THE_MACHINE = "stop the machine with its own buttons if it must stop now"
NO_SIGNAL = "to end its process would not stop the machine"


def silent(session_file: Path, why: str = "") -> LinkError:
    """Return the error for a process that lives and does not answer; why: the last try's error."""
    return LinkError(SILENT, _silence(session_file), value=printable(why), advice="; ".join(_what_to_do(session_file)))


def lost(session_file: Path) -> LinkError:
    """Return the error for a session that left no word of its end."""
    return LinkError(
        "session-lost",
        Text("the session {session_file} is not there, or was killed", session_file=session_file.stem),
        advice=_unknown(session_file),
    )


def unreadable(session_file: Path, why: str) -> LinkError:
    """Return the error for a session that has ended, and of which the outcome cannot be read."""
    return LinkError(
        "session-end",
        Text(
            "the session {session_file} has ended, and its outcome cannot be read: {why}",
            session_file=session_file.stem,
            why=printable(why),
        ),
        advice=_unknown(session_file),
    )


def garbled(session_file: Path) -> LinkError:
    """Return the error for a session of which this program does not understand the answers."""
    return LinkError(
        GARBLED,
        Text(
            "this program does not understand the answers of the session {session_file}", session_file=session_file.stem
        ),
        advice="; ".join(("use the version of CNCStepper that started it", *_what_to_do(session_file))),
    )


def closed(session_file: Path) -> LinkError:
    """Return the error for a session whose file this user may not open: it may have any port, or none any more."""
    user = owner(session_file)
    if is_alive(session_file):
        advice = Text("end that session as {user}, or remove the file as {user} where none runs any more", user=user)
    else:
        advice = Text("no process has it any more: remove the file as {user}", user=user)
    return LinkError(
        CLOSED,
        Text("a session's file belongs to {user} and cannot be opened, so that its port is unknown", user=user),
        value=str(session_file),
        advice=advice,
    )


def _silence(session_file: Path) -> str:
    if session_file.suffix == SERVICE:
        return Text(
            "the connection {session_file} is open, but its process does not answer", session_file=session_file.stem
        )
    return Text("the session {session_file} runs, but its process does not answer", session_file=session_file.stem)


def _what_to_do(session_file: Path) -> list[str]:
    """Return advice; no signal lets a process stop its machine on Windows."""
    process, log = _process(session_file), session_file.with_suffix(LOG)
    if os.name == "nt":
        signal = NO_SIGNAL
    elif process:
        signal = Text("`kill {process}` (SIGTERM) lets its process stop the machine safely", process=process)
    else:
        signal = "SIGTERM lets its process stop the machine safely"
    return [AT_THE_MACHINE, signal, f"see {log}"]


def _unknown(session_file: Path) -> str:
    return Text(
        "if it was cutting, the position is unknown: look at the machine, then see {session_file}",
        session_file=session_file.with_suffix(LOG),
    )


def _process(session_file: Path) -> int:
    """Return the number of the process of a session, 0 where its file does not say."""
    try:
        return Address.of(read_private(session_file) or {}).process
    except (OSError, ValueError):
        return 0
