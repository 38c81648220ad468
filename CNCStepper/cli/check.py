# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper check`: what is wrong with a program on a machine, before it moves anything."""

from __future__ import annotations

import sys
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, NoReturn

import click

from CNCStepper.cli.hints import add_conversion, show_hints
from CNCStepper.cli.job_file import job_of
from CNCStepper.cli.options import (
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
from CNCStepper.cli.show import show_figures, show_findings, write_report
from CNCStepper.cli.start import Given, start_options
from CNCStepper.cli.verb import OutputPath, Verb
from CNCStepper.errors import ProgramError
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tool import Tool

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.job.prove import Proof
    from CNCStepper.job.prove_file import FileProof
    from CNCStepper.simulation.stock import Stock
    from CNCStepper.state import Start

STAGES = {
    "make": "making the shapes of",
    "read": "reading back",
    "cut": "cutting the stock by",
    "time": "timing",
    "judge": "judging the part of",
    "check": "checking",
    "report": "reporting on",
}


@click.command("check", cls=Verb)
@program_argument
@machine_option(required=True)
@stock_options(required=False)
@job_option
@start_options
@dialect_option
@click.option(
    "--part", type=click.IntRange(1), help="Which program of the job it is, where the machine wants one a tool."
)
@click.option("--json", "json_path", type=OutputPath("report"), help="Also write the report there.")
@click.option("--certificate", type=OutputPath("certificate"), help="Also write the certificate there, for `send`.")
def command(
    program: Path,
    machine: Machine,
    stock: tuple[float, float, float] | None,
    origin: str,
    tool: Tool | None,
    job_path: Path | None,
    dialect: str | None,
    part: int | None,
    json_path: Path | None,
    certificate: Path | None,
    given: Given,
) -> None:
    """Check PROGRAM against a machine: travel, feeds, spindle; with --stock and --tool also rapids and plunges, with
    --job gouge and material left, clamps and the sheet's edge too.

    A job that is split into a program a tool needs --part: the programs before it are made anew and taken as cut.
    A block that moves is a line of PROGRAM, counted once however often it is run.
    Exit 0 clean, 1 refused; each finding is file:line:column: text. Where --work-zero is not given, the place of
    the program on the table is reported as unknown.
    """
    check_stock(stock, tool, job_path)
    language, start = dialect_name(dialect, machine), given.start()
    if not job_path and program.is_file():  # a pipe can be read only once
        _check_in_pieces(program, machine, language, start, stock_of(stock, origin), tool, json_path, certificate)
    from CNCStepper.job.prove import prove, prove_job

    text, job = read_program(program), job_of(job_path) if job_path else None
    _require_readable(text, job.started(start, machine) if job else start, language, program)
    words: dict[str, Any] = {"file": str(program), "dialect": language, "start": start}
    with Progress(f"checking {program.name}") as progress:
        words["tell"] = lambda stage: progress.doing(f"{STAGES[stage]} {program.name}")
        words["share"] = progress.share
        if job:
            proof = prove_job(job, machine, text, earlier=earlier_parts(job, machine, part), **words)
        else:
            proof = prove(text, machine, stock=stock_of(stock, origin), tools=tool, **words)
    _conclude(proof, program, json_path, certificate)


def _conclude(proof: Proof | FileProof, program: Path, json_path: Path | None, certificate: Path | None) -> NoReturn:
    """Show what was found, write what was asked for, and end the command."""
    show_findings(proof.findings)
    if json_path:
        write_report(json_path, proof.report)
    if certificate:
        from CNCStepper.cli.made_with import made_with
        from CNCStepper.job.certify import certificate_of
        from CNCStepper.whole_file import whole_file

        with whole_file(certificate) as file:
            file.writelines(map(str.encode, certificate_of(proof).sending(made_with=made_with()).json_pieces()))
    show_figures(proof.report)
    verdict = "refused" if proof.refused else "clean"
    click.echo(f"{program}: {verdict}; {proof.report['blocks']} blocks that move, {proof.report['time_s']:.1f} s")
    sys.exit(1 if proof.refused else 0)


def _check_in_pieces(
    program: Path,
    machine: Machine,
    language: str,
    start: Start | None,
    stock: Stock | None,
    tool: Tool | None,
    json_path: Path | None,
    certificate: Path | None,
) -> NoReturn:
    """Check a program without holding it whole, and end the command."""
    from CNCStepper.job.prove_file import prove_file

    with TemporaryDirectory(prefix="cncstepper-check-") as folder:
        try:
            with Progress(f"checking {program.name}") as progress:
                proof = prove_file(
                    program,
                    machine,
                    dialect=language,
                    start=start,
                    stock=stock,
                    tools=tool,
                    spool=Path(folder) / "sent" if certificate else None,
                    share=progress.share,
                )
        except ProgramError as error:
            _end_unread(refusals_of_file(program, start, language) or [error], program)
        _conclude(proof, program, json_path, certificate)


def _require_readable(text: str, start: Start | None, language: str, program: Path) -> None:
    """End the command with status 1, telling why, where lines of a program cannot be read or sent."""
    from CNCStepper.gcode.read_back import refused_lines

    with Progress(f"reading {program.name}"):
        refused = list(refused_lines(text, start, language, str(program)))
    if refused:
        _end_unread(refused, program)


def refusals_of_file(program: Path, start: Start | None, language: str) -> list[ProgramError]:
    """Return why lines of a long program are refused, the first of them."""
    from CNCStepper.gcode.read_back import MOST_REFUSALS
    from CNCStepper.gcode.read_file import FileReading

    with Progress(f"reading {program.name}") as progress:
        reading = FileReading(program, start, language, progress=progress.share)
        return list(islice(reading.refusals(), MOST_REFUSALS))


def _end_unread(refused: list[ProgramError], program: Path) -> NoReturn:
    """End the command with status 1, telling why."""
    for error in refused:
        click.echo(str(error))
    click.echo(f"{program}: refused; it cannot be read")
    add_conversion(refused[0], click.get_current_context())
    show_hints(refused)
    sys.exit(1)


def earlier_parts(job: Job, machine: Machine, part: int | None) -> list[Proof]:
    """Return the proofs of the job's programs before this one; raises a usage error where nobody says which it is."""
    from CNCStepper.job.make import is_split, make_parts
    from CNCStepper.job.prove import prove_parts

    if not is_split(job, machine):
        if part is not None:
            raise click.UsageError("--part goes with a job that is split into a program a tool")
        return []
    parts = make_parts(job, machine)
    if part is None or part > len(parts):
        raise click.UsageError(f"the job is split into {len(parts)} programs: say with --part which of them this is")
    return list(prove_parts(job, machine, parts[: part - 1], Path()))
