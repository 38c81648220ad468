# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper chart`: cut charts listed, asked, converted, and the kerf and speed tests that correct them."""

from __future__ import annotations

from pathlib import Path

import click

from CNCStepper.atomic_file import write_whole
from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.cli.common.path_types import OutputPath
from CNCStepper.cli.common.verb import Verbs, check_further
from CNCStepper.errors import JobError, Text
from CNCStepper.job.cut_tests import kerf_test, speed_test
from CNCStepper.machine.cut_charts import cut_data_for, known_chart, read_chart, write_chart
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.output_files import Output

WITH_CHARTS = [name for name, process in PROCESSES.items() if process.uses_chart]
SHOWN = ("feed_mm_min", "kerf_mm", "pierce_delay_s", "power_percent", "amperes")  # in a list
UnitsType = click.Choice(["mm", "inch"], case_sensitive=False)
process_option = click.option("--process", type=click.Choice(WITH_CHARTS), default="plasma", show_default=True)
material_option = click.option("--material", required=True, help="As the chart calls it: mild-steel, acrylic ...")
thickness_option = click.option(
    "--thickness", "thickness_mm", type=NumberType(kind="depth"), required=True, help="Of the sheet, in mm."
)
consumable_option = click.option("--consumable", default="", help="As the chart calls it: 45A, co2-60w ...")
chart_option = click.option("--chart", type=FilePath, help="The shop's own chart: .toml, or QtPlasmaC's .cfg.")
units_option = click.option("--units", type=UnitsType, help="Of a .cfg that does not say it. [default: mm]")


@click.group("chart", cls=Verbs)
def command() -> None:
    """Cut charts: feed, kerf, pierce and power for process, material and thickness."""


@command.command("list")
@process_option
@chart_option
@units_option
def list_(process: str, chart: Path | None, units: str | None) -> None:
    """List the rows of the chart that ships for a process, or of a chart of the shop's own."""
    for row in _rows(process, chart, units):
        told = ", ".join(f"{key} {value:g}" for key in SHOWN if (value := getattr(row, key)))
        number = f"{row.number}: " if row.number else ""
        click.echo(f"{number}{row.material} {row.thickness_mm:g} mm {row.consumable or '-'}: {told}")


@command.command("show")
@process_option
@material_option
@thickness_option
@consumable_option
@chart_option
@units_option
def show(
    process: str, material: str, thickness_mm: float, consumable: str, chart: Path | None, units: str | None
) -> None:
    """Print the row that cuts a thickness of a material, interpolated where it lies between two."""
    row = _row(process, material, thickness_mm, consumable, chart, units)
    for key, value in row.model_dump(exclude_defaults=True).items():
        click.echo(f"{key} = {value}")


@command.command("convert")
@click.argument("file", type=FilePath)
@click.option("--to", type=OutputPath(""), required=True, help="Write it there: .toml, or .cfg for QtPlasmaC.")
@units_option
@click.option("--to-units", type=UnitsType, default="mm", show_default=True, help="Of the .cfg that is written.")
def convert(file: Path, to: Path, units: str | None, to_units: str) -> None:
    """Write a chart as TOML or as QtPlasmaC's material file; what such a file cannot hold is told."""
    rows = read_chart(file, units or "")
    for note in write_chart(to, rows, to_units):
        show_text("   note: {note}", note=note)
    show_text("{to}: {rows} rows", to=to, rows=len(rows))


@command.command("kerf-test")
@process_option
@material_option
@thickness_option
@consumable_option
@click.option("--machine", required=True, help="A shipped profile, or the path of one.")
@click.option("--side", "side_mm", type=NumberType(kind="length"), default=80.0, show_default=True, help="Of the part.")
@click.option("-o", "--out", type=OutputPath(""), required=True, help="Write the job there.")
def kerf_test_(
    process: str, material: str, thickness_mm: float, consumable: str, machine: str, side_mm: float, out: Path
) -> None:
    """Write a job that cuts a square with a square hole, both of known size.

    Measure both: kerf = kerf of the chart + (side - part + hole - its side) / 2; write it into a chart of your own.
    """
    row = _row(process, material, thickness_mm, consumable, None, "")
    write_whole(out, kerf_test(row, machine, side_mm).encode("utf-8"))
    show_text(
        "{out}: kerf {kerf_mm:g} mm, outside {side_mm:g} mm, inside {side_mm2:g} mm",
        out=out,
        kerf_mm=row.kerf_mm,
        side_mm=side_mm,
        side_mm2=side_mm / 2,
    )


@command.command("speed-test")
@process_option
@material_option
@thickness_option
@consumable_option
@click.option("--machine", required=True, help="A shipped profile, or the path of one.")
@click.option("--count", type=click.IntRange(2, 9), default=5, show_default=True, help="How many squares.")
@click.option("-o", "--out", type=OutputPath(""), required=True, help="PATH.toml writes PATH-1.toml and so on.")
def speed_test_(
    process: str, material: str, thickness_mm: float, consumable: str, machine: str, count: int, out: Path
) -> None:
    """Write jobs that cut a small square each, from 70 to 130 % of the chart's feed, side by side on one sheet.

    Run them in their order: the best one has the least dross and the squarest edge.
    """
    row = _row(process, material, thickness_mm, consumable, None, "")
    jobs = list(speed_test(row, machine, count, out))
    check_further([Output(path, "--out") for path, _, _ in jobs])
    for path, text, feed_mm_min in jobs:
        write_whole(path, text.encode("utf-8"))
        show_text("{path}: {feed_mm_min:g} mm/min", path=path, feed_mm_min=feed_mm_min)


def _rows(process: str, chart: Path | None, units: str | None) -> list[CutData]:
    rows = read_chart(chart, units or "") if chart else list(known_chart(process))
    if of_process := [row for row in rows if row.process == process]:
        return of_process
    raise JobError("chart-process", Text("the chart has no row of {process}", process=process), advice="name another")


def _row(
    process: str, material: str, thickness_mm: float, consumable: str, chart: Path | None, units: str | None
) -> CutData:
    rows = read_chart(chart, units or "") if chart else None
    return cut_data_for(process, material, thickness_mm, consumable, rows)
