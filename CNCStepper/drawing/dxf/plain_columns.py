# SPDX-License-Identifier: LGPL-2.1-or-later
"""Ordinary entities of a DXF file as pieces in mm, all at once: their columns stay where they were gathered.

Entities of hidden layers are left out. One that is no curve in mm as it is (too far away, too short) goes through a
`Curve` alone, which mends or refuses it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from CNCStepper.cancellation import checkpoint
from CNCStepper.drawing.chain_columns import ChainColumns, Names
from CNCStepper.drawing.drawing import Attributes, Piece
from CNCStepper.drawing.dxf.attributes import BLACK, OUTSIDE, Layers, attributes, colour_of
from CNCStepper.drawing.dxf.plain_entities import NAMES, Looks, PlainEntities, are_chains
from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.curve_bundle import Bundle

BLOCK = 16_384  # curves that are looked through at once


@dataclass
class PlainPieces:
    """Pieces in columns, the number of each among the entities, int32[n], and what is not among them, by number.

    `refused` has kind, layer and handle of an entity beside the reason.
    """

    columns: ChainColumns
    numbers: np.ndarray
    mended: list[tuple[int, Piece]] = field(default_factory=list)
    refused: list[tuple[int, str, str, str, GeometryError]] = field(default_factory=list)


def plain_pieces(
    plain: PlainEntities, layers: Layers, groups: Mapping[str, tuple[str, ...]], encoding: str, unit_mm: float
) -> PlainPieces:
    """Return ordinary entities as pieces; `groups` are those of entities by handle. The entities are used up."""
    numbers, look, curves, handles = plain.columns()
    layer_names = [layers.named(own.layer.decode(encoding, "surrogateescape")) for own in plain.looks]
    looks = [_attributes(own, name, layers) for own, name in zip(plain.looks, layer_names, strict=True)]
    shown = np.array([not layers.is_hidden(name) for name in layer_names], bool)[look]
    if groups:
        look = _with_groups(look, looks, handles, groups)
    fine = _scaled(curves, unit_mm)
    found = PlainPieces(ChainColumns(curves, look, looks, handles), numbers)
    for row in np.flatnonzero(shown & ~fine).tolist():
        chain, number = found.columns[row], int(numbers[row])
        try:
            found.mended.append((number, Piece(Curve(chain.curve.xy, chain.curve.bulge), chain.attributes)))
        except GeometryError as error:
            kind = NAMES[plain.looks[plain.look(row)].kind]
            found.refused.append((number, kind, chain.attributes.layer, chain.attributes.name, error))
    kept = shown & fine
    if not kept.all():
        rows = np.flatnonzero(kept)
        found.columns, found.numbers = found.columns.where(rows, curves.where(kept)), numbers[rows]
    return found


def _attributes(own: Looks, layer: str, layers: Layers) -> Attributes:
    colour = colour_of(own.colour_index, own.true_colour, layers.colour(layer), BLACK)
    return attributes(layer, colour, "", OUTSIDE)


def _with_groups(
    look: np.ndarray, looks: list[Attributes], handles: Names, groups: Mapping[str, tuple[str, ...]]
) -> np.ndarray:
    """Return the looks of the entities with those of groups, which are appended to `looks`."""
    look, known = look.copy(), dict[tuple[int, tuple[str, ...]], int]()
    for first in range(0, len(look), BLOCK):
        checkpoint()
        rows = np.arange(first, min(first + BLOCK, len(look)))
        for row, handle in enumerate(handles.of(rows), start=first):
            if own := groups.get(handle.upper()):
                key = int(look[row]), own
                if key not in known:
                    known[key] = len(looks)
                    looks.append(replace(looks[key[0]], groups=own))
                look[row] = known[key]
    return look


def _scaled(curves: Bundle, unit_mm: float) -> np.ndarray:
    """Bring curves to mm in their place; return which of them are curves in mm as they are, bool[n]."""
    if unit_mm == 1.0:
        return np.ones(len(curves.counts), bool)
    fine = []
    for block in curves.blocks(BLOCK):
        checkpoint()
        block.xy[:] *= unit_mm
        fine.append(are_chains(block))
    return np.concatenate(fine)
