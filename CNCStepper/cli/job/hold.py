# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper hold`: holds a job that runs, from any terminal."""

from __future__ import annotations

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job.running_job import follow, session_file, session_option
from CNCStepper.errors import Text


@click.command("hold", cls=Verb)
@session_option
def command(session: str | None) -> None:
    """Hold the running job: the machine slows down and stops, no position is lost, the spindle keeps turning.

    The job is one that `cncstepper send` sent from any terminal, also one that is closed by now, or that was sent from
    FreeCAD's window. `cncstepper go` lets it go on, `cncstepper back` leads it back along its cut, `cncstepper stop`
    ends it. This is not an emergency stop. The mini-lathe cannot be held over its link.
    """
    from CNCStepper.cli.job.pause_prompt import why
    from CNCStepper.control.service.connection_session import attach
    from CNCStepper.control.session.job_phase import WAITING

    with attach(session_file(session)) as client:
        before = client.status()  # asked first: a refusal that came with it would be lost
        client.hold()
        status = follow(client, before, lambda status: status.phase in WAITING, "hold")
        if client.outcome:
            raise click.ClickException(Text("the job has ended: {text}", text=client.outcome.text))
        show_text(
            "{phase}: {status}, at line {file_line}", phase=status.phase, status=why(status), file_line=status.file_line
        )
