# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper send`: a program to a controller, by the sender's own process, watched until the machine is idle.

The program that a verb is given, of which no more is held than is asked for.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.chart_options import ChartOptions, chart_options
from CNCStepper.cli.common.findings_output import show_findings
from CNCStepper.cli.common.language import look_up, show_text
from CNCStepper.cli.common.options import FilePath, program_argument, read_program
from CNCStepper.cli.common.program_options import ProgramOptions, program_options
from CNCStepper.cli.common.send_options import SendOptions, send_options
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import JobError, Text
from CNCStepper.machine.processes import PROCESSES, Process
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.control.program.certificate import Certificate
    from CNCStepper.control.program.send_job import SendJob
    from CNCStepper.control.session.status import Outcome
    from CNCStepper.job.model import Job
    from CNCStepper.machine.cut_data import CutData
    from CNCStepper.simulation.cutter_solid import Tools
    from CNCStepper.simulation.finding import Finding
    from CNCStepper.simulation.stock import Stock
    from CNCStepper.state import Start
    from CNCStepper.toolpath import Toolpath

LETTERS = ".letters"  # ends the name of a file of pulse letters
HELP = """Send PROGRAM to the controller at --port and wait until the machine is idle.

With --certificate only the proven program is sent. Machine, start state, tools, stock and clamps must be those of the
proof, as far as you give them. Without a certificate the program is checked first, with --machine or --job (whose
machine counts where --machine is absent); --unchecked skips the check. The controller's settings are compared, and the
work zero where the proof knows it.

With --machine, a controller of ours runs machines whose pulses this computer makes, and the mini-lathe. Programs in the
machine's own language are sent to it as grbl lines, which are proven by reading them back. The fastest pulse rate of
the program is tried before the first line. PROGRAM may be a file of pulse letters, NAME.letters. What a machine cannot
do (hold, stop, override) is printed before the first line.

Many boards restart when their port is opened; then the position is unknown. With limit switches give --home. Without
them move the tool to the work zero, run `cncstepper zero`, and send without moving anything in between; with any other
zero nothing is sent. After an alarm, a lost link or a killed sender the position is unknown for all later connections
too. Then nothing is sent before --home, `cncstepper home`, or `cncstepper zero` for all axes.

The job uses the connection that is open at --port. It leaves a connection open for --keep-open minutes, so that the
next verb does not restart the board.

Ctrl-C holds the machine and asks what to do; a second Ctrl-C stops the job. This stop is not an emergency stop. If the
job went on after a question, your answer is ignored and you are asked again. `cncstepper hold`, `go`, `stop`,
`override` and `back` act on the job from any terminal, also after this one is closed. Without a terminal (standard
input at its end) the machine waits at each pause and hold for one of them. Ctrl-C then holds it, and stops it there.

At a pause (M0, or M6 of grblHAL) and between two lines with --step a beam is off. Enter resumes and s stops.
"x10 y-5 z0.1" jogs by these mm ("f100": at 100 mm/min), "zero z" sets the work zero of Z, "all" ends --step. "feed
-10", "spindle +10", "rapid 50" and "flood" change the overrides; "?" lists them. After a jog the tool returns before
the job resumes: up, across, and slowly down to where the program stopped.
"""


@dataclass(frozen=True)
class ProgramFile:
    """The program of a file; `text` holds it whole, from the first time that it is asked for."""

    path: Path

    @cached_property
    def text(self) -> str:
        """Its text."""
        return read_program(self.path)

    @cached_property
    def sha256(self) -> str:
        """The fingerprint by which a certificate knows it."""
        from CNCStepper.control.program.certificate import digest_of_pieces

        return digest_of_pieces(self._pieces())

    def is_expanded(self, dialect: str) -> bool:
        """Whether its lines are written out before they are sent, perhaps with those of other files."""
        from CNCStepper.gcode.dialects import dialect_named
        from CNCStepper.gcode.wire.expansion import is_expanded

        return any(is_expanded(piece, dialect_named(dialect)) for piece in self._pieces())

    def _pieces(self) -> Iterable[str]:
        from CNCStepper.gcode.interpreter.program_file import text_pieces

        if "text" in vars(self) or not self.path.is_file():  # a pipe can be read only once
            return [self.text]
        return text_pieces(self.path)


