# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machine knows besides its moves: the start state of a text and the modal state of a row.

A program has meaning only from a start state (`Start`). While it runs, each row of the table of
moves names one modal snapshot (`State`). Positions in the table are machine coordinates:

    machine = work + State.offset_mm,   offset = G54..G59.3 + G92 + tool length (on its axis)

Where the work zero is not known (`Start.zero_known` false) the offsets are taken as zero, and the
place of the program on the table must be reported as unknown.
"""

from __future__ import annotations

import hashlib
import json
from dataclasses import asdict, dataclass, field

UNKNOWN = float("nan")
WORK_SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
ZERO3 = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Start:
    """The state in which a machine stands before the first line is read.

    position_mm: machine coordinates, one value an axis, NaN where it is not known.
    work_offsets_mm: the offset of each work system that is not zero, by name ("G54").
    zero_known: whether the work offsets are the machine's own; false means "taken as zero".
    tool_lengths_mm: by tool number. parameters: `#n` by number.
    """

    position_mm: tuple[float, ...] = (UNKNOWN, UNKNOWN, UNKNOWN)
    work_system: str = "G54"
    work_offsets_mm: dict[str, tuple[float, ...]] = field(default_factory=dict)
    g92_mm: tuple[float, ...] = ZERO3
    zero_known: bool = False
    tool: int = 0
    tool_lengths_mm: dict[int, float] = field(default_factory=dict)
    spindle_rpm: float = 0.0
    parameters: dict[int, float] = field(default_factory=dict)

    @classmethod
    def at_zero(cls, axes: int = 3) -> Start:
        """Return the start of a machine that stands at its zero with no offsets, as a bare interpreter does."""
        return cls(position_mm=(0.0,) * axes, zero_known=True)

    @classmethod
    def with_work_zero(cls, zero_mm: tuple[float, ...], work_system: str = "G54") -> Start:
        """Return a start whose work zero lies at `zero_mm` in machine coordinates; the position is unknown."""
        return cls(work_system=work_system, work_offsets_mm={work_system: zero_mm}, zero_known=True)

    def sha256(self) -> str:
        """Return the fingerprint that a certificate names."""
        return hashlib.sha256(json.dumps(asdict(self), sort_keys=True).encode("ascii")).hexdigest()


@dataclass(frozen=True)
class State:
    """One whole modal snapshot, valid from the row that first names it until the next change."""

    units: str = "mm"  # "mm" (G21) or "inch" (G20): the text's own, the table is always mm
    distance: str = "absolute"  # or "incremental"
    arc_centres: str = "incremental"  # or "absolute" (G90.1)
    plane: str = "XY"  # or "ZX" (G18), "YZ" (G19)
    feed_mode: str = "per_minute"  # or "inverse_time"
    path_mode: str = "exact_path"  # G61; "blend" is G64
    work_system: str = "G54"
    offset_mm: tuple[float, ...] = ZERO3  # machine = work + offset
    g92_mm: tuple[float, ...] = ZERO3
    tool: int = 0
    tool_length_mm: float = 0.0
    spindle: str = "off"  # "cw" (M3), "ccw" (M4)
    spindle_rpm: float = 0.0
    mist: bool = False
    flood: bool = False
    feed_mm_min: float = 0.0  # the F word in force

    @property
    def spindle_turns(self) -> bool:
        """Whether the spindle turns, or the beam burns: M3 at S0 leaves both off."""
        return self.spindle != "off" and self.spindle_rpm > 0
