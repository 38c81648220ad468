# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cutter for the exact judge: a solid of revolution about the tool's axis, by its form.

     radius                        beside
|<----------->|              +------------------>  from the axis to a point
|             |              |
|            .'   height     |  cutter
|         .-'                '----.
'--------'  tip               drop|  gap
                                  x   the point, below the tip

Its profile is the tool's `Form` (`machine/tools/tool_profile.py`), which is convex and never falls. The kernels give
the height over the tip at a radius; along a straight move the lowest height over a point is therefore one minimum,
and `lead` is its place.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from CNCStepper.kernels import njit
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import Form

NEWTON = 60  # steps at most; three are usual
WIDER = 1.01  # factor on a result of precision `CLOSE` where it must be an upper bound
CLOSE = 1e-2  # a step of that share is the last: the next would be its square, and the height is at its minimum


@njit
def height_at(distance, form):
    """Return the height of the cutter over its tip at a distance from its axis, at most its radius."""
    _, tip, corner, slope = form
    beyond = distance - tip
    if beyond <= 0.0:
        return 0.0
    if corner > 0.0:
        return corner - math.sqrt(max(corner * corner - beyond * beyond, 0.0))
    return beyond * slope


@njit
def reach(rise, form):
    """Return two lengths: a cell that has a `lead` l on a move of slope `rise`, l mm behind the tip or ahead of it,

    lies there at most the first away, or within the second of the tip.
    """
    radius, tip, corner, slope = form
    steep = abs(rise)
    if steep == 0.0:
        return 0.0, 0.0
    if corner > 0.0:
        plain = tip + corner * steep / math.sqrt(1.0 + steep * steep)
        if tip == 0.0:
            return plain, 0.0
        beside = WIDER * _corner_lead(plain, steep, tip, corner)
        return beside, math.sqrt(plain * plain + beside * beside)
    if slope > steep:
        return radius * steep / slope, tip
    return 0.0, radius


@njit
def lead(beside, rise, form):
    """Return how far along a move of slope `rise` from the foot of a point `beside` it the cutter is lowest.

    Positive ahead (the move falls), negative behind (it climbs). There the profile's slope along the
    move is as steep as the move itself, or its floor ends.
    """
    radius, tip, corner, slope = form
    steep = abs(rise)
    if steep == 0.0:
        return 0.0
    if corner > 0.0:
        ahead = _corner_lead(abs(beside), steep, tip, corner)
    else:
        ahead = math.sqrt(max(tip * tip - beside * beside, 0.0))
        if slope > steep:
            ahead = max(ahead, steep * abs(beside) / math.sqrt(slope * slope - steep * steep))
        elif slope > 0.0:
            ahead = radius
    return ahead if rise < 0.0 else -ahead


@njit
def _corner_lead(beside, steep, tip, corner):
    """Return where the round corner touches its envelope: at the angle of cosine c from the move's direction

    it does so at the radius out = tip + corner * steep / sqrt(steep² + c²), as far beside as out * sqrt(1 - c²).
    The square of c is looked for by Newton's method between bounds: out lies between its value at c = 1 and tip +
    corner, and is at least `beside`.
    """
    if tip == 0.0:
        return steep * math.sqrt(max(corner * corner - beside * beside, 0.0)) / math.sqrt(1.0 + steep * steep)
    if beside >= tip + corner:
        return 0.0
    least = tip + corner * steep / math.sqrt(1.0 + steep * steep)
    low, high = max(1.0 - (beside / least) * (beside / least), 0.0), 1.0
    square = low
    if beside > least:
        share = corner / (beside - tip)
        high = min(steep * steep * (share * share - 1.0), 1.0)
        square = high * (beside - tip) / corner
    for _ in range(NEWTON):
        root, rest = math.sqrt(steep * steep + square), math.sqrt(1.0 - square)
        out = tip + corner * steep / root
        over = out * rest - beside
        if over > 0.0:
            low = square
        else:
            high = square
        slope = -0.5 * (corner * steep * rest / (root * root * root) + out / max(rest, 1e-9))
        step = over / slope
        square -= step
        if not low <= square <= high:
            square = 0.5 * (low + high)
        elif abs(step) <= CLOSE * square:
            break
    return (tip + corner * steep / math.sqrt(steep * steep + square)) * math.sqrt(square)


