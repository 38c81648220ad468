# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tool object carries every key of the core's tool; 0 is "not given", and what other shapes have does not count."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import FreeCAD
import pytest

from CNCStepper.errors import JobError
from CNCStepper.machine.tools.tool import Tool as Model
from CNCStepper.machine.tools.tool_shapes import SHAPES, foreign_keys
from CNCStepper.workbench import api
from CNCStepper.workbench.features.base import problem_of, values
from CNCStepper.workbench.features.tool import OPTIONAL, Tool, model_of
from CNCStepper.workbench.panels.field_errors import complaints

OLD = Path(__file__).parent / "data" / "first-release.FCStd"
OWN = ("from_chart",)  # of the object alone: the core's tool is then the one that the chart describes
PLAIN = {"number": 1, "diameter_mm": 6, "feed_mm_min": 800, "plunge_mm_min": 200, "spindle_rpm": 10000}
GIVEN = {
    "flute_length_mm": 15,
    "length_mm": 30,
    "holder_diameter_mm": 20,
    "ramp_max_deg": 5,
    "flutes": 2,
    "chip_load_min_mm": 0.0125,
    "chip_load_max_mm": 0.05,
    "engagement_max_deg": 90,
}
OF_SHAPE = {
    "flat": {"core_diameter_mm": 2},
    "ball": {"core_diameter_mm": 1},
    "bullnose": {"corner_radius_mm": 1, "core_diameter_mm": 2},
    "v": {"tip_angle_deg": 60, "tip_diameter_mm": 0.2},
    "engraver": {"tip_angle_deg": 30, "tip_diameter_mm": 0.1},
    "drill": {"point_angle_deg": 130},
    "jet": {"taper_deg": 1},
    "wire": {"taper_deg": 0.5},
}


@pytest.fixture
def job(document: Any) -> Any:
    return api.new_job(document)


def test_a_tool_has_a_property_for_every_key_of_the_core() -> None:
    assert {entry.key for entry in Tool.PROPERTIES if not entry.output} == {*Model.model_fields, *OWN}


@pytest.mark.parametrize("shape", SHAPES)
def test_what_is_given_reaches_the_core(job: Any, shape: str) -> None:
    content = {**PLAIN, **GIVEN, "shape": shape, **OF_SHAPE[shape]}
    assert model_of(api.add_tool(job, **content)) == Model(**content)


@pytest.mark.parametrize("shape", SHAPES)
def test_nothing_is_given_until_somebody_does(job: Any, shape: str) -> None:
    tool = api.add_tool(job, shape=shape)
    assert {values(tool)[key] for key in OPTIONAL} == {0}
    assert model_of(tool) == Model(shape=shape, **PLAIN)


def test_another_shape_keeps_the_values_that_it_does_not_have_without_using_them(document: Any, job: Any) -> None:
    tool = api.add_tool(job, shape="v", tip_angle_deg=60)
    document.recompute()
    api.edit(tool, shape="drill")
    document.recompute()
    assert problem_of(tool) == ""
    assert model_of(tool).tip_angle_deg is None
    api.edit(tool, shape="v")
    assert model_of(tool).tip_angle_deg == 60


@pytest.mark.parametrize("shape", SHAPES)
def test_only_what_the_shape_has_can_be_typed(job: Any, shape: str) -> None:
    tool = api.add_tool(job)
    api.edit(tool, shape=shape)
    fixed = {
        entry.key for entry in Tool.PROPERTIES if not entry.output and "ReadOnly" in tool.getEditorMode(entry.name)
    }
    assert fixed == foreign_keys(shape)


@pytest.mark.parametrize(
    ("shape", "bad", "named"),
    [
        ("bullnose", {"corner_radius_mm": 3.5}, "corner_radius_mm"),
        ("v", {"tip_angle_deg": -60}, "tip_angle_deg"),
        ("v", {"tip_angle_deg": 180}, "tip_angle_deg"),
        ("flat", {"core_diameter_mm": 7}, "core_diameter_mm"),
        ("flat", {"flute_length_mm": -1}, "flute_length_mm"),
        ("flat", {"flute_length_mm": 20, "length_mm": 10}, "flute_length_mm"),
        ("flat", {"chip_load_max_mm": 0.05}, "flutes"),
    ],
)
def test_what_cannot_be_is_refused_by_its_key(job: Any, shape: str, bad: dict[str, float], named: str) -> None:
    with pytest.raises(JobError, match=named):
        api.add_tool(job, shape=shape, **bad)
    assert job.Tools == []


def test_the_panel_takes_a_zero_back_as_not_given_and_no_number_below(job: Any) -> None:
    tool = api.add_tool(job, shape="v", tip_angle_deg=60)

    def wrong(**changes: float) -> set[str]:
        return set(complaints(Model, tool.Proxy.given(values(tool) | changes), lambda key, number: str(number)))

    assert wrong(tip_angle_deg=0) == set()
    assert wrong(tip_angle_deg=-1) == {"tip_angle_deg"}
    assert wrong(diameter_mm=0) == {"diameter_mm"}


def test_the_program_is_the_same_whatever_is_known_of_the_tool(document: Any, job: Any) -> None:
    tool = api.add_tool(job)
    api.add_elliptical_pocket(job, depth_mm=2)
    document.recompute()
    plain = api.program_text(job)
    api.edit(tool, **GIVEN)
    document.recompute()
    assert api.program_text(job) == plain
    assert api.job_model(job).tool[0].flute_length_mm == GIVEN["flute_length_mm"]


def test_what_is_given_is_there_after_reopening(document: Any, job: Any, tmp_path: Path) -> None:
    name = api.add_tool(job, shape="v", **OF_SHAPE["v"], **GIVEN).Name
    before = model_of(document.getObject(name))
    document.saveAs(str(tmp_path / "ferramentas ç.FCStd"))
    FreeCAD.closeDocument(document.Name)
    tool = FreeCAD.openDocument(str(tmp_path / "ferramentas ç.FCStd")).getObject(name)
    assert model_of(tool) == before
    assert "ReadOnly" in tool.getEditorMode("PointAngle")
    assert "ReadOnly" not in tool.getEditorMode("TipAngle")


def test_a_tool_of_an_older_document_is_what_it_was_and_can_become_a_jet(document: Any, tmp_path: Path) -> None:
    path = tmp_path / "old.FCStd"
    path.write_bytes(OLD.read_bytes())
    for tool in FreeCAD.openDocument(str(path)).getObject("CNCStepper_Job").Tools:
        assert tuple(tool.getEnumerationsOfProperty("ToolShape")) == SHAPES
        content = {key: value for key, value in values(tool).items() if key not in (*OPTIONAL, *OWN)}
        assert model_of(tool) == Model(**content)
        assert "ReadOnly" in tool.getEditorMode("Taper")
        api.edit(tool, shape="jet", taper_deg=1)
        assert model_of(tool).taper_deg == 1
