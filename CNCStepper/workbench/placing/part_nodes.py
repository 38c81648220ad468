# SPDX-License-Identifier: LGPL-2.1-or-later
"""The nodes of sheets and of the parts on them in FreeCAD's 3D view; a drag moves and colours one part.

view's scene graph
  root (not pickable) ── sheets: a face and its rim ── a group for each part: place, colour, faces, rim
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from pivy import coin
from shapely import Polygon

from CNCStepper.nesting.manual_nesting import ManualNest, PlacedPart
from CNCStepper.nesting.nesting_model import Placement
from CNCStepper.nesting.no_fit import convex_pieces
from CNCStepper.workbench.services.coin_fields import fill_points, fill_whole_numbers
from CNCStepper.workbench.services.view_colours import Rgb

SHEET_RGB, RIM_RGB = (0.93, 0.90, 0.82), (0.35, 0.30, 0.20)
PART_RGB: Rgb = (0.37, 0.59, 0.83)
LOCKED_RGB: Rgb = (0.45, 0.48, 0.52)
CHOSEN_RGB: Rgb = (0.97, 0.72, 0.18)
FAULT_RGB: Rgb = (0.83, 0.18, 0.18)
FACE_TRANSPARENCY = 0.35
SHEET_Z_MM, FACE_Z_MM, RIM_Z_MM = -0.2, 0.1, 0.2  # one above the other, so that each is seen


class PartNodes:
    """The sheets and parts of a nest in a view; corners: where the sheets lie, by `in_rows`."""

    def __init__(self, view: Any, nest: ManualNest, corners: Sequence[tuple[float, float]]):
        self._graph, self._nest, self._corners = view.getSceneGraph(), nest, corners
        self._root, self._parts = coin.SoSeparator(), coin.SoSeparator()
        unpickable, flat, style = coin.SoPickStyle(), coin.SoLightModel(), coin.SoDrawStyle()
        unpickable.style = coin.SoPickStyle.UNPICKABLE
        flat.model = coin.SoLightModel.BASE_COLOR
        style.lineWidth = 2
        for node in (unpickable, flat, style):
            self._root.addChild(node)
        self._sheets = coin.SoSeparator()
        self._root.addChild(self._sheets)
        self._root.addChild(self._parts)
        self._shapes: dict[int, Any] = {}  # of each item, shared by its parts
        self._places: list[Any] = []
        self._colours: list[Any] = []

    def show(self) -> None:
        """Put all into the view."""
        self._graph.addChild(self._root)

    def hide(self) -> None:
        """Take all out of the view."""
        self._graph.removeChild(self._root)

    def build(self, shown: Sequence[int]) -> None:
        """Make the nodes anew: these sheets, and all parts."""
        self._sheets.removeAllChildren()
        self._parts.removeAllChildren()
        self._places, self._colours = [], []
        for number in shown:
            self._sheets.addChild(_sheet_node(self._nest.sheets[number].outline, self._corners[number]))
        for part in self._nest.parts:
            self._add(part)

    def place(self, number: int, placement: Placement) -> None:
        """Show a part at a place."""
        left, low = self._corners[placement.sheet]
        node = self._places[number]
        node.translation = (placement.x_mm + left, placement.y_mm + low, 0.0)
        node.rotation.setValue(coin.SbVec3f(0, 0, 1), math.radians(placement.rotation_deg))

    def colour(self, number: int, rgb: Rgb) -> None:
        """Show a part in a colour."""
        self._colours[number].diffuseColor = rgb

    def _add(self, part: PlacedPart) -> None:
        item = part.placement.item
        if item not in self._shapes:
            self._shapes[item] = _part_node(self._nest.items[item].outline)
        group, place, colour = coin.SoSeparator(), coin.SoTransform(), coin.SoMaterial()
        colour.transparency = FACE_TRANSPARENCY
        for node in (place, colour, self._shapes[item]):
            group.addChild(node)
        self._parts.addChild(group)
        self._places.append(place)
        self._colours.append(colour)
        self.place(len(self._places) - 1, part.placement)
        self.colour(len(self._places) - 1, LOCKED_RGB if part.locked else PART_RGB)


def _part_node(outline: Polygon) -> Any:
    """Return the face of an item, where it has no holes, and its rims."""
    group = coin.SoSeparator()
    if not outline.interiors:
        group.addChild(_faces(convex_pieces(outline), FACE_Z_MM))
    for node in _rims(outline, RIM_Z_MM):
        group.addChild(node)
    return group


def _sheet_node(outline: Polygon, corner: tuple[float, float]) -> Any:
    group, place, face, rim = coin.SoSeparator(), coin.SoTransform(), coin.SoMaterial(), coin.SoMaterial()
    place.translation = (*corner, 0.0)
    face.diffuseColor, rim.diffuseColor = SHEET_RGB, RIM_RGB
    face.transparency = FACE_TRANSPARENCY
    nodes = (place, face, _faces(convex_pieces(outline), SHEET_Z_MM), rim, *_rims(outline, SHEET_Z_MM))
    for node in nodes:
        group.addChild(node)
    return group


def _faces(pieces: Sequence[np.ndarray], z_mm: float) -> Any:
    points = np.concatenate(pieces)
    content = coin.SoVertexProperty()
    fill_points(content.vertex, np.column_stack([points, np.full(len(points), z_mm)]))
    faces = coin.SoFaceSet()
    faces.vertexProperty = content
    fill_whole_numbers(faces.numVertices, [len(piece) for piece in pieces])
    return faces


def _rims(polygon: Polygon, z_mm: float) -> list[Any]:
    rings = [np.asarray(ring.coords) for ring in (polygon.exterior, *polygon.interiors)]
    found = []
    for ring in rings:
        content, lines = coin.SoVertexProperty(), coin.SoLineSet()
        fill_points(content.vertex, np.column_stack([ring[:, :2], np.full(len(ring), z_mm)]))
        lines.vertexProperty = content
        lines.numVertices.setValue(len(ring))
        found.append(lines)
    return found
