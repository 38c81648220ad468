# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nests an order: items by their stock on the sheets of that stock, within a budget of time.

    items, sheets ──► one group for each stock ──► in order: priority, then area ──► first layout (sheet_filling.py)
                      ──► strips, cut to the sheets (sheet_packing.py) ──► orders changed at random, the best is kept
                      ──► slid together (compaction.py), for common lines edge to edge (edge_snapping.py)
                      ──► filling items ──► judged (judge.py) ──► Layout

Locked parts lie first. A stop, or the end of the budget, gives the best layout so far.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from CNCStepper.errors import Text
from CNCStepper.nesting.compaction import compacted
from CNCStepper.nesting.edge_snapping import edge_to_edge, facing_mm
from CNCStepper.nesting.judge import require_sound
from CNCStepper.nesting.nesting_model import Budget, Item, Layout, Placement, Sheet, Spacing, Unplaced
from CNCStepper.nesting.order_checks import require_order
from CNCStepper.nesting.sheet_filling import Filling, Room, Shapes, placed_on_first
from CNCStepper.nesting.sheet_packing import in_holes, packed_sheets
from CNCStepper.nesting.strips import StripPacker

STRIP_SHARE = 0.6  # of the time, on sheets; a strip gets nearly all
FIRST_SHARE = 0.25  # of the time, for the first attempt where strips follow
LONGEST_FIRST = 5.0  # times the time given, and so many seconds more
LAST_SHARE = 0.02  # of the time, for sliding and judging
STRIP_LAST_SHARE = 0.01  # for the same on a strip, which gains next to nothing by it
SNAP_SHARE = 0.2  # of the time, for that and for moving edges together, where parts share cuts
Rank = tuple[float, ...]


@dataclass(frozen=True)
class Attempt:
    """The sheets of one attempt, filled, and the items that found no place, one by one; whether it was ended early."""

    fillings: tuple[Filling, ...]
    left: tuple[int, ...]
    ended: bool = False

    def rank(self, items: Sequence[Item], common_lines: bool = False) -> Rank:
        """Return what is compared: unplaced parts by priority, area of the sheets used, length of the last one.

        Where parts share cuts, the shared length counts before the length of the last sheet.
        """
        missing: Counter[int] = Counter()
        for number in self.left:
            missing[-items[number].priority] += items[number].outline.area
        used = [filling for filling in self.fillings if filling.placements]
        area = sum(filling.room.sheet.outline.area for filling in used)
        end_mm = used[-1].end_mm - used[-1].room.sheet.outline.bounds[0] if used else 0.0
        levels = sorted({-item.priority for item in items})
        common_mm = sum(facing_mm(filling.room, filling.shapes, filling.placements) for filling in used * common_lines)
        return (*(missing[level] for level in levels), area, -common_mm, end_mm)


def nest(
    items: Sequence[Item],
    sheets: Sequence[Sheet],
    spacing: Spacing,
    budget: Budget,
    strips: StripPacker | None = None,
    seed: int = 1,
    common_lines: bool = False,
) -> Layout:
    """Return where the parts lie; raises JobError for an order that is refused, GeometryError for a fault of ours.

    strips: packs strips in a process of its own; without it the search is our own alone. common_lines: parts are moved
    on until their straight edges face each other at the gap, so that one cut serves both.
    """
    require_order(items, sheets, spacing)
    shapes = Shapes(items, spacing)
    placements: list[Placement] = []
    unplaced: list[Unplaced] = []
    groups = _groups(items)
    parts = {stock: sum(items[number].count for number in numbers) for stock, numbers in groups.items()}
    waiting = sum(parts.values())
    for stock, numbers in groups.items():
        own = budget.part(budget.left_s * parts[stock] / max(waiting, 1))
        waiting -= parts[stock]
        rooms = [Room(place, sheet, spacing) for place, sheet in enumerate(sheets) if sheet.stock == stock]
        group = _Group(shapes, numbers, rooms, own, strips, seed, common_lines)
        placements += group.placements()
        unplaced += group.unplaced()
    layout = Layout(tuple(placements), tuple(unplaced))
    require_sound(items, sheets, spacing, layout)
    return layout


def _groups(items: Sequence[Item]) -> dict[str, list[int]]:
    groups: dict[str, list[int]] = {}
    for number, item in enumerate(items):
        groups.setdefault(item.stock, []).append(number)
    return groups


