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

from CNCStepper.kernels import njit
from CNCStepper.simulation.form import height_at, lead, reach

AFTER_LAST, BEFORE_NEXT = 1, 2  # bits of `joined`, as in removal_moves
FAR = 1e30
JOINT_MM = 1e-6  # the two sides of a joint overlap by it, so that rounding leaves no cell between them


@njit
def lower(tile, row, column, z, covered, share):
    """Cut one cell down to z: its centre where that is `covered`, and `share` of its area, else as high as it was.

    Both numbers that a cell holds are the least of all cuts, so that the order of cuts does not matter.
    """
    heights, means, tops, bottom = tile
    if covered and z < heights[row, column]:
        heights[row, column] = z
    z = max(z, bottom)
    if share < 1.0:
        z = share * z + (1.0 - share) * float(tops[row, column])
    if z < means[row, column]:
        means[row, column] = z


@njit
def share_of(distance, radius, width):
    """Return how much of a cell of that `width` lies within `radius` of an axis, `distance` from its centre."""
    half = 0.5 * width
    return (min(half, radius - distance) + min(half, radius + distance)) / width


@njit
def inverse_of(factor):
    """Return 1 / factor, or 0 for a factor that is as good as 0."""
    return 0.0 if abs(factor) < 1e-12 else 1.0 / factor


@njit
def between(inverse, offset, low, high, first, last):
    """Narrow the range [first, last] of x to where low <= x / inverse + offset <= high; inverse 0: x plays no part."""
    if inverse == 0.0:
        return (first, last) if low <= offset <= high else (1.0, 0.0)
    one, other = (low - offset) * inverse, (high - offset) * inverse
    return max(first, min(one, other)), min(last, max(one, other))


@njit
def columns_between(first, last, x0, per_mm, columns):
    """Return the first and the last column whose centres lie in [first, last]; x0 is that of column 0."""
    if first > last:
        return 0, -1
    first = min(max((first - x0) * per_mm, 0.0), float(columns))
    last = min(max((last - x0) * per_mm, -1.0), columns - 1.0)
    return math.ceil(first), math.floor(last)


@njit
def cut_point(tile, grid, x, y, z, form):
    """Cut at one place of the axis."""
    x0, y0, dx, dy = grid
    rows, columns = tile[0].shape
    wide = form[0] + 0.5 * (dx + dy)
    first, last = columns_between(y - wide, y + wide, y0, 1.0 / dy, rows)
    west, east = columns_between(x - wide, x + wide, x0, 1.0 / dx, columns)
    for row in range(first, last + 1):
        for column in range(west, east + 1):
            _cut_from_point(tile, grid, row, column, x, y, z, form)


@njit
def _cut_from_point(tile, grid, row, column, x, y, z, form):
    x0, y0, dx, dy = grid
    radius = form[0]
    east, north = x0 + column * dx - x, y0 + row * dy - y
    distance = math.sqrt(east * east + north * north)
    width = dx + dy if distance == 0.0 else (dx * abs(east) + dy * abs(north)) / distance
    share = share_of(distance, radius, width)
    if share > 0.0:
        lower(tile, row, column, z + height_at(min(distance, radius), form), distance <= radius, share)


@njit
def cut_line(tile, grid, begin, end, following, joined, form):
    """Cut along one straight move; `following`: the end of the move after it, used where they are joined."""
    ax, ay, az = begin[0], begin[1], begin[2]
    length = math.hypot(end[0] - ax, end[1] - ay)
    if length == 0.0:
        cut_point(tile, grid, ax, ay, min(az, end[2]), form)
        return
    direction = (end[0] - ax) / length, (end[1] - ay) / length
    rise = (end[2] - az) / length
    out = math.hypot(following[0] - end[0], following[1] - end[1]) if joined & BEFORE_NEXT else 0.0
    wide = form[0] + 0.5 * (grid[2] + grid[3])
    furthest = reach(rise, form)
    first, last = -wide, length + wide  # of the feet of the cells that this move cuts
    if joined & AFTER_LAST:
        first = -JOINT_MM - (furthest if rise < 0.0 else 0.0)
    if joined & BEFORE_NEXT:
        last = length + JOINT_MM + (furthest if rise > 0.0 else 0.0)
    _cut_strip(tile, grid, (ax, ay, az, length, rise), direction, (first, last), form)
    if out > 0.0:
        turned = (following[0] - end[0]) / out, (following[1] - end[1]) / out
        _cut_wedge(tile, grid, end, direction, turned, form)


