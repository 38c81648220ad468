# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Where leads and pierces may be: the proof by distances that one touches no part and no cut edge.

    lead      its band, a kerf wide, keeps off every part, and a kerf off the paths of other contours and their leads
    pierce    its spot keeps off every part, and off the edge of every other cut
    sheet     both lie in the sheet, where its outline is known

All distances are between chords whose departure from the true curves is bounded and taken off.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.sheet_cutting.chord_pieces import FLAT_MM, ChordPieces

OTHER_MM = 0.002  # by so much more a lead keeps off other parts
OWN_MM = 0.003  # at its end a lead lies half a kerf from its own part: by so much less is rounding


@dataclass(frozen=True)
class LeadRoom:
    """What leads keep clear of.

    parts: the closed chains, by their index; paths: the paths, by the number of their item. part_of: the chain of each
    item. sheet: where pierces may be, None where that is not known.
    """

    kerf_mm: float
    pierce_mm: float
    parts: ChordPieces
    paths: ChordPieces
    part_of: np.ndarray
    sheet: BaseGeometry | None

    def pierces_fit(self, item: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Return which pierces, float64[n, 2], of items are in scrap and off cut edges, bool[n]."""
        spots = shapely.points(points)
        fits = self._in_sheet(spots)
        hit, _ = self.parts.near(spots, self.pierce_mm - FLAT_MM / 2.0)
        fits[hit] = False
        hit, run = self.paths.near(spots, self.pierce_mm + self.kerf_mm / 2.0)
        fits[hit[self.paths.owner[run] != item[hit]]] = False
        return fits

    def ways_fit(self, item: np.ndarray, ways: np.ndarray, flat_mm: np.ndarray) -> np.ndarray:
        """Return which ways, shapely lines whose chords leave them by flat_mm, of items are in scrap, bool[n]."""
        half_mm = self.kerf_mm / 2.0
        fits = self._in_sheet(ways)
        hit, run = self.parts.near(ways, half_mm + OTHER_MM + FLAT_MM + flat_mm)
        own = self.parts.owner[run] == self.part_of[item[hit]]
        fits[hit[~own]] = False
        hit, run = hit[own], run[own]
        near = shapely.distance(ways[hit], self.parts.lines[run]) < half_mm - OWN_MM
        fits[hit[near]] = False
        hit, run = self.paths.near(ways, self.kerf_mm + flat_mm)
        fits[hit[self.paths.owner[run] != item[hit]]] = False
        return fits

    def clearances_mm(self, item: np.ndarray, points: np.ndarray) -> np.ndarray:
        """Return how large a pierce's spot may be at points of items, float64[n]."""
        spots = shapely.points(points)
        far_mm = 1e9
        (hit, _), away_mm = self.parts.tree.query_nearest(spots, return_distance=True)
        room_mm = np.full(len(points), far_mm)
        np.minimum.at(room_mm, hit, away_mm)
        hit, run = self.paths.near(spots, room_mm + self.kerf_mm)
        other = self.paths.owner[run] != item[hit]
        away_mm = shapely.distance(spots[hit[other]], self.paths.lines[run[other]]) - self.kerf_mm / 2.0
        np.minimum.at(room_mm, hit[other], away_mm)
        return np.where(self._in_sheet(spots), room_mm, 0.0)

    def _in_sheet(self, shapes: np.ndarray) -> np.ndarray:
        if self.sheet is None:
            return np.ones(len(shapes), bool)
        return np.array(shapely.covers(self.sheet, shapes), bool)