class _Group:
    """The items and sheets of one stock, and the best attempt at them."""

    def __init__(
        self,
        shapes: Shapes,
        numbers: Sequence[int],
        rooms: Sequence[Room],
        budget: Budget,
        strips: StripPacker | None,
        seed: int,
        common_lines: bool,
    ):
        self._shapes, self._items, self._rooms, self._budget = shapes, shapes.items, rooms, budget
        self._strips, self._random, self._common_lines = strips, random.Random(seed), common_lines
        own = [(number, self._items[number]) for number in numbers]
        wanted = sorted((pair for pair in own if not pair[1].fill), key=lambda pair: _urgency(pair[1]))
        self._order = [number for number, item in wanted for _ in range(item.count)]
        self._extra = sorted((n for n, item in own if item.fill), key=lambda n: _urgency(self._items[n]))
        self._filled: Counter[int] = Counter()
        self._best = self._searched(seed)

    def placements(self) -> list[Placement]:
        """Return the placements of the best attempt, slid together, with the filling items."""
        found: list[Placement] = []
        for filling in self._best.fillings:
            if filling.placements or self._locked(filling.room):
                found += self._finished(filling)
        return found

    def unplaced(self) -> list[Unplaced]:
        """Return what the best attempt has left over, with the reason."""
        counts = Counter(self._best.left)
        return [Unplaced(number, count, self._reason(number)) for number, count in sorted(counts.items())]

    def _reason(self, number: int) -> str:
        if not self._rooms:
            return Text("there is no sheet of the stock '{stock}'", stock=self._items[number].stock)
        if self._best.ended:
            return "the sheets were full, or the search ended before it had its turn"
        return "the sheets are full"

    def _searched(self, seed: int) -> Attempt:
        """Return the best attempt within the budget."""
        end = self._budget.part(self._budget.left_s * (1.0 - self._last_share()))
        best = self._first(end)
        if self._strips and self._order:
            hidden = in_holes(self._shapes, best.fillings) if best else Counter()
            fresh = [self._fresh(room) for room in self._rooms]
            time_s = end.left_s * (STRIP_SHARE if len(self._rooms) > 1 else 1.0)
            left = packed_sheets(fresh, self._order, hidden, self._strips, end.part(time_s), seed)
            best = self._better(best, Attempt(tuple(fresh), tuple(left), self._budget.stopped.is_set()))
        return self._improved(best or Attempt((), ()), end)

    def _last_share(self) -> float:
        """Return the share of the time that is kept for what follows the search."""
        if self._common_lines:
            return SNAP_SHARE
        return STRIP_LAST_SHARE if len(self._rooms) == 1 else LAST_SHARE

    def _first(self, end: Budget) -> Attempt | None:
        """Return the first attempt part by part; on one sheet without holes in parts the strips do better alone."""
        has_holes = any(self._items[number].outline.interiors for number in set(self._order))
        if self._strips and self._order and len(self._rooms) == 1 and not has_holes:
            return None
        return self._attempt(self._order, end.part(FIRST_SHARE * end.left_s) if self._strips else None)

    def _improved(self, best: Attempt, end: Budget) -> Attempt:
        """Return the best attempt of orders that are changed at random until time ends."""
        order, tried = list(self._order), 0
        while not end.over and len(set(order)) > 1 and tried != end.attempts:
            tried += 1
            changed = self._changed(order)
            attempt = self._attempt(changed, end)
            if attempt is None:
                break
            if self._better(best, attempt) is attempt:
                best, order = attempt, changed
        return best

    def _better(self, one: Attempt | None, other: Attempt) -> Attempt:
        if one is None:
            return other
        ranks = [attempt.rank(self._items, self._common_lines) for attempt in (one, other)]
        return other if ranks[1] < ranks[0] else one

    def _changed(self, order: list[int]) -> list[int]:
        """Return the order with a run of parts moved elsewhere among those of its priority."""
        changed = list(order)
        begin = self._random.randrange(len(changed))
        long = 1 + min(int(self._random.expovariate(0.5)), len(changed) - begin - 1)
        run = changed[begin : begin + long]
        del changed[begin : begin + long]
        place = self._random.randrange(len(changed) + 1)
        changed[place:place] = run
        return sorted(changed, key=lambda number: -self._items[number].priority)

    def _fresh(self, room: Room) -> Filling:
        filling = Filling(room, self._shapes)
        for placement in self._locked(room):
            filling.add(placement)
        return filling

    def _locked(self, room: Room) -> list[Placement]:
        return [placement for item in self._items for placement in item.locked if placement.sheet == room.number]

    def _attempt(self, order: Sequence[int], end: Budget | None) -> Attempt | None:
        """Return the sheets filled in an order; None where time ends before.

        Without an end it goes on beyond its time, up to LONGEST_FIRST times as long: some layout is better than none.
        """
        late = Budget(LONGEST_FIRST * self._budget.time_s + LONGEST_FIRST, stopped=self._budget.stopped)
        fillings = [self._fresh(room) for room in self._rooms]
        full = set[tuple[int, int]]()
        left: list[int] = []
        for done, number in enumerate(order):
            if end is not None and end.over:
                return None
            if late.over:
                return Attempt(tuple(fillings), (*left, *order[done:]), ended=True)
            left += [] if placed_on_first(fillings, number, full) else [number]
        return Attempt(tuple(fillings), tuple(left))

    def _finished(self, filling: Filling) -> list[Placement]:
        room = filling.room
        lie = compacted(room, self._shapes, filling.placements, self._budget)
        if self._common_lines:
            lie = edge_to_edge(room, self._shapes, lie, self._budget)
        if not self._extra:
            return lie
        last = Filling(room, self._shapes)
        for placement in lie:
            last.add(placement)
        for number in self._extra:
            while self._filled[number] < self._items[number].count and last.place(number):
                self._filled[number] += 1
        return last.placements


def _urgency(item: Item) -> tuple[float, float]:
    return -item.priority, -item.outline.convex_hull.area
