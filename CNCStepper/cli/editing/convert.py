# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper convert`: a program of one dialect in another, with a report of what was expanded."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.findings_output import save
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import DialectType, NumberType, linuxcnc_option, program_argument, read_program
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.progress import Progress
from CNCStepper.cli.common.start_state_options import StartOptions, start_options
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.output_files import MADE_BY
from CNCStepper.state import Start

STAGES = {"read": Text("reading"), "write": Text("writing"), "compare": Text("reading back what was made of")}


@click.command("convert", cls=Verb)
@program_argument
@click.option("--to", "target", type=DialectType, required=True, help="The dialect that is written.")
@linuxcnc_option
@click.option(
    "-o",
    "--out",
    type=OutputPath("program"),
    help="Write the program there instead of printing it.",
)
@click.option(
    "--units", type=click.Choice(["mm", "inch"], case_sensitive=False), help="Of the new program. [default: as it was]"
)
@click.option(
    "--tool-change",
    type=click.Choice(["pause", "m6"]),
    help="How tools are changed. [default: m6 where the target has it]",
)
@click.option(
    "--tool-length",
    type=click.Choice(["touch_off", "table", "none"]),
    help="touch_off: the operator zeroes each tool, so that lengths are left out. [default: lengths are kept]",
)
@click.option("--rapid", "rapid_mm_min", type=NumberType(kind="feed"), help="F of rapids in mm/min, for Marlin.")
@click.option(
    "--leave-out",
    multiple=True,
    type=click.Choice(["spindle", "coolant", "dwell", "pause", "tool"]),
    help="May be missing where the target lacks it; otherwise such a program is refused.",
)
@start_options
def command(
    program: Path,
    target: str,
    dialect: str | None,
    out: Path | None,
    units: str | None,
    tool_change: str | None,
    tool_length: str | None,
    rapid_mm_min: float | None,
    leave_out: tuple[str, ...],
    given: StartOptions,
) -> None:
    """Write PROGRAM in another dialect: the same moves, what the target lacks expanded or refused.

    The report goes to standard error, the program to standard output or --out.
    """
    from CNCStepper.gcode.conversion.convert import convert

    start = given.on(Start())
    choices = {"units": units, "tool_change": tool_change, "tool_length": tool_length, "rapid_mm_min": rapid_mm_min}
    chosen: dict[str, Any] = {name: value for name, value in choices.items() if value is not None}
    lengths_mm = {number: tool.offset_mm[2] for number, tool in start.tools.items()}
    chosen["title"] = f"{MADE_BY} from {program.name}"
    chosen |= {"leave_out": leave_out, "tool_lengths_mm": lengths_mm}
    with Progress(Text("converting {name}", name=program.name)) as progress:
        chosen["tell"] = lambda stage: progress.doing(Text("{stage} {name}", stage=STAGES[stage], name=program.name))
        chosen["share"] = progress.share
        made = convert(read_program(program), dialect or "linuxcnc", target, start, str(program), **chosen)
    for note in made.notes:
        show_text("note: {note}", err=True, note=note)
    if out:
        save(out, made.text.encode("ascii"))
        show_text("{out}: written; {lines} lines", err=True, out=out, lines=len(made.text.splitlines()))
    else:
        click.echo(made.text, nl=False)
