# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drawings of known contours, and the same drawings damaged at random as careless hands and exporters damage them."""

from __future__ import annotations

import math
import random
from collections import Counter
from dataclasses import dataclass, field

import numpy as np

from CNCStepper.drawing.drawing import Attributes, Drawing, Piece
from CNCStepper.drawing.joined_pieces import joined_pieces
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle

DAMAGES = ("pieces", "gap", "corner", "join", "double", "part_double", "tiny")
GAP_MM, JOIN_MM = 0.4, 0.03


@dataclass
class Damaged:
    """The contours that were meant, the drawing that came of them, and how often each damage was done."""

    meant: list[Curve]
    drawing: Drawing
    done: Counter[str] = field(default_factory=Counter)


def contours(chance: random.Random) -> list[Curve]:
    """Return closed contours of lines and arcs, apart from each other."""
    found = []
    for number in range(chance.randint(2, 6)):
        x, y = 60.0 * (number % 3), 60.0 * (number // 3)
        kind = chance.choice(("rectangle", "circle", "polygon"))
        if kind == "rectangle":
            size = (x + chance.uniform(15, 40), y + chance.uniform(15, 40))
            found.append(rectangle((x, y), size, chance.choice((0.0, chance.uniform(1, 6)))))
        elif kind == "circle":
            found.append(circle((x + 20, y + 20), chance.uniform(5, 20)))
        else:
            corners = chance.randint(3, 7)
            angles = [(number + chance.uniform(-0.2, 0.2)) * math.tau / corners for number in range(corners)]
            found.append(from_points([(x + 20 + 18 * math.cos(a), y + 20 + 18 * math.sin(a)) for a in angles], True))
    return found


def damaged(seed: int) -> Damaged:
    """Return a drawing damaged at random."""
    chance = random.Random(seed)
    result = Damaged(contours(chance), Drawing(()))
    parts: list[Curve] = []
    for curve in result.meant:
        parts += _damage(curve, chance, result.done)
    chance.shuffle(parts)
    pieces = [Piece(part, Attributes("CUT")) for part in parts]
    chains, gaps = joined_pieces(pieces)
    result.drawing = Drawing(chains, gaps)
    return result


def _damage(curve: Curve, chance: random.Random, done: Counter[str]) -> list[Curve]:
    """Return the pieces that one contour has become."""
    cuts = sorted(curve.before_mm[1:-1].tolist()) or [curve.length_mm / 2]
    parts = curve.split(cuts)
    done["pieces"] += len(parts) > 1
    parts = [part.reversed() if chance.random() < 0.5 else part for part in parts]
    for number, part in enumerate(parts):
        kind = chance.choice((*DAMAGES, "none", "none"))
        if kind in ("gap", "corner", "join"):
            parts[number] = _shortened(part, kind, chance, done)
    for part in list(parts):
        kind = chance.choice((*DAMAGES, "none", "none"))
        if kind == "double":
            parts.append(part.reversed())
            done[kind] += 1
        elif kind == "part_double":
            begin = chance.uniform(0.0, 0.4) * part.length_mm
            parts.append(part.part(begin, begin + chance.uniform(0.3, 0.55) * part.length_mm))
            done[kind] += 1
        elif kind == "tiny":
            x, y = part.at_length(part.length_mm / 2)[0]
            parts.append(from_points([(x, y + 2.0), (x + 0.01, y + 2.0)]))
            done[kind] += 1
    return parts


def _shortened(part: Curve, kind: str, chance: random.Random, done: Counter[str]) -> Curve:
    """Return a piece that ends early (gap), too late (corner), or a little beside its place (join)."""
    if part.length_mm < 5.0:
        return part
    if kind == "gap":
        done[kind] += 1
        return part.part(0.0, part.length_mm - chance.uniform(0.06, GAP_MM))
    if kind == "corner" and part.bulge[-1] == 0.0:
        done[kind] += 1
        along = part.xy[-1] - part.xy[-2]
        xy = part.xy.copy()
        xy[-1] += along / np.hypot(*along) * chance.uniform(0.06, GAP_MM)
        return Curve(xy, part.bulge)
    done["join"] += 1
    xy = part.xy.copy()
    angle = chance.uniform(0, math.tau)
    xy[-1] += np.array([math.cos(angle), math.sin(angle)]) * chance.uniform(0.0005, JOIN_MM)
    return Curve(xy, part.bulge)
