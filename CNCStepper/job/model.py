# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job: what a job file or a FreeCAD document says, checked whole before anything is made."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, model_validator

from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.cycles.form import Cycle, Setup
from CNCStepper.drawing.heights import read_heights
from CNCStepper.drawing.points import read_points
from CNCStepper.errors import JobError, Place
from CNCStepper.machine.profile import Machine, load_machine, profile_names, read_toml, validated
from CNCStepper.machine.tool import Tool
from CNCStepper.simulation.clamps import Clamp
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock
from CNCStepper.state import WORK_SYSTEMS


class StockForm(BaseModel):
    """The raw material as a job file names it.

    size_mm: of the box around it, for a cylinder diameter, diameter, height. heights_mm: of a height field over its
    bottom, rows along X from the front to the back; a job file names a file of them as `heights`. edge_mm: how far
    from a sheet's edge cuts must stay, if that matters.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    form: Literal["box", "sheet", "cylinder", "height_field"] = "box"
    size_mm: tuple[float, float, float]
    origin: str
    heights_mm: tuple[tuple[float, ...], ...] | None = None
    edge_mm: float | None = Field(default=None, ge=0)

    @model_validator(mode="after")
    def _is_a_stock(self) -> StockForm:
        if (self.heights_mm is not None) != (self.form == "height_field"):
            raise ValueError("heights belong to a stock of the form 'height_field', and to no other")
        try:
            self.stock()
        except JobError as error:
            raise ValueError(f"{error.what}; {error.advice}") from error
        return self

    def stock(self) -> Stock:
        """Return the stock in work coordinates."""
        if self.form == "cylinder":
            return Cylinder(self.size_mm, self.origin)
        if self.heights_mm is not None:
            return HeightField(self.size_mm, self.origin, _rectangular(self.heights_mm))
        return Stock(self.size_mm, self.origin)


def _rectangular(rows: tuple[tuple[float, ...], ...]) -> np.ndarray:
    if len({len(row) for row in rows}) != 1:
        raise JobError("stock-heights", "the rows of heights differ in length", advice="give every row as many")
    return np.array(rows, float)


class ClampForm(BaseModel):
    """A clamp as a job file names it: two opposite corners of a rectangle or those of a polygon, and its top's height.

    Both in work coordinates.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    corners_mm: tuple[tuple[float, float], ...] = Field(min_length=2)
    top_mm: float

    @model_validator(mode="after")
    def _encloses_something(self) -> ClampForm:
        try:
            self.clamp()
        except JobError as error:
            raise ValueError(f"{error.what}; {error.advice}") from error
        return self

    def clamp(self) -> Clamp:
        """Return the clamp that the tool keeps clear of."""
        return Clamp(self.corners_mm, self.top_mm)


class Job(BaseModel):
    """Everything that decides a program, besides the machine's own profile.

    units: of the program written only, "mm" is G21 and "inch" is G20; heights are above the stock's top.
    operation: cycles in the order in which they are cut, each already checked by its own model.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, arbitrary_types_allowed=True)

    units: Literal["mm", "inch"] = "mm"
    machine: str
    work_offset: str = "G54"
    clearance_mm: float = Field(gt=0, allow_inf_nan=False)
    retract_mm: float = Field(gt=0, allow_inf_nan=False)
    coolant: Literal["none", "mist", "flood"] = "none"
    stock: StockForm
    clamp: tuple[ClampForm, ...] = ()
    tool: tuple[Tool, ...] = Field(min_length=1)
    operation: tuple[Any, ...] = Field(min_length=1)

    @model_validator(mode="after")
    def _parts_fit_together(self) -> Job:
        if self.work_offset not in WORK_SYSTEMS:
            raise ValueError(f"work_offset must be one of {', '.join(WORK_SYSTEMS)}")
        if self.clearance_mm < self.retract_mm:
            raise ValueError("clearance_mm must not be below retract_mm")
        numbers = [tool.number for tool in self.tool]
        if len(set(numbers)) < len(numbers):
            raise ValueError("two tools have the same number")
        for operation in self.operation:
            if operation.tool not in numbers:
                raise ValueError(
                    f"operation '{operation.cycle}' uses tool {operation.tool}, which the job does not have"
                )
        return self

    @property
    def tools(self) -> dict[int, Tool]:
        """The tools by number."""
        return {tool.number: tool for tool in self.tool}

    @property
    def clamps(self) -> list[Clamp]:
        """What the tool keeps clear of."""
        return [clamp.clamp() for clamp in self.clamp]

    @property
    def cutters(self) -> str:
        """The tools in words for people."""
        return ", ".join(tool.words for tool in self.tool)

    def setup(self, operation: Cycle) -> Setup:
        """Return what the job gives that operation besides its own parameters."""
        return Setup(self.tools[operation.tool], self.clearance_mm, self.retract_mm)


def load_job(path: Path) -> tuple[Job, Machine]:
    """Return the job of a TOML file, or of a JSON file that `save_job` wrote, and its machine.

    Paths in the file are relative to it. Raises JobError that names the file, the key and its value.
    """
    job = read_job(path)
    return job, load_machine(_machine_name(job.machine, path.parent))


def read_job(path: Path) -> Job:
    """Return the job as `load_job` does, without looking for its machine."""
    if not path.is_file():
        raise JobError("job-missing", f"there is no job file '{path}'", advice="give the path of a TOML job file")
    content = _read_json(path) if path.suffix.lower() == ".json" else read_toml(path)
    content["operation"] = tuple(
        operation_of(raw, path.parent, f"{path} operation {number}")
        for number, raw in enumerate(_tables(content, "operation", path), start=1)
    )
    if isinstance(stock := content.get("stock"), dict) and "heights" in stock:
        stock["heights_mm"] = read_heights(path.parent / str(stock.pop("heights")))
    return validated(Job, content, str(path))


def save_job(job: Job, path: Path) -> None:
    """Write the job as JSON, its curves within it, so that another process can make, prove and send it."""
    content = job.model_dump(mode="json") | {
        "operation": [operation.model_dump(mode="json") for operation in job.operation]
    }
    path.write_text(json.dumps(content, indent=1, allow_nan=False) + "\n", encoding="utf-8")


def operation_of(raw: dict[str, Any], folder: Path, file: str) -> Cycle:
    """Return the cycle that one `[[operation]]` table describes; `folder` is where its files are looked for."""
    content = dict(raw)
    model = cycle_class(str(content.get("cycle", "")))
    if "points" in content:
        content["curves"] = (read_points(folder / content.pop("points"), closed=bool(content.get("closed", False))),)
    return validated(model, content, file)  # type: ignore[return-value]


def _read_json(path: Path) -> dict[str, Any]:
    try:
        content = json.loads(path.read_text("utf-8"))
    except ValueError as error:  # JSONDecodeError and UnicodeDecodeError are both
        raise JobError("json", f"not a JSON file: {error}", place=Place(str(path))) from error
    if not isinstance(content, dict):
        raise JobError("json", "not a job: the file holds no object", place=Place(str(path)))
    return content


def _tables(content: dict[str, Any], key: str, path: Path) -> list[dict[str, Any]]:
    tables = content.get(key, [])
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise JobError(
            "bad-value", f"{key} must be a list of tables", advice=f"write [[{key}]]", place=Place(str(path))
        )
    return tables


def _machine_name(name: str, folder: Path) -> str:
    return name if name in profile_names() else str(folder / name)
