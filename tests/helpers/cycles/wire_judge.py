# SPDX-License-Identifier: LGPL-2.1-or-later
"""The independent judge of wire cutting: exact geometry of the table's rows and of what was drawn, with shapely.

Nothing is asked of the cycle but the order in which it says that parts come free, and which rows are slits.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import shapely
from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.cycle import Answer
from CNCStepper.toolpath import ARC_CCW, LINE, RAPID, Toolpath
from helpers.cycles.random_outlines import enclosed
from helpers.cycles.random_wire_sheets import Sheet
from helpers.cycles.sweep_judge import reachable

ERROR_MM = 0.0015  # of the judge: chords, and shapely's round buffers
ROUND = 64  # chords of a quarter turn
MEETS_MM = 1e-4  # ends of rows that meet are rounded


@dataclass(frozen=True)
class WirePath:
    """The feeds as lines, a row each; slit: whether a row is cut through a part on purpose."""

    lines: list[BaseGeometry]
    slit: np.ndarray
    rows: np.ndarray

    @property
    def points(self) -> np.ndarray:
        """All vertices in order, float64[n, 2]."""
        return np.concatenate([shapely.get_coordinates(line) for line in self.lines])


def path_of(path: Toolpath) -> WirePath:
    """Return the feeds of a table."""
    table = path.table()
    feeds = np.flatnonzero(table.kind != RAPID)
    lines = [_line(path, int(row)) for row in feeds]
    slits = [(span.first, span.last) for span in path.spans if span.kind == "slit"]
    is_slit = np.array([any(first <= row < last for first, last in slits) for row in feeds], bool)
    return WirePath(lines, is_slit, feeds)


def in_one_way(path: Toolpath, sheet: Polygon, half_mm: float) -> None:
    """Assert that the wire is hot in one continuous way from outside the sheet to outside it, and cold elsewhere."""
    table, wire = path.table(), path_of(path)
    assert (table.end[:, 2] == 0.0).all()
    assert (np.diff(wire.rows) == 1).all(), "a rapid between feeds"
    hot = np.array([path.states[state].spindle == "cw" for state in table.state])
    assert (hot == (table.kind != RAPID)).all()
    for end in (wire.points[0], wire.points[-1]):
        assert sheet.distance(shapely.points(end)) >= half_mm
    begins = path.begins()
    for row in np.flatnonzero(table.kind == RAPID).tolist():
        if np.isfinite(begins[row, :2]).all():
            assert not LineString([begins[row, :2], table.end[row, :2]]).crosses(sheet)


def keeps_off(wire: WirePath, sheet: Sheet, tolerance_mm: float) -> None:
    """Assert that the wire comes nowhere nearer to a part than half a kerf, but for slits."""
    material = enclosed(tuple(curve for curve in sheet.curves if curve.closed))
    away_mm = shapely.distance(np.array(wire.lines)[~wire.slit], material)
    assert away_mm.min() >= sheet.kerf_mm / 2.0 - tolerance_mm - ERROR_MM, f"{away_mm.min():.4f} mm from a part"


def crosses_nowhere(wire: WirePath) -> None:
    """Assert that the wire crosses no way that it cut before; it may touch one, or go back along it."""
    lines = np.array(wire.lines)
    first, second = shapely.STRtree(lines).query(lines, predicate="crosses")
    for a, b in zip(first.tolist(), second.tolist(), strict=True):
        if shapely.hausdorff_distance(lines[a], lines[b]) <= MEETS_MM:
            continue  # an arc, and the same one back
        met = shapely.get_coordinates(lines[a].intersection(lines[b]))
        ends = shapely.multipoints(np.concatenate([shapely.get_coordinates(lines[each])[[0, -1]] for each in (a, b)]))
        assert shapely.distance(shapely.points(met), ends).max() <= MEETS_MM, f"rows cross at {met}"


def cut_whole(wire: WirePath, sheet: Sheet, answer: Answer, outline: Polygon, tolerance_mm: float) -> None:
    """Assert that each part falls whole and within tolerance, in the order told, and nothing after it came loose."""
    half_mm = sheet.kerf_mm / 2.0
    parts = answer.parts
    wanted = shapely.get_parts(enclosed(tuple(curve for curve in sheet.curves if curve.closed)))
    assert len(parts) == len(wanted)
    bands = [line.buffer(half_mm, quad_segs=ROUND) for line in wire.lines]
    _falls_in_order(wire, bands, parts, outline)
    rest = shapely.get_parts(outline.difference(shapely.union_all(bands)))
    slits = shapely.union_all(np.array(bands)[wire.slit]) if wire.slit.any() else shapely.Polygon()
    for part in wanted:
        held = part.difference(slits)
        piece = max(rest, key=lambda each: each.intersection(held).area)
        missing = held.difference(piece.buffer(tolerance_mm + ERROR_MM))
        assert missing.area <= 1e-6, f"{missing.area:.4f} mm² of a part are cut away"
        closed = _closed(part, half_mm)  # inner corners stay round
        more = piece.difference(closed.buffer(tolerance_mm + ERROR_MM, quad_segs=ROUND))
        assert more.area <= 1e-6, f"{more.area:.4f} mm² stay at a part"


def holes_while_it_hangs(wire: WirePath, answer: Answer, outline: Polygon) -> int:
    """Assert that the wire goes into and out of each hole while the part hangs in the largest piece; return how often.

    What hangs by less than a tenth of the kerf's width does not count as held by that.
    """
    bands = [line.buffer(answer.figures["kerf_mm"] * 0.55, quad_segs=ROUND) for line in wire.lines]
    slits = np.flatnonzero(wire.slit).tolist()
    for row in slits:
        middle = wire.lines[row].interpolate(0.5, normalized=True)
        part = min(answer.parts, key=middle.distance)
        rest = outline.difference(shapely.union_all(bands[:row]))
        largest = max(shapely.get_parts(rest), key=shapely.area)
        assert largest.intersects(part.buffer(-0.1 * answer.figures["kerf_mm"])), f"a part is loose before row {row}"
    return len(slits)


def sweeps(wire: WirePath, sheet: Sheet, answer: Answer, outline: Polygon) -> None:
    """Assert that the removal is what the wire sweeps."""
    swept = shapely.union_all([line.buffer(sheet.kerf_mm / 2.0, quad_segs=ROUND) for line in wire.lines])
    region = answer.removals[0].region
    off = swept.intersection(outline).symmetric_difference(region)
    assert off.buffer(-ERROR_MM).is_empty


def _falls_in_order(wire: WirePath, bands: list[BaseGeometry], parts: list[BaseGeometry], outline: Polygon) -> None:
    """Assert that the parts come free in their order, each while those after it hang in the largest piece."""
    middles = [part.representative_point() for part in parts]
    for number, middle in enumerate(middles[:-1]):
        last = max(_nearest_rows(wire, parts[number]))
        rest = shapely.get_parts(outline.difference(shapely.union_all(bands[: last + 1])))
        largest = max(rest, key=shapely.area)
        loose = [each for each in middles[number + 1 :] if not largest.intersects(each)]
        free = not largest.intersects(middle) or len(rest) == 1
        assert free, f"part {number} is not cut free in its turn"
        assert not loose, f"{len(loose)} parts are loose before they are cut, after part {number}"


def _nearest_rows(wire: WirePath, part: BaseGeometry) -> list[int]:
    """Return the rows of the wire's last stretch round a part: those that are as near to it as any."""
    outer = Polygon(max(shapely.get_parts(part), key=shapely.area).exterior)
    away_mm = shapely.distance(np.array(wire.lines), outer)
    whole = np.array([line.length for line in wire.lines]) > 0.0
    return np.flatnonzero(whole & ~wire.slit & (away_mm <= away_mm[~wire.slit].min() + 0.005)).tolist()


