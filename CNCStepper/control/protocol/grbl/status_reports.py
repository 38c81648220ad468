# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parses the reports of grbl 1.1, line by line, into values; pure functions of the text.

    ok · error:n                    the answer to one line, the only ones that free the buffer
    ALARM:n · [TAG:text] · $n=v     said without being counted; so are named settings, $N0=text
    >line:ok · Grbl 1.1h [...]      a start-up line and its result; the greeting after a reset
    <State:sub|Field:values|...>    the answer to `?`, its fields in any order

A line that is none of these is `Unknown`, a status with a state or a number that no firmware writes is `Damaged`:
noise on the link must never look like an answer.

The numbers in a controller's reports: plain decimals within bounds, so that noise is refused instead of believed.

Python's own `int` and `float` also take `1_0`, `nan`, `1e999`, and fail in their own way on 5000 digits.
"""

from __future__ import annotations

import re
from dataclasses import dataclass

from CNCStepper.errors import Text
from CNCStepper.word_pattern import DECIMAL

MOST = 1e7  # of any position, speed or setting, in whatever unit
MOST_COUNT = 100_000  # of a code, of free blocks and bytes
_DECIMAL = re.compile(DECIMAL)
_COUNT = re.compile(r"[0-9]+")
_LONGEST = 24  # characters of the longest number that a firmware writes


def decimal(text: str) -> float:
    """Return a number as a firmware writes it, without exponent; raises ValueError beyond `MOST` or for other text."""
    value = float(_matched(_DECIMAL, text))
    if abs(value) > MOST:
        raise ValueError(Text("a number beyond {most:g}: {text}", most=MOST, text=text))
    return value


def count(text: str) -> int:
    """Return a whole number without sign; raises ValueError beyond `MOST_COUNT` or for other text."""
    value = int(_matched(_COUNT, text))
    if value > MOST_COUNT:
        raise ValueError(Text("a number beyond {most_count}: {text}", most_count=MOST_COUNT, text=text))
    return value


def code(text: str) -> int:
    """Return the number of an error or an alarm; -1 for text that is none."""
    try:
        return count(text.strip())
    except ValueError:
        return -1


def vector(text: str) -> tuple[float, ...]:
    """Return comma-separated numbers; raises ValueError."""
    return tuple(decimal(part) for part in text.split(","))


def sizes(options: str) -> tuple[int, int]:
    """Return planner blocks and receive bytes of `$I`'s "letters,blocks,bytes"; 0 for what it does not say."""
    blocks, size, *_ = [*map(code, options.split(",")[1:3]), 0, 0]
    return max(blocks, 0), max(size, 0)


def _matched(form: re.Pattern[str], text: str) -> str:
    if len(text) > _LONGEST or not form.fullmatch(text):
        raise ValueError(Text("not a number: {text}", text=text[:_LONGEST]))
    return text


Vector = tuple[float, ...]
AXES = 3  # at least
STATES = (
    *("Idle", "Run", "Hold", "Jog", "Alarm", "Door", "Check", "Home", "Sleep"),  # of grbl
    *("Tool", "Starting", "ConfigAlarm", "Critical"),  # of grblHAL and FluidNC
)


@dataclass(frozen=True)
class Answer:
    """`ok` (error 0) or `error:n`; -1 for an error without a number."""

    error: int = 0
    text: str = "ok"


@dataclass(frozen=True)
class Alarm:
    """`ALARM:n`; -1 without a number."""

    code: int


@dataclass(frozen=True)
class Greeting:
    """The greeting after power-up or reset."""

    text: str
    version: str


@dataclass(frozen=True)
class Feedback:
    """`[TAG:text]`: MSG, GC, G54 to G59, G28, G30, G92, TLO, PRB, VER, OPT, HLP, echo, and FIRMWARE, NEWOPT, AXS ..."""

    tag: str
    text: str


@dataclass(frozen=True)
class Setting:
    """`$n=value`, of the answer to `$$`."""

    number: int
    value: float


@dataclass(frozen=True)
class NamedSetting:
    """`$name=text`: a stored start-up line (`$N0=`), or a setting of FluidNC (`$/report_inches=false`)."""

    name: str
    text: str


@dataclass(frozen=True)
class StartupLine:
    """`>line:ok` or `>line:error:n`: what a stored start-up line gave; no answer to anything sent."""

    text: str


