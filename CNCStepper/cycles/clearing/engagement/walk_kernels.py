# SPDX-License-Identifier: LGPL-2.1-or-later
r"""Kernels that plan on the map: where a walk begins, the walk itself, and the way along a wall.

A walk is a chain of short steps. Each step turns as far to the right, into the material, as the engagement allows
and the room lets it; where a wall or too much material lies ahead, it turns to the left:

        \  \  \                 engagement: the part of the rim's front half that meets material. There may be no
     ----->->-o  cleared        more of it on the left than on the right, or the walk would curl back.
    //////////\\
    material on the right

So walks run along the front of the material at the bound, spiral out of the opening, and peel corners and necks in
arcs: the next walk begins where the material begins along an earlier one.
"""

from __future__ import annotations

import math

from CNCStepper.cycles.clearing.engagement.map_kernels import cut, cut_until, engaged, value_at
from CNCStepper.kernels import njit

LEFTMOST = 2.7  # radians that a step may turn to the left
COARSE = 0.25  # radians between the directions that are tried first
BISECTIONS = 6
LEFT_SHARE = 0.5  # of the engagement, at most
TURN = 0.25  # of the radius: the sharpest turn to the right
IDLE_TURN = 0.8  # the same, where nothing is cut
BENT = 0.5  # radii over which the bend of the way is averaged
IDLE = 1.0  # radii to go on without clearing a node; what cuts nothing at the end is taken back
HALVINGS = 3  # of a step that has no direction
GAP = 8  # vertices without material beside them part two stretches


@njit
def _allowed(chart, x, y, angle, step, most):
    """Return whether a step in a direction stays in the room and within the engagement."""
    cosine, sine = math.cos(angle), math.sin(angle)
    if value_at(chart, chart.room, x + step * cosine, y + step * sine) < 0.0:
        return False
    for part in (1.0, 0.5):
        x_there, y_there = x + part * step * cosine, y + part * step * sine
        total, left = engaged(chart, x_there, y_there, cosine, sine, chart.radius, chart.thin)
        if total > most or left > LEFT_SHARE * total:
            return False
    return True


@njit
def _direction(chart, x, y, angle, step, right, most):
    """Return the rightmost direction allowed, from `right` to the right of `angle` on; NaN where there is none."""
    refused, tried = math.nan, angle - right
    while not _allowed(chart, x, y, tried, step, most):
        refused = tried
        tried += COARSE
        if tried > angle + LEFTMOST:
            return math.nan
    if math.isnan(refused):
        return tried
    for _ in range(BISECTIONS):
        middle = 0.5 * (refused + tried)
        if _allowed(chart, x, y, middle, step, most):
            tried = middle
        else:
            refused = middle
    return tried


@njit
def widened(most, more, bend):
    r"""Return the engagement that cuts no deeper on a bent way than `most` does on a straight one, radians.

           C    centre of the bend to the left, 1/bend from the tool's centre o
           |
           o    the rim meets the front at the angle t from the line C o:
           |\   (1/bend + 1 - a)^2 = 1/bend^2 + 1 + 2 cos t / bend, lengths in radii, so
        ___|_\__ front          cos t = 1 - a - bend a (1 - a/2)
        ///a/////              cos t = 1 - a    straight on

    At the same depth a the rim meets more where the front bends round it. At most `more` above `most`; a way that
    bends to the right counts as straight.
    """
    depth = 1.0 - math.cos(most)
    cosine = 1.0 - depth - max(bend, 0.0) * depth * (1.0 - 0.5 * depth)
    return min(math.acos(max(cosine, -1.0)), most + more)


