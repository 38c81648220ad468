# SPDX-License-Identifier: LGPL-2.1-or-later
"""Values of a job object from its cut chart or material: the chart's row with the job's own values, and tools' feeds.

Process, Material, Consumable, Chart, thickness of the stock ──► row of the chart ──► values of the job ──► CutData
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.errors import JobError
from CNCStepper.job.chart_tools import filled, tool_keys
from CNCStepper.machine.cut_charts import cut_data_for, known_chart, material_key, read_chart
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.feeds_and_speeds import with_feeds
from CNCStepper.machine.materials import material
from CNCStepper.machine.processes import PROCESSES, Process
from CNCStepper.machine.profile import validated
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.workbench.document.machine_of_job import file_stamp, machine_of
from CNCStepper.workbench.document.stock_of_job import size_mm
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.features.cut_values import CUT_VALUES, HEIGHT_KEYS


def process_of(job: Any) -> Process:
    """Return the process of a job object."""
    return PROCESSES[job.Process]


def keys_that_count(job: Any) -> set[str]:
    """Return the keys of a job object that its process and its machine have, of those that not all have."""
    process, machine = process_of(job), machine_of(job)
    if not process.uses_chart:
        return {"coolant", *HEIGHT_KEYS}
    pierces, has_z = process.entry == "pierce", machine.has_z
    keys = {
        "consumable": True,
        "chart": True,
        "feed_mm_min": True,
        "kerf_mm": process.is_thermal,
        "pierce_delay_s": process.power in ("contour", "always"),
        "pierce_height_mm": pierces and has_z,
        "cut_height_mm": pierces and has_z,
        "preheat_s": process.name == "oxyfuel",
        "amperes": process.name == "plasma",
        "power_percent": process.name in ("laser", "hot-wire") and machine.has_spindle,
        **dict.fromkeys(HEIGHT_KEYS, has_z),
    }
    return {key for key, counts in keys.items() if counts}


def rows_of(job: Any) -> Sequence[CutData]:
    """Return the rows of a job object's chart for its process; raises JobError for a file that is none."""
    return rows_for(job.Process, job)


def rows_for(process: str, job: Any) -> Sequence[CutData]:
    """Return the rows that a job object's chart has for a process, () for milling; raises JobError."""
    if not PROCESSES[process].uses_chart:
        return ()
    rows = _own_chart(job) if job.Chart else known_chart(process)
    return [row for row in rows if row.process == process]


def consumables_of(job: Any) -> list[str]:
    """Return the consumables of a job object's chart for its material; raises JobError for a file that is none."""
    rows = [row for row in rows_of(job) if material_key(row.material) == material_key(job.Material)]
    return list(dict.fromkeys(row.consumable for row in rows if row.consumable))


def best_material(rows: Sequence[CutData], thickness_mm: float, present: str) -> str:
    """Return the material with which a job begins: its present one, else the first that covers its thickness."""
    names = list(dict.fromkeys(row.material for row in rows))
    if present and any(material_key(name) == material_key(present) for name in names):
        return present
    spans = {name: [row.thickness_mm for row in rows if row.material == name] for name in names}
    covering = [name for name, found in spans.items() if min(found) <= thickness_mm <= max(found)]
    return next(iter([*covering, *names]), "")


def chart_row(job: Any) -> CutData | None:
    """Return the chart's row of a job object, None for one without chart or material; raises JobError."""
    process = process_of(job)
    if not (process.uses_chart and job.Material):
        return None
    chart = _own_chart(job) if job.Chart else None
    return cut_data_for(process.name, job.Material, size_mm(job)[2], job.Consumable, chart)


def cut_data_of(job: Any) -> CutData | None:
    """Return the chart's row with the job's own values in place of it; raises JobError for one that cannot be.

    Where a chart has the kerf by the feed, an own feed has the kerf that belongs to it.
    """
    row = chart_row(job)
    own = own_values(job)
    if row is None or not own:
        return row
    if "kerf_mm" in own:
        own["kerf_by_feed"] = ()
    elif "feed_mm_min" in own:
        own["kerf_mm"] = row.kerf_at(own["feed_mm_min"])
    if "power_percent" in own:
        own["power"] = 0.0
    return validated(CutData, {**row.model_dump(), **own}, job.Label)


def own_values(job: Any) -> dict[str, Any]:
    """Return the values that a person has typed in place of the chart's and that count, by key."""
    counting = keys_that_count(job)
    found = {entry.key: value_of(job, entry) for entry in CUT_VALUES if entry.key in counting}
    return {key: value for key, value in found.items() if value}


def chart_tool_keys(job: Any) -> dict[str, Any]:
    """Return the keys of the tool that the chart describes, without its number; raises JobError where it does not."""
    row = cut_data_of(job)
    if row is None:
        what = "the job names no material, so the chart gives no tool"
        raise JobError("chart-material", what, advice="choose the job's material")
    return tool_keys(process_of(job), row)


def fed(tool: Tool, job: Any) -> Tool:
    """Return a tool with the feeds and the speed that it has none of itself; raises JobError.

    job: the object of its job, None where it has none; without a material the tool stays as it is.
    """
    if job is None or not job.Material:
        return tool
    machine = machine_of(job)
    if not process_of(job).uses_chart:
        return with_feeds(tool, material(job.Material), machine)
    row = cut_data_of(job)
    if row is None:
        return tool
    most_mm_min = machine.axes[2].max_rate_mm_min if machine.has_z else row.feed_mm_min
    return filled(tool, process_of(job), row, most_mm_min)


def _own_chart(job: Any) -> Sequence[CutData]:
    """Return the rows of the chart that a job object names; it is looked for in the document's folder."""
    path = Path(job.Chart)
    if not path.is_absolute() and job.Document.FileName:
        path = Path(job.Document.FileName).parent / path
    return _read(str(path), file_stamp(str(path)))


@functools.lru_cache(maxsize=8)
def _read(path: str, stamp: tuple[int, ...]) -> tuple[CutData, ...]:
    return tuple(read_chart(Path(path)))
