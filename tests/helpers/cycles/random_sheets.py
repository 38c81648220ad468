# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random sheets of random parts: parts in holes, tight gaps, small holes, slots, bays with parts in them, arcs.

sheet = random_sheet(seed)      sheet.curves: as drawn, in any order and direction; sheet.traits: what is in it
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np

from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle

TRAITS = ("part in hole", "tight gap", "small hole", "slot", "bay", "arcs", "enclosed")


@dataclass
class Sheet:
    """What is drawn: outlines and holes in any order; kerf, least distance of pierces, the sheet's outline."""

    kerf_mm: float
    pierce_mm: float
    curves: list[Curve] = field(default_factory=list)
    traits: set[str] = field(default_factory=set)
    parts: int = 0

    @property
    def outline(self) -> Curve:
        boxes = np.array([curve.box_mm for curve in self.curves])
        low, high = boxes[:, :2].min(axis=0) - 20.0, boxes[:, 2:].max(axis=0) + 20.0
        return rectangle(tuple(low.tolist()), tuple(high.tolist()))


def random_sheet(seed: int) -> Sheet:
    """Return a sheet of three to eight cells with something random in each."""
    rng = np.random.default_rng(seed)
    kerf_mm = float(rng.choice([0.2, 1.0, 1.5]))
    sheet = Sheet(kerf_mm, max(kerf_mm / 2.0, float(rng.choice([0.0, 1.2, 2.0]))))
    makers = (plain, with_holes, ring_with_part, slotted, bay_with_part, tight_row, three_discs)
    for cell in range(int(rng.integers(3, 9))):
        drawn = makers[int(rng.integers(len(makers)))](sheet, rng)
        turn = float(rng.choice([0.0, 30.0, 77.0]))
        place = np.array([cell % 3, cell // 3]) * 260.0 + rng.uniform(0.0, 5.0, 2)
        moved = [curve.rotated(turn).moved(*place) for curve in drawn]
        sheet.curves += [curve.reversed() if rng.random() < 0.5 else curve for curve in moved]
    sheet.curves = [sheet.curves[index] for index in rng.permutation(len(sheet.curves))]
    return sheet


def plain(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return a star, a rounded rectangle or a disc."""
    sheet.parts += 1
    kind = int(rng.integers(3))
    if kind == 0:
        count = int(rng.integers(4, 9))
        angles = np.arange(2 * count) * math.pi / count
        radii = np.where(np.arange(2 * count) % 2, rng.uniform(9.0, 14.0), rng.uniform(18.0, 25.0))
        return [from_points(np.column_stack([radii * np.cos(angles), radii * np.sin(angles)]), closed=True)]
    sheet.traits.add("arcs")
    return [circle((0.0, 0.0), 18.0) if kind == 1 else rectangle((-20.0, -12.0), (20.0, 12.0), 5.0)]


def with_holes(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return a plate with round and square holes, of which some are small."""
    sheet.parts += 1
    room_mm = sheet.pierce_mm + 0.05
    holes = [circle((x, y), float(rng.uniform(room_mm, room_mm + 5.0))) for x, y in ((-20, -10), (20, -10), (20, 10))]
    if min(hole.length_mm for hole in holes) < math.pi * 4.0 * max(room_mm, 1.0):
        sheet.traits.add("small hole")
    sheet.traits.add("arcs")
    side = float(rng.uniform(room_mm * 2.0 + 0.1, 12.0))
    return [rectangle((-32.0, -22.0), (32.0, 22.0)), *holes, rectangle((-24.0, 6.0), (-24.0 + side, 6.0 + side))]


def ring_with_part(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return a ring, a part in its hole, and a hole in that."""
    sheet.parts += 2
    sheet.traits |= {"part in hole", "arcs"}
    gap_mm = float(rng.uniform(1.1 * sheet.kerf_mm, 8.0)) + 2.0 * sheet.pierce_mm + sheet.kerf_mm
    inner = 24.0 - gap_mm
    return [
        circle((0.0, 0.0), 34.0),
        circle((0.0, 0.0), 24.0),
        circle((0.0, 0.0), inner),
        circle((1.0, 0.0), inner / 2),
    ]


def slotted(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return a plate with a slot from its edge, narrower or wider than the kerf."""
    sheet.parts += 1
    sheet.traits.add("slot")
    wide = sheet.kerf_mm * float(rng.choice([0.6, 1.2, 3.0]))
    points = [(-25, -15), (25, -15), (25, 15), (wide, 15), (wide, -5), (0, -5), (0, 15), (-25, 15)]
    return [from_points(points, closed=True)]


def bay_with_part(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return a C with a part in its bay, whose mouth the kerf passes once or hardly twice."""
    sheet.parts += 2
    sheet.traits.add("bay")
    half = sheet.kerf_mm * float(rng.choice([0.6, 0.8, 1.4]))
    points = [(-35, -30), (35, -30), (35, -half), (25, -half), (25, -20), (-25, -20), (-25, 20), (25, 20), (25, half),
              (35, half), (35, 30), (-35, 30)]  # fmt: skip
    return [from_points(points, closed=True), rectangle((-8.0, -6.0), (8.0, 6.0), 2.0)]


def tight_row(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return three plates in a row whose gaps are little wider than the kerf."""
    sheet.parts += 3
    sheet.traits.add("tight gap")
    pitch_mm = 22.0 + sheet.kerf_mm * float(rng.choice([1.02, 1.5, 1.95]))
    return [rectangle((-32.0 + pitch_mm * number, -12.0), (-10.0 + pitch_mm * number, 12.0)) for number in range(3)]


def three_discs(sheet: Sheet, rng: np.random.Generator) -> list[Curve]:
    """Return three discs whose cuts run into each other, and a small part in the scrap between them."""
    sheet.parts += 4
    sheet.traits |= {"tight gap", "arcs"}
    gap_mm, small_mm = sheet.kerf_mm * float(rng.choice([1.05, 1.5])), 0.8
    if rng.random() < 0.5:
        radius_mm = 22.0
    else:  # room for the small part, its pierce and its cut
        radius_mm = (2.0 * sheet.pierce_mm + 1.5 * sheet.kerf_mm + small_mm + 1.0) / (
            1.0 / math.cos(math.pi / 6.0) - 1.0
        )
    far_mm = (radius_mm + gap_mm / 2.0) / math.cos(math.pi / 6.0)
    corners = [far_mm * np.exp(2j * math.pi * number / 3.0) for number in range(3)]
    discs = [circle((corner.real, corner.imag), radius_mm) for corner in corners]
    if radius_mm == 22.0:
        sheet.parts -= 1
        return discs
    sheet.traits.add("enclosed")
    return [*discs, circle((0.0, 0.0), small_mm)]
