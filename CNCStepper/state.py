# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a machine knows besides its moves: the start state of a text and the modal state of a row.

A program has meaning only from a start state (`Start`). While it runs, each row of the table of
moves names one modal snapshot (`State`). Positions in the table are machine coordinates:

    machine = work + State.offset_mm,   offset = G54..G59.3 + G92 + tool length (on its axis)

where work X and Y are turned by `State.rotation_deg` first (G10 L2 R, 0 nearly always).

Where the work zero is not known (`Start.zero_known` false) the offsets are taken as zero, and the
place of the program on the table must be reported as unknown.
"""

from __future__ import annotations

import hashlib
import json
from bisect import bisect_right
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from itertools import chain
from typing import TYPE_CHECKING, overload

if TYPE_CHECKING:
    import numpy as np

UNKNOWN = float("nan")
WORK_SYSTEMS = ("G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3")
ZERO3 = (0.0, 0.0, 0.0)
ZERO9 = (0.0,) * 9
FEW = 256  # states that are made at once, rather than kept as feeds
MOST_SHARED = 65_536  # states that are held once wherever they are named
PIECE = 4096  # states that are forgotten together


@dataclass(frozen=True)
class ToolEntry:
    """A line of a tool table: what the tool in a pocket measures.

    offset_mm: of X Y Z A B C U V W (mm, degrees for A B C). diameter_mm: NaN where it is not known.
    front_deg, back_deg, orientation: of a lathe tool; orientation 0 is a mill, 1 to 9 say where the tip lies.
    """

    pocket: int = 0
    offset_mm: tuple[float, ...] = ZERO9
    diameter_mm: float = UNKNOWN
    front_deg: float = 0.0
    back_deg: float = 0.0
    orientation: int = 0


@dataclass(frozen=True)
class Start:
    """The state in which a machine stands before the first line is read.

    position_mm: machine coordinates, one value an axis, NaN where it is not known.
    work_offsets_mm: the offset of each work system that is not zero, by name ("G54").
    zero_known: whether the work offsets are the machine's own; false means "taken as zero".
    tool_lengths_mm: by tool number. tools: whole entries of a tool table by number; a length given above wins.
    parameters: `#n` by number, lengths in units of `machine_unit_mm`.
    search: folders of subroutines, looked through after that of the program.
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
    tools: dict[int, ToolEntry] = field(default_factory=dict)
    machine_unit_mm: float = 1.0
    search: tuple[str, ...] = ()

    @classmethod
    def at_zero(cls, axes: int = 3) -> Start:
        """Return the start of a machine that stands at its zero with no offsets, as a bare interpreter does."""
        return cls(position_mm=(0.0,) * axes, zero_known=True)

    @classmethod
    def with_work_zero(cls, zero_mm: tuple[float, ...], work_system: str = "G54") -> Start:
        """Return a start whose work zero lies at `zero_mm` in machine coordinates; the position is unknown."""
        return cls(work_system=work_system, work_offsets_mm={work_system: zero_mm}, zero_known=True)

    def sha256(self) -> str:
        """Return the fingerprint that a certificate names; where subroutines were found does not count."""
        told = asdict(self)
        del told["search"]
        return hashlib.sha256(json.dumps(told, sort_keys=True).encode("ascii")).hexdigest()


@dataclass(frozen=True)
class State:
    """One whole modal snapshot, valid from the row that first names it until the next change."""

    units: str = "mm"  # "mm" (G21) or "inch" (G20): the text's own, the table is always mm
    distance: str = "absolute"  # or "incremental"
    arc_centres: str = "incremental"  # or "absolute" (G90.1)
    plane: str = "XY"  # or "ZX" (G18), "YZ" (G19)
    feed_mode: str = "per_minute"  # or "inverse_time", "per_turn"
    path_mode: str = "exact_path"  # G61; "exact_stop" is G61.1, "blend" G64
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
    feed_mm_turn: float = 0.0  # the same under G95
    surface_m_min: float = 0.0  # G96: what S asks for; spindle_rpm follows X
    largest_rpm: float = 0.0  # D of G96
    rotation_deg: float = 0.0  # of the work system about Z
    blend_mm: float = 0.0  # G64 P: how far corners may be cut; 0 without P, when no one has said how far
    spindle_number: int = 0  # $ of M3: QtPlasmaC's torch 0, scribe 1, spotting 2

    @property
    def spindle_turns(self) -> bool:
        """Whether the spindle turns, or the beam burns: M3 at S0 leaves both off."""
        return self.spindle != "off" and self.spindle_rpm > 0


