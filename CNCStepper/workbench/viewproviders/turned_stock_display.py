# SPDX-License-Identifier: LGPL-2.1-or-later
"""A lathe's bar, chuck and tailstock in the 3D view: half sections in the XZ plane, circles at their ends, the axis.

X is the radius, Z = 0 the finished end face, the chuck at Z below.
"""

from __future__ import annotations

import math
from typing import Any

from CNCStepper.workbench.services.view_colours import STOCK_RGB
from CNCStepper.workbench.viewproviders.stock_display import show_strips

CHUCK_RGB = (0.42, 0.45, 0.50)
SIDES = 48  # of a circle
BEYOND_MM = 10.0  # of the axis, from the ends of bar and chuck
CHUCK_MM = 30.0  # how much of the chuck is drawn
TURNED_BY = frozenset(
    {"StockForm", "Diameter", "Bore", "FaceStock", "Length", "ChuckDiameter", "JawDiameter", "Jaws", "TailstockBy",
     "CentreDiameter", "CentreAngle"}
)  # fmt: skip
Strips = list[list[tuple[float, float, float]]]


class TurnedStock:
    """`node` is for the view; `update` follows the job."""

    def __init__(self) -> None:
        from pivy import coin

        self.node = coin.SoSeparator()
        pick, style = coin.SoPickStyle(), coin.SoDrawStyle()
        pick.style = coin.SoPickStyle.UNPICKABLE  # sketches within the bar stay within reach of the mouse
        style.lineWidth = 1.5
        self.node.addChild(pick)
        self.node.addChild(style)
        self._bar, self._holders = self._lines(STOCK_RGB), self._lines(CHUCK_RGB)

    def _lines(self, rgb: tuple[float, float, float]) -> tuple[Any, Any]:
        from pivy import coin

        colour, points, lines = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoLineSet()
        colour.rgb = rgb
        for part in (colour, points, lines):
            self.node.addChild(part)
        return points, lines

    def update(self, job: Any) -> None:
        """Draw bar, chuck and tailstock as the job says they are."""
        show_strips(*self._bar, bar_strips(job))
        show_strips(*self._holders, holder_strips(job))


def bar_strips(job: Any) -> Strips:
    """Return the bar and its axis as lines."""
    radius, bore = float(job.Diameter) / 2, float(job.Bore) / 2 if job.StockForm == "tube" else 0.0
    back, front = -float(job.Length), float(job.FaceStock)
    axis = [(0.0, 0.0, back - BEYOND_MM), (0.0, 0.0, front + BEYOND_MM)]
    rings = [_circle(r, z) for r in (radius, bore) if r > 0 for z in (back, front)]
    return [axis, _section(bore, radius, back, front), *rings]


def holder_strips(job: Any) -> Strips:
    """Return chuck, jaws and tailstock as lines."""
    back, chuck, jaws = -float(job.Length), float(job.ChuckDiameter) / 2, float(job.JawDiameter) / 2
    strips = [_section(0.0, chuck, back - CHUCK_MM, back), _circle(chuck, back)]
    if jaws > 0 and float(job.Jaws) > 0:
        strips.append(_section(float(job.Diameter) / 2, jaws, back, back + float(job.Jaws)))
    if job.TailstockBy == "given":
        strips.append(_centre(float(job.CentreDiameter) / 2, float(job.CentreAngle), float(job.FaceStock)))
    return strips


def _section(low: float, high: float, back: float, front: float) -> list[tuple[float, float, float]]:
    return [(low, 0.0, back), (high, 0.0, back), (high, 0.0, front), (low, 0.0, front), (low, 0.0, back)]


def _circle(radius: float, z: float) -> list[tuple[float, float, float]]:
    angles = [2 * math.pi * side / SIDES for side in range(SIDES + 1)]
    return [(radius * math.cos(angle), radius * math.sin(angle), z) for angle in angles]


def _centre(radius: float, angle_deg: float, z: float) -> list[tuple[float, float, float]]:
    """Return the tip of a tailstock's centre, then its cylinder."""
    tip = radius / math.tan(math.radians(max(angle_deg, 1.0) / 2))
    return [(0.0, 0.0, z), (radius, 0.0, z + tip), (radius, 0.0, z + tip + CHUCK_MM)]
