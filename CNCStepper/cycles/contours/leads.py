# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Leads in and out, fitted so that the tool on them touches nothing that is to stay.

         arc                    line
    begin.                begin \
          \                      \ angle
    -------'-------> t     -------'-------> t     the contour; its part lies below, the scrap above

A lead is proven: from a place at distance f of all walls no place within f - need can be too near, so that
halving the lead until every stretch is shown free (or one place is too near) decides it within PROVEN_MM.
Places along the contour are tried at full size, then at smaller ones down to SIZES[-1].
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.cycles.contours.contour_model import Lead
from CNCStepper.errors import CycleError, Text
from CNCStepper.geometry.curve import Curve, joined
from CNCStepper.geometry.curve_columns import xy_of

SIZES = (1.0, 0.7, 0.5, 0.35, 0.25, 0.15)
LONGEST = 16  # segments whose middles are tried first
SPREAD = 48  # places tried then
LOOKED_AT = (1.0, 0.5, 0.2)  # shares of a lead's length that are sampled before it is proven
CHORD_MM = 0.0005
PROVEN_MM = 0.0005


class Walls:
    """Curves that the tool's centre must keep away from, each by its own distance."""

    def __init__(self, curves: Sequence[Curve], need_mm: Sequence[float], names: Sequence[str]):
        chords = [curve.points(CHORD_MM) for curve in curves]
        edges = [np.stack([points[:-1], points[1:]], axis=1) for points in chords]
        self._trees = {}
        for need in sorted(set(need_mm)):
            mine = [index for index, own in enumerate(need_mm) if own == need]
            lines = shapely.linestrings(np.concatenate([edges[index] for index in mine]))
            owner = np.repeat(mine, [len(edges[index]) for index in mine])
            self._trees[need] = (shapely.STRtree(lines), owner)
        self._names = names

    def room_mm(self, places: np.ndarray) -> np.ndarray:
        """Return by how much each place, float64[m, 2], is farther from the walls than it must be."""
        room = np.full(len(places), np.inf)
        for need, (tree, _) in self._trees.items():
            far = tree.query_nearest(shapely.points(places), return_distance=True, all_matches=False)[1]
            room = np.minimum(room, far - need)
        return room

    def nearest(self, place: np.ndarray) -> tuple[str, float, float, np.ndarray]:
        """Return of what most hinders a place its name, how far it is, how far it must be, and where it is."""
        point, found = shapely.Point(place), []
        for need, (tree, owner) in self._trees.items():
            index, far = tree.query_nearest(point, return_distance=True, all_matches=False)
            there = shapely.get_coordinates(shapely.shortest_line(point, tree.geometries[index[0]]))[1]
            found.append((float(far[0]) - need, self._names[owner[index[0]]], float(far[0]), need, there))
        return min(found, key=lambda each: each[0])[1:]

    def free(self, curves: Sequence[Curve]) -> np.ndarray:
        """Return which curves keep away from every wall, bool[k], proven within PROVEN_MM."""
        free = np.ones(len(curves), bool)
        owner = np.arange(len(curves))
        first, last = np.zeros(len(curves)), np.array([curve.length_mm for curve in curves])
        while len(owner):
            middle, half = (first + last) / 2.0, (last - first) / 2.0
            room = self.room_mm(_places(curves, owner, middle)) - CHORD_MM
            free[owner[room < -PROVEN_MM]] = False
            open_ = free[owner] & (room < half - PROVEN_MM) & (half > PROVEN_MM)
            first, middle, last, owner = first[open_], middle[open_], last[open_], owner[open_]
            first, last, owner = np.r_[first, middle], np.r_[middle, last], np.r_[owner, owner]
        return free


@dataclass(frozen=True)
class Fitted:
    """Where a closed contour begins, its leads (None where there is none), and how small they had to be made."""

    start_mm: float
    lead_in: Curve | None
    lead_out: Curve | None
    size: float

    @property
    def leads(self) -> list[Curve]:
        """The leads that there are."""
        return [lead for lead in (self.lead_in, self.lead_out) if lead is not None]


def lead_curve(lead: Lead, size: float, place: complex, along: complex, scrap: int, entering: bool) -> Curve | None:
    """Return a lead at a place of a contour that runs `along` there; scrap is 1 when it lies to the left, else -1."""
    if lead.kind == "none":
        return None
    far = complex(lead_point(lead, size, np.array(place), np.array(along), scrap, entering, 1.0))
    bulge = math.tan(math.radians(lead.angle_deg) * scrap / 4.0) if lead.kind == "arc" else 0.0
    ends = [far, place] if entering else [place, far]
    return Curve(np.array([(end.real, end.imag) for end in ends]), np.array([bulge]))


def lead_point(
    lead: Lead, size: float, place: np.ndarray, along: np.ndarray, scrap: int, entering: bool, share: float
) -> np.ndarray:
    """Return the points at a share of a lead's length away from places, complex128[n]."""
    forth = -1 if entering else 1
    angle = math.radians(lead.angle_deg) * scrap * forth
    if lead.kind == "line":
        return place + forth * share * size * lead.length_mm * along * complex(math.cos(angle), math.sin(angle))
    centre = place + 1j * scrap * along * size * lead.radius_mm
    return centre + (place - centre) * complex(math.cos(share * angle), math.sin(share * angle))


