# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job model: the content of a job file or a FreeCAD document, validated whole before use.

The tools of a job in a file of their own: `tools = "shop.fctl"` beside the `[[tool]]` tables.

    tools = "shop.fctl"                                   FreeCAD's library, or one bit: "mill.fctb"
    tools = { file = "tool.tbl", unit_mm = 25.4 }         LinuxCNC's table; its unit is a mm where nothing is said

The job has those that its operations use. A `[[tool]]` with the number of one of them says more of it, or other than
the file: feeds and speed, which these files do not have.

A job of a process with a cut chart takes tool and feeds from it: `chart_tools.py`. Without a Z axis clearance_mm and
retract_mm may be left out.
"""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, PrivateAttr, model_validator

from CNCStepper.atomic_file import write_whole
from CNCStepper.cycles.catalogue import cycle_class
from CNCStepper.cycles.cycle import Cycle, Setup
from CNCStepper.drawing.drawing import Share
from CNCStepper.drawing.point_list import read_heights, read_points
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.gcode.dialects import dialect
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.job.chart_tools import FIRST_TOOL, as_cut_by, filled, process_of, take_cut_data
from CNCStepper.job.shapes import NO_SHAPES, Drawn, Shapes, read_shapes, with_curves
from CNCStepper.machine.cut_charts import cut_data_for
from CNCStepper.machine.cut_data import CutData
from CNCStepper.machine.feeds_and_speeds import Remark, remarks_on, with_feeds
from CNCStepper.machine.files.toml_reader import read_json, read_toml
from CNCStepper.machine.materials import material, material_names
from CNCStepper.machine.processes import MILLING, PROCESSES, Process, ProcessName
from CNCStepper.machine.profile import ON_RPM, Machine, load_machine, profile_names, validated
from CNCStepper.machine.tools.stored_tool import StoredTool, given_keys
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_files import read_tools
from CNCStepper.quantities import MOST_ITEMS, Coordinate, Height, Length, LengthOr0, Unit, shown
from CNCStepper.simulation.checks.clamps import Clamp
from CNCStepper.simulation.stock import Cylinder, HeightField, Stock
from CNCStepper.state import WORK_SYSTEMS, Start

NO_HEIGHT_MM = 1.0  # of a job whose machine never lifts its tool


class ToolFile(BaseModel):
    """The key `tools` of a job file."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    file: str
    unit_mm: Unit = 1.0


def take_tool_file(content: dict[str, Any], path: Path) -> None:
    """Replace the key `tools` of a job's content by `[[tool]]` tables, and note what of them was guessed.

    Raises JobError that names the file, and a tool that an operation uses and that is not there, or is none of ours.
    """
    told = content.pop("tools")
    form = validated(ToolFile, {"file": told} if isinstance(told, str) else told, f"{path} tools")
    own = _by_number(content.get("tool", []), path)
    used = {operation.tool for operation in content["operation"]}
    notes = []
    for stored in read_tools(path.parent / form.file, form.unit_mm):
        if stored.number in used:
            own[stored.number] = _keys(stored, own.get(stored.number, {}), form.file)
            notes += [
                Text(
                    "tool {stored_number} of {form_file}: {note}",
                    stored_number=stored.number,
                    form_file=form.file,
                    note=note,
                )
                for note in stored.notes
            ]
    for number in sorted(used - set(own)):
        what = Text(
            "an operation uses tool {number}, which neither the job nor {form_file} has",
            number=number,
            form_file=form.file,
        )
        raise JobError("tool-missing", what, advice="describe it in a [[tool]] table", place=Place(str(path)))
    content["tool"] = [own[number] for number in sorted(own)]
    content["notes"] = (*content.get("notes", ()), *notes)


def _keys(stored: StoredTool, own: dict[str, Any], file: str) -> dict[str, Any]:
    if "shape" in own and "diameter_mm" in own:
        return own
    return given_keys(stored.required(file)) | own


def _by_number(tables: Any, path: Path) -> dict[int, dict[str, Any]]:
    if not isinstance(tables, list) or not all(isinstance(table, dict) and "number" in table for table in tables):
        what, advice = "tool must be a list of tables with a number", "write [[tool]] and below it number = 1"
        raise JobError("bad-value", what, place=Place(str(path)), advice=advice)
    if len({table["number"] for table in tables}) < len(tables):
        advice = "give each tool its own number"
        raise JobError("bad-value", "two tools have the same number", place=Place(str(path)), advice=advice)
    return {table["number"]: table for table in tables}


