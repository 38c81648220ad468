# SPDX-License-Identifier: LGPL-2.1-or-later
"""Kernels: what one arc or helix in the XY plane removes from a tile of cells.

Seen from the arc's centre a cell lies `out` mm away, and `turn` rad on from the arc's higher end; a helix
comes past it at turn, turn + 2 pi, ..., each time lower. A level arc is nearest there, or at its ends; a
helix that falls by `fall` mm a rad is lowest a little later, where one bounded minimum is looked for.
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit
from CNCStepper.simulation.cutter_solid import height_at
from CNCStepper.simulation.removal.line_kernels import lower, share_of
from CNCStepper.simulation.removal.row_kernels import columns_between

TURN = 2.0 * math.pi
SCANS = 12  # sample places of a pass before the best of them is refined
GOLDEN = 0.5 * (math.sqrt(5.0) - 1.0)
REFINEMENTS = 30


@njit
def falling(begin, end, arc):
    """Return the arc from its higher end: centre x, y; angle; sense; sweep; radii; height; fall a rad."""
    cx, cy, angle, sweep, r0, r1 = arc[0], arc[1], arc[2], arc[3], arc[4], arc[5]
    sense = 1.0 if sweep >= 0.0 else -1.0
    z0, z1 = begin[2], end[2]
    if z1 > z0:
        angle, sense = angle + sweep, -sense
        r0, r1, z0, z1 = r1, r0, z1, z0
    size = max(abs(sweep), 1e-12)
    return cx, cy, angle, sense, size, r0, r1, z0, (z0 - z1) / size


@njit
def bounds(begin, end, arc):
    """Return the smallest x and y and the largest x and y of the arc."""
    cx, cy, angle, sweep, r0, r1 = arc[0], arc[1], arc[2], arc[3], arc[4], arc[5]
    radius = max(r0, r1)
    x_low, x_high = min(begin[0], end[0]), max(begin[0], end[0])
    y_low, y_high = min(begin[1], end[1]), max(begin[1], end[1])
    sense = 1.0 if sweep >= 0.0 else -1.0
    for quarter in range(4):
        if ((quarter * 0.5 * math.pi - angle) * sense) % TURN <= abs(sweep):
            if quarter == 0:
                x_high = max(x_high, cx + radius)
            elif quarter == 1:
                y_high = max(y_high, cy + radius)
            elif quarter == 2:
                x_low = min(x_low, cx - radius)
            else:
                y_low = min(y_low, cy - radius)
    return x_low, y_low, x_high, y_high


@njit
def cut_arc(tile, grid, begin, end, arc, form):
    """Cut along one arc or helix; its row of `arcs` is `arc`."""
    x0, y0, dx, dy = grid
    heights, means, tops, bottom = tile
    rows, columns = heights.shape
    path = falling(begin, end, arc)
    wide = form[0] + 0.5 * (dx + dy)
    inside, outside = min(path[5], path[6]) - wide, max(path[5], path[6]) + wide
    low = min(begin[2], end[2])
    mean_low = max(low, bottom)
    x_low, y_low, x_high, y_high = bounds(begin, end, arc)
    first_row, last_row = columns_between(y_low - wide, y_high + wide, y0, 1.0 / dy, rows)
    first, last = columns_between(x_low - wide, x_high + wide, x0, 1.0 / dx, columns)
    for row in range(first_row, last_row + 1):
        y = y0 + row * dy - path[1]
        for column in range(first, last + 1):
            height, mean = float(heights[row, column]), float(means[row, column])
            if height <= low and mean <= mean_low:
                continue
            x = x0 + column * dx - path[0]
            out = math.sqrt(x * x + y * y)
            if inside <= out <= outside:
                cell = height, mean, float(tops[row, column]), bottom
                heights[row, column], means[row, column] = _below_arc(cell, (x, y, out), (dx, dy), path, form)


@njit
def _below_arc(cell, place, cell_size, path, form):
    """Return a cell's two heights after an arc; place: from the arc's centre, and its distance."""
    x, y, out = place
    _, _, angle, sense, size, r0, r1, z0, fall = path
    radius = form[0]
    turn = ((math.atan2(y, x) - angle) * sense) % TURN
    if turn <= size:
        near = turn + TURN * math.floor((size - turn) / TURN)
        r = r0 + (r1 - r0) * near / size
        distance = abs(out - r)
        east, north = x, y
    else:
        near, r = _nearer_end(out, turn, size, r0, r1)
        east = x - r * math.cos(angle + sense * near)
        north = y - r * math.sin(angle + sense * near)
        distance = math.sqrt(east * east + north * north)
    length = math.sqrt(east * east + north * north)
    across = cell_size[0] * abs(east) + cell_size[1] * abs(north)
    width = across / length if length > 0.0 else cell_size[0] + cell_size[1]
    share = share_of(distance, radius, width)
    if share <= 0.0:
        return cell[0], cell[1]
    if distance > radius:
        return lower(cell, z0 - fall * near + height_at(radius, form), False, share)
    if fall == 0.0:
        return lower(cell, z0 + height_at(distance, form), True, share)
    return lower(cell, z0 + _lowest(out, turn, size, r, fall, form), True, share)


@njit
def _nearer_end(out, turn, size, r0, r1):
    """Return how far along the arc its end nearer to the cell lies, and the radius there."""
    to_first = r0 * r0 - 2.0 * r0 * out * math.cos(turn)
    to_last = r1 * r1 - 2.0 * r1 * out * math.cos(turn - size)
    return (0.0, r0) if to_first <= to_last else (size, r1)


@njit
def _lowest(out, turn, size, r, fall, form):
    """Return the least height over the higher end that the helix has at the cell, on its last two passes there."""
    half = _half_pass(out, r, form[0])
    last = turn + TURN * math.floor((size - turn + half) / TURN)
    best = 1e30
    for middle in (last, last - TURN):
        first, end = max(-half, -middle), min(half, size - middle)
        if first <= end:
            best = min(best, _lowest_of_pass(out, r, fall, first, end, form) - fall * middle)
    return best


@njit
def _half_pass(out, r, radius):
    """Return the angle over which the cutter's radius covers the cell, before and after it is nearest."""
    product = 2.0 * r * out
    cosine = (r * r + out * out - radius * radius) / product if product > 1e-12 else -1.0
    return math.acos(min(max(cosine, -1.0), 1.0))


