# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper compact`: the same path in fewer blocks."""

from __future__ import annotations

from typing import TYPE_CHECKING

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import NumberType
from CNCStepper.cli.common.verb import Verb
from CNCStepper.cli.editing.edit_options import Opened, editing_options

if TYPE_CHECKING:
    from CNCStepper.gcode.edit.edit_result import Edited


@click.command("compact", cls=Verb)
@click.option(
    "--tolerance",
    type=NumberType(kind="tolerance"),
    required=True,
    help="How far the new path may be off, mm.",
)
@editing_options
def command(opened: Opened, tolerance: float) -> Edited:
    """Rewrite runs of tiny straight moves in PROGRAM as arcs, helices and longer lines.

    The new path is never farther than --tolerance from the old one, nor the old one from the new. Feeds, stops,
    outputs, comments and corners stay; rapids, arcs and all other lines are not touched.
    """
    from CNCStepper.gcode.edit.compact import compact

    edited = compact(opened.text, tolerance, **opened.reading)
    before, after = (len(text.splitlines()) for text in (edited.before, edited.text))
    show_text("{path}: {before} lines become {after}", err=True, path=opened.path, before=before, after=after)
    return edited
