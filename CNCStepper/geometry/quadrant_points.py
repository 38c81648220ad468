# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where along an arc the axes of its plane turn back: at its quarter points.

        Y turns back
           ___
         /     \\
        |   +   |  X turns back
         \\ ___ /
"""

from __future__ import annotations

import math

QUARTER = math.pi / 2


def turning_points(
    begin: tuple[float, float], centre: tuple[float, float], swept_rad: float, least: tuple[float, float]
) -> list[float]:
    """Return the swept angles, rising, at which an axis of the plane turns back; `swept_rad` > 0 is counter-clockwise.

    An extreme is left out where its axis comes less than `least` (of either axis, mm) from the arc's begin or end:
    the motor does not turn back there, and no piece of an arc becomes so short that it could be taken for a circle.
    """
    u, v = begin[0] - centre[0], begin[1] - centre[1]
    radius, angle = math.hypot(u, v), math.atan2(v, u)
    sign = 1.0 if swept_rad > 0 else -1.0
    whole = abs(swept_rad)
    found = []
    number = math.floor(sign * angle / QUARTER) + 1
    while (swept := number * QUARTER - sign * angle) < whole:
        axis = number % 2  # even: on the first axis, which turns back there
        to_ends = (min(swept, math.pi), min(whole - swept, math.pi))
        if min(radius * (1.0 - math.cos(way)) for way in to_ends) >= least[axis] > 0:
            found.append(swept)
        number += 1
    return found


def point_on_arc(
    begin: tuple[float, float],
    end: tuple[float, float],
    centre: tuple[float, float],
    swept_rad: float,
    share: float,
) -> tuple[float, float]:
    """Return the point after a share of the sweep; the radius goes evenly from the begin's to the end's."""
    u, v = begin[0] - centre[0], begin[1] - centre[1]
    last = math.hypot(end[0] - centre[0], end[1] - centre[1])
    radius = math.hypot(u, v) * (1.0 - share) + last * share
    angle = math.atan2(v, u) + swept_rad * share
    return centre[0] + radius * math.cos(angle), centre[1] + radius * math.sin(angle)
