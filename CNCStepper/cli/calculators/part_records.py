# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper part-records`: turned parts as they were measured, against their nominal height and diameter."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import NumberType
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.verb import Verb
from CNCStepper.errors import Text
from CNCStepper.machine.axis_tests import Readings
from CNCStepper.machine.part_records import DIAMETERS, PartRecord, over_parts, part_record
from CNCStepper.quantities import MOST_ITEMS

LengthType = NumberType(kind="length")


class _PartType(click.ParamType):
    """A height and three diameters, joined by commas."""

    name = "HEIGHT,D1,D2,D3"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> tuple[float, ...]:
        words = str(value).split(",")
        if len(words) != 1 + DIAMETERS:
            self.fail(
                Text("'{value}' is not a height and three diameters, such as 150.02,49.98,50.01,50.00", value=value),
                param,
                ctx,
            )
        return tuple(LengthType.convert(word.strip(), param, ctx) for word in words)


@click.command("part-records", cls=Verb)
@click.argument("parts", nargs=-1, required=True, type=_PartType())
@click.option("--height", type=LengthType, required=True, help="Nominal, mm.")
@click.option("--diameter", type=LengthType, required=True, help="Nominal, mm; of a cone that of its base.")
@click.option("--plot", type=OutputPath(""), help="Draw the mean diameters into this file: .png, .svg or .pdf.")
def command(parts: tuple[tuple[float, ...], ...], height: float, diameter: float, plot: Path | None) -> None:
    """Print height, diameters, mean, deviation and ratio to the nominal of measured PARTS, and those of all together.

    \b
      cncstepper part-records --height 150 --diameter 50 150.02,49.98,50.01,50.00 149.97,50.03,50.02,49.99
    """
    if len(parts) > MOST_ITEMS["notes"]:
        raise click.UsageError(Text("at most {notes} parts", notes=MOST_ITEMS["notes"]))
    records = [part_record(values, height, diameter) for values in parts]
    show_text("part    height        d1        d2        d3      mean  deviation     ratio  height's")
    for number, record in enumerate(records, start=1):
        click.echo(_row(number, record, height, diameter))
    heights, means = over_parts(records)
    for name, readings, nominal in (("height", heights, height), ("diameter", means, diameter)):
        click.echo(_summary(name, readings, nominal))
    if plot:
        from CNCStepper.simulation.views.readings_plot import save_readings

        title = f"mean diameters of {len(records)} parts of {diameter:g} mm"
        save_readings(plot, title, diameter, means.values_mm, means.mean_mm, means.deviation_mm)
        show_text("{plot}: the mean diameters", plot=plot)


def _row(number: int, record: PartRecord, height_mm: float, diameter_mm: float) -> str:
    measured = "".join(f"{value:10.4f}" for value in (record.height_mm, *record.diameters_mm.values_mm))
    diameters = record.diameters_mm
    ratios = f"{record.diameter_ratio(diameter_mm):10.5f}{record.height_ratio(height_mm):10.5f}"
    return f"{number:4d}{measured}{diameters.mean_mm:10.4f}{diameters.deviation_mm:11.4f}{ratios}"


def _summary(name: str, readings: Readings, nominal_mm: float) -> str:
    return (
        f"{name} of {len(readings.values_mm)} parts: mean {readings.mean_mm:.4f} mm, standard deviation "
        f"{readings.deviation_mm:.4f} mm, range {readings.range_mm:.4f} mm, ratio {readings.mean_mm / nominal_mm:.5f} "
        f"to {nominal_mm:g} mm"
    )
