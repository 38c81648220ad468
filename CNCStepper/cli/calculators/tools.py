# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper tools`: the tools of a FreeCAD library, a tool bit or a LinuxCNC tool table, listed and converted."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.verb import Verb, check_further
from CNCStepper.machine.tools.stored_tool import StoredTool, given_keys
from CNCStepper.machine.tools.tool_files import files_of, read_tools, write_tools
from CNCStepper.output_files import Output
from CNCStepper.units import MM_PER_INCH


@click.command("tools", cls=Verb)
@click.argument("file", type=FilePath)
@click.option("--to", type=OutputPath(""), help="Write them there: .fctb, .fctl or .tbl.")
@click.option("--inch", is_flag=True, help="The lengths of a tool.tbl, read or written, are inches.")
def command(file: Path, to: Path | None, inch: bool) -> None:
    """List the tools of FILE: .fctb or .fctl of FreeCAD, .tbl of LinuxCNC; with --to convert them.

    It reports what it does not understand, guesses or does not write.
    """
    unit_mm = MM_PER_INCH if inch else 1.0
    tools = read_tools(file, unit_mm)
    if to is not None:
        check_further([Output(each, "--to") for each in files_of(tools, to)])
    for stored in tools:
        click.echo(f"{stored.number}: {stored.name or '-'}: {_words(stored)}")
        for note in stored.notes:
            show_text("   note: {note}", note=note)
    if to is not None:
        for note in write_tools(tools, to, unit_mm):
            show_text("   note: {note}", note=note)
        click.echo(f"{to}: {', '.join(str(stored.number) for stored in read_tools(to, unit_mm))}")


def _words(stored: StoredTool) -> str:
    if stored.tool is None:
        return "not a tool that cuts here"
    more = {
        key: value for key, value in given_keys(stored.tool).items() if key not in ("number", "shape", "diameter_mm")
    }
    told = ", ".join(
        f"{key} {value:.6g}" if isinstance(value, float) else f"{key} {value}" for key, value in more.items()
    )
    return f"{stored.tool.words}, {told}" if told else stored.tool.words
