# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every kind of quantity: its unit, the least and the most that makes sense, and why; the one place of such bounds.

    QUANTITIES["feed"] ──► Bounds("feed") ──► Feed, a type that a pydantic model takes      job files, profiles, FreeCAD
                                     └──► Bounds("feed").require(value, "--feed")           the command line

Beyond these bounds nothing physical lies: such a number is a slip (a lost decimal point, another unit) that would give
a program which no machine reads, or a calculation without end. Pure Python: pydantic is asked for only by its own hook.
"""

from __future__ import annotations

import reprlib
from dataclasses import dataclass
from typing import Annotated, Any

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.safe_text import printable

ERROR_TYPE = "quantity"  # of pydantic's error for a number out of its bounds
ROUNDING = 1e-9  # what is smaller is the rounding error of a calculation that gives 0, such as 0.1 + 0.2 - 0.3


@dataclass(frozen=True)
class Quantity:
    """A kind: its unit ("" for a bare number), the least and the most value, and why nothing beyond makes sense."""

    unit: str
    least: float
    most: float
    why: str


QUANTITIES: dict[str, Quantity] = {
    "coordinate": Quantity("mm", -100_000, 100_000, "no table is longer than 100 m"),
    "length": Quantity("mm", 0.001, 100_000, "no step is finer than a micron and no table longer than 100 m"),
    "height": Quantity("mm", 0.001, 10_000, "no axis lifts a tool by more than 10 m"),
    "depth": Quantity("mm", 0.001, 10_000, "no tool cuts thinner than a micron or deeper than 10 m"),
    "width": Quantity("mm", 0.001, 10_000, "no pass is narrower than a micron or wider than 10 m"),
    "tolerance": Quantity("mm", 0.0001, 10, "no machine holds a tenth of a micron, and above 10 mm nothing is held"),
    "unit": Quantity("mm", 1e-6, 1_000_000, "a drawing's unit lies between a nanometre and a kilometre"),
    "feed": Quantity("mm/min", 0.001, 1_000_000, "no axis runs faster than 16 m/s"),
    "acceleration": Quantity("mm/s²", 0.01, 1_000_000, "no axis speeds up by more than 100 g"),
    "jerk": Quantity("mm/s³", 0.01, 1_000_000_000, "no drive changes its acceleration faster"),
    "surface_speed": Quantity("m/min", 0.01, 10_000, "no cutter's edge runs faster than 170 m/s"),
    "chip_load": Quantity("mm", 0.00001, 10, "no tooth takes more than 10 mm"),
    "speed": Quantity("rpm", 0.01, 1_000_000, "no spindle turns faster than a million a minute"),
    "time": Quantity("s", 0.0001, 86_400, "nothing here waits for more than a day"),
    "wait": Quantity("ms", 0.001, 60_000, "a step comes between every microsecond and every minute"),
    "pulse": Quantity("µs", 0.01, 1_000_000, "a signal lasts between 10 ns and a second"),
    "angle": Quantity("deg", -36_000, 36_000, "a hundred turns are enough"),
    "slope": Quantity("deg", 0.01, 179.99, "an angle between two sides lies between 0 and 180 degrees"),
    "share": Quantity("", 0.0001, 1, "a share is at most the whole"),
    "ratio": Quantity("", 0.0001, 10_000, "no gear turns ten thousand times faster"),
    "factor": Quantity("", 0.000001, 1_000_000, "beyond a million nothing of the shape is left"),
    "count": Quantity("", 1, 1_000_000, "more than a million of anything is a slip"),
    "number": Quantity("", 0, 1_000_000, "a number that names something is short"),
    "pin": Quantity("", -25, 25, "a parallel port has 25 pins, and one below zero is active low"),
    "steps_per_mm": Quantity("steps/mm", 0.01, 1_000_000, "a step is between a nanometre and 100 mm"),
    "steps_per_turn": Quantity("", 1, 100_000_000, "no encoder counts more in a turn"),
    "steps_acceleration": Quantity("steps/s²", 0.0001, 1e12, "beyond these a step lasts over a minute or no time"),
    "torque": Quantity("Nm", 0.00001, 10_000, "no stepper motor gives more than 10 kNm"),
    "mass": Quantity("kg", 0.0001, 100_000, "nothing that an axis moves weighs more than 100 t"),
    "inertia": Quantity("kg·m²", 1e-12, 1_000, "no screw and rotor has more"),
    "percent": Quantity("%", 0.01, 1000, "more than ten times the whole is a slip"),
    "current": Quantity("A", 0.001, 10_000, "no torch or wire draws more than 10 kA"),
    "voltage": Quantity("V", 0.001, 10_000, "no arc or wire stands at more than 10 kV"),
    "pressure": Quantity("bar", 0.001, 10_000, "no jet is driven by more than 10 kbar"),
    "money": Quantity("", 0.0001, 1_000_000_000, "a rate is more than nothing and less than a thousand million"),
    "power": Quantity("W", 0.1, 1_000_000, "no spindle of a lathe or mill has more than 1 MW"),
    "specific_force": Quantity(
        "N/mm²", 1, 100_000, "no material needs more than 100 kN on a square millimetre of chip"
    ),
    "elasticity": Quantity("N/mm²", 1, 1_000_000, "no material is stiffer than diamond"),
    "force": Quantity("N", 0.0001, 1_000_000, "no axis pushes with more than 100 t"),
}

MOST_ITEMS: dict[str, int] = {  # of a list in a file; longer ones are a slip, and some work grows with their square
    "operations": 1_000,
    "tools": 256,
    "clamps": 1_000,
    "corners": 10_000,
    "shapes": 10_000,
    "curves": 20_000,
    "areas": 2_000,  # outlines and islands: every wall is measured against every other
    "points": 1_000_000,
    "heights": 5_000,  # rows of a height field, and values in a row
    "torques": 1_000,
    "inputs": 64,
    "speeds": 100,
    "materials": 1_000,
    "notes": 10_000,
    "diameters": 1_000,
    "cuts": 5_000,  # rows of a cut chart
}


@dataclass(frozen=True)
class Bounds:
    """The bounds of one key: those of its kind, narrower where `least` or `most` say so.

    zero: whether 0 is allowed too, where it means "none" or "not given"; rounding errors of 0 are 0. As an annotation
    (`Annotated[float, Bounds("feed")]`) it makes pydantic take only a number, no text and no truth value, within the
    bounds.
    """

    kind: str
    least: float | None = None
    most: float | None = None
    zero: bool = False

    @property
    def unit(self) -> str:
        """The unit of the values, "" for bare numbers."""
        return QUANTITIES[self.kind].unit

    @property
    def low(self) -> float:
        """The least value besides 0."""
        return QUANTITIES[self.kind].least if self.least is None else self.least

    @property
    def high(self) -> float:
        """The most."""
        return QUANTITIES[self.kind].most if self.most is None else self.most

    @property
    def words(self) -> Text:
        """The bounds for a person: "0.001 to 10000 mm, or 0"."""
        unit = f" {self.unit}" if self.unit else ""
        words = Text("{low:.10g} to {high:.10g}{unit}", low=self.low, high=self.high, unit=unit)
        return Text("{words}, or 0", words=words) if self.zero and self.low > 0 else words

    @property
    def advice(self) -> str:
        """What to do about a value out of the bounds, and why these are the bounds."""
        return Text("write a number within these bounds: {why}", why=QUANTITIES[self.kind].why)

    def allows(self, value: Any) -> bool:
        """Return whether a value is a number (no truth value, no text) within the bounds."""
        if isinstance(value, bool) or not isinstance(value, int | float):
            return False
        return bool(self.low <= value <= self.high) or (self.zero and _is_zero(value))

    def refusal(self, value: Any, says: str, place: Place | None = None) -> JobError:
        """Return the error for a value that is not allowed; `says` is how its key or option is called."""
        is_number = isinstance(value, int | float) and not isinstance(value, bool)
        what = Text("{says} is out of range", says=says) if is_number else Text("{says} is no number", says=says)
        said = with_unit(value, self.unit) if is_number else shown(value)
        return JobError("quantity", what, value=said, limit=self.words, advice=self.advice, place=place)

    def require(self, value: Any, says: str, place: Place | None = None) -> float:
        """Return `value` as a float; raises JobError that names `says`, value, limit and why for one not allowed."""
        if not self.allows(value):
            raise self.refusal(value, says, place)
        return 0.0 if self.low > 0 and _is_zero(value) else float(value)

    def __get_pydantic_core_schema__(self, source: Any, handler: Any) -> Any:
        """Return pydantic's schema for a number within the bounds, which it checks itself."""
        from pydantic_core import core_schema

        zero, kind = self.zero and self.low > 0, handler(source)
        least = -ROUNDING if kind["type"] == "float" else 0
        kind |= {"strict": True, "ge": least if zero else _whole(self.low), "le": _whole(self.high)}
        if kind["type"] == "float":
            kind["allow_inf_nan"] = False
        schema = core_schema.no_info_after_validator_function(self._not_between, kind) if zero else kind
        number = Text("a whole number") if kind["type"] == "int" else Text("a number")
        return core_schema.custom_error_schema(
            schema,
            custom_error_type=ERROR_TYPE,
            custom_error_message="{sentence}",
            custom_error_context={
                "sentence": Text("must be {number} from {words}", number=number, words=self.words),
                "number": number,
                "bounds": self.words,
                "unit": self.unit,
                "low": self.low,
                "high": self.high,
                "zero": self.zero,
                "advice": Text(
                    "write {number} within these bounds: {why}", number=number, why=QUANTITIES[self.kind].why
                ),
            },
        )

    def _not_between(self, value: float) -> float:
        if not self.allows(value):
            raise ValueError("above 0 and below the least")
        return 0.0 if isinstance(value, float) and _is_zero(value) else value


