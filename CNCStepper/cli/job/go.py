# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper go`: resumes a paused or held job from any terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job.running_job import follow, session_file, session_option
from CNCStepper.errors import MachineRefusal, Text

if TYPE_CHECKING:
    from CNCStepper.control.service.connection_session import ConnectionSession
    from CNCStepper.control.session.client import SessionClient
    from CNCStepper.control.session.status import SenderStatus


@click.command("go", cls=Verb)
@click.option(
    "--pause", "from_pause", is_flag=True, help="Resume also at a pause of the program (M0), once its task is done."
)
@session_option
def command(from_pause: bool, session: str | None) -> None:
    """Resume a paused job: after a hold, a closed door, or a retract along its cut.

    At a pause of the program (M0) it prints the reason, for example a tool change, and moves nothing. Do what it asks,
    then give --pause. The job was sent by `cncstepper send` from any terminal, also a closed one, or from FreeCAD's
    window. `cncstepper hold` holds it, `cncstepper stop` ends it.
    """
    from CNCStepper.control.service.connection_session import attach
    from CNCStepper.control.session.job_phase import Phase

    with attach(session_file(session)) as client:
        status = client.status()
        _check(status, from_pause)
        if status.phase == Phase.RETREATED:
            _from_cut(client)
        else:
            _from_pause(client, status)
    show_text("the job goes on")


def _check(status: SenderStatus, from_pause: bool) -> None:
    """Refuse a pause whose reason the operator must read first; raises MachineRefusal."""
    from CNCStepper.cli.job.pause_prompt import why
    from CNCStepper.control.session.job_phase import WAITING, Phase

    if status.phase not in WAITING:
        raise MachineRefusal("not-held", "the job is not held", value=status.phase, advice="there is nothing to do")
    if status.phase == Phase.PAUSED and not from_pause:
        advice = "see to that, then `cncstepper go --pause`"
        raise MachineRefusal("program-pause", Text("the program pauses: {why}", why=why(status)), advice=advice)
    if status.phase == "door" and status.machine_state != "Door:0":
        raise MachineRefusal(
            "door-open", "the safety door is open", value=status.machine_state, advice="close it first"
        )


def _from_pause(client: SessionClient | ConnectionSession, stood: SenderStatus) -> None:
    from CNCStepper.control.session.job_phase import WAITING

    client.ask("resume", stand=stood.stand)
    follow(client, stood, lambda now: now.stand != stood.stand or now.phase not in WAITING, "resume")


def _from_cut(client: SessionClient | ConnectionSession) -> None:
    """Cut from where the tool was retracted to, as `cncstepper back --resume` does."""
    from CNCStepper.recovery.retract.retract_client import RetractClient

    back = RetractClient(client)
    back.go(back.held().rest())
