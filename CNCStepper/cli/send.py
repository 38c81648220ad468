# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper send`: a program to a controller, by the sender's own process, watched until the machine is idle."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.options import dialect_name, dialect_option, machine_option, program_argument, read_program
from CNCStepper.cli.show import show_findings
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.control.outcome import Outcome
    from CNCStepper.control.send_job import SendJob


@click.command("send")
@program_argument
@click.option("--port", required=True, help="A serial port (COM3, /dev/ttyUSB0) or a URL (socket://127.0.0.1:2217).")
@machine_option(required=False)
@dialect_option
@click.option("--baud", type=click.IntRange(min=300), default=115200, show_default=True)
@click.option("--zero-confirmed", is_flag=True, help="The work zero is set on the stock; without it you are asked.")
@click.option("--resume-pauses", is_flag=True, help="Go on by itself at M0: for a virtual machine or a dry run.")
@click.option("--allow-differences", is_flag=True, help="Send though the controller's settings differ from --machine.")
def command(
    program: Path,
    port: str,
    machine: Machine | None,
    dialect: str | None,
    baud: int,
    zero_confirmed: bool,
    resume_pauses: bool,
    allow_differences: bool,
) -> None:
    """Send PROGRAM to the controller at --port and wait until the machine is idle again.

    With --machine the program is checked against it first, and the controller's settings are compared with it.
    Ctrl-C holds the machine and asks what to do. A stop here is not an emergency stop.
    """
    from CNCStepper.cli.watch import watch

    job = _job(program, port, machine, dialect_name(dialect, machine), baud, allow_differences)
    outcome = watch(_confirmed(job, zero_confirmed), resume_pauses)
    _conclude(outcome)


def _job(
    program: Path, port: str, machine: Machine | None, dialect: str, baud: int, allow_differences: bool
) -> SendJob:
    """Read the program back and check it; exits with 1 where a check refuses it."""
    from CNCStepper.gcode.prepare import prepare
    from CNCStepper.gcode.read_back import read_back
    from CNCStepper.job.send import send_job
    from CNCStepper.simulation.check import check
    from CNCStepper.simulation.finding import refused

    text = read_program(program)
    wire = prepare(text, dialect, str(program))
    toolpath = read_back(wire, text, None, dialect, str(program))
    if machine:
        findings = check(toolpath, machine, file=str(program))
        show_findings(finding for finding in findings if finding.severity == "error")
        if refused(findings):
            sys.exit(1)
    job = send_job(wire, machine, str(program))
    return replace(job, port=port, baud=baud, allow_differences=allow_differences)


def _confirmed(job: SendJob, confirmed: bool) -> SendJob:
    """Return the job with the zero confirmed, by the option or by the person at the terminal."""
    if not confirmed and sys.stdin.isatty():
        confirmed = click.confirm("Is the work zero set on the stock, and the way free?", default=False)
    return replace(job, zero_confirmed=confirmed)


def _conclude(outcome: Outcome) -> None:
    """Say how it ended and how the machine stands; only "done" is exit status 0."""
    status = outcome.status
    click.echo(f"{status.acknowledged} of {status.total} lines acknowledged in {status.elapsed_s:.1f} s")
    if outcome.error:
        click.echo(f"cncstepper: {outcome.text}", err=True)
    else:
        click.echo(outcome.text)
    sys.exit(0 if outcome.done else 1)
