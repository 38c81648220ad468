# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper jog`: a way by hand."""

from __future__ import annotations

import re

import click

from CNCStepper.cli.options import NumberType
from CNCStepper.cli.talk import Talk, place, port_options

WORD = re.compile(r"([XYZ])([-+]?\d+(?:\.\d*)?|[-+]?\.\d+)", re.IGNORECASE)
FEED_MM_MIN = 1000.0


@click.command("jog")
@click.argument("way", nargs=-1, required=True)
@click.option("--feed", type=NumberType(above=0), default=FEED_MM_MIN, show_default=True, help="Speed in mm/min.")
@port_options
def command(way: tuple[str, ...], feed: float, port: str, baud: int) -> None:
    """Move the axes of the machine at --port by WAY from where they stand, in mm: X10, or X-2.5 Y3 together.

    The program's modes are left as they are ($J). Ctrl-C brakes at once and keeps the position. Works in any position,
    known or not; the controller refuses a way out of its travel where its soft limits are on ($20=1).
    """
    line = jog_line(way, feed)
    with Talk(port, baud) as talk:
        jog(talk, line)
        click.echo(place(talk.status))


def jog_line(way: tuple[str, ...], feed_mm_min: float) -> str:
    """Return the jog command for words as "X10" and "Y-2.5"; raises a usage error for what is no way."""
    words = [WORD.fullmatch(part) for part in way]
    axes = [word[1].upper() for word in words if word]
    if len(axes) < len(way) or len(set(axes)) < len(axes):
        raise click.UsageError(f"'{' '.join(way)}' is no way: write for example X10, or X-2.5 Y3 (mm)")
    moves = "".join(f"{word[1].upper()}{float(word[2]):.4f}" for word in words if word)
    return f"$J=G91G21{moves}F{feed_mm_min:.1f}"


def jog(talk: Talk, line: str) -> None:
    """Jog and wait until the machine stands; raises a ClickException with the controller's words when it does not."""
    try:
        answer = talk.type(line)
    except KeyboardInterrupt:
        talk.client.jog_cancel()
        talk.until(lambda event: event["event"] == "answer")
        raise
    if answer != "ok":
        raise click.ClickException(answer)
