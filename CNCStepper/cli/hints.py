# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which option helps against a refusal: the core, which knows no options, cannot say it."""

from __future__ import annotations

from collections.abc import Iterable

import click

from CNCStepper.errors import CNCStepperError

DIALECT = "--dialect says how a program is read: linuxcnc knows parameters, expressions and O-words"
TOOLS = "--tool-table FILE tells the tools' lengths and diameters"
PLACE = "--position X,Y,Z says where the machine stands at first, --parameters FILE the places of G28 and G30"
HINTS = {
    "unknown-position": PLACE,
    "no-subroutine": "--search FOLDER says where else the files of subroutines stand",
    "tool-length": TOOLS,
    "tool-diameter": TOOLS,
    "not-expressible": "--leave-out leaves out what the target lacks: spindle, coolant, dwell, pause or tool",
}


def show_hints(errors: Iterable[CNCStepperError]) -> None:
    """Print on standard error, each once, the options that help."""
    for text in dict.fromkeys(map(_hint, errors)):
        if text:
            click.echo(f"hint: {text}", err=True)


def _hint(error: CNCStepperError) -> str:
    if error.code == "not-supported" and "dialect" in error.what:
        return DIALECT
    return HINTS.get(error.code, "")
