# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper time`: how long a program takes on a machine."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.options import dialect_name, dialect_option, machine_option, program_argument, read_program
from CNCStepper.machine.profile import Machine


@click.command("time")
@program_argument
@machine_option(required=True)
@dialect_option
def command(program: Path, machine: Machine, dialect: str | None) -> None:
    """Print the seconds that PROGRAM takes on the machine, from its planner; one number on the last line.

    The machine stands at its zero when the program begins. Pauses (M0) count as no time.
    """
    from CNCStepper.gcode.interpret import interpret
    from CNCStepper.motion.plan import duration_s
    from CNCStepper.state import Start

    toolpath = interpret(read_program(program), Start.at_zero(), dialect_name(dialect, machine), str(program))
    click.echo(f"{duration_s(toolpath, machine):.3f}")
