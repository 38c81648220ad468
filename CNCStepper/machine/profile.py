# SPDX-License-Identifier: LGPL-2.1-or-later
"""The machine profile: axes, planner, spindle and outputs, read from TOML and checked whole."""

from __future__ import annotations

import math
import tomllib
from collections.abc import Set
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Literal, TypeVar

from pydantic import BaseModel, ConfigDict, Field, StrictBool, ValidationError, model_serializer, model_validator

from CNCStepper.errors import JobError, Text
from CNCStepper.input_file import is_there
from CNCStepper.machine.axis_drive import Drive
from CNCStepper.machine.controller_family import LANGUAGES, WIRE_LANGUAGE, family_of, makes_pulses
from CNCStepper.machine.files.profile_files import own_names, own_path, shipped_file, shipped_names
from CNCStepper.machine.files.toml_reader import read_json, read_toml
from CNCStepper.machine.files.validation_errors import refusal_of
from CNCStepper.machine.lathe_link import LatheLink
from CNCStepper.machine.processes import PROCESSES, Process, ProcessName, process_named
from CNCStepper.machine.step_wait_tables import Waits
from CNCStepper.machine.wiring import DEVICES, Input, Relay, Signals, check_apart, check_relays
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
WITHOUT_FEED_WORDS = ("thesis-a",)  # languages in which the speeds of cuts and rapids are settings of the machine
CALIBRATED = 0.02  # measured steps_per_mm may differ from the drive's by this share
Model = TypeVar("Model", bound=BaseModel)
Interpolation = Literal["planner", "dda", "published"]
TorqueOr0 = Annotated[float, Bounds("torque", zero=True)]


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, defer_build=True)


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
        except ValidationError:  # errors of the drive are reported at its own keys
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
    """Speeds and the time to reach them; `laser` means M4 with power ($32=1).

    preset_rpm: the speeds that a gear or a switch has, rising; empty where any speed can be set. power_w: of the motor,
    0 where it is not known.
    """

    min_rpm: SpeedOr0
    max_rpm: Speed
    preset_rpm: tuple[Speed, ...] = Field(default=(), max_length=MOST_ITEMS["speeds"])
    spin_up_s: Annotated[float, Bounds("time", most=3600.0, zero=True)] = 0.0
    power_w: Annotated[float, Bounds("power", zero=True)] = 0.0
    laser: StrictBool = False

    @model_serializer(mode="wrap")
    def _without_empty(self, as_dict: Any) -> dict[str, Any]:
        """Leave no presets and no power out, so that certificates stay what they were."""
        return {key: value for key, value in as_dict(self).items() if value or key not in ("preset_rpm", "power_w")}


class Outputs(_Checked):
    """What can be switched."""

    coolant: list[Literal["mist", "flood"]] = Field(default=[], max_length=2)


class Retreat(_Checked):
    """What is on while the tool goes back along its cut and forward again.

    outputs: "keep" (spindle and coolant as they were) or "off"; left out, those of a laser, a torch or a jet are off,
    others are kept. A torch that a milling machine switches as its spindle wants "off".
    """

    outputs: Literal["keep", "off"] | None = None


Money = Annotated[float, Bounds("money", zero=True)]


class Rates(_Checked):
    """What work on the machine costs, in `currency`; what is left out costs nothing.

    per_hour: of the planned time. per_metre: of the length cut. per_pierce. per_sheet: to put a sheet on the table and
    take it off. per_square_metre: of sheet, by material as orders name it; the key "other" is any other material.
    """

    currency: Annotated[str, Field(max_length=8)] = ""
    per_hour: Money = 0.0
    per_metre: Money = 0.0
    per_pierce: Money = 0.0
    per_sheet: Money = 0.0
    per_square_metre: dict[str, Money] = Field(default={}, max_length=MOST_ITEMS["materials"])

    def square_metre_of(self, material: str) -> float:
        """Return what a square metre of a material costs."""
        return self.per_square_metre.get(material, self.per_square_metre.get("other", 0.0))


NO_AXIS = Axis(  # what planner and step generators take for an axis that is not there; it never moves
    steps_per_mm=100.0,
    max_rate_mm_min=1000.0,
    acceleration_mm_s2=100.0,
    jerk_mm_s3=1000.0,
    travel_min_mm=-1.0,
    travel_max_mm=1.0,
)
SWITCHED = Spindle(min_rpm=0.0, max_rpm=1.0)  # means no spindle: a torch is off at 0 and on at 1
ON_RPM = SWITCHED.max_rpm


