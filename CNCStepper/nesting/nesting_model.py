# SPDX-License-Identifier: LGPL-2.1-or-later
"""What is nested: items, the sheets or the strip that take them, their spacing, and the placements that result.

    Item ──┐
    Sheet ─┼─► nest (nest.py) ──► Layout: placements · what was not placed, and why
    Spacing┘

An item has two polygons that hold the part: `outline`, of few corners, is what the search places; `exact`, of short
chords, is what the judge measures. All lengths are mm. A placement turns an item about its own origin, then moves it.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from threading import Event

import numpy as np
import shapely
from shapely import Polygon

MOST_PARTS = 10_000  # of an order: a search takes some ms for each
MOST_ROTATIONS = 360
FREE_STEP_DEG = 30.0  # between the rotations that our own search tries for an item of any rotation
PRINCIPAL_AXES = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))


@dataclass(frozen=True, order=True)
class Placement:
    """Where a part lies: item and sheet by number from 0, turned about the item's origin, then moved."""

    sheet: int
    item: int
    x_mm: float
    y_mm: float
    rotation_deg: float


@dataclass(frozen=True)
class Item:
    """A part and how often it is wanted.

    rotations_deg: those allowed; None: any. grain_deg: the direction in the part that must lie along the grain of the
    sheet, None: none. Items of higher `priority` are placed first. `fill`: as many as fit beside the others, up to
    `count`, on sheets that are used anyhow. locked: placements of the user's own, beside `count`. stock: material and
    thickness as one word; the item lies on sheets of the same stock only.
    """

    name: str
    outline: Polygon
    exact: Polygon
    count: int = 1
    rotations_deg: tuple[float, ...] | None = (0.0,)
    grain_deg: float | None = None
    priority: int = 0
    fill: bool = False
    locked: tuple[Placement, ...] = ()
    stock: str = ""


@dataclass(frozen=True)
class Sheet:
    """One sheet or remnant; `outline` holds no more than the sheet, with its holes. grain_deg: of its grain, if any."""

    name: str
    outline: Polygon
    grain_deg: float | None = None
    stock: str = ""


@dataclass(frozen=True)
class Spacing:
    """How far parts lie from each other and from the rim of a sheet, mm."""

    gap_mm: float = 0.0
    margin_mm: float = 0.0


@dataclass(frozen=True)
class Unplaced:
    """Parts of an item that lie on no sheet: how many, and why."""

    item: int
    count: int
    why: str


@dataclass(frozen=True)
class Layout:
    """Where the parts lie, and which lie nowhere."""

    placements: tuple[Placement, ...] = ()
    unplaced: tuple[Unplaced, ...] = ()

    @property
    def sheets(self) -> tuple[int, ...]:
        """The numbers of the sheets that carry parts, ascending."""
        return tuple(sorted({placement.sheet for placement in self.placements}))


@dataclass
class Budget:
    """The time that a search may take; `stop` ends it early with the best so far.

    attempts: how many changed orders are tried, None: as many as there is time for. With attempts and ample time the
    same order and seed give the same layout, however fast the computer is.
    """

    time_s: float
    attempts: int | None = None
    begun_s: float = field(default_factory=time.monotonic)
    stopped: Event = field(default_factory=Event)
    progress: Callable[[float], None] = lambda share: None

    @property
    def left_s(self) -> float:
        """How much time is left, 0 once it is stopped."""
        used_s = self._report()
        return 0.0 if self.stopped.is_set() else max(self.time_s - used_s, 0.0)

    @property
    def over(self) -> bool:
        """Whether the search has to end."""
        return self.left_s <= 0.0

    def stop(self) -> None:
        """End the search with the best so far."""
        self.stopped.set()

    def part(self, time_s: float) -> Budget:
        """Return a budget of at most `time_s` from now, which ends with this one and reports to it."""
        left_s = min(time_s, self.left_s)
        return Budget(left_s, self.attempts, stopped=self.stopped, progress=self._report_part)

    def _report_part(self, share: float) -> None:
        """Report, whatever share of a part's time is used."""
        self._report()

    def _report(self) -> float:
        """Report what share of the time is used, and return that time."""
        used_s = time.monotonic() - self.begun_s
        self.progress(min(used_s / max(self.time_s, 1e-3), 1.0))
        return used_s


def turned(polygon: Polygon, rotation_deg: float) -> Polygon:
    """Return a polygon turned counter-clockwise about the origin; by multiples of 90 degrees exactly."""
    c, s = direction(rotation_deg)
    return shapely.transform(polygon, lambda xy: xy @ np.array([[c, s], [-s, c]]))


def direction(angle_deg: float) -> tuple[float, float]:
    """Return cosine and sine; of multiples of 90 degrees exactly."""
    quarters, rest = divmod(angle_deg, 90.0)
    if rest == 0.0:
        return PRINCIPAL_AXES[int(quarters) % 4]
    angle = math.radians(angle_deg)
    return math.cos(angle), math.sin(angle)


def moved(polygon: Polygon, x_mm: float, y_mm: float) -> Polygon:
    """Return a polygon moved."""
    return shapely.transform(polygon, lambda xy: xy + np.array([x_mm, y_mm]))


def placed(polygon: Polygon, placement: Placement) -> Polygon:
    """Return a polygon of the item where the placement puts it."""
    return moved(turned(polygon, placement.rotation_deg), placement.x_mm, placement.y_mm)


def allowed_rotations_deg(item: Item, sheet: Sheet) -> tuple[float, ...] | None:
    """Return the rotations in which an item may lie on a sheet, 0 to 360; None: any.

    The grain leaves two: along it, to and fro, of those that the item allows; () where it allows neither.
    """
    if item.grain_deg is None or sheet.grain_deg is None:
        return item.rotations_deg
    along = (sheet.grain_deg - item.grain_deg) % 360.0
    ways = (along, (along + 180.0) % 360.0)
    return ways if item.rotations_deg is None else tuple(way for way in ways if is_among(way, item.rotations_deg))


def is_among(angle_deg: float, angles_deg: Sequence[float]) -> bool:
    """Return whether an angle is one of some, whole turns aside."""
    return any(abs((angle_deg - other + 180.0) % 360.0 - 180.0) < 1e-9 for other in angles_deg)


def tried_rotations_deg(item: Item, sheet: Sheet) -> tuple[float, ...]:
    """Return the rotations that a search over a list tries: those allowed, or for any rotation a fan of them.

    The fan holds steps of 30 degrees and what lays the longest edge of the convex hull along X.
    """
    allowed = allowed_rotations_deg(item, sheet)
    if allowed is not None:
        return allowed
    corners = np.asarray(item.outline.convex_hull.exterior.coords)
    edges = np.diff(corners, axis=0)
    longest = edges[np.argmax(np.hypot(*edges.T))]
    along = -math.degrees(math.atan2(longest[1], longest[0])) % 90.0
    steps = np.arange(0.0, 360.0, FREE_STEP_DEG)
    return tuple(sorted({*steps.tolist(), *(along + 90.0 * quarter for quarter in range(4))}))
