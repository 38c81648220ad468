# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a window asks about a nest, and the answer, both plain data.

    {"verb": "search", "order": {...}, "drawings": {NAME: {...}}, "parts": [[sheet, item, x, y, deg, locked], ...],
     "folder": PATH, "time_s": 20}

    show        the outlines of parts and sheets alone
    search      the parts that are not locked are placed, and the files written
    fill        more of the part "item" where the sheet "sheet" has room; nothing is written
    write       the files of just these parts, judged as a whole before

The answer holds the outlines (`nest_data.py`), the parts, those that do not fit any more, the files of the sheets,
what has no place, and what common lines save. Parts on a sheet that is not there any more are left out.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from threading import Event
from typing import Any

from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.errors import JobError, Text
from CNCStepper.job.drawings.packed_curves import unpacked_curves
from CNCStepper.job.nesting.nest_data import FILL, SEARCH, WRITE, packed_items, parts_of, rows_of
from CNCStepper.job.nesting.nest_files import density_of, write_nest
from CNCStepper.job.nesting.order_file import Order, OrderForm, order_of
from CNCStepper.job.nesting.shared_cuts import saving_of, shared_cuts
from CNCStepper.job.nesting.strip_process import strip_packer
from CNCStepper.machine.profile import validated
from CNCStepper.nesting.judge import require_sound
from CNCStepper.nesting.manual_nesting import ManualNest, PlacedPart, filled
from CNCStepper.nesting.nest import nest
from CNCStepper.nesting.nesting_model import Budget, Item, Layout, Placement, Unplaced


def answer_of(
    asked: dict[str, Any], share: Callable[[float], None] = lambda share: None, stopped: Event | None = None
) -> dict[str, Any]:
    """Do what is asked; stopped: ends a search with the best so far. Raises CNCStepperError."""
    order = _order(asked)
    parts = [part for part in parts_of(asked["parts"]) if part.placement.sheet < len(order.sheets)]
    budget = Budget(float(asked["time_s"]), progress=share, stopped=stopped or Event())
    layout, files = None, []
    if asked["verb"] == SEARCH:
        layout, parts = _searched(order, parts, budget)
    elif asked["verb"] == FILL:
        manual = ManualNest(order.items, order.sheets, order.spacing, parts)
        parts += [PlacedPart(place) for place in filled(manual, asked["item"], asked["sheet"], budget)]
    elif asked["verb"] == WRITE:
        layout = _judged(order, parts)
    shared = shared_cuts(order, layout) if layout is not None else {}
    if layout is not None:
        files = write_nest(order, layout, Path(asked["folder"]), shared)
    unplaced = layout.unplaced if layout is not None else ()
    return {
        "order": packed_items(order.items, order.sheets, order.spacing),
        "parts": rows_of(parts),
        "faults": ManualNest(order.items, order.sheets, order.spacing, parts).overlapping(),
        "written": layout is not None,
        "sheets": [str(path) for path in files if path.name.startswith("sheet-")],
        "density": density_of(order, layout) if layout is not None else 0.0,
        "missing": sum(each.count for each in unplaced),
        "unplaced": [_sentence(order, each) for each in unplaced],
        "saving": [saving_of(shared).sentence, *saving_of(shared).notes] if shared else [],
    }


def _order(asked: dict[str, Any]) -> Order:
    drawings = asked["drawings"]

    def chains_of(name: str) -> tuple[str, tuple[Chain, ...]]:
        if name not in drawings:
            raise JobError("nest-drawing", Text("there is no drawing '{name}'", name=name), advice="choose another one")
        curves = unpacked_curves(drawings[name]["curves"])
        layers = drawings[name]["layers"]
        return "", tuple(Chain(curve, Attributes(layer=layer)) for curve, layer in zip(curves, layers, strict=True))

    return order_of(validated(OrderForm, asked["order"], "order"), chains_of)


def _searched(order: Order, parts: Sequence[PlacedPart], budget: Budget) -> tuple[Layout, list[PlacedPart]]:
    """Return the best layout that is found round the locked parts, and its parts."""
    locked = [part.placement for part in parts if part.locked]
    counts = [item.count for item in order.items]
    items = with_locked(order.items, counts, locked)
    layout = nest(items, order.sheets, order.spacing, budget, strip_packer(), common_lines=order.common_lines)
    return layout, [PlacedPart(place, place in locked) for place in sorted(layout.placements)]


def _judged(order: Order, parts: Sequence[PlacedPart]) -> Layout:
    """Return the parts as a layout; raises GeometryError that names the first fault."""
    places = tuple(part.placement for part in parts)
    lie = Counter(place.item for place in places)
    counts = [max(item.count, lie[number]) for number, item in enumerate(order.items)]
    unplaced = tuple(
        Unplaced(number, count - lie[number], "it was not placed")
        for number, count in enumerate(counts)
        if count > lie[number]
    )
    layout = Layout(places, unplaced)
    items = with_locked(order.items, counts, [part.placement for part in parts if part.locked])
    require_sound(items, order.sheets, order.spacing, layout)
    return layout


def with_locked(items: Sequence[Item], counts: Sequence[int], locked: Sequence[Placement]) -> list[Item]:
    """Return the items with their locked placements, which count among those wanted."""
    found = []
    for number, (item, count) in enumerate(zip(items, counts, strict=True)):
        own = tuple(place for place in locked if place.item == number)
        found.append(replace(item, count=max(count - len(own), 0), locked=own))
    return found


def _sentence(order: Order, unplaced: Unplaced) -> Text:
    name = order.items[unplaced.item].name
    return Text("{count} of {name}: {why}", count=unplaced.count, name=name, why=unplaced.why)
