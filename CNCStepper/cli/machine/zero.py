# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper zero`: the place of the tool becomes the work zero."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.machine.service_client import ServiceClient, ServicePort, place, port_options


@click.command("zero", cls=Verb)
@click.argument("axes", default="XYZ")
@port_options
def command(axes: str, at: ServicePort) -> None:
    """Make the tool's position the work zero of AXES: XYZ where none are given, or Z, or XY.

    It is stored in the work system in force (G54 as a rule) of the controller at --port, and read back. The machine
    must be idle; nothing moves. The connection stays open for the verbs that follow, --keep-open minutes long or until
    `cncstepper disconnect`, so that a board that restarts when its port is opened keeps its zero till then.

    Also while `cncstepper send` pauses at that port, at an M0 or a change of tools: what follows moves with the zero.
    """
    from CNCStepper.control.service.connection_session import job_at

    if session := job_at(at.name):
        _zero_job(session, axes)
        return
    with ServiceClient(at) as talk:
        talk.set_zero(axes)
        click.echo(place(talk.status))


def _zero_job(session: Path, axes: str) -> None:
    """Set the zero of a job that is paused between two lines."""
    from CNCStepper.control.service.connection_session import attach
    from CNCStepper.recovery.retract.retract_client import set_zero

    with attach(session) as client:
        click.echo(place(set_zero(client, axes)))
