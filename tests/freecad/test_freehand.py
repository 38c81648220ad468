# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Freehand: a wire within the tolerance of every drawn point, which survives save and reopen."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import FreeCAD
import Part
import pytest
from FreeCAD import Vector

from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, proxy_type

WAVE = [(x / 10, math.sin(x / 20)) for x in range(400)]


def test_without_a_tolerance_every_bend_is_kept(document: Any) -> None:
    line = api.add_freehand(document, [(0, 0), (5, 0), (5, 0), (10, 0), (10, 10)])
    document.recompute()
    assert problem_of(line) == ""
    assert line.Shape.Length == pytest.approx(20)
    assert line.Kept == len(line.Shape.Vertexes)


@pytest.mark.parametrize("tolerance_mm", [0.01, 0.1, 0.5])
def test_the_wire_stays_within_the_tolerance(document: Any, tolerance_mm: float) -> None:
    line = api.add_freehand(document, WAVE, tolerance_mm=tolerance_mm)
    document.recompute()
    assert line.Kept < len(WAVE) / 3
    assert max(line.Shape.distToShape(Part.Vertex(Vector(*p, 0)))[0] for p in WAVE) <= tolerance_mm + 1e-9
    ends = [tuple(line.Shape.Vertexes[i].Point)[:2] for i in (0, -1)]
    assert ends == [pytest.approx(WAVE[0]), pytest.approx(WAVE[-1])]


@pytest.mark.parametrize("smooth_mm", [0.01, 0.1])
def test_a_smoothed_wire_has_arcs_within_its_tolerance(document: Any, smooth_mm: float) -> None:
    line = api.add_freehand(document, WAVE, smooth_mm=smooth_mm)
    document.recompute()
    assert problem_of(line) == ""
    assert any(isinstance(edge.Curve, Part.Circle) for edge in line.Shape.Edges)
    assert line.Kept == len(line.Shape.Vertexes) < len(WAVE) / 10
    assert max(line.Shape.distToShape(Part.Vertex(Vector(*p, 0)))[0] for p in WAVE) <= smooth_mm + 1e-7


def test_a_smoothed_closed_circle_is_closed_and_round(document: Any) -> None:
    angles = [2 * math.pi * k / 200 for k in range(200)]
    points = [(10 * math.cos(a), 10 * math.sin(a), 3) for a in angles]
    line = api.add_freehand(document, points, smooth_mm=0.05, closed=True)
    document.recompute()
    assert line.Shape.isClosed()
    assert line.Shape.Length == pytest.approx(20 * math.pi, abs=0.1)
    assert Part.Face(line.Shape).Area == pytest.approx(100 * math.pi, rel=0.01)
    assert line.Shape.BoundBox.ZMin == pytest.approx(3) == line.Shape.BoundBox.ZMax


def test_an_edited_tolerance_and_a_closed_line_recompute(document: Any) -> None:
    line = api.add_freehand(document, WAVE)
    document.recompute()
    before = line.Kept
    api.edit(line, tolerance_mm=0.1, closed=True)
    document.recompute()
    assert line.Kept < before
    assert line.Shape.isClosed()


def test_the_placement_stays(document: Any) -> None:
    line = api.add_freehand(document, [(0, 0, 2), (10, 0, 2)])
    line.Placement.Base = Vector(0, 0, 5)
    document.recompute()
    assert line.Placement.Base.z == 5
    assert line.Shape.BoundBox.ZMax == pytest.approx(7)


@pytest.mark.parametrize(
    ("points", "values", "sentence"),
    [
        ([], {}, "at least two points"),
        ([(1, 1), (1, 1)], {}, "at least two points"),
        ([(0, 0, 0), (1, 0, 3)], {}, "different heights"),
        ([(0, 0), (1, 0)], {"tolerance_mm": -1}, "must not be negative"),
        ([(0, 0), (1, 0)], {"smooth_mm": -1}, "must not be negative"),
    ],
)
def test_points_that_make_no_line_show_why(document: Any, points: Any, values: dict[str, Any], sentence: str) -> None:
    line = api.add_freehand(document, points, **values)
    document.recompute()
    assert sentence in problem_of(line)


@pytest.mark.parametrize("points", [[(0, 0), (math.nan, 1)], [(0, 0), (1,)], [(0, 0), ("a", 1)]])
def test_points_that_are_no_numbers_change_nothing(document: Any, points: Any) -> None:
    with pytest.raises(JobError):
        api.add_freehand(document, points)
    assert not document.Objects


def test_it_survives_save_and_reopen(document: Any, tmp_path: Path) -> None:
    api.add_freehand(document, WAVE, tolerance_mm=0.1)
    document.recompute()
    kept = document.Objects[0].Kept
    document.saveAs(str(tmp_path / "linha à mão nº 1.FCStd"))
    FreeCAD.closeDocument(document.Name)
    again = FreeCAD.openDocument(str(tmp_path / "linha à mão nº 1.FCStd"))
    (line,) = again.Objects
    assert proxy_type(line) == "CNCStepper_Freehand"
    assert type(line.Proxy).__module__ == "CNCStepper.workbench.features.freehand"
    api.edit(line, tolerance_mm=0.5)
    again.recompute()
    assert 1 < line.Kept < kept
