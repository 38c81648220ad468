# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper compare`: two programs by what their moves do, as figures and as one picture."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import write_report
from CNCStepper.cli.common.language import look_up, show_text, translated
from CNCStepper.cli.common.lathe_options import LatheOptions, lathe_options
from CNCStepper.cli.common.options import DialectType, FilePath, NumberType, read_program
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.program_options import ProgramOptions, program_options
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.profile import Machine, load_machine
from CNCStepper.tolerances import SAME_PATH_MM

if TYPE_CHECKING:
    from CNCStepper.job.comparison.compare_programs import PartOf, ProgramComparison

NAME_COLUMN, VALUE_COLUMN = 24, 26
DIFFER = 1  # the exit status, as of `diff`


@click.command("compare", cls=Verb)
@click.argument("first", type=FilePath)
@click.argument("second", type=FilePath)
@program_options()
@lathe_options
@click.option("-o", "--out", type=OutputPath("picture"), help="Draw both paths over each other: .png or .svg.")
@click.option("--json", "json_path", type=OutputPath("report"), help="Also write the comparison there.")
@click.option("--second-dialect", type=DialectType, help="How SECOND is read. [default: as FIRST]")
@click.option(
    "--tolerance",
    "same_mm",
    type=NumberType(above=0.0),
    default=SAME_PATH_MM,
    show_default=True,
    help="How far apart paths may be that are one, mm.",
)
@click.option(
    "--part",
    type=click.IntRange(1),
    help="Which program of a lathe's job both are, where the machine wants one a tool.",
)
def command(
    first: Path,
    second: Path,
    out: Path | None,
    json_path: Path | None,
    second_dialect: str | None,
    same_mm: float,
    part: int | None,
    given: ProgramOptions,
    lathe: LatheOptions,
) -> None:
    """Compare the motion of the programs FIRST and SECOND: what only one has, where they part, how far they are apart.

    Comments, line numbers, units, modal words, arcs written as chords and lines divided otherwise make no difference.
    Times are the job's machine's or table-a's unless told. With --stock and --tool, --bar and --turning-tool, or --job,
    the parts that both cut are compared too: of a lathe their exact profiles, diameter by diameter. Exit 0 where the
    motion is the same, 1 where it differs.
    """
    from CNCStepper.job.comparison.compare_programs import ComparedProgram, compare_programs, report_of

    given.check_stock()
    turns = lathe.turns(given)
    machine = given.job_and_machine()[1] or load_machine("mini-lathe" if turns else "table-a")
    dialect, start = given.dialect_on(machine), given.start_options.start()
    if job := given.job_and_machine()[0]:
        start = job.started(start, machine)
    if part is not None and not turns:
        raise click.UsageError(Text("--part goes with the --job of a lathe"))
    texts = [read_program(first), read_program(second)]
    programs, milled = [], job is not None or given.stock is not None
    for path, text, language in zip((first, second), texts, (dialect, second_dialect or dialect), strict=True):
        setup = lathe.setup(texts, given, machine, language, start, part) if turns else (None, start)
        programs.append(ComparedProgram(str(path), text, language, setup[1], setup[0], milled))
    with Progress("comparing") as progress:
        words: dict[str, Any] = {"machine": machine, "same_mm": same_mm, "share": progress.share}
        found = compare_programs(*programs, part_of=None if turns else _part_of(given, machine), **words)
    _show(found)
    if out is not None:
        _draw(out, found)
    if json_path is not None:
        write_report(json_path, report_of(found))
    sys.exit(0 if found.paths.same else DIFFER)


def _part_of(given: ProgramOptions, machine: Machine) -> PartOf | None:
    """Return what cuts the stock of the options by a mill's program, None without stock and tools."""
    from CNCStepper.job.prove import tools_of
    from CNCStepper.simulation.removal.heightmap import height_map

    job = given.job_and_machine()[0]
    stock = job.stock.stock() if job else given.stock
    tools = tools_of(job.on(machine)) if job else given.tool
    if stock is None or tools is None:
        return None
    return lambda program, path: height_map(path, tools, stock)


def _show(found: ProgramComparison) -> None:
    """Print the figures side by side, and then what differs."""
    from CNCStepper.job.comparison.compare_programs import rows, sentences

    names = (Path(name).name for name in found.names)
    click.echo("".join([" " * NAME_COLUMN, *(f"{name:>{VALUE_COLUMN}}" for name in names)]))
    for name, *values in rows(found):
        click.echo(f"{translated(name):<{NAME_COLUMN}}" + "".join(f"{value:>{VALUE_COLUMN}}" for value in values))
    for sentence in sentences(found):
        show_text(sentence)


def _draw(out: Path, found: ProgramComparison) -> None:
    """Draw the picture, in the language of the command line."""
    from CNCStepper.job.comparison.comparison_picture_file import save_picture
    from CNCStepper.job.comparison.turned_picture_words import TURNED_WORDS

    out.parent.mkdir(parents=True, exist_ok=True)
    words = {key: look_up(text) for key, text in TURNED_WORDS.items()}
    save_picture(out, found, [translated(found.verdict)], words)
    show_text("{out}: written", out=out)
