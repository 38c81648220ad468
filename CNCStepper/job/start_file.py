# SPDX-License-Identifier: LGPL-2.1-or-later
"""The start state in the folder of a proof: start.json, which is not there where the start is not known."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from pathlib import Path

from CNCStepper.state import UNKNOWN, Start

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
    content = json.loads((folder / START).read_text("utf-8"))
    axes = {name: tuple(map(_same_unknown, content[name])) for name in AXES}
    numbered = {name: {int(number): value for number, value in content[name].items()} for name in NUMBERED}
    offsets = {name: tuple(offset) for name, offset in content["work_offsets_mm"].items()}
    return Start(**content | axes | numbered | {"work_offsets_mm": offsets})


def _same_unknown(value: float) -> float:
    """Return the one NaN that stands for unknown, so that start states can be compared."""
    return UNKNOWN if math.isnan(value) else value
