# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper arrange`: several programs, placed, turned and counted, as one checked program."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import save, show_findings
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import (
    FilePath,
    NumberType,
    dialect_name,
    dialect_option,
    machine_option,
    program_bytes,
)
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.quantities import QUANTITIES

if TYPE_CHECKING:
    from CNCStepper.gcode.edit.arrange import Copy
    from CNCStepper.job.editing.arrangement import Program
    from CNCStepper.machine.profile import Machine

MOST_MM = QUANTITIES["coordinate"].most


class _Numbers(click.ParamType):
    """Numbers with decimal points, or whole ones, joined by a separator."""

    def __init__(
        self, name: str, separator: str, counts: tuple[int, ...], least: float, number: Callable[[str], float] = float
    ):
        self.name, self._separator, self._counts = name, separator, counts
        self._least, self._number = least, number

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        try:
            numbers = tuple(self._number(part) for part in str(value).lower().split(self._separator))
        except ValueError:
            numbers = ()
        if len(numbers) not in self._counts or not all(self._least <= number <= MOST_MM for number in numbers):
            self.fail(Text("'{value}' is not {name}", value=value, name=self.name), param, ctx)
        return numbers


SizeType = _Numbers("X,Y", ",", (2,), 0.001)


@click.command("arrange", cls=Verb)
@click.argument("programs", type=FilePath, nargs=-1, required=True)
@click.option("-o", "--out", type=OutputPath("program"), required=True, help="Write the whole program there.")
@click.option(
    "--count", type=click.IntRange(1, 2000), multiple=True, help="Copies of each program in turn. [default: 1]"
)
@click.option("--at", type=_Numbers("X,Y[,DEG]", ",", (2, 3), -MOST_MM), multiple=True, help="A copy's work zero.")
@click.option("--grid", type=_Numbers("COLUMNSxROWS", "x", (2,), 1, int), help="In rows: 3x2. One program fills it.")
@click.option("--sheet", type=SizeType, help="Nest on a sheet of that size, from 0, 0.")
@click.option("--turn", is_flag=True, help="With --sheet, also by 90, 180 and 270 degrees.")
@click.option("--gap", "gap_mm", type=NumberType(above=-1e-9), default=5.0, show_default=True, help="Between cuts, mm.")
@click.option(
    "--diameter", "diameter_mm", type=NumberType(above=-1e-9), default=0.0, show_default=True, help="Of the tool, mm."
)
@click.option("--allow-overlap", is_flag=True, help="Copies may cut into each other.")
@dialect_option
@machine_option(required=False)
def command(
    programs: tuple[Path, ...],
    out: Path,
    count: tuple[int, ...],
    at: tuple[tuple[float, ...], ...],
    grid: tuple[float, ...] | None,
    sheet: tuple[float, ...] | None,
    turn: bool,
    gap_mm: float,
    diameter_mm: float,
    allow_overlap: bool,
    dialect: str | None,
    machine: Machine | None,
) -> None:
    """Make one program of PROGRAMS, each placed, turned and counted: --at 10,20,90, --grid 3x2 or --sheet 600,400.

    Arcs stay arcs, units follow the first program, and each tool is changed to once where the order of work allows it.
    Each copy is an operation, at which a restart may begin. The result is read back and, with --machine, checked.
    """
    from CNCStepper.job.editing.arrangement import arranged_and_checked

    language = dialect_name(dialect, machine)
    if sum(map(bool, (at, grid, sheet))) > 1:
        raise click.UsageError(Text("give one of --at, --grid and --sheet"))
    read = _programs(programs, count, grid, language, diameter_mm / 2.0)
    copies = _copies(read, at, grid, sheet, gap_mm, turn)
    text, errors = arranged_and_checked(read, copies, language, str(out), machine, allow_overlap)
    if errors:
        show_findings(errors)
        show_text("{out}: not written; the arranged program would be refused", err=True, out=out)
        sys.exit(1)
    save(out, text.encode("utf-8"))
    for copy in copies:
        click.echo(copy.title)
    show_text("{out}: {copies} copies of {read} programs", out=out, copies=len(copies), read=len(read))


def _programs(
    paths: tuple[Path, ...], count: tuple[int, ...], grid: tuple[float, ...] | None, language: str, radius_mm: float
) -> list[Program]:
    from CNCStepper.gcode.syntax.text_format import decoded
    from CNCStepper.job.editing.arrangement import program_of

    if len(count) not in (0, 1, len(paths)):
        raise click.UsageError(Text("give --count once, or once for each program"))
    whole = int(grid[0] * grid[1]) if grid and len(paths) == 1 and not count else 1
    counts = count * len(paths) if len(count) == 1 else count or (whole,) * len(paths)
    texts = [decoded(program_bytes(path))[0] for path in paths]
    return [
        program_of(str(path), text, number, language, radius_mm)
        for path, text, number in zip(paths, texts, counts, strict=True)
    ]


def _copies(
    programs: list[Program],
    at: tuple[tuple[float, ...], ...],
    grid: tuple[float, ...] | None,
    sheet: tuple[float, ...] | None,
    gap_mm: float,
    turn: bool,
) -> list[Copy]:
    from CNCStepper.job.editing.arrangement import at_places, in_grid, on_sheet

    if at:
        return at_places(programs, [(x, y, *(more or [0.0])) for x, y, *more in at])  # type: ignore[misc]
    if sheet:
        return on_sheet(programs, (sheet[0], sheet[1]), gap_mm, (0.0, 90.0, 180.0, 270.0) if turn else (0.0,))
    total = sum(program.count for program in programs)
    if grid and total > grid[0] * grid[1]:
        raise click.UsageError(
            Text("{total} copies do not fit into a grid of {grid:g}", total=total, grid=grid[0] * grid[1])
        )
    return in_grid(programs, int(grid[0]) if grid else total, gap_mm)
