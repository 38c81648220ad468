# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Leads as columns: where they meet a path, of which kind, size and angle, and the chords along them.

       pierce o                      side     +1: the scrap lies left of the path, -1: right of it
               \  line, angle        into     true: from the pierce to the path; false: from the path on
---------------->*------------->
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from CNCStepper.geometry.curve import Curve, straight

CHORDS = 24  # of a lead, whatever it is: all leads are rows of one array
LINE, ARC = 0, 1


@dataclass(frozen=True)
class Leads:
    """Leads as columns of equal length: item int64[n], place_mm, kind, size_mm, angle_rad: float64[n] but for kind.

    item: the number of the path. place_mm: the length along it where the two meet. size_mm: the length of a line, the
    radius of an arc; angle_rad: between a line and the path behind its meeting point, or by how much an arc turns.
    """

    item: np.ndarray
    place_mm: np.ndarray
    kind: np.ndarray
    size_mm: np.ndarray
    angle_rad: np.ndarray

    def __len__(self) -> int:
        return len(self.item)

    def rows(self, which: np.ndarray) -> Leads:
        """Return some of the leads."""
        return Leads(
            self.item[which], self.place_mm[which], self.kind[which], self.size_mm[which], self.angle_rad[which]
        )


def together(leads: list[Leads]) -> Leads:
    """Return several columns of leads as one."""
    names = ("item", "place_mm", "kind", "size_mm", "angle_rad")
    return Leads(*(np.concatenate([getattr(each, name) for each in leads]) for name in names))


def lead_points(leads: Leads, paths: list[Curve], side: int, into: bool) -> np.ndarray:
    """Return the points along each lead from its far end to the path, float64[n, CHORDS + 1, 2]."""
    meet, along = np.empty((len(leads), 2)), np.empty((len(leads), 2))
    order = np.argsort(leads.item, kind="stable")
    bounds = np.flatnonzero(np.diff(leads.item[order], prepend=-1, append=-1))
    for first, last in zip(bounds[:-1].tolist(), bounds[1:].tolist(), strict=True):
        rows = order[first:last]
        meet[rows], along[rows] = paths[int(leads.item[rows[0]])].at_length(leads.place_mm[rows])
    at, ahead = meet @ (1, 1j), along @ (1, 1j)
    scrap = ahead * (1j * side)
    if not into:
        ahead = -ahead
    share = np.linspace(1.0, 0.0, CHORDS + 1)
    return np.where((leads.kind == ARC)[:, None, None], _arcs(leads, at, ahead, scrap, share),
                    _lines(leads, at, ahead, scrap, share))  # fmt: skip


def flatness_mm(leads: Leads) -> np.ndarray:
    """Return how far the chords leave each lead at most, float64[n]."""
    return np.where(leads.kind == ARC, leads.size_mm * (1.0 - np.cos(leads.angle_rad / (2.0 * CHORDS))), 0.0)


def curve_of(lead: Leads, points: np.ndarray, side: int, into: bool) -> Curve:
    """Return a single lead as the curve that is run, exact; points: as lead_points gives them."""
    begin, end = tuple(points[0].tolist()), tuple(points[-1].tolist())
    if lead.kind[0] == LINE:
        curve = straight(begin, end)
    else:
        turn = side if into else -side
        curve = Curve.trusted(np.array([begin, end]), np.array([turn * math.tan(float(lead.angle_rad[0]) / 4.0)]))
    return curve if into else curve.reversed()


def _lines(leads: Leads, at, ahead, scrap, share: np.ndarray) -> np.ndarray:
    away = (-ahead * np.cos(leads.angle_rad) + scrap * np.sin(leads.angle_rad)) * leads.size_mm
    return _xy(at[:, None] + away[:, None] * share)


def _arcs(leads: Leads, at, ahead, scrap, share: np.ndarray) -> np.ndarray:
    turned = leads.angle_rad[:, None] * share
    spoke = -scrap[:, None] * np.cos(turned) - ahead[:, None] * np.sin(turned)
    return _xy((at + scrap * leads.size_mm)[:, None] + leads.size_mm[:, None] * spoke)


def _xy(places: np.ndarray) -> np.ndarray:
    return np.stack([places.real, places.imag], axis=-1)