class Machine(_Checked):
    """A whole machine profile; the unit of each value is in its name.

    processes: what it can do, without the key milling, and laser where the spindle is one. feed_mm_min, rapid_mm_min:
    the speeds of a language that has no words for them; the first also what a program without F takes. tool_change:
    "pause" (retract, M5, a message, M0), "split" (a file a tool) or "m6". tool_length: what is done about the length of
    a new tool: "touch_off" (the operator sets the Z zero with it), "table" (its length offset: G43 H, or G43.1 Z) or
    "none" (all tools stand out equally far). interpolation: of pulses that this computer makes: "planner" (our own), or
    the digital differential analyser of the published table, "dda" with our registers, "published" with its own.
    axis: x, y and, where the table has one, z; of a lathe x and z. spindle: left out, the torch is a switch (M3 and M5
    without S), or the machine has none. input: the machine's own buttons. relay: what the keys of the dock switch, by
    the machine's own words. link: of the mini-lathe. rates: of orders and offers.
    """

    name: str
    controller: str
    processes: tuple[ProcessName, ...] = Field(default=(), min_length=1, max_length=len(PROCESSES))
    feed_mm_min: Feed | None = None
    rapid_mm_min: Feed | None = None
    tool_change: Literal["pause", "split", "m6"] = "pause"
    tool_length: Literal["touch_off", "table", "none"] = "touch_off"
    interpolation: Interpolation = "planner"
    planner: Planner
    axis: dict[Literal["x", "y", "z"], Axis]
    spindle: Spindle = SWITCHED
    outputs: Outputs = Outputs()
    retreat: Retreat = Retreat()
    signals: Signals = Signals()
    input: tuple[Input, ...] = Field(default=(), max_length=MOST_ITEMS["inputs"])
    link: LatheLink | None = None
    relay: tuple[Relay, ...] = Field(default=(), max_length=len(DEVICES))
    rates: Rates | None = None

    @model_validator(mode="before")
    @classmethod
    def _mills_where_nothing_is_said(cls, content: Any) -> Any:
        if not isinstance(content, dict) or "processes" in content:
            return content
        spindle = content.get("spindle")
        is_laser = spindle.get("laser") is True if isinstance(spindle, dict) else getattr(spindle, "laser", False)
        return {**content, "processes": _usual_processes(is_laser)}

    @model_serializer(mode="wrap")
    def _without_what_is_usual(self, as_dict: Any) -> dict[str, Any]:
        """Omit default values, so that certificates of older profiles stay valid."""
        usual: dict[str, Any] = {"feed_mm_min": None, "rapid_mm_min": None, "interpolation": "planner"}
        usual |= {"link": None, "relay": (), "rates": None}
        usual["processes"] = _usual_processes(self.spindle.laser)
        if not self.has_spindle:
            usual["spindle"] = self.spindle
        told = {key for key in usual if getattr(self, key) != usual[key]}
        return {key: value for key, value in as_dict(self).items() if key in told or key not in usual}

    @model_validator(mode="after")
    def _inputs_are_apart(self) -> Machine:
        check_apart(self.input)
        check_relays(self.relay)
        if family_of(self) != "parport" and any(entry.is_own for entry in self.input):
            raise ValueError("a pin with a number has a port: the device file of its parallel port")
        return self

    @model_validator(mode="after")
    def _has_its_axes(self) -> Machine:
        second = "z" if self.is_lathe or "z" in self.axis else "y"  # a lathe of another controller has no Y either
        missing = [name for name in ("x", second) if name not in self.axis]
        if missing:
            raise ValueError(Text("axis.{missing} is missing", missing=missing[0]))
        return self

    @model_validator(mode="after")
    def _s_curves_have_jerks(self) -> Machine:
        without = [name for name, axis in self.own_axes.items() if axis.jerk_mm_s3 is None]
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
        is_torch = self.cuts_standing and "contour" in self._powers
        is_off = self.spindle.laser or is_torch
        return self.retreat.outputs == "keep" or (self.retreat.outputs is None and not is_off)

    @property
    def _powers(self) -> Set[str]:
        return {PROCESSES[name].power for name in self.processes} - {"none"}

    @property
    def cuts_standing(self) -> bool:
        """Whether the tool keeps cutting at rest: a laser, or all that has power is a torch, a jet or a hot wire."""
        return self.spindle.laser or (bool(self._powers) and "operation" not in self._powers)

    @property
    def stand_s(self) -> float:
        """How long the tool may stand with power; a laser's controller takes it by itself."""
        if self.spindle.laser or not self.cuts_standing:
            return math.inf
        return min(PROCESSES[name].stand_s for name in self.processes if PROCESSES[name].power != "none")

    @property
    def run_up_mm(self) -> float:
        """How far behind an interruption a cut begins again, in its own kerf."""
        if self.spindle.laser or not self.cuts_standing:
            return 0.0
        return max(PROCESSES[name].run_up_mm for name in self.processes)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The axes in the order x, y, z; for one that is not there one that never moves."""
        return tuple(self.own_axes.get(name, NO_AXIS) for name in AXIS_NAMES)

    @property
    def own_axes(self) -> dict[str, Axis]:
        """The axes that are there, by name, in the order x, y, z."""
        return {name: self.axis[name] for name in AXIS_NAMES if name in self.axis}  # type: ignore[index]

    @property
    def numbered_axes(self) -> list[tuple[int, str, Axis]]:
        """The axes that are there, each with its number among x, y, z and its name."""
        return [(AXIS_NAMES.index(name), name, axis) for name, axis in self.own_axes.items()]

    @property
    def is_lathe(self) -> bool:
        """Whether it turns: X is the radius and there is no Y."""
        return family_of(self) == "lathe"

    @property
    def has_z(self) -> bool:
        """Whether the tool can be lifted."""
        return "z" in self.axis

    @property
    def has_spindle(self) -> bool:
        """Whether M3 takes an S: the profile has a spindle, or a laser's or wire's power."""
        return self.spindle != SWITCHED

    @property
    def switches_power(self) -> bool:
        """Whether a process of the machine switches its power, by M3 without S where there is no spindle."""
        return any(PROCESSES[name].power in ("contour", "always") for name in self.processes)

    @property
    def fastest_mm_min(self) -> float:
        """The speed of rapids: the profile's own, else the fastest axis'."""
        return self.rapid_mm_min or max(axis.max_rate_mm_min for axis in self.own_axes.values())

    @property
    def rapid_limit_mm_min(self) -> float | None:
        """The speed of rapids along the path, where the controller's language leaves it to the machine; else None."""
        return self.rapid_mm_min if self.controller in WITHOUT_FEED_WORDS else None

    def process(self, name: str) -> Process:
        """Return the process of that name; raises JobError where there is none, or not on this machine."""
        process = process_named(name)
        if process.name not in self.processes:
            raise JobError(
                "process-machine",
                Text("{machine} does not cut by {process}", machine=self.name, process=process.name),
                value=process.name,
                limit=", ".join(self.processes),
                advice=Text("use one of: {processes}", processes=", ".join(self.processes)),
            )
        return process

    def wire_language(self, dialect: str = "") -> str:
        """Return the language of the lines that are sent of a program in a dialect: its own, or that of our pulses."""
        base = (dialect or LANGUAGES.get(self.controller, self.controller)).partition(":")[0]
        return self.language(WIRE_LANGUAGE if makes_pulses(self) and base != WIRE_LANGUAGE else dialect)

    def language(self, dialect: str = "", feed_mm_min: float = 0.0) -> str:
        """Return the dialect, the controller's where none is given, with settings for what this machine lacks.

        feed_mm_min: what a program without F takes; 0 is the profile's feed_mm_min, where it has one.
        """
        base, _, own = (dialect or LANGUAGES.get(self.controller, self.controller)).partition(":")
        settings = [setting for setting in own.split(",") if setting]
        told = {setting.partition("=")[0] for setting in settings}
        feed_mm_min = feed_mm_min or self.feed_mm_min or 0.0
        lacks = {
            "z": "" if self.has_z else "none",
            "spindle": self._spindle_setting(base),
            "feed": f"{feed_mm_min:.10g}" if feed_mm_min else "",
            "outputs": "pins" if base == WIRE_LANGUAGE and makes_pulses(self) else "",
        }
        settings += [f"{key}={value}" for key, value in lacks.items() if value and key not in told]
        return base + ":" * bool(settings) + ",".join(settings)

    def _spindle_setting(self, dialect: str) -> str:
        if dialect in WITHOUT_FEED_WORDS:
            return "always" if "hot-wire" in self.processes else ""
        if self.has_spindle:
            return ""
        return "switch" if self.switches_power else "none"


def _usual_processes(is_laser: bool) -> tuple[ProcessName, ...]:
    return ("milling", "laser") if is_laser else ("milling",)


def profile_names() -> list[str]:
    """Return the names of the profiles that ship with the product and of the user's own."""
    return sorted({*shipped_names(), *own_names()})


def load_machine(name_or_path: str | Path) -> Machine:
    """Return the machine of a profile of `profile_names`, of a TOML file, or of the same as JSON.

    The user's own profile takes the place of a shipped one of its name. Raises JobError when there is no such profile
    or a value in it is not allowed.
    """
    own = own_path(str(name_or_path))
    if own is None and str(name_or_path) in shipped_names():
        return _shipped(str(name_or_path))
    path = own or Path(name_or_path)
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
    return validated(Machine, tomllib.loads(shipped_file(name).read_text("utf-8")), name)


def validated(model: type[Model], content: dict[str, Any], file: str) -> Model:
    """Return `content` as a checked `model`; raises JobError with the key, its value and the error."""
    try:
        return model.model_validate(content)
    except ValidationError as error:
        raise refusal_of(model, error, file) from error
