# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper restart`: proves, writes and sends a program from a place in its middle on.

Its options: the place, the entry into the path, and where the restart program goes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import save, show_findings
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import NumberType, PointType, program_argument, read_program, reproduce_options
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.program_options import ProgramOptions, program_options
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.send_options import SendOptions, send_options
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job.send import LETTERS
from CNCStepper.errors import JobError, Text
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool

if TYPE_CHECKING:
    from CNCStepper.control.program.certificate import Certificate
    from CNCStepper.job.model import Job
    from CNCStepper.recovery.restart.prove_restart import EntryOptions, ProvenRestart
    from CNCStepper.recovery.restart.restart_places import RequestedPlace
    from CNCStepper.simulation.stock import Stock
    from CNCStepper.state import Start

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
_RESULT = (
    click.option("-o", "--out", type=OutputPath("program"), help="Write the restart program there."),
    click.option("--certificate", type=OutputPath("certificate"), help="Write its certificate there."),
    click.option("--port", help="Send it: a port or URL as of `cncstepper send`, a parallel port too."),
    click.option(
        "--without-stock",
        is_flag=True,
        help="Send a restart that was not simulated on a stock: without --job, and without --stock and --tool.",
    ),
)


@dataclass(frozen=True)
class RestartOutput:
    """Where the restart program goes: to files, to a port."""

    out: Path | None
    certificate: Path | None
    port: str | None
    without_stock: bool


def restart_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of place and output; the function gets them as `where`, `entering` and `output`."""

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
        from CNCStepper.recovery.restart.prove_restart import EntryOptions
        from CNCStepper.recovery.restart.restart_places import RequestedPlace

        where = RequestedPlace(line or 0, time or 0, operation, contour or 0, at_mm)
        output = RestartOutput(**{name: more.pop(name) for name in RestartOutput.__dataclass_fields__})
        return function(*arguments, where=where, entering=EntryOptions(overlap, height), output=output, **more)

    for option in reversed((*_PLACE, *_RESULT)):
        command = option(command)
    return command


@dataclass(frozen=True)
class _Against:
    """Machine, start and stock for the proof of the restart."""

    machine: Machine
    dialect: str
    start: Start | None
    stock: Stock | None
    tool: Tool | None
    job: Job | None

    @classmethod
    def of(cls, given: ProgramOptions) -> _Against:
        """Return the inputs that the options name; raises a usage error where they name no machine."""
        job, machine = given.job_and_machine()
        if machine is None:
            raise click.UsageError(Text("give --machine, or --job whose machine counts"))
        start, dialect = given.start_options.start(), given.dialect_on(machine)
        return cls(machine, dialect, start, given.stock, given.tool, job)

    @property
    def has_stock(self) -> bool:
        """Whether the restart is cut on a stock, so that what its moves meet is seen."""
        return self.job is not None or (self.stock is not None and self.tool is not None)


HELP = """Restart PROGRAM at a line, an operation, a contour or a point.

Everything before that place counts as cut. The tool goes up and over the place, the spindle starts, and the tool goes
down at the plunge feed; a beam is switched on at the bottom. Offsets and modes are those of the undisturbed run, and
the program's own lines follow unchanged. If the place cannot be entered, an earlier place is used and printed.

Without --port nothing is sent: the restart is described, and -o writes its program. Without a place the contours are
listed. Give --machine, or --job with its machine. With --job, or --stock and --tool, the restart is simulated on the
stock that the earlier moves have left, and refused where a rapid meets material. Without a stock it is sent only with
--without-stock. A program in a language that the controller does not read is restarted in grbl's, as it is sent.
`cncstepper resume` prints the whole command for a job that did not end.

At a parallel port or a USB board --machine names the controller of ours that --port starts. It can neither home nor
probe: set the work zero with `cncstepper zero` first. What a machine cannot do is printed before the first line.
Programs of the mini-lathe, and pulse letters, cannot be restarted in the middle: send them whole.

