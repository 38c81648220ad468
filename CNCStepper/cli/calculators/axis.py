# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper axis`: pulses, speeds and resolution of one axis, worked out."""

from __future__ import annotations

from typing import Any

import click

from CNCStepper.cli.common.options import NumberType, machine_option
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.axis_drive import USUAL_RATE_HZ, Drive, answers, shown
from CNCStepper.machine.profile import AXIS_NAMES, Machine, validated

ABOVE_0 = NumberType(0.0)
WORDS = {
    "travel_per_turn": "travel a turn",
    "pulse_angle": "angle of a pulse",
    "pulses_per_turn": "pulses a turn",
    "steps_per_mm": "pulses a mm",
    "resolution": "resolution",
    "pulses": "pulses",
    "reached": "whole ones reach",
    "motor_angle": "motor turns by",
    "screw_speed": "screw or pulley",
    "motor_speed": "motor speed",
    "pulse_rate": "pulse rate",
    "highest_feed": "highest feed",
}
TOLD = "axis of the command line"


@click.command("axis", cls=Verb)
@click.option("--screw", "screw_pitch_mm", type=ABOVE_0, help="Travel of the screw a turn (pitch, or lead), mm.")
@click.option("--belt", "belt_pitch_mm", type=ABOVE_0, help="Pitch of the belt, mm; with --teeth.")
@click.option("--teeth", "pulley_teeth", type=click.IntRange(1), help="Teeth of the belt's pulley.")
@click.option("--steps", "steps_per_turn", type=ABOVE_0, help="Full steps of the motor a turn. [default: 200]")
@click.option("--microsteps", type=click.IntRange(1), help="Of the driver, in a full step. [default: 1]")
@click.option("--gear", "gear_ratio", type=ABOVE_0, help="Turns of the motor for one of screw or pulley. [default: 1]")
@click.option("--encoder", "encoder_pulses_per_turn", type=ABOVE_0, help="Closed loop: pulses of the encoder a turn.")
@click.option("--encoder-gear", "encoder_gear_ratio", type=ABOVE_0, help="Its turns for one of screw or pulley.")
@machine_option(required=False)
@click.option("--axis", "axis", type=click.Choice(AXIS_NAMES), help="Take this axis' drive of --machine's profile.")
@click.option("--distance", type=ABOVE_0, default=100.0, show_default=True, help="How far it goes, mm.")
@click.option("--feed", type=ABOVE_0, help="How fast, mm/min. [default: 1000, of --machine the axis' fastest]")
@click.option("--rate", type=ABOVE_0, default=USUAL_RATE_HZ, show_default=True, help="Pulses a second at most, Hz.")
def command(
    machine: Machine | None, axis: str | None, distance: float, feed: float | None, rate: float, **drive: Any
) -> None:
    """Print steps per mm, resolution, pulses, motor speed, pulse rate and highest feed of one axis, each worked out.

    The axis is one of a screw or a belt, and of a stepper motor (open loop) or a drive with an encoder (closed loop):

    \b
      cncstepper axis --screw 6 --gear 5 --steps 48 --distance 250 --feed 500
      cncstepper axis --screw 6 --gear 5 --encoder 48 --encoder-gear 4 --distance 250 --feed 500
      cncstepper axis --belt 2 --teeth 20 --microsteps 16
      cncstepper axis --machine table.toml --axis x         of a profile with [axis.x.drive]

    Angles are of the shaft that is counted: the motor's, or the encoder's. In the workings p is the travel a turn of
    screw or pulley, n the pulses for it, x the distance, v the feed.
    """
    given = {key: value for key, value in drive.items() if value is not None}
    found, fastest = (_of_profile(machine, axis, given)) if machine or axis else (_of_options(given), 1000.0)
    for line in lines(found, distance, feed or fastest, rate):
        click.echo(line)


def _of_options(given: dict[str, Any]) -> Drive:
    if not given.keys() & {"screw_pitch_mm", "belt_pitch_mm", "pulley_teeth"}:
        raise click.UsageError(
            Text("what moves the axis? give --screw MM, or --belt MM and --teeth N, or --machine and --axis")
        )
    if ("belt_pitch_mm" in given) != ("pulley_teeth" in given):
        raise click.UsageError(Text("--belt and --teeth belong together"))
    return validated(Drive, given, TOLD)


def _of_profile(machine: Machine | None, axis: str | None, given: dict[str, Any]) -> tuple[Drive, float]:
    if machine is None or axis is None:
        raise click.UsageError(Text("--machine and --axis belong together"))
    if given:
        raise click.UsageError(Text("the profile says what drives the axis: leave the drive's options out"))
    entry = machine.axis[axis]  # type: ignore[index]
    if entry.drive is None:
        raise click.UsageError(
            Text("the profile does not say what drives {axis}: add [axis.{axis}.drive] to it", axis=axis)
        )
    return entry.drive, entry.max_rate_mm_min


def lines(drive: Drive, distance_mm: float, feed_mm_min: float, rate_hz: float) -> list[str]:
    """Return the worked answer, a line a quantity."""
    found = answers(drive, distance_mm, feed_mm_min, rate_hz)
    width = max(len(answer.working) for answer in found)
    loop = "closed loop" if drive.closed_loop else "open loop"
    head = f"{loop}: {shown(distance_mm)} mm at {shown(feed_mm_min)} mm/min, at most {shown(rate_hz)} pulses a second"
    return [
        head,
        *(
            f"{WORDS[answer.quantity]:16}  {answer.working:{width}}  = {shown(answer.value)} {answer.unit}".rstrip()
            for answer in found
        ),
    ]
