# SPDX-License-Identifier: LGPL-2.1-or-later
"""One block of a program, and the modal state before it.

Positions are 32-bit floats in mm (kept in Python floats), machine coordinates, as in the firmware.
"""

from __future__ import annotations

from dataclasses import dataclass, field, fields
from enum import Enum
from operator import attrgetter

FIRST_SYSTEM, LAST_SYSTEM = 54, 59  # G54 to G59; G59.1 to G59.3 count on as 60 to 62
X, Y, Z = 0, 1, 2
AXES = "XYZ"
CENTRES = "IJK"
FIRST_PLANE = 17
PLANES = {17: (X, Y, Z), 18: (Z, X, Y), 19: (Y, Z, X)}  # first and second axis of the plane, then the normal

RAPID, FEED, ARC_CW, ARC_CCW, CANCELLED = 0, 1, 2, 3, 80
PROBE_TOWARD, PROBE_TOWARD_QUIET, PROBE_AWAY, PROBE_AWAY_QUIET = 382, 383, 384, 385  # G38.2 to G38.5
PROBES = (PROBE_TOWARD, PROBE_TOWARD_QUIET, PROBE_AWAY, PROBE_AWAY_QUIET)
ARCS = (ARC_CW, ARC_CCW)
CHIP_BREAK, DRILL, DRILL_DWELL, PECK = 73, 81, 82, 83
PECKING = (CHIP_BREAK, PECK)
CYCLES = (CHIP_BREAK, DRILL, DRILL_DWELL, PECK)

DWELL, SET_DATA, MACHINE_MOVE = 40, 100, 530  # ten times the G number, so that G28.1 is 281
GO_HOME, SET_HOME = (280, 300), (281, 301)
SET_OFFSET, CLEAR_OFFSET = 920, 921


class AxisCommand(Enum):
    """Which command of a block takes its axis words."""

    NONE = 0
    ACTION = 1
    MOTION = 2
    TOOL_LENGTH = 3


@dataclass(slots=True)
class Modal:
    """The words in force, by the number of their G or M code; the defaults are those after a reset."""

    motion: int = RAPID
    plane: int = 17
    units: int = 21
    distance: int = 90
    feed_mode: int = 94
    system: int = 54
    tool_length: int = 49
    retract: int = 98
    spindle: int = 5
    flood: bool = False
    mist: bool = False


_words_of = attrgetter(*(word.name for word in fields(Modal)))  # ten times quicker than `replace`, block by block


@dataclass(frozen=True, slots=True)
class Drilling:
    """A drilling cycle: heights in machine coordinates, mm; peck 0 goes down at once. initial: before its run."""

    initial: float
    retract: float
    bottom: float
    peck: float
    dwell_s: float


@dataclass(slots=True)
class Parser:
    """The parser's whole state: the modal words, where it believes the machine to be, and the offsets."""

    modal: Modal = field(default_factory=Modal)
    position: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    feed: float = 0.0  # mm/min
    rpm: float = 0.0
    tool: int = 0
    system_offset: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    g92: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    tool_length: float = 0.0
    drilling: Drilling | None = None  # while a cycle is modal


@dataclass(slots=True)
class Block:
    """One block, first as read (modal, words), then completed by the checks (target, feed ...)."""

    modal: Modal
    jog: bool = False
    action: int = 0  # DWELL, SET_DATA ...; 0 is none
    axis_command: AxisCommand = AxisCommand.NONE
    changes_tool: bool = False  # M6
    switches: bool | None = None  # a digital output, number P: M62 and M64 on, M63 and M65 off
    flow: int | None = None  # 0, 2 or 30 from M0, M2, M30
    groups: set[str] = field(default_factory=set)
    words: dict[str, float] = field(default_factory=dict)
    unused: set[str] = field(default_factory=set)
    feed: float = 0.0
    rpm: float = 0.0
    target: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])
    centre: list[float] = field(default_factory=lambda: [0.0, 0.0, 0.0])  # I J K; data of G10, G28, G30
    radius: float = 0.0
    system: int = 54  # the work system that G10 changes
    drilling: Drilling | None = None
    repeats: int = 1  # of a drilling cycle

    @property
    def axis_words(self) -> tuple[int, ...]:
        """The axes named in the block."""
        return tuple(axis for axis, letter in enumerate(AXES) if letter in self.words)

    @classmethod
    def after(cls, modal: Modal, jog: bool = False) -> Block:
        """Return an empty block that begins with the words in force; a jog is always G1 G94."""
        words = Modal(*_words_of(modal))
        if jog:
            words.motion, words.feed_mode = FEED, 94
        return cls(words, jog)