@dataclass(frozen=True)
class Status:
    """The answer to `?`, in the controller's own units ($13); None where a field was not in it.

    state: "Idle", "Run", "Hold", "Jog", "Alarm", "Door", "Check", "Home", "Sleep", "Tool". substate: the
    number after the colon. buffer: free planner blocks and free bytes. feed and spindle as reported.
    outputs: what is on, known with the overrides only: S or C for the spindle's sense, F flood, M mist.
    left_s: how long a machine that cannot be stopped still works on what it was sent. port_inputs, port_outputs: of a
    parallel port the status pins that are high, and the devices that are on. queued_lines: of the answered lines those
    whose moves are not all made, as a CNCStepper controller counts them.
    """

    state: str
    substate: int | None = None
    mpos: Vector | None = None
    wpos: Vector | None = None
    wco: Vector | None = None
    buffer: tuple[int, int] | None = None
    feed: float | None = None
    spindle: float | None = None
    overrides: tuple[int, ...] | None = None
    pins: str = ""
    outputs: str | None = None
    left_s: float | None = None
    port_inputs: tuple[int, ...] | None = None
    port_outputs: tuple[str, ...] | None = None
    queued_lines: int | None = None

    @property
    def name(self) -> str:
        """The state as grbl writes it: "Hold:0"."""
        return self.state if self.substate is None else f"{self.state}:{self.substate}"


@dataclass(frozen=True)
class Unknown:
    """A line that is not grbl's: another controller, or noise."""

    text: str


@dataclass(frozen=True)
class Damaged(Unknown):
    """A status that was damaged on its way or invented: nothing in it is believed."""


Report = Answer | Alarm | Greeting | Feedback | Setting | NamedSetting | StartupLine | Status | Unknown

OK = Answer()
_GREETING = re.compile(r"Grbl(?:HAL)?\s+(\S+)", re.IGNORECASE)
_FEEDBACK = re.compile(r"\[([A-Za-z0-9.]+(?: [A-Z]+)*):?(.*)\]")
_SETTING = re.compile(r"\$([0-9]+)=\s*([-+.0-9]+)")
_NAMED_SETTING = re.compile(r"\$(N\d+|[A-Za-z]*/[\w/]+)=(.*)")
_STATE = re.compile(r"([A-Z][A-Za-z]+)(?::([0-9]{1,3}))?")


def parse(line: str) -> Report:
    """Return what one line of the controller, without its line end, means."""
    if line == "ok":
        return OK
    if line.startswith("<"):
        return _status(line)
    if line.startswith("error:"):
        return Answer(code(line[6:]), line)
    if line.startswith("ALARM:"):
        return Alarm(code(line[6:]))
    if line.startswith(">"):
        return StartupLine(line[1:])
    return _other(line)


def _place(text: str) -> Vector:
    """Return a position, which has three axes at least; raises ValueError."""
    place = vector(text)
    if len(place) < AXES:
        raise ValueError(Text("an axis is missing: {text}", text=text))
    return place


def _other(line: str) -> Report:
    if greeting := _GREETING.match(line):
        return Greeting(line, greeting[1])
    if feedback := _FEEDBACK.fullmatch(line):
        return Feedback(feedback[1], feedback[2])
    if setting := _SETTING.match(line):
        return _setting(line, setting[1], setting[2])
    if named := _NAMED_SETTING.fullmatch(line):
        return NamedSetting(named[1], named[2])
    return Unknown(line)


def _setting(line: str, number: str, value: str) -> Report:
    try:
        return Setting(count(number), decimal(value))
    except ValueError:
        return Unknown(line)


def _status(line: str) -> Report:
    state, *fields = line[1:-1].split("|")
    found = _STATE.fullmatch(state)
    if found is None or found[1] not in STATES or not line.endswith(">"):
        return Damaged(line)
    try:
        values = _fields(fields)
    except ValueError:  # a byte was lost on the way: half a position is worse than none
        return Damaged(line)
    if not values.keys() & {"mpos", "wpos"}:
        return Damaged(line)
    return Status(found[1], int(found[2]) if found[2] else None, **values)


def _fields(fields: list[str]) -> dict:
    """Return the known fields as arguments of Status; raises ValueError on a damaged one."""
    values: dict = {}
    for field in fields:
        name, _, text = field.partition(":")
        if name in ("MPos", "WPos", "WCO"):
            values[name.lower()] = _place(text)
        elif name == "Bf":
            blocks, size = map(count, text.split(","))
            values["buffer"] = (blocks, size)
        elif name in ("FS", "F"):
            values.update(zip(("feed", "spindle"), vector(text), strict=False))
        elif name == "Ov":
            values["overrides"] = tuple(map(count, text.split(",")))
            values.setdefault("outputs", "")
        elif name == "A":
            values["outputs"] = text
        elif name == "Pn":
            values["pins"] = text
        elif name == "Left":
            values["left_s"] = decimal(text)
        elif name == "Queue":
            values["queued_lines"] = count(text)
        elif name == "In":
            values["port_inputs"] = tuple(map(count, filter(None, text.split(","))))
        elif name == "Out":
            values["port_outputs"] = tuple(filter(None, text.split(",")))
    return values