@click.command("send", cls=Verb, help=HELP)
@program_argument
@click.option(
    "--port",
    required=True,
    help="A serial port (COM3, /dev/ttyUSB0) or a URL (socket://127.0.0.1:2217). For a machine whose pulses this "
    "computer makes also a parallel port (/dev/parport0), or record:FILE, which records the pulses as CSV.",
)
@click.option("--certificate", type=FilePath, help="The certificate that `check` or `run` wrote for this program.")
@program_options()
@chart_options
@send_options
@click.option(
    "--step", "by_line", is_flag=True, help="Send line by line: Enter sends the next line after the last is cut."
)
@click.option("--unchecked", is_flag=True, help="Send without a certificate and without a check.")
@click.option(
    "--despite-certificate", is_flag=True, help="Send even if the certificate does not match or holds errors."
)
def command(
    program: Path,
    port: str,
    certificate: Path | None,
    sending: SendOptions,
    by_line: bool,
    unchecked: bool,
    despite_certificate: bool,
    given: ProgramOptions,
    cut: ChartOptions,
) -> None:
    """Send a program and wait until the machine is idle; see `HELP`."""
    from CNCStepper.cli.job.driven_job import driven_by, typed_machine, with_rate
    from CNCStepper.cli.job.session_watch import watch
    from CNCStepper.control.service.port_owner import check_free, warn_of_closed

    _check_pauses(by_line, sending.resume_pauses)
    _check_proof(given, bool(certificate), unchecked, despite_certificate)
    check_free(port)
    warn_of_closed(partial(click.echo, err=True))
    if program.suffix.lower() == LETTERS:
        job = _letters(program, given, certificate)
    else:
        job = _job(ProgramFile(program), given, cut, certificate, unchecked, despite_certificate)
        job = driven_by(job, job.retrace.get("machine") or {}, typed_machine())
    job = replace(with_rate(job) if job.profile else job, port=port, baud=sending.baud, by_line=by_line)
    job = replace(job, allow_differences=sending.allow_differences, home_first=sending.home_first)
    conclude(watch(confirmed(job, sending.zero_confirmed), sending.resume_pauses, sending.keep_min))


def _letters(program: Path, given: ProgramOptions, certificate: Path | None) -> SendJob:
    """Return the job of a file of pulse letters; they are checked by themselves, so that no certificate is of them."""
    from CNCStepper.cli.job.driven_job import driven_by, typed_machine
    from CNCStepper.job.letter_file import letter_file, letter_job, read_letter_text

    if certificate:
        raise click.UsageError(Text("pulse letters have no certificate: they are checked when they are sent"))
    _, machine = given.job_and_machine()
    if machine is None:
        raise click.UsageError(Text("pulse letters need --machine"))
    text = read_letter_text(program)
    job = letter_job(text, machine, str(program))
    letters = letter_file(text, str(program))
    ends = (
        f"{name.upper()}{steps / axis.steps_per_mm:+.3f}"
        for (name, axis), steps in zip(machine.own_axes.items(), letters.steps, strict=False)
    )
    show_text(
        "{pulses} pulses in {plan:.1f} s, from here to {ends} mm",
        err=True,
        pulses=letters.pulses,
        plan=job.plan[-1][1],
        ends=" ".join(ends),
    )
    return driven_by(job, machine.model_dump(mode="json"), typed_machine())


def _job(
    program: ProgramFile,
    given: ProgramOptions,
    cut: ChartOptions,
    certificate: Path | None,
    unchecked: bool,
    despite: bool,
) -> SendJob:
    """Return the job of a program, as its certificate proves it or as it is checked now."""
    from CNCStepper.cli.common.options import merged, reproduce_options

    wanted = _Wanted.of(program, given, cut, is_certified=certificate is not None)
    if certificate:
        if cut != ChartOptions():
            given = replace(given, dialect=cut.language(given.dialect, wanted.machine))
        job = _certified(certificate, wanted, given, despite)
        _check_dialect(job.dialect, wanted.machine)
    else:
        job = _checked(wanted, cut.language(given.dialect, wanted.machine), unchecked)
    return replace(job, program_sha256=program.sha256, made_with=merged(job.made_with, reproduce_options()))


def _check_pauses(by_line: bool, resume_pauses: bool) -> None:
    if by_line and resume_pauses:
        raise click.UsageError(Text("--step waits at each line, --resume-pauses at none: give one of them"))


def _check_proof(given: ProgramOptions, is_certified: bool, unchecked: bool, despite_certificate: bool) -> None:
    """Refuse options that describe the stock in part, or leave a program unproven without saying so."""
    if not is_certified or given.job_path:
        given.check_stock()
    if despite_certificate and not is_certified:
        raise click.UsageError(Text("--despite-certificate goes with --certificate"))
    if not (is_certified or given.machine or given.job_path or unchecked):
        raise click.UsageError(Text("give --certificate, or --machine or --job to have it checked, or --unchecked"))


