# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper zero`: the place of the tool becomes the work zero."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.machine.service_client import ServiceClient, place, port_options


@click.command("zero", cls=Verb)
@click.argument("axes", default="XYZ")
@port_options
def command(axes: str, port: str, baud: int) -> None:
    """Make the place where the tool stands the work zero of AXES: XYZ where none are given, or Z, or XY.

    It is stored in the work system in force (G54 as a rule) of the controller at --port, and read back. The machine
    must be idle; nothing moves. Where the board restarts when its port is opened, this is the last thing to do before
    `cncstepper send`: nothing may move the tool in between.

    Also while `cncstepper send` pauses at that port, at an M0 or a change of tools: what follows moves with the zero.
    """
    from CNCStepper.control.session.files import session_at

    if session := session_at(port):
        _zero_job(session, axes)
        return
    with ServiceClient(port, baud) as talk:
        talk.set_zero(axes)
        click.echo(place(talk.status))


def _zero_job(session: Path, axes: str) -> None:
    """Set the zero of a job that is paused between two lines."""
    from CNCStepper.control.session.client import SessionClient
    from CNCStepper.recovery.retract.client import set_zero

    with SessionClient.attach(session) as client:
        click.echo(place(set_zero(client, axes)))
