# SPDX-License-Identifier: LGPL-2.1-or-later
"""The chains of a drawing as plain data, and how many there are of each layer and colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from CNCStepper.drawing.drawing import Chain, Drawing

DIGITS, ROUNDED = 6, 9  # of a mm: a picometre is noise


def chain_rows(drawing: Drawing) -> list[dict[str, Any]]:
    """Return one table a chain: its attributes, closed, length_mm, area_mm2 (0 where open) and box_mm."""
    return [_row(chain) for chain in drawing.chains]


def _row(chain: Chain) -> dict[str, Any]:
    curve, told = chain.curve, chain.attributes
    return {
        "layer": told.layer,
        "colour": told.colour,
        "name": told.name,
        "groups": list(told.groups),
        "closed": curve.closed,
        "filled": told.filled,
        "length_mm": round(curve.length_mm, DIGITS),
        "area_mm2": round(abs(curve.area_mm2), DIGITS) if curve.closed else 0.0,
        "box_mm": [round(value, DIGITS) + 0.0 for value in curve.box_mm],
    }


def drawing_box_mm(chains: Sequence[Chain]) -> tuple[float, float, float, float]:
    """Return the box round chains, of which there is at least one: least x and y, greatest x and y, mm."""
    boxes = np.array([chain.curve.box_mm for chain in chains])
    low, high = boxes[:, :2].min(axis=0), boxes[:, 2:].max(axis=0)
    left, front = (np.round(low, ROUNDED) + 0.0).tolist()  # -0.0 is 0
    right, back = (np.round(high, ROUNDED) + 0.0).tolist()
    return left, front, right, back


@dataclass(frozen=True)
class Count:
    """How many chains of one layer and colour there are, and the length of all, mm."""

    layer: str
    colour: str
    closed: int
    open: int
    length_mm: float


def counts_of(chains: Sequence[Chain]) -> tuple[Count, ...]:
    """Return the counts in the order in which layers and colours first appear."""
    found: dict[tuple[str, str], list[Chain]] = {}
    for chain in chains:
        found.setdefault((chain.attributes.layer, chain.attributes.colour), []).append(chain)
    return tuple(_count(layer, colour, own) for (layer, colour), own in found.items())


def _count(layer: str, colour: str, chains: Sequence[Chain]) -> Count:
    closed = sum(chain.curve.closed for chain in chains)
    return Count(layer, colour, closed, len(chains) - closed, sum(chain.curve.length_mm for chain in chains))
