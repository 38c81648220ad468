# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper restart`: a program from a place in its middle on, proven, written and sent."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.options import (
    NumberType,
    PointType,
    check_stock,
    dialect_name,
    dialect_option,
    job_option,
    machine_option,
    program_argument,
    read_program,
    stock_of,
    stock_options,
)
from CNCStepper.cli.progress import Progress
from CNCStepper.cli.show import show_findings
from CNCStepper.cli.start import Given, start_options
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tool import Tool

if TYPE_CHECKING:
    from CNCStepper.gcode.restart.places import Where
    from CNCStepper.job.model import Job
    from CNCStepper.job.restart import Entering, ProvenRestart
    from CNCStepper.simulation.stock import Stock

_PLACE = (
    click.option("--line", type=click.IntRange(1), help="The first line that is not certainly done."),
    click.option("--time", type=click.IntRange(1), help="Which of its runs, for a line that is run often."),
    click.option("--operation", default="", help="An operation of the program, by its name or its number."),
    click.option("--contour", type=click.IntRange(1), help="A stretch of cuts between two rapids, by its number."),
    click.option(
        "--at", "at_mm", type=PointType(), default=(), help="The cut nearest to this point; without Z the first."
    ),
    click.option(
        "--overlap", type=NumberType(-1e-9), default=0.0, help="Cut so many mm before the place again, within its cut."
    ),
    click.option(
        "--height", type=NumberType(), help="Go up to this Z first. [default: the program's highest crossing rapid]"
    ),
)
_SENDING = (
    click.option(
        "-o", "--out", type=click.Path(dir_okay=False, path_type=Path), help="Write the restart program there."
    ),
    click.option("--certificate", type=click.Path(dir_okay=False, path_type=Path), help="Write its certificate there."),
    click.option("--port", help="Send it: a serial port (COM3, /dev/ttyUSB0) or a URL (socket://127.0.0.1:2217)."),
    click.option("--baud", type=click.IntRange(min=300), default=115200, show_default=True),
    click.option("--zero-confirmed", is_flag=True, help="As of `cncstepper send`; the tool is in."),
    click.option("--home", "home_first", is_flag=True, help="Let the machine home itself first ($H)."),
    click.option("--resume-pauses", is_flag=True, help="Go on by itself at M0: for a virtual machine or a dry run."),
    click.option(
        "--allow-differences",
        is_flag=True,
        help="Send though the controller's settings or offsets are not those wanted.",
    ),
)


@dataclass(frozen=True)
class _Sending:
    """What becomes of the restart program."""

    out: Path | None
    certificate: Path | None
    port: str | None
    baud: int
    zero_confirmed: bool
    home_first: bool
    resume_pauses: bool
    allow_differences: bool


@dataclass(frozen=True)
class _Against:
    """What the restart program is proven against."""

    machine: Machine
    dialect: str
    given: Given
    stock: Stock | None
    tool: Tool | None
    job: Job | None


