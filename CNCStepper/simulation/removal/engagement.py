# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of the tool is in the material along the path, measured in a map of heights while it is cut.

      ,-----.            The rim is looked at half a radius ahead of what counts as cut: that is
 ____/ tool  \\_____      wide enough for the map's cells. So the engagement angle is good to about
////|    o -> |/////     15 degrees, the heights are those of the cut itself.
/////\\       /////// material
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import COMPILED, njit
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import Form, form_of
from CNCStepper.simulation.cutter_solid import BEAM, Tools, height_at, tool_numbered
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, segments
from CNCStepper.toolpath import Toolpath

CELLS_A_RADIUS = 16
FEWEST_CELLS = 10  # a radius, for the angle to mean anything
MOST_CELLS = 16_000_000 if COMPILED else 250_000
CELLS_AT_ONCE = 500_000  # whose heights are asked for
AHEAD = 0.5  # of the radius: what is cut later than this behind the tool counts as standing
PLACES_A_RADIUS = 4
MOST_PLACES = 200_000  # that are followed at once
MOST_PLACES_A_MOVE = 1_000_000
ANGLE_STEP_DEG = 5.0
WIDEST_DEG = 80.0  # to each side; beyond it the cells cannot separate side and front
MATERIAL_MM = 0.01  # higher above the tool's profile is material
RINGS = ((0.3, 3), (0.6, 2), (0.9, 1))  # of the radius, where material inside a tool or holder is looked for; and step
INSIDE = 0.75  # cells from the rim, inwards, where the angle is measured: a rim that only touches meets nothing
AROUND = np.array([(np.cos(turn), np.sin(turn)) for turn in np.arange(72) * np.pi / 36])
BESIDE = 1.5  # cells from the rim, inwards for cut material and outwards for the wall beside
TURNS_DEG = np.arange(-WIDEST_DEG, WIDEST_DEG + ANGLE_STEP_DEG / 2, ANGLE_STEP_DEG)
AHEAD_OF = np.array([(np.cos(turn), np.sin(turn)) for turn in np.radians(TURNS_DEG)])


@dataclass(frozen=True)
class Engagement:
    """The engagement at k places of the tip along the path, in their order.

    row: int64[k], of the table of moves. place_mm: float64[k, 3]. angle_deg: float64[k], of the rim in material,
    NaN where the tool goes straight down or up, or is too small for the map. uncut_mm, beside_mm, holder_mm:
    float64[k], the highest material over the tip within the tool (but for its outermost cells), at its wall, and
    within its holder; -inf for none. cell_mm: of the map.
    """

    row: np.ndarray
    place_mm: np.ndarray
    angle_deg: np.ndarray
    uncut_mm: np.ndarray
    beside_mm: np.ndarray
    holder_mm: np.ndarray
    cell_mm: float

    @property
    def least_radius_mm(self) -> float:
        """The smallest radius of a tool whose angle can be measured."""
        return FEWEST_CELLS * self.cell_mm


def engagement(toolpath: Toolpath, tools: Tools, stock: Stock) -> Engagement:
    """Return the engagement of the tools in the stock; rows of unknown tools and of beams cut nothing here."""
    path, numbers = path_of(toolpath)
    area = Area(stock, tools)
    area.see(path, numbers)
    if not area.used:
        return no_engagement()
    (met,) = area.followed([(path, numbers)])
    return met


def path_of(toolpath: Toolpath) -> tuple[Segments, np.ndarray]:
    """Return the tip's path as it is followed, and the number of the tool on each segment, int[n]."""
    path = segments(toolpath, 0.01).known()
    return path, np.array([state.tool for state in toolpath.states], int)[toolpath.table().state[path.row]]


def no_engagement() -> Engagement:
    """Return the engagement of no place."""
    return Engagement(np.zeros(0, np.int64), np.zeros((0, 3)), *(np.zeros(0),) * 4, 0.0)