class States(Sequence[State]):
    """The states of a table of moves in their order; long runs that differ in the feed alone are kept as feeds.

    pieces    [State, State, State] | _Feeds | [State] | ...
    firsts    0                       3        1003        of the pieces that are still held
    """

    def __init__(self, states: Iterable[State] = ()):
        self._pieces: list[Sequence[State]] = [list(states)]
        self._firsts = [0]
        self._count = len(self._pieces[0])
        self._made = _OfFeeds(State())
        self._shared: dict[State, State] = {}

    def append(self, state: State) -> None:
        """Add one state; equal ones are held once, as those of a laser's raster, whose lines have a thousand powers."""
        if len(self._shared) > MOST_SHARED:
            self._shared.clear()
        self._add([self._shared.setdefault(state, state)])

    def append_feeds(self, base: State, feeds_mm_min: np.ndarray) -> None:
        """Add the state `base` with each of these feeds, float64[n], which are kept."""
        base = replace(base, feed_mm_min=0.0)
        if base != self._made.base or len(self._made) > MOST_SHARED:
            self._made = _OfFeeds(base)
        states = _Feeds(self._made, feeds_mm_min)
        self._add(list(states) if len(states) < FEW else states)

    def forget(self, before: int) -> None:
        """Let go of the states before this one, for a reader that will not ask for them again; few of them stay.

        A laser's raster has another S, and so another state, in each line.
        """
        gone = bisect_right(self._firsts, before) - 1
        if gone > 0:
            del self._pieces[:gone], self._firsts[:gone]

    def _add(self, states: Sequence[State]) -> None:
        last = self._pieces[-1]
        if isinstance(last, list) and isinstance(states, list) and len(last) < PIECE:
            last += states
        else:
            self._pieces.append(states)
            self._firsts.append(self._count)
        self._count += len(states)

    @overload
    def __getitem__(self, index: int) -> State: ...

    @overload
    def __getitem__(self, index: slice) -> list[State]: ...

    def __getitem__(self, index: int | slice) -> State | list[State]:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(self._count))]
        place = index + self._count if index < 0 else index
        if not 0 <= place < self._count:
            raise IndexError(f"there are {self._count} states, none at {index}")
        piece = bisect_right(self._firsts, place) - 1
        if piece < 0:
            raise IndexError(f"state {place} is forgotten, those from {self._firsts[0]} on are held")
        return self._pieces[piece][place - self._firsts[piece]]

    def __len__(self) -> int:
        return self._count

    def __iter__(self) -> Iterator[State]:
        return chain.from_iterable(self._pieces)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, States | list):
            return NotImplemented
        return len(self) == len(other) and all(one == another for one, another in zip(self, other, strict=True))


class _OfFeeds(dict[float, State]):
    """The state with each feed, made when it is first asked for."""

    def __init__(self, base: State):
        super().__init__()
        self.base = base

    def __missing__(self, feed_mm_min: float) -> State:
        state = self[feed_mm_min] = replace(self.base, feed_mm_min=feed_mm_min)
        return state


class _Feeds(Sequence[State]):
    """States that differ in the feed alone."""

    def __init__(self, made: _OfFeeds, feeds_mm_min: np.ndarray):
        self._made, self._feeds_mm_min = made, feeds_mm_min

    @overload
    def __getitem__(self, index: int) -> State: ...

    @overload
    def __getitem__(self, index: slice) -> list[State]: ...

    def __getitem__(self, index: int | slice) -> State | list[State]:
        feeds = self._feeds_mm_min[index].tolist()
        return [self._made[feed] for feed in feeds] if isinstance(index, slice) else self._made[feeds]

    def __len__(self) -> int:
        return len(self._feeds_mm_min)

    def __iter__(self) -> Iterator[State]:
        return map(self._made.__getitem__, self._feeds_mm_min.tolist())
