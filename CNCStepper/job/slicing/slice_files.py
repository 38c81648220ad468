# SPDX-License-Identifier: LGPL-2.1-or-later
"""The files of a stack: a drawing of each sheet, the list of them, the order that nests their pieces.

slice-001.dxf     layers CUT (outlines), REGISTRATION (holes, true circles), MARK (numbers in strokes)
slices.json       thickness, volumes, and of each sheet its place, part and pieces
assembled.png     the stack
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import shapely
from shapely import Polygon

from CNCStepper.atomic_file import write_whole
from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.job.nesting.order_file import Order
from CNCStepper.job.slicing.slice_picture import save_stack_picture
from CNCStepper.job.slicing.solid_slices import Piece, Slice, Stack
from CNCStepper.nesting.nesting_model import Item, Sheet, Spacing
from CNCStepper.nesting.outlines import simplified

FILES = {r"slice-\d+\.dxf": "drawing", r"slices\.json": "report", r"assembled\.png": "picture"}
CUT, REGISTRATION, MARK = (Attributes(layer=name) for name in ("CUT", "REGISTRATION", "MARK"))
HIGHEST_MARK_MM = 8.0
LOWEST_MARK_MM = 1.5
COARSE_MM = 0.05  # how far the outline that is nested may exceed a piece
CIRCLE_CORNERS = 32
SEGMENTS = {  # of a digit in a box 1 wide and 2 high, as in a display
    "a": ((0, 2), (1, 2)),
    "b": ((1, 2), (1, 1)),
    "c": ((1, 1), (1, 0)),
    "d": ((0, 0), (1, 0)),
    "e": ((0, 1), (0, 0)),
    "f": ((0, 2), (0, 1)),
    "g": ((0, 1), (1, 1)),
}
DIGITS = ("abcdef", "bc", "abged", "abgcd", "fgbc", "afgcd", "afgedc", "abc", "abcdefg", "abcdfg")
DIGIT_STEP = 1.6  # widths from one digit to the next


def write_stack(stack: Stack, folder: Path, title: str) -> list[Path]:
    """Write the drawings, the list and the picture into a folder; return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for each in stack.slices:
        paths.append(folder / f"slice-{each.number:03d}.dxf")
        write_whole(paths[-1], dxf_bytes(Drawing(tuple(slice_chains(each)))))
    paths.append(folder / "slices.json")
    write_whole(paths[-1], (json.dumps(_list(stack), indent=1) + "\n").encode("utf-8"))
    paths.append(folder / "assembled.png")
    save_stack_picture(paths[-1], stack, title)
    return paths


def _list(stack: Stack) -> dict[str, object]:
    rows = [
        {
            "number": each.number,
            "part": each.part,
            "begin_mm": round(each.begin_mm, 6),
            "area_mm2": round(each.area_mm2, 6),
            "pieces": [piece.name for piece in each.pieces],
            "registration_holes": max((len(piece.holes) for piece in each.pieces), default=0),
        }
        for each in stack.slices
    ]
    volumes = {"volume_mm3": stack.volume_mm3, "solid_volume_mm3": stack.solid_volume_mm3}
    return {"format": "CNCStepper report", "thickness_mm": stack.thickness_mm, **volumes, "slices": rows}


def slice_chains(each: Slice) -> Iterator[Chain]:
    """Yield the chains of a sheet of the stack, where the solid has them."""
    for piece in each.pieces:
        yield from piece_chains(piece, each.number)


def piece_chains(piece: Piece, number: int) -> Iterator[Chain]:
    """Yield the outline, the registration holes and the number of a piece."""
    for ring in piece.rings:
        yield Chain(ring, CUT)
    for hole in piece.holes:
        yield Chain(circle((hole.x_mm, hole.y_mm), hole.diameter_mm / 2.0), REGISTRATION)
    yield from mark_chains(piece, str(number))


def mark_chains(piece: Piece, digits: str) -> Iterator[Chain]:
    """Yield the strokes of a number in the widest place of a piece; none where it would be too small."""
    free = without_holes(piece)
    widest = shapely.maximum_inscribed_circle(free, tolerance=0.5)
    wide, high = DIGIT_STEP * (len(digits) - 1) + 1.0, 2.0
    scale_mm = min(1.6 * widest.length / np.hypot(wide, high), HIGHEST_MARK_MM / 2.0)
    if 2.0 * scale_mm < LOWEST_MARK_MM:
        return
    centre = np.asarray(widest.coords)[0]
    for place, digit in enumerate(digits):
        corner = centre - scale_mm * np.array([wide / 2.0 - DIGIT_STEP * place, 1.0])
        for segment in DIGITS[int(digit)]:
            yield Chain(from_points(corner + scale_mm * np.array(SEGMENTS[segment])), MARK)


def without_holes(piece: Piece) -> Polygon:
    """Return the outline of a piece without its registration holes, of chords within the circles."""
    discs = [_disc(hole.x_mm, hole.y_mm, hole.diameter_mm / 2.0) for hole in piece.holes]
    return piece.outline.difference(shapely.union_all(discs)) if discs else piece.outline


def _disc(x_mm: float, y_mm: float, radius_mm: float) -> Polygon:
    angles = np.linspace(0.0, 2.0 * np.pi, CIRCLE_CORNERS, endpoint=False)
    return Polygon(np.column_stack([x_mm + radius_mm * np.cos(angles), y_mm + radius_mm * np.sin(angles)]))


def nest_order(stack: Stack, size_mm: tuple[float, float], gap_mm: float, margin_mm: float) -> Order:
    """Return the order that nests all pieces, those of a part together, on as many sheets as there are pieces."""
    pieces = [(each, piece) for each in stack.slices for piece in each.pieces]
    levels = {part: -place for place, part in enumerate(dict.fromkeys(each.part for each in stack.slices))}
    items = tuple(
        Item(
            piece.name,
            simplified(piece.outline, COARSE_MM),
            piece.outline,
            rotations_deg=(0.0, 90.0, 180.0, 270.0),
            priority=levels[each.part],
        )
        for each, piece in pieces
    )
    chains = tuple(tuple(piece_chains(piece, each.number)) for each, piece in pieces)
    sheet = Sheet("sheet", shapely.box(0.0, 0.0, *size_mm))
    return Order(items, (sheet,) * len(items), Spacing(gap_mm, margin_mm), chains)
