# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper disconnect`: closes a connection that verbs before have left open."""

from __future__ import annotations

import time
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import LinkError, Text

if TYPE_CHECKING:
    from CNCStepper.control.service.connection_session import ConnectionSession

LOOK_EVERY_S = 0.02
END_LIMIT_S = 30.0  # of a board that is being connected
CLOSE_LIMIT_S = 5.0


@click.command("disconnect", cls=Verb)
@click.option("--port", help="Whose connection; without it every connection of yours.")
def command(port: str | None) -> None:
    """Close the connection to a controller that home, zero, jog, console, send or restart have left open.

    A connection that a window has open is closed too. It is refused while a job runs or something moves there. When
    the port is opened again many boards restart and forget where they stand.
    """
    from CNCStepper.control.session.files import running_services, service_at

    files = [file for file in [service_at(port)] if file] if port else running_services()
    for file in files:
        show_text("{file} is disconnected", file=_disconnect(file))
    if not files:
        none = Text("no connection to {port} is open", port=port) if port else Text("no connection is open")
        show_text(none, err=True)


def _disconnect(file: Path) -> str:
    """End the service of a file and return its port; raises MachineRefusal where it is at work."""
    from CNCStepper.control.service.connection_client import port_held_by_job
    from CNCStepper.control.service.connection_session import ConnectionSession

    with ConnectionSession.attach(file) as session:
        status = session.status()
        if status.total:
            raise port_held_by_job(file, session.port, status)
        session.ask("disconnect")
        with suppress(LinkError):  # it has ended
            _await_end(session)
        _await_process(file, session.port)
        return session.port


def _await_end(session: ConnectionSession) -> None:
    """Wait until the service closes the conversation; raises why it refuses to end, LinkError once it is gone."""
    end_s = time.monotonic() + END_LIMIT_S
    while time.monotonic() < end_s:
        for event in session.poll(LOOK_EVERY_S):
            if event["event"] == "refused" and event.get("command") == "disconnect":
                raise event["error"]


def _await_process(file: Path, port: str) -> None:
    """Wait until the process has closed its port; raises LinkError where it does not."""
    from CNCStepper.control.processes.process_file import is_alive

    end_s = time.monotonic() + CLOSE_LIMIT_S
    while is_alive(file):
        if time.monotonic() > end_s:
            raise LinkError("service-stays", "the connection does not end", value=port, advice="try again")
        time.sleep(LOOK_EVERY_S)
