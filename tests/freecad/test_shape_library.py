# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every shape of the library, judged by OCCT: its lines and arcs make a valid face of the same area."""

from __future__ import annotations

from typing import Any

import Part
import pytest
from FreeCAD import Vector

from CNCStepper.drawing.shape_library.declaration import SHAPES
from CNCStepper.drawing.shape_library.shape_families import figure_of
from CNCStepper.geometry.curve import Curve


def wire(curve: Curve) -> Any:
    """Return a curve as a wire of lines and arcs, each arc through its middle."""
    corners = [Vector(*point) for point in [*curve.xy[:-1].tolist(), curve.xy[0].tolist()]]
    places = zip(corners, corners[1:], curve.segments.at(0.5).tolist(), curve.bulge.tolist(), strict=False)
    edges = [
        Part.Arc(begin, Vector(middle.real, middle.imag), end).toShape() if bulge else Part.makeLine(begin, end)
        for begin, end, middle, bulge in places
    ]
    return Part.Wire(edges)


@pytest.mark.parametrize("kind", SHAPES)
def test_occt_finds_a_valid_face_of_the_same_area(kind: str) -> None:
    figure = figure_of(kind, {})
    wires = [wire(curve) for curve in figure.curves]
    assert all(each.isClosed() for each in wires)
    face = Part.Face(wires[0])
    for hole in wires[1:]:
        face = face.cut(Part.Face(hole))
    assert face.isValid() and len(face.Faces) == 1
    assert face.Area == pytest.approx(figure.area_mm2, rel=1e-7)
    assert sum(each.Length for each in wires) == pytest.approx(
        sum(curve.length_mm for curve in figure.curves), rel=1e-9
    )
