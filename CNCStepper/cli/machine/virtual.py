# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper virtual`: controllers without hardware."""

from __future__ import annotations

import click

from CNCStepper.cli.common.options import machine_option
from CNCStepper.cli.common.verb import Verbs
from CNCStepper.cli.machine.virtual_options import check_address, hand_at, pin_options, server_options, speed_option
from CNCStepper.cli.machine.virtual_twins import board, lathe, parport
from CNCStepper.machine.profile import Machine, load_machine


@click.group("virtual", cls=Verbs)
def command() -> None:
    """Be a controller without hardware: it answers and moves as the real one does."""


@command.command("grbl")
@server_options("t_s,x_mm,y_mm,z_mm", records=False)
@speed_option
@click.option(
    "--baud", type=click.IntRange(min=300), default=115200, show_default=True, help="Rate of its serial link."
)
@click.option("--homing", is_flag=True, help="Start in alarm until homed, as with $22=1.")
@click.option(
    "--firmware",
    type=click.Choice(["grbl", "grblhal", "fluidnc"]),
    default="grbl",
    show_default=True,
    help="Greet, answer and refuse as this one does, with its buffer and line length.",
)
@click.option(
    "--restarts", is_flag=True, help="Restart whenever its port is opened anew, as boards do where DTR is their reset."
)
@pin_options
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
    check_address(pty, tcp)
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
