# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper home`: the machine finds its own zero."""

from __future__ import annotations

import click

from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.machine.service_client import ServiceClient, ServicePort, place, port_options


@click.command("home", cls=Verb)
@port_options
def command(at: ServicePort) -> None:
    """Let the machine at --port find its own zero with its limit switches ($H), and wait until it has.

    The axes move to their switches: make sure that the path is free. Ctrl-C stops them; the position is unknown then.
    Many boards restart when their port is opened anew and forget what they have found: the connection stays open for
    the verbs that follow, --keep-open minutes long or until `cncstepper disconnect`.
    """
    with ServiceClient(at) as talk:
        try:
            talk.home()
        except KeyboardInterrupt:
            talk.client.stop()
            talk.until(lambda event: talk.status.phase not in ("homing", "busy"))
            raise
        click.echo(place(talk.status))