@dataclass(frozen=True)
class _Wanted:
    """The program to send, and what it is compared with, as far as the command line gives it.

    turning: the file of a lathe's job.
    """

    program: ProgramFile
    machine: Machine | None
    stock: Stock | None
    tools: Tools | None
    start: Start | None
    job: Job | None = None
    row: CutData | None = None
    turning: Path | None = None

    @property
    def file(self) -> str:
        """What the program is called."""
        return str(self.program.path)

    @classmethod
    def of(cls, program: ProgramFile, given: ProgramOptions, cut: ChartOptions, is_certified: bool) -> _Wanted:
        """Return what the command line asks for; a job gives stock and tools, and its machine where none is named.

        Where the command line gives no start, the certificate does; without a certificate the job does.
        """
        start, (job, machine) = given.start_options.start(), given.job_and_machine()
        if job is None or machine is None:
            return cls(program, machine, given.stock, given.tool, start, row=cut.row(machine), turning=given.job_path)
        start = start if is_certified and not start else job.started(start, machine)
        on_machine = job.on(machine)
        return cls(program, machine, job.stock.stock(), on_machine.tools, start, job, on_machine.cut_data)

    @property
    def process(self) -> Process | None:
        """The process that the job, or else the chart's row, names."""
        name = self.job.process if self.job else self.row.process if self.row else None
        return PROCESSES[name] if name else None


def _check_dialect(dialect: str, machine: Machine | None) -> None:
    """Refuse, before a port is opened, what the machine's controller would read as other moves."""
    from CNCStepper.control.preflight.checks import check_sendable

    language = machine.wire_language(dialect) if machine else dialect
    check_sendable(language, machine.controller if machine else "")


def _certified(path: Path, wanted: _Wanted, given: ProgramOptions, despite: bool) -> SendJob:
    """Return the certificate's own job; refuses whatever differs from it, or prints it when `despite`."""
    from CNCStepper.control.program.certificate import Certificate
    from CNCStepper.job.make_certificate import proven_start

    try:
        certificate = Certificate.read(path)
    except JobError as error:
        if not despite:
            raise
        show_text("cncstepper: {error}", err=True, error=error)
        return _uncertified(wanted, given.dialect_on(wanted.machine))
    proven = replace(wanted, start=wanted.start or proven_start(certificate))
    dialect = given.dialect_on(wanted.machine) if given.dialect else certificate.program_dialect
    refusals = list(_refusals(certificate, proven, dialect))
    if refusals and not despite:
        raise refusals[0]
    for refusal in refusals:
        show_text("cncstepper: {refusal}", err=True, refusal=refusal)
    if any(refusal.code in ("certificate-program", "certificate-wire") for refusal in refusals):
        return _uncertified(wanted, dialect)
    return certificate.send_job(file=wanted.file)


def _refusals(certificate: Certificate, wanted: _Wanted, dialect: str) -> Iterator[JobError]:
    """Yield each thing in which what is wanted is not what was proven, and the proof's own errors."""
    from CNCStepper.job.make_certificate import (
        check_cut,
        cut_content,
        keep_out_digest,
        machine_digest,
        stock_digest,
        tools_digest,
    )

    digests = {
        "program": wanted.program.sha256,
        "wire": _other_wire(certificate, wanted, dialect),
        "machine": wanted.machine and machine_digest(wanted.machine),
        "start": wanted.start and wanted.start.sha256(),
        "stock": wanted.stock and stock_digest(wanted.stock),
        "tools": wanted.tools and tools_digest(wanted.tools),
        "keep_out": wanted.job and keep_out_digest(wanted.job.clamps, wanted.job.stock.edge_mm),
    }
    process, machine = wanted.process, wanted.machine
    cut = cut_content(machine, process, wanted.row) if machine and process else None
    checks: list[Callable[[], None]] = [partial(check_cut, certificate, machine, cut)]
    checks += [partial(certificate.compare, what, digest) for what, digest in digests.items() if digest]
    for check in [*checks, certificate.check_clean]:
        try:
            check()
        except JobError as error:
            yield error


def _other_wire(certificate: Certificate, wanted: _Wanted, dialect: str) -> str:
    """Return the fingerprint of the lines to send, "" where they can be none but the proven ones.

    So it is with the same program, read in the same way, that leads to no other file: it need not be held whole then.
    """
    from CNCStepper.job.make_certificate import proven_wire

    asked = (wanted.program.sha256, wanted.start and wanted.start.sha256(), dialect)
    proven = (
        certificate.content["program"]["sha256"],
        certificate.content["start"]["sha256"],
        certificate.program_dialect,
    )
    if asked == proven and not wanted.program.is_expanded(dialect):
        return ""
    return proven_wire(certificate, wanted.program.text, dialect, wanted.file, wanted.start).sha256


