# SPDX-License-Identifier: LGPL-2.1-or-later
"""Options that several virtual machines have, and the hand at their input pins."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath
from CNCStepper.cli.common.path_types import InputPath, OutputPath
from CNCStepper.errors import Text

if TYPE_CHECKING:
    from CNCStepper.virtual.server.pin_presses import Pressable

MARGIN = 1.5


def server_options(columns: str, records: bool = True) -> Callable[[Any], Any]:
    """Return the decorator that adds what all of them have; columns: of the trace; records: whether bytes are saved."""
    record = click.option("--record", type=OutputPath(""), help="Save the bytes as they come.")
    options = [
        click.option(
            "--faults",
            type=InputPath(exists=False),
            help="Inject the faults of this TOML or JSON file, and print each; see docs/user-guide/sending/faults.md.",
        ),
        click.option(
            "--until-left", is_flag=True, help="End when the client disconnects, or when none connects within 30 s."
        ),
        click.option("--trace", type=OutputPath("path"), help=f"Save the path of the axes: {columns}."),
        *[record] * records,
        click.option(
            "--tcp", metavar="HOST:PORT", help="Listen there, for example 127.0.0.1:2217; port 0 picks a free one."
        ),
        click.option(
            "--pty", type=OutputPath(""), help="Create a link to a pseudo-terminal at this path (not on Windows)."
        ),
    ]
    return lambda function: _with(function, options)


speed_option = click.option(
    "--speed",
    type=click.FloatRange(min=0.01, max=1000),
    default=1.0,
    show_default=True,
    help="Speed of its clock relative to real time.",
)


def pin_options(function: Any) -> Any:
    """Add the options that press its input pins."""
    options = [
        click.option("--typed", is_flag=True, help="Press its input pins by lines typed here."),
        click.option("--press", type=FilePath, help="Press its input pins at the times in this TOML file."),
    ]
    return _with(function, options)


def check_address(pty: Path | str | None, tcp: str | None) -> None:
    """Refuse a server without an address, and one with two."""
    if bool(pty) == bool(tcp):
        raise click.UsageError(Text("give either --pty PATH or --tcp HOST:PORT"))


def _with(function: Any, options: Iterable[Callable[[Any], Any]]) -> Any:
    for option in options:
        function = option(function)
    return function


def motor_options(function: Any) -> Any:
    """Add the options for the limits of its motors."""
    for option in (
        click.option(
            "--start-stop",
            type=click.FloatRange(min=0, max=1_000_000),
            default=0.0,
            help="With --motors real: the start-stop rate of its motors, pulses/s.",
        ),
        click.option(
            "--margin",
            type=click.FloatRange(min=0.1, max=100),
            default=MARGIN,
            show_default=True,
            help="With --motors real: the limits of its motors, as a multiple of the profile's acceleration and rate.",
        ),
        click.option(
            "--motors",
            type=click.Choice(["ideal", "real"]),
            default="ideal",
            show_default=True,
            help="ideal motors follow every pulse; real ones lose steps where pulses come too fast.",
        ),
    ):
        function = option(function)
    return function


def hand_at(machine: Pressable, press: Path | None, typed: bool) -> Callable[[], None]:
    """Return what lets a hand press the pins of a machine, called again and again.

    press: a TOML file of presses; raises JobError where one cannot be. typed: whether lines are read from here.
    """
    from CNCStepper.cli.common.terminal_input import TerminalInput
    from CNCStepper.virtual.server.pin_presses import PinPresses

    hand = PinPresses(machine, tell=show_text)
    if press:
        hand.plan(press)
    if not typed:
        return hand.turn
    lines = TerminalInput(hand.on_message)

    def poll_pin_presses() -> None:
        lines.wait(0.0)
        hand.turn()

    return poll_pin_presses
