# SPDX-License-Identifier: LGPL-2.1-or-later
"""Nodes of FreeCAD's 3D view (Coin, by pivy) from arrays."""

from __future__ import annotations

from typing import Any

import numpy as np

from CNCStepper.workbench.services.coin_fields import fill_colours, fill_points, fill_whole_numbers
from CNCStepper.workbench.services.view_colours import Rgb


def separator(*children: Any) -> Any:
    """Return a group whose settings concern its own children only."""
    from pivy import coin

    group = coin.SoSeparator()
    for child in children:
        group.addChild(child)
    return group


def quads(corners: np.ndarray) -> Any:
    """Return faces of four corners, float32[n, 4, 3]."""
    from pivy import coin

    faces = coin.SoFaceSet()
    faces.vertexProperty = _corners(corners)
    fill_whole_numbers(faces.numVertices, np.full(len(corners), 4))
    return faces


def polygons(points: np.ndarray, counts: np.ndarray) -> Any:
    """Return faces without holes, float32[n, 3], of so many corners each."""
    from pivy import coin

    content = coin.SoVertexProperty()
    fill_points(content.vertex, points)
    faces = coin.SoFaceSet()
    faces.vertexProperty = content
    fill_whole_numbers(faces.numVertices, counts)
    return faces


def coloured_quads(corners: np.ndarray, rgba: np.ndarray) -> Any:
    """Return faces of four corners, float32[n, 4, 3], with a packed colour for every corner, uint32[n, 4].

    Their corners are named by index because Coin draws a SoFaceSet of up to four such faces in wrong colours.
    """
    from pivy import coin

    content = _corners(corners)
    fill_colours(content.orderedRGBA, rgba.ravel())
    content.materialBinding = coin.SoVertexProperty.PER_VERTEX
    index = np.full((len(corners), 5), -1, np.int32)
    index[:, :4] = np.arange(4 * len(corners)).reshape(-1, 4)
    faces = coin.SoIndexedFaceSet()
    faces.vertexProperty = content
    fill_whole_numbers(faces.coordIndex, index.ravel())
    return faces


def _corners(corners: np.ndarray) -> Any:
    from pivy import coin

    content = coin.SoVertexProperty()
    fill_points(content.vertex, corners)
    return content


def strips(points: np.ndarray, normals: np.ndarray, counts: np.ndarray) -> Any:
    """Return strips of triangles, float32[n, 3] with normals, float32[n, 3], of so many points each."""
    from pivy import coin

    content = coin.SoVertexProperty()
    fill_points(content.vertex, points)
    fill_points(content.normal, normals)
    content.normalBinding = coin.SoVertexProperty.PER_VERTEX
    bands = coin.SoTriangleStripSet()
    bands.vertexProperty = content
    fill_whole_numbers(bands.numVertices, counts)
    return bands


def lines(points: np.ndarray, counts: np.ndarray) -> Any:
    """Return polylines one after another, float32[n, 3], of so many points each."""
    from pivy import coin

    content = coin.SoVertexProperty()
    fill_points(content.vertex, points)
    strips = coin.SoLineSet()
    strips.vertexProperty = content
    fill_whole_numbers(strips.numVertices, counts)
    return strips


def unlit() -> Any:
    """Return the setting that what follows has its own colours in any light."""
    from pivy import coin

    model = coin.SoLightModel()
    model.model = coin.SoLightModel.BASE_COLOR
    return model


def plain(rgb: Rgb) -> Any:
    """Return the setting that what follows has this colour in any light."""
    from pivy import coin

    group = coin.SoGroup()
    colour = coin.SoBaseColor()
    colour.rgb = rgb
    group.addChild(unlit())
    group.addChild(colour)
    return group


def material(rgb: Rgb, shine: float = 0.0) -> Any:
    """Return the setting that what follows is lit and has this colour."""
    from pivy import coin

    node = coin.SoMaterial()
    node.diffuseColor = rgb
    node.specularColor = (shine, shine, shine)
    node.shininess = shine
    return node


def solid() -> Any:
    """Return the setting that faces which follow are seen from outside only, with smooth edges where they are blunt."""
    from pivy import coin

    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.SOLID
    hints.creaseAngle = 0.6
    return hints


def both_sides() -> Any:
    """Return the setting that faces which follow are seen from both sides."""
    from pivy import coin

    hints = coin.SoShapeHints()
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    hints.shapeType = coin.SoShapeHints.UNKNOWN_SHAPE_TYPE
    return hints


def concave() -> Any:
    """Return the setting that faces which follow may be concave and are seen from both sides."""
    from pivy import coin

    hints = coin.SoShapeHints()
    hints.faceType = coin.SoShapeHints.UNKNOWN_FACE_TYPE
    hints.vertexOrdering = coin.SoShapeHints.COUNTERCLOCKWISE
    return hints


def in_front() -> Any:
    """Return the setting that what follows is seen through whatever stands before it."""
    from pivy import coin

    depth = coin.SoDepthBuffer()
    depth.test = False
    return depth
