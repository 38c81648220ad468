# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper jog`: moves axes by hand."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.options import NumberType
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.machine.service_client import ServiceClient, ServicePort, place, port_options
from CNCStepper.errors import Text
from CNCStepper.word_pattern import WORD

AXES = "XYZ"
FEED_MM_MIN = 1000.0


@click.command("jog", cls=Verb)
@click.argument("way", nargs=-1, required=True)
@click.option("--feed", type=NumberType(kind="feed"), default=FEED_MM_MIN, show_default=True, help="Speed in mm/min.")
@port_options
def command(way: tuple[str, ...], feed: float, at: ServicePort) -> None:
    """Move the axes of the machine at --port by WAY, in mm: X10, or X-2.5 Y3 together.

    A jog ($J) leaves the program's modes unchanged. Ctrl-C cancels it and keeps the position. The position need not be
    known. The controller refuses a jog beyond its travel if soft limits are on ($20=1).

    It also works while `cncstepper send` holds its job at that port. The controller is then reset at standstill, which
    stops the spindle. `cncstepper back --resume` goes on: up, across and slowly down to the cut, and along it. At a
    pause, or during a tool change (M6 of grblHAL), nothing is reset, and the tool returns before the job resumes.
    """
    from CNCStepper.control.service.connection_session import job_at

    axes_mm = _axes_mm(way)
    if session := job_at(at.name):
        _jog_job(session, axes_mm, feed)
        return
    with ServiceClient(at) as talk:
        jog(talk, jog_line(way, feed))
        click.echo(place(talk.status))


def jog_line(way: tuple[str, ...], feed_mm_min: float) -> str:
    """Return the jog command for words as "X10" and "Y-2.5"; raises a usage error for what is no way."""
    moves = "".join(f"{axis}{value:.4f}" for axis, value in _axes_mm(way).items())
    return f"$J=G91G21{moves}F{feed_mm_min:.1f}"


def _axes_mm(way: tuple[str, ...]) -> dict[str, float]:
    words = [WORD.fullmatch(part) for part in way]
    axes_mm = {word[1].upper(): float(word[2]) for word in words if word}
    if len(axes_mm) < len(way) or set(axes_mm) - set(AXES):
        raise click.UsageError(Text("'{way}' is no way: write for example X10, or X-2.5 Y3 (mm)", way=" ".join(way)))
    return axes_mm


def _jog_job(session: Path, axes_mm: dict[str, float], feed_mm_min: float) -> None:
    """Jog the machine of a job that is held; Ctrl-C brakes."""
    from CNCStepper.control.service.connection_session import attach
    from CNCStepper.recovery.retract.retract_client import jog, step_aside

    way = {f"{axis.lower()}_mm": axes_mm.get(axis, 0.0) for axis in AXES} | {"feed_mm_min": feed_mm_min}
    with attach(session) as client:
        step_aside(client)
        try:
            click.echo(place(jog(client, way)))
        except KeyboardInterrupt:
            client.ask("jog_cancel")
            raise


def jog(talk: ServiceClient, line: str) -> None:
    """Jog and wait until the machine is idle; raises a ClickException with the controller's words when it does not."""
    try:
        answer = talk.type(line)
    except KeyboardInterrupt:
        talk.client.jog_cancel()
        talk.until(lambda event: event["event"] == "answer")
        raise
    if answer != "ok":
        raise click.ClickException(answer)
