# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper slice`: a solid as a stack of sheets."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputFolder
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.sheets.arrange import SizeType

if TYPE_CHECKING:
    from CNCStepper.job.slicing.solid_slices import Stack

PARTS = "front,middle,back"


def _names(params: Mapping[str, Any]) -> Mapping[str, str]:
    from CNCStepper.job.nesting import nest_files
    from CNCStepper.job.slicing import slice_files

    return slice_files.FILES | (nest_files.FILES if params.get("sheet") else {})


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
@click.option("--scale", type=NumberType(kind="factor"), default=1.0, show_default=True, help="mm of the file's unit.")
@click.option("--sheet", type=SizeType, help="Nest the pieces on sheets of that size.")
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
    gap_mm: float,
    margin_mm: float,
    time_s: float,
) -> None:
    """Cut the closed mesh SOLID (STL) into sheets of a thickness along an axis.

    DIR/slice-NNN.dxf has the outlines (layer CUT), registration holes and the number of each sheet; DIR/slices.json the
    places and volumes, DIR/assembled.png the stack. With --sheet the pieces are nested: sheet-N.dxf, placements.json.
    """
    from CNCStepper.drawing.solids.stl import MOST_BYTES, read_triangles
    from CNCStepper.errors import Place, placed
    from CNCStepper.input_file import read_input
    from CNCStepper.job.slicing.slice_files import write_stack
    from CNCStepper.job.slicing.solid_slices import sliced

    names = tuple(filter(None, (part.strip() for part in parts.split(",")))) or ("part",)
    with Progress("slicing"), placed(Place(str(solid))):
        triangles = read_triangles(read_input(solid, MOST_BYTES), Place(str(solid))) * scale
        stack = sliced(triangles, axis, thickness_mm, names, hole_mm)
    for note in stack.notes:
        click.echo(f"   note: {note}", err=True)
    paths = write_stack(stack, out, f"{solid.stem}, axis {axis.upper()}")
    share = stack.volume_mm3 / stack.solid_volume_mm3 - 1.0
    click.echo(f"{paths[0].parent}: {len(stack.slices)} sheets, {stack.volume_mm3:.6g} mm3, {share:+.3%} of the solid")
    if sheet:
        _nest(stack, (sheet[0], sheet[1]), gap_mm, margin_mm, time_s, out)


def _nest(
    stack: Stack, size_mm: tuple[float, float], gap_mm: float, margin_mm: float, time_s: float, out: Path
) -> None:
    from CNCStepper.job.nesting.nest_files import write_nest
    from CNCStepper.job.slicing.slice_files import nest_order
    from CNCStepper.nesting.nest import nest
    from CNCStepper.nesting.nesting_model import Budget

    order = nest_order(stack, size_mm, gap_mm, margin_mm)
    with Progress("nesting") as progress:
        budget = Budget(time_s, progress=progress.share)
        layout = nest(order.items, order.sheets, order.spacing, budget)
    write_nest(order, layout, out)
    click.echo(f"{len(layout.placements)} pieces on {len(layout.sheets)} sheets of {size_mm[0]:g} x {size_mm[1]:g} mm")
    sys.exit(1 if layout.unplaced else 0)
