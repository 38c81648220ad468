# SPDX-License-Identifier: LGPL-2.1-or-later
"""Changes of speed whose acceleration rises and falls at a limited rate, the jerk.

    acceleration │    ┌────────┐              speed │            ____
                 │   /          \\                   │         /
                 │  /            \\                  │      /
                 └─/──────────────\\──► time         └____/──────────► time
                    A/J   hold   A/J     the greatest A is not reached where the change is below A²/J

A whole change begins and ends without acceleration and is symmetric about its middle, so that its mean speed
is that of its two ends, also where one of them lies below zero. mm, mm/s, mm/s², mm/s³.
"""

from __future__ import annotations

import math

from CNCStepper.kernels import njit_in_place


@njit_in_place
def change_time(change, acceleration, jerk):
    """Return how long a whole change of speed by `change` (any sign) takes, in s."""
    size = abs(change)
    if size * jerk <= acceleration**2:
        return 2.0 * math.sqrt(size / jerk)
    return size / acceleration + acceleration / jerk


@njit_in_place
def change_length(before, after, acceleration, jerk):
    """Return the way of a whole change from one speed to another, in mm."""
    return 0.5 * (before + after) * change_time(after - before, acceleration, jerk)


@njit_in_place
def reachable_speed(speed, length, acceleration, jerk):
    """Return the greatest speed that a whole change from `speed` reaches within `length`; the same backwards."""
    half = 0.5 * (speed / acceleration + 0.5 * acceleration / jerk)  # of the linear term of change²/2A + ... = 0
    rest = length - speed * acceleration / jerk
    if rest > 0.0:
        change = 2.0 * acceleration * (math.sqrt(half**2 + 0.5 * rest / acceleration) - half)
        if change * jerk >= acceleration**2:
            return speed + change
    return speed + _small_change(speed, length * math.sqrt(jerk))


@njit_in_place
def _small_change(speed, scaled):
    """Return x² of the positive root of x³ + 2 speed x = scaled: a change that does not reach the acceleration."""
    if speed * speed * speed <= 1e-12 * scaled * scaled:
        return scaled ** (2.0 / 3.0)
    third = math.sqrt(2.0 * speed / 3.0)
    root = 2.0 * third * math.sinh(math.asinh(0.5 * scaled / third**3) / 3.0)
    return root**2
