# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper feeds`: feed and speed of a tool in a material, worked out."""

from __future__ import annotations

import click

from CNCStepper.cli.common.options import ToolType, machine_option
from CNCStepper.cli.common.verb import Verb
from CNCStepper.machine.feeds_and_speeds import Feeds, feeds_of
from CNCStepper.machine.materials import Material, material, material_names
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool


@click.command("feeds", cls=Verb)
@click.option("--material", "name", type=click.Choice(material_names()), required=True, help="What is cut.")
@click.option("--tool", type=ToolType, required=True, help="The cutter, for example flat:6 or drill:3.")
@click.option("--flutes", type=click.IntRange(1, 20), help="Its cutting edges. [default: 2]")
@click.option("--hss", is_flag=True, help="It is of high-speed steel, not of carbide.")
@machine_option(required=False)
def command(name: str, tool: Tool, flutes: int | None, hss: bool, machine: Machine | None) -> None:
    """Print spindle speed, feed and plunge feed of a tool in a material, and how they come about.

    With --machine they are bounded by its spindle and the rates of its axes. Values to begin with: the cutter's own
    data sheet and the first chips know better.
    """
    cutter = tool.model_copy(update={"flutes": flutes or 0, "made_of": "hss" if hss else "carbide"})
    stuff = material(name)
    for line in _lines(stuff, cutter, machine, feeds_of(cutter, stuff, machine)):
        click.echo(line)


def _lines(stuff: Material, tool: Tool, machine: Machine | None, found: Feeds) -> list[str]:
    least, most = found.speed_range_m_min
    thin, thick = found.chip_range_mm
    of = "HSS" if tool.made_of == "hss" else "carbide"
    on = f" on {machine.name}" if machine else ""
    return [
        f"{stuff.title}: {tool.words} of {of}, {found.flutes} flutes{on} (source: {stuff.source})",
        f"spindle    {found.spindle_rpm:.0f} rpm: {found.speed_m_min:.0f} m/min at the rim, of {least:g} to {most:g}",
        f"feed       {found.feed_mm_min:.0f} mm/min: {found.chip_load_mm:.3f} mm a tooth, of {thin:.3f} to {thick:.3f}",
        f"plunge     {found.plunge_mm_min:.0f} mm/min",
        f"to begin   stepdown_mm {found.stepdown_mm:.3g}, stepover_mm {found.stepover_mm:.3g}",
        *(
            f"{remark.severity}: {remark.text} (value {remark.value:.3g} {remark.unit}, limit {remark.limit:.3g} "
            f"{remark.unit}); {remark.advice}"
            for remark in found.remarks
        ),
    ]
