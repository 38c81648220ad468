# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine profile: axes, planner, spindle and outputs, read from TOML and checked whole."""

from __future__ import annotations

import math
import tomllib
from functools import cache
from importlib import resources
from itertools import pairwise
from pathlib import Path
from typing import Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from CNCStepper.errors import JobError, Place

AXIS_NAMES = ("x", "y", "z")
Model = TypeVar("Model", bound=BaseModel)


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Motor(_Checked):
    """An axis' stepper motor and its load; without an encoder it loses steps where its torque does not suffice.

    travel_per_turn_mm: of the axis a turn of the motor (the screw's pitch, or the belt's travel). torque: points
    (rpm, Nm) of the pull-out torque, rising in speed. mass_kg: of what moves. inertia_kg_m2: of rotor, coupling and
    screw. force_n: friction, weight and cutting force together.
    """

    travel_per_turn_mm: float = Field(gt=0)
    torque: tuple[tuple[float, float], ...] = Field(min_length=1)
    mass_kg: float = Field(ge=0)
    inertia_kg_m2: float = Field(default=0.0, ge=0)
    force_n: float = Field(default=0.0, ge=0)
    efficiency: float = Field(default=1.0, gt=0, le=1)

    @model_validator(mode="after")
    def _torque_is_a_curve(self) -> Motor:
        speeds = [rpm for rpm, _ in self.torque]
        if speeds[0] < 0 or any(one >= next_ for one, next_ in pairwise(speeds)):
            raise ValueError("torque must be points (rpm, Nm) that rise in rpm")
        if any(torque_nm < 0 for _, torque_nm in self.torque):
            raise ValueError("torque must not be below zero")
        return self

    def rpm_at(self, speed_mm_s: float) -> float:
        """Return how fast the motor turns at a speed of its axis."""
        return abs(speed_mm_s) / self.travel_per_turn_mm * 60.0

    def torque_at_nm(self, rpm: float) -> float:
        """Return the pull-out torque at a speed; none beyond the last point, before the first that of the first."""
        speeds, torques = zip(*self.torque, strict=True)
        for k in range(1, len(speeds)):
            if speeds[k - 1] <= rpm <= speeds[k]:
                share = (rpm - speeds[k - 1]) / (speeds[k] - speeds[k - 1])
                return torques[k - 1] + (torques[k] - torques[k - 1]) * share
        return torques[0] if rpm <= speeds[0] else 0.0

    def needed_nm(self, acceleration_mm_s2: float) -> float:
        """Return the torque that moves the load against its force while it speeds up."""
        lead_m_rad = self.travel_per_turn_mm / 1000.0 / math.tau
        acceleration_m_s2 = abs(acceleration_mm_s2) / 1000.0
        force_n = self.mass_kg * acceleration_m_s2 + self.force_n
        return self.inertia_kg_m2 * acceleration_m_s2 / lead_m_rad + force_n * lead_m_rad / self.efficiency


class Axis(_Checked):
    """One axis; travel is in machine coordinates. Without its motor the motor's torque is not checked."""

    steps_per_mm: float = Field(gt=0)
    max_rate_mm_min: float = Field(gt=0)
    acceleration_mm_s2: float = Field(gt=0)
    backlash_mm: float = Field(default=0.0, ge=0)
    travel_min_mm: float
    travel_max_mm: float
    homing: Literal["min", "max", "none"] = "none"
    motor: Motor | None = None

    @model_validator(mode="after")
    def _travel_is_ordered(self) -> Axis:
        if self.travel_min_mm >= self.travel_max_mm:
            raise ValueError("travel_min_mm must be below travel_max_mm")
        return self


class Planner(_Checked):
    """What the controller's planner is set to ($11 and $12 of grbl)."""

    junction_deviation_mm: float = Field(gt=0)
    arc_tolerance_mm: float = Field(gt=0)


class Spindle(_Checked):
    """Speeds and the time to reach them; `laser` means M4 with power ($32=1)."""

    min_rpm: float = Field(ge=0)
    max_rpm: float = Field(gt=0)
    spin_up_s: float = Field(default=0.0, ge=0)
    laser: bool = False


class Outputs(_Checked):
    """What can be switched."""

    coolant: list[Literal["mist", "flood"]] = []


class Machine(_Checked):
    """A whole machine profile; the unit of each value stands in its name."""

    name: str
    controller: str
    tool_change: Literal["pause", "split", "m6"] = "pause"
    planner: Planner
    axis: dict[Literal["x", "y", "z"], Axis]
    spindle: Spindle
    outputs: Outputs = Outputs()

    @model_validator(mode="after")
    def _has_three_axes(self) -> Machine:
        missing = [name for name in AXIS_NAMES if name not in self.axis]
        if missing:
            raise ValueError(f"axis.{missing[0]} is missing")
        return self

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes in the order x, y, z."""
        return tuple(self.axis[name] for name in AXIS_NAMES)  # type: ignore[index]


def profile_names() -> list[str]:
    """Return the names of the profiles that ship with the product."""
    return list(_profile_names())


@cache
def _profile_names() -> tuple[str, ...]:
    folder = resources.files("CNCStepper.machine") / "profiles"
    return tuple(sorted(entry.name[:-5] for entry in folder.iterdir() if entry.name.endswith(".toml")))


def load_machine(name_or_path: str | Path) -> Machine:
    """Return the machine of a shipped profile ("table-a") or of a TOML file.

    Raises JobError when there is no such profile or a value in it is not allowed.
    """
    if str(name_or_path) in profile_names():
        return _shipped(str(name_or_path))
    path = Path(name_or_path)
    if not path.is_file():
        raise JobError(
            "machine-missing",
            f"there is no machine profile '{name_or_path}'",
            advice=f"give a TOML file or one of: {', '.join(profile_names())}",
        )
    return validated(Machine, read_toml(path), str(path))


@cache
def _shipped(name: str) -> Machine:
    entry = resources.files("CNCStepper.machine") / "profiles" / f"{name}.toml"
    return validated(Machine, tomllib.loads(entry.read_text("utf-8")), name)


def read_toml(path: Path) -> dict[str, Any]:
    """Return the content of a TOML file; raises JobError naming the file and line."""
    try:
        return tomllib.loads(path.read_text("utf-8-sig"))
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise JobError("toml", f"not a TOML file: {error}", place=Place(str(path))) from error


def validated(model: type[Model], content: dict[str, Any], file: str) -> Model:
    """Return `content` as a checked `model`; raises JobError that names the key, its value and what is wrong."""
    try:
        return model.model_validate(content)
    except ValidationError as error:
        raise _refusal(model, error, file) from error


def _refusal(model: type[BaseModel], error: ValidationError, file: str) -> JobError:
    """Return the first thing that is wrong; a key that nobody knows comes first, for it may be the missing one."""
    problems = error.errors()
    unknown = [problem for problem in problems if problem["type"] == "extra_forbidden"]
    first = (unknown or problems)[0]
    key = ".".join(str(part) for part in first["loc"])
    place = Place(file)
    if unknown:
        advice = f"correct its spelling or take it out; known are: {', '.join(sorted(model.model_fields))}"
        return JobError("bad-value", f"there is no key {key}", advice=advice, place=place)
    what = first["msg"].removeprefix("Value error, ")
    if not key:
        return JobError("bad-value", what, advice="correct that", place=place)
    return JobError(
        "bad-value", f"{key}: {what}", value=repr(first["input"])[:60], advice="correct that key", place=place
    )