def _closed(part: BaseGeometry, half_mm: float) -> BaseGeometry:
    """Return a part with its inner corners as round as the wire: all that a disc outside of it cannot reach."""
    low_x, low_y, high_x, high_y = part.bounds
    frame = shapely.box(low_x - 9.0, low_y - 9.0, high_x + 9.0, high_y + 9.0)
    return frame.difference(reachable(frame.difference(part), half_mm))


def _line(path: Toolpath, row: int) -> BaseGeometry:
    begins, table = path.begins(), path.table()
    if table.kind[row] == LINE:
        return LineString([begins[row, :2], table.end[row, :2]])
    return _arc(begins[row, :2], table.end[row, :2], table.centre[row, :2], int(table.kind[row]))


def _arc(begin: np.ndarray, end: np.ndarray, centre: np.ndarray, kind: int) -> BaseGeometry:
    """Return an arc as chords that leave it by less than a thousandth of the judge's error."""
    one, other = begin - centre, end - centre
    turn = np.arctan2(one[0] * other[1] - one[1] * other[0], one @ other)
    sense = 1.0 if kind == ARC_CCW else -1.0
    if turn * sense <= 0.0:
        turn += sense * 2.0 * np.pi
    radius = float(np.hypot(*one))
    count = max(int(np.ceil(abs(turn) / (2.0 * np.arccos(max(1.0 - 1e-4 / radius, -1.0))))), 2)
    angles = np.arctan2(one[1], one[0]) + turn * np.linspace(0.0, 1.0, count + 1)
    points = centre + radius * np.column_stack([np.cos(angles), np.sin(angles)])
    points[0], points[-1] = begin, end
    return LineString(points)