HeightRow = Annotated[tuple[Coordinate, ...], Field(max_length=MOST_ITEMS["heights"])]


class StockForm(BaseModel):
    """The raw material as a job file names it.

    size_mm: of the box around it, for a cylinder diameter, diameter, height. heights_mm: of a height field over its
    bottom, rows along X from the front to the back; a job file names a file of them as `heights`. edge_mm: how far
    from a sheet's edge cuts must stay, if that matters.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    form: Literal["box", "sheet", "cylinder", "height_field"] = "box"
    size_mm: tuple[Length, Length, Length]
    origin: str
    heights_mm: tuple[HeightRow, ...] | None = Field(default=None, max_length=MOST_ITEMS["heights"])
    edge_mm: LengthOr0 | None = None

    @model_validator(mode="after")
    def _is_a_stock(self) -> StockForm:
        if (self.heights_mm is not None) != (self.form == "height_field"):
            raise ValueError("heights belong to a stock of the form 'height_field', and to no other")
        try:
            self.stock()
        except JobError as error:
            raise ValueError(Text("{error}; {advice}", error=error.what, advice=error.advice)) from error
        return self

    def stock(self) -> Stock:
        """Return the stock in work coordinates."""
        if self.form == "cylinder":
            return Cylinder(self.size_mm, self.origin)
        if self.heights_mm is not None:
            return HeightField(self.size_mm, self.origin, _rectangular(self.heights_mm))
        return Stock(self.size_mm, self.origin)

    def outline(self) -> Curve:
        """Return the stock's outline seen from above, in work coordinates."""
        stock = self.stock()
        if self.form == "cylinder":
            return circle(stock.outline.centroid.coords[0], self.size_mm[0] / 2.0)
        (left, front), (right, back) = stock.low_mm[:2], stock.high_mm[:2]
        return from_points([(left, front), (right, front), (right, back), (left, back)], closed=True)


def _rectangular(rows: tuple[tuple[float, ...], ...]) -> np.ndarray:
    if len({len(row) for row in rows}) != 1:
        raise JobError("stock-heights", "the rows of heights differ in length", advice="give every row as many")
    return np.array(rows, float)


