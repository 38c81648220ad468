# SPDX-License-Identifier: LGPL-2.1-or-later
"""How far values may go for a job's stock and machine before they are slips: of a decimal point, or of a unit.

Bounds without a job are those of the quantities (`quantities`); what only leaves the stock a little is a finding, not
a slip. A key's suffix is its unit:

    depths    depth_mm, stepdown_mm, …    twice the stock's thickness and 10 mm, and the travel of Z
    heights   clearance_mm, …             the travel of Z, without a Z that of the last axis
    widths    stepover_mm, radius_mm, …   four times the longest side of the stock or the longest travel
    feeds     …feed_mm_min                ten times the fastest axis
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from CNCStepper.machine.profile import Machine

DEPTHS = ("depth_mm", "stepdown_mm", "finish_stepdown_mm", "through_mm", "peck_mm", "pitch_mm", "tabs_height_mm")
HEIGHTS = ("clearance_mm", "retract_mm")
FEEDS = ("feed_mm_min", "plunge_mm_min", "finish_feed_mm_min")
LENGTHS = ("_mm",)  # all other keys that end so, besides those of the stock itself
NOT_JUDGED = ("stock_size_mm", "work_origin_mm", "points_mm", "length_offset_mm", "tolerance_mm", "resolution_mm")
SPARE_MM = 10.0  # below a thin sheet lies the board that it is fixed to
TIMES_THICK, TIMES_WIDE, TIMES_FAST = 2.0, 4.0, 10.0


@dataclass(frozen=True)
class Limit:
    """The most that a value may be, in the unit of its key, and why: "depth", "travel", "width" or "feed"."""

    most: float
    reason: str


@dataclass(frozen=True)
class Reach:
    """How far depths, heights, widths and feeds of a job may go."""

    depth: Limit
    height: Limit
    width: Limit
    feed: Limit

    def limit(self, key: str) -> Limit | None:
        """Return the limit of a parameter, None where it has none here."""
        kind = kind_of(key)
        return getattr(self, kind) if kind else None

    def refusal(self, key: str, value: Any) -> Limit | None:
        """Return the limit that a value, or one of several, goes beyond; None where it does not."""
        limit = self.limit(key)
        return limit if limit is not None and _largest(value) > limit.most else None

    def holds(self, most: dict[str, float]) -> bool:
        """Return whether no value goes beyond its limit, of which the largest of each kind are given."""
        return all(number <= getattr(self, kind).most for kind, number in most.items())


def kind_of(key: str) -> str:
    """Return what limits a parameter: "depth", "height", "width" or "feed" of a Reach, "" where nothing does here."""
    if key in DEPTHS:
        return "depth"
    if key in HEIGHTS:
        return "height"
    if key in FEEDS:
        return "feed"
    return "width" if key.endswith(LENGTHS) and key not in NOT_JUDGED else ""


def largest(found: dict[str, Any]) -> dict[str, float]:
    """Return the largest of some values by key for each kind that they are of, whatever their sign."""
    most: dict[str, float] = {}
    for key, value in found.items():
        if kind := kind_of(key):
            most[kind] = max(most.get(kind, 0.0), _largest(value))
    return most


def _largest(value: Any) -> float:
    """Return the largest absolute number of a value; 0 without one."""
    numbers = value if isinstance(value, tuple | list) else [value]
    return max(map(abs, numbers), default=0.0) if all(isinstance(number, int | float) for number in numbers) else 0.0


def reach_of(stock_mm: tuple[float, float, float], machine: Machine) -> Reach:
    """Return the limits of values for a stock of that size and that machine."""
    travels_mm = [axis.travel_max_mm - axis.travel_min_mm for axis in machine.own_axes.values()]
    travel = Limit(travels_mm[-1], "travel")
    stock_limit = Limit(TIMES_THICK * stock_mm[2] + SPARE_MM, "depth")
    wide_mm = max(*stock_mm[:2], *travels_mm)
    return Reach(
        depth=min(stock_limit, travel, key=lambda limit: limit.most),
        height=travel,
        width=Limit(TIMES_WIDE * wide_mm, "width"),
        feed=Limit(TIMES_FAST * max(axis.max_rate_mm_min for axis in machine.own_axes.values()), "feed"),
    )
