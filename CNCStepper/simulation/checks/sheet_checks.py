# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a beam or wire does to a sheet and its parts, seen once the whole program is known.

    pierce      its spot, as wide as the kerf, lies on no part and not on an edge that is cut already
    kerf        no lead and no cut goes beyond the drawing into a part
    free piece  nothing is cut into it any more: it has fallen or moved; the head goes over it only when lifted

A piece that tips stands up about the edge of a slat, at most by half of its smaller extent. One that is wider than two
spaces between slats lies on three of them and stays. A program whose head is never lifted is not refused for it.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from CNCStepper.errors import Text
from CNCStepper.simulation.check_context import CheckContext
from CNCStepper.simulation.exact.free_pieces import Freed, FreePiece
from CNCStepper.simulation.exact.sheet_cuts import SheetCuts
from CNCStepper.simulation.finding import Finding, Severity
from CNCStepper.tolerances import SAME_PASS_MM

PART_TOLERANCE_MM = 0.025  # the removals' 0.01, and what flattening the path and the parts adds
SLAT_SPACE_MM = 75.0  # from slat to slat under the sheet
LIFT_MM = 0.5  # over the cut height, before the head counts as lifted
NEAR_MM = 0.01
TOP_MM = 0.0  # of the sheet: the height of every place on it


def sheet_findings(subject: CheckContext, sheet: SheetCuts, freed: Freed | None) -> Iterator[Finding]:
    """Yield all findings about the cuts of a program; subject: the last part of it. freed: None for too long a path."""
    if freed is None:
        text = "the program is too long for it to be known which pieces fall"
        yield subject.finding(-1, "warning", "pieces-unknown", text, advice="split the program")
        return
    if sheet.cutting.process.entry == "pierce":
        yield from _pierces_on_parts(subject, sheet)
        yield from _pierces_on_edges(subject, sheet)
    yield from _cuts_in_parts(subject, sheet)
    yield from _thin_parts(subject, sheet)
    yield from _cuts_in_free_pieces(subject, sheet, freed)
    if sheet.cutting.process.tips_parts:
        yield from _travel_over_pieces(subject, sheet, freed)


def _pierces(sheet: SheetCuts) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return the first segment of each cut that begins in the sheet, its place as a point and the spot's radius."""
    cuts = sheet.cuts
    first = cuts.first_of_cuts
    points = shapely.points(cuts.ends_mm[first, :2])
    radius = cuts.radius_mm[first]
    inside = shapely.distance(points, sheet.sheet) < radius
    return first[inside], points[inside], radius[inside]


def _pierces_on_parts(subject: CheckContext, sheet: SheetCuts) -> Iterator[Finding]:
    """Yield pierces whose spot reaches a part, and those that are nearer to one than the chart's lead-in is long."""
    parts, data = np.array(list(sheet.cutting.parts), object), sheet.cutting.cut_data
    first, points, radius = _pierces(sheet)
    if not len(parts) or not len(first):
        return
    wanted_mm = data.lead_in_mm if data else 0.0
    tree = shapely.STRtree(points)
    part, pierce = tree.query(parts, predicate="dwithin", distance=max(float(radius.max()), wanted_mm))
    beside = _nearest(pierce, shapely.distance(points[pierce], parts[part]), len(points))
    for number in np.unique(pierce).tolist():
        aside_mm = float(beside[number])
        segment, spot_mm = int(first[number]), float(radius[number])
        if aside_mm < spot_mm - PART_TOLERANCE_MM:
            text, advice = "the pierce lies on a part", "pierce in scrap, and lead in to the contour"
            yield _at(subject, sheet, segment, "error", "pierce-on-part", text, advice, (aside_mm, spot_mm))
        elif aside_mm < wanted_mm - NEAR_MM:
            text = "the pierce is nearer to a part than the chart's lead-in is long: its spatter reaches the part"
            advice = "make the lead-in longer"
            yield _at(subject, sheet, segment, "warning", "pierce-near-part", text, advice, (aside_mm, wanted_mm))


def _pierces_on_edges(subject: CheckContext, sheet: SheetCuts) -> Iterator[Finding]:
    """Yield pierces whose spot reaches the kerf of an earlier cut."""
    path, (first, points, radius) = sheet.moving, _pierces(sheet)
    if not len(path) or not len(first):
        return
    number, other = path.tree.query(points, predicate="dwithin", distance=radius + float(path.radius_mm.max()))
    earlier = path.cut[other] < sheet.cuts.cut[first[number]]
    number, other = number[earlier], other[earlier]
    if sheet.cutting.process.passes:
        number, other = _without_passes(sheet, points, number, other)
    gap = shapely.distance(points[number], path.lines[other]) - path.radius_mm[other]
    nearest = _nearest(number, gap, len(points))
    for one in np.unique(number).tolist():
        gap_mm, spot_mm = float(nearest[one]), float(radius[one])
        if gap_mm < spot_mm - NEAR_MM:
            text, advice = "the pierce lies on an edge that is cut already", "pierce farther away from earlier cuts"
            numbers = max(gap_mm, 0.0), spot_mm
            yield _at(subject, sheet, int(first[one]), "error", "pierce-on-edge", text, advice, numbers)


