# SPDX-License-Identifier: LGPL-2.1-or-later
"""The job file of a lathe: stock, chuck, tools, profiles, operations, validated whole before use.

    units = "mm"                    of the program
    machine = "mini-lathe"          a profile whose axes are x and z, or a file of one
    process = "turning"
    x_is = "diameter"               how this file gives X in points and `start`, and the program too: or "radius"
    distance = "absolute"           of the program, or "incremental"
    canned = false                  true: G70 to G72 along profiles and G76 for threads, where the controller has them
    material = "pvc"                of the materials of turning, for forces
    start = [80, 10]                x, z where the tool is when the program begins and between two tools
    [stock]                         z = 0 is the finished end face, z < 0 towards the chuck
    form = "bar"                    or "tube" with bore_mm
    diameter_mm = 55
    face_mm = 1                     how far the raw end lies over z = 0
    length_mm = 170                 from the chuck's face to z = 0: the chuck's face is at z = -length_mm
    [chuck]                         diameter_mm, jaw_mm: how far jaws of jaw_diameter_mm come out of its face, grip_n
    [tailstock]                     diameter_mm of its centre, angle_deg of its tip, on the axis at z = face_mm
    [[tool]]                        machine/tools/turning_tool.py
    [[profile]]                     job/turning/profile_form.py
    [[operation]]                   cycles/turning/turning_operation.py

Within the package Z has the signs of a right-handed lathe and X is the radius; `turned_coordinates.py` knows the
program's.
"""

from __future__ import annotations

from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import BaseModel, ConfigDict, Field, PrivateAttr, StrictBool, model_validator

from CNCStepper.cycles.turning.turning_operation import ALONG_PROFILES, TurningOperation, turning_operation_class
from CNCStepper.errors import JobError, Place, Text, placed
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.model import machine_path
from CNCStepper.job.turning.profile_form import Pair, ProfileForm, Xis
from CNCStepper.machine.files.toml_reader import read_toml
from CNCStepper.machine.materials import turned_materials
from CNCStepper.machine.profile import Machine, load_machine, validated
from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.quantities import MOST_ITEMS, Bounds, Length, LengthOr0, TipAngle, Width, WidthOr0

START_CLEAR_MM = 5.0  # of the tool before the program begins, from the raw end and the bar
WHOLE_TURN_TIP_DEG = 60.0  # of a tailstock's centre


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class TurnedStock(_Checked):
    """A bar or a tube: from the chuck's face at z = -length_mm to z = face_mm."""

    form: Literal["bar", "tube"] = "bar"
    diameter_mm: Length
    bore_mm: LengthOr0 = 0.0
    face_mm: LengthOr0 = 0.0
    length_mm: Length

    @model_validator(mode="after")
    def _is_a_ring(self) -> TurnedStock:
        if (self.form == "tube") != (self.bore_mm > 0):
            raise ValueError("bore_mm belongs to a stock of the form 'tube', and to no other")
        if self.bore_mm >= self.diameter_mm:
            limit = f"{self.diameter_mm:g} mm"
            raise ValueError(Text("bore_mm must be below diameter_mm, {limit}", limit=limit))
        return self


class Chuck(_Checked):
    """The chuck: its face at z = -length_mm of the stock; jaws of jaw_diameter_mm come jaw_mm out of it.

    grip_n: the force of all jaws, 0 where it is not known.
    """

    diameter_mm: Width = 100.0
    jaw_diameter_mm: WidthOr0 = 0.0
    jaw_mm: WidthOr0 = 0.0
    grip_n: Annotated[float, Bounds("force", zero=True)] = 0.0


class Tailstock(_Checked):
    """A tailstock's centre in the raw end: a cone of angle_deg, then a cylinder of diameter_mm away from the chuck."""

    diameter_mm: Width
    angle_deg: TipAngle = WHOLE_TURN_TIP_DEG
    hole_mm: WidthOr0 = 0.0


