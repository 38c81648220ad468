# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine profile: axes, planner, spindle and outputs, read from TOML and checked whole."""

from __future__ import annotations

import math
import tomllib
from functools import cache
from importlib import resources
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, StrictBool, ValidationError, model_validator

from CNCStepper.errors import JobError, Text
from CNCStepper.input_file import is_there
from CNCStepper.machine.axis_drive import Drive
from CNCStepper.machine.files.readers import read_json, read_toml
from CNCStepper.machine.files.validation_errors import refusal_of
from CNCStepper.machine.step_wait_tables import Waits
from CNCStepper.machine.wiring import Input, Signals, check_apart
from CNCStepper.quantities import (
    MOST_ITEMS,
    Acceleration,
    Bounds,
    Coordinate,
    Feed,
    Jerk,
    Length,
    Speed,
    SpeedOr0,
    Tolerance,
)
from CNCStepper.safe_text import printable

AXIS_NAMES = ("x", "y", "z")
CALIBRATED = 0.02  # steps_per_mm, as measured, may differ from what the drive gives by this share
Model = TypeVar("Model", bound=BaseModel)
TorqueOr0 = Annotated[float, Bounds("torque", zero=True)]


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Motor(_Checked):
    """An axis' stepper motor and its load; without an encoder it loses steps where its torque does not suffice.

    travel_per_turn_mm: of the axis a turn of the motor (the screw's pitch, or the belt's travel). torque: points
    (rpm, Nm) of the pull-out torque, rising in speed. mass_kg: of what moves. inertia_kg_m2: of rotor, coupling and
    screw. force_n: friction, weight and cutting force together.
    """

    travel_per_turn_mm: Length
    torque: tuple[tuple[SpeedOr0, TorqueOr0], ...] = Field(min_length=1, max_length=MOST_ITEMS["torques"])
    mass_kg: Annotated[float, Bounds("mass", zero=True)]
    inertia_kg_m2: Annotated[float, Bounds("inertia", zero=True)] = 0.0
    force_n: Annotated[float, Bounds("force", zero=True)] = 0.0
    efficiency: Annotated[float, Bounds("share")] = 1.0

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
    """One axis; travel is in machine coordinates. Without its motor the motor's torque is not checked.

    drive: the axis' motor, gear and screw or belt, from which steps_per_mm follows where it is not given.
    """

    steps_per_mm: Annotated[float, Bounds("steps_per_mm")]
    max_rate_mm_min: Feed
    acceleration_mm_s2: Acceleration
    jerk_mm_s3: Jerk | None = None
    backlash_mm: Annotated[float, Bounds("length", 0.00001, zero=True)] = 0.0
    travel_min_mm: Coordinate
    travel_max_mm: Coordinate
    homing: Literal["min", "max", "none"] = "none"
    motor: Motor | None = None
    drive: Drive | None = None

    @model_validator(mode="before")
    @classmethod
    def _steps_follow_from_the_drive(cls, content: Any) -> Any:
        if not isinstance(content, dict) or "drive" not in content or "steps_per_mm" in content:
            return content
        try:
            return {**content, "steps_per_mm": Drive.model_validate(content["drive"]).pulses_per_mm}
        except ValidationError:  # what is wrong with the drive is told where it stands
            return {**content, "steps_per_mm": 1.0}

    @model_validator(mode="after")
    def _steps_agree_with_the_drive(self) -> Axis:
        if self.drive is not None and abs(self.drive.pulses_per_mm / self.steps_per_mm - 1.0) > CALIBRATED:
            raise ValueError(
                Text(
                    "steps_per_mm is {steps_per_mm:g}, but the drive gives {pulses_per_mm:g}",
                    steps_per_mm=self.steps_per_mm,
                    pulses_per_mm=self.drive.pulses_per_mm,
                )
            )
        return self

    @model_validator(mode="after")
    def _travel_is_ordered(self) -> Axis:
        if self.travel_min_mm >= self.travel_max_mm:
            raise ValueError("travel_min_mm must be below travel_max_mm")
        return self

    @model_validator(mode="after")
    def _backlash_is_small(self) -> Axis:
        if self.backlash_mm >= self.travel_max_mm - self.travel_min_mm:
            raise ValueError("backlash_mm must be below the travel of the axis")
        return self


LOOK_AHEAD_BLOCKS = 15  # of grbl as delivered


