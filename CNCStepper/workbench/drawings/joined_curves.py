# SPDX-License-Identifier: LGPL-2.1-or-later
"""The curves of several drawings together: lines that meet are joined, what is drawn twice counts once.

 drawings ──► parts: whole drawings, faces ──► chains of lines that touch ──► doubled ones out ──► open ones joined

What is said of them (drawn twice, at different heights) comes with them as sentences for a person.
"""

from __future__ import annotations

import itertools
import math
from collections import OrderedDict, defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.job.curve_fit_cache import Line, require
from CNCStepper.tolerances import SAME_CURVE_MM, SAME_HEIGHT_MM
from CNCStepper.workbench.drawings.curves import SHORTEST_MM, Piece, curve_of_chain, pieces_of, require_tolerance
from CNCStepper.workbench.drawings.exact_curves import kept_curves
from CNCStepper.workbench.drawings.shapes import DrawingSnapshot, line_groups, refuse_unflat, sorted_chains

CELL_MM = 0.01  # of the grid in which ends that meet are looked for
MOST_DRAWINGS = 64  # whose chains are kept
SAMPLES = 16  # places along a curve where its distance from another one is looked at
Pair = tuple[Any, tuple[str, ...]]


@dataclass(frozen=True)
class DrawnCurve:
    """A curve, the drawings that it comes from, and their height in the document."""

    curve: Curve
    drawings: tuple[Any, ...]
    height_mm: float

    @property
    def label(self) -> str:
        """The labels of its drawings."""
        return ", ".join(dict.fromkeys(str(drawing.Label) for drawing in self.drawings))


@dataclass(frozen=True)
class Drawn:
    """The curves of several drawings; `doubled` are those left out, each with the one that it is the same as."""

    curves: tuple[DrawnCurve, ...]
    doubled: tuple[tuple[DrawnCurve, DrawnCurve], ...]

    def remarks(self) -> list[str]:
        """Return remarks on the drawings."""
        pairs = dict.fromkeys((out.label, kept.label) for out, kept in self.doubled)
        said: list[str] = [
            Text("'{out}' is drawn where '{kept}' is, and counts once", out=out, kept=kept) for out, kept in pairs
        ]
        heights = [each.height_mm for each in self.curves]
        if heights and max(heights) - min(heights) > SAME_HEIGHT_MM:
            said.append(
                Text(
                    "the drawings lie at heights from Z{least_heights:.4g} to Z{most_heights:.4g} mm; "
                    "all depths count from the top of the stock",
                    least_heights=min(heights),
                    most_heights=max(heights),
                )
            )
        return said


def drawn_of(pairs: Sequence[Pair], tolerance_mm: float) -> Drawn:
    """Return the curves of drawings, of each the picked faces and edges or all of it, in the document's coordinates.

    Raises GeometryError for an empty drawing, one that is not flat, or a tolerance that cannot be kept.
    """
    require_tolerance(tolerance_mm)
    chains = [(drawing, chain) for drawing, names in pairs for chain in _chains_of(drawing, names)]
    require([piece for _, chain in chains for piece in chain.pieces if isinstance(piece, Line)], tolerance_mm)
    found = [
        DrawnCurve(curve_of_chain(chain.pieces, tolerance_mm), (drawing,), chain.height_mm) for drawing, chain in chains
    ]
    doubled = _doubled([each.curve for each in found])
    kept = [each for number, each in enumerate(found) if number not in doubled]
    return Drawn(tuple(_joined(kept)), tuple((found[out], found[same]) for out, same in doubled.items()))


@dataclass(frozen=True)
class _Chain:
    """The pieces of a line of a drawing in the order in which they touch, and its height in the document."""

    pieces: list[Piece]
    height_mm: float


_chains: OrderedDict[tuple[Any, ...], tuple[DrawingSnapshot, list[_Chain]]] = OrderedDict()  # of the last drawings


def _chains_of(drawing: Any, names: tuple[str, ...]) -> list[_Chain]:
    """Return the chains of a drawing, or of what is picked of it, looked for anew where it has changed."""
    key, seen = (drawing.Document.Name, drawing.Name, names), DrawingSnapshot.of(drawing)
    if key not in _chains or not seen.same(_chains[key][0]):
        _chains[key] = seen, _looked_for(drawing, names)
        while len(_chains) > MOST_DRAWINGS:
            _chains.popitem(last=False)
    _chains.move_to_end(key)
    return _chains[key][1]


def _looked_for(drawing: Any, names: tuple[str, ...]) -> list[_Chain]:
    chains = [chain for group in line_groups(drawing, names) for chain in sorted_chains(group, SHORTEST_MM)]
    for chain in chains:
        refuse_unflat(chain, drawing.Label)
    found = [_Chain(pieces_of(chain), chain[0].valueAt(chain[0].FirstParameter).z) for chain in chains]
    if names or any(isinstance(piece, Line) for chain in found for piece in chain.pieces):
        return found
    drawn = [curve_of_chain(chain.pieces, SHORTEST_MM) for chain in found]
    return [_Chain([curve], chain.height_mm) for curve, chain in zip(kept_curves(drawing, drawn), found, strict=True)]


