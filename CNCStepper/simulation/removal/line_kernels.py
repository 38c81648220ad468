# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: what one straight move removes from a tile of cells.

Along the move runs s, from 0 to its length; a cell's centre has its foot at s = foot and lies `beside`
the move. Where two lines join, the cells behind the joint belong to the first move alone and those
before it to the second; the wedge that a turn leaves between them is cut by the first from the joint:

      ______________ first's wedge
     |  first    |. / '.
     |-----------|-------> foot of the first
     |___________|\\   '.
              second '.  '.
"""

from __future__ import annotations

import math

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.simulation.cutter_solid import height_at, reach
from CNCStepper.simulation.removal.row_kernels import (
    AFTER_LAST,
    BEFORE_NEXT,
    FAR,
    between,
    columns_between,
    columns_of,
    inverse_of,
    place_of,
    strip_of,
)

JOINT_MM = 1e-6  # the two sides of a joint overlap by it, so that rounding leaves no cell between them


@njit
def lower(cell, z, covered, share):
    """Return a cell's two heights cut down to z: its centre where that is `covered`, and `share` of its area.

    cell: height, mean, top before all cuts, bottom of the stock. Both heights are the least of all cuts, so that the
    order of cuts does not matter. The kernels of a cell know no arrays: counting references would cost more.
    """
    height, mean, top, bottom = cell
    if covered and z < height:
        height = z
    z = max(z, bottom)
    if share < 1.0:
        z = share * z + (1.0 - share) * top
    return height, min(z, mean)


@njit
def stored(z):
    """Return a height as cells keep it: those that are as low are not changed by a cut down to z."""
    return float(np.float32(z))


@njit
def share_of(distance, radius, width):
    """Return how much of a cell of that `width` lies within `radius` of an axis, `distance` from its centre."""
    half = 0.5 * width
    return (min(half, radius - distance) + min(half, radius + distance)) / width


@njit
def cut_point(tile, grid, x, y, z, form):
    """Cut at one place of the axis."""
    x0, y0, dx, dy = grid
    heights, means, tops, bottom = tile
    rows, columns = heights.shape
    wide, mean_low = form[0] + 0.5 * (dx + dy), max(z, bottom)
    first, last = columns_between(y - wide, y + wide, y0, 1.0 / dy, rows)
    west, east = columns_between(x - wide, x + wide, x0, 1.0 / dx, columns)
    for row in range(first, last + 1):
        north = y0 + row * dy - y
        for column in range(west, east + 1):
            height, mean = float(heights[row, column]), float(means[row, column])
            if height <= z and mean <= mean_low:
                continue
            cell = height, mean, float(tops[row, column]), bottom
            cut = _below_point(cell, x0 + column * dx - x, north, dx, dy, z, form)
            heights[row, column], means[row, column] = cut


@njit
def _below_point(cell, east, north, dx, dy, z, form):
    radius = form[0]
    distance = math.sqrt(east * east + north * north)
    width = dx + dy if distance == 0.0 else (dx * abs(east) + dy * abs(north)) / distance
    share = share_of(distance, radius, width)
    if share <= 0.0:
        return cell[0], cell[1]
    return lower(cell, z + height_at(min(distance, radius), form), distance <= radius, share)


@njit
def cut_line(tile, grid, begin, end, following, joined, form):
    """Cut along one straight move; `following`: the end of the move after it, used where they are joined."""
    ax, ay, az = begin[0], begin[1], begin[2]
    length = math.hypot(end[0] - ax, end[1] - ay)
    if length == 0.0:
        cut_point(tile, grid, ax, ay, min(az, end[2]), form)
        return
    ux, uy, rise = (end[0] - ax) / length, (end[1] - ay) / length, (end[2] - az) / length
    vx, vy, next_rise = _direction(end, following) if joined & BEFORE_NEXT else (0.0, 0.0, 0.0)
    wide = form[0] + 0.5 * (grid[2] + grid[3])
    first, last = -wide, length + wide  # of the feet of the cells that this move cuts
    behind, before = 0.0, 0.0  # radii about its begin and its end within which it cuts more
    if joined & AFTER_LAST:
        strip, behind = reach(min(rise, 0.0), form)
        first = -JOINT_MM - strip
    if joined & BEFORE_NEXT:
        strip, before = reach(max(rise, next_rise, 0.0), form)
        last = length + JOINT_MM + strip
        if next_rise > 0.0:
            last += form[0] * math.hypot(vx - ux, vy - uy)
    turned = ux * vx + uy * vy, ux * vy - uy * vx, next_rise
    _cut_strip(tile, grid, (ax, ay, az, length, rise), (ux, uy), turned, (first, last, behind, before), joined, form)
    if vx != 0.0 or vy != 0.0:
        _cut_wedge(tile, grid, end, (ux, uy), (vx, vy), form)


@njit
def _direction(begin, end):
    """Return the direction in the plane from one place to another, and the slope; zeros straight up or down."""
    x, y = end[0] - begin[0], end[1] - begin[1]
    length = math.hypot(x, y)
    if length == 0.0:
        return 0.0, 0.0, 0.0
    return x / length, y / length, (end[2] - begin[2]) / length


@njit
def _cut_strip(tile, grid, move, direction, turned, feet, joined, form):
    """Cut the cells beside the move whose feet lie in the range `feet`, but for those left to its neighbours."""
    heights, means, tops, bottom = tile
    x0, y0, dx, dy = grid
    rows, columns = heights.shape
    if move[4] == 0.0 and feet[2] == 0.0 and feet[3] == 0.0:
        _cut_level(tile, grid, move, direction, feet, form)
        return
    low = move[2] + min(move[4] * move[3], 0.0)
    mean_low = max(low, bottom)
    strip = strip_of(move, direction, turned, feet, joined, form, dx, dy)
    first_row, last_row = columns_between(strip[0], strip[1], y0 - move[1], 1.0 / dy, rows)
    for row in range(first_row, last_row + 1):
        y = y0 + row * dy - move[1]
        west, skip, until, east = columns_of(y, x0 - move[0], columns, strip, move, direction, feet, form, dx, dy)
        for first, last in ((west, skip), (until, east)):
            for column in range(first, last + 1):
                height, mean = float(heights[row, column]), float(means[row, column])
                if height <= low and mean <= mean_low:
                    continue
                x = x0 + column * dx - move[0]
                cell = height, mean, float(tops[row, column]), bottom
                cut = _below_line(cell, x, y, dx, dy, move, direction, turned, joined, low, form)
                heights[row, column], means[row, column] = cut


@njit
def _cut_level(tile, grid, move, direction, feet, form):
    """Cut the cells beside a level move whose feet lie in a range, which is a rectangle: its rows are found quicker."""
    heights, means, tops, bottom = tile
    x0, y0, dx, dy = grid
    rows, columns = heights.shape
    ux, uy = direction
    low, mean_low = stored(move[2]), stored(max(move[2], bottom))
    wide = form[0] + 0.5 * (dx + dy)
    first_foot, last_foot = max(feet[0], -wide), min(feet[1], move[3] + wide)
    one, other = uy * first_foot, uy * last_foot
    first_row, last_row = columns_between(
        min(one, other) - wide * abs(ux), max(one, other) + wide * abs(ux), y0 - move[1], 1.0 / dy, rows
    )
    per_mm, by_ux, by_uy, begin = 1.0 / dx, inverse_of(ux), inverse_of(uy), x0 - move[0]
    half = abs(wide * by_uy) if by_uy != 0.0 else FAR
    for row in range(first_row, last_row + 1):
        y = y0 + row * dy - move[1]
        middle = y * ux * by_uy
        west, east = middle - half, middle + half
        if by_ux != 0.0:
            one, other = (first_foot - y * uy) * by_ux, (last_foot - y * uy) * by_ux
            west, east = max(west, min(one, other)), min(east, max(one, other))
        if west > east:
            continue
        first = math.ceil(min(max((west - begin) * per_mm, 0.0), float(columns)))
        last = math.floor(min(max((east - begin) * per_mm, -1.0), columns - 1.0))
        for column in range(first, last + 1):
            height, mean = float(heights[row, column]), float(means[row, column])
            if height <= low and mean <= mean_low:
                continue
            cell = height, mean, float(tops[row, column]), bottom
            x = x0 + column * dx - move[0]
            cut = _below_line(cell, x, y, dx, dy, move, direction, (0.0, 0.0, 0.0), 0, low, form)
            heights[row, column], means[row, column] = cut


@njit
def _below_line(cell, x, y, dx, dy, move, direction, turned, joined, low, form):
    """Return a cell's two heights after a move; `low`: the least height of the tip on it."""
    height, mean, _, bottom = cell
    _, _, az, length, rise = move
    radius = form[0]
    foot, beside = x * direction[0] + y * direction[1], x * direction[1] - y * direction[0]
    near = min(max(foot, 0.0), length)
    past = foot - near
    distance = abs(beside) if past == 0.0 else math.sqrt(beside * beside + past * past)
    if distance + 0.5 * (dx + dy) <= radius:
        share = 1.0
    else:
        across = abs(past * direction[0] + beside * direction[1]), abs(past * direction[1] - beside * direction[0])
        width = (dx * across[0] + dy * across[1]) / distance if distance > 0.0 else dx + dy
        share = share_of(distance, radius, width)
        if share <= 0.0:
            return height, mean
    if distance > radius:
        return lower(cell, az + rise * near + height_at(radius, form), False, share)
    if rise == 0.0:
        return lower(cell, az + height_at(distance, form), True, share)
    least = low + height_at(distance, form)
    if height <= least and mean <= max(least, bottom):
        return height, mean
    s = place_of(foot, beside, length, rise, turned, joined, form, dx + dy)
    if math.isnan(s):
        return height, mean
    out = min(math.sqrt(beside * beside + (s - foot) * (s - foot)), radius)
    return lower(cell, az + rise * s + height_at(out, form), True, share)


