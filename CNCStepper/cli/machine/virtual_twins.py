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
    """A table at a parallel port: two bytes a write, data and control; Ctrl-C ends it.

    Pins, levels and times are those of the profile's [signals]; thesis-table when --machine is left out. A pulse that
    is certainly too short, or too close behind the one before it or a change of direction, is lost, and told. Relays
    are told by name. When an input changes, and when a client comes, it sends one byte, the status register. With
    --typed these lines press its inputs, the pins 10, 11, 12, 13 and 15:

    \b
      13           for 0.3 s
      press 13     and keep it pressed
      release 13   let it go

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
    """A USB board with four stepper motors: a byte sets the coils of one; Ctrl-C ends it.

    High nibble: motor 0 to 3, in the order of the profile's [signals] motors; usb-board when --machine is left out. Low
    nibble: coils L1 to L4, forwards A 9 5 6. Only a change of motor is a clock edge: a second byte for the same motor
    moves nothing. It takes 384 bytes ahead of the coils and never says anything.
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
    help="Bytes of its receive buffer, which the source does not tell.",
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
    help="The preset speed at which its spindle turns, set by hand; 0: it stands.",
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
    """The mini-lathe at 9600 baud, 8E1 (here 8N1, in 8E1's time): manual bytes, then records; Ctrl-C ends it.

    It begins in manual mode: A to H move, I sets the feed speed, P stops, Y begins the automatic mode, Z quits. In
    automatic mode records end with # and pieces of a program with ?, which starts them. It never says anything; a full
    buffer loses bytes, a record that cannot be read is left out, and both are told here. After Y there is no way back,
    and M02 ends the program. Without --machine it has 80 steps/mm in X and Z.
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
    """Serve a machine, with its faults where there are some."""
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
