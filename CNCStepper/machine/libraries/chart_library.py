# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cut charts of a process as a table: the user's own, which takes the place of the one that ships.

Imports and exports are those of `machine/cut_charts.py`: TOML, and QtPlasmaC's material file (`*.cfg`).
"""

from __future__ import annotations

import typing
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from CNCStepper.errors import Text
from CNCStepper.machine.cut_charts import known_chart, material_key, own_chart_path, read_chart, write_chart
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.libraries.table_draft import Column, Problems, Values, model_problem, unknown_ending
from CNCStepper.machine.processes import PROCESSES

PROCESS = "process"
NEEDED = ("material", "thickness_mm", "feed_mm_min", "kerf_mm")
CHARTED = tuple(name for name, process in PROCESSES.items() if process.uses_chart)


class ChartLibrary:
    """The chart of one process: a row for each material, thickness and consumable, by the keys of `[[cut]]`."""

    ENDINGS: tuple[str, ...] = (".toml", ".cfg")

    def __init__(self, process: str):
        self.process = process
        self.columns = tuple(_column(key) for key in CutData.model_fields if key != PROCESS)

    def rows(self) -> list[tuple[Values, Any]]:
        """Return the rows of the user's chart, else those of the one that ships; raises JobError for a bad file."""
        return [(_values(row), None) for row in known_chart(self.process)]

    def new_row(self, rows: Sequence[Values]) -> Values:
        """Return a row for the last one's material, with everything but a material's own facts left to type."""
        last = next((row for row in reversed(rows) if row.get("material")), {})
        return {key: last.get(key) for key in ("material", "consumable")}

    def judge(self, rows: Sequence[Values]) -> Problems:
        """Return what is wrong with rows: their values, and two for the same cut."""
        problems, seen = Problems(), set()
        for number, row in enumerate(rows):
            if found := model_problem(CutData, self._keys(row)):
                place, sentence = found
                problems[number, place[0] if place else "kerf_by_feed"] = sentence
            cut = (material_key(row["material"]), (row.get("consumable") or "").lower(), row["thickness_mm"])
            if cut in seen:
                problems.setdefault(
                    (number, "thickness_mm"),
                    Text(
                        "two rows are for {thickness:g} mm of {material}",
                        thickness=row["thickness_mm"],
                        material=row["material"],
                    ),
                )
            seen.add(cut)
        return problems

    def save(self, rows: Sequence[tuple[Values, Any]]) -> Path:
        """Write the user's chart of the process."""
        path = own_chart_path(self.process)
        path.parent.mkdir(parents=True, exist_ok=True)
        write_chart(path, self._cuts(rows))
        return path

    def read(self, path: Path) -> tuple[list[tuple[Values, Any]], list[str]]:
        """Return the rows of a file for this process, and how many are for another one; raises JobError."""
        self._require(path)
        rows = read_chart(path)
        own = [row for row in rows if row.process == self.process]
        others = len(rows) - len(own)
        notes: list[str] = [Text("{count} rows are for another process", count=others)] if others else []
        return [(_values(row), None) for row in own], notes

    def write(self, rows: Sequence[tuple[Values, Any]], path: Path) -> list[str]:
        """Write rows into a file, and return notes on what it does not hold; raises JobError."""
        self._require(path)
        return write_chart(path, self._cuts(rows))

    def _require(self, path: Path) -> None:
        if path.suffix.lower() not in self.ENDINGS:
            raise unknown_ending(path, self.ENDINGS)

    def _cuts(self, rows: Sequence[tuple[Values, Any]]) -> list[CutData]:
        return [CutData.model_validate(self._keys(values)) for values, _ in rows]

    def _keys(self, values: Values) -> Values:
        return {PROCESS: self.process, **{key: value for key, value in values.items() if value is not None}}


def _values(row: CutData) -> Values:
    """Return the values of a row; those that it does not give are None."""
    fields = CutData.model_fields
    return {key: value for key, value in row.model_dump().items() if value != fields[key].default and key != PROCESS}


def _column(key: str) -> Column:
    """Return the column of a key of the model: its kind follows from its type."""
    default, annotation = CutData.model_fields[key].default, CutData.model_fields[key].annotation
    if typing.get_origin(annotation) is tuple:
        return Column(key, "rows")
    if isinstance(default, bool):
        return Column(key, "choice", ("true", "false"))
    kind: dict[Any, Any] = {str: "text", int: "whole"}
    return Column(key, kind.get(annotation, "number"), is_needed=key in NEEDED)
