# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper slice`: a solid as a stack of sheets."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputFolder
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.sheets.arrange import SizeType
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.job.slicing.solid_slices import Stack
    from CNCStepper.job.templates.template import Template
    from CNCStepper.nesting.nesting_model import Layout

PARTS = "front,middle,back"


def _names(params: Mapping[str, Any]) -> Mapping[str, str]:
    from CNCStepper.job.nesting import nest_files
    from CNCStepper.job.slicing import slice_files, slice_programs

    nested = nest_files.FILES if params.get("sheet") or params.get("template") else {}
    return slice_files.FILES | nested | (slice_programs.FILES if params.get("template") else {})


@click.command("slice", cls=Verb)
@click.argument("solid", type=FilePath)
@click.option("--thickness", "thickness_mm", type=NumberType(kind="depth"), required=True, help="Of the sheets, mm.")
@click.option("--axis", type=click.Choice(["x", "y", "z"], case_sensitive=False), default="z", show_default=True)
@click.option("-o", "--out", type=OutputFolder(_names), required=True, help="Folder for drawings, list and pictures.")
@click.option("--parts", default=PARTS, show_default=True, help="Names of the runs of sheets, from the lowest.")
@click.option(
    "--hole",
    "hole_mm",
    type=NumberType(above=-1e-9),
    default=3.0,
    show_default=True,
    help="Registration holes; 0: none.",
)
@click.option("--scale", type=NumberType(kind="factor"), default=1.0, show_default=True, help="mm of an STL's unit.")
@click.option(
    "--sheet",
    type=SizeType,
    help="Nest the pieces on sheets of that size. [default with --template: the template's, or the machine's travel]",
)
@click.option("--template", type=FilePath, help="Make a checked program of each nested sheet by this job template.")
@click.option("--machine", default="", help="In place of the template's: a profile's name or file.")
@click.option(
    "--gap", "gap_mm", type=NumberType(above=-1e-9), default=2.0, show_default=True, help="Between pieces, mm."
)
@click.option(
    "--margin", "margin_mm", type=NumberType(above=-1e-9), default=3.0, show_default=True, help="To the rim, mm."
)
@click.option("--time", "time_s", type=NumberType(kind="time"), default=20.0, show_default=True, help="To nest.")
def command(
    solid: Path,
    thickness_mm: float,
    axis: str,
    out: Path,
    parts: str,
    hole_mm: float,
    scale: float,
    sheet: tuple[float, ...] | None,
    template: Path | None,
    machine: str,
    gap_mm: float,
    margin_mm: float,
    time_s: float,
) -> None:
    """Cut SOLID (STL, STEP, BREP or FCStd) into sheets of a thickness along an axis.

    DIR/slice-NNN.dxf has the outlines (layer CUT), registration holes and the number of each sheet; DIR/slices.json the
    places and volumes, DIR/assembled.png the stack. With --sheet the pieces are nested: sheet-N.dxf, placements.json.
    With --template each nested sheet gets job, program, report and certificate: job-N.toml, job-N.nc. Its rules take
    the layers CUT, REGISTRATION and MARK. Exit 1 when a piece has no place or a sheet no sound program.
    """
    from CNCStepper.job.batch.sheet_template import sheet_size_mm
    from CNCStepper.job.slicing.make_slices import SOLIDS, sections_of
    from CNCStepper.job.slicing.slice_programs import on_sheets
    from CNCStepper.job.slicing.solid_slices import stack_of

    if scale != 1.0 and solid.suffix.casefold() in SOLIDS:
        raise click.UsageError(Text("--scale is for STL; {name} says its unit itself", name=solid.name))
    names = tuple(filter(None, (part.strip() for part in parts.split(",")))) or ("part",)
    shop = _template(template, machine)
    size_mm = (sheet[0], sheet[1]) if sheet else None
    if shop:
        size_mm = sheet_size_mm(shop, size_mm)
        shop = on_sheets(shop, size_mm)
    with Progress(Text("slicing")):
        stack = stack_of(sections_of(solid, axis.lower(), thickness_mm, scale), names, hole_mm)
    _write_stack(stack, out, f"{solid.stem}, axis {axis.upper()}")
    if size_mm is None:
        return
    layout = _nest(stack, size_mm, gap_mm, margin_mm, time_s, out)
    is_sound = shop is None or _make(shop, out, layout.sheets, thickness_mm)
    sys.exit(0 if is_sound and not layout.unplaced else 1)


def _write_stack(stack: Stack, out: Path, title: str) -> None:
    """Write the slices, and print their notes, how many they are and their volume."""
    from CNCStepper.job.slicing.slice_files import write_stack

    for note in stack.notes:
        show_text("   note: {note}", err=True, note=note)
    paths = write_stack(stack, out, title)
    share = stack.volume_mm3 / stack.solid_volume_mm3 - 1.0
    show_text(
        "{parent}: {slices} sheets, {volume_mm3:.6g} mm3, {share:+.3%} of the solid",
        parent=paths[0].parent,
        slices=len(stack.slices),
        volume_mm3=stack.volume_mm3,
        share=share,
    )


def _template(path: Path | None, machine: str) -> Template | None:
    """Return the template with another machine, where one is named; raises UsageError for a machine alone."""
    from CNCStepper.job.slicing.slice_programs import with_machine
    from CNCStepper.job.templates.template import read_template

    if path is None and machine:
        raise click.UsageError(Text("--machine needs --template: a template says how the sheets are cut"))
    return with_machine(read_template(path), machine) if path else None


def _nest(
    stack: Stack, size_mm: tuple[float, float], gap_mm: float, margin_mm: float, time_s: float, out: Path
) -> Layout:
    from CNCStepper.job.slicing.make_slices import nest_stack
    from CNCStepper.job.slicing.slice_files import nest_order

    with Progress(Text("nesting")) as progress:
        nested = nest_stack(nest_order(stack, size_mm, gap_mm, margin_mm), time_s, out, progress.share)
    layout = nested.layout
    for why in nested.unplaced:
        show_text("   not placed: {why}", err=True, why=why)
    show_text(
        "{placements} pieces on {sheets} sheets of {size_mm:g} x {size_mm2:g} mm",
        placements=len(layout.placements),
        sheets=len(layout.sheets),
        size_mm=size_mm[0],
        size_mm2=size_mm[1],
    )
    return layout


def _make(template: Template, out: Path, numbers: Sequence[int], thickness_mm: float) -> bool:
    """Write the programs of the sheets, print what became of each, and return whether all are sound."""
    from CNCStepper.job.slicing.slice_programs import write_programs

    with Progress(Text("making and proving")) as progress:
        made = []
        for each in write_programs(template, out, numbers, thickness_mm):
            made.append(each)
            progress.share(len(made) / len(numbers))
    for each in made:
        for why in (*each.refused, *([each.error] if each.error else [])):
            show_text("   sheet {number}: {why}", err=True, number=each.number, why=why)
    sound = [each for each in made if each.is_sound]
    show_text(
        "{sound} of {made} programs, {sound2:.1f} min",
        sound=len(sound),
        made=len(made),
        sound2=sum(each.time_s for each in sound) / 60.0,
    )
    return len(sound) == len(made)
