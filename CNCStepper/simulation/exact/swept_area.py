# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact judge for 2.5D: the tool's swept area against the wanted removals, without a grid.

Arcs are flattened within 0.0002 mm and all distances are exact; a cutter that is not flat enters by discs
0.001 mm apart on its profile. So gouge and left-over are good to 0.001 mm. Every move counts, rapids too.
An engraving wants its line at its depth: there the tool's centre is judged against the line.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import shapely

from CNCStepper.cycles.cycle import Removal
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.simulation.cutter_solid import BEAM, POINT, Cutter, Tools, tool_numbered
from CNCStepper.simulation.exact.beams import beam_cuts, through
from CNCStepper.simulation.exact.edge_tree import EdgeTree, flat_edges
from CNCStepper.simulation.exact.gouge import SMALL_MM, Entries, PathEntries, ProtectedMaterial, Ranked, Worst, deepest
from CNCStepper.simulation.exact.remaining_material import Island, Leftover, left_over
from CNCStepper.simulation.exact.segment_blocks import Blocks, Cuts
from CNCStepper.simulation.exact.stored_cuts import StoredCuts
from CNCStepper.simulation.exact.wall_distance import Region
from CNCStepper.simulation.stock import HeightField, Stock
from CNCStepper.simulation.tip_segments import Segments, clipped_below, segments
from CNCStepper.tolerances import SAME_HEIGHT_MM
from CNCStepper.toolpath import Toolpath

FLATTEN_MM = 0.0002
FAR_MM = 1e5  # how far the air beside the stock reaches
LINE_STEP_MM = 0.02  # between the points at which an engraving's path is compared with its line
MOST_POINTS = 50_000


@dataclass(frozen=True)
class Level:
    """One level of the tool's tip: how much path lies on it, and how deep it can gouge at most."""

    z_mm: float
    path_mm: float
    gouge_at_most_mm: float


@dataclass(frozen=True)
class Judgement:
    """The verdict on a program: the deepest gouge into material that must stay, and the thickest material left.

    gouge_tolerance_mm: what the removal nearest to the gouge allows. removals: what each of them leaves,
    in their order. levels: from the top downwards.
    """

    gouge: Worst
    gouge_tolerance_mm: float
    left_over: Worst
    islands: list[Island]
    removals: list[Leftover]
    levels: list[Level]

    @property
    def gouge_mm(self) -> float:
        """The deepest penetration into the wanted part."""
        return self.gouge.depth_mm

    @property
    def left_over_mm(self) -> float:
        """The thickest material left inside the wanted removals."""
        return self.left_over.depth_mm


def judge(
    toolpath: Toolpath,
    tools: Tools,
    removals: Sequence[Removal],
    stock: Stock | None = None,
) -> Judgement:
    """Return how far the program is from cutting exactly the removals (work coordinates).

    Without a stock everything below z = 0 outside the removals is to stay. Rows with a tool that is not
    among `tools` are not judged.
    """
    cuts = cutting_path(toolpath, tools, 0.0, stock)
    return judge_cuts([(cutter, Blocks([pieces])) for cutter, pieces in cuts], removals, stock)


def judge_cuts(cuts: Cuts, removals: Sequence[Removal], stock: Stock | None = None) -> Judgement:
    """Return the same of the tip's path below z = 0, as `cutting_path` gives it, block by block."""
    _, lines = _areas_and_lines(removals)  # drawn lines may leave the stock: beside it the tool cuts air
    removals = [_inside_stock(removal, stock) for removal in removals]
    areas, _ = _areas_and_lines(removals)
    kept, levels = _kept(areas, stock), _LevelSums()
    engraves = partial(_engraves, lines=lines, alone=not areas)
    with closing(StoredCuts()) as engraved:
        ranked = [_ranked(PathEntries(cutter, blocks, kept, engraves), engraved, levels) for cutter, blocks in cuts]
        centres = [(POINT, blocks.held()) for _, blocks in engraved.by_cutter()]
        gouge = max(
            [deepest(one, kept) for one in ranked] + [_engraving_gouge(blocks, lines) for _, blocks in centres],
            key=lambda worst: worst.depth_mm,
            default=Worst(),
        )
        left = [left_over(_reachable(one, stock), cuts if one.region.area > 0 else centres, stock) for one in removals]
    return Judgement(
        gouge,
        _nearest_tolerance_mm(gouge, removals),
        max((one.worst for one in left), key=lambda worst: worst.depth_mm, default=Worst()),
        [island for one in left for island in one.islands],
        left,
        levels.all(),
    )


