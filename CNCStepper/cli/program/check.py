# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper check`: errors and warnings of a program on a machine, before it moves anything.

A program that comes through a pipe, put into a file: what is checked is read more than once, but not held whole.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import partial
from itertools import islice
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any, NamedTuple, NoReturn

import click

from CNCStepper.cli.common.chart_options import ChartOptions, chart_options
from CNCStepper.cli.common.findings_output import show_figures, show_findings, write_report
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.lathe_options import LatheOptions, lathe_options, show_x_of_file
from CNCStepper.cli.common.option_hints import add_conversion, add_option_hint, show_hints
from CNCStepper.cli.common.options import program_argument, read_program
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.program_options import ProgramOptions, program_options
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.job_file import job_of
from CNCStepper.errors import ProgramError, Text
from CNCStepper.input_file import MB
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.job.model import Job
    from CNCStepper.job.prove import Proof
    from CNCStepper.job.prove_file import FileProof
    from CNCStepper.state import Start


@contextmanager
def regular_file(program: Path) -> Iterator[Path]:
    """Give the regular file of a program: its own, or for a pipe one that is removed when the block ends.

    Raises ProgramError, naming the program, for a line that is longer than any program's, and OSError on a full disk.
    """
    if program.is_file():
        yield program
        return
    from CNCStepper.gcode.interpreter.program_file import byte_pieces  # it loads the interpreter

    with TemporaryDirectory(prefix="cncstepper-pipe-") as folder:
        file = Path(folder) / "program.nc"
        with Progress(Text("reading {name}", name=program.name)) as progress, file.open("wb") as copy:
            read = 0
            for piece in byte_pieces(program):
                read += copy.write(piece)
                progress.doing(Text("reading {name}, {read_mb:.0f} MB so far", name=program.name, read_mb=read / MB))
        yield file


STAGES = {
    "read": Text("reading back"),
    "cut": Text("cutting the stock by"),
    "make": Text("making the shapes of"),
    "time": Text("timing"),
    "judge": Text("judging the part of"),
    "check": Text("checking"),
    "report": Text("reporting on"),
}


@click.command("check", cls=Verb)
@program_argument
@program_options(machine_required=True)
@lathe_options
@chart_options
@click.option(
    "--part", type=click.IntRange(1), help="Which program of the job it is, where the machine wants one a tool."
)
@click.option("--json", "json_path", type=OutputPath("report"), help="Also write the report there.")
@click.option("--certificate", type=OutputPath("certificate"), help="Also write the certificate there, for `send`.")
def command(
    program: Path,
    part: int | None,
    json_path: Path | None,
    certificate: Path | None,
    given: ProgramOptions,
    lathe: LatheOptions,
    cut: ChartOptions,
) -> None:
    """Check PROGRAM against a machine: travel, feeds, spindle; with --stock and --tool also rapids and plunges, with
    --job gouge and material left, clamps and the sheet's edge too. --bar and --turning-tool are those of a lathe.

    A job that is split into a program a tool needs --part: the programs before it are made anew and taken as cut. A
    lathe's program is found among those of its job by its moves, where --part does not say which it is.
    A block that moves is a line of PROGRAM, counted once however often it is run.
    Exit 0 clean, 1 refused; each finding is file:line:column: text. Where --work-zero is not given, the place of
    the program on the table is reported as unknown.
    """
    given.check_stock()
    machine, start = given.machine, given.start_options.start()
    assert machine  # the option is required
    asked = _Asked(program, machine, cut.language(given.dialect, machine), start, json_path, certificate)
    show_x_of_file(program, asked.language, machine)
    if lathe.turns(given):
        text = read_program(program)
        proof, _ = lathe.prove(text, given, machine, str(program), asked.language, start, part)
        _conclude(proof, program, json_path, certificate)
    job = job_of(given.job_path) if given.job_path else None
    with Progress(Text("{stage} {name}", stage=STAGES["make"], name=program.name)):
        earlier = prior_parts(job, machine, part) if job else []
    with regular_file(program) as file:
        if job and earlier:
            _check_after(earlier, job, file, asked)
        elif job:
            from CNCStepper.job.prove_job_file import prove_job_file

            _check_in_pieces(partial(prove_job_file, job), file, job.started(start, machine), asked)
        else:
            from CNCStepper.job.prove_file import prove_file

            prove = partial(prove_file, stock=given.stock, tools=given.tool, **cut.proof_words(machine))
            _check_in_pieces(prove, file, start, asked)


class _Asked(NamedTuple):
    """What the command line asks for; program: as it is named there."""

    program: Path
    machine: Machine
    language: str
    start: Start | None
    json_path: Path | None
    certificate: Path | None


