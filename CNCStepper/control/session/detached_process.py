# SPDX-License-Identifier: LGPL-2.1-or-later
"""A process of our own: started apart from its parent, known by its session file, ended politely."""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

from CNCStepper.control.processes.python_finder import command, environment
from CNCStepper.control.session.files import LOG
from CNCStepper.errors import LinkError, Text


def start(python: str, module: str, session_file: Path, *arguments: str) -> subprocess.Popen:
    """Start `module` of ours as a process of its own: no signal of our terminal reaches it, its errors go to a log.

    Raises LinkError when that Python cannot be started.
    """
    apart: dict[str, Any] = {"start_new_session": True}
    if os.name == "nt":
        flags = ("DETACHED_PROCESS", "CREATE_NEW_PROCESS_GROUP")
        apart = {"creationflags": sum(getattr(subprocess, flag) for flag in flags)}
    log = os.open(session_file.with_suffix(LOG), os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    try:
        return subprocess.Popen(
            command(python, module, str(session_file), *arguments),
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=log,
            env=environment(),
            **apart,
        )
    except OSError as error:
        raise LinkError(
            "sender-start",
            Text("{python} cannot be started: {error}", python=python, error=error),
            advice="choose another",
        ) from error
    finally:
        os.close(log)


def stop_on_signals(stop: Callable[[], None]) -> None:
    """Let every polite signal end the work safely; a closed terminal is no reason to end it."""
    for name in ("SIGTERM", "SIGINT", "SIGBREAK"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), lambda *_: stop())
    if hasattr(signal, "SIGHUP"):
        signal.signal(signal.SIGHUP, signal.SIG_IGN)
