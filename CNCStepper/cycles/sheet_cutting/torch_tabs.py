# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Tabs for a torch or jet: gaps in a contour, behind each of which it pierces anew.

            o pierce, in scrap            A torch has one power and cannot go over a tab: it stops before it. Its
            |                             kerf begins anew where the lead meets the path, square to it, so that the
--> ----->)   (-----------> -->           lead's kerf leaves the tab whole.
          <--->
          width
===============================           part
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from CNCStepper.cycles.sheet_cutting.chord_pieces import ChordPieces
from CNCStepper.cycles.sheet_cutting.lead_places import Item
from CNCStepper.cycles.sheet_cutting.lead_room import LeadRoom, NoScrap
from CNCStepper.cycles.sheet_cutting.lead_shapes import LINE, Leads, curve_of, flatness_mm, lead_points
from CNCStepper.cycles.sheet_cutting.sheet_model import MicroJoints
from CNCStepper.cycles.sheet_cutting.strokes import joint_places
from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve

TRIED = 24  # places for each tab
SIZES = (1.0, 0.5, 0.0)  # between the wanted length of a lead and the least
SQUARE = math.pi / 2.0


def tabbed_paths(
    items: Sequence[Item],
    number: int,
    tabs: MicroJoints,
    lengths_mm: tuple[float, float],
    room: LeadRoom,
    side: int,
    taken: Sequence[Curve],
) -> list[tuple[Curve, Curve]]:
    """Return the stretches of a closed path between its tabs, each with its lead-in.

    number: of the item. lengths_mm: of leads, as wanted and the least. side: +1 where the scrap lies left of the path.
    taken: the leads of other contours. Raises CycleError where a tab has no scrap for the pierce behind it.
    """
    path, chain = items[number].path, items[number].chain
    wanted_mm = joint_places(path, chain, tabs, room.kerf_mm)
    gap_mm = tabs.width_mm + room.kerf_mm
    search = _Search(items, number, lengths_mm, room, side)
    leads: list[Curve] = []
    begins: list[float] = []
    for place in (at_mm + gap_mm / 2.0 for at_mm in wanted_mm):
        reach_mm = path.length_mm / len(wanted_mm) / 2.0 - gap_mm / 2.0
        found = search.nearest(place, max(reach_mm, 0.0), [*taken, *leads])
        if found is None:
            raise _no_scrap(path, chain.title, place, room)
        begins.append(found[0])
        leads.append(found[1])
    ends = [*begins[1:], begins[0] + path.length_mm]
    return [(path.part(begin, end - gap_mm), lead) for begin, end, lead in zip(begins, ends, leads, strict=True)]


class _Search:
    """The leads, square to one path, that lie in scrap: where they meet it, float64[n], and their points."""

    def __init__(self, items: Sequence[Item], number: int, lengths_mm: tuple[float, float], room: LeadRoom, side: int):
        self._path, self._room, self._side = items[number].path, room, side
        full_mm, least_mm = lengths_mm
        self._sizes_mm = [least_mm + share * max(full_mm - least_mm, 0.0) for share in SIZES]
        self._paths, self._number = [item.path for item in items], number

    def nearest(self, place_mm: float, reach_mm: float, taken: Sequence[Curve]) -> tuple[float, Curve] | None:
        """Return the place nearest to a wanted one, within a reach, where a lead fits, and the longest such lead."""
        shifts = np.linspace(-reach_mm, reach_mm, 2 * TRIED + 1)
        shifts = shifts[np.argsort(np.abs(shifts), kind="stable")]
        places = np.tile((place_mm + shifts) % self._path.length_mm, len(self._sizes_mm))
        leads = Leads(
            np.full(len(places), self._number),
            places,
            np.full(len(places), LINE),
            np.repeat(self._sizes_mm, len(shifts)),
            np.full(len(places), SQUARE),
        )
        points = lead_points(leads, self._paths, self._side, into=True)
        fits = np.flatnonzero(self._fit(leads, points, taken))
        if not len(fits):
            return None
        best = int(fits[np.lexsort([fits // len(shifts), fits % len(shifts)])[0]])
        lead = curve_of(leads.rows(np.array([best])), points[best], self._side, into=True)
        return place_mm + float(shifts[best % len(shifts)]), lead

    def _fit(self, leads: Leads, points: np.ndarray, taken: Sequence[Curve]) -> np.ndarray:
        room, lines = self._room, shapely.linestrings(points)
        fits = room.pierces_fit(leads.item, points[:, 0]) & room.ways_fit(leads.item, lines, flatness_mm(leads))
        if taken:
            hit, _ = ChordPieces(list(taken)).near(lines, room.pierce_mm + room.kerf_mm / 2.0)
            fits[hit] = False
        return fits


def _no_scrap(path: Curve, title: str, place_mm: float, room: LeadRoom) -> NoScrap:
    x, y = path.at_length(place_mm % path.length_mm)[0].tolist()
    what = Text(
        "there is no scrap for the pierce behind a tab of {chain} near X{x:.3f} Y{y:.3f}", chain=title, x=x, y=y
    )
    return NoScrap("tab-lead", what, value=room.pierce_value, scrap_mm=room.scrap_mm(False))
