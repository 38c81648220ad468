# SPDX-License-Identifier: LGPL-2.1-or-later
"""The options that take the feed of a program without F from a cut chart: material, thickness and what chooses among.

cncstepper check part.nc --machine torch-table --material mild-steel --thickness 3
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import wraps
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from CNCStepper.cli.common.language import show_text
from CNCStepper.cli.common.options import FilePath, NumberType
from CNCStepper.errors import Text
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.machine.profile import Machine

if TYPE_CHECKING:
    from CNCStepper.machine.cut_data import CutData

CHARTED = [name for name, process in PROCESSES.items() if process.uses_chart]
_OPTIONS = (
    click.option("--material", default="", help="Take the feed of a program without F from the cut chart of this one."),
    click.option("--thickness", type=NumberType(kind="depth"), help="How thick the material is, in mm."),
    click.option(
        "--process", type=click.Choice(CHARTED), help="[default: the first with a chart that the machine has]"
    ),
    click.option(
        "--consumable", default="", help="The chart's consumable. [default: the first that cuts the thickness]"
    ),
    click.option("--chart", type=FilePath, help="Your own chart, instead of the one that ships."),
)


@dataclass(frozen=True)
class ChartOptions:
    """The cut options of the command line; all are optional."""

    material: str = ""
    thickness: float | None = None
    process: str | None = None
    consumable: str = ""
    chart: Path | None = None

    def language(self, dialect: str | None, machine: Machine | None) -> str:
        """Return the dialect to read with, whose programs without F take the chart's feed; tells that feed.

        Raises a usage error for half of the options, and JobError for what the chart does not cover.
        """
        if self == ChartOptions():
            return machine.language(dialect or "") if machine else dialect or "grbl"
        if machine is None or not self.material or self.thickness is None:
            raise click.UsageError(Text("--material, --thickness and --machine (or --job) go together"))
        row = self._row(machine)
        show_text(told(row))
        return machine.language(dialect or "", row.feed_mm_min)

    def row(self, machine: Machine | None) -> CutData | None:
        """Return the chart's row that the options name, None where they name none; raises as `language` does."""
        return None if machine is None or self == ChartOptions() else self._row(machine)

    def proof_words(self, machine: Machine | None) -> dict[str, Any]:
        """Return the process and the row for a proof or a check of the program; nothing where the options name none."""
        row = self.row(machine)
        return {"process": PROCESSES[row.process], "cut_data": row} if row else {}

    def _row(self, machine: Machine) -> CutData:
        from CNCStepper.machine.cut_charts import cut_data_for, read_chart

        assert self.thickness is not None
        chart = read_chart(self.chart) if self.chart else None
        own = [name for name in machine.processes if name in CHARTED]
        if not (self.process or own):
            raise click.UsageError(
                Text(
                    "{name} has no process with a cut chart: it has {processes}",
                    name=machine.name,
                    processes=", ".join(machine.processes),
                )
            )
        process = machine.process(self.process or own[0])
        return cut_data_for(process.name, self.material, self.thickness, self.consumable, chart)


def told(row: CutData) -> Text:
    """Return in words which feed a program without F takes, and from which row."""
    whose = f"{row.process}, {row.material} {row.thickness_mm:g} mm" + f", {row.consumable}" * bool(row.consumable)
    return Text("a program without F takes {feed:g} mm/min ({whose})", feed=row.feed_mm_min, whose=whose)


def chart_options(function: Callable[..., Any]) -> Callable[..., Any]:
    """Add the options that take a feed from a chart; the function gets what they say as `cut`."""

    @wraps(function)
    def command(
        *arguments: Any,
        material: str,
        thickness: float | None,
        process: str | None,
        consumable: str,
        chart: Path | None,
        **more: Any,
    ) -> Any:
        return function(*arguments, cut=ChartOptions(material, thickness, process, consumable, chart), **more)

    for option in reversed(_OPTIONS):
        command = option(command)
    return command
