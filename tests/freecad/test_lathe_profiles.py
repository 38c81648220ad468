# SPDX-License-Identifier: LGPL-2.1-or-later
"""Operations of a lathe follow sketches, edges and solids: the same program as the points that say the same."""

from __future__ import annotations

from typing import Any

import Part
import pytest
from FreeCAD import Vector

from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import edit, problem_of
from helpers.freecad.half_profiles import POINTS, edges, shaft, sketch


def programs(document: Any, drawing: Any) -> str:
    """Return the program that roughs and finishes a drawing."""
    job = api.new_lathe_job(document, stock_diameter_mm=40)
    job.Label = "Shaft"
    api.add_tool(job)
    api.add_operation(job, "turn_rough", drawing, stock_to_leave_mm=0.3)
    api.add_operation(job, "turn_finish", drawing)
    document.recompute()
    assert [problem_of(each) for each in job.Operations] == ["", ""]
    return api.program_text(job)


@pytest.mark.parametrize("drawn", [sketch, shaft, edges])
def test_what_is_drawn_gives_the_program_of_its_points(document: Any, drawn: Any) -> None:
    points = ("0; 0", *POINTS) if drawn is shaft else POINTS  # the section of a solid begins at the axis
    wanted = programs(document, api.add_profile(document, points)).splitlines()
    assert programs(document, drawn(document)).splitlines()[1:] == wanted[1:]


def test_an_edited_sketch_changes_the_program(document: Any) -> None:
    drawing = sketch(document)
    before = programs(document, drawing)
    (job,) = [obj for obj in document.Objects if obj.Name.startswith("CNCStepper_LatheJob")]
    drawing.delGeometry(2)
    drawing.addGeometry(Part.LineSegment(Vector(18, -20, 0), Vector(18, -35, 0)), False)
    document.recompute()
    assert api.program_text(job) != before
    drawing.addGeometry(Part.LineSegment(Vector(30, 5, 0), Vector(30, 9, 0)), False)
    document.recompute()
    assert "one chain" in problem_of(job.Operations[0])


def test_a_profile_that_is_deleted_is_missed(document: Any) -> None:
    profile = api.add_profile(document, POINTS)
    programs(document, profile)
    (job,) = [obj for obj in document.Objects if obj.Name.startswith("CNCStepper_LatheJob")]
    document.removeObject(profile.Name)
    document.recompute()
    assert "was deleted" in problem_of(job.Operations[0])


def test_a_profile_by_points_refuses_what_is_none(document: Any) -> None:
    profile = api.add_profile(document, POINTS)
    edit(profile, points=("24; 0", "24; -20; chamfr 1"))
    document.recompute()
    assert "chamfr 1" in problem_of(profile)
    edit(profile, points=("24; 0", "24; -20; chamfer 1", "36; -20", "36; -40"))
    document.recompute()
    assert problem_of(profile) == "" and profile.Shape.BoundBox.XMax == pytest.approx(18)
    assert profile.Shape.BoundBox.ZMin == pytest.approx(-40)
