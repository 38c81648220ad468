# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine profile: axes, planner, spindle and outputs, read from TOML and checked whole."""

from __future__ import annotations

import tomllib
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from CNCStepper.errors import JobError, Place

AXIS_NAMES = ("x", "y", "z")
Model = TypeVar("Model", bound=BaseModel)


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class Axis(_Checked):
    """One axis; travel is in machine coordinates."""

    steps_per_mm: float = Field(gt=0)
    max_rate_mm_min: float = Field(gt=0)
    acceleration_mm_s2: float = Field(gt=0)
    backlash_mm: float = Field(default=0.0, ge=0)
    travel_min_mm: float
    travel_max_mm: float
    homing: Literal["min", "max", "none"] = "none"

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
