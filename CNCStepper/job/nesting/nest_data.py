# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parts, sheets and placed parts as plain data, between a window and the process that nests.

It loads neither the readers of drawings nor matplotlib: the window's thread has no time for these.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import shapely
from shapely import Polygon

from CNCStepper.drawing.drawing import Chain
from CNCStepper.job.drawings.packed_curves import packed_curves
from CNCStepper.nesting.manual_nesting import PlacedPart
from CNCStepper.nesting.nesting_model import Item, Placement, Sheet, Spacing

Rows = list[list[Any]]
SHOW, SEARCH, FILL, WRITE = "show", "search", "fill", "write"


def packed_chains(chains: Sequence[Chain]) -> dict[str, Any]:
    """Return the chains of a drawing as plain data."""
    curves = packed_curves([chain.curve for chain in chains])
    return {"curves": curves, "layers": [chain.attributes.layer for chain in chains]}


def rows_of(parts: Sequence[PlacedPart]) -> Rows:
    """Return placed parts as plain data: sheet, item, x, y, rotation, whether it is locked."""
    told = [(part.placement, part.locked) for part in parts]
    return [[at.sheet, at.item, at.x_mm, at.y_mm, at.rotation_deg, locked] for at, locked in told]


def parts_of(rows: Rows) -> list[PlacedPart]:
    """Return the placed parts of `rows_of`."""
    return [PlacedPart(Placement(*place), bool(locked)) for *place, locked in rows]


def unpacked_order(content: dict[str, Any]) -> tuple[list[Item], list[Sheet], Spacing]:
    """Return the items, the sheets and the spacing of an answer."""
    items = [Item(**{**each, **_polygons(each, ("outline", "exact"))}) for each in content["items"]]
    sheets = [Sheet(**{**each, **_polygons(each, ("outline",))}) for each in content["sheets"]]
    return [_with_tuple(item) for item in items], sheets, Spacing(**content["spacing"])


def packed_items(items: Sequence[Item], sheets: Sequence[Sheet], spacing: Spacing) -> dict[str, Any]:
    """Return what `unpacked_order` gives, as plain data."""
    rows = [
        {
            "name": item.name,
            "outline": shapely.to_wkb(item.outline, hex=True),
            "exact": shapely.to_wkb(item.exact, hex=True),
            "count": item.count,
            "rotations_deg": item.rotations_deg and list(item.rotations_deg),
            "grain_deg": item.grain_deg,
            "stock": item.stock,
        }
        for item in items
    ]
    plates = [
        {
            "name": sheet.name,
            "outline": shapely.to_wkb(sheet.outline, hex=True),
            "grain_deg": sheet.grain_deg,
            "stock": sheet.stock,
        }
        for sheet in sheets
    ]
    return {
        "items": rows,
        "sheets": plates,
        "spacing": {"gap_mm": spacing.gap_mm, "margin_mm": spacing.margin_mm},
    }


def _polygons(content: dict[str, Any], keys: Sequence[str]) -> dict[str, Polygon]:
    return {key: shapely.from_wkb(content[key]) for key in keys}


def _with_tuple(item: Item) -> Item:
    return item if item.rotations_deg is None else replace(item, rotations_deg=tuple(item.rotations_deg))
