# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper drawing`: lists the chains and problems of a drawing, and mends it."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import save
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.drawing.reading_options import ReadingOptions, reading_options
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.drawing.drawing import Drawing
    from CNCStepper.drawing.repair.mend import Change
    from CNCStepper.drawing.repair.problems import Problem

LISTED = 20  # of each kind of problem, and of what was left out
Length0 = NumberType(kind="tolerance")


@click.command("drawing", cls=Verb)
@click.argument("file", type=FilePath)
@click.option("--picture", type=OutputPath("picture"), help="Draw it, with what is wrong marked: .png or .svg.")
@click.option("--json", "json_path", type=OutputPath(""), help="Write a list of its chains as JSON.")
@click.option("--mend", is_flag=True, help="Join, close and take out what is wrong within the limits; -o writes it.")
@click.option("-o", "--out", type=OutputPath("drawing"), help="Write the drawing, mended or not: .dxf or .svg.")
@click.option("--close", "close_mm", type=Length0, default=0.5, show_default=True, help="Gaps closed by a line, mm.")
@click.option("--tiny", "tiny_mm", type=Length0, default=0.02, show_default=True, help="Chains left out up to, mm.")
@click.option("--double", "double_mm", type=Length0, default=0.005, show_default=True, help="Lines that are one, mm.")
@click.option("--fit", "fit_mm", type=Length0, help="With --mend, polylines become arcs and fewer lines, mm.")
@reading_options
def command(
    file: Path,
    picture: Path | None,
    json_path: Path | None,
    mend: bool,
    out: Path | None,
    close_mm: float,
    tiny_mm: float,
    double_mm: float,
    fit_mm: float | None,
    reading: ReadingOptions,
) -> None:
    """Print what is in the drawing FILE and what is wrong with it: layers, colours, lengths, gaps, doubles, crossings.

    Nothing is mended without --mend; every change is then printed. A CadQuery or build123d script (.py) is run, in a
    process that may take 60 s and 4 GB and writes nothing. Exit 0 where the file was read, 1 where it is refused.
    """
    from CNCStepper.drawing.repair.mend import mended
    from CNCStepper.drawing.repair.problems import RepairLimits, problems_of
    from CNCStepper.job.drawings.read_any import read_named_drawing

    limits = RepairLimits(
        join_mm=reading.join_mm, close_mm=close_mm, double_mm=double_mm, tiny_mm=tiny_mm, fit_mm=fit_mm or 0.0
    )
    with Progress(Text("reading {name}", name=file.name)) as progress:
        drawing = read_named_drawing(file, reading.read_options(near_mm=close_mm), progress.share)
        progress.doing(Text("looking at {name}", name=file.name))
        changes: tuple[Change, ...] = ()
        if mend:
            drawing, changes = mended(drawing, limits)
        problems = problems_of(drawing, limits)
    for line in [*_lines(file, drawing), *_change_lines(changes), *_problem_lines(problems)]:
        click.echo(line)
    _write(file, drawing, problems, picture, json_path, out)


def _write(
    file: Path, drawing: Drawing, problems: tuple[Problem, ...], picture: Path | None, chains: Path | None,
    out: Path | None,
) -> None:  # fmt: skip
    from CNCStepper.drawing.chain_list import chain_rows
    from CNCStepper.drawing.writers.write_drawing import drawing_bytes

    if chains:
        save(chains, (json.dumps(chain_rows(drawing), indent=1, ensure_ascii=False) + "\n").encode("utf-8"))
    if out:
        save(out, drawing_bytes(drawing, out.suffix))
    if picture:
        from CNCStepper.simulation.views.drawing_picture import save_drawing_picture

        picture.parent.mkdir(parents=True, exist_ok=True)
        save_drawing_picture(picture, drawing, file.name, problems)
    for path in (chains, out, picture):
        if path:
            show_text("{path}: written", path=path)


def _lines(file: Path, drawing: Drawing) -> Iterator[str]:
    """Yield what was read: format, unit, size, layers, what was left out."""
    from CNCStepper.drawing.chain_list import counts_of, drawing_box_mm

    left, low, right, high = drawing_box_mm(drawing.chains)
    kind = file.suffix.lstrip(".").upper()
    yield f"{file}: {kind}, unit {drawing.unit_mm:g} mm"
    yield f"size {right - left:.6g} x {high - low:.6g} mm, from X{left:.3f} Y{low:.3f} to X{right:.3f} Y{high:.3f}"
    for count in counts_of(drawing.chains):
        colour = f" {count.colour}" if count.colour else ""
        kinds = ", ".join(f"{number} {word}" for number, word in ((count.closed, "closed"), (count.open, "open")))
        yield f"layer '{count.layer}'{colour}: {kinds}, {count.length_mm:.6g} mm"
    if drawing.damage:
        yield f"warning: the file is damaged, a part of it may be missing: {drawing.damage}"
    yield from (f"warning: {warning}" for warning in drawing.warnings)
    skipped = [f"left out: {each.kind} {each.handle} on layer '{each.layer}': {each.why}" for each in drawing.skipped]
    yield from _first(skipped, "left out")


def _change_lines(changes: Sequence[Change]) -> Iterator[str]:
    from CNCStepper.drawing.repair.mend import CHANGES

    for kind, own in _by_kind(changes, CHANGES):
        yield f"mended: {CHANGES[kind]}: {len(own)}"
        yield from _first([f"  {change.text}" for change in own], f"  {kind}")


def _problem_lines(problems: tuple[Problem, ...]) -> Iterator[str]:
    """Yield the problems with the numbers that they have in the picture."""
    from CNCStepper.drawing.repair.problems import KINDS

    numbers = {id(problem): number for number, problem in enumerate(problems, start=1)}
    for kind, own in _by_kind(problems, KINDS):
        yield f"problem: {KINDS[kind]}: {len(own)}"
        yield from _first([f"  {numbers[id(problem)]}: {problem.text}" for problem in own], f"  {kind}")


def _by_kind(items: Sequence[Any], kinds: Iterable[Any]) -> Iterator[tuple[Any, list[Any]]]:
    """Yield each kind of which there is one, with its items."""
    for kind in kinds:
        if own := [item for item in items if item.kind == kind]:
            yield kind, own


def _first(lines: list[str], of_what: str) -> Iterator[str]:
    yield from lines[:LISTED]
    if len(lines) > LISTED:
        yield f"{of_what}: {len(lines) - LISTED} more"
