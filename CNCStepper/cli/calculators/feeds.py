# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper feeds`: feed and speed of a tool in a material, and the force and power of a cut on a lathe."""

from __future__ import annotations

import math
from dataclasses import dataclass

import click

from CNCStepper.cli.common.options import NumberType, ToolType, machine_option
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.feeds_and_speeds import Feeds, Remark, feeds_of
from CNCStepper.machine.materials import Material, material, material_names
from CNCStepper.machine.profile import Machine
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.turning_forces import (
    Holding,
    TurningCut,
    deflection_mm,
    nearest_preset_rpm,
    rpm_of_power,
    turning_remarks,
)

LengthType = NumberType(kind="length")


@dataclass(frozen=True)
class _Lathe:
    """What the options say of a cut on a lathe; None where an option was left out."""

    diameter_mm: float
    depth_mm: float
    feed_mm: float
    rpm: float | None
    power_w: float
    holding: Holding
    hss: bool


@click.command("feeds", cls=Verb)
@click.option("--material", "name", type=click.Choice(material_names()), required=True, help="What is cut.")
@click.option("--tool", type=ToolType, help="The cutter, for example flat:6 or drill:3.")
@click.option("--flutes", type=click.IntRange(1, 20), help="Its cutting edges. [default: 2]")
@click.option("--hss", is_flag=True, help="It is of high-speed steel, not of carbide.")
@click.option("--turn", "diameter", type=LengthType, help="On a lathe, in place of --tool: the diameter, mm.")
@click.option("--depth", type=NumberType(kind="depth"), help="On a lathe: the depth of cut a_p, mm.")
@click.option("--feed", type=NumberType(kind="chip_load"), help="On a lathe: the feed f, mm a turn.")
@click.option("--rpm", type=NumberType(kind="speed"), help="On a lathe: the speed. [default: of the material]")
@click.option("--power", type=NumberType(kind="power"), help="On a lathe: the motor's power, W. [default: --machine's]")
@click.option("--stickout", type=LengthType, help="On a lathe: the length of the bar out of the chuck, mm.")
@click.option("--tailstock", is_flag=True, help="On a lathe: the bar's end runs in a tailstock.")
@click.option("--grip", type=NumberType(kind="force"), help="On a lathe: the force of all jaws of the chuck, N.")
@machine_option(required=False)
def command(
    name: str, tool: Tool | None, flutes: int | None, hss: bool, diameter: float | None, depth: float | None,
    feed: float | None, rpm: float | None, power: float | None, stickout: float | None, tailstock: bool,
    grip: float | None, machine: Machine | None,
) -> None:  # fmt: skip
    """Print spindle speed, feed and plunge feed of a tool in a material, and how they come about.

    With --machine they are bounded by its spindle and the rates of its axes. Values to begin with: the cutter's own
    data sheet and the first chips know better.

    For a lathe give --turn, --depth and --feed in place of --tool. Printed are the force, power and torque of the cut,
    the nearest of the machine's preset speeds, and what is too weak: motor, chuck or bar.

    \b
      cncstepper feeds --material plywood --tool flat:6
      cncstepper feeds --material pvc --turn 100 --depth 3 --feed 3 --power 386
    """
    of_lathe = (depth, feed, rpm, power, stickout, grip, tailstock or None)
    if (tool is None) == (diameter is None):
        raise click.UsageError(Text("give --tool for a mill, or --turn for a lathe"))
    if tool is not None:
        if any(value is not None for value in of_lathe):
            raise click.UsageError(Text("these options belong to --turn, not to --tool"))
        lines = _of_cutter(material(name), tool, flutes, hss, machine)
    elif depth is None or feed is None:
        raise click.UsageError(Text("--turn needs --depth and --feed"))
    else:
        motor_w = power or (machine.spindle.power_w if machine else 0.0)
        holding = Holding(stickout or 0.0, tailstock, grip or 0.0)
        lines = _of_lathe(material(name), _Lathe(diameter or 0.0, depth, feed, rpm, motor_w, holding, hss), machine)
    for line in lines:
        click.echo(line)


def _of_cutter(stuff: Material, tool: Tool, flutes: int | None, hss: bool, machine: Machine | None) -> list[str]:
    cutter = tool.model_copy(update={"flutes": flutes or 0, "made_of": "hss" if hss else "carbide"})
    return _lines(stuff, cutter, machine, feeds_of(cutter, stuff, machine))


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
        *map(_remark, found.remarks),
    ]


def _of_lathe(stuff: Material, lathe: _Lathe, machine: Machine | None) -> list[str]:
    data = stuff.turning_data()
    sizes = (data, lathe.diameter_mm, lathe.depth_mm, lathe.feed_mm)
    wanted = TurningCut(*sizes, lathe.rpm or _usual_rpm(stuff, lathe))
    presets = machine.spindle.preset_rpm if machine else ()
    cut = TurningCut(*sizes, nearest_preset_rpm(presets, wanted.rpm))
    remarks = turning_remarks(cut, lathe.power_w, lathe.holding)
    of = f", the nearest preset to {wanted.rpm:.1f}" if presets else ""
    bend = [
        f"bar        L/D {lathe.holding.stickout_mm / cut.diameter_mm:.3g}, bends by "
        f"{deflection_mm(cut, lathe.holding):.4f} mm"
    ]
    return [
        f"{stuff.title}: diameter {cut.diameter_mm:g} mm, a_p {cut.depth_mm:g} mm, f {cut.feed_mm:g} mm a turn",
        f"K_s        {cut.pressure_n_mm2:.1f} N/mm² = {data.force_n_mm2:g} / {cut.feed_mm:g}^{data.exponent:g}",
        f"F_c        {cut.force_n:.1f} N = K_s a_p f",
        f"spindle    {cut.rpm:.1f} rpm{of}",
        f"v_c        {cut.speed_m_min:.2f} m/min ({cut.speed_m_min / 60:.3f} m/s) = pi d n / 1000",
        f"P_c        {cut.power_w:.0f} W = F_c v_c / 60",
        f"torque     {cut.torque_nm:.1f} Nm",
        f"v_f        {cut.feed_mm_min:.1f} mm/min = f n",
        *(bend if lathe.holding.stickout_mm else []),
        *map(_remark, remarks),
    ]


def _usual_rpm(stuff: Material, lathe: _Lathe) -> float:
    """Return the speed of the middle of the material's range, no faster than the motor's power allows."""
    least, most = stuff.speed_m_min("hss" if lathe.hss else "carbide")
    rpm = 1000.0 * math.sqrt(least * most) / (math.pi * lathe.diameter_mm)
    if not lathe.power_w:
        return rpm
    sizes = (lathe.diameter_mm, lathe.depth_mm, lathe.feed_mm)
    return min(rpm, rpm_of_power(stuff.turning_data(), *sizes, lathe.power_w))


def _remark(remark: Remark) -> str:
    if remark.value is None or remark.limit is None:
        return f"{remark.severity}: {remark.text}; {remark.advice}"
    return (
        f"{remark.severity}: {remark.text} (value {remark.value:.3g} {remark.unit}, limit {remark.limit:.3g} "
        f"{remark.unit}); {remark.advice}"
    )
