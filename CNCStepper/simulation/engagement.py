# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much of the tool is in the material along the path, measured in a map of heights while it is cut.

      ,-----.            The rim is looked at half a radius ahead of what counts as cut: that is
 ____/ tool  \\_____      wide enough for the map's cells. So the engagement angle is good to about
////|    o -> |/////     15 degrees, the heights are those of the cut itself.
/////\\       /////// material
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from CNCStepper.kernels import COMPILED, njit
from CNCStepper.machine.tool import Tool
from CNCStepper.simulation.cutter import BEAM, Tools, tool_numbered
from CNCStepper.simulation.form import Form, form_of, height_at
from CNCStepper.simulation.segments import Segments, segments
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import Toolpath

CELLS_A_RADIUS = 16
FEWEST_CELLS = 10  # a radius, for the angle to mean anything
MOST_CELLS = 16_000_000 if COMPILED else 250_000
AHEAD = 0.5  # of the radius: what is cut later than this behind the tool counts as standing
PLACES_A_RADIUS = 4
ANGLE_STEP_DEG = 5.0
WIDEST_DEG = 80.0  # to each side; beyond it the cells cannot tell the side from the front
MATERIAL_MM = 0.01  # higher above the tool's profile is material
RINGS = ((0.3, 3), (0.6, 2), (0.9, 1))  # of the radius, where material inside a tool or holder is looked for; and step
INSIDE = 0.75  # cells from the rim, inwards, where the angle is measured: a rim that only touches meets nothing
AROUND = np.array([(np.cos(turn), np.sin(turn)) for turn in np.arange(72) * np.pi / 36])
BESIDE = 1.5  # cells from the rim, inwards for what is cut and outwards for the wall beside
TURNS_DEG = np.arange(-WIDEST_DEG, WIDEST_DEG + ANGLE_STEP_DEG / 2, ANGLE_STEP_DEG)
AHEAD_OF = np.array([(np.cos(turn), np.sin(turn)) for turn in np.radians(TURNS_DEG)])


@dataclass(frozen=True)
class Engagement:
    """What was met at k places of the tip along the path, in their order.

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
    """Return what the tools meet in the stock; rows whose tool is not known, and beams, cut nothing here."""
    path = segments(toolpath, 0.01).known()
    numbers = np.array([state.tool for state in toolpath.states], int)[toolpath.table().state[path.row]]
    used = {number: tool_numbered(tools, number) for number in np.unique(numbers).tolist()}
    known = {number: tool for number, tool in used.items() if tool is not None and tool.shape not in BEAM}
    path, numbers = path[np.isin(numbers, list(known))], numbers[np.isin(numbers, list(known))]
    if not len(path):
        return Engagement(np.zeros(0, np.int64), np.zeros((0, 3)), *(np.zeros(0),) * 4, 0.0)
    order = list(known)
    which = np.searchsorted(order, numbers)
    radii = np.array([known[number].radius_mm for number in order])
    pieces, which = _short(path, which, radii)
    heights, corner, cell_mm = _map(stock, pieces, list(known.values()))
    step = (pieces.end - pieces.begin)[:, :2]
    length = np.hypot(*step.T)
    direction = step / np.where(length > 0, length, 1.0)[:, None]
    bodies = np.array([_body(known[number]) for number in order])
    met = np.full((len(pieces), 4), -np.inf)
    _follow(
        heights,
        corner,
        cell_mm,
        np.ascontiguousarray(pieces.end),
        direction,
        _cut_before(pieces, length, which, AHEAD * radii),
        which,
        bodies,
        stock.top_mm,
        met,
    )
    met[radii[which] < FEWEST_CELLS * cell_mm, 0] = np.nan
    return Engagement(pieces.row, pieces.end, met[:, 0], met[:, 1], met[:, 2], met[:, 3], cell_mm)


def _body(tool: Tool) -> tuple[float, ...]:
    """Return a tool's form, and its holder's radius and height over the tip."""
    return (*form_of(tool), tool.holder_diameter_mm / 2, tool.length_mm)


def _short(path: Segments, which: np.ndarray, radii: np.ndarray) -> tuple[Segments, np.ndarray]:
    """Return the path in pieces short against the tool's radius; the places are their ends."""
    length = np.linalg.norm(path.end - path.begin, axis=1)
    counts = np.maximum(np.ceil(length / radii[which] * PLACES_A_RADIUS), 1).astype(np.int64)
    level = np.hypot(*(path.end - path.begin)[:, :2].T) > 0
    counts = np.where(level, counts, 1)  # straight down or up only the end counts
    index = np.repeat(np.arange(len(path)), counts)
    step = np.arange(len(index)) - np.repeat(np.cumsum(counts) - counts, counts)
    delta = (path.end - path.begin)[index] / counts[index][:, None]
    begin = path.begin[index] + delta * step[:, None]
    return Segments(begin, begin + delta, path.row[index]), which[index]


def _map(stock: Stock, pieces: Segments, tools: list[Tool]) -> tuple[np.ndarray, np.ndarray, float]:
    """Return the heights of the stock where the path can reach, its low corner and the side of a cell."""
    reach = max(max(tool.diameter_mm, tool.holder_diameter_mm) / 2 for tool in tools)
    low = np.maximum(pieces.end[:, :2].min(axis=0) - reach, stock.low_mm[:2])
    high = np.minimum(pieces.end[:, :2].max(axis=0) + reach, stock.high_mm[:2])
    size = np.maximum(high - low, 1e-3)
    fine = min(tool.radius_mm for tool in tools) / CELLS_A_RADIUS
    cell = max(fine, float(np.sqrt(size[0] * size[1] / MOST_CELLS)))
    x, y = (low[k] + cell * (np.arange(int(np.ceil(size[k] / cell))) + 0.5) for k in range(2))
    tops = stock.tops_mm(x, y)
    tops[stock.shares(x, y, (cell, cell)) <= 0.0] = -np.inf
    return tops.astype(np.float32), low, cell


def _cut_before(pieces: Segments, length: np.ndarray, which: np.ndarray, ahead: np.ndarray) -> np.ndarray:
    """Return how many of the places are cut before each is measured: those that lie `ahead` behind it."""
    joined = np.r_[False, (pieces.begin[1:] == pieces.end[:-1]).all(axis=1) & (which[1:] == which[:-1])]
    straight = length > 0
    first = ~joined | ~straight | np.r_[True, ~straight[:-1]]
    chain = np.maximum.accumulate(np.where(first, np.arange(len(pieces)), 0))
    done = np.cumsum(length)
    behind = np.searchsorted(done, done - ahead[which], side="right")
    return np.maximum(behind, chain)


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
    """Return the highest material on a circle about the tool's axis, looked at in every `step`-th direction."""
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
def _follow(heights, corner, cell, places, direction, cut_before, which, bodies, top, met):
    """Write to `met` what is met at every place: angle, and the material over the tip in tool, wall and holder."""
    done, per_mm = 0, 1.0 / cell
    for k in range(len(places)):
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
                met[k, 0] = _angle(heights, corner, cell, place, direction[k], radius, rise)
            else:
                met[k, 0] = np.nan
            inner = max(body[0] - BESIDE * cell, 0.0)
            met[k, 1] = _highest_within(heights, corner, per_mm, place, inner, inner) - place[2]
            met[k, 2] = _highest(heights, corner, per_mm, place, body[0] + BESIDE * cell, 1) - place[2]
        if body[4] > 0.0 and body[5] > 0.0 and place[2] + body[5] < top:
            rim = body[4] - BESIDE * cell
            met[k, 3] = _highest_within(heights, corner, per_mm, place, body[4], rim) - place[2]
