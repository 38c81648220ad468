# SPDX-License-Identifier: LGPL-2.1-or-later
"""The independent judge of cut sheets: from the table of moves alone, with shapely; nothing is asked of the cycle.

    strokes(path)                  what is run with power, one stroke from power on to power off, and its rapids
    parts_of(curves)               what is drawn, by the even-odd rule
    faults(path, ...)              all that is wrong, in words: power over parts, pierces, pieces, what moved before

Chords leave arcs by FLAT_MM at most, so every distance is good to 2 FLAT_MM.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.geometry.curve import Curve
from CNCStepper.toolpath import ARC_CCW, ARC_CW, RAPID, Toolpath

FLAT_MM = 2e-4
TOLERANCE_MM = 0.01
QUARTER = 48  # chords in a quarter turn of the kerf's edge
CRUMB = 0.05  # of a kerf's square: smaller pieces are crumbs between two cuts


@dataclass(frozen=True)
class Powered:
    """What is run from power on to power off, as a line of chords; dwell_s: how long it stands at its begin."""

    line: shapely.LineString
    dwell_s: float

    @property
    def pierce(self) -> shapely.Point:
        return shapely.Point(self.line.coords[0])


def strokes(path: Toolpath) -> list[Powered]:
    """Return the strokes in their order; raises AssertionError for a rapid with power."""
    table, begins = path.table(), path.begins()
    on = np.array([state.spindle_turns for state in path.states], bool)[table.state]
    assert not (on & (table.kind == RAPID)).any(), "a rapid with power"
    dwells = {event.index: event.value for event in path.events if event.kind == "dwell"}
    found, points, first = [], [], 0
    for row in np.flatnonzero(on).tolist():
        if not points or not on[row - 1]:
            points, first = [begins[row, :2]], row
        points += _chords(begins[row, :2], table, row)
        if row + 1 == len(table) or not on[row + 1]:
            found.append(Powered(shapely.LineString(points), dwells.get(first, 0.0)))
    return found


def parts_of(curves: Sequence[Curve]) -> list[shapely.Polygon]:
    """Return the drawn parts: what an odd number of outlines encloses, in its pieces."""
    drawn: BaseGeometry = shapely.Polygon()
    for curve in curves:
        drawn = drawn.symmetric_difference(shapely.Polygon(curve.points(FLAT_MM)))
    return [part for part in shapely.get_parts(drawn) if part.area > 0.01]


def faults(
    path: Toolpath, curves: Sequence[Curve], sheet: Curve, kerf_mm: float, pierce_mm: float, delay_s: float
) -> list[str]:
    """Return all that is wrong with the cuts of a sheet, in words."""
    cuts, parts = strokes(path), parts_of(curves)
    told = [fault for number, cut in enumerate(cuts) for fault in _of_cut(number, cut, parts, kerf_mm, pierce_mm)]
    told += [f"cut {number}: no pierce delay" for number, cut in enumerate(cuts) if cut.dwell_s != delay_s]
    told += _cut_edges(cuts, kerf_mm, pierce_mm)
    material = shapely.Polygon(sheet.points(FLAT_MM))
    bands = [cut.line.buffer(kerf_mm / 2.0, quad_segs=QUARTER) for cut in cuts]
    told += _moved(cuts, bands, material, kerf_mm)
    return told + _pieces(shapely.get_parts(material.difference(shapely.union_all(bands))), parts, kerf_mm)


def _of_cut(number: int, cut: Powered, parts: Sequence[shapely.Polygon], kerf_mm: float, pierce_mm: float) -> list[str]:
    """Return which parts a stroke's band touches, and which its pierce."""
    told = []
    near = float(shapely.distance(parts, cut.line).min())
    if near < kerf_mm / 2.0 - TOLERANCE_MM:
        told.append(f"cut {number} comes within {near:.4f} mm of a part")
    near = float(shapely.distance(parts, cut.pierce).min())
    if near < pierce_mm - TOLERANCE_MM / 2.0:
        told.append(f"pierce {number} lies {near:.4f} mm from a part")
    return told


def _cut_edges(cuts: Sequence[Powered], kerf_mm: float, pierce_mm: float) -> list[str]:
    """Return the pierces that lie nearer to the edge of an earlier cut than they may."""
    told = []
    for number, cut in enumerate(cuts[1:], start=1):
        near = min(earlier.line.distance(cut.pierce) for earlier in cuts[:number]) - kerf_mm / 2.0
        if near < pierce_mm - TOLERANCE_MM:
            told.append(f"pierce {number} lies {near:.4f} mm from a cut edge")
    return told


def _moved(cuts: Sequence[Powered], bands: Sequence[BaseGeometry], material: BaseGeometry, kerf_mm: float) -> list[str]:
    """Return the cuts into what was free before: neither in the sheet nor in a cut that was made."""
    told, left = [], material
    rim = material.exterior
    for number, (cut, band) in enumerate(zip(cuts, bands, strict=True)):
        loose = [piece for piece in shapely.get_parts(left) if piece.distance(rim) > 0.0]
        for piece in loose:
            if piece.area > CRUMB * kerf_mm**2 and cut.line.intersection(piece).length > TOLERANCE_MM:
                told.append(f"cut {number} goes into what is free already")
        left = left.difference(band)
    return told


def _pieces(pieces: np.ndarray, parts: Sequence[shapely.Polygon], kerf_mm: float) -> list[str]:
    """Return which parts did not come out whole, or not within the tolerance where the kerf can go."""
    told = []
    tree = shapely.STRtree(pieces)
    for number, part in enumerate(parts):
        own = tree.query(part.representative_point(), predicate="intersects")
        if len(own) != 1:
            told.append(f"part {number} is cut into at {part.representative_point()}")
            continue
        piece = pieces[own[0]]
        closed = part.buffer(kerf_mm / 2.0, quad_segs=QUARTER).buffer(-kerf_mm / 2.0, quad_segs=QUARTER)
        if not piece.buffer(TOLERANCE_MM).covers(part):
            told.append(f"part {number} is too small")
        if not closed.union(part).buffer(TOLERANCE_MM + 1e-3).covers(piece):
            told.append(f"part {number} is too large, or hangs on the sheet")
    return told


def _chords(begin: np.ndarray, table, row: int) -> list[np.ndarray]:
    """Return the points along a row after its begin."""
    end = table.end[row, :2]
    if table.kind[row] not in (ARC_CW, ARC_CCW):
        return [end]
    centre = table.centre[row, :2]
    radius = float(np.hypot(*(begin - centre)))
    first, last = (float(np.arctan2(*(point - centre)[::-1])) for point in (begin, end))
    sweep = (last - first) % (2.0 * np.pi)
    if table.kind[row] == ARC_CW:
        sweep -= 2.0 * np.pi
    if abs(sweep) < 1e-9 or abs(abs(sweep) - 2.0 * np.pi) < 1e-9:
        sweep = 2.0 * np.pi if table.kind[row] == ARC_CCW else -2.0 * np.pi
    count = max(int(np.ceil(abs(sweep) / (2.0 * np.arccos(max(1.0 - FLAT_MM / radius, -1.0))))), 2)
    angles = first + sweep * np.arange(1, count + 1) / count
    points = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    return [*points[:-1], end]
