# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper stop`: ends a job that runs, from any terminal."""

from __future__ import annotations

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job.running_job import follow, session_file, session_option


@click.command("stop", cls=Verb)
@session_option
def command(session: str | None) -> None:
    """End the job that runs: hold, standstill, reset; spindle, torch, laser and coolant off, the position kept.

    The rest of the job is not cut. The job is one that `cncstepper send` sent from any terminal, also one that is
    closed by now, or that was sent from FreeCAD's window. `cncstepper hold` only holds it. This is not an emergency
    stop: that one is on the machine.

    The mini-lathe cannot be stopped over its link while it runs what it was sent: nothing more is sent to it, and the
    outcome says how long it still works. A parallel port or USB board brakes and stops.
    """
    from CNCStepper.control.service.connection_session import attach

    with attach(session_file(session)) as client:
        before = client.status()  # asked first: a refusal that came with it would be lost
        client.stop()
        follow(client, before, lambda status: False, "stop")
        if client.outcome:
            show_text(client.outcome.text)