class TurningSetup(_Checked):
    """What a job of a lathe has before its operations: machine, bar, chuck and tools."""

    units: Literal["mm", "inch"] = "mm"
    machine: str
    process: Literal["turning"]
    x_is: Xis = "diameter"
    distance: Literal["absolute", "incremental"] = "absolute"
    canned: StrictBool = False
    material: str = ""
    coolant: Literal["none", "mist", "flood"] = "none"
    work_offset: str = "G54"
    start: Pair | None = None
    arc_tolerance_mm: Annotated[float, Bounds("tolerance", 0.0005, 0.1)] = 0.002
    stock: TurnedStock
    chuck: Chuck = Chuck()
    tailstock: Tailstock | None = None
    tool: tuple[TurningTool, ...] = Field(min_length=1, max_length=MOST_ITEMS["tools"])

    @model_validator(mode="after")
    def _setup_fits_together(self) -> Self:
        _require_different([tool.number for tool in self.tool], "number", "tools")
        self._check_chuck_and_start()
        if self.material and self.material not in (materials := turned_materials()):
            what = "no material of turning is called '{name}': it may be {names}"
            raise ValueError(Text(what, name=self.material, names=", ".join(materials)))
        z = self.start_zr[0]
        if z < self.stock.face_mm and self.start_zr[1] < self.stock.diameter_mm / 2:
            what = "the start is in the stock: its z must be at least {face:g} mm, or its x outside {diameter:g} mm"
            raise ValueError(Text(what, face=self.stock.face_mm, diameter=self.stock.diameter_mm))
        return self

    def _check_chuck_and_start(self) -> None:
        """Raise ValueError for jaws longer than the bar, or a start over the axis or between the jaws."""
        jaw_mm, length_mm, (z, r) = self.chuck.jaw_mm, self.stock.length_mm, self.start_zr
        if jaw_mm >= length_mm + self.stock.face_mm:
            what = "the jaws are longer than the bar: jaw_mm must be below {most:g} mm"
            raise ValueError(Text(what, most=length_mm + self.stock.face_mm))
        if r < 0:
            raise ValueError(Text("the start lies over the axis: its x is {x:g} mm, it must be at least 0", x=r))
        widest_mm = max(self.chuck.diameter_mm, self.chuck.jaw_diameter_mm)
        if z < jaw_mm - length_mm and r < widest_mm / 2:
            what = "the start is in the chuck: its z must be at least {z:g} mm, or its x outside {diameter:g} mm"
            raise ValueError(Text(what, z=jaw_mm - length_mm, diameter=widest_mm))

    @property
    def tools(self) -> dict[int, TurningTool]:
        """The tools by number."""
        return {tool.number: tool for tool in self.tool}

    @property
    def start_zr(self) -> tuple[float, float]:
        """Where the control point is when the program begins: z and radius in the part's coordinates, mm."""
        if self.start is None:
            return self.stock.face_mm + START_CLEAR_MM, self.stock.diameter_mm / 2 + START_CLEAR_MM
        x, z = self.start
        return z, x / 2 if self.x_is == "diameter" else x


class TurningJob(TurningSetup):
    """A whole job of a lathe; `_folder` is where its files are looked for."""

    profile: tuple[ProfileForm, ...] = Field(default=(), max_length=MOST_ITEMS["shapes"])
    operation: tuple[Any, ...] = Field(min_length=1, max_length=MOST_ITEMS["operations"])
    _folder: Path = PrivateAttr(default=Path())

    @model_validator(mode="after")
    def _operations_have_what_they_need(self) -> Self:
        _require_different([profile.name for profile in self.profile], "name", "profiles")
        names = [profile.name for profile in self.profile]
        for number, operation in enumerate(self.operation, start=1):
            if operation.tool not in self.tools:
                what = "operation {number} uses tool {tool}, which the job does not have: it has {tools}"
                known = ", ".join(map(str, self.tools))
                raise ValueError(Text(what, number=number, tool=operation.tool, tools=known))
            profile = getattr(operation, "profile", "")
            if profile not in names and (profile or operation.cycle in ALONG_PROFILES):
                what = "operation {number} turns the profile '{profile}', which the job does not have: it has {names}"
                known = ", ".join(names) or "none"
                raise ValueError(Text(what, number=number, profile=profile, names=known))
        return self

    @cached_property
    def curves(self) -> dict[str, Curve]:
        """The profiles by name, in (z, r)."""
        return {form.name: form.curve(self.x_is, self._folder) for form in self.profile}


def load_turning_job(path: Path) -> tuple[TurningJob, Machine]:
    """Return the job of a TOML file and its machine, a lathe or one with X and Z.

    Raises JobError that names the file, the key and its value.
    """
    with placed(Place(str(path))):
        job = turning_job_of(read_toml(path), path)
        return job, require_lathe(load_machine(machine_path(job.machine, path.parent)))


def require_lathe(machine: Machine) -> Machine:
    """Return the machine; raises JobError for one without X and Z."""
    if "x" not in machine.own_axes or "z" not in machine.own_axes:
        what = "the machine has no axes X and Z"
        raise JobError("machine-axes", what, value=machine.name, advice="name a profile with both")
    return machine


def turning_job_of(content: dict[str, Any], path: Path) -> TurningJob:
    """Return the job that a file of this content at `path` holds; raises JobError."""
    tables = content.get("operation", [])
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise JobError("bad-value", "operation must be a list of tables", advice="write [[operation]]")
    operations = tuple(_operation(table, number, path) for number, table in enumerate(tables, start=1))
    job = validated(TurningJob, {**content, "operation": operations}, str(path))
    job._folder = path.parent
    _ = job.curves  # drawn and checked with the file
    return job


def _operation(table: dict[str, Any], number: int, path: Path) -> TurningOperation:
    place = f"{path} operation {number}"
    with placed(Place(place)):
        return validated(turning_operation_class(table.get("cycle", "")), table, place)


def _require_different(values: list[Any], key: str, of_what: str) -> None:
    if len(set(values)) < len(values):
        raise ValueError(Text("two {of_what} have the same {key}", of_what=of_what, key=key))
