# SPDX-License-Identifier: LGPL-2.1-or-later
"""A job's clamps in the 3D view: what the tool keeps clear of, from each clamp's top down to the stock's bottom."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.document.clamps import rings_of

RGB = (0.78, 0.16, 0.55)  # no path, stock or part is drawn in it
GLASS = 0.7  # of the top face: the solid itself stays to be seen


class ClampBlocks:
    """`node` is for the view; `update` follows the job."""

    def __init__(self) -> None:
        from pivy import coin

        self.node = coin.SoSeparator()
        self._points, self._lines, self._tops = coin.SoCoordinate3(), coin.SoLineSet(), coin.SoFaceSet()
        self._top_points = coin.SoCoordinate3()
        glass, solid = coin.SoMaterial(), coin.SoMaterial()
        glass.diffuseColor, glass.transparency = RGB, GLASS
        solid.diffuseColor = RGB
        style, light, pick = coin.SoDrawStyle(), coin.SoLightModel(), coin.SoPickStyle()
        style.lineWidth = 2.0
        light.model = coin.SoLightModel.BASE_COLOR
        pick.style = coin.SoPickStyle.UNPICKABLE  # the solid below stays within reach of the mouse
        for part in (pick, light, style, glass, self._top_points, self._tops, solid, self._points, self._lines):
            self.node.addChild(part)

    def update(self, job: Any) -> None:
        """Draw the clamps that the job keeps."""
        rings = list(rings_of(job))
        floor_mm = job.WorkOrigin.z - job.StockSize.z
        _show(self._top_points, self._tops, [ring[:-1] for ring in rings])
        _show(self._points, self._lines, [strip for ring in rings for strip in _edges(ring, floor_mm)])


def _edges(ring: list[Any], floor_mm: float) -> list[list[Any]]:
    """Return the edges of the block between a clamp's outline and the stock's bottom."""
    low = [(x, y, min(z, floor_mm)) for x, y, z in ring]
    return [ring, low, *([top, bottom] for top, bottom in zip(ring[:-1], low[:-1], strict=True))]


def _show(points: Any, shape: Any, strips: list[list[Any]]) -> None:
    flat = [point for strip in strips for point in strip]
    points.point.setValues(0, len(flat), flat)
    points.point.setNum(len(flat))
    shape.numVertices.setValues(0, len(strips), [len(strip) for strip in strips])
    shape.numVertices.setNum(len(strips))