DISC_STEP_MM = 0.001  # along the profile, between the discs that stand for it when a gouge is judged
BEAM = ("jet", "wire")  # cut through the whole stock wherever their height is


@dataclass(frozen=True)
class Cutter:
    """A cutter by its form; convex and never narrower higher up."""

    form: Form

    @property
    def radius_mm(self) -> float:
        """The largest radius."""
        return self.form.radius_mm

    @property
    def floor_mm(self) -> float:
        """The radius of the flat floor at the tip; 0 where there is none."""
        return self.form.tip_mm

    @property
    def is_flat(self) -> bool:
        """Whether it is a cylinder, as wide at its tip as anywhere."""
        return self.form.is_flat

    @property
    def rise_mm(self) -> float:
        """The height over the tip from which it is as wide as anywhere."""
        return self.form.rise_mm

    def discs(self, up_to_mm: float = np.inf, step_mm: float = DISC_STEP_MM) -> tuple[np.ndarray, np.ndarray]:
        """Return heights above the tip and radii of discs that approximate the cutter, rising.

        up_to_mm: higher ones are left out, but for the next one. step_mm: along the profile.
        """
        top_mm = max(min(up_to_mm, self.rise_mm), 0.0)
        if self.is_flat:
            return np.zeros(1), np.array([self.radius_mm])
        corner_mm = self.form.corner_mm
        if corner_mm:
            turn = np.arccos(1 - top_mm / corner_mm)
            angle = np.linspace(0.0, turn, int(np.ceil(corner_mm * turn / step_mm)) + 1)
            return corner_mm * (1 - np.cos(angle)), self.floor_mm + corner_mm * np.sin(angle)
        count = int(np.ceil(top_mm * np.hypot(1.0, 1 / self.form.slope) / step_mm)) + 1
        height = np.linspace(0.0, top_mm, count)
        return height, self.radius_at(height)

    def radius_at(self, height_mm: np.ndarray) -> np.ndarray:
        """Return the radius that the cutter has at heights above its tip."""
        return self.form.radius_at(height_mm)  # type: ignore[no-any-return]

    def heights_at(self, beside_mm: np.ndarray) -> np.ndarray:
        """Return the height over the tip of its lower face at distances from the axis; infinite beyond its radius."""
        beyond = np.clip(beside_mm - self.floor_mm, 0.0, self.radius_mm - self.floor_mm)
        height = beyond * self.form.slope
        if self.form.corner_mm:
            height = self.form.corner_mm - np.sqrt(np.maximum(self.form.corner_mm**2 - beyond**2, 0.0))
        return np.where(beside_mm <= self.radius_mm, height, np.inf)

    def gap(self, beside_mm: np.ndarray, drop_mm: float) -> np.ndarray:
        """Return the distance to the cutter from points beside its axis, `drop_mm` below its tip.

        Negative: above its tip; there a round corner counts as if the point lay at the tip's height.
        """
        beyond = np.maximum(beside_mm - self.floor_mm, 0.0)
        if self.is_flat:
            return np.hypot(beyond, max(drop_mm, 0.0))
        if self.form.corner_mm:
            corner_mm = self.form.corner_mm
            return np.maximum(np.hypot(beyond, corner_mm + max(drop_mm, 0.0)) - corner_mm, 0.0)
        wide, high = self.radius_mm - self.floor_mm, self.rise_mm
        drop_mm = max(drop_mm, -high)
        share = np.clip((beyond * wide - drop_mm * high) / (wide**2 + high**2), 0.0, 1.0)
        beside_cone = np.hypot(beyond - share * wide, drop_mm + share * high)
        return np.where(beyond * high <= -drop_mm * wide, 0.0, beside_cone)


POINT = Cutter(Form(0.0, 0.0))
Tools = Mapping[int, Tool] | Tool  # a single tool applies to every number


def tool_numbered(tools: Tools | None, number: int) -> Tool | None:
    """Return the tool with that number, or None; a program that names none is cut by the one tool that there is."""
    if isinstance(tools, Tool):
        return tools
    if tools and number == 0 and len(tools) == 1:
        return next(iter(tools.values()))
    return tools.get(number) if tools else None
