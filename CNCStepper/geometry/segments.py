# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lines and arcs as columns of complex numbers: what a Curve computes with, one row a segment.

    begin  complex128[n]   where the segment begins, x + iy, mm
    end    complex128[n]   where it ends; exactly where the next one of a chain begins
    sweep  float64[n]      the angle it turns through, rad, positive counter-clockwise, 0 for a line

No centre comes in: a nearly straight arc has it so far away that nothing could be computed from it.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

Row = np.ndarray | slice | int


class Segments(NamedTuple):
    """Columns of segments; see the module's text."""

    begin: np.ndarray
    end: np.ndarray
    sweep: np.ndarray

    @property
    def chord(self) -> np.ndarray:
        """From begin to end, complex128[n]."""
        return self.end - self.begin

    @property
    def curvature(self) -> np.ndarray:
        """One over the radius, float64[n], 1/mm, positive where it turns left, 0 for lines."""
        size = np.abs(self.chord)
        return 2.0 * np.sin(self.sweep / 2.0) / np.where(size > 0.0, size, 1.0)

    @property
    def length_mm(self) -> np.ndarray:
        """The length, float64[n]."""
        half = np.abs(self.sweep) / 2.0
        return np.abs(self.chord) * np.where(half > 0.0, half / np.sin(np.where(half > 0.0, half, 1.0)), 1.0)

    @property
    def along(self) -> np.ndarray:
        """The unit vector of the chord, complex128[n]; 1 where there is none."""
        size = np.abs(self.chord)
        return np.where(size > 0.0, self.chord / np.where(size > 0.0, size, 1.0), 1.0)

    def rows(self, rows: Row) -> Segments:
        """Return some of the segments."""
        return Segments(self.begin[rows], self.end[rows], self.sweep[rows])

    def at(self, share: np.ndarray | float) -> np.ndarray:
        """Return the point at a share of each segment's length, complex128[n].

        The chord to such a point is the whole chord, shortened and turned back.
        """
        whole = np.sin(self.sweep / 2.0)
        shortened = np.where(whole != 0.0, np.sin(share * self.sweep / 2.0) / np.where(whole, whole, 1.0), share)
        return self.begin + self.chord * shortened * np.exp(-0.5j * self.sweep * (1.0 - share))

    def direction(self, share: np.ndarray | float) -> np.ndarray:
        """Return the unit direction of travel at a share of each segment's length, complex128[n]."""
        return self.along * np.exp(1j * self.sweep * (share - 0.5))

    def divided(self, counts: np.ndarray) -> tuple[np.ndarray, Segments]:
        """Return each segment in equal parts, `counts` int64[n] of them, and which segment each part is of."""
        row = np.repeat(np.arange(len(counts)), counts)
        number = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)
        whole = self.rows(row)
        first, last = whole.at(number / counts[row]), whole.at((number + 1) / counts[row])
        first = np.where(number == 0, whole.begin, first)
        last = np.where(number + 1 == counts[row], whole.end, last)
        return row, Segments(first, last, whole.sweep / counts[row])

    def boxes_mm(self) -> np.ndarray:
        """Return the box round each segment, float64[n, 4]: least x, least y, greatest x, greatest y."""
        places = [self.begin, self.end]
        for quarter in range(4):  # the point where the outward normal looks along an axis, when the arc has one
            share = self._share_of_direction(np.exp(0.5j * math.pi * quarter))
            places.append(np.where(share <= 1.0, self.at(np.minimum(share, 1.0)), self.begin))
        x, y = np.real(places), np.imag(places)
        return np.column_stack([x.min(axis=0), y.min(axis=0), x.max(axis=0), y.max(axis=0)])

    def _share_of_direction(self, direction: complex | np.ndarray) -> np.ndarray:
        """Return at which share each arc travels along a direction; above 1 where it never does, as no line does."""
        turn = np.angle(direction * np.conj(self.direction(0.0))) * np.sign(self.sweep)
        turn = np.where(turn < 0.0, turn + 2.0 * math.pi, turn)
        return turn / np.where(self.sweep != 0.0, np.abs(self.sweep), 1e-300)

    def monotone(self) -> tuple[np.ndarray, Segments]:
        """Return the segments cut where they run level (least and greatest y), and which segment each part is of."""
        first = self._share_of_direction(1.0 + 0j)
        second = self._share_of_direction(-1.0 + 0j)
        cuts = np.sort(np.minimum(np.column_stack([first, second]), 1.0), axis=1)
        bounds = np.column_stack([np.zeros(len(cuts)), cuts, np.ones(len(cuts))])
        row, part = np.nonzero(np.diff(bounds, axis=1) > 0.0)
        whole, begin, end = self.rows(row), bounds[row, part], bounds[row, part + 1]
        first_place = np.where(begin == 0.0, whole.begin, whole.at(begin))
        last_place = np.where(end == 1.0, whole.end, whole.at(end))
        return row, Segments(first_place, last_place, whole.sweep * (end - begin))


def segments_of(xy: np.ndarray, bulge: np.ndarray) -> Segments:
    """Return the columns of a chain: vertices float64[n + 1, 2] and bulges float64[n]."""
    vertices = complex_of(xy)
    return Segments(vertices[:-1], vertices[1:], 4.0 * np.arctan(bulge))


def complex_of(xy: np.ndarray) -> np.ndarray:
    """Return points, float64[..., 2], as complex numbers."""
    return xy[..., 0] + 1j * xy[..., 1]


def xy_of(places: np.ndarray) -> np.ndarray:
    """Return complex numbers as points, float64[..., 2]."""
    return np.stack([places.real, places.imag], axis=-1)