def fit_closed(curve: Curve, leads: tuple[Lead, Lead], overcut_mm: float, scrap: int, walls: Walls) -> Fitted:
    """Return where a closed contour may begin with leads in and out of at most their size.

    Raises CycleError that names the closest wall when they fit nowhere.
    """
    starts = _starts(curve)
    if all(lead.kind == "none" for lead in leads):
        return Fitted(float(starts[0]), None, None, 1.0)
    for size in SIZES:
        for start in starts[_promising(curve, starts, leads, overcut_mm, scrap, size, walls)].tolist():
            fitted = _at(curve, start, leads, overcut_mm, scrap, size)
            if walls.free(joined_leads(fitted)).all():
                return fitted
    raise _no_room(_at(curve, float(starts[0]), leads, overcut_mm, scrap, SIZES[-1]), walls)


def fit_open(curve: Curve, leads: tuple[Lead, Lead], scrap: int, walls: Walls) -> Fitted:
    """Return the leads at the two ends of an open contour; raises CycleError when one does not fit."""
    for size in SIZES:
        fitted = Fitted(0.0, *_two(curve, (0.0, curve.length_mm), leads, scrap, size), size)
        if walls.free(fitted.leads).all():
            return fitted
    raise _no_room(fitted, walls)


def joined_leads(fitted: Fitted) -> list[Curve]:
    """Return the leads, as one curve where they meet."""
    first, last = fitted.lead_in, fitted.lead_out
    if first is not None and last is not None and np.allclose(first.xy[-1], last.xy[0], atol=1e-9, rtol=0.0):
        return [joined([first, last])]
    return fitted.leads


def _at(curve: Curve, place: float, leads: tuple[Lead, Lead], overcut_mm: float, scrap: int, size: float) -> Fitted:
    ends = (place, (place + overcut_mm) % curve.length_mm)
    return Fitted(place, *_two(curve, ends, leads, scrap, size), size)


def _two(
    curve: Curve, ends: tuple[float, float], leads: tuple[Lead, Lead], scrap: int, size: float
) -> tuple[Curve | None, Curve | None]:
    points, directions = curve.at_length(np.array(ends))
    places, along = points @ (1, 1j), directions @ (1, 1j)
    return (
        lead_curve(leads[0], size, places[0], along[0], scrap, entering=True),
        lead_curve(leads[1], size, places[1], along[1], scrap, entering=False),
    )


def _promising(
    curve: Curve, starts: np.ndarray, leads: tuple[Lead, Lead], overcut_mm: float, scrap: int, size: float, walls: Walls
) -> np.ndarray:
    """Return at which starts some points of both leads keep away from the walls, bool[n]: the others need no proof."""
    free = np.ones(len(starts), bool)
    for lead, entering in zip(leads, (True, False), strict=True):
        points, directions = curve.at_length(starts if entering else (starts + overcut_mm) % curve.length_mm)
        for share in LOOKED_AT if lead.kind != "none" else ():
            there = lead_point(lead, size, points @ (1, 1j), directions @ (1, 1j), scrap, entering, share)
            free &= walls.room_mm(xy_of(there)) > -PROVEN_MM
    return free


def _starts(curve: Curve) -> np.ndarray:
    """Return lengths along a closed curve at which it may begin, the best first: middles of long segments."""
    before, long = curve.before_mm, curve.lengths_mm
    order = np.argsort(-np.round(long, 6), kind="stable")[:LONGEST]
    spread = (np.arange(SPREAD) + 0.5) * curve.length_mm / SPREAD
    return np.r_[before[order] + long[order] / 2.0, spread]


def _places(curves: Sequence[Curve], owner: np.ndarray, lengths_mm: np.ndarray) -> np.ndarray:
    places = np.empty((len(owner), 2))
    for index in np.unique(owner).tolist():
        mine = owner == index
        places[mine] = curves[index].at_length(lengths_mm[mine])[0]
    return places


def _no_room(fitted: Fitted, walls: Walls) -> CycleError:
    """Return the refusal, with the wall that the smallest leads come too near to."""
    places = np.vstack([lead.points(CHORD_MM) for lead in fitted.leads])
    worst = places[int(walls.room_mm(places).argmin())]
    name, far_mm, need_mm, (x, y) = walls.nearest(worst)
    return CycleError(
        "lead-room",
        Text(
            "the leads fit nowhere in the scrap; the closest obstacle is {name} at X{x:.3f} Y{y:.3f}",
            name=name,
            x=x,
            y=y,
        ),
        value=Text("{far_mm:.3f} mm from the tool's centre", far_mm=far_mm),
        limit=Text("at least {need_mm:.3f} mm", need_mm=need_mm),
        advice="make the leads or the tool smaller, move the parts apart, or do without leads",
    )
