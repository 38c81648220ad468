# SPDX-License-Identifier: LGPL-2.1-or-later
r"""The map that clearing at bounded engagement is planned on: distances on a grid, and kernels that read and cut it.

    field[row, column]   distance of a node from the way so far, at most `far`: what is nearer than the radius is cut
    vertex[row, column]  the number of the way's vertex that is nearest
    need[row, column]    a node is cleared where field <= need; where nothing is wanted it is above `far`
    room[row, column]    how far inside the room of the tool's centre a node lies, negative outside, within +-far

A distance changes by no more than one moves, so it is interpolated to about cell²/(8 radius) between the nodes; and
a tool that is wider than `radius` by 0.75 cells has cleared everything between nodes that are cleared.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from CNCStepper.kernels import njit

FRONT = 40  # intervals of the rim's front half, from its right to its left
SIDES = np.array([(math.cos(turn), math.sin(turn)) for turn in np.linspace(-math.pi / 2, math.pi / 2, FRONT + 1)])


class Map(NamedTuple):
    """The grid's fields, float32[rows, columns] but vertex, int32; x_mm, y_mm: of its first node; the rest in mm too.

    radius: of the tool that is planned with. thin: a chip below that is no engagement.
    """

    field: np.ndarray
    vertex: np.ndarray
    need: np.ndarray
    room: np.ndarray
    x: float
    y: float
    cell: float
    far: float
    radius: float
    thin: float


@njit
def value_at(chart, layer, x, y):
    """Return a layer of the map between its nodes, bilinearly."""
    across, up = (x - chart.x) / chart.cell, (y - chart.y) / chart.cell
    column = min(max(int(across), 0), layer.shape[1] - 2)
    row = min(max(int(up), 0), layer.shape[0] - 2)
    across, up = across - column, up - row
    low = layer[row, column] * (1.0 - across) + layer[row, column + 1] * across
    high = layer[row + 1, column] * (1.0 - across) + layer[row + 1, column + 1] * across
    return low * (1.0 - up) + high * up


@njit
def nodes(origin, cell, count, low, high):
    """Return the first node not below `low`, and one past the last that is not above `high`."""
    return max(math.ceil((low - origin) / cell), 0), min(math.floor((high - origin) / cell) + 1, count)


@njit
def square_from(x, y, dx, dy, square):
    """Return the squared distance of a point from the segment that begins at the origin with the chord d."""
    if square > 0.0:
        share = min(max((x * dx + y * dy) / square, 0.0), 1.0)
        x, y = x - share * dx, y - share * dy
    return x * x + y * y


@njit
def spread(layer, x0, y0, cell, far, points):
    """Lower a layer to the distance from a chain of points, float64[n, 2], where that is below `far`."""
    for k in range(len(points) - 1):
        ax, ay = points[k]
        dx, dy = points[k + 1, 0] - ax, points[k + 1, 1] - ay
        square = dx * dx + dy * dy
        first, last = nodes(y0, cell, layer.shape[0], min(ay, ay + dy) - far, max(ay, ay + dy) + far)
        begin, end = nodes(x0, cell, layer.shape[1], min(ax, ax + dx) - far, max(ax, ax + dx) + far)
        for row in range(first, last):
            y = y0 + row * cell - ay
            for column in range(begin, end):
                away = square_from(x0 + column * cell - ax, y, dx, dy, square)
                if away < layer[row, column] * layer[row, column]:
                    layer[row, column] = math.sqrt(away)


@njit
def flip_inside(inside, x0, y0, cell, points):
    """Flip for every node whether it is inside, where a closed chain of points runs to its right."""
    for k in range(len(points) - 1):
        ax, ay = points[k]
        bx, by = points[k + 1]
        low, high = min(ay, by), max(ay, by)
        first, last = nodes(y0, cell, inside.shape[0], low, high)
        for row in range(first, last):
            y = y0 + row * cell
            if y < high:
                x = ax + (bx - ax) * (y - ay) / (by - ay)
                end = min(max(math.ceil((x - x0) / cell), 0), inside.shape[1])
                for column in range(end):
                    inside[row, column] = not inside[row, column]


@njit
def cut(chart, ax, ay, bx, by, index, front, met):
    """Lower the field along one step that ends at the way's vertex `index`; return how many nodes that has cleared.

    front, met: the wanted nodes that the way has come near to, as flat numbers, and how many these are, in met[0].
    """
    field, far, cell = chart.field, chart.far, chart.cell
    dx, dy = bx - ax, by - ay
    square = dx * dx + dy * dy
    first, last = nodes(chart.y, cell, field.shape[0], min(ay, by) - far, max(ay, by) + far)
    cleared = 0
    for row in range(first, last):
        y = chart.y + row * cell
        beside = max(y - max(ay, by), min(ay, by) - y, 0.0)
        half = math.sqrt(max(far * far - beside * beside, 0.0))
        begin, end = nodes(chart.x, cell, field.shape[1], min(ax, bx) - half, max(ax, bx) + half)
        for column in range(begin, end):
            old = field[row, column]
            away = square_from(chart.x + column * cell - ax, y - ay, dx, dy, square)
            if away < old * old:
                away = math.sqrt(away)
                wanted = chart.need[row, column]
                if old > wanted and away <= wanted:
                    cleared += 1
                if chart.vertex[row, column] < 0 and wanted < far:
                    front[met[0]] = row * field.shape[1] + column
                    met[0] += 1
                field[row, column] = away
                chart.vertex[row, column] = index
    return cleared


@njit
def cut_until(chart, way, done, last, pending, lag, front, met):
    """Cut the way's steps after vertex `done` up to `last`, but for `lag` of their length `pending`.

    Returns the vertex that is reached, what is pending there, and how many nodes that has cleared.
    """
    cleared = 0
    while done < last:
        ax, ay = way[done]
        bx, by = way[done + 1]
        step = math.hypot(bx - ax, by - ay)
        if pending - step < lag:
            break
        cleared += cut(chart, ax, ay, bx, by, done + 1, front, met)
        pending -= step
        done += 1
    return done, pending, cleared


@njit
def engaged(chart, x, y, cosine, sine, radius, thin):
    """Return how much of the front half of a rim, in radians, is at chips thicker than `thin`, and that on the left.

    A chip is as thick as the field at the rim exceeds the radius, before the step to (x, y) is cut.
    """
    total, before, on_right = 0.0, 0.0, 0.0
    for k in range(len(SIDES)):
        ahead, aside = SIDES[k]
        rim_x = x + radius * (cosine * ahead - sine * aside)
        rim_y = y + radius * (sine * ahead + cosine * aside)
        chip = value_at(chart, chart.field, rim_x, rim_y) - radius - thin
        if k > 0:
            if chip > 0.0 and before > 0.0:
                total += 1.0
            elif chip > 0.0:
                total += chip / (chip - before)
            elif before > 0.0:
                total += before / (before - chip)
        before = chip
        if k == FRONT // 2:
            on_right = total
    return total * math.pi / FRONT, (total - on_right) * math.pi / FRONT
