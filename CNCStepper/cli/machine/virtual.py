# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper virtual`: controllers without hardware."""

from __future__ import annotations

import click

from CNCStepper.cli.common.options import FilePath, machine_option
from CNCStepper.cli.common.path_types import InputPath, OutputPath
from CNCStepper.cli.common.verb import Verbs
from CNCStepper.cli.machine.virtual_options import hand_at
from CNCStepper.cli.machine.virtual_twins import board, lathe, parport
from CNCStepper.machine.profile import Machine, load_machine


@click.group("virtual", cls=Verbs)
def command() -> None:
    """Be a controller without hardware: it answers and moves as the real one does."""


@command.command("grbl")
@click.option("--pty", type=OutputPath(""), help="Make this path a link to a pseudo-terminal (not on Windows).")
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
@click.option("--trace", type=OutputPath("path"), help="Save the path of the axes: t_s,x_mm,y_mm,z_mm.")
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
    "--restarts", is_flag=True, help="Restart whenever its port is opened anew, as boards do where DTR is their reset."
)
@click.option(
    "--faults",
    type=InputPath(exists=False),
    help="Make the faults that this TOML or JSON file lists, and report each; see docs/user-guide/sending/faults.md.",
)
@click.option("--press", type=FilePath, help="Press its input pins when this TOML file says so.")
@click.option("--typed", is_flag=True, help="Press its input pins by what is typed here.")
@machine_option(required=False)
def grbl(
    pty, tcp, speed, baud, trace, homing, firmware, until_left, restarts, faults, press, typed, machine: Machine | None
) -> None:
    """A grbl 1.1 with 128 bytes and 15 blocks, on a pseudo-terminal or a TCP port; Ctrl-C ends it.

    With --firmware grblhal it has 1023 bytes, lines of 255 characters and M6, which waits in the state Tool; with
    fluidnc lines of 254 characters, and settings that can only be read. Without --machine it has the settings of
    table-a. With --typed these lines press its input pins:

    \b
      P            the probe's pin for 0.3 s; also X Y Z (limit switches), D door, R reset, H hold, S cycle start
      press P      the same, and keep it pressed
      release P    let it go

    --press reads the same from a file, in seconds since the first client has come:

    \b
      [[press]]
      pin = "P"
      at_s = 2.5
      for_s = 0.3
    """
    if bool(pty) == bool(tcp):
        raise click.UsageError("give either --pty PATH or --tcp HOST:PORT")
    from CNCStepper.virtual.faults.host_faults import plan_for_server
    from CNCStepper.virtual.grbl.firmware import FIRMWARES
    from CNCStepper.virtual.server.grbl_server import serve

    serve(
        machine or load_machine("table-a"),
        pty=pty,
        tcp=tcp,
        speed=speed,
        baud=baud,
        trace=trace,
        homing=homing,
        until_left=until_left,
        restarts=restarts,
        firmware=FIRMWARES[firmware],
        ready=lambda address: click.echo(f"virtual {firmware} at {address}"),
        faults=plan_for_server(faults) if faults else None,
        told=lambda fault, time_s: click.echo(f"{time_s:.3f} s: {fault}"),
        visit=lambda board: hand_at(board, press, typed),
    )


for _twin in (parport, board, lathe):
    command.add_command(_twin)
