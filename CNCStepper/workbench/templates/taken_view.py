# SPDX-License-Identifier: LGPL-2.1-or-later
"""The contours of a rule in the 3D view, drawn over everything else; they belong to no document object."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from pivy import coin

from CNCStepper.workbench.services.coin_fields import fill_points, fill_whole_numbers

if TYPE_CHECKING:
    from CNCStepper.geometry.curve import Curve

TAKEN = (0.97, 0.62, 0.05)  # amber reads on light and on dark backgrounds
UNTAKEN = (0.90, 0.28, 0.30)
WIDTH_PX = 4
MOST_SHOWN = 5000  # contours that are drawn at once
CHORD_SHARE = 0.001  # of a contour's size: how far chords leave its arcs


class TakenView:
    """The marked contours of one view; nothing of them can be selected."""

    def __init__(self, view: Any):
        self._root, self._node = view.getSceneGraph(), coin.SoAnnotation()
        self._colour, self._points, self._lines = coin.SoBaseColor(), coin.SoCoordinate3(), coin.SoLineSet()
        unpickable, flat, style = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDrawStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        flat.model = coin.SoLightModel.BASE_COLOR
        style.lineWidth = WIDTH_PX
        for node in (unpickable, flat, style, self._colour, self._points, self._lines):
            self._node.addChild(node)
        self.draw(())
        self._root.addChild(self._node)

    def draw(self, curves: Sequence[Curve], untaken: bool = False) -> None:
        """Show some contours, mm, in place of those before."""
        shown = [curve.points(_chord_mm(curve)) for curve in curves[:MOST_SHOWN]]
        flat = np.vstack(shown) if shown else np.zeros((0, 2))
        self._colour.rgb = UNTAKEN if untaken else TAKEN
        fill_points(self._points.point, np.column_stack([flat, np.zeros(len(flat))]))
        fill_whole_numbers(self._lines.numVertices, list(map(len, shown)))

    def end(self) -> None:
        """Take them out of the view, where they still are."""
        if self._root.findChild(self._node) >= 0:
            self._root.removeChild(self._node)


def _chord_mm(curve: Curve) -> float:
    left, low, right, high = curve.box_mm
    return max(CHORD_SHARE * max(right - left, high - low), 1e-4)
