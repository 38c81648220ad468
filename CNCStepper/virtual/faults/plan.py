# SPDX-License-Identifier: LGPL-2.1-or-later
"""A plan of timed faults between a sender and a virtual controller, from TOML, JSON or a seed.

[[fault]]           kinds of the wire       drop  delay  duplicate  corrupt   bytes of one way, "in" or "out"
kind = "corrupt"              of the words  withhold  flood                   answers kept back, messages too many
way = "in"                    of the board  reset  power  alarm               at once, in motion, or at rest
at_byte = 400                 of the port   close                             as a cable that is pulled
count = 1                     of the sender kill  disk                        its process, its disk
                              of a machine  stall  dead_pin  swapped_pins     motors and cables of the published ones
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, model_validator

from CNCStepper.errors import JobError, Place, Text
from CNCStepper.machine.profile import read_toml, validated

Kind = Literal[
    "drop",
    "delay",
    "duplicate",
    "corrupt",
    "withhold",
    "flood",
    "reset",
    "power",
    "alarm",
    "close",
    "kill",
    "disk",
    "stall",
    "dead_pin",
    "swapped_pins",
]
MACHINE_KINDS = ("stall", "dead_pin", "swapped_pins")  # of motors and cables that a grbl's board does not have
KINDS: tuple[str, ...] = tuple(kind for kind in get_args(Kind) if kind not in MACHINE_KINDS)
WIRE_KINDS = ("drop", "delay", "duplicate", "corrupt")
BOARD_KINDS = ("reset", "power", "alarm")
SENDER_KINDS = ("kill", "disk")
PIN_KINDS = ("dead_pin", "swapped_pins")
SERVER_KINDS = tuple(kind for kind in KINDS if kind != "disk")  # as a virtual grbl can cause them
IN, OUT = "in", "out"


class _Checked(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Fault(_Checked):
    """One fault, once.

    at_byte: the byte of its way, from 0, that it begins with. at_s: or the time since power-up, in simulated
    seconds. way: "in" to the controller, "out" from it; bytes are counted there. count: bytes, `ok` or messages.
    for_s: of a delay, a full disk, a stalled motor, or a lost supply of motors. bits: corrupted are these bits of each
    byte; 0 leaves one to chance. when: a fault of the board waits until the machine is in "motion" or at "rest". code:
    of an alarm, 1 (limit switch) or 2 (soft limit); while the machine homes either is 9 (no switch found). text: of a
    flood's messages. pid_file: holds the number of the process to kill, or is a session file. motor: that stalls, as
    the profile names it. pin, other_pin: of the parallel port, one that is dead or two that are swapped.
    """

    kind: Kind
    way: Literal["in", "out"] = "in"
    at_byte: int | None = Field(default=None, ge=0)
    at_s: float | None = Field(default=None, ge=0)
    count: int = Field(default=1, ge=1, le=10_000)
    for_s: float = Field(default=0.5, gt=0)
    bits: int = Field(default=0, ge=0, le=255)
    when: Literal["any", "motion", "rest"] = "any"
    code: int = Field(default=1, ge=1, le=2)
    text: str = Field(default="[MSG:Flood]", pattern=r"^[ -~]*$")
    pid_file: str = ""
    motor: str = ""
    pin: int = Field(default=0, ge=0, le=25)
    other_pin: int = Field(default=0, ge=0, le=25)

    @model_validator(mode="after")
    def _has_one_moment(self) -> Fault:
        if (self.at_byte is None) == (self.at_s is None):
            raise ValueError("give either at_byte or at_s")
        return self

    @model_validator(mode="after")
    def _names_what_it_hits(self) -> Fault:
        if self.kind == "stall" and not self.motor:
            raise ValueError('a stall needs its motor, such as motor = "x"')
        if self.kind in PIN_KINDS and not self.pin:
            raise ValueError("give the pin of the parallel port")
        if self.kind == "swapped_pins" and not self.other_pin:
            raise ValueError("give other_pin, with which the pin is swapped")
        return self

    def __str__(self) -> str:
        moment = f"at byte {self.at_byte}" if self.at_s is None else f"at {self.at_s:g} s"
        way = f" {self.way}" if self.kind in WIRE_KINDS else ""
        hit = f" {self.motor}" if self.motor else f" {self.pin}" if self.pin else ""
        return f"{self.kind}{hit}{way} {moment}"


class FaultPlan(_Checked):
    """Faults, and the seed of their random choices."""

    seed: int = 0
    fault: tuple[Fault, ...] = ()


def read_plan(path: Path) -> FaultPlan:
    """Return the plan of a TOML or JSON file; raises JobError naming the file and what is wrong."""
    try:
        content = _json(path) if path.suffix.lower() == ".json" else read_toml(path)
    except OSError as error:
        what, advice = Text("it cannot be read: {error}", error=error.strerror), "look at its name and rights"
        raise JobError("faults-file", what, place=Place(str(path)), advice=advice) from error
    return validated(FaultPlan, content, str(path))


def _json(path: Path) -> dict[str, Any]:
    try:
        content = json.loads(path.read_text("utf-8-sig"))
    except ValueError as error:
        what, advice = Text("not a JSON file: {error}", error=error), "correct that, or name a JSON file"
        raise JobError("json", what, place=Place(str(path)), advice=advice) from error
    if not isinstance(content, dict):
        advice = "write its keys and values in braces"
        raise JobError("json", "not an object of keys and values", place=Place(str(path)), advice=advice)
    return content