@njit
def _lowest_of_pass(out, r, fall, first, last, form):
    """Return the least of height - fall * angle over angles [first, last] from where the cutter is nearest."""
    first = max(first, min(0.0, last))  # until it is nearest both get lower
    best = min(_pass_height(out, r, fall, first, form), _pass_height(out, r, fall, last, form))
    if form[1] >= form[0] or first == last:
        return best
    step = (last - first) / SCANS
    place = 0
    for k in range(SCANS + 1):
        height = _pass_height(out, r, fall, first + k * step, form)
        if height <= best:
            best, place = height, k
    low, high = first + max(place - 1, 0) * step, first + min(place + 1, SCANS) * step
    return min(best, _golden(out, r, fall, low, high, form))


@njit
def _golden(out, r, fall, low, high, form):
    """Return the least height between two angles by golden section."""
    one, other = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
    at_one, at_other = _pass_height(out, r, fall, one, form), _pass_height(out, r, fall, other, form)
    for _ in range(REFINEMENTS):
        if at_one < at_other:
            high, other, at_other = other, one, at_one
            one = high - GOLDEN * (high - low)
            at_one = _pass_height(out, r, fall, one, form)
        else:
            low, one, at_one = one, other, at_other
            other = low + GOLDEN * (high - low)
            at_other = _pass_height(out, r, fall, other, form)
    return min(at_one, at_other)


@njit
def _pass_height(out, r, fall, angle, form):
    sine = math.sin(0.5 * angle)
    distance = math.sqrt((out - r) * (out - r) + 4.0 * out * r * sine * sine)
    return height_at(min(distance, form[0]), form) - fall * angle