class ClampForm(BaseModel):
    """A clamp as a job file names it: two opposite corners of a rectangle or those of a polygon, and its top's height.

    Both in work coordinates.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)

    corners_mm: tuple[tuple[Coordinate, Coordinate], ...] = Field(min_length=2, max_length=MOST_ITEMS["corners"])
    top_mm: Coordinate

    @model_validator(mode="after")
    def _encloses_something(self) -> ClampForm:
        try:
            self.clamp()
        except JobError as error:
            raise ValueError(Text("{error}; {advice}", error=error.what, advice=error.advice)) from error
        return self

    def clamp(self) -> Clamp:
        """Return the clamp that the tool keeps clear of."""
        return Clamp(self.corners_mm, self.top_mm)


class Job(BaseModel):
    """Everything that decides a program, besides the machine's own profile.

    units: of the program written only, "mm" is G21 and "inch" is G20; heights are above the stock's top.
    operation: cycles in the order in which they are cut, each already checked by its own model; none where only another
    program is proven with its machine, stock, tools and clamps. process: how it is cut. material: for milling of the
    table of materials, from which tools without feeds or speed take theirs; else of the cut chart, as consumable.
    chart: the file of the shop's own chart. cut_data: the row that was found there. notes: what a person should know of
    the files that curves and tools came from.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, arbitrary_types_allowed=True)

    units: Literal["mm", "inch"] = "mm"
    machine: str
    work_offset: str = "G54"
    process: ProcessName = "milling"
    clearance_mm: Height
    retract_mm: Height
    coolant: Literal["none", "mist", "flood"] = "none"
    material: str = ""
    consumable: str = ""
    chart: str = ""
    cut_data: CutData | None = None
    stock: StockForm
    clamp: tuple[ClampForm, ...] = Field(default=(), max_length=MOST_ITEMS["clamps"])
    tool: tuple[Tool, ...] = Field(min_length=1, max_length=MOST_ITEMS["tools"])
    operation: tuple[Any, ...] = Field(default=(), max_length=MOST_ITEMS["operations"])
    notes: tuple[str, ...] = Field(default=(), max_length=MOST_ITEMS["notes"])
    _has_z: bool = PrivateAttr(default=True)  # of the machine that the job is `on`
    _most_power: float = PrivateAttr(default=ON_RPM)
    _is_switch: bool = PrivateAttr(default=True)
    _starts_at_zero: bool = PrivateAttr(default=False)

    @model_validator(mode="after")
    def _parts_fit_together(self) -> Job:
        if self.work_offset not in WORK_SYSTEMS:
            raise ValueError(Text("work_offset must be one of {work_systems}", work_systems=", ".join(WORK_SYSTEMS)))
        if self.is_milled and self.material and self.material not in material_names():
            raise ValueError(
                Text(
                    "there is no material '{material}'; use one of: {material_names}",
                    material=self.material,
                    material_names=", ".join(material_names()),
                )
            )
        if self.clearance_mm < self.retract_mm:
            raise ValueError("clearance_mm must not be below retract_mm")
        numbers = [tool.number for tool in self.tool]
        if len(set(numbers)) < len(numbers):
            raise ValueError("two tools have the same number")
        for operation in self.operation:
            if operation.tool not in numbers:
                raise ValueError(
                    Text(
                        "operation '{cycle}' uses tool {tool}, which the job does not have",
                        cycle=operation.cycle,
                        tool=operation.tool,
                    )
                )
            self._check_shape(self.tools[operation.tool])
        return self

    def _check_shape(self, tool: Tool) -> None:
        """Raise ValueError for a tool that the process does not cut with; milling takes a laser's jet too, as ever."""
        if not self.is_milled and tool.shape not in self.cutting.shapes:
            shapes = ", ".join(self.cutting.shapes)
            raise ValueError(
                Text(
                    "{process} does not cut with a {shape} tool; its shape is one of: {shapes}",
                    process=self.process,
                    shape=tool.shape,
                    shapes=shapes,
                )
            )

    @classmethod
    def load(cls, path: str | Path) -> Job:
        """Return the job of a TOML or JSON file, its machine as `Machine.load` takes it; raises as `load_job` does."""
        job, _ = load_job(Path(path))
        return job.model_copy(update={"machine": machine_path(job.machine, Path(path).parent)})

    @property
    def tools(self) -> dict[int, Tool]:
        """The tools by number."""
        return {tool.number: tool for tool in self.tool}

    @property
    def tool_lengths_mm(self) -> dict[int, float]:
        """The length offsets by tool number, where the tools have one."""
        return {tool.number: tool.length_offset_mm for tool in self.tool if tool.length_offset_mm is not None}

    def on(self, machine: Machine) -> Job:
        """Return the job as that machine cuts it: tools without feeds have those of material or chart, if named.

        Raises JobError where the machine does not name the process, or the chart does not cover the job.
        """
        machine.process(self.process)
        row = self._row()
        copy = self.model_copy(update={"tool": tuple(self._fed(tool, row, machine) for tool in self.tool)})
        copy = copy.model_copy(update={"cut_data": row})
        copy._has_z = machine.has_z
        copy._is_switch = not machine.has_spindle
        copy._most_power = machine.spindle.max_rpm
        copy._starts_at_zero = dialect(machine.language()).starts_at_work_zero
        return copy

    def _row(self) -> CutData | None:
        """Return the chart's row; a job made without a file finds it in the chart that ships."""
        if self.cut_data or not (self.cutting.uses_chart and self.material):
            return self.cut_data
        return cut_data_for(self.process, self.material, self.stock.size_mm[2], self.consumable)

    def _fed(self, tool: Tool, row: CutData | None, machine: Machine) -> Tool:
        if row is not None:
            z_rate_mm_min = machine.axes[2].max_rate_mm_min if machine.has_z else row.feed_mm_min
            return filled(tool, self.cutting, row, z_rate_mm_min)
        return with_feeds(tool, material(self.material), machine) if self.is_milled and self.material else tool

    @property
    def begin(self) -> Start:
        """The position before the first operation, in work coordinates: the zero if the language starts there."""
        return Start.at_zero() if self._starts_at_zero else Start()

    @property
    def cutting(self) -> Process:
        """The process as data."""
        return PROCESSES[self.process]

    @property
    def is_milled(self) -> bool:
        """Whether the process is milling."""
        return self.process == MILLING.name

    def remarks(self, machine: Machine) -> dict[int, tuple[Remark, ...]]:
        """Return the values out of the range of tool or material on that machine, by tool; none without a material."""
        if not (self.is_milled and self.material):
            return {}
        used = {operation.tool for operation in self.operation}
        cutters = [tool for tool in self.tool if tool.number in used]
        return {tool.number: remarks_on(tool, material(self.material), machine) for tool in cutters}

    def started(self, start: Start | None, machine: Machine) -> Start | None:
        """Return `start` with the tools' length offsets, where programs for the machine select them; else unchanged.

        One that is not known is taken as 0. In a language without a word for tools the only one is in from the start.
        """
        used = {operation.tool for operation in self.operation}
        if len(used) == 1 and "T" not in dialect(machine.language()).letters:
            start = replace(start or Start(), tool=used.pop())
        if machine.tool_length != "table":
            return start
        start = start or Start()
        lengths_mm = {tool.number: tool.length_offset_mm or 0.0 for tool in self.tool}
        return replace(start, tool_lengths_mm=lengths_mm | start.tool_lengths_mm)

    @property
    def clamps(self) -> list[Clamp]:
        """What the tool keeps clear of."""
        return [clamp.clamp() for clamp in self.clamp]

    @property
    def cutters(self) -> str:
        """The tools in words for people."""
        return ", ".join(tool.words for tool in self.tool)

    def setup(self, operation: Cycle) -> Setup:
        """Return the job's data for that operation besides its own parameters."""
        keep: tuple[Curve, ...] = ()
        parts: tuple[tuple[Curve, ...], ...] = ()
        if depends_on_contours(operation):  # a cut is kept by its setup: no more
            others = [other for other in self.operation if other is not operation]
            if operation.cycle == "contour":
                keep = tuple(curve for other in others for curve in _kept_by(other))
            outside = [other for other in others if getattr(other, "side", "") == "outside"]
            parts = tuple(kept for kept in map(_kept_by, outside) if kept)  # threads have a side too, and keep nothing
        tool = self.tools[operation.tool]
        outline, thickness_mm = self.stock.outline(), self.stock.size_mm[2]
        row = self.cut_data and as_cut_by(self.cut_data, tool)
        given = (tool, self.clearance_mm, self.retract_mm, outline, keep, thickness_mm, parts)
        return Setup(*given, self.cutting, row, self._has_z, self._power_s(tool))

    def _power_s(self, tool: Tool) -> float:
        """Return the S with which a beam or wire is on; a torch has only on and off."""
        if self._is_switch:
            return ON_RPM
        share = (self.cut_data.power_percent if self.cut_data else 0.0) / 100.0
        return tool.spindle_rpm or (share or 1.0) * self._most_power


