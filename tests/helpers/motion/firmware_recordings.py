# SPDX-License-Identifier: LGPL-2.1-or-later
"""The recordings of real firmware, and a reader of their programs that knows only what they use."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np

from CNCStepper.motion.planner.machine_limits import Limits
from CNCStepper.state import Start
from CNCStepper.toolpath import ARC_CCW, ARC_CW, PLANE_AXES, TableBuilder, Toolpath

FOLDER = Path(__file__).parents[2] / "data" / "firmware"
NAMES = sorted(path.stem for path in FOLDER.glob("*.json"))
WORD = re.compile(r"([A-Z])([-+.\d]+)")


def recording(name: str) -> dict:
    """Return one recording as it was written."""
    return json.loads((FOLDER / f"{name}.json").read_text("ascii"))


def end_steps(recorded: dict) -> list[int]:
    """Return where a recording ends; an older one has it in mm."""
    steps_per_mm = [recorded["settings"][f"${100 + axis}"] for axis in range(3)]
    in_mm = [round(mm * steps) for mm, steps in zip(recorded["end_mpos_mm"], steps_per_mm, strict=True)]
    return recorded.get("end_steps", in_mm)


def limits_of(settings: dict[str, float]) -> Limits:
    """Return the limits that grbl's settings state."""
    steps, rates, accelerations = (tuple(settings[f"${base + i}"] for i in range(3)) for base in (100, 110, 120))
    return Limits(steps, rates, accelerations, settings["$11"], settings["$12"])


class Reader:
    """Feeds a table of moves with G0 to G4, G17 to G19, F and incremental I J K."""

    def __init__(self) -> None:
        self.table = TableBuilder(Start.at_zero())
        self.place = np.zeros(3)
        self.motion = self.feed = self.plane = 0

    def line(self, text: str, number: int) -> None:
        """Read one line."""
        words = [(letter, float(value)) for letter, value in WORD.findall(text)]
        codes = [value for letter, value in words if letter == "G"]
        values = {letter: value for letter, value in words if letter != "G"}
        self.feed = values.get("F", self.feed)
        if 4 in codes:
            self.table.event("dwell", values["P"])
            return
        for code in codes:
            self.plane = {17: 0, 18: 1, 19: 2}.get(code, self.plane)
            self.motion = int(code) if code in (0, 1, 2, 3) else self.motion
        if any(letter in values for letter in "XYZ"):
            self._move(values, number)

    def _move(self, values: dict[str, float], number: int) -> None:
        end = np.array([values.get(letter, now) for letter, now in zip("XYZ", self.place, strict=True)])
        if self.motion == 0:
            self.table.rapid(end, number)
        elif self.motion == 1:
            self.table.feed(end, self.feed, number)
        else:
            centre = self.place.copy()
            for axis in PLANE_AXES[self.plane][:2]:
                centre[axis] += values.get("IJK"[axis], 0.0)
            kind = ARC_CW if self.motion == 2 else ARC_CCW
            self.table.arc(kind, end, centre, self.feed, self.plane, 1, number)
        self.place = end


def toolpath_of(program: list[str]) -> Toolpath:
    """Return the table of a recorded program."""
    reader = Reader()
    for number, text in enumerate(program, 1):
        reader.line(text, number)
    return reader.table.toolpath()
