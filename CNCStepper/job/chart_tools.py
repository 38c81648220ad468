# SPDX-License-Identifier: LGPL-2.1-or-later
"""Applies a cut chart to a job: its row for process, material and thickness, and the tool that the row describes.

    process = "plasma"              the process, which the machine's profile must name
    material = "mild-steel"         of the chart; the thickness is the third value of the stock's size_mm
    consumable = "45A"              where the chart has several
    chart = "our-torch.toml"        the shop's own chart; left out, the one that ships

Tool 1 is then made from the row. Keys of a `[[tool]]` that the job has win over it.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any

from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.machine.cut_charts import cut_data_for, read_chart
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.processes import MILLING, Process, process_named
from CNCStepper.machine.tools.tool import Tool

FIRST_TOOL = 1
NO_KEYS: Mapping[str, Any] = MappingProxyType({})


def process_of(content: dict[str, Any], file: str) -> Process:
    """Return the process that a job's content names; raises JobError where there is none of that name."""
    name = content.get("process", MILLING.name)
    if not isinstance(name, str):
        advice = 'write its name in quotes, for example process = "plasma"'
        raise JobError("bad-value", "process must be a text", place=Place(file), advice=advice)
    with placed(Place(file)):
        return process_named(name)


def take_cut_data(content: dict[str, Any], folder: Path, file: str) -> None:
    """Put the chart's row and the tools that it describes into a job's content, where its process uses a chart.

    folder: where the chart is looked for. A job without material must describe its tools itself. Raises JobError that
    names the material, the consumable or the thickness that the chart does not have.
    """
    process = process_of(content, file)
    if not process.uses_chart:
        return
    if "cut_data" not in content and content.get("material"):
        content["cut_data"] = _row(process, content, folder, file)
    row = content.get("cut_data")
    if isinstance(row, CutData):
        content["tool"] = _with_row(content.get("tool"), process, row)
    elif "tool" not in content:
        what = Text("the job of {process} names no material and has no tool", process=process.name)
        raise JobError("tool-missing", what, advice="name the material, or write a [[tool]]", place=Place(file))


def _row(process: Process, content: dict[str, Any], folder: Path, file: str) -> CutData | None:
    """Return the chart's row, None where the job's values are no such texts and numbers: they are refused later."""
    texts = [content.get(key, "") for key in ("material", "consumable", "chart")]
    stock = content.get("stock")
    size_mm = stock.get("size_mm") if isinstance(stock, dict) else None
    whole = isinstance(size_mm, list | tuple) and len(size_mm) == 3 and isinstance(size_mm[2], int | float)
    if not whole or not all(isinstance(text, str) for text in texts):
        return None
    material, consumable, chart = texts
    with placed(Place(file)):
        rows = read_chart(folder / chart) if chart else None
        return cut_data_for(process.name, material, float(size_mm[2]), consumable, rows)  # type: ignore[index]


def _with_row(tables: Any, process: Process, row: CutData) -> Any:
    """Return the tables of the tools, each with the row's values where it has none of its own."""
    if tables is None:
        return [{"number": FIRST_TOOL, **tool_keys(process, row)}]
    if not isinstance(tables, list):
        return tables
    return [{**tool_keys(process, row, table), **table} if isinstance(table, dict) else table for table in tables]


def tool_keys(process: Process, row: CutData, own: Mapping[str, Any] = NO_KEYS) -> dict[str, Any]:
    """Return the keys of the tool that a row describes, without its number; own: keys that win over them.

    The kerf is the one at the tool's feed. Raises JobError for a feed at which the chart has none.
    """
    feed_mm_min = own.get("feed_mm_min")
    needs_kerf = isinstance(feed_mm_min, int | float) and feed_mm_min > 0 and "diameter_mm" not in own
    return {
        "shape": process.shapes[0],
        "diameter_mm": row.kerf_at(feed_mm_min if needs_kerf else row.feed_mm_min),  # type: ignore[arg-type]
        "feed_mm_min": row.feed_mm_min,
        "plunge_mm_min": row.plunge_mm_min,
        "spindle_rpm": row.power,
    }


def filled(tool: Tool, process: Process, row: CutData, most_mm_min: float) -> Tool:
    """Return a tool with the row's feeds and power where it has none of its own.

    most_mm_min: the highest rate of Z, with which it goes down where the row names no other feed.
    """
    names = ("feed_mm_min", "plunge_mm_min", "spindle_rpm")
    keys = tool_keys(process, row)
    keys["plunge_mm_min"] = row.plunge_mm_min or min(tool.feed_mm_min or row.feed_mm_min, most_mm_min)
    return tool.model_copy(update={name: keys[name] for name in names if not getattr(tool, name)})


def as_cut_by(row: CutData, tool: Tool) -> CutData:
    """Return the row with the tool's own values: its diameter is the kerf, at any feed."""
    said = {"kerf_by_feed": (), "kerf_mm": tool.diameter_mm, "feed_mm_min": tool.feed_mm_min, "power": tool.spindle_rpm}
    return row.model_copy(update={key: value for key, value in said.items() if value or key == "kerf_by_feed"})