def depends_on_contours(operation: Cycle) -> bool:
    """Return whether the setup of an operation depends on the contours of the job."""
    return getattr(operation, "DEPENDS_ON_CONTOURS", False)


def _kept_by(operation: Cycle) -> tuple[Curve, ...]:
    """Return the outlines of the parts that a contour leaves."""
    return operation.kept() if operation.cycle == "contour" else ()  # type: ignore[attr-defined]


def load_job(path: Path, share: Share = lambda share: None) -> tuple[Job, Machine]:
    """Return the job of a TOML file, or of a JSON file that `save_job` wrote, and its machine.

    Paths in the file are relative to it. `share` is called with the share of a drawing that is read. Raises JobError
    that names the file, the key and its value.
    """
    job = read_job(path, share)
    if not job.operation:
        what, advice = "the job has no operation", "write the cuts as [[operation]]"
        raise JobError("operation-missing", what, advice=advice, place=Place(str(path)))
    with placed(Place(str(path))):
        return job, load_machine(machine_path(job.machine, path.parent))


def read_job(path: Path, share: Share = lambda share: None) -> Job:
    """Return the job as `load_job` does, without looking for its machine."""
    with placed(Place(str(path))):
        return _read(path, share)


def _read(path: Path, share: Share) -> Job:
    return job_of_content(read_json(path) if path.suffix.lower() == ".json" else read_toml(path), path, share)