def _doubled(curves: Sequence[Curve]) -> dict[int, int]:
    """Return which curves are drawn along another one all their way, and along which, by their numbers."""
    reach_mm = np.array([SAME_CURVE_MM + _highest_arc_mm(curve) for curve in curves])
    low = np.array([curve.xy.min(axis=0) for curve in curves]).reshape(-1, 2)
    high = np.array([curve.xy.max(axis=0) for curve in curves]).reshape(-1, 2)
    found: dict[int, int] = {}
    kept = np.zeros(len(curves), bool)
    for number in sorted(range(len(curves)), key=lambda number: (-round(curves[number].length_mm, 2), number)):
        near = np.all(low - reach_mm[:, None] <= low[number], axis=1) & np.all(
            high + reach_mm[:, None] >= high[number], axis=1
        )
        others = np.flatnonzero(kept & near).tolist()
        same = next((other for other in others if _lies_on(curves[number], curves[other])), None)
        kept[number] = same is None
        if same is not None:
            found[number] = same
    return dict(sorted(found.items()))


def _highest_arc_mm(curve: Curve) -> float:
    """Return how far at most the arcs of a curve reach beyond the box of its vertices."""
    chords_mm = np.hypot(*np.diff(curve.xy, axis=0).T)
    return float((np.abs(curve.bulge) * chords_mm).max()) / 2.0


def _lies_on(one: Curve, other: Curve) -> bool:
    """Return whether a curve is drawn along another one all its way; a closed one is then the same as that."""
    if one.closed and (not other.closed or abs(one.length_mm - other.length_mm) > SAME_CURVE_MM):
        return False
    if other.distances_mm(one.xy[:1])[0] >= SAME_CURVE_MM:  # so it is of nearly all: the window waits for this
        return False
    places, _ = one.at_length((np.arange(SAMPLES) + 0.5) * one.length_mm / SAMPLES)
    return bool(np.all(other.distances_mm(np.vstack([places, one.xy])) < SAME_CURVE_MM))


def _joined(curves: Sequence[DrawnCurve]) -> list[DrawnCurve]:
    """Return the curves, open ones of different drawings joined where the ends of just two meet.

    A joined curve stands where the first of its parts stood, and runs as that does.
    """
    is_open = [number for number, each in enumerate(curves) if not each.curve.closed]
    if len({drawing for number in is_open for drawing in curves[number].drawings}) < 2:
        return list(curves)
    ends = _Ends({number: curves[number] for number in is_open})
    used: set[int] = set()
    result = []
    for number, each in enumerate(curves):
        if number not in used:
            way = [(number, True)] if each.curve.closed else ends.way(number)
            used.update(part for part, _ in way)
            result.append(_one([(curves[part], forwards) for part, forwards in way]))
    return result


class _Ends:
    """The ends of open curves by their places: which curves begin or end at each."""

    def __init__(self, curves: dict[int, DrawnCurve]):
        self._places: dict[tuple[int, bool], int] = {}  # by a curve's number and whether it is its begin
        self._there: list[list[tuple[int, bool]]] = []
        cells: defaultdict[tuple[int, ...], list[tuple[tuple[float, ...], int]]] = defaultdict(list)
        for number, each in curves.items():
            for begins in (True, False):
                x, y = each.curve.xy[0 if begins else -1].tolist()
                place = self._place((x, y, each.height_mm), cells)
                self._places[number, begins] = place
                self._there[place].append((number, begins))

    def way(self, first: int) -> list[tuple[int, bool]]:
        """Return the curves that hang together with one, in turn, each with whether it runs as it is drawn."""
        after = self._on(first, True)
        if after and after[-1][0] == first:
            return [(first, True), *after[:-1]]
        before = self._on(first, False)
        return [*((number, not forwards) for number, forwards in reversed(before)), (first, True), *after]

    def _on(self, first: int, forwards: bool) -> list[tuple[int, bool]]:
        """Return the curves on from one, up to a place where not just two meet, or to itself where they close."""
        found: list[tuple[int, bool]] = []
        number, runs = first, forwards
        while True:
            there = self._there[self._places[number, not runs]]
            others = [end for end in there if end[0] != number]
            if len(there) != 2 or len(others) != 1:
                return found
            number, runs = others[0]
            found.append((number, runs))
            if number == first:
                return found

    def _place(self, at: tuple[float, ...], cells: Any) -> int:
        cell = tuple(math.floor(value / CELL_MM) for value in at)
        for step in itertools.product((-1, 0, 1), repeat=3):
            for other, place in cells.get(tuple(map(sum, zip(cell, step, strict=True))), ()):
                if math.dist(at, other) <= SHORTEST_MM:
                    return int(place)
        self._there.append([])
        cells[cell].append((at, len(self._there) - 1))
        return len(self._there) - 1


def _one(parts: Sequence[tuple[DrawnCurve, bool]]) -> DrawnCurve:
    """Return touching curves as one, closed where its ends meet; each runs as it is drawn, or else the other way."""
    pieces = [each.curve if forwards else each.curve.reversed() for each, forwards in parts]
    if len(pieces) == 1:
        return parts[0][0]
    xy = np.vstack([pieces[0].xy[:1], *(piece.xy[1:] for piece in pieces)])
    if math.dist(xy[0], xy[-1]) <= SHORTEST_MM:
        xy[-1] = xy[0]
    drawings = tuple(dict.fromkeys(drawing for each, _ in parts for drawing in each.drawings))
    curve = Curve(xy, np.concatenate([piece.bulge for piece in pieces]))
    return DrawnCurve(curve, drawings, parts[0][0].height_mm)