def _is_zero(value: float) -> bool:
    return abs(value) <= ROUNDING


def _whole(bound: float) -> float | int:
    """Return a bound as an int where it is one: pydantic wants such for whole numbers."""
    return int(bound) if float(bound).is_integer() else bound


def shown(value: Any, most: int = 60) -> str:
    """Return any value of a file in few words: no depth, length or number of digits makes this slow or fail."""
    short = reprlib.Repr()
    short.maxlevel, short.maxstring, short.maxother, short.maxlong = 2, most, most, most
    try:
        return printable(short.repr(value), most)
    except (ValueError, RecursionError):  # Python writes no int of more than 4300 digits
        return Text("a number of thousands of digits") if isinstance(value, int) else f"a {type(value).__name__}"


def with_unit(value: float, unit: str) -> str:
    """Return a number as a person reads it, with its unit; any int, inf and NaN too."""
    try:
        text = f"{float(value):.10g}"
    except OverflowError:
        return Text("a number of hundreds of digits")
    return f"{text} {unit}".strip()


Coordinate = Annotated[float, Bounds("coordinate")]
Length = Annotated[float, Bounds("length")]
LengthOr0 = Annotated[float, Bounds("length", zero=True)]
Height = Annotated[float, Bounds("height")]
Depth = Annotated[float, Bounds("depth")]
DepthOr0 = Annotated[float, Bounds("depth", zero=True)]
Width = Annotated[float, Bounds("width")]
WidthOr0 = Annotated[float, Bounds("width", zero=True)]
Feed = Annotated[float, Bounds("feed")]
FeedOr0 = Annotated[float, Bounds("feed", zero=True)]
Acceleration = Annotated[float, Bounds("acceleration")]
Jerk = Annotated[float, Bounds("jerk")]
Speed = Annotated[float, Bounds("speed")]
SpeedOr0 = Annotated[float, Bounds("speed", zero=True)]
ChipLoadOr0 = Annotated[float, Bounds("chip_load", zero=True)]
TimeOr0 = Annotated[float, Bounds("time", zero=True)]
Angle = Annotated[float, Bounds("angle")]
Turn = Annotated[float, Bounds("angle", -360.0, 360.0)]
EntryAngle = Annotated[float, Bounds("slope", 0.1, 45.0)]
TipAngle = Annotated[float, Bounds("slope")]
Tolerance = Annotated[float, Bounds("tolerance")]
CutTolerance = Annotated[float, Bounds("tolerance", 0.003, 1.0)]  # of a cycle's path
Ratio = Annotated[float, Bounds("ratio")]
Unit = Annotated[float, Bounds("unit")]
ToolNumber = Annotated[int, Bounds("number", 0, 255)]
ToolReference = Annotated[int, Bounds("number")]  # of an operation: the job says which there are


def duration_text(time_s: float) -> str:
    """Return a time as people read it, for example "1 h 02 min 05 s"."""
    whole = round(time_s)
    hours, minutes, seconds = whole // 3600, whole // 60 % 60, whole % 60
    if hours:
        return f"{hours} h {minutes:02d} min {seconds:02d} s"
    return f"{minutes} min {seconds:02d} s" if minutes else f"{time_s:.1f} s"
