# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper edit VERB PROGRAM`: change a program, show the difference, and write it on request."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.findings_output import save
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import MOST, NumbersType, NumberType
from CNCStepper.cli.common.path_types import OutputFolder
from CNCStepper.cli.common.verb import Verbs
from CNCStepper.cli.editing.edit_options import Opened, editing_options, reading_options
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.gcode.edit.edit_result import Edited


class _Place(click.ParamType):
    """X,Y in mm with decimal points."""

    name = "X,Y"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, float]:
        if isinstance(value, tuple):
            return value
        try:
            x, y = (float(part) for part in value.split(","))
        except ValueError:
            x = y = float("nan")
        if not max(abs(x), abs(y)) < MOST:
            self.fail(
                Text("'{value}' is not two numbers in mm with decimal points, such as 50,35", value=value), param, ctx
            )
        return x, y


@click.group("edit", cls=Verbs)
def command() -> None:
    """Change a program: VERB --help describes each verb.

    The difference is shown, and nothing is written until --out FILE or --in-place says where. Comments, order and
    form stay; only the words that must change do. Every new program is read again and compared with what it must be,
    and with --machine (and --stock, --tool) checked as `cncstepper check` does: one with errors that the old one had
    not is refused.
    """


@command.command("offset")
@click.option(
    "--x",
    type=NumberType(),
    default=0.0,
    help="How far to move along X, mm; a lathe's diameter changes by twice as much.",
)
@click.option("--y", type=NumberType(), default=0.0, help="How far to move along Y, mm.")
@click.option("--z", type=NumberType(), default=0.0, help="How far to move along Z, mm.")
@editing_options
def _offset(opened: Opened, x: float, y: float, z: float) -> Edited:
    """Move the whole path: --x 25 --y -10."""
    from CNCStepper.gcode.edit.transform_verbs import offset

    return offset(opened.text, x, y, z, **opened.reading)


@command.command("scale", short_help="Make the path larger or smaller: --factor 1.02.")
@click.option("--factor", type=NumberType(above=0), help="All axes times this.")
@click.option("--x", type=NumberType(above=0), help="X times this.")
@click.option("--y", type=NumberType(above=0), help="Y times this.")
@click.option("--z", type=NumberType(above=0), help="Z times this.")
@click.option("--about", type=NumbersType(), default="0,0,0", show_default=True, help="The point that stays.")
@editing_options
def _scale(
    opened: Opened, factor: float | None, x: float | None, y: float | None, z: float | None, about: tuple
) -> Edited:
    """Make the path larger or smaller: --factor 1.02, or --x 2 --y 2 and Z as it is. Feeds stay.

    Arcs need the same factor for both axes of their plane.
    """
    from CNCStepper.gcode.edit.transform_verbs import scale

    if factor is None and x is y is z is None:
        raise click.UsageError(Text("give --factor, or some of --x, --y, --z"))
    every = 1.0 if factor is None else factor
    by_x, by_y, by_z = (every if own is None else own for own in (x, y, z))
    return scale(opened.text, by_x, by_y, by_z, about, **opened.reading)


@command.command("rotate")
@click.option("--angle", type=NumberType(), required=True, help="Degrees, counter-clockwise seen from above.")
@click.option("--about", type=_Place(), default="0,0", show_default=True, help="The point that stays.")
@editing_options
def _rotate(opened: Opened, angle: float, about: tuple[float, float]) -> Edited:
    """Turn the path about Z: --angle 90 --about 50,35."""
    from CNCStepper.gcode.edit.transform_verbs import rotate

    return rotate(opened.text, angle, about, **opened.reading)


@command.command("mirror")
@click.option(
    "--axis",
    type=click.Choice(["x", "y"], case_sensitive=False),
    required=True,
    help="The coordinate that changes its sign.",
)
@click.option(
    "--at", type=NumberType(), default=0.0, show_default=True, help="Where on that axis the mirror stands, mm."
)
@editing_options
def _mirror(opened: Opened, axis: str, at: float) -> Edited:
    """Make the mirror image: --axis x turns left into right. Climb milling becomes conventional."""
    from CNCStepper.gcode.edit.transform_verbs import mirror

    return mirror(opened.text, axis, at, **opened.reading)


