# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which insert reaches a profile that the tool at hand does not, or which blade where none does, for refusals.

An insert of either hand needs the same room between a profile's steepest fall and its steepest rise; what differs is
the entering angle at which its holder sets it. A left-hand one comes from the chuck, over the end of the profile.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from CNCStepper.cycles.turning.turning_setup import TurningSetup
from CNCStepper.errors import Text
from CNCStepper.geometry.curve import Curve
from CNCStepper.machine.tools.insert_code import NOSE_ANGLES_DEG
from CNCStepper.tolerances import SAME_EDGE_DEG, SAME_MM

USUAL_LEAD_DEG = (90.0, 107.5)  # entering angles of the usual holders for profiles
STEEP_LEAD_DEG = (45.0, 90.0)  # of holders that there are besides
SHAPES = "CTDV"  # of the usual inserts, the strongest nose first
CHORDS_MM = 1e-3
LEAST_BLADE_MM = 0.5


class Choice(NamedTuple):
    """An insert by the letter of its shape, and the entering angles between which it reaches the profile."""

    shape: str
    low_deg: float
    high_deg: float
    is_left: bool = False

    def words(self) -> Text:
        """Return it as an advice."""
        right = "use an insert {shape} ({nose:g} deg) at an entering angle of {low:.4g} to {high:.4g} deg"
        left = "use a left-hand insert {shape} ({nose:g} deg) at an entering angle of {low:.4g} to {high:.4g} deg"
        nose = NOSE_ANGLES_DEG[self.shape]
        return Text(left if self.is_left else right, shape=self.shape, nose=nose, low=self.low_deg, high=self.high_deg)


def advice(profile: Curve, setup: TurningSetup, side: float, rising: float, falling: float) -> Text:
    """Return which insert or blade reaches a framed profile; rising, falling: its steepest stretches, from +z, deg."""
    right = _choices(180.0 - rising, 180.0 - falling)
    is_open = side > 0 and not setup.is_mirrored and profile.xy[-1, 1] >= setup.radius_mm - SAME_MM
    left = [one._replace(is_left=True) for one in _choices(falling, rising)] if is_open else []
    usual = next(_within(USUAL_LEAD_DEG, [*right, *left]), None)
    found = usual or next(_within(STEEP_LEAD_DEG, right), None)
    return found.words() if found else _blade_words(profile, setup, side, rising - falling)


def _choices(low_deg: float, most_deg: float) -> list[Choice]:
    """Return the usual inserts that fit; most_deg: where the entering angle and the nose's end together at most."""
    every = [Choice(shape, low_deg, most_deg - NOSE_ANGLES_DEG[shape]) for shape in SHAPES]
    return [one for one in every if one.low_deg <= one.high_deg + SAME_EDGE_DEG]


def _within(leads_deg: tuple[float, float], choices: list[Choice]) -> Iterator[Choice]:
    least, most = leads_deg
    return (one for one in choices if one.low_deg <= most and one.high_deg >= least)


def _blade_words(profile: Curve, setup: TurningSetup, side: float, room_deg: float) -> Text:
    width_mm, floor_mm = narrowest_floor(profile)
    if width_mm < LEAST_BLADE_MM:
        what = "no usual insert fits between its walls: it must fill {room:.4g} deg or less; draw them less steep"
        return Text(what, room=max(room_deg, 0.0))
    deep_mm = (setup.radius_mm if side > 0 else -setup.bore_mm / 2) - floor_mm
    what = "no insert reaches both its walls: cut it with a blade of {width:.4g} mm or narrower, {deep:.4g} mm deep"
    return Text(what, width=width_mm, deep=deep_mm)


def narrowest_floor(profile: Curve) -> tuple[float, float]:
    """Return the width and the height of a framed profile's narrowest floor between a fall and a rise, or its end."""
    z, r = profile.points(CHORDS_MM).T
    found: list[tuple[float, float]] = [(np.inf, 0.0)]
    foot: int | None = None
    for at in range(1, len(z)):
        if r[at] < r[at - 1] - SAME_MM:
            foot = at
        elif r[at] > r[at - 1] + SAME_MM and foot is not None:
            found.append((z[foot] - z[at - 1], r[foot]))
            foot = None
    if foot is not None:
        found.append((z[foot] - z[-1], r[foot]))
    width_mm, height_mm = min(found)
    return float(width_mm), float(height_mm)
