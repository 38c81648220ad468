# SPDX-License-Identifier: LGPL-2.1-or-later
"""The start state in the folder of a proof: start.json, which is not there where the start is not known."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from pathlib import Path
from typing import Any

from CNCStepper.state import UNKNOWN, Start, ToolEntry

START = "start.json"
AXES = ("position_mm", "g92_mm")
NUMBERED = ("tool_lengths_mm", "parameters")


def write_start(folder: Path, start: Start | None) -> None:
    """Write the start state of a proof, where it is known."""
    if start is not None:
        (folder / START).write_text(json.dumps(asdict(start)), encoding="utf-8")


def read_start(folder: Path) -> Start | None:
    """Return the start state as `write_start` left it."""
    if not (folder / START).exists():
        return None
    return start_from(json.loads((folder / START).read_text("utf-8")))


def start_from(content: dict[str, Any]) -> Start:
    """Return the start state of plain data, as `asdict` makes it and certificates hold it; null is unknown."""
    axes = {name: tuple(map(_same_unknown, content[name])) for name in AXES}
    numbered = {name: {int(number): value for number, value in content[name].items()} for name in NUMBERED}
    offsets = {name: tuple(offset) for name, offset in content["work_offsets_mm"].items()}
    tools = {int(number): _entry(entry) for number, entry in content["tools"].items()}
    tuples = {"work_offsets_mm": offsets, "tools": tools, "search": tuple(content.get("search", ()))}
    return Start(**content | axes | numbered | tuples)


def _entry(content: dict[str, Any]) -> ToolEntry:
    diameter_mm = _same_unknown(content["diameter_mm"])
    return ToolEntry(**content | {"offset_mm": tuple(content["offset_mm"]), "diameter_mm": diameter_mm})


def _same_unknown(value: float | None) -> float:
    """Return the one NaN object that means unknown, so that start states can be compared."""
    return UNKNOWN if value is None or math.isnan(value) else value
