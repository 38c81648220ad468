# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper back`: retracts the tool of a held job along its cut, moves it forward again, and resumes the job."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import machine_option
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job.running_job import session_file, session_option
from CNCStepper.errors import CNCStepperError, JobError, Text
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.control.service.connection_session import ConnectionSession
    from CNCStepper.control.session.client import SessionClient
    from CNCStepper.control.session.status import SenderStatus
    from CNCStepper.recovery.retract.path_retract import HeldProgram
    from CNCStepper.recovery.retract.places_on_path import Place
    from CNCStepper.recovery.retract.retract_client import RetractClient

QUESTION = "b MM | l LINE | e | f [MM] | r | s | q"
MEANINGS = Text("""\
b MM    back along the cut by MM millimetres      f [MM]  forward again, as far as it was cut at most
l LINE  back to where LINE of the program begins  r       resume: spindle on, cut from here to the end
e       back to the last entry into the work      s       stop the job        q  leave, the machine stands""")
OVER = Text("that was not done: the job has gone on meanwhile")
LENGTH = click.FloatRange(min=0, min_open=True)


@click.command("back", cls=Verb)
@click.option("--distance", "distance_mm", type=LENGTH, metavar="MM", help="Go back by this length along the cut.")
@click.option("--line", type=click.IntRange(min=1), metavar="N", help="Go back to where line N of the program begins.")
@click.option("--entry", is_flag=True, help="Go back to where the tool last began to go down into the work.")
@click.option(
    "--forward",
    "forward_mm",
    type=LENGTH,
    metavar="[MM]",
    is_flag=False,
    flag_value=math.inf,
    help="Go forward again: by MM, or without a number to where the cut ended.",
)
@click.option(
    "--resume", is_flag=True, help="Switch spindle or beam on again and cut from here to the end of the program."
)
@session_option
@machine_option(required=False)
def command(
    distance_mm: float | None,
    line: int | None,
    entry: bool,
    forward_mm: float | None,
    resume: bool,
    session: str | None,
    machine: Machine | None,
) -> None:
    """Retract along the cut of a running job, move forward again, and resume.

    The job is one that `cncstepper send` runs in another terminal, or that FreeCAD's window sent.

    A machine that still moves is held first. The tool then follows the program's path backwards, arcs and helices too.
    Every line is checked before the machine moves. Each move begins with a reset of the controller at standstill, which
    stops the spindle. The spindle starts again and reaches its speed before the tool moves. With [retreat] outputs =
    "off" in the machine profile it stays off, and so does every laser.

    \b
    cncstepper back --distance 5     hold, and 5 mm back
    cncstepper back --forward        forward again to where it was held
    cncstepper back --resume         go on with the job from where the tool stands now

    Without one of these options it asks what to do, until the job resumes or you leave.
    """
    requests = [distance_mm is not None, line is not None, entry, forward_mm is not None, resume]
    if sum(requests) > 1:
        raise click.UsageError(Text("give one of --distance, --line, --entry, --forward and --resume"))
    from CNCStepper.control.service.connection_session import attach
    from CNCStepper.control.session.job_phase import Phase
    from CNCStepper.recovery.retract.retract_client import RetractClient

    with attach(session_file(session)) as client:
        back = RetractClient(client, machine)
        if back.hold().phase != Phase.RETREATED or not any(requests):
            _show(back.hold(), back.held())
        if not any(requests):
            _Dialogue(back, client).run()
        elif resume:
            _resume(back)
        else:
            held = back.held()
            _go(back, held, _target(held, distance_mm, line, entry, forward_mm))


def _target(
    held: HeldProgram, distance_mm: float | None, line: int | None, entry: bool, forward_mm: float | None
) -> Place:
    """Return the place that is asked for, by one of these."""
    if distance_mm is not None:
        return held.back_by(distance_mm)
    if line is not None:
        return held.back_to_line(line)
    return held.back_to_entry() if entry else held.forward_by(forward_mm or math.inf)


def _go(back: RetractClient, held: HeldProgram, target: Place) -> None:
    """Go along the cut to a place, and print the tool's position there."""
    if held.doubt:
        show_text(held.doubt, err=True)
    back.go(held.along(target))
    _show(back.wait_for_leg(), back.held())


def _resume(back: RetractClient) -> None:
    back.go(back.held().rest())
    show_text("the job goes on from here")


def _show(status: SenderStatus, held: HeldProgram) -> None:
    """Print where the tool is: the line that moves there, and the work position."""
    place = " ".join(f"{axis}{value:.3f}" for axis, value in zip("XYZ", status.wpos_mm or (), strict=False))
    show_text("{phase}: line {line}  {place}", phase=status.phase, line=held.file_line(held.place), place=place)


class _Dialogue:
    """Prompts until the job resumes, or is left."""

    def __init__(self, back: RetractClient, client: SessionClient | ConnectionSession) -> None:
        self._back = back
        self._client = client

    def run(self) -> None:
        """Ask and execute the answer; after a refusal print it and ask again."""
        show_text(MEANINGS)
        while True:
            stand = self._client.status().stand
            answer = click.prompt(QUESTION, err=True).lower().split() or [""]
            try:
                if self._over(stand, answer[0]):
                    _show(self._client.status(), self._back.held())
                elif self._execute_command(*answer[:2]):
                    return
            except CNCStepperError as error:
                if error.code == "session-ended":
                    raise
                show_text("cncstepper: {error}", err=True, error=error)

    def _over(self, stand: int, word: str) -> bool:
        """Return whether an answer that moves the machine belongs to a pause that is over, and print that."""
        if word in ("s", "q") or self._client.status().stand == stand:
            return False
        show_text(OVER, err=True)
        return True

    def _execute_command(self, word: str, number: str = "") -> bool:
        """Carry out one answer; return whether it was the last."""
        if word == "s":
            self._client.stop()
        elif word == "r":
            _resume(self._back)
        elif word in ("b", "l", "e", "f"):
            held = self._back.held()
            _go(self._back, held, _asked(held, word, number))
        elif word != "q":
            show_text(MEANINGS)
        return word in ("s", "r", "q")


def _asked(held: HeldProgram, word: str, number: str) -> Place:
    """Return the place of an answer; raises JobError for one that lacks its number."""
    try:
        length_mm = float(number) if number else math.inf
    except ValueError:
        length_mm = math.nan
    if not length_mm > 0 or (word in "bl" and length_mm == math.inf):
        raise JobError(
            "answer",
            Text("'{word} {number}' says no length or line", word=word, number=number),
            advice="write for example: b 5",
        )
    if word == "l":
        return _target(held, None, int(length_mm), False, None)
    return _target(held, length_mm if word == "b" else None, None, word == "e", length_mm if word == "f" else None)