@command.command("units")
@click.option(
    "--to", "units", type=click.Choice(["mm", "inch"], case_sensitive=False), required=True, help="The units to write."
)
@editing_options
def _units(opened: Opened, units: str) -> Edited:
    """Write the same path in mm (G21) or inches (G20)."""
    from CNCStepper.gcode.edit.transform_verbs import convert_units

    return convert_units(opened.text, units, **opened.reading)


@command.command("feeds")
@click.option(
    "--factor", type=NumberType(above=0), required=True, help="Every F word times this: 0.8 is a fifth slower."
)
@editing_options
def _feeds(opened: Opened, factor: float) -> Edited:
    """Make all feeds faster or slower: --factor 0.8."""
    from CNCStepper.gcode.edit.feed_scaling import scale_feeds

    return scale_feeds(opened.text, factor, **opened.reading)


@command.command("renumber")
@click.option("--first", type=click.IntRange(min=0), default=10, show_default=True, help="The first number.")
@click.option("--step", type=click.IntRange(min=1), default=10, show_default=True, help="From one to the next.")
@click.option("--remove", is_flag=True, help="Take all N words out instead.")
@editing_options
def _renumber(opened: Opened, first: int, step: int, remove: bool) -> Edited:
    """Give every line with code an N word: N10, N20, N30."""
    from CNCStepper.gcode.edit.renumber import renumber, without_numbers

    if remove:
        return without_numbers(opened.text, **opened.reading)
    return renumber(opened.text, first, step, **opened.reading)


@command.command("replace", short_help="Find and replace in the code: PROGRAM F800 F650.")
@click.option("--regex", is_flag=True, help="FIND is a regular expression, NEW may name its groups: \\1.")
@click.option("--comments", is_flag=True, help="Look in comments too.")
@click.option("--ignore-case", is_flag=True, help="f800 and F800 are the same.")
@editing_options
@click.argument("find")
@click.argument("new")
def _replace(opened: Opened, find: str, new: str, regex: bool, comments: bool, ignore_case: bool) -> Edited:
    """Put NEW in place of FIND in the code of every line: PROGRAM F800 F650 (F8000 is another number and stays)."""
    from CNCStepper.gcode.edit.find_replace import replace

    return replace(opened.text, find, new, regex, comments, ignore_case, **opened.reading)


@command.command("reverse", short_help="Cut every contour the other way round.")
@editing_options
def _reverse(opened: Opened) -> Edited:
    """Cut every contour the other way round: climb milling becomes conventional.

    Plunges, spindle, coolant and the order of the contours stay. Refused where that is unsafe, such as ramps.
    """
    from CNCStepper.gcode.edit.reverse_passes import reverse

    return reverse(opened.text, **opened.reading)


def _split_names(parameters: Mapping[str, Any]) -> dict[str, str]:
    """Return the names of the programs that the program is split into."""
    program: Path = parameters["program"]
    return {rf"{re.escape(program.stem)}-\d+-T\d+{re.escape(program.suffix or '.nc')}": "program"}


@command.command("split", short_help="Make a program for each tool: --out FOLDER.")
@click.option("-o", "--out", type=OutputFolder(_split_names), help="Folder for the programs.")
@reading_options
def _split(opened: Opened, out: Path | None) -> None:
    """Make a program for each tool: FOLDER/NAME-1-T1.nc, NAME-2-T4.nc and so on.

    Each sets all modes at its begin and switches off at its end.
    """
    from CNCStepper.gcode.edit.split_by_tool import split

    programs = split(opened.text, **opened.reading)
    for program in programs:
        opened.check(program.text)
    for program in programs:
        name = f"{opened.path.stem}-{program.number}-T{program.tool}{opened.path.suffix or '.nc'}"
        if out:
            save(out / name, opened.form.encoded(program.text))
        show_text(
            "{name}: tool {tool}, {lines} lines",
            name=out / name if out else name,
            tool=program.tool,
            lines=len(program.text.splitlines()),
        )
    if not out:
        show_text("{path}: not written; add --out FOLDER", err=True, path=opened.path)