class Planner(_Checked):
    """What the controller's planner is set to ($11 and $12 of grbl), and how it changes speeds.

    look_ahead_blocks: as many moves, chords of arcs included, as it plans ahead.
    ramp: "trapezoid" (constant acceleration, as grbl), "s_curve" (every axis then has its jerk_mm_s3) or "table" (by
    the times of `waits`; every move then begins and ends at rest).
    """

    junction_deviation_mm: Tolerance
    arc_tolerance_mm: Tolerance
    look_ahead_blocks: Annotated[int, Bounds("count", 2, 100_000)] = LOOK_AHEAD_BLOCKS
    ramp: Literal["trapezoid", "s_curve", "table"] = "trapezoid"
    waits: Waits | None = None

    @model_validator(mode="after")
    def _table_has_waits(self) -> Planner:
        if (self.ramp == "table") != (self.waits is not None):
            raise ValueError('ramp = "table" and planner.waits belong together')
        return self


class Spindle(_Checked):
    """Speeds and the time to reach them; `laser` means M4 with power ($32=1)."""

    min_rpm: SpeedOr0
    max_rpm: Speed
    spin_up_s: Annotated[float, Bounds("time", most=3600.0, zero=True)] = 0.0
    laser: StrictBool = False


class Outputs(_Checked):
    """What can be switched."""

    coolant: list[Literal["mist", "flood"]] = Field(default=[], max_length=2)


class Retreat(_Checked):
    """What is on while the tool goes back along its cut and forward again.

    outputs: "keep" (spindle and coolant as they were) or "off"; left out, a laser's are off and others are kept. A
    torch or a jet that is switched as a spindle wants "off".
    """

    outputs: Literal["keep", "off"] | None = None


class Machine(_Checked):
    """A whole machine profile; the unit of each value is in its name.

    tool_change: "pause" (retract, M5, a message, M0), "split" (a file a tool) or "m6". tool_length: what is done about
    the length of a new tool: "touch_off" (the operator sets the Z zero with it), "table" (its length offset: G43 H, or
    G43.1 Z) or "none" (all tools stand out equally far). input: the machine's own buttons.
    """

    name: str
    controller: str
    tool_change: Literal["pause", "split", "m6"] = "pause"
    tool_length: Literal["touch_off", "table", "none"] = "touch_off"
    planner: Planner
    axis: dict[Literal["x", "y", "z"], Axis]
    spindle: Spindle
    outputs: Outputs = Outputs()
    retreat: Retreat = Retreat()
    signals: Signals = Signals()
    input: tuple[Input, ...] = Field(default=(), max_length=MOST_ITEMS["inputs"])

    @model_validator(mode="after")
    def _inputs_are_apart(self) -> Machine:
        check_apart(self.input)
        return self

    @model_validator(mode="after")
    def _has_three_axes(self) -> Machine:
        missing = [name for name in AXIS_NAMES if name not in self.axis]
        if missing:
            raise ValueError(Text("axis.{missing} is missing", missing=missing[0]))
        return self

    @model_validator(mode="after")
    def _s_curves_have_jerks(self) -> Machine:
        without = [name for name in AXIS_NAMES if self.axis[name].jerk_mm_s3 is None]  # type: ignore[index]
        if self.planner.ramp == "s_curve" and without:
            raise ValueError(
                Text('axis.{without}.jerk_mm_s3 is missing: ramp = "s_curve" needs it', without=without[0])
            )
        return self

    @classmethod
    def load(cls, name_or_path: str | Path) -> Machine:
        """Return the machine of a profile, as `load_machine` does."""
        return load_machine(name_or_path)

    @property
    def keeps_outputs_back(self) -> bool:
        """Whether spindle and coolant stay on while the tool goes back along its cut."""
        return self.retreat.outputs == "keep" or (self.retreat.outputs is None and not self.spindle.laser)

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
    """Return the machine of a shipped profile ("table-a"), of a TOML file, or of the same as JSON.

    Raises JobError when there is no such profile or a value in it is not allowed.
    """
    if str(name_or_path) in profile_names():
        return _shipped(str(name_or_path))
    path = Path(name_or_path)
    if not is_there(path):
        raise JobError(
            "machine-missing",
            Text("there is no machine profile '{name_or_path}'", name_or_path=printable(str(name_or_path), 300)),
            advice=Text("give a TOML file or one of: {profile_names}", profile_names=", ".join(profile_names())),
        )
    content = read_json(path) if path.suffix.lower() == ".json" else read_toml(path)
    return validated(Machine, content, str(path))


@cache
def _shipped(name: str) -> Machine:
    entry = resources.files("CNCStepper.machine") / "profiles" / f"{name}.toml"
    return validated(Machine, tomllib.loads(entry.read_text("utf-8")), name)


def validated(model: type[Model], content: dict[str, Any], file: str) -> Model:
    """Return `content` as a checked `model`; raises JobError that names the key, its value and what is wrong."""
    try:
        return model.model_validate(content)
    except ValidationError as error:
        raise refusal_of(model, error, file) from error
