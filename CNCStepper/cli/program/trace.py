# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper trace`: the canonical calls of a program, to be compared with `rs274 -g`."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.common.options import FilePath, linuxcnc_option, program_argument, read_program
from CNCStepper.cli.common.start_state_options import StartOptions, search_option
from CNCStepper.cli.common.verb import Verb


@click.command("trace", cls=Verb)
@program_argument
@linuxcnc_option
@click.option("--tool-table", type=FilePath, help="LinuxCNC's tool table, in inches. [default: that of its samples]")
@click.option("--parameters", type=FilePath, help="LinuxCNC's parameter file (.var), in inches. [default: all 0]")
@search_option
def command(
    program: Path, dialect: str | None, tool_table: Path | None, parameters: Path | None, search: tuple[str, ...]
) -> None:
    """Print the canonical calls of PROGRAM as `rs274 -g` prints them, read as LinuxCNC does unless told.

    --tool-table and --parameters are the files that `rs274 -t` and `rs274 -v` take: as there, the machine's own unit
    is the inch, whatever the program's is.
    """
    from CNCStepper.gcode.interpreter.canonical_trace import canonical_text, default_start

    start = StartOptions(parameters=parameters, tool_table=tool_table, search=search).on(default_start())
    for calls in canonical_text(read_program(program), start, dialect or "linuxcnc", str(program)):
        click.echo(calls, nl=False)
