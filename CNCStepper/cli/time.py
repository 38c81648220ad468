# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper time`: how long a program takes on a machine."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.options import (
    dialect_name,
    dialect_option,
    machine_option,
    program_argument,
)
from CNCStepper.cli.progress import Progress
from CNCStepper.cli.reading import straight_chunks
from CNCStepper.cli.start import Given, start_options
from CNCStepper.machine.profile import Machine


@click.command("time")
@program_argument
@machine_option(required=True)
@dialect_option
@start_options
def command(program: Path, machine: Machine, dialect: str | None, given: Given) -> None:
    """Print the seconds that PROGRAM takes on the machine, from its planner; one number on the last line.

    Unless told, the machine stands at its zero when the program begins. Pauses (M0) count as no time.
    """
    from CNCStepper.gcode.take_up import play_of
    from CNCStepper.motion.backlash import way_duration_s
    from CNCStepper.state import Start

    language = dialect_name(dialect, machine)
    with Progress(f"timing {program.name}") as progress:
        path, chunks = straight_chunks(program, given.on(Start.at_zero()), language, progress)
        taken_s = way_duration_s(path, chunks, machine, play_of(machine, language))
    click.echo(f"{taken_s:.3f}")
