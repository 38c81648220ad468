# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper job`: a drawing and a template of the shop in; a job file out."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.findings_output import save
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text


@click.command("job", cls=Verb)
@click.argument("drawing", type=FilePath)
@click.option("--template", type=FilePath, required=True, help="Machine, tools and rules of the shop, a TOML file.")
@click.option("-o", "--out", type=OutputPath("job"), required=True, help="The job file that is written.")
@click.option(
    "--thickness", "thickness_mm", type=NumberType(kind="depth"), help="Of the stock. [default: the template's]"
)
@click.option("--material", default="", help="Of the stock. [default: as the template says]")
@click.option("--unit-mm", type=NumberType(kind="unit"), help="The length of the drawing's unit, where it is wrong.")
@click.option("--strict", is_flag=True, help="Refuse a drawing of which no rule takes some chains.")
def command(
    drawing: Path,
    template: Path,
    out: Path,
    thickness_mm: float | None,
    material: str,
    unit_mm: float | None,
    strict: bool,
) -> None:
    """Make a job file of DRAWING by the rules of a template, which `cncstepper run` then makes a program of.

    The job names the drawing and follows it when it changes. Chains that no rule takes are printed with their number;
    with --strict they are refused. A CadQuery or build123d script (.py) is run once, here: its outline is written
    beside the job as DXF, which the job names, for a job runs no script.
    """
    from CNCStepper.drawing.read_drawing import SCRIPT
    from CNCStepper.job.templates.drawing_job import job_of_drawing
    from CNCStepper.job.templates.script_drawing import drawing_of_script
    from CNCStepper.job.templates.template import read_template

    rules = read_template(template)
    out.parent.mkdir(parents=True, exist_ok=True)
    with Progress(Text("reading {name}", name=drawing.name)) as progress:
        if drawing.suffix.casefold() == SCRIPT:
            drawing = drawing_of_script(rules, drawing, out, progress.share)
            show_text("{drawing}: written, what the script draws", drawing=drawing)
        made = job_of_drawing(
            rules, drawing, out, thickness_mm=thickness_mm, material=material, unit_mm=unit_mm, strict=strict,
            share=progress.share,
        )  # fmt: skip
    for title, count in made.counts:
        show_text("{title}: {count} chains", title=title, count=count)
    for note in made.job.notes:
        show_text("note: {note}", note=note)
    for untaken in made.untaken:
        layer = f"layer '{untaken.layer}' {untaken.colour}".strip()
        show_text("warning: no rule takes {open} chains: {layer}", open=untaken.closed + untaken.open, layer=layer)
    save(out, made.text.encode("utf-8"))
    size = " x ".join(f"{length:g}" for length in made.job.stock.size_mm)
    show_text("{out}: {operation} operations, stock {size} mm", out=out, operation=len(made.job.operation), size=size)
