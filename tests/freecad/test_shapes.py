# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Shape: every shape of the library becomes exact wires with its own dimensions, and a program."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.drawing.shape_library.declaration import SHAPES
from CNCStepper.drawing.shape_library.shape_families import figure_of
from CNCStepper.errors import JobError
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of


def test_every_shape_has_the_curves_of_the_library(document: Any) -> None:
    assert len(SHAPES) >= 43
    for kind in SHAPES:
        shape, figure = api.add_shape(document, kind), figure_of(kind, {})
        shape.recompute()
        assert problem_of(shape) == "", kind
        assert len(shape.Shape.Wires) == len(figure.curves), kind
        length = sum(curve.length_mm for curve in figure.curves)
        assert shape.Shape.Length == pytest.approx(length, rel=1e-9), kind
        assert all(wire.isClosed() for wire in shape.Shape.Wires), kind
        document.removeObject(shape.Name)


def test_dimensions_recompute_and_make_a_program(document: Any) -> None:
    ring = api.add_shape(document, "ring", outer_diameter_mm=50, inner_diameter_mm=20)
    job = api.new_job(document, stock_size_mm=(100, 70, 10))
    api.add_tool(job, diameter_mm=6)
    pocket = api.add_operation(job, "pocket", ring, depth_mm=2)
    document.recompute()
    assert [problem_of(each) for each in (ring, pocket, job)] == ["", "", ""]
    before = api.program_text(job)
    api.edit(ring, inner_diameter_mm=30)
    document.recompute()
    assert ring.Shape.BoundBox.XLength == pytest.approx(50)
    assert api.program_text(job) != before


@pytest.mark.parametrize(
    ("values", "sentence"),
    [({"inner_diameter_mm": 90}, "larger"), ({"outer_diameter_mm": -3}, "outer_diameter_mm"), ({"part": "holes"}, "")],
)
def test_dimensions_that_do_not_go_together_say_why(document: Any, values: dict[str, Any], sentence: str) -> None:
    ring = api.add_shape(document, "ring")
    api.edit(ring, **values)
    document.recompute()
    assert sentence in problem_of(ring)
    assert bool(problem_of(ring)) == bool(sentence)


def test_an_unknown_kind_or_key_adds_nothing(document: Any) -> None:
    for kind, values in (("no_such_shape", {}), ("ring", {"length_mm": 3})):
        with pytest.raises(JobError):
            api.add_shape(document, kind, **values)
    assert not document.Objects


def test_it_survives_copy_save_and_reopen(document: Any, tmp_path: Path) -> None:
    ring = api.add_shape(document, "ring", inner_diameter_mm=11)
    document.copyObject(ring)
    document.recompute()
    document.saveAs(str(tmp_path / "formas.FCStd"))
    FreeCAD.closeDocument(document.Name)
    rings = FreeCAD.openDocument(str(tmp_path / "formas.FCStd")).Objects
    assert len(rings) == 2
    for again in rings:
        api.edit(again, inner_diameter_mm=12)
        again.Document.recompute()
        assert min(wire.Length for wire in again.Shape.Wires) == pytest.approx(12 * 3.14159265, rel=1e-6)