def _ranked(path: PathEntries, engraved: StoredCuts, levels: _LevelSums) -> Ranked:
    """Return the entries of a path that may gouge deepest; what engraves is kept apart."""
    ranked = Ranked(path)
    for rest, centres in path:
        ranked.add(rest)
        engraved.add([(path.cutter, centres.pieces)])
        levels.add(rest.pieces, rest.bound_mm)
        levels.add(centres.pieces, np.zeros(len(centres.pieces)))
    return ranked


def cutting_path(
    toolpath: Toolpath, tools: Tools, top_mm: float, stock: Stock | None = None
) -> list[tuple[Cutter, Segments]]:
    """Return the tip's path below `top_mm` as segments, by cutter; that of a beam lies at the stock's bottom."""
    path, cuts = segments(toolpath, FLATTEN_MM), beam_cuts(toolpath, tools)
    number = np.array([state.tool for state in toolpath.states])[toolpath.table().state[path.row]]
    through_mm = 0.0 if stock is None else stock.top_mm - stock.bottom_mm
    by_cutter: dict[Cutter, list[Segments]] = {}
    for used in np.unique(number).tolist():
        tool, pieces = tool_numbered(tools, used), path[number == used]
        if tool is not None:
            if stock is not None and tool.shape in BEAM:
                pieces = through(pieces[cuts[pieces.row]], stock.bottom_mm)
            by_cutter.setdefault(Cutter(form_of(tool, through_mm)), []).append(pieces.known())
    return [(cutter, clipped_below(_joined(parts), top_mm - SAME_HEIGHT_MM)) for cutter, parts in by_cutter.items()]


def _joined(parts: list[Segments]) -> Segments:
    if len(parts) == 1:
        return parts[0]
    order = np.argsort(np.concatenate([part.row for part in parts]), kind="stable")
    columns = (np.concatenate([getattr(part, name) for part in parts]) for name in ("begin", "end", "row"))
    return Segments(*(column[order] for column in columns))


def _inside_stock(removal: Removal, stock: Stock | None) -> Removal:
    """Return what of the removal there is to cut."""
    if stock is None:
        return removal
    region = removal.region.intersection(stock.outline)
    top_mm = min(removal.top_mm, stock.top_mm)
    return replace(removal, region=region, top_mm=top_mm, bottom_mm=max(removal.bottom_mm, stock.bottom_mm))


def _reachable(removal: Removal, stock: Stock | None) -> Removal:
    """Return the part of the removal in which nothing may be left."""
    if removal.reachable is None:
        return removal
    return _inside_stock(replace(removal, region=removal.reachable), stock)


def _nearest_tolerance_mm(gouge: Worst, removals: list[Removal]) -> float:
    """Return the tolerance of the removal beside which the gouge lies; 0 where nothing is to be removed."""
    if gouge.place_mm is None or not removals:
        return max((removal.tolerance_mm for removal in removals), default=0.0)
    point = shapely.Point(gouge.place_mm[:2])
    return min(removals, key=lambda removal: removal.region.distance(point)).tolerance_mm


def _areas_and_lines(removals: Sequence[Removal]) -> tuple[list[Removal], list[Removal]]:
    areas = [removal for removal in removals if removal.region.area > 0]
    lines = [removal for removal in removals if removal.region.area == 0 and removal.region.length > 0]
    return areas, lines


