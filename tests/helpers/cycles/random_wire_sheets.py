# SPDX-License-Identifier: LGPL-2.1-or-later
"""Random sheets of random parts for the wire: tight pairs, parts in holes, parts at the edge, rings of parts, lines."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.shapes.rectangle import rectangle
from helpers.cycles.random_outlines import polygon

TRIES = 60  # to place a part
LAYOUTS = ("loose", "tight", "nested", "ring", "lines")
TIGHT_KERFS = 1.02  # the gap of a tight pair


@dataclass(frozen=True)
class Sheet:
    """A sheet: its outline, the drawn curves, the kerf, and how many of the hard things it has."""

    layout: str
    outline: Curve
    curves: tuple[Curve, ...]
    kerf_mm: float
    tight: int
    at_edge: int

    @property
    def outer(self) -> list[BaseGeometry]:
        """The closed curves as polygons."""
        return [polygon(curve) for curve in self.curves if curve.closed]

    @property
    def lines(self) -> list[Curve]:
        """The open curves."""
        return [curve for curve in self.curves if not curve.closed]


def random_wire_sheet(seed: int) -> Sheet:
    """Return the sheet of a seed; the layout follows from it, so that each has its share."""
    rng = np.random.default_rng(seed)
    layout = LAYOUTS[seed % len(LAYOUTS)]
    width, height = rng.uniform(160, 300), rng.uniform(110, 200)
    kerf_mm = round(float(rng.uniform(0.4, 2.0)), 2)
    maker = _Maker(rng, width, height, kerf_mm)
    if layout == "nested":
        maker.nested()
    if layout == "ring":
        maker.ring()
    maker.loose(int(rng.integers(2, 7)))
    if layout == "tight":
        maker.beside()
    if rng.random() < 0.4:
        maker.edge()
    if layout == "lines":
        maker.lines(int(rng.integers(1, 4)))
    sheet = rectangle((0.0, 0.0), (width, height))
    order = rng.permutation(len(maker.curves))
    curves = tuple(maker.curves[index] for index in order)
    return Sheet(layout, sheet, curves, kerf_mm, maker.tight, maker.at_edge)


class _Maker:
    """Places curves so that each keeps its gap from the others."""

    def __init__(self, rng: np.random.Generator, width: float, height: float, kerf_mm: float):
        self._rng, self._size, self._kerf_mm = rng, np.array([width, height]), kerf_mm
        self.curves: list[Curve] = []
        self._taken: BaseGeometry = shapely.Polygon()
        self.tight = self.at_edge = 0

    def loose(self, count: int) -> None:
        """Place parts anywhere within the sheet."""
        for _ in range(count):
            gap_mm = self._kerf_mm + float(self._rng.uniform(1.0, 8.0))
            for _ in range(TRIES):
                part = _shape(self._rng, float(self._rng.uniform(8.0, 30.0)))
                part = part.moved(*self._rng.uniform(0.1, 0.9, 2) * self._size)
                if self._fits(part, gap_mm, gap_mm):
                    self._add(part)
                    break

    def nested(self) -> None:
        """Place a part with one or two holes and parts in them."""
        x, y = self._size / 2.0
        side = float(self._rng.uniform(60.0, 90.0))
        self._add(rectangle((x - side / 2, y - 30.0), (x + side / 2, y + 30.0), 5.0))
        if self._rng.random() < 0.5:
            self.curves += [circle((x, y), 22.0), _shape(self._rng, 8.0).moved(x + 2.0, y - 1.0)]
            return
        for way in (-1, 1):
            self.curves.append(circle((x + way * side / 4, y), float(self._rng.uniform(4.0, 12.0))))

    def ring(self) -> None:
        """Place a part in a ring of four, of which three gaps are tight."""
        x, y = self._size / 2.0
        gap, wide = self._kerf_mm * 1.3, self._kerf_mm + 4.0
        low = rectangle((x - 30, y - 30), (x + 30, y - 20))
        left = rectangle((x - 30, y - 20 + gap), (x - 20, y + 30))
        top = rectangle((x - 20 + gap, y + 20), (x + 30, y + 30))
        right = rectangle((x + 20, y - 20 + gap), (x + 30, y + 20 - wide))
        for part in (low, left, top, right, circle((x, y), 8.0)):
            self._add(part)
        self.tight += 3

    def beside(self) -> None:
        """Place a part beside another one, hardly more than a kerf away."""
        for part in list(self.curves):
            low_x, _, high_x, high_y = part.box_mm
            gap_mm = TIGHT_KERFS * self._kerf_mm
            other = rectangle((low_x, high_y + gap_mm), (high_x, high_y + gap_mm + 8.0))
            if self._fits(other, 0.99 * gap_mm, self._kerf_mm):
                self._add(other)
                self.tight += 1
                return

    def edge(self) -> None:
        """Place a part at the sheet's edge."""
        for _ in range(TRIES):
            x = float(self._rng.uniform(5.0, self._size[0] - 30.0))
            off_mm = float(self._rng.choice([0.0, 0.3]))
            part = rectangle((x, off_mm), (x + 20.0, 12.0))
            if self._fits(part, self._kerf_mm + 3.0, off_mm - 0.1):
                self._add(part)
                self.at_edge += 1
                return

    def lines(self, count: int) -> None:
        """Place open chains of lines and an arc."""
        for _ in range(count * TRIES):
            begin, angle = self._rng.uniform(0.1, 0.9, 2) * self._size, self._rng.uniform(0, 2 * math.pi)
            step = float(self._rng.uniform(5.0, 20.0)) * np.array([math.cos(angle), math.sin(angle)])
            xy = np.array([begin, begin + step, begin + 1.5 * step + step[::-1] * 0.3])
            line = Curve(xy, np.array([0.0, float(self._rng.uniform(-0.5, 0.5))]))
            if self._fits(line, self._kerf_mm + 4.0, 4.0):
                self._add(line)
                count -= 1
            if not count:
                return

    def _fits(self, curve: Curve, gap_mm: float, edge_mm: float) -> bool:
        low_x, low_y, high_x, high_y = curve.box_mm
        inside = min(low_x, low_y, self._size[0] - high_x, self._size[1] - high_y) >= edge_mm
        return inside and (not self.curves or shapely.distance(_area(curve), self._taken) >= gap_mm)

    def _add(self, curve: Curve) -> None:
        self.curves.append(curve)
        self._taken = self._taken.union(_area(curve))


