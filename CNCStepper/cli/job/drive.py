# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper drive`: the pulses of a program, sent by this computer."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.options import dialect_name, dialect_option, machine_option, program_argument, read_program
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.start_state_options import StartOptions, start_options
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import MachineRefusal
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.control.pulses.pacing import Jitter
    from CNCStepper.control.pulses.program import PulseProgram
    from CNCStepper.control.pulses.sender import Pace
    from CNCStepper.motion.planner.feed_hold import FeedHold

HOLD, RESUME = "!", "~"  # as grbl knows them


@click.command("drive", cls=Verb)
@program_argument
@machine_option(required=True)
@click.option(
    "--port",
    type=OutputPath("pulses"),
    required=True,
    help="The device file of a parallel port (/dev/parport0), or a file that records each write and when it was.",
)
@click.option(
    "--zero-confirmed",
    is_flag=True,
    help="The machine stands where the program begins, its way is free.",
)
@dialect_option
@start_options
def command(
    program: Path,
    machine: Machine,
    port: Path,
    zero_confirmed: bool,
    dialect: str | None,
    given: StartOptions,
) -> None:
    """Send PROGRAM's pulses to a parallel port, with the pins and pulse times of the profile's [signals].

    The machine stands at its zero, or at --position, when the program begins. First every pulse is worked out once,
    so that what the machine cannot do is refused before it moves; then this computer is tried for three seconds at
    the program's fastest rate, and refuses to start where one write comes too late. A write that is late by a whole
    pulse ends the run with exit status 1, spindle, beam and drives off: steps may be lost, home the machine. The
    jitter is printed at the end. Backlash is taken up. A laser's beam is off on rapids; speeds and powers (S) have no
    line. Programs that pause, wait, probe, thread or change tools are refused, and devices that are on no pin.

    While it runs, type and press Enter:

    \b
      !       hold: brake along the path, no place is lost; the spindle goes on turning, a laser's beam goes off
      ~       go on
      50      50 % of every programmed speed; from 1 to 100

    What is typed is heard half a second later. Limit switches are not read. Ctrl-C, Ctrl-Z and a closed terminal stop
    at once: axes that move may lose their place. It is not an emergency stop: a process that is killed (SIGKILL) and
    a computer that hangs leave spindle and beam as they are.
    """
    from CNCStepper.cli.common.findings_output import show_findings
    from CNCStepper.control.pulses.ports import is_parallel_port
    from CNCStepper.control.pulses.program import PulseProgram
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.state import Start

    start = given.on(Start.at_zero())
    path = interpret(read_program(program), start, dialect_name(dialect, machine), str(program))
    job = PulseProgram.of(path, machine, str(program))
    if errors := job.errors():
        show_findings(errors)
        sys.exit(1)
    pace = job.pace()
    if is_parallel_port(port) and not zero_confirmed:
        click.confirm("Does the machine stand where the program begins, and is its way free?", abort=True)
    told = _sent(job, port, pace)
    click.echo(f"{told.writes} writes in {told.taken_s:.3f} s, {_late(told)}")


def _sent(job: PulseProgram, port: Path, pace: Pace) -> Jitter:
    """Send all pulses, obeying what is typed meanwhile; return how late they were."""
    from CNCStepper.cli.common.terminal_input import TerminalInput
    from CNCStepper.control.pulses.sender import send_pulses
    from CNCStepper.motion.planner.buffers import TICKS_PER_S
    from CNCStepper.motion.planner.feed_hold import FeedHold

    reins = FeedHold()
    typed = TerminalInput(lambda line: _execute_command(reins, line))
    try:
        return send_pulses(job.chunks(reins), TICKS_PER_S, port, pace, _report_trial, typed.wait)
    except KeyboardInterrupt:
        click.echo("cncstepper: steps may be lost: home the machine before its next move", err=True)
        raise


def _execute_command(reins: FeedHold, line: str) -> None:
    """Do what a line asks for and print it; any other line is answered with the list of commands."""
    if line == HOLD:
        reins.hold()
        said = "holding; ~ goes on"
    elif line == RESUME:
        reins.resume()
        said = "going on"
    elif line.isdecimal():
        said = _slow(reins, int(line))
    else:
        said = "! holds, ~ goes on, a number from 1 to 100 is the share of every programmed speed in %"
    click.echo(said, err=True)


def _slow(reins: FeedHold, percent: int) -> str:
    """Set the share of every speed; return what to answer."""
    try:
        reins.slow(percent / 100)
    except MachineRefusal as refusal:
        return refusal.sentence
    return f"{percent} % of every programmed speed"


def _report_trial(trial: Jitter) -> None:
    click.echo(f"tried at {trial.writes / trial.taken_s:.0f} writes/s: {_late(trial)}", err=True)


def _late(jitter: Jitter) -> str:
    return (
        f"late by {jitter.mean_us:.1f} µs on average, "
        f"99 of 100 by at most {jitter.p99_us:.0f}, the worst by {jitter.worst_us:.0f}"
    )
