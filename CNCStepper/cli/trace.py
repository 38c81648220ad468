# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper trace`: the canonical calls of a program, to be compared with `rs274 -g`."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.options import dialect_option, program_argument, read_program


@click.command("trace")
@program_argument
@dialect_option
def command(program: Path, dialect: str | None) -> None:
    """Print the canonical calls of PROGRAM as `rs274 -g` prints them, read as LinuxCNC does unless told."""
    from CNCStepper.gcode.trace import canonical_calls

    for call in canonical_calls(read_program(program), dialect or "linuxcnc", str(program)):
        click.echo(call)
