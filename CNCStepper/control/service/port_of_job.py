# SPDX-License-Identifier: LGPL-2.1-or-later
"""Finds the job of a command line that holds a machine's port, before a connection service is launched."""

from __future__ import annotations

from pathlib import Path

from CNCStepper.control.processes.process_file import is_alive
from CNCStepper.control.session.client import SessionClient
from CNCStepper.control.session.files import session_near
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import LinkError, MachineRefusal, Text


def check_no_job(port: str, folder: Path | None = None) -> None:
    """Raise MachineRefusal where a job that was sent from a command line has the port; a killed one has it no more."""
    if session := session_near(port, folder):
        try:
            with SessionClient.attach(session) as client:
                status = client.status() if client.outcome is None else None
        except LinkError as error:  # it was killed, and its journal tells of it, or it does not answer
            check_over(session, port, error)
            return
        if status:
            raise port_held_by_job(session, port, status)


def check_over(file: Path, port: str, error: LinkError) -> None:
    """Raise MachineRefusal where the process that could not be reached lives: then it has the port."""
    if is_alive(file):
        what = Text("{port} is held by a process of yours that does not answer", port=port)
        raise MachineRefusal("port-held", what, advice=error.advice) from error


def port_held_by_job(file: Path, port: str, status: SenderStatus) -> MachineRefusal:
    """Return the refusal for a port that a job holds, from the file of its session or service."""
    return MachineRefusal(
        "port-held",
        Text(
            "{port} is held by a job of yours, {status_file}, which is {phase}",
            port=port,
            status_file=status.file or "a program",
            phase=status.phase,
        ),
        advice=Text(
            "go on with it or stop it where it was started, or with: cncstepper back --session {file}", file=file.stem
        ),
    )
