# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The independent judge of 2.5D cycles: exact sweeps of a flat tool by level, with shapely, from the table of moves.

What is wanted is drawn by the test as shapely polygons; nothing is asked of the cycle.

    swept area of a path      the nearest place of the path to a swept point is inside a row: then the point lies in the
                              row's strip; or at a corner: then it lies in the sector on the corner's outside; or at
    .--------+ \ sector       an end: then it lies in the disc there. So strips, sectors and discs are all there is,
   (  strip  |--\             and nothing must be buffered as a whole (shapely's buffer of a line that crosses itself
    '--------+ s t r i p      can lack pieces).

    gouge_mm(path, r, wanted)          how far the tool enters what is to stay
    swept(path, r, z)                  what is cut down to a height
    reachable(region, r)               what of a region the tool can reach: opened by its disc, exactly
    left_mm(must_go, cut)              how thick the material is that stays
    left_by_level(path, r, region)     the same for each level alone

All is good to FLAT_MM, the reachable region to EASED_MM, heights to DEEP_MM.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely import STRtree
from shapely.geometry.base import BaseGeometry

from CNCStepper.toolpath import ARC_CCW, ARC_CW, RAPID, XY, Toolpath

FLAT_MM = 1e-4  # how far chords leave their arcs
DEEP_MM = 1e-3  # heights that differ less are one: the writer rounds them
NECK_MM = 1e-3  # a tool may stay out of a throat that is wider than it by less than twice this
SMALL_MM = 2e-4  # what is thinner is rounding
EASED_MM = 4e-4  # by how much outlines are simplified where only the reachable region is asked for


@dataclass(frozen=True)
class Wanted:
    """A region that is to be removed down to `bottom_mm`; regions may lie over each other."""

    region: BaseGeometry
    bottom_mm: float


@dataclass(frozen=True)
class Rows:
    """Moves in the plane as complex columns; sweep: of arcs in rad, 0 on lines. low, high: begin and end height."""

    begin: np.ndarray
    end: np.ndarray
    centre: np.ndarray
    sweep: np.ndarray
    begin_z: np.ndarray
    end_z: np.ndarray

    def __len__(self) -> int:
        return len(self.begin)

    def some(self, which: np.ndarray) -> Rows:
        """Return the rows that an index or a mask names."""
        return Rows(*(getattr(self, name)[which] for name in self.__dataclass_fields__))


def rows_of(path: Toolpath, below_mm: float = math.inf) -> Rows:
    """Return the moves that reach below a height, rapids too; arcs must lie in XY."""
    table = path.table()
    begin, end = path.begins()[:, :3] - path.offsets_mm(), table.end[:, :3] - path.offsets_mm()
    centre = table.centre - path.offsets_mm()
    arc = np.isin(table.kind, (ARC_CCW, ARC_CW))
    assert (table.plane[arc] == XY).all()
    a, b, c = (xyz[:, :2] @ (1, 1j) for xyz in (begin, end, centre))
    with np.errstate(invalid="ignore", divide="ignore"):
        turn = np.where(table.kind == ARC_CCW, 1.0, -1.0) * np.angle((b - c) / (a - c)) % (2.0 * math.pi)
        turn = np.where(turn < 1e-9, 2.0 * math.pi, turn) + 2.0 * math.pi * np.maximum(table.turns - 1.0, 0.0)
    sweep = np.where(arc, np.where(table.kind == ARC_CCW, turn, -turn), 0.0)
    rows = Rows(a, b, c, sweep, begin[:, 2], end[:, 2])
    return rows.some(np.fmin(rows.begin_z, rows.end_z) < below_mm)


def flattened(rows: Rows) -> Rows:
    """Return the rows with chords for arcs, within FLAT_MM."""
    radius = np.abs(rows.begin - rows.centre)
    step = np.sqrt(8.0 * FLAT_MM / np.maximum(radius, FLAT_MM))
    count = np.where(rows.sweep == 0.0, 1, np.ceil(np.abs(rows.sweep) / step)).astype(int)
    of = np.repeat(np.arange(len(rows)), count)
    first = (np.arange(len(of)) - np.repeat(np.cumsum(count) - count, count)) / count[of]
    last = first + 1.0 / count[of]

    def at(share: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        begin, end, centre = rows.begin[of], rows.end[of], rows.centre[of]
        on_line = begin + share * (end - begin)
        on_arc = centre + (begin - centre) * np.exp(1j * share * rows.sweep[of])
        z = rows.begin_z[of] + share * (rows.end_z[of] - rows.begin_z[of])
        return np.where(rows.sweep[of] == 0.0, on_line, on_arc), z

    (begin, begin_z), (end, end_z) = at(first), at(last)
    return Rows(begin, end, np.zeros(len(of), complex), np.zeros(len(of)), begin_z, end_z)


def gouge_mm(path: Toolpath, radius_mm: float, wanted: Sequence[Wanted]) -> float:
    """Return how deep the tool enters what is to stay: sideways at any height below the top, or below all floors."""
    chords = flattened(rows_of(path, -DEEP_MM))
    lowest_mm = min(one.bottom_mm for one in wanted)
    worst_mm = lowest_mm - float(np.minimum(chords.begin_z, chords.end_z).min(initial=lowest_mm))
    for top_mm in {0.0, *(one.bottom_mm for one in wanted)} - {lowest_mm}:
        allowed = shapely.union_all([one.region for one in wanted if one.bottom_mm < top_mm - DEEP_MM])
        worst_mm = max(worst_mm, _sideways_mm(_below(chords, top_mm - DEEP_MM), radius_mm, allowed))
    return worst_mm


def swept(path: Toolpath, radius_mm: float, z_mm: float) -> BaseGeometry:
    """Return what a flat tool clears down to a height; a row that only ends there counts with its end."""
    rows = rows_of(path, z_mm + DEEP_MM)
    return _swept(rows.some(rows.end_z <= z_mm + DEEP_MM), radius_mm, z_mm + DEEP_MM)


def left_by_level(path: Toolpath, radius_mm: float, region: BaseGeometry) -> dict[float, float]:
    """Return by level of the feed moves how thick the material is that stays of what the tool can reach there.

    A level counts with what is cut at that height alone.
    """
    must_go, known = reachable(region, radius_mm), {}
    table = path.table()
    left = {}
    for z_mm in _levels(path):
        rows = rows_of(path)
        rows = rows.some((np.abs(rows.end_z - z_mm) < DEEP_MM) & (table.kind != RAPID))
        key = np.concatenate([rows.begin, rows.end, rows.sweep, rows.begin_z < z_mm + DEEP_MM]).tobytes()
        if key not in known:
            known[key] = left_mm(must_go, _swept(rows, radius_mm, z_mm + DEEP_MM))
        left[z_mm] = known[key]
    return left


def reachable(region: BaseGeometry, radius_mm: float, neck_mm: float = NECK_MM) -> BaseGeometry:
    """Return what of a region a disc can reach that stays inside: opened by one that is larger by `neck_mm`.

    So corners lose a little more than by the disc itself, and throats that are only just wide enough stay closed.
    """
    region = shapely.simplify(region, EASED_MM)
    room = shapely.simplify(region.difference(band(region, radius_mm + neck_mm)), EASED_MM)
    return room.union(band(room, radius_mm + neck_mm)) if room.area else room


def band(region: BaseGeometry, width_mm: float) -> BaseGeometry:
    """Return what lies within a distance of a region's boundary."""
    bands = []
    for ring in shapely.get_parts(shapely.get_rings(shapely.get_parts(region))):
        xy = shapely.get_coordinates(ring) @ (1, 1j)
        xy = np.append(xy, xy[1])  # round the first corner too
        zero = np.zeros(len(xy) - 1)
        bands.append(_swept(Rows(xy[:-1], xy[1:], zero + 0j, zero, zero, zero), width_mm, 0.0))
    return shapely.union_all(bands)


def left_mm(must_go: BaseGeometry, cut: BaseGeometry) -> float:
    """Return how thick the material is that stays: how far it reaches away from the cut; of islands their width."""
    pieces = shapely.get_parts(must_go.difference(cut))
    pieces = pieces[shapely.area(pieces) > SMALL_MM**2]
    if not len(pieces):
        return 0.0
    if cut.is_empty:
        return math.inf
    places, of = shapely.get_coordinates(pieces, return_index=True)
    far_mm = np.zeros(len(pieces))
    np.maximum.at(far_mm, of, _from_wall(_edges(cut), places))
    islands = pieces[far_mm < SMALL_MM]
    discs = shapely.length(shapely.maximum_inscribed_circle(islands, tolerance=SMALL_MM))
    return max(float(far_mm.max()), float(2.0 * discs.max(initial=0.0)))


def _levels(path: Toolpath) -> list[float]:
    """Return the heights below the top at which feed moves run level, from the top downwards."""
    table, begins = path.table(), path.begins()
    z = table.end[:, 2] - path.offsets_mm()[:, 2]
    run = np.abs(table.end[:, :2] - begins[:, :2]).max(axis=1) > 0
    level = (table.kind != RAPID) & run & (np.abs(begins[:, 2] - table.end[:, 2]) < 1e-9) & (z < -DEEP_MM)
    return sorted(set(np.round(z[level], 6).tolist()), reverse=True)


def _below(chords: Rows, top_mm: float) -> np.ndarray:
    """Return what of the chords lies below a height, float64[n, 2, 2], each once."""
    z0, z1 = chords.begin_z, chords.end_z
    with np.errstate(invalid="ignore", divide="ignore"):
        share = np.clip((top_mm - z0) / (z1 - z0), 0.0, 1.0)
    way = chords.end - chords.begin
    begin = np.where(z0 > top_mm, chords.begin + np.nan_to_num(share) * way, chords.begin)
    end = np.where(z1 > top_mm, chords.begin + np.nan_to_num(share) * way, chords.end)
    lines = np.column_stack([begin.real, begin.imag, end.real, end.imag])[np.minimum(z0, z1) < top_mm]
    return np.unique(np.round(lines, 9), axis=0).reshape(-1, 2, 2)


def _sideways_mm(lines: np.ndarray, radius_mm: float, allowed: BaseGeometry) -> float:
    """Return how far a disc that runs along the chords gets out of what is allowed, 0 when it stays inside."""
    if not len(lines):
        return 0.0
    if allowed.is_empty:
        return math.inf
    tree = _edges(allowed)
    shapely.prepare(allowed)
    begin_mm, inside = _from_wall(tree, lines[:, 0]), shapely.covers(allowed, shapely.points(lines[:, 0]))
    long_mm = np.hypot(*(lines[:, 1] - lines[:, 0]).T)
    near = ~inside | (begin_mm - long_mm < radius_mm)
    lines, begin_mm, inside = lines[near], begin_mm[near], inside[near]
    ends_inside = shapely.covers(allowed, shapely.points(lines[:, 1]))
    line_mm = tree.query_nearest(shapely.linestrings(lines), return_distance=True, all_matches=False)[1]
    outside_mm = np.maximum(np.where(inside, 0.0, begin_mm), np.where(ends_inside, 0.0, _from_wall(tree, lines[:, 1])))
    depth_mm = radius_mm + np.where(inside & ends_inside & (line_mm > 0), -line_mm, outside_mm)
    return float(depth_mm.max(initial=0.0))


def _from_wall(tree: STRtree, places: np.ndarray) -> np.ndarray:
    """Return how far each point, float64[n, 2], is from the nearest edge."""
    return tree.query_nearest(shapely.points(places), return_distance=True, all_matches=False)[1]


def _edges(region: BaseGeometry) -> STRtree:
    xy, of = shapely.get_coordinates(shapely.get_parts(shapely.get_rings(shapely.get_parts(region))), return_index=True)
    edges = np.stack([xy[:-1], xy[1:]], axis=1)[of[:-1] == of[1:]]
    return STRtree(shapely.linestrings(edges))


def _swept(rows: Rows, radius_mm: float, z_mm: float) -> BaseGeometry:
    """Return the union of strips, sectors and discs; a row that begins above `z_mm` is the disc at its end."""
    down = rows.begin_z > z_mm
    ends = [rows.end[down]]
    rows = rows.some(~down & ((np.abs(rows.end - rows.begin) > 1e-9) | (rows.sweep != 0.0)))
    if len(rows):
        goes_on = np.abs(rows.begin[1:] - rows.end[:-1]) < 1e-6
        ends += [rows.begin[np.append(True, ~goes_on)], rows.end[np.append(~goes_on, True)]]
    shapes = [_discs(np.concatenate(ends), radius_mm)]
    if len(rows):
        straight = rows.sweep == 0.0
        shapes += [_strips(rows.some(straight), radius_mm), _rings(rows.some(~straight), radius_mm)]
        shapes += [_sectors(rows, np.flatnonzero(goes_on), radius_mm)]
    return shapely.union_all(np.concatenate(shapes))


def _discs(places: np.ndarray, radius_mm: float) -> np.ndarray:
    quarter = math.ceil(math.pi / 2 / math.sqrt(8.0 * FLAT_MM / radius_mm))
    places = np.unique(np.round(places, 9))
    return shapely.buffer(shapely.points(_xy(places)), radius_mm, quad_segs=quarter)


def _strips(rows: Rows, radius_mm: float) -> np.ndarray:
    along = (rows.end - rows.begin) / np.abs(rows.end - rows.begin)
    left, more = 1j * radius_mm * along, _overlap_mm(radius_mm) * along
    begin, end = rows.begin - more, rows.end + more
    return shapely.polygons(_xy(np.stack([begin + left, begin - left, end - left, end + left], axis=1)))


def _overlap_mm(radius_mm: float) -> float:
    """Return by how much neighbours overlap: unions of shapes that only touch come out wrong.

    A strip that is so much longer leaves what a disc covers by FLAT_MM / 4.
    """
    return math.sqrt(radius_mm * FLAT_MM / 2.0)


def _rings(rows: Rows, radius_mm: float) -> np.ndarray:
    """Return the strips of arcs: rings, or parts of rings or discs."""
    return np.array([_ring(*row, radius_mm) for row in zip(rows.centre, rows.begin, rows.sweep, strict=True)], object)


def _ring(centre: complex, begin: complex, sweep: float, radius_mm: float) -> BaseGeometry:
    arm, size_mm = begin - centre, abs(begin - centre)
    wide_mm, narrow_mm = size_mm + radius_mm, size_mm - radius_mm
    if abs(sweep) > 2.0 * math.pi - 1e-6:
        outer, inner = (_xy(centre + far_mm * _turn(sweep, far_mm)) for far_mm in (wide_mm, narrow_mm))
        return shapely.polygons(outer, holes=[inner] if narrow_mm > FLAT_MM else None)
    more = math.copysign(_overlap_mm(radius_mm) / wide_mm, sweep)
    arm, sweep = arm / size_mm * np.exp(-1j * more), sweep + 2.0 * more
    inner = narrow_mm * _turn(sweep, narrow_mm)[::-1] if narrow_mm > FLAT_MM else np.zeros(1)
    return shapely.polygons(_xy(centre + arm * np.concatenate([wide_mm * _turn(sweep, wide_mm), inner])))


def _sectors(rows: Rows, corners: np.ndarray, radius_mm: float) -> np.ndarray:
    """Return what the disc covers on the outside of corners between rows that follow each other."""
    heading = np.where(rows.sweep == 0.0, rows.end - rows.begin, 1j * np.sign(rows.sweep) * (rows.begin - rows.centre))
    before = (heading * np.exp(1j * rows.sweep))[corners]
    turns = np.angle(heading[corners + 1] / before)
    out = -1j * np.sign(turns) * before / np.abs(before)
    more = _overlap_mm(radius_mm) / radius_mm
    found = []
    for place, arm, turn in zip(rows.end[corners], out, turns, strict=True):
        if abs(turn) > more:
            wide = math.copysign(more, turn)
            fan = radius_mm * arm * np.exp(-1j * wide) * _turn(turn + 2.0 * wide, radius_mm)
            found.append(shapely.polygons(_xy(place + np.append(fan, 0.0))))
    return np.array(found, object)


def _turn(sweep: float, radius_mm: float) -> np.ndarray:
    """Return unit vectors from 1 on round a sweep, dense enough for that radius."""
    count = math.ceil(abs(sweep) / math.sqrt(8.0 * FLAT_MM / max(abs(radius_mm), FLAT_MM))) + 1
    return np.exp(1j * np.linspace(0.0, sweep, count + 1))


def _xy(places: np.ndarray) -> np.ndarray:
    return np.stack([places.real, places.imag], axis=-1)
