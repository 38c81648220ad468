# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper time`: how long a program takes on a machine."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.chart_options import ChartOptions, chart_options
from CNCStepper.cli.common.lathe_options import show_x_of_file
from CNCStepper.cli.common.options import dialect_option, machine_option, program_argument, read_program
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.start_state_options import StartOptions, start_options
from CNCStepper.cli.common.streamed_program import program_chunks
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.state import Start
    from CNCStepper.toolpath import Chunk, Toolpath


@click.command("time", cls=Verb)
@program_argument
@machine_option(required=True)
@dialect_option
@start_options
@chart_options
def command(program: Path, machine: Machine, dialect: str | None, given: StartOptions, cut: ChartOptions) -> None:
    """Print the seconds that PROGRAM takes on the machine, from its planner; one number on the last line.

    Unless told, the machine stands at the work zero when the program begins, as in `check` and in the report of `run`.
    Pauses (M0) count as no time. Of a lathe program it says whether X is a diameter or a radius.
    """
    from CNCStepper.errors import ProgramError
    from CNCStepper.state import Start

    language = cut.language(dialect, machine)
    show_x_of_file(program, language, machine, err=True)
    text = None if program.is_file() else read_program(program)  # a pipe can be read only once

    def taken_s(start: Start) -> float:
        with Progress(Text("timing {name}", name=program.name)) as progress:
            return _taken_s(*program_chunks(program, start, language, progress, text), machine, language)

    try:
        seconds = taken_s(given.on(Start()))
    except ProgramError as error:
        if error.code != "unknown-position":
            raise
        seconds = taken_s(given.on(Start.at_zero()))  # it begins with an incremental move, which no check lets pass
    click.echo(f"{seconds:.3f}")


def _taken_s(path: Toolpath, chunks: Iterator[Chunk], machine: Machine, language: str) -> float:
    """Return the time of the motors' path, s, begun as a proof begins it."""
    from CNCStepper.gcode.wire.backlash_compensation import backlash_of
    from CNCStepper.motion.planner.backlash_moves import motor_chunks, way_duration_s
    from CNCStepper.motion.planner.plan import begun_chunks

    if play := backlash_of(machine, language):
        path, chunks = motor_chunks(path, chunks, play)
    begun, known = begun_chunks(path, chunks)
    if machine.interpolation != "planner":
        from CNCStepper.motion.interpolation.dda_stream import DdaTimes

        times = DdaTimes(begun, machine, known)
        deque(times.row_ends_s(), maxlen=0)
        return times.whole_s
    return way_duration_s(begun, known, machine)