def _nearest(number: np.ndarray, distance: np.ndarray, count: int) -> np.ndarray:
    """Return the smallest distance of each of `count` numbers, infinite for one that does not occur."""
    nearest = np.full(count, np.inf)
    np.minimum.at(nearest, number, distance)
    return nearest


def _without_passes(
    sheet: SheetCuts, points: np.ndarray, number: np.ndarray, other: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Leave out earlier cuts that begin at the same place: the pierce begins another pass of theirs."""
    path, begins = sheet.moving, shapely.points(sheet.moving.ends_mm[sheet.moving.first_of_cuts, :2])
    cut = np.searchsorted(path.cut[path.first_of_cuts], path.cut[other])
    apart = shapely.distance(points[number], begins[cut]) > SAME_PASS_MM
    return number[apart], other[apart]


def _cuts_in_parts(subject: CheckContext, sheet: SheetCuts) -> Iterator[Finding]:
    """Yield each cut whose kerf goes into a part, where it goes deepest."""
    path, parts = sheet.moving, np.array(list(sheet.cutting.parts), object)
    if not len(path) or not len(parts):
        return
    most_mm = float(path.radius_mm.max()) - PART_TOLERANCE_MM
    part, segment = path.tree.query(parts, predicate="dwithin", distance=most_mm)
    depth = path.radius_mm[segment] - shapely.distance(path.lines[segment], parts[part])
    wrong = depth > PART_TOLERANCE_MM
    part, segment, depth = part[wrong], segment[wrong], depth[wrong]
    for cut in np.unique(path.cut[segment]).tolist():
        of_cut = np.flatnonzero(path.cut[segment] == cut)
        worst = int(of_cut[depth[of_cut].argmax()])
        at, depth_mm = int(segment[worst]), float(depth[worst])
        place = shapely.get_coordinates(shapely.shortest_line(path.lines[at], parts[part[worst]]))[1]
        text, advice = _words_of_cut(sheet, depth_mm >= path.radius_mm[at])
        yield subject.finding_at(
            int(path.line[at]),
            "error",
            "cut-in-part",
            text,
            advice=advice,
            place_mm=(*place.tolist(), TOP_MM),
            value=depth_mm,
            limit=PART_TOLERANCE_MM,
            unit="mm",
            count=len(np.unique(path.row[segment[of_cut]])),
        )


def _words_of_cut(sheet: SheetCuts, goes_through: bool) -> tuple[str, str]:
    if not goes_through:
        return "the kerf goes beyond the drawing into a part", "keep half a kerf beside the part"
    if sheet.cutting.process.power == "always":
        return "the wire goes through a part", "route it around the part, through scrap"
    return "a lead or a cut goes through a part", "lead in and out through scrap"


def _thin_parts(subject: CheckContext, sheet: SheetCuts) -> Iterator[Finding]:
    """Yield parts of which less than a kerf is left somewhere between two cuts."""
    if not len(sheet.moving):
        return
    parts, kerf_mm = np.array(list(sheet.cutting.parts), object), 2 * float(sheet.moving.radius_mm.max())
    tree = sheet.moving.tree
    for part in parts[~_stays_whole(parts, kerf_mm / 2 - NEAR_MM)]:
        segment = int(tree.nearest(part))
        text, advice = "less than a kerf is left of a part between two cuts", "use a smaller kerf, or widen the web"
        place = (*shapely.get_coordinates(part.representative_point())[0].tolist(), TOP_MM)
        line = int(sheet.moving.line[segment])
        numbers = {"value": 2 * _narrowest_mm(part, kerf_mm / 2), "limit": kerf_mm, "unit": "mm"}
        yield subject.finding_at(line, "warning", "thin-part", text, advice=advice, place_mm=place, **numbers)


def _stays_whole(parts: np.ndarray, by_mm: float) -> np.ndarray:
    """Return which polygons stay one piece, with as many holes, when they shrink by a distance, bool[n]."""
    shrunk = shapely.buffer(parts, -by_mm)
    same_holes = shapely.get_num_interior_rings(shrunk) == shapely.get_num_interior_rings(parts)
    return ~shapely.is_empty(shrunk) & (shapely.get_num_geometries(shrunk) == 1) & same_holes


def _narrowest_mm(part: shapely.Geometry, most_mm: float) -> float:
    """Return the largest distance by which a part can shrink and stay whole, at most that."""
    low, high = 0.0, most_mm
    while high - low > NEAR_MM:
        middle = (low + high) / 2
        low, high = (middle, high) if _stays_whole(np.array([part]), middle)[0] else (low, middle)
    return low


def _cuts_in_free_pieces(subject: CheckContext, sheet: SheetCuts, freed: Freed) -> Iterator[Finding]:
    """Yield each cut into a piece that an earlier one has set free."""
    for piece in freed.free:
        for later in piece.later:
            certain = not piece.at_edge or _holds_part(sheet, piece)
            text = Text("the piece that is cut came free at line {line}: it has fallen or moved", line=piece.line)
            advice = "cut holes before the outline round them, or hold the piece by tabs"
            yield subject.finding_at(
                later.line,
                "error" if certain else "warning",
                "piece-free",
                text,
                advice=advice,
                place_mm=(*later.place_mm, TOP_MM),
            )


def _holds_part(sheet: SheetCuts, piece: FreePiece) -> bool:
    """Return whether most of a part lies in the piece: a strip that is cut off the sheet stays where it is."""
    parts = np.array(list(sheet.cutting.parts), object)
    inside = shapely.area(shapely.intersection(parts, piece.shape)) if len(parts) else np.zeros(0)
    return bool((inside > shapely.area(parts) / 2).any())


def _travel_over_pieces(subject: CheckContext, sheet: SheetCuts, freed: Freed) -> Iterator[Finding]:
    """Yield travel that is lower than pieces under it, which are free, can stand up: one finding of each severity."""
    tipping = [piece for piece in freed.free if piece.smaller_extent_mm < 2 * SLAT_SPACE_MM]
    travel, working_mm = sheet.travel, _working_mm(sheet)
    if not tipping or not len(travel):
        return
    tree = shapely.STRtree([piece.shape for piece in tipping])
    way, number = tree.query(travel.lines, predicate="intersects")
    stands_mm = np.array([piece.smaller_extent_mm / 2 for piece in tipping])[number]
    low_mm = np.where(np.isfinite(travel.low_mm), travel.low_mm, 0.0)[way]
    under = (travel.row[way] > np.array([piece.row for piece in tipping])[number]) & (low_mm < stands_mm)
    is_lifted = low_mm > working_mm
    can_lift = bool((travel.low_mm > working_mm).any())
    kinds: tuple[tuple[Severity, np.ndarray], ...] = (
        ("error", under & ~is_lifted & can_lift),
        ("warning", under & is_lifted),
        ("info", under & ~is_lifted & (not can_lift)),
    )
    for severity, which in kinds:
        if which.any():
            yield _over(subject, sheet, severity, way[which], (stands_mm - low_mm)[which], low_mm[which])


def _working_mm(sheet: SheetCuts) -> float:
    """Return the height up to which the head does not count as lifted; infinite where no cut has a known height."""
    known = sheet.cuts.low_mm[np.isfinite(sheet.cuts.low_mm)]
    return float(known.max()) + LIFT_MM if len(known) else np.inf


def _over(
    subject: CheckContext, sheet: SheetCuts, severity: Severity, way: np.ndarray, over: np.ndarray, low: np.ndarray
) -> Finding:
    worst = int(over.argmax())
    at = int(way[worst])
    return subject.finding_at(
        int(sheet.travel.line[at]),
        severity,
        "head-over-piece",
        "the head goes over a piece that is free and may stand up",
        advice="lift the head higher, or go round the piece",
        place_mm=(*sheet.travel.ends_mm[at, 2:].tolist(), float(low[worst])),
        value=float(low[worst]),
        limit=float(low[worst] + over[worst]),
        unit="mm",
        count=len(np.unique(sheet.travel.row[way])),
    )


def _at(
    subject: CheckContext,
    sheet: SheetCuts,
    segment: int,
    severity: Severity,
    code: str,
    text: str,
    advice: str,
    value_and_limit: tuple[float, float],
) -> Finding:
    """Return a finding at the begin of a cutting segment, with its value and limit in mm."""
    cuts = sheet.cuts
    place = (*cuts.ends_mm[segment, :2].tolist(), TOP_MM)
    numbers = {"value": value_and_limit[0], "limit": value_and_limit[1], "unit": "mm"}
    return subject.finding_at(int(cuts.line[segment]), severity, code, text, advice=advice, place_mm=place, **numbers)