def _kept(areas: list[Removal], stock: Stock | None) -> ProtectedMaterial:
    """Return the material that must stay: by falling bottom the union of removals and air at or below it."""
    beside = []
    if stock is not None:
        beside = [shapely.box(-FAR_MM, -FAR_MM, FAR_MM, FAR_MM).difference(stock.outline)]
    bottoms = sorted({removal.bottom_mm for removal in areas}, reverse=True)
    unions = [[one.region for one in areas if one.bottom_mm <= bottom] + beside for bottom in bottoms]
    stock_bottom_mm = -np.inf if stock is None else stock.bottom_mm
    if beside:
        bottoms, unions = [*bottoms, stock_bottom_mm], [*unions, beside]
    regions = tuple(Region(shapely.union_all(union)) for union in unions)
    field = stock if isinstance(stock, HeightField) else None
    return ProtectedMaterial(tuple(bottoms), regions, 0.0, stock_bottom_mm, field)


def _engraves(entry: Entries, lines: list[Removal], alone: bool) -> np.ndarray:
    """Return which entries engrave, bool[n].

    Path engraves where it lies lower than a line's top, within the tool's radius of the line, and in no
    removed area; where all removals are lines (`alone`), everything engraves.
    """
    pieces = entry.pieces
    belongs = np.full(len(pieces), alone and bool(lines))
    for line in lines:
        near = EdgeTree.of_geometry(line.region).nearest(flat_edges(pieces))[1]
        belongs |= (near <= entry.cutter.radius_mm) & (pieces.low_mm < line.top_mm) & (entry.bound_mm > SMALL_MM)
    return belongs


def _engraving_gouge(path: Blocks, lines: list[Removal]) -> Worst:
    """Return the point of the tool's path that is farthest from every line and depth, but never above the stock."""
    whole_mm = sum(float(np.linalg.norm(pieces.end - pieces.begin, axis=1).sum()) for pieces in path)
    step_mm, worst = max(LINE_STEP_MM, whole_mm / MOST_POINTS), Worst()
    for points, row in (_spread(pieces, step_mm) for pieces in path):
        depth = -points[:, 2]
        for line in lines:
            beside = EdgeTree.of_geometry(line.region).distance(points[:, :2])
            depth = np.minimum(depth, np.hypot(beside, np.maximum(line.bottom_mm - points[:, 2], 0.0)))
        if depth.max(initial=0.0) > max(SMALL_MM, worst.depth_mm):
            k = int(depth.argmax())
            worst = Worst(float(depth[k]), tuple(points[k].tolist()), int(row[k]))
    return worst


def _spread(pieces: Segments, step_mm: float) -> tuple[np.ndarray, np.ndarray]:
    """Return points close together on the pieces, float64[n, 3], with their rows."""
    length = np.linalg.norm(pieces.end - pieces.begin, axis=1)
    counts = np.ceil(length / step_mm).astype(np.int64) + 1
    index = np.repeat(np.arange(len(pieces)), counts)
    place = np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)
    share = (place / np.maximum(counts[index] - 1, 1))[:, None]
    return pieces.begin[index] * (1 - share) + pieces.end[index] * share, pieces.row[index]


class _LevelSums:
    """The levels on which path lies, summed up block after block."""

    def __init__(self) -> None:
        self._found: dict[float, tuple[float, float]] = {}  # the height: how much path, the greatest bound

    def add(self, pieces: Segments, bound_mm: np.ndarray) -> None:
        """Take further path with what bounds its gouge."""
        level = np.abs(pieces.begin[:, 2] - pieces.end[:, 2]) <= SAME_HEIGHT_MM
        length = np.hypot(*(pieces.end - pieces.begin)[level, :2].T)
        z, which = np.unique(np.round(pieces.end[level, 2] / SAME_HEIGHT_MM) * SAME_HEIGHT_MM, return_inverse=True)
        path, worst = np.bincount(which, length, minlength=len(z)), np.zeros(len(z))
        np.maximum.at(worst, which, bound_mm[level])
        for height, path_mm, worst_mm in zip(z.tolist(), path.tolist(), worst.tolist(), strict=True):
            before = self._found.get(height, (0.0, 0.0))
            self._found[height] = before[0] + path_mm, max(before[1], worst_mm)

    def all(self) -> list[Level]:
        """Return them from the top downwards."""
        return [Level(height, *self._found[height]) for height in sorted(self._found, reverse=True)]
