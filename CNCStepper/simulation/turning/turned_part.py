# SPDX-License-Identifier: LGPL-2.1-or-later
"""The part that the moves of a lathe program leave of its stock, and what each of them met on its way.

    rapid  feed feed feed ...  rapid  rapid  feed ...        a pass: feeds up to the next rapid or tool
           '--- a pass ----'                                 its moves are swept at once and taken off together

The region of the part is kept after each pass, so that the part at any move is the cut of at most one pass away.
What comes off the piece in the chuck has fallen: no later move cuts it.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from CNCStepper.simulation.turning.half_section import HalfSection, solid
from CNCStepper.simulation.turning.swept_outline import Moves, outlines_at, swept
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.tolerances import NO_LENGTH_MM

CONTACT_MM = 0.002  # how deep a tool must be in material to touch it: chords and rounding are below
LONGEST_PASS = 512  # moves that are taken off together
SLIVER_MM2 = 1e-6  # an area that rounding leaves between two moves
DUST_MM3 = 1e-3  # what falls and is smaller was left between two chords

Sections = Mapping[int, ToolSection]


@dataclass(frozen=True)
class Contact:
    """A move that touched material: place (z, r) of the deepest point, how deep the tool was in there."""

    move: int
    depth_mm: float
    place_mm: tuple[float, float]


@dataclass(frozen=True)
class Fallen:
    """A piece that came off the rest during a move."""

    move: int
    section: HalfSection


@dataclass
class TurnedPart:
    """The part as cut. region: what the chuck still holds; moves: those whose tool is known, as they were swept.

    rapids: rapids through material. holders: moves whose holder touched it. depths_mm, float64[n]: how deep each feed
    cut across its way, 0 where it cut nothing. marks: (moves done, region) after each pass. areas: swept by each move.
    left_out: the first line of each tool number whose feeds are not simulated, as its shape is not known.
    """

    stock: HalfSection
    moves: Moves
    areas: np.ndarray
    region: BaseGeometry
    depths_mm: np.ndarray
    rapids: list[Contact] = field(default_factory=list)
    holders: list[Contact] = field(default_factory=list)
    fallen: list[Fallen] = field(default_factory=list)
    marks: list[tuple[int, BaseGeometry]] = field(default_factory=list)
    left_out: dict[int, int] = field(default_factory=dict)

    @property
    def held(self) -> HalfSection:
        """What the chuck holds at the end."""
        return HalfSection(self.region)

    @property
    def section(self) -> HalfSection:
        """All that is left, the pieces that fell too."""
        return HalfSection(shapely.union_all([self.region, *(one.section.region for one in self.fallen)]))

    def at(self, row: int) -> HalfSection:
        """Return the part after that row of the table, with what has fallen until then; -1: the stock."""
        count = int(np.searchsorted(self.moves.row, row, side="right"))
        place = bisect_right(self.marks, count, key=lambda mark: mark[0]) - 1
        done, region = self.marks[place] if place >= 0 else (0, self.stock.region)
        if count > done:
            region = _held(region.difference(shapely.union_all(self.areas[done:count])), self.stock)[0]
        fallen = [one.section.region for one in self.fallen if one.move < count]
        return HalfSection(shapely.union_all([region, *fallen]))


def turned_part(moves: Moves, stock: HalfSection, tools: Sections) -> TurnedPart:
    """Return what the moves leave of the stock; moves of a tool that is not among `tools` are left out."""
    left_out = _left_out(moves, tools)
    moves = _with_pitches(moves[np.isin(moves.tool, list(tools))], tools)
    areas = np.empty(len(moves), object)
    for number in np.unique(moves.tool).tolist():
        mine = np.flatnonzero(moves.tool == number)
        areas[mine] = swept(tools[number].cutting_parts, moves[mine])
    part = TurnedPart(stock, moves, areas, stock.region, np.zeros(len(moves)), left_out=left_out)
    for first, last in _passes(moves):
        _cut(part, slice(first, last), tools[int(moves.tool[first])])
    return part


def _left_out(moves: Moves, tools: Sections) -> dict[int, int]:
    """Return the first line of each tool number that feeds and is not among `tools`."""
    unknown = np.flatnonzero(~np.isin(moves.tool, list(tools)) & ~moves.rapid)
    numbers, firsts = np.unique(moves.tool[unknown], return_index=True)
    return dict(zip(numbers.tolist(), moves.line[unknown[firsts]].tolist(), strict=True))


def _with_pitches(moves: Moves, tools: Sections) -> Moves:
    """Return the moves where the feeds of threading tools with a pitch follow the spindle."""
    own = np.array([tools[number].pitch_mm for number in moves.tool.tolist()])
    pitch = np.where((moves.pitch_mm == 0) & ~moves.rapid, own, moves.pitch_mm)
    return replace(moves, pitch_mm=pitch)


def _passes(moves: Moves) -> Iterator[tuple[int, int]]:
    """Yield the first move of each pass and the one after its last; rapids in a row are a pass too."""
    if not len(moves):
        return
    changed = (np.diff(moves.tool) != 0) | (np.diff(moves.rapid.astype(int)) != 0)
    bounds = [0, *(np.flatnonzero(changed) + 1).tolist(), len(moves)]
    for first, last in pairwise(bounds):
        for begin in range(first, last, LONGEST_PASS):
            yield begin, min(begin + LONGEST_PASS, last)


def _cut(part: TurnedPart, which: slice, tool: ToolSection) -> None:
    """Take a pass off the part, and note what it met."""
    is_rapid = bool(part.moves.rapid[which.start])
    holder = swept(tool.holder_parts, part.moves[which]) if tool.holder_parts else np.zeros(0, object)
    if is_rapid:
        part.holders += contacts(part.region, holder, which.start)
    shapely.prepare(part.region)
    met = which.start + np.flatnonzero(shapely.intersects(part.region, part.areas[which]))
    if is_rapid:
        found = [one for move in met.tolist() for one in contacts(part.region, part.areas[move : move + 1], move)]
        part.rapids += found
        met = np.array([one.move for one in found], int)
    elif len(met):
        part.depths_mm[met] = _depths_mm(part, met, tool)
    if len(met):
        _take_off(part, met, which.stop)
    if not is_rapid:
        part.holders += contacts(part.region, holder, which.start)


def _take_off(part: TurnedPart, met: np.ndarray, stop: int) -> None:
    left = part.region.difference(shapely.union_all(part.areas[met]))
    part.region, loose = _held(left, part.stock)
    part.marks.append((stop, part.region))
    part.fallen += [Fallen(stop - 1, HalfSection(piece)) for piece in loose]


def _depths_mm(part: TurnedPart, met: np.ndarray, tool: ToolSection) -> np.ndarray:
    """Return how far the material that each feed cuts reaches across its way, float64[len(met)].

    What the outline covers where the move begins is cut already. A move that follows the spindle counts as none.
    """
    begin, end = part.moves.begin[met], part.moves.end[met]
    fresh = shapely.difference(part.areas[met], outlines_at(tool.cutting_parts, begin))
    cut = shapely.intersection(fresh, part.region)
    cut[shapely.area(cut) < SLIVER_MM2] = None
    points, index = shapely.get_coordinates(cut, return_index=True)
    way = end - begin
    length = np.hypot(*way.T)
    across = np.column_stack([-way[:, 1], way[:, 0]]) / np.maximum(length, NO_LENGTH_MM)[:, None]
    place = np.einsum("ij,ij->i", points, across[index])
    low, high = np.full(len(met), np.inf), np.full(len(met), -np.inf)
    np.minimum.at(low, index, place)
    np.maximum.at(high, index, place)
    counts = (high > low) & (length > NO_LENGTH_MM) & (part.moves.pitch_mm[met] == 0)
    return np.where(counts, np.where(counts, high, 0.0) - np.where(counts, low, 0.0), 0.0)


def contacts(material: BaseGeometry, areas: np.ndarray, first: int) -> list[Contact]:
    """Return which of these areas reach deeper than CONTACT_MM into material; they belong to moves from `first` on.

    The depth is the thickness of what both share: the diameter of the largest circle in it.
    """
    if not len(areas):
        return []
    shapely.prepare(material)
    met = np.flatnonzero(shapely.intersects(material, areas))
    shared = shapely.intersection(areas[met], material)
    deep = ~shapely.is_empty(shapely.buffer(shared, -CONTACT_MM / 2))
    return [Contact(first + int(move), *thickness(both)) for move, both in zip(met[deep], shared[deep], strict=True)]


def thickness(region: BaseGeometry) -> tuple[float, tuple[float, float]]:
    """Return the diameter of the largest circle in a region, and its middle (z, r); regions that are not empty."""
    widest = max(shapely.get_parts(region), key=lambda part: part.area)
    circle = shapely.maximum_inscribed_circle(widest, tolerance=CONTACT_MM / 4)
    (z, r), _ = circle.coords
    return 2 * circle.length, (z, r)


def _held(region: BaseGeometry, stock: HalfSection) -> tuple[BaseGeometry, list[BaseGeometry]]:
    """Return what still hangs together with the end in the chuck, and the pieces that do not; dust is dropped."""
    pieces = shapely.get_parts(solid(region))
    if len(pieces) < 2:
        return shapely.union_all(pieces), []
    end = stock.region.bounds[0] + CONTACT_MM
    held = [piece for piece in pieces if piece.bounds[0] <= end]
    loose = [piece for piece in pieces if piece.bounds[0] > end and HalfSection(piece).volume_mm3 > DUST_MM3]
    return shapely.union_all(held), loose