def _checked(wanted: _Wanted, dialect: str, unchecked: bool) -> SendJob:
    """Read the program back and check it; exits with 1 where a check refuses it."""
    from CNCStepper.job.make_certificate import send_job
    from CNCStepper.job.wire_round_trip import wire_round_trip
    from CNCStepper.simulation.finding import refused
    from CNCStepper.toolpath import require_straight_axes

    _check_dialect(dialect, wanted.machine)
    if wanted.turning and wanted.machine and not unchecked:
        return _turned(wanted, wanted.turning, wanted.machine, dialect)
    wire, motors, toolpath = wire_round_trip(wanted.program.text, wanted.machine, dialect, wanted.file, wanted.start)
    require_straight_axes(motors, wanted.file)
    if wanted.machine and not unchecked:
        findings = _findings(wanted, wanted.machine, toolpath, motors)
        show_findings(finding for finding in findings if finding.severity == "error")
        if refused(findings):
            sys.exit(1)
    return send_job(wire, wanted.machine, wanted.file, toolpath.start, dialect, _plan(wanted.machine, motors))


def _turned(wanted: _Wanted, job: Path, machine: Machine, dialect: str) -> SendJob:
    """Return the job of a lathe's program, proven behind those that cut before it; exits with 1 where it is refused."""
    from CNCStepper.job.make_certificate import send_job
    from CNCStepper.job.turning.prove_program import prove_text_of_job

    words: dict[str, Any] = {"file": wanted.file, "dialect": dialect, "start": wanted.start}
    proof, _ = prove_text_of_job(wanted.program.text, job, machine, **words)
    show_findings(finding for finding in proof.findings if finding.severity == "error")
    if proof.refused:
        sys.exit(1)
    return send_job(proof.wire, machine, wanted.file, proof.start, dialect, proof.plan)


def _plan(machine: Machine | None, motors: Toolpath) -> list[list[float]]:
    """Return the planned times from which the sender calculates what remains; none without a machine."""
    from CNCStepper.job.planned_times import milestones
    from CNCStepper.motion.interpolation.dda_stream import times_and_whole_s
    from CNCStepper.motion.planner.plan import begun

    return milestones(motors.table().line, times_and_whole_s(begun(motors), machine)[0]) if machine else []


def _findings(wanted: _Wanted, machine: Machine, toolpath: Toolpath, motors: Toolpath) -> list[Finding]:
    """Return what every check finds, with a job also against its shapes, its clamps and its sheet's edge."""
    from CNCStepper.job.make import is_split, make_program
    from CNCStepper.simulation.checks.check_program import check

    given: dict[str, Any] = {"file": wanted.file, "stock": wanted.stock, "tools": wanted.tools, "motors": motors}
    given |= {"process": wanted.process, "cut_data": wanted.row} if wanted.process else {}
    if wanted.job and is_split(wanted.job, machine):
        what = "the programs of a job that is split, one a tool, are proven one after the other"
        raise JobError("send-part", what, advice="send each with the certificate that `run` wrote beside it")
    if wanted.job:
        made = make_program(wanted.job, machine)
        given |= {"removals": made.removals, "parts": [part for answer in made.answers for part in answer.parts]}
        given |= {"keep_out": wanted.job.clamps, "edge_mm": wanted.job.stock.edge_mm}
    return check(toolpath, machine, **given)


def _uncertified(wanted: _Wanted, dialect: str) -> SendJob:
    """Return the job of a program that no certificate covers, which somebody wants sent all the same."""
    from CNCStepper.gcode.wire.backlash_compensation import backlash_of
    from CNCStepper.job.make_certificate import send_job
    from CNCStepper.job.wire_round_trip import wire_of

    play = backlash_of(wanted.machine, dialect)
    wire = wire_of(wanted.program.text, wanted.machine, dialect, wanted.file, wanted.start, play)
    return send_job(wire, wanted.machine, wanted.file, wanted.start, dialect)


def confirmed(job: SendJob, confirmed: bool) -> SendJob:
    """Return the job with the zero confirmed, by the option or by the person at the terminal."""
    if not confirmed and sys.stdin.isatty():
        show_text(
            "Should the board restart when its port is opened, the tool must stand on the work zero, as it was set."
        )
        confirmed = click.confirm(look_up("Is the work zero set on the stock, and the way free?"), default=False)
    return replace(job, zero_confirmed=confirmed)


def conclude(outcome: Outcome) -> None:
    """Print the outcome and the machine's state; only "done" is exit status 0."""
    status = outcome.status
    show_text(
        "{acknowledged} of {total} lines acknowledged in {elapsed_s:.1f} s",
        acknowledged=status.acknowledged,
        total=status.total,
        elapsed_s=status.elapsed_s,
    )
    if outcome.error:
        show_text("cncstepper: {outcome}", err=True, outcome=outcome.text)
    else:
        show_text(outcome.text)
    sys.exit(0 if outcome.done else 1)
