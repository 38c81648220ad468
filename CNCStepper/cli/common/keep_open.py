# SPDX-License-Identifier: LGPL-2.1-or-later
"""How long a connection stays open after the verb that opened it: the option, and its message."""

from __future__ import annotations

from typing import Any

import click

from CNCStepper.cli.common.language import show_text

KEEP_MIN = 10.0
LONGEST_MIN = 24 * 60.0
VARIABLE = "CNCSTEPPER_KEEP_OPEN"


def keep_option(function: Any) -> Any:
    """Add --keep-open, which the function gets as `keep_min`."""
    option = click.option(
        "--keep-open",
        "keep_min",
        type=click.FloatRange(0, LONGEST_MIN),
        default=KEEP_MIN,
        show_default=True,
        envvar=VARIABLE,
        show_envvar=True,
        metavar="MIN",
        help="How many minutes the connection stays open for the next verb, so that the board does not restart; "
        "0 closes it with this one.",
    )
    return option(function)


def tell_kept(port: str, keep_min: float) -> None:
    """Print that the connection stays open, and how to close it."""
    if keep_min:
        show_text(
            "the connection to {port} stays open for {keep_min:g} min; `cncstepper disconnect` closes it",
            err=True,
            port=port,
            keep_min=keep_min,
        )