def job_of_content(content: dict[str, Any], path: Path, share: Share = lambda share: None) -> Job:
    """Return the job that a file of this content at `path` holds; the content is used up. Raises as `load_job` does."""
    drawn = Drawn()
    shapes = read_shapes(_tables(content, "shape", path), path.parent, str(path), drawn, share)
    content.pop("shape", None)
    content["notes"] = (*_notes(content, path), *shapes.notes)
    first = {"tool": FIRST_TOOL} if process_of(content, str(path)).uses_chart else {}
    content["operation"] = tuple(
        operation_of(first | raw, path.parent, _numbered(path, number), shapes, drawn)
        for number, raw in enumerate(_tables(content, "operation", path), start=1)
    )
    if "tools" in content:
        take_tool_file(content, path)
    take_cut_data(content, path.parent, str(path))
    _take_heights(content, path.parent)
    if isinstance(stock := content.get("stock"), dict) and "heights" in stock:
        stock["heights_mm"] = read_heights(
            file_in_job_folder(path.parent, stock.pop("heights"), "stock.heights", str(path))
        )
    return validated(Job, content, str(path))


def _take_heights(content: dict[str, Any], folder: Path) -> None:
    """Give a job that names no heights those of a machine without Z, which has none."""
    missing = [key for key in ("clearance_mm", "retract_mm") if key not in content]
    name = content.get("machine")
    if missing and isinstance(name, str) and not _has_z(machine_path(name, folder)):
        content.update(dict.fromkeys(missing, NO_HEIGHT_MM))


def _has_z(machine: str) -> bool:
    """Return whether a machine has a Z; one that cannot be read is taken to have, and refused later."""
    try:
        return load_machine(machine).has_z
    except JobError:
        return True


def save_job(job: Job, path: Path) -> None:
    """Write the job as JSON, its curves within it, so that another process can make, prove and send it."""
    content = job.model_dump(mode="json") | {
        "operation": [operation.model_dump(mode="json") for operation in job.operation]
    }
    write_whole(path, (json.dumps(content, indent=1, allow_nan=False) + "\n").encode("utf-8"))


def _numbered(path: Path, number: int) -> Text:
    return Text("{path} operation {number}", path=path, number=number)


def operation_of(
    raw: dict[str, Any], folder: Path, file: str, shapes: Shapes = NO_SHAPES, drawn: Drawn | None = None
) -> Cycle:
    """Return the cycle that one `[[operation]]` table describes, the shapes that it names resolved into curves.

    `folder` is where its files are looked for; `drawn` counts what they hold. Raises JobError that
    names `file`, the key and its value.
    """
    with placed(Place(file)):
        model = cycle_class(raw.get("cycle", ""))
        content = with_curves(raw, shapes, file)
        if "points" in content:
            points = file_in_job_folder(folder, content.pop("points"), "points", file)
            content["curves"] = (read_points(points, closed=content.get("closed") is True),)
            (drawn or Drawn()).add(content["curves"])
        return validated(model, content, file)  # type: ignore[return-value]


def _tables(content: dict[str, Any], key: str, path: Path) -> list[dict[str, Any]]:
    tables, place = content.get(key, []), Place(str(path))
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise JobError(
            "bad-value",
            Text("{key} must be a list of tables", key=key),
            advice=Text("write [[{key}]]", key=key),
            place=place,
        )
    if len(tables) > (most := MOST_ITEMS[f"{key}s"]):
        what, advice = Text("{key} is too long", key=key), "make several jobs of this one"
        raise JobError("bad-value", what, value=f"{len(tables)}", limit=f"{most}", advice=advice, place=place)
    return tables


def _notes(content: dict[str, Any], path: Path) -> list[Any]:
    """Return the notes of a saved job; that they are texts is seen with the rest."""
    notes = content.get("notes", [])
    if not isinstance(notes, list):
        advice = 'write notes = ["…", "…"]'
        raise JobError("bad-value", "notes must be a list", value=shown(notes), place=Place(str(path)), advice=advice)
    return notes


def file_in_job_folder(folder: Path, name: Any, key: str, file: str) -> Path:
    """Return the path of a job's file, relative to its folder; raises JobError for a value of another type."""
    if not isinstance(name, str):
        advice = Text('write {key} = "file"', key=key)
        raise JobError(
            "bad-value", Text("{key} must name a file", key=key), value=shown(name), advice=advice, place=Place(file)
        )
    return folder / name


def machine_path(name: str, folder: Path) -> str:
    """Return what `load_machine` takes for the key machine of a job file in that folder."""
    return name if name in profile_names() else str(folder / name)