def _area(curve: Curve) -> BaseGeometry:
    return polygon(curve) if curve.closed else shapely.LineString(curve.points(0.001))


def _shape(rng: np.random.Generator, size_mm: float) -> Curve:
    kind = rng.choice(["star", "circle", "box", "arcs", "slot", "notch"])
    angles = np.arange(10) * math.pi / 5
    ring = size_mm * np.column_stack([np.cos(angles), np.sin(angles)])
    if kind == "star":
        return from_points(ring * np.where(np.arange(10) % 2, rng.uniform(0.4, 0.9), 1.0)[:, None], closed=True)
    if kind == "circle":
        return circle((0.0, 0.0), size_mm)
    if kind == "box":
        return rectangle((-size_mm, -size_mm / 2), (size_mm, size_mm / 2)).rotated(float(rng.uniform(0, 90)))
    if kind == "arcs":
        bulge = np.append(rng.uniform(-0.2, 0.5, 9), 0.0)
        return Curve(np.vstack([ring, ring[:1]]), bulge)
    if kind == "slot":
        corners = size_mm * np.array([(-1, -0.3), (1, -0.3), (1, 0.3), (-1, 0.3), (-1, -0.3)])
        return Curve(corners, np.array([0, 1, 0, 1.0])).rotated(float(rng.uniform(0, 360)))
    notch = [(-1, -1), (1, -1), (1, 1), (0.4, 1), (0.4, -0.3), (-0.4, -0.3), (-0.4, 1), (-1, 1)]
    return from_points(size_mm * np.array(notch), closed=True).rotated(float(rng.uniform(0, 360)))
