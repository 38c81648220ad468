# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shared parts of the verbs that act on a running job, sent from another terminal or from FreeCAD's window."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.control.session.status import SenderStatus
from CNCStepper.errors import JobError, Text, joined

if TYPE_CHECKING:
    from CNCStepper.control.service.connection_session import ConnectionSession
    from CNCStepper.control.session.client import SessionClient

LOOK_EVERY_S = 0.05

session_option = click.option("--session", help="Which job, by its session's name or file, where several run.")


def session_file(name: str | None) -> Path:
    """Return the file of the session or service meant; raises JobError where it is not clear which."""
    from CNCStepper.control.service.connection_session import jobs_running
    from CNCStepper.control.session.files import running_services, sessions

    if name and Path(name).suffix:
        return Path(name)
    running = [path for path in sessions() + running_services() if path.stem == name] if name else jobs_running()
    if len(running) == 1:
        return running[0]
    if not running:
        raise _none_runs(name)
    names = ", ".join(path.stem for path in running)
    raise JobError(
        "session-which", Text("{count} jobs run", count=len(running)), value=names, advice="choose one with --session"
    )


def _none_runs(name: str | None) -> JobError:
    """Return the refusal where no job is found, with the sessions that cannot be read: one of them may be meant."""
    from CNCStepper.control.session.files import closed_files
    from CNCStepper.control.session.unreachable import closed

    what = Text("no job '{name}' runs", name=name) if name else "no job runs"
    others = [closed(path).sentence for path in closed_files() if name in (None, path.stem)]
    return JobError("session-none", what, advice=joined("; ", [Text("start one with cncstepper send"), *others]))


def follow(
    client: SessionClient | ConnectionSession, status: SenderStatus, reached: Callable[[SenderStatus], bool], asked: str
) -> SenderStatus:
    """Wait until a status is reached or the job has ended, and return it; events meanwhile are printed.

    status: that of before. asked: the command whose refusal is raised.
    """
    while not reached(status) and client.outcome is None:
        for event in client.poll(LOOK_EVERY_S):
            if event["event"] == "refused" and event.get("command") == asked:
                raise event["error"]
            if event["event"] == "status":
                status = SenderStatus.from_json(event["status"])
            elif event["event"] in ("message", "warning"):
                show_text(event["text"], err=True)
    return client.outcome.status if client.outcome else status
