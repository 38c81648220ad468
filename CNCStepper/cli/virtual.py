# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper virtual`: controllers without hardware."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.cli.options import machine_option
from CNCStepper.machine.profile import Machine, load_machine


@click.group("virtual")
def command() -> None:
    """Be a controller without hardware: it answers and moves as the real one does."""


@command.command("grbl")
@click.option("--pty", type=click.Path(), help="Make this path a link to a pseudo-terminal (not on Windows).")
@click.option("--tcp", metavar="HOST:PORT", help="Listen there, for example 127.0.0.1:2217; port 0 picks a free one.")
@click.option(
    "--speed",
    type=click.FloatRange(min=0.01, max=1000),
    default=1.0,
    show_default=True,
    help="How many times faster than real time its clock runs.",
)
@click.option(
    "--baud", type=click.IntRange(min=300), default=115200, show_default=True, help="Rate of its serial link."
)
@click.option("--trace", type=click.Path(path_type=Path), help="Save the path of the axes: t_s,x_mm,y_mm,z_mm.")
@click.option("--homing", is_flag=True, help="Start in alarm until homed, as with $22=1.")
@click.option(
    "--firmware",
    type=click.Choice(["grbl", "grblhal", "fluidnc"]),
    default="grbl",
    show_default=True,
    help="Greet, answer and refuse as this one does, with its buffer and line length.",
)
@click.option("--until-left", is_flag=True, help="End when its client has left, or when none has come within 30 s.")
@click.option(
    "--faults",
    type=click.Path(path_type=Path),
    help="Let go wrong what this TOML or JSON file says, and tell of each fault; see docs/control/faults.md.",
)
@machine_option(required=False)
def grbl(pty, tcp, speed, baud, trace, homing, firmware, until_left, faults, machine: Machine | None) -> None:
    """A grbl 1.1 with 128 bytes and 15 blocks, on a pseudo-terminal or a TCP port; Ctrl-C ends it.

    With --firmware grblhal it has 1023 bytes, lines of 255 characters and M6, which waits in the state Tool; with
    fluidnc lines of 254 characters, and settings that can only be read. Without --machine it has the settings of
    table-a.
    """
    if bool(pty) == bool(tcp):
        raise click.UsageError("give either --pty PATH or --tcp HOST:PORT")
    from CNCStepper.virtual.faults_outside import plan_for_server
    from CNCStepper.virtual.grbl.firmware import FIRMWARES
    from CNCStepper.virtual.grbl.server import serve

    serve(
        machine or load_machine("table-a"),
        pty=pty,
        tcp=tcp,
        speed=speed,
        baud=baud,
        trace=trace,
        homing=homing,
        until_left=until_left,
        firmware=FIRMWARES[firmware],
        ready=lambda address: click.echo(f"virtual {firmware} at {address}"),
        faults=plan_for_server(faults) if faults else None,
        told=lambda fault, time_s: click.echo(f"{time_s:.3f} s: {fault}"),
    )
