# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of the verbs that send a program to a controller: `send` and `restart`."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from typing import Any

import click

from CNCStepper.cli.common.keep_open import keep_option
from CNCStepper.machine.controller_family import BAUD

_OPTIONS = (
    click.option("--baud", type=click.IntRange(min=300), default=BAUD, show_default=True),
    click.option(
        "--zero-confirmed",
        is_flag=True,
        help="The work zero is set on the stock, the tool is in the spindle, and it has stayed at that zero if the "
        "board restarts now. Without this option you are asked.",
    ),
    click.option("--home", "home_first", is_flag=True, help="Home the machine first ($H); make sure the way is free."),
    click.option(
        "--resume-pauses", is_flag=True, help="Resume at M0 without a person: for virtual machines and dry runs."
    ),
    click.option(
        "--allow-differences",
        is_flag=True,
        help="Send even if the controller's settings or offsets differ from the proof.",
    ),
    keep_option,
)


@dataclass(frozen=True)
class SendOptions:
    """Their values."""

    baud: int
    zero_confirmed: bool
    home_first: bool
    resume_pauses: bool
    allow_differences: bool
    keep_min: float


def send_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options; the function gets their values as `sending`."""

    @wraps(function)
    def command(*arguments: Any, **more: Any) -> Any:
        sending = SendOptions(**{name: more.pop(name) for name in SendOptions.__dataclass_fields__})
        return function(*arguments, sending=sending, **more)

    for option in reversed(_OPTIONS):
        command = option(command)
    return command