@njit
def _cut_wedge(tile, grid, joint, direction, turned, form):
    """Cut from the joint the cells past the first move's end that lie behind the second's begin.

    They lie on the outer side of the turn, between the normals of the two moves there.
    """
    x0, y0, dx, dy = grid
    heights, means, tops, bottom = tile
    rows, columns = heights.shape
    jx, jy, jz = joint[0], joint[1], joint[2]
    wide, low, mean_low = form[0] + 0.5 * (dx + dy), stored(jz), stored(max(jz, bottom))
    side = -wide if direction[0] * turned[1] - direction[1] * turned[0] > 0.0 else wide
    one, other = side * direction[0], side * turned[0]
    south, north = min(one, other, 0.0), max(one, other, 0.0)
    if direction[1] > 0.0 > turned[1]:
        north = wide
    if direction[1] < 0.0 < turned[1]:
        south = -wide
    first_row, last_row = columns_between(jy + south, jy + north, y0, 1.0 / dy, rows)
    per_mm, by_first, by_second = 1.0 / dx, inverse_of(direction[0]), inverse_of(turned[0])
    for row in range(first_row, last_row + 1):
        y = y0 + row * dy - jy
        west, east = between(by_first, y * direction[1], -JOINT_MM, wide, -wide, wide)
        west, east = between(by_second, y * turned[1], -wide, JOINT_MM, west, east)
        first, last = columns_between(west, east, x0 - jx, per_mm, columns)
        for column in range(first, last + 1):
            height, mean = float(heights[row, column]), float(means[row, column])
            if height <= low and mean <= mean_low:
                continue
            cell = height, mean, float(tops[row, column]), bottom
            cut = _below_point(cell, x0 + column * dx - jx, y, dx, dy, jz, form)
            heights[row, column], means[row, column] = cut