@njit
def walk(chart, way, count, angle, right, longest, lag, most, more, front, met):
    """Walk on from the way's vertex `count` - 1; return its new count, how many nodes that clears, and how far it cuts.

    angle, right: of the first step, radians, and how far it may turn to the right. longest: of a step. lag: how much
    of the way behind the tool counts as not cut yet, or the rim's side would seem free. most, more: radians of
    engagement, and of what bends may have above it.
    """
    x, y = way[count - 1]
    useful, done, total, idled, pending, bend, cut_mm = count, count - 1, 0, 0.0, 0.0, 0.0, 0.0
    while count < len(way) and idled < IDLE * chart.radius:
        step, found, here = longest, math.nan, widened(most, more, bend)
        for _ in range(HALVINGS):
            found = _direction(chart, x, y, angle, step, right, here)
            if not math.isnan(found):
                break
            step *= 0.5
        if math.isnan(found):
            break
        bend += min(step / (BENT * chart.radius), 1.0) * ((found - angle) * chart.radius / step - bend)
        angle = found
        x, y = x + step * math.cos(angle), y + step * math.sin(angle)
        way[count, 0], way[count, 1] = x, y
        count += 1
        touching = engaged(chart, x, y, math.cos(angle), math.sin(angle), chart.radius, chart.thin)[0] > 0.0
        done, pending, cleared = cut_until(chart, way, done, count - 1, pending + step, lag, front, met)
        idled = 0.0 if cleared else idled + step
        total += cleared
        if touching:
            useful = count
            cut_mm += step
        elif cleared:
            useful = max(useful, done + 1)
        right = step / ((TURN if touching else IDLE_TURN) * chart.radius)
    total += cut_until(chart, way, done, useful - 1, math.inf, 0.0, front, met)[2]
    columns = chart.field.shape[1]
    for k in range(met[0]):
        row, column = front[k] // columns, front[k] % columns
        chart.vertex[row, column] = min(chart.vertex[row, column], useful - 1)
    return useful, total, cut_mm


@njit
def cut_to_node(chart, way, count, node, longest, most, front, met):
    """Step straight from the way's vertex `count` - 1 to a node until that is cleared; return the way's new count."""
    row, column = node // chart.field.shape[1], node % chart.field.shape[1]
    goal_x, goal_y = chart.x + column * chart.cell, chart.y + row * chart.cell
    while count < len(way) and chart.field[row, column] > chart.need[row, column]:
        x, y = way[count - 1]
        away = math.hypot(goal_x - x, goal_y - y)
        step = min(longest, away - chart.need[row, column] + 0.01 * chart.cell)
        if step <= 0.0:
            break
        cosine, sine = (goal_x - x) / away, (goal_y - y) / away
        way[count, 0], way[count, 1] = x + step * cosine, y + step * sine
        if value_at(chart, chart.room, way[count, 0], way[count, 1]) < 0.0:
            break
        if engaged(chart, way[count, 0], way[count, 1], cosine, sine, chart.radius, chart.thin)[0] > most:
            break
        cut(chart, x, y, way[count, 0], way[count, 1], count, front, met)
        count += 1
    return count


@njit
def start(chart, way, count, front, met, tried, tries, beside, x, y):
    """Return the flat number of a node to begin a walk at, -1 for none; nodes that are cleared leave the front.

    Of the way's stretches with material beside them, and not yet tried `tries` times, it is the first vertex of the
    one that begins nearest to (x, y). beside: int64 as long as the way, for the kernel's own use.
    """
    kept, columns = 0, chart.field.shape[1]
    beside[:count] = -1
    for k in range(met[0]):
        node = front[k]
        row, column = node // columns, node % columns
        if chart.field[row, column] > chart.need[row, column]:
            front[kept] = node
            kept += 1
            index = chart.vertex[row, column]
            if tried[index] < tries:
                old = beside[index]
                if old < 0 or chart.field[row, column] < chart.field[old // columns, old % columns]:
                    beside[index] = node
    met[0] = kept
    best, nearest, last = -1, math.inf, -GAP - 1
    for k in range(count):
        if beside[k] >= 0:
            if k - last > GAP:
                away = math.hypot(way[k, 0] - x, way[k, 1] - y)
                if away < nearest:
                    best, nearest = beside[k], away
            last = k
    return best


@njit
def _cut_step(chart, points, k, index, front, met):
    """Cut along the chain's step after point k and return its length."""
    ax, ay = points[k]
    bx, by = points[k + 1]
    cut(chart, ax, ay, bx, by, index, front, met)
    return math.hypot(bx - ax, by - ay)


@njit
def follow(chart, points, index, radius, thin, lag, front, met, angles):
    """Cut along a chain of points and write to `angles`, float64[n - 1], the engagement at each step's end."""
    done, pending = 0, 0.0
    for k in range(len(points) - 1):
        ax, ay = points[k]
        bx, by = points[k + 1]
        away = math.hypot(bx - ax, by - ay)
        pending += away
        if away > 0.0:
            angles[k] = engaged(chart, bx, by, (bx - ax) / away, (by - ay) / away, radius, thin)[0]
        while done <= k and pending > lag:
            pending -= _cut_step(chart, points, done, index, front, met)
            done += 1
    while done < len(points) - 1:
        _cut_step(chart, points, done, index, front, met)
        done += 1
