# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper steps`: the signals of the motors with their times, as letters, bytes, port writes or edges."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.options import (
    NumberType,
    dialect_name,
    dialect_option,
    machine_option,
    program_argument,
    read_program,
)
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.start_state_options import StartOptions, start_options
from CNCStepper.cli.common.streamed_program import program_chunks
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.motion.signals.pulse_stream import PulseStream

FORMS = ("letters", "board", "coils", "parport", "csv", "vcd")
COILS = ("one_phase", "two_phases", "two_phases_a", "half_step", "bipolar")  # of motion.signals.coils.WIRES
LETTERS_TICKS_PER_S = 1_000_000
BLOCK_BYTES = 65_536
ALL = 2**62  # pulses: more than a file has


@click.command("steps", cls=Verb)
@program_argument
@machine_option(required=True)
@click.option(
    "--as",
    "form",
    type=click.Choice(FORMS),
    required=True,
    help="letters: one a pulse. board: a byte a pulse, four motors. coils: time and wires of each motor. "
    "parport: time, data and control register. csv: time and positions. vcd: every edge, for GTKWave or PulseView.",
)
@click.option(
    "--coils",
    type=click.Choice(COILS),
    help="With --as coils: full steps with one phase or two (two_phases_a: other wiring), half steps, or the signs "
    "on the wires of bipolar motors. [default: two_phases]",
)
@click.option("-o", "--out", type=OutputPath("signals"), help="Write there instead of printing.")
@click.option("--back", is_flag=True, help="The way back: every pulse again, from the last one to the first.")
@click.option("--back-from", "from_s", type=NumberType(), help="The same from this second of the program on.")
@click.option(
    "--letters-every", "every_ms", type=NumberType(above=0), help="PROGRAM holds pulse letters, one every so many ms."
)
@dialect_option
@start_options
def command(
    program: Path,
    machine: Machine,
    form: str,
    coils: str | None,
    out: Path | None,
    back: bool,
    from_s: float | None,
    every_ms: float | None,
    dialect: str | None,
    given: StartOptions,
) -> None:
    """Write every step of PROGRAM as the machine's motors and drives receive it.

    Unless told, the machine stands at its zero when the program begins; its planner times the steps, which take up the
    backlash of the axes. With interpolation = "dda" in the profile they are those of the published interpolators, each
    move from rest to rest; "published" has the printed registers of arcs too. The profile's [signals] say how long
    pulses are, which motors an axis has, and on which pins of a parallel port they are. Letters and board bytes have no
    time; digital outputs have no letter, and no device has a board byte or coils.
    """
    if coils and form != "coils":
        raise click.UsageError(Text("--coils belongs to --as coils"))
    with Progress(Text("stepping {name}", name=program.name)) as progress:
        if every_ms is not None:
            stream = _letters(program, every_ms, from_s, back or from_s is not None)
        else:
            stream = _planned(program, machine, dialect_name(dialect, machine), given, progress, from_s, back)
        _write(_coded(stream, machine, form, coils or "two_phases"), out)


def _planned(
    program: Path,
    machine: Machine,
    language: str,
    given: StartOptions,
    progress: Progress,
    from_s: float | None,
    back: bool,
) -> PulseStream:
    """Return the pulses of a program, which is read while they are made where they go forwards."""
    from CNCStepper.gcode.interpreter.interpret import interpret
    from CNCStepper.machine.backlash import Backlash
    from CNCStepper.motion.planner.backlash_moves import motor_chunks, motor_moves
    from CNCStepper.motion.planner.buffers import TICKS_PER_S
    from CNCStepper.motion.signals.pulse_stream import pulse_stream
    from CNCStepper.motion.signals.reverse_pulses import ReversePulses
    from CNCStepper.state import Start
    from CNCStepper.toolpath import require_straight_axes

    start, play = given.on(Start.at_zero()), Backlash.of(machine)
    if back or from_s is not None:
        if machine.interpolation != "planner":
            raise click.UsageError(Text("--back is by the planner: the profile's interpolation is another"))
        path = interpret(read_program(program), start, language, str(program))
        path = motor_moves(require_straight_axes(path, str(program)), play)
        return ReversePulses(path, machine).stream(None if from_s is None else max(0, round(from_s * TICKS_PER_S)))
    path, chunks = program_chunks(program, start, language, progress)
    path, chunks = motor_chunks(path, chunks, play) if play else (path, chunks)
    if machine.interpolation != "planner":
        from CNCStepper.motion.interpolation.dda_stream import dda_stream

        return dda_stream(path, machine, chunks)
    return pulse_stream(path, machine, chunks)


def _letters(program: Path, every_ms: float, from_s: float | None, back: bool) -> PulseStream:
    """Return the pulses of a file of letters."""
    from CNCStepper.motion.signals.pulse_stream import PulseStream
    from CNCStepper.motion.signals.step_letters import byte_after, letters_back, read_letters, steps_to

    ticks = max(1, round(every_ms * LETTERS_TICKS_PER_S / 1000))
    pulses = ALL if from_s is None else max(0, int(from_s * LETTERS_TICKS_PER_S) // ticks)
    with program.open("rb") as file:
        end = byte_after(file, pulses) if back else 0
        begin = steps_to(file, end, name=str(program))

    def blocks() -> Iterator[bytes]:
        with program.open("rb") as file:
            if back:
                yield from letters_back(file, end, name=str(program))
            while not back and (block := file.read(BLOCK_BYTES)):
                yield block

    return PulseStream(read_letters(blocks(), ticks, str(program)), len(begin), LETTERS_TICKS_PER_S, begin)


def _coded(stream: PulseStream, machine: Machine, form: str, coils: str) -> Iterator[bytes]:
    """Yield a stream in one of FORMS; coils: one of COILS."""
    from CNCStepper.motion.signals import signal_export
    from CNCStepper.motion.signals.coils import WIRES
    from CNCStepper.motion.signals.parallel_port_registers import port_chunks
    from CNCStepper.motion.signals.port_bytes import Board
    from CNCStepper.motion.signals.step_direction import Timeline
    from CNCStepper.motion.signals.step_letters import letters_of

    signals = machine.signals
    if form == "letters":
        return letters_of(stream)
    if form == "board":
        return Board(signals.motors, signals.null_motor).bytes_of(stream)
    if form == "coils":
        return signal_export.coil_csv(stream, WIRES[coils], signals.motors, signals.motor_names)
    if form == "csv":
        return signal_export.position_csv(stream)
    if form == "vcd":
        return signal_export.vcd(Timeline(stream, signals))
    return signal_export.port_csv(port_chunks(stream, signals), stream.ticks_per_s or 0, signals.base)


def _write(pieces: Iterable[bytes], out: Path | None) -> None:
    """Write pieces as they come; a file is there whole or not at all."""
    if out is None:
        for piece in pieces:
            sys.stdout.buffer.write(piece)
        sys.stdout.buffer.flush()
        return
    from CNCStepper.atomic_file import whole_file

    out.parent.mkdir(parents=True, exist_ok=True)
    with whole_file(out) as file:
        for piece in pieces:
            file.write(piece)
