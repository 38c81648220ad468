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
    """Run a virtual controller, which answers and moves as the real one does."""


@command.command("grbl")
@server_options("t_s,x_mm,y_mm,z_mm", records=False)
@speed_option
@click.option(
    "--baud", type=click.IntRange(min=300), default=115200, show_default=True, help="Baud rate of its serial link."
)
@click.option("--homing", is_flag=True, help="Start in alarm until homed, as with $22=1.")
@click.option(
    "--firmware",
    type=click.Choice(["grbl", "grblhal", "fluidnc"]),
    default="grbl",
    show_default=True,
    help="The firmware whose greeting, answers, refusals, buffer and line length it has.",
)
@click.option(
    "--restarts", is_flag=True, help="Restart whenever its port is opened, as boards do whose reset is on DTR."
)
@pin_options
@machine_option(required=False)
def grbl(
    pty, tcp, speed, baud, trace, homing, firmware, until_left, restarts, faults, press, typed, machine: Machine | None
) -> None:
    """Run a virtual grbl 1.1 (128 bytes, 15 blocks) on a pseudo-terminal or a TCP port; Ctrl-C ends it.

    --firmware grblhal has 1023 bytes, lines of 255 characters, and waits at M6 in the state Tool. fluidnc has lines of
    254 characters, and its settings can only be read. Without --machine the settings are those of table-a. With --typed
    these lines press its input pins:

    \b
      P            press the probe's pin for 0.3 s; also X Y Z (limit switches), D door, R reset, H hold, S cycle start
      press P      press it until it is released
      release P    release it

    --press reads the same from a file, in seconds since the first client has connected:

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