Exit 0 when the restart is clean (and, with --port, done), else 1.
"""


@click.command("restart", cls=Verb, help=HELP)
@program_argument
@restart_options
@send_options
@program_options()
@click.option("--part", type=click.IntRange(1), help="Which program of a job that is split, one a tool.")
def command(
    program: Path,
    where: RequestedPlace,
    entering: EntryOptions,
    output: RestartOutput,
    sending: SendOptions,
    part: int | None,
    given: ProgramOptions,
) -> None:
    """Restart a program in its middle; see `HELP`."""
    from CNCStepper.control.service.port_owner import check_free, warn_of_closed
    from CNCStepper.recovery.restart.prove_restart import certificate_of_restart

    _check_not_letters(program)
    given.check_stock()
    against = _Against.of(given)
    _check_stock(against, output)
    if output.port:
        check_free(output.port)
        warn_of_closed(partial(show_text, err=True))
    text = read_program(program)
    if not (where.line or where.operation or where.contour or where.at_mm):
        _list(text, program, against)
        return
    proven = _proven(text, program, where, entering, against, part)
    _tell(proven, against)
    certificate = certificate_of_restart(proven).sending(made_with=reproduce_options())
    _write(proven, certificate, output)
    if proven.proof.refused:
        show_text("{program}: this restart is refused", program=program)
        sys.exit(1)
    if output.port:
        _send(certificate, output.port, sending)


def _check_not_letters(program: Path) -> None:
    """Refuse pulse letters; raises JobError."""
    if program.suffix.lower() == LETTERS:
        raise JobError(
            "restart-letters",
            "pulse letters name no places, so that no entry can be written for them",
            advice="hold and go back along the pulses with 'cncstepper back', or send the letters that are left",
        )


def _check_stock(against: _Against, output: RestartOutput) -> None:
    """Refuse to send a restart cut on no stock without --without-stock, and both together; raises a usage error."""
    if output.without_stock and against.has_stock:
        raise click.UsageError(Text("--without-stock goes without --job, --stock and --tool"))
    if output.port and not (against.has_stock or output.without_stock):
        raise click.UsageError(
            Text("give --job, or --stock and --tool, to have it cut on what is left of the stock; or --without-stock")
        )


def _list(text: str, program: Path, against: _Against) -> None:
    """Print the places by which a restart can be named."""
    from CNCStepper.recovery.restart.description import contour_table
    from CNCStepper.recovery.restart.interrupted_program import read_on_machine

    start = against.job.started(against.start, against.machine) if against.job else against.start
    interrupted = read_on_machine(text, against.machine, against.dialect, start, str(program))
    show_text("contour   line   operation             begins at                        length")
    for number, line, operation, place, length_mm in contour_table(interrupted):
        click.echo(f"{number:7} {line:6}   {operation:20}  {place:32} {length_mm:.1f} mm")
    show_text("name one with --contour, or give --line, --operation or --at")


def _proven(
    text: str, program: Path, where: RequestedPlace, entering: EntryOptions, against: _Against, part: int | None
) -> ProvenRestart:
    from CNCStepper.cli.program.check import STAGES, prior_parts
    from CNCStepper.recovery.restart.prove_restart import restart_job, restart_program

    words: dict[str, Any] = {"file": str(program), "dialect": against.dialect, "start": against.start}
    with Progress(Text("reading {name}", name=program.name)) as progress:
        words["tell"] = lambda stage: progress.doing(
            Text("{stage} the restart of {name}", stage=STAGES[stage], name=program.name)
        )
        words["share"] = progress.share
        machine, job = against.machine, against.job
        if job:
            return restart_job(job, machine, text, where, entering, earlier=prior_parts(job, machine, part), **words)
        return restart_program(text, machine, where, entering, stock=against.stock, tools=against.tool, **words)


def _tell(proven: ProvenRestart, against: _Against) -> None:
    """Print the steps of the restart, and the inputs of its proof."""
    from CNCStepper.recovery.restart.description import proven_against, words_of

    show_findings(proven.proof.findings)
    for sentence in words_of(proven.restart):
        show_text(sentence)
    show_text(proven_against(against.has_stock, against.job is not None))
    show_text("takes {time_s:.1f} s", time_s=proven.proof.report["time_s"])


def _write(proven: ProvenRestart, certificate: Certificate, output: RestartOutput) -> None:
    """Write program and certificate where they are wanted; the certificate names the program."""
    if output.out:
        save(output.out, proven.restart.text.encode("utf-8"))
        show_text("{out}: written{proven}", out=output.out, proven=_language_note(proven))
    if output.certificate:
        output.certificate.parent.mkdir(parents=True, exist_ok=True)
        certificate.write(output.certificate)
        show_text("{certificate}: written", certificate=output.certificate)


def _language_note(proven: ProvenRestart) -> str:
    """Return in which language a restart is, where that is not the language of its program."""
    program = proven.restart.program
    name = program.dialect.name.partition(":")[0]
    return Text(", in the language that is sent: --dialect {name}", name=name) if program.is_translated else ""


def _send(certificate: Certificate, port: str, sending: SendOptions) -> None:
    """Send the proven lines as `cncstepper send` does."""
    from CNCStepper.cli.job.driven_job import driven_by, typed_machine, with_rate
    from CNCStepper.cli.job.send import conclude, confirmed
    from CNCStepper.cli.job.session_watch import watch

    certificate.check_clean()
    job = certificate.send_job(
        port=port,
        baud=sending.baud,
        allow_differences=sending.allow_differences,
        home_first=sending.home_first,
    )
    job = driven_by(job, job.retrace.get("machine") or {}, typed_machine())
    job = with_rate(job) if job.profile else job
    conclude(watch(confirmed(job, sending.zero_confirmed), sending.resume_pauses, sending.keep_min))