def _check_after(earlier: list[Proof], job: Job, file: Path, asked: _Asked) -> NoReturn:
    """Check the program that a job's others have cut before, and end the command; all of them are held whole."""
    from CNCStepper.job.prove import prove_job

    program, machine = asked.program, asked.machine
    text = read_program(file)
    _require_readable(text, job.started(asked.start, machine), asked.language, program)
    words: dict[str, Any] = {"file": str(program), "dialect": asked.language, "start": asked.start}
    with Progress(Text("checking {name}", name=program.name)) as progress:
        words["tell"] = lambda stage: progress.doing(Text("{stage} {name}", stage=STAGES[stage], name=program.name))
        proof = prove_job(job, machine, text, earlier=earlier, share=progress.share, **words)
    _conclude(proof, program, asked.json_path, asked.certificate)


def _conclude(proof: Proof | FileProof, program: Path, json_path: Path | None, certificate: Path | None) -> NoReturn:
    """Show what was found, write what was asked for, and end the command."""
    show_findings(proof.findings)
    if json_path:
        write_report(json_path, proof.report)
    if certificate:
        from CNCStepper.cli.common.options import reproduce_options
        from CNCStepper.job.make_certificate import certificate_of

        certificate_of(proof).sending(made_with=reproduce_options()).write(certificate)
    show_figures(proof.report)
    verdict = Text("refused") if proof.refused else Text("clean")
    show_text(
        "{program}: {verdict}; {blocks} blocks that move, {time_s:.1f} s",
        program=program,
        verdict=verdict,
        blocks=proof.report["blocks"],
        time_s=proof.report["time_s"],
    )
    sys.exit(1 if proof.refused else 0)


def _check_in_pieces(prove: Callable[..., FileProof], file: Path, start: Start | None, asked: _Asked) -> NoReturn:
    """Check a program without holding it whole, and end the command; start: with which its lines are read."""
    program, certificate = asked.program, asked.certificate
    with TemporaryDirectory(prefix="cncstepper-check-") as folder:
        try:
            with Progress(Text("checking {name}", name=program.name)) as progress:
                proof = prove(
                    file,
                    asked.machine,
                    name=str(program),
                    dialect=asked.language,
                    start=asked.start,
                    sent=Path(folder) if certificate else None,
                    share=progress.share,
                    tell=lambda stage: progress.doing(Text("{stage} {name}", stage=STAGES[stage], name=program.name)),
                )
        except ProgramError as error:
            _end_unread(refusals_of_file(file, start, asked.language, str(program)) or [error], program)
        _conclude(proof, program, asked.json_path, certificate)


def _require_readable(text: str, start: Start | None, language: str, program: Path) -> None:
    """End the command with status 1 and the reason where lines of a program cannot be read or sent."""
    from CNCStepper.gcode.wire.read_back import refused_lines

    with Progress(Text("reading {name}", name=program.name)):
        refused = list(refused_lines(text, start, language, str(program)))
    if refused:
        _end_unread(refused, program)


def refusals_of_file(program: Path, start: Start | None, language: str, name: str = "") -> list[ProgramError]:
    """Return why lines of a long program are refused, the first of them; name: by which people know it."""
    from CNCStepper.gcode.interpreter.program_file import FileReading
    from CNCStepper.gcode.wire.read_back import MOST_REFUSALS

    with Progress(Text("reading {name}", name=Path(name or program).name)) as progress:
        reading = FileReading(program, start, language, progress=progress.share, name=name)
        return list(islice(reading.refusals(), MOST_REFUSALS))


def _end_unread(refused: list[ProgramError], program: Path) -> NoReturn:
    """End the command with status 1 and the reason."""
    context = click.get_current_context()
    for error in refused:
        show_text("{error}", error=error)
        add_option_hint(error, context)
    show_text("{program}: refused; it cannot be read", program=program)
    add_conversion(refused[0], context)
    show_hints(refused)
    sys.exit(1)


def prior_parts(job: Job, machine: Machine, part: int | None) -> list[Proof]:
    """Return the proofs of the job's programs before this one; raises a usage error where --part is missing."""
    from CNCStepper.job.make import is_split, make_parts
    from CNCStepper.job.prove import prove_parts

    if not is_split(job, machine):
        if part is not None:
            raise click.UsageError(Text("--part goes with a job that is split into a program a tool"))
        return []
    parts = make_parts(job, machine)
    if part is None or part > len(parts):
        raise click.UsageError(
            Text("the job is split into {parts} programs: say with --part which of them this is", parts=len(parts))
        )
    return list(prove_parts(job, machine, parts[: part - 1], Path()))