@njit
def _cut_strip(tile, grid, move, direction, feet, form):
    """Cut the cells beside the move whose feet lie in the range `feet`."""
    ax, ay, az, length, rise = move
    ux, uy = direction
    x0, y0, dx, dy = grid
    heights, means, _, bottom = tile
    rows, columns = heights.shape
    wide = form[0] + 0.5 * (dx + dy)
    low = az + min(rise * length, 0.0)
    mean_low = max(low, bottom)
    y_low, y_high = ay + min(uy * length, 0.0) - wide, ay + max(uy * length, 0.0) + wide
    first_row, last_row = columns_between(y_low, y_high, y0, 1.0 / dy, rows)
    per_mm, by_ux, by_uy = 1.0 / dx, inverse_of(ux), inverse_of(uy)
    for row in range(first_row, last_row + 1):
        y = y0 + row * dy - ay
        west, east = between(by_ux, y * uy, feet[0], feet[1], -FAR, FAR)
        west, east = between(by_uy, -y * ux, -wide, wide, west, east)
        first, last = columns_between(west, east, x0 - ax, per_mm, columns)
        for column in range(first, last + 1):
            if heights[row, column] <= low and means[row, column] <= mean_low:
                continue
            x = x0 + column * dx - ax
            _cut_from_line(tile, grid, row, column, x * ux + y * uy, x * uy - y * ux, move, direction, form)


@njit
def _cut_from_line(tile, grid, row, column, foot, beside, move, direction, form):
    _, _, az, length, rise = move
    radius = form[0]
    near = min(max(foot, 0.0), length)
    past = foot - near
    distance = abs(beside) if past == 0.0 else math.sqrt(beside * beside + past * past)
    if distance + 0.5 * (grid[2] + grid[3]) <= radius:
        share = 1.0
    else:
        across = abs(past * direction[0] + beside * direction[1]), abs(past * direction[1] - beside * direction[0])
        width = (grid[2] * across[0] + grid[3] * across[1]) / distance if distance > 0.0 else grid[2] + grid[3]
        share = share_of(distance, radius, width)
        if share <= 0.0:
            return
    if distance > radius:
        lower(tile, row, column, az + rise * near + height_at(radius, form), False, share)
        return
    s, out = near, distance
    if rise != 0.0:
        half = math.sqrt(max(radius * radius - beside * beside, 0.0))
        s = min(max(foot + lead(beside, rise, form), foot - half, 0.0), foot + half, length)
        out = min(math.sqrt(beside * beside + (s - foot) * (s - foot)), radius)
    lower(tile, row, column, az + rise * s + height_at(out, form), True, share)


@njit
def _cut_wedge(tile, grid, joint, direction, turned, form):
    """Cut from the joint the cells past the first move's end that lie behind the second's begin."""
    x0, y0, dx, dy = grid
    rows, columns = tile[0].shape
    jx, jy, jz = joint[0], joint[1], joint[2]
    wide = form[0] + 0.5 * (dx + dy)
    first_row, last_row = columns_between(jy - wide, jy + wide, y0, 1.0 / dy, rows)
    per_mm, by_first, by_second = 1.0 / dx, inverse_of(direction[0]), inverse_of(turned[0])
    for row in range(first_row, last_row + 1):
        y = y0 + row * dy - jy
        west, east = between(by_first, y * direction[1], -JOINT_MM, wide, -wide, wide)
        west, east = between(by_second, y * turned[1], -wide, JOINT_MM, west, east)
        first, last = columns_between(west, east, x0 - jx, per_mm, columns)
        for column in range(first, last + 1):
            _cut_from_point(tile, grid, row, column, jx, jy, jz, form)
