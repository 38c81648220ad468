# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who of this user has a machine's port already: a job that runs or stands, or a desk (a window, a console).

A second opening would get nothing from a serial port, and from a network port a connection that breaks at once: both
look as if the cable were at fault.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from CNCStepper.control.processes.process_file import is_alive
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import closed_files, desk_near, session_near
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.control.session.unreachable import closed
from CNCStepper.errors import LinkError, MachineRefusal


def check_free(port: str, folder: Path | None = None) -> None:
    """Raise MachineRefusal where a job or a desk of this user has the port."""
    check_no_job(port, folder)
    if desk := desk_near(port, folder):
        _check_desk(desk, port)


def tell_closed(tell: Callable[[str], None], folder: Path | None = None) -> None:
    """Tell of each session that lives and cannot be read: it may have the port that is opened now, and keeps none."""
    for path in filter(is_alive, closed_files(folder)):
        tell(str(closed(path)))


def check_no_job(port: str, folder: Path | None = None) -> None:
    """Raise MachineRefusal where a job that was sent from a command line has the port; a killed one has it no more."""
    if session := session_near(port, folder):
        try:
            with SessionClient.attach(session) as client:
                status = client.status() if client.outcome is None else None
        except LinkError as error:  # it was killed, and its journal tells of it, or it does not answer
            _check_over(session, port, error)
            return
        if status:
            raise _held_by_job(session, port, status)


def _check_desk(desk: Path, port: str) -> None:
    from CNCStepper.control.service.connection_session import (
        DeskSession,  # whose desks ask `check_no_job` before they are launched
    )

    try:
        with DeskSession.attach(desk) as client:
            status = client.status()
    except LinkError as error:  # it has ended meanwhile, or it does not answer
        _check_over(desk, port, error)
        return
    if status.total:
        raise _held_by_job(desk, port, status)
    raise MachineRefusal(
        "port-held",
        f"{port} is held by a window or a console of yours",
        advice="disconnect there first, or send the job from there",
    )


def _check_over(file: Path, port: str, error: LinkError) -> None:
    """Raise MachineRefusal where the process that could not be reached lives: then it has the port."""
    if is_alive(file):
        what = f"{port} is held by a process of yours that does not answer"
        raise MachineRefusal("port-held", what, advice=error.advice) from error


def _held_by_job(file: Path, port: str, status: SenderStatus) -> MachineRefusal:
    return MachineRefusal(
        "port-held",
        f"{port} is held by a job of yours, {status.file or 'a program'}, which is {status.phase}",
        advice=f"go on with it or stop it where it was started, or with: cncstepper back --session {file.stem}",
    )