def _options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of the place and of sending; the function gets them as `where`, `entering` and `sending`."""

    @wraps(function)
    def command(
        *arguments: Any,
        line: int | None,
        time: int | None,
        operation: str,
        contour: int | None,
        at_mm: tuple[float, ...],
        overlap: float,
        height: float | None,
        **more: Any,
    ) -> Any:
        from CNCStepper.gcode.restart.places import Where
        from CNCStepper.job.restart import Entering

        where = Where(line or 0, time or 0, operation, contour or 0, at_mm)
        sending = _Sending(**{name: more.pop(name) for name in _Sending.__dataclass_fields__})
        return function(*arguments, where=where, entering=Entering(overlap, height), sending=sending, **more)

    for option in reversed((*_PLACE, *_SENDING)):
        command = option(command)
    return command


@click.command("restart")
@program_argument
@_options
@machine_option(required=False)
@stock_options(required=False)
@job_option
@start_options
@dialect_option
@click.option("--part", type=click.IntRange(1), help="Which program of the job it is, where it is split, one a tool.")
def command(
    program: Path,
    where: Where,
    entering: Entering,
    sending: _Sending,
    machine: Machine | None,
    stock: tuple[float, float, float] | None,
    origin: str,
    tool: Tool | None,
    job_path: Path | None,
    dialect: str | None,
    part: int | None,
    given: Given,
) -> None:
    """Go on with PROGRAM from a line, an operation, a contour or a point on.

    What lies before the place is taken as cut. The tool goes up, over the place, the spindle starts, and it goes down
    at the plunge feed; a beam is switched on down there. All offsets and modes are as in the undisturbed run, and the
    program's own lines follow as they are. Where the place cannot be entered, an earlier one is, and you are told.

    Without --port nothing is sent: you see what it would do, and with -o you get the program. Without a place you get
    the list of the contours. --machine, or --job with its machine, is needed; with --job, or with --stock and --tool,
    the restart is cut on the stock that the moves before it have left, and refused where a rapid meets material.
    Exit 0 when it is clean (and, with --port, done), else 1.
    """
    from CNCStepper.job.model import load_job

    check_stock(stock, tool, job_path)
    job, machine_of_job = load_job(job_path) if job_path else (None, None)
    machine = machine or machine_of_job
    if machine is None:
        raise click.UsageError("give --machine, or --job whose machine counts")
    against = _Against(machine, dialect_name(dialect, machine), given, stock_of(stock, origin), tool, job)
    text = read_program(program)
    if not (where.line or where.operation or where.contour or where.at_mm):
        _list(text, program, against)
        return
    proven = _proven(text, program, where, entering, against, part)
    _tell(proven)
    _write(proven, sending)
    if proven.proof.refused:
        click.echo(f"{program}: this restart is refused")
        sys.exit(1)
    if sending.port:
        _send(proven, sending)


def _list(text: str, program: Path, against: _Against) -> None:
    """Print the places by which a restart can be named."""
    from CNCStepper.gcode.restart.program import read_program as read
    from CNCStepper.job.restart_words import contour_table

    start = against.given.start()
    start = against.job.started(start, against.machine) if against.job else start
    click.echo("contour   line   operation             begins at                        length")
    for number, line, operation, place, length_mm in contour_table(read(text, against.dialect, start, str(program))):
        click.echo(f"{number:7} {line:6}   {operation:20}  {place:32} {length_mm:.1f} mm")
    click.echo("name one with --contour, or give --line, --operation or --at")


def _proven(
    text: str, program: Path, where: Where, entering: Entering, against: _Against, part: int | None
) -> ProvenRestart:
    from CNCStepper.cli.check import STAGES, earlier_parts
    from CNCStepper.job.restart import restart_job, restart_program

    words: dict[str, Any] = {"file": str(program), "dialect": against.dialect, "start": against.given.start()}
    with Progress(f"reading {program.name}") as progress:
        words["tell"] = lambda stage: progress.doing(f"{STAGES[stage]} the restart of {program.name}")
        words["share"] = progress.share
        machine, job = against.machine, against.job
        if job:
            return restart_job(job, machine, text, where, entering, earlier=earlier_parts(job, machine, part), **words)
        return restart_program(text, machine, where, entering, stock=against.stock, tools=against.tool, **words)


def _tell(proven: ProvenRestart) -> None:
    from CNCStepper.job.restart_words import words_of

    show_findings(proven.proof.findings)
    for sentence in words_of(proven.restart):
        click.echo(sentence)
    click.echo(f"takes {proven.proof.report['time_s']:.1f} s")


def _write(proven: ProvenRestart, sending: _Sending) -> None:
    """Write program and certificate where they are wanted; the certificate names the program."""
    from CNCStepper.job.restart import certificate_of_restart

    if sending.out:
        sending.out.write_text(proven.restart.text, encoding="utf-8", newline="\n")
        click.echo(f"{sending.out}: written")
    if sending.certificate:
        sending.certificate.write_text(certificate_of_restart(proven).to_json(), encoding="utf-8")
        click.echo(f"{sending.certificate}: written")


def _send(proven: ProvenRestart, sending: _Sending) -> None:
    """Send the proven lines as `cncstepper send` does."""
    from CNCStepper.cli.send import conclude, confirmed
    from CNCStepper.cli.watch import watch
    from CNCStepper.job.restart import certificate_of_restart

    assert sending.port
    certificate = certificate_of_restart(proven)
    certificate.check_clean()
    job = replace(
        certificate.send_job(),
        port=sending.port,
        baud=sending.baud,
        allow_differences=sending.allow_differences,
        home_first=sending.home_first,
    )
    conclude(watch(confirmed(job, sending.zero_confirmed), sending.resume_pauses))
