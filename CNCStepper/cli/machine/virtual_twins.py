# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper virtual parport`, `board` and `lathe`: the published machines without hardware."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.options import machine_option
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.machine.virtual_options import (
    check_address,
    hand_at,
    motor_options,
    pin_options,
    server_options,
    speed_option,
)
from CNCStepper.machine.profile import Machine, load_machine

if TYPE_CHECKING:
    from CNCStepper.virtual.motors.rotor import MotorLimits
    from CNCStepper.virtual.server.twin_faults import Twin


@click.command("parport", cls=Verb)
@server_options("t_s,x_mm,y_mm,z_mm")
@motor_options
@pin_options
@machine_option(required=False)
def parport(
    motors: str,
    margin: float,
    start_stop: float,
    press: Path | None,
    typed: bool,
    machine: Machine | None,
    **options: Any,
) -> None:
    """Run a virtual table at a parallel port: two bytes a write, data and control; Ctrl-C ends it.

    Pins, levels and times are those of the profile's [signals]; without --machine of thesis-table. A pulse is lost if
    it is too short, or too close to the last pulse or change of direction; each loss is printed. Relays are printed by
    name. It sends the status register, one byte, when a client connects and when an input changes. With --typed these
    lines press its inputs, the pins 10, 11, 12, 13 and 15:

    \b
      13           press pin 13 for 0.3 s
      press 13     press it until it is released
      release 13   release it

    --press reads the same from a file, in seconds since its start:

    \b
      [[press]]
      pin = 13
      at_s = 2.5
      for_s = 0.3
    """
    from CNCStepper.virtual.parport.machine import CARRIED_S, Parport
    from CNCStepper.virtual.server.twin_faults import PARPORT_KINDS

    profile = machine or load_machine("thesis-table")
    twin = Parport(profile, _limits(profile, motors, margin, start_stop), CARRIED_S)
    _serve(twin, "parport", PARPORT_KINDS, options, hand=lambda: hand_at(twin, press, typed))


@click.command("board", cls=Verb)
@server_options("t_s,x_mm,y_mm,z_mm")
@motor_options
@machine_option(required=False)
def board(motors: str, margin: float, start_stop: float, machine: Machine | None, **options: Any) -> None:
    """Run a virtual USB board with four stepper motors: a byte sets the coils of one; Ctrl-C ends it.

    High nibble: motor 0 to 3, in the order of the profile's [signals] motors; without --machine of usb-board. Low
    nibble: coils L1 to L4, forwards A 9 5 6. Only a change of motor is a clock edge: a second byte for the same motor
    moves nothing. It buffers 384 bytes and sends nothing.
    """
    from CNCStepper.virtual.board.machine import Board
    from CNCStepper.virtual.server.twin_faults import TWIN_KINDS

    profile = machine or load_machine("usb-board")
    _serve(Board(profile, _limits(profile, motors, margin, start_stop)), "board", TWIN_KINDS, options)


@click.command("lathe", cls=Verb)
@server_options("t_s,x_mm,z_mm, X as a radius")
@speed_option
@click.option(
    "--buffer",
    "buffer_bytes",
    type=click.IntRange(min=16, max=65536),
    default=256,
    show_default=True,
    help="Bytes of its receive buffer; the source does not give them.",
)
@click.option(
    "--g20",
    type=click.Choice(["radius", "diameter"]),
    default="radius",
    show_default=True,
    help="What G20 means: radius in the published table, diameter in the listing.",
)
@click.option(
    "--g70",
    type=click.Choice(["mm", "inch"]),
    default="mm",
    show_default=True,
    help="What G70 means: mm in the published table, inch in the listing.",
)
@click.option("--thread-start", is_flag=True, help="Begin each run of G01 at the index of the spindle's encoder.")
@click.option(
    "--spindle-rpm",
    type=click.FloatRange(min=0, max=10_000),
    default=0.0,
    show_default=True,
    help="Spindle speed, which is set by hand; 0: it does not turn.",
)
@machine_option(required=False)
def lathe(
    speed: float,
    buffer_bytes: int,
    g20: Any,
    g70: Any,
    thread_start: bool,
    spindle_rpm: float,
    machine: Machine | None,
    **options: Any,
) -> None:
    """Run a virtual mini-lathe at 9600 baud, 8E1 (here 8N1 with the timing of 8E1); Ctrl-C ends it.

    It starts in manual mode: A to H move, I sets the feed speed, P stops, Y begins the automatic mode, Z quits. In
    automatic mode a record ends with #; a ? starts the records before it. It sends nothing. A full buffer loses bytes,
    and a record that cannot be read is skipped; both are printed here. Y cannot be undone, and M02 ends the program.
    Without --machine it has 80 steps/mm in X and Z.
    """
    from CNCStepper.virtual.lathe.machine import Lathe
    from CNCStepper.virtual.server.twin_faults import TWIN_KINDS

    twin = Lathe(
        machine, buffer_bytes=buffer_bytes, g20=g20, g70=g70, thread_start=thread_start, spindle_rpm=spindle_rpm
    )
    _serve(twin, "lathe", TWIN_KINDS, options, speed=speed)


def _limits(machine: Machine, motors: str, margin: float, start_stop: float) -> list[MotorLimits | None]:
    """Return what each motor of the profile can follow."""
    from CNCStepper.machine.profile import AXIS_NAMES
    from CNCStepper.virtual.motors.rotor import limits_of

    axes = [machine.axes[AXIS_NAMES.index(turning[-1])] for turning in machine.signals.motors]
    return [limits_of(axis, margin, start_stop) if motors == "real" else None for axis in axes]


def _serve(
    twin: Twin,
    name: str,
    kinds: Sequence[str],
    options: dict[str, Any],
    *,
    speed: float = 1.0,
    hand: Callable[[], Callable[[], None]] = lambda: _nobody,
) -> None:
    """Serve a machine, with the faults of --faults."""
    check_address(options["pty"], options["tcp"])
    from CNCStepper.virtual.faults.host_faults import kill_sender, plan_for_server
    from CNCStepper.virtual.server.twin_faults import FaultyTwin
    from CNCStepper.virtual.server.twin_server import serve_twin

    faults = options.pop("faults")
    plan = plan_for_server(faults, kinds) if faults else None
    if plan:
        twin = FaultyTwin(twin, plan, outside=kill_sender)
    serve_twin(
        twin,
        **options,
        speed=speed,
        ready=lambda address: click.echo(f"virtual {name} at {address}"),
        note=lambda time_s, text: click.echo(f"{time_s:.3f} s: {text}"),
        each_step=hand(),
    )


def _nobody() -> None:
    """Nobody is at the machine."""
