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
from CNCStepper.errors import CycleError, Text

OTHER_MM = 0.002  # by so much more a lead keeps off other parts
NO_PIERCE_MM = "leave so much, ask for fewer tabs, or cut with a narrower kerf: no smaller pierce_mm does"
OWN_MM = 0.003  # at its end a lead lies half a kerf from its own part: by so much less is rounding


class NoScrap(CycleError):
    """There is no scrap for a pierce; scrap_mm: the width of scrap that would hold it."""

    def __init__(self, code: str, what: Text, *, value: Text, scrap_mm: float):
        super().__init__(code, what, value=value, advice=NO_PIERCE_MM)
        self.scrap_mm = scrap_mm

    def with_most(self, pierce_mm: float | None) -> CycleError:
        """Return the refusal with the largest pierce_mm that does for all contours; None where none does."""
        scrap = Text("{scrap_mm:.2f} mm of scrap there", scrap_mm=self.scrap_mm)
        if pierce_mm is None:
            return CycleError(self.code, self.what, value=self.value, limit=scrap, advice=NO_PIERCE_MM)
        return CycleError(
            self.code,
            self.what,
            value=self.value,
            limit=Text("at most {most_mm:.2f} mm", most_mm=pierce_mm),
            advice=Text("set pierce_mm to that limit, or leave {scrap}", scrap=scrap),
        )


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

    @property
    def pierce_value(self) -> Text:
        """How far pierces stay off, in words for people."""
        return Text("{pierce_mm:g} mm from parts and cut edges", pierce_mm=self.pierce_mm)

    def scrap_mm(self, in_hole: bool) -> float:
        """Return how wide scrap must be for a pierce: in a hole, or between a part and another one with its cut."""
        return 2.0 * self.pierce_mm + (0.0 if in_hole else self.kerf_mm)

    def _in_sheet(self, shapes: np.ndarray) -> np.ndarray:
        if self.sheet is None:
            return np.ones(len(shapes), bool)
        return np.array(shapely.covers(self.sheet, shapes), bool)
