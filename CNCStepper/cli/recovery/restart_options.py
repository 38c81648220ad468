# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options of `cncstepper restart`: where, how the path is entered, and what becomes of the restart program."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.options import NumberType, PointType
from CNCStepper.cli.common.path_types import OutputPath

_PLACE = (
    click.option("--line", type=click.IntRange(1), help="The first line that is not certainly done."),
    click.option("--time", type=click.IntRange(1), help="Which of its runs, for a line that is run often."),
    click.option("--operation", default="", help="An operation of the program, by its name or its number."),
    click.option("--contour", type=click.IntRange(1), help="A stretch of cuts between two rapids, by its number."),
    click.option(
        "--at", "at_mm", type=PointType(), default=(), help="The cut nearest to this point; without Z the first."
    ),
    click.option(
        "--overlap", type=NumberType(-1e-9), default=0.0, help="Cut so many mm before the place again, within its cut."
    ),
    click.option(
        "--height", type=NumberType(), help="Go up to this Z first. [default: the program's highest crossing rapid]"
    ),
)
_SENDING = (
    click.option("-o", "--out", type=OutputPath("program"), help="Write the restart program there."),
    click.option("--certificate", type=OutputPath("certificate"), help="Write its certificate there."),
    click.option("--port", help="Send it: a serial port (COM3, /dev/ttyUSB0) or a URL (socket://127.0.0.1:2217)."),
    click.option("--baud", type=click.IntRange(min=300), default=115200, show_default=True),
    click.option("--zero-confirmed", is_flag=True, help="As of `cncstepper send`; the tool is in."),
    click.option("--home", "home_first", is_flag=True, help="Let the machine home itself first ($H)."),
    click.option("--resume-pauses", is_flag=True, help="Go on by itself at M0: for a virtual machine or a dry run."),
    click.option(
        "--allow-differences",
        is_flag=True,
        help="Send though the controller's settings or offsets are not those wanted.",
    ),
    click.option(
        "--without-stock",
        is_flag=True,
        help="Send though nobody has seen whether a rapid meets material: without --job, or --stock and --tool.",
    ),
)


@dataclass(frozen=True)
class Sending:
    """What becomes of the restart program."""

    out: Path | None
    certificate: Path | None
    port: str | None
    baud: int
    zero_confirmed: bool
    home_first: bool
    resume_pauses: bool
    allow_differences: bool
    without_stock: bool


def restart_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options of the place and of sending; the function gets them as `where`, `entering` and `sending`."""

    @wraps(function)
    def command(
        *arguments: Any,
        line: int | None,
        time: int | None,
        operation: str,
        contour: int | None,
        at_mm: tuple[float, ...],
        overlap: float,
        height: float | None,
        **more: Any,
    ) -> Any:
        from CNCStepper.recovery.restart.places import RequestedPlace
        from CNCStepper.recovery.restart.prove import EntryOptions

        where = RequestedPlace(line or 0, time or 0, operation, contour or 0, at_mm)
        sending = Sending(**{name: more.pop(name) for name in Sending.__dataclass_fields__})
        return function(*arguments, where=where, entering=EntryOptions(overlap, height), sending=sending, **more)

    for option in reversed((*_PLACE, *_SENDING)):
        command = option(command)
    return command