class Area:
    """Where in the stock a path goes, which may come in parts: all of them are seen first, and then followed.

    used: the known tools that go there, beams left out, by number.
    """

    def __init__(self, stock: Stock, tools: Tools):
        self._stock, self._tools = stock, tools
        self.used: dict[int, Tool] = {}
        self._low, self._high = np.full(2, np.inf), np.full(2, -np.inf)  # of the places

    def see(self, path: Segments, numbers: np.ndarray) -> None:
        """Let the area grow by a part of the path."""
        for number in np.unique(numbers).tolist():
            tool = tool_numbered(self._tools, number)
            if tool is not None and tool.shape not in BEAM:
                self.used[number] = tool
        path, _, counts = self._known(path, numbers)
        if len(path):
            delta = (path.end - path.begin) / counts[:, None]
            ends = np.vstack([path.begin + delta, path.begin + delta * (counts - 1)[:, None] + delta])[:, :2]
            self._low = np.minimum(self._low, ends.min(axis=0))
            self._high = np.maximum(self._high, ends.max(axis=0))

    def split_at(self, path: Segments, numbers: np.ndarray) -> np.ndarray:
        """Return where to cut a part of the path that would be too long a row of places to be followed at once."""
        counts = np.zeros(len(path), np.int64)
        known, _, counts_of_known = self._known(Segments(path.begin, path.end, np.arange(len(path))), numbers)
        counts[known.row] = counts_of_known
        return np.flatnonzero(np.diff(np.cumsum(counts) // MOST_PLACES)) + 1

    def followed(self, parts: Iterable[tuple[Segments, np.ndarray]]) -> Iterator[Engagement]:
        """Yield the engagement along the parts read so far, one after the other."""
        used = list(self.used.values())
        heights, corner, cell_mm = _map(self._stock, self._low, self._high, used)
        bodies = np.array([_body(tool) for tool in used])
        radii = np.array([tool.radius_mm for tool in used])
        behind = _Behind(AHEAD * radii)
        for path, numbers in parts:
            pieces, which = _short(*self._known(path, numbers))
            first, window = behind.with_next(pieces, which)
            met = np.full((len(pieces), 4), -np.inf)
            map_of = heights, corner, cell_mm
            cut = _follow(*map_of, first, *window.columns, bodies, self._stock.top_mm, met)
            behind.forget(cut)
            met[radii[which] < FEWEST_CELLS * cell_mm, 0] = np.nan
            yield Engagement(pieces.row, pieces.end, met[:, 0], met[:, 1], met[:, 2], met[:, 3], cell_mm)

    def _known(self, path: Segments, numbers: np.ndarray) -> tuple[Segments, np.ndarray, np.ndarray]:
        """Return the path of known tools, of each segment the place of its tool among those used, and its pieces."""
        order = np.array(list(self.used), int)
        known = np.isin(numbers, order)
        sorter = np.argsort(order, kind="stable")
        which = sorter[np.searchsorted(order, numbers[known], sorter=sorter)]
        radii = np.array([tool.radius_mm for tool in self.used.values()])
        return path[known], which, _piece_counts(path[known], radii[which])


class _Window(NamedTuple):
    """Consecutive places of the tip, float64[n, 3]; which way the tool goes to each, what is cut before, which tool."""

    places: np.ndarray
    direction: np.ndarray
    cut_before: np.ndarray  # int64[n], how many of the window
    which: np.ndarray

    @property
    def columns(self) -> tuple[np.ndarray, ...]:
        """What the kernel is given."""
        return np.ascontiguousarray(self.places), self.direction, self.cut_before, self.which


class _Behind:
    """The places of the parts before that are not cut out of the map yet."""

    def __init__(self, ahead_mm: np.ndarray):
        """ahead_mm: by tool, how far behind the tool lies what is cut later than it is measured."""
        self._ahead_mm = ahead_mm
        self._places, self._which = np.zeros((0, 3)), np.zeros(0, np.int64)
        self._done_mm = np.zeros(0)  # of the path, at each of them
        self._gone_mm = 0.0
        self._last: tuple[np.ndarray, int, bool] | None = None  # place and tool of the last one, whether it went aside
        self._chain = 0  # among them, the first from which the path is unbroken

    def with_next(self, pieces: Segments, which: np.ndarray) -> tuple[int, _Window]:
        """Return these and the next places as one window, and which of it is the first of the next."""
        step = (pieces.end - pieces.begin)[:, :2]
        length = np.hypot(*step.T)
        first = len(self._places)
        self._places = np.vstack([self._places, pieces.end])
        self._which = np.append(self._which, which)
        done_mm = np.cumsum(np.append(self._gone_mm, length))
        self._gone_mm, self._done_mm = float(done_mm[-1]), np.append(self._done_mm, done_mm[1:])
        behind = np.searchsorted(self._done_mm, done_mm[1:] - self._ahead_mm[which], side="right")
        chain = self._chains(pieces, which, length > 0, first)
        none = np.zeros((first, 2))
        window = _Window(
            self._places,
            np.vstack([none, step / np.where(length > 0, length, 1.0)[:, None]]),
            np.append(np.zeros(first, np.int64), np.maximum(behind, chain)),
            self._which,
        )
        return first, window

    def forget(self, count: int) -> None:
        """Forget the first places of the window, which are cut out of the map."""
        self._places, self._which, self._done_mm = self._places[count:], self._which[count:], self._done_mm[count:]
        self._chain -= count

    def _chains(self, pieces: Segments, which: np.ndarray, aside: np.ndarray, first: int) -> np.ndarray:
        """Return for each next place the first in the window from which the path is unbroken up to it."""
        if not len(pieces):
            return np.zeros(0, np.int64)
        place, tool, went_aside = self._last or (np.full(3, np.nan), -1, False)
        before = np.vstack([place, pieces.end[:-1]])
        joined = (pieces.begin == before).all(axis=1) & (which == np.append(tool, which[:-1]))
        begins = ~joined | ~aside | ~np.append(went_aside, aside[:-1])
        chain = np.maximum.accumulate(np.where(begins, np.arange(first, first + len(pieces)), self._chain))
        self._last, self._chain = (pieces.end[-1], int(which[-1]), bool(aside[-1])), int(chain[-1])
        return chain


def _body(tool: Tool) -> tuple[float, ...]:
    """Return a tool's form, and its holder's radius and height over the tip."""
    return (*form_of(tool), tool.holder_diameter_mm / 2, tool.length_mm)


def _piece_counts(path: Segments, radii_mm: np.ndarray) -> np.ndarray:
    """Return into how many pieces each segment is cut that are short against its tool's radius, int64[n]."""
    length = np.linalg.norm(path.end - path.begin, axis=1)
    counts = np.clip(np.ceil(length / radii_mm * PLACES_A_RADIUS), 1, MOST_PLACES_A_MOVE).astype(np.int64)
    level = np.hypot(*(path.end - path.begin)[:, :2].T) > 0
    return np.where(level, counts, 1)  # straight down or up only the end counts


def _short(path: Segments, which: np.ndarray, counts: np.ndarray) -> tuple[Segments, np.ndarray]:
    """Return the path in so many pieces, whose ends are the places, and the tool of each."""
    index = np.repeat(np.arange(len(path)), counts)
    step = np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)
    delta = (path.end - path.begin)[index] / counts[index][:, None]
    begin = path.begin[index] + delta * step[:, None]
    return Segments(begin, begin + delta, path.row[index]), which[index]


def _map(stock: Stock, low: np.ndarray, high: np.ndarray, tools: list[Tool]) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the heights of the stock where tools from `low` to `high` reach, its low corner and the side of a cell."""
    reach = max(max(tool.diameter_mm, tool.holder_diameter_mm) / 2 for tool in tools)
    low = np.maximum(low - reach, stock.low_mm[:2])
    high = np.minimum(high + reach, stock.high_mm[:2])
    size = np.maximum(high - low, 1e-3)
    fine = min(tool.radius_mm for tool in tools) / CELLS_A_RADIUS
    cell = max(fine, float(np.sqrt(size[0] * size[1] / MOST_CELLS)))
    x, y = (low[k] + cell * (np.arange(int(np.ceil(size[k] / cell))) + 0.5) for k in range(2))
    heights = np.empty((len(y), len(x)), np.float32)
    rows = max(CELLS_AT_ONCE // len(x), 2)
    for first in range(0, len(y), rows):
        some = y[first : first + rows]
        tops = stock.tops_mm(x, some)
        tops[stock.shares(x, some, (cell, cell)) <= 0.0] = -np.inf
        heights[first : first + rows] = tops
    return heights, low, cell


@njit
def _height(heights, corner, per_mm, x, y):
    """Return the material's height at a point; beside the map there is none."""
    column, row = (x - corner[0]) * per_mm, (y - corner[1]) * per_mm
    if row < 0.0 or column < 0.0 or row >= heights.shape[0] or column >= heights.shape[1]:
        return -np.inf
    return heights[int(row), int(column)]


@njit
def _cut(heights, corner, cell, place, form):
    """Cut the tool out of the map at one place."""
    rows, columns = heights.shape
    square = form[0] * form[0]
    west, south, z = place[0] - corner[0] - 0.5 * cell, place[1] - corner[1] - 0.5 * cell, place[2]
    first, last = _cells_within(south, form[0], cell, rows)
    for row in range(first, last + 1):
        y = row * cell - south
        half = np.sqrt(max(square - y * y, 0.0))
        begin, end = _cells_within(west, half, cell, columns)
        for column in range(begin, end + 1):
            if heights[row, column] > z:
                x = column * cell - west
                bottom = z + height_at(min(np.sqrt(x * x + y * y), form[0]), form)
                if bottom < heights[row, column]:
                    heights[row, column] = bottom


@njit
def _cells_within(middle, half, cell, count):
    """Return the first and last of `count` cells whose middles lie within `half` of a place, that of cell 0 at 0."""
    return max(int(np.ceil((middle - half) / cell)), 0), min(int(np.floor((middle + half) / cell)), count - 1)


@njit
def _highest(heights, corner, per_mm, place, radius, step):
    """Return the highest material on a circle about the tool's axis, sampled in every `step`-th direction."""
    found = -np.inf
    for k in range(0, len(AROUND), step):
        x, y = place[0] + radius * AROUND[k, 0], place[1] + radius * AROUND[k, 1]
        found = max(found, _height(heights, corner, per_mm, x, y))
    return found


@njit
def _highest_within(heights, corner, per_mm, place, radius, rim):
    """Return the highest material on rings up to a radius, and on the circle `rim`; none is sparser than the rim."""
    found = _highest(heights, corner, per_mm, place, rim, 1)
    for share, step in RINGS:
        found = max(found, _highest(heights, corner, per_mm, place, radius * share, step))
    return found


@njit
def _angle(heights, corner, cell, place, direction, radius, rise):
    """Return how many degrees of the rim's front half are in material `rise` over the tip."""
    found = 0.0
    radius -= INSIDE * cell
    least = place[2] + rise + MATERIAL_MM
    for k in range(len(AHEAD_OF)):
        cosine, sine = AHEAD_OF[k]
        x = place[0] + radius * (direction[0] * cosine - direction[1] * sine)
        y = place[1] + radius * (direction[0] * sine + direction[1] * cosine)
        if _height(heights, corner, 1.0 / cell, x, y) > least:
            found += ANGLE_STEP_DEG if 0 < k < len(AHEAD_OF) - 1 else 90.0 - WIDEST_DEG + ANGLE_STEP_DEG / 2
    return found


@njit
def _follow(heights, corner, cell, first, places, direction, cut_before, which, bodies, top, met):
    """Write the engagement at the places from `first` on to `met`; return how many places are cut out of the map.

    It is the angle, and the material over the tip in tool, wall and holder.
    """
    done, per_mm = 0, 1.0 / cell
    for k in range(first, len(places)):
        place, body = places[k], bodies[which[k]]
        while done < cut_before[k]:
            form = Form(bodies[which[done], 0], bodies[which[done], 1], bodies[which[done], 2], bodies[which[done], 3])
            if places[done, 2] < top:
                _cut(heights, corner, cell, places[done], form)
            done += 1
        if place[2] < top:
            form = Form(body[0], body[1], body[2], body[3])
            radius = body[0]
            if direction[k, 0] != 0.0 or direction[k, 1] != 0.0:
                rise = 0.0
                while radius > form.tip_mm + cell and height_at(radius, form) > top - place[2] - MATERIAL_MM:
                    radius -= cell
                if form.tip_mm < radius:
                    rise = height_at(radius, form)
                met[k - first, 0] = _angle(heights, corner, cell, place, direction[k], radius, rise)
            else:
                met[k - first, 0] = np.nan
            inner = max(body[0] - BESIDE * cell, 0.0)
            met[k - first, 1] = _highest_within(heights, corner, per_mm, place, inner, inner) - place[2]
            met[k - first, 2] = _highest(heights, corner, per_mm, place, body[0] + BESIDE * cell, 1) - place[2]
        if body[4] > 0.0 and body[5] > 0.0 and place[2] + body[5] < top:
            rim = body[4] - BESIDE * cell
            met[k - first, 3] = _highest_within(heights, corner, per_mm, place, body[4], rim) - place[2]
    return done
