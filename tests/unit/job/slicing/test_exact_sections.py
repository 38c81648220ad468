# SPDX-License-Identifier: LGPL-2.1-or-later
"""Sections of STEP, BREP and FCStd files by CadQuery and by FreeCAD: exact circles, areas in closed form, volumes."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from CNCStepper.drawing.solids.stl import read_triangles
from CNCStepper.errors import JobError, Place
from CNCStepper.job.drawings import solid_process
from CNCStepper.job.slicing import sections
from CNCStepper.job.slicing.sections import SECTION_TOLERANCE_MM, mesh_sections, section_area, solid_sections
from CNCStepper.job.slicing.solid_slices import Stack, stack_of

CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
CADQUERY = Path(os.environ.get("CNCSTEPPER_CADQUERIES") or CACHE / "cncstepper-cadquery") / "bin" / "python"
SOLIDS = """
import json
import cadquery as cq
ball = cq.Workplane().sphere(20)
inner = cq.Workplane().sphere(9).translate((-8, 0, 3))
hull = cq.Workplane().sphere(25).cut(inner).cut(cq.Workplane().box(11, 12, 13).translate((9.5, 0, -2.5)))
wall = cq.Workplane().rect(40, 30).extrude(20).cut(cq.Workplane().rect(38.4, 28.4).extrude(20))
loft = cq.Workplane().ellipse(20, 10).workplane(offset=30).circle(6).loft()
for name, solid in {"ball": ball, "hull": hull, "wall": wall, "loft": loft}.items():
    cq.exporters.export(solid, name + ".step")
    cq.exporters.export(solid, name + ".stl", tolerance=0.005, angularTolerance=0.05)
hull.val().exportBrep("hull.brep")
cq.exporters.export(wall.faces(), "open.step")
apart = [cq.Workplane().box(10, 10, 10).translate((x, 0, 0)).val() for x in (0, 4)]
cq.exporters.export(cq.Workplane(cq.Compound.makeCompound(apart)), "overlap.step")
areas = {}
for name, solid, heights in (("hull", hull, range(-24, 24, 6)), ("loft", loft, range(1, 31, 4))):
    level = lambda z: cq.Face.makePlane(100, 100, (0, 0, z), (0, 0, 1))
    areas[name] = [[z, level(z).intersect(solid.val()).Area()] for z in heights]
with open("areas.json", "w") as file:
    json.dump(areas, file)
"""


@pytest.fixture(scope="module")
def solids(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with the solids as STEP and STL, made by CadQuery."""
    assert CADQUERY.exists(), "run 'make setup'"
    folder = tmp_path_factory.mktemp("solids")
    subprocess.run([CADQUERY, "-c", SOLIDS], cwd=folder, check=True, timeout=300)
    return folder


@pytest.fixture(params=["cadquery", "freecad"])
def engine(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.setenv("CNCSTEPPER_CADQUERY", str(CADQUERY) if request.param == "cadquery" else "none")
    solid_process.cadquery_python.cache_clear()
    return str(request.param)


def stack(path: Path, axis: str, thickness_mm: float = 1.0) -> Stack:
    return stack_of(solid_sections(path, axis, thickness_mm))


@pytest.mark.slow
@pytest.mark.freecad
@pytest.mark.parametrize(
    ("name", "axis"),
    [("ball.step", "x"), ("hull.step", "y"), ("hull.brep", "z"), ("wall.step", "z"), ("loft.step", "z")],
)
def test_volumes_of_stacks_and_areas_of_sections(solids: Path, engine: str, name: str, axis: str) -> None:
    made = stack(solids / name, axis)
    assert made.volume_mm3 == pytest.approx(made.solid_volume_mm3, rel=0.01)
    mesh = read_triangles((solids / name).with_suffix(".stl").read_bytes(), Place(name))
    by_mesh = mesh_sections(mesh, axis, 1.0)
    assert made.solid_volume_mm3 == pytest.approx(by_mesh.volume_mm3, rel=0.01)
    assert len(made.slices) == len(by_mesh.outlines)
    for each, outlines in zip(made.slices, by_mesh.outlines, strict=True):
        assert each.area_mm2 == pytest.approx(sum(one.area_mm2 for one in outlines), rel=0.02, abs=0.5)


@pytest.mark.slow
@pytest.mark.freecad
def test_sections_of_spheres_are_circles_of_the_radius_at_that_height(solids: Path, engine: str) -> None:
    for each in stack(solids / "ball.step", "x", 4.0).slices:
        (ring,) = each.pieces[0].rings
        radius_mm = np.sqrt(400.0 - (each.begin_mm + 2.0) ** 2)
        assert np.ptp(ring.radii_mm) < 1e-6 and ring.radii_mm[0] == pytest.approx(radius_mm, abs=1e-6)
    middle = stack(solids / "hull.step", "z", 2.0).slices[13]
    z = middle.begin_mm + 1.0
    holes = np.pi * (81.0 - (z - 3.0) ** 2) + 11.0 * 12.0
    assert middle.area_mm2 == pytest.approx(np.pi * (625.0 - z**2) - holes, abs=1e-3)


@pytest.mark.slow
@pytest.mark.freecad
@pytest.mark.parametrize("name", ["hull", "loft"])
def test_sections_are_those_that_occt_cuts_out_of_a_plane(solids: Path, engine: str, name: str) -> None:
    mesh = read_triangles((solids / f"{name}.stl").read_bytes(), Place(name))
    made = {round(each.begin_mm + 1.0, 3): each for each in stack(solids / f"{name}.step", "z", 2.0).slices}
    areas = json.loads((solids / "areas.json").read_text("ascii"))[name]
    assert len(areas) == 8
    for z, area_mm2 in areas:
        length_mm = sum(ring.length_mm for piece in made[z].pieces for ring in piece.rings)
        assert made[z].area_mm2 == pytest.approx(area_mm2, abs=SECTION_TOLERANCE_MM * length_mm)
        assert section_area(mesh, z).area == pytest.approx(area_mm2, rel=0.01)


@pytest.mark.slow
@pytest.mark.freecad
def test_solids_that_are_open_or_overlap_are_refused(
    solids: Path, engine: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, code in (("open.step", "slice-open"), ("overlap.step", "slice-overlap")):
        with pytest.raises(JobError) as refused:
            solid_sections(solids / name, "z", 1.0)
        assert refused.value.code == code and name in str(refused.value)
    with pytest.raises(JobError) as refused:
        solid_sections(solids / "ball.step", "z", 0.001)
    assert refused.value.code == "slice-count"


@pytest.mark.slow
@pytest.mark.freecad
def test_the_body_of_a_freecad_document_is_sliced(tmp_path: Path) -> None:
    path, script = tmp_path / "body.FCStd", tmp_path / "make.py"
    script.write_text(
        "import FreeCAD\n"
        "document = FreeCAD.newDocument()\n"
        "body = document.addObject('PartDesign::Body', 'Body')\n"
        "ball = document.addObject('PartDesign::AdditiveSphere', 'Ball')\n"
        "ball.Radius = 15\n"
        "body.addObject(ball)\n"
        "document.recompute()\n"
        f"document.saveAs({str(path)!r})\n",
        "utf-8",
    )
    command = [solid_process._freecad_command(), str(script)]
    home = {"FREECAD_USER_HOME": str(tmp_path)}
    subprocess.run(command, stdin=subprocess.DEVNULL, env=os.environ | home, timeout=120, check=False)
    made = stack(path, "y")
    assert made.solid_volume_mm3 == pytest.approx(4.0 / 3.0 * np.pi * 15.0**3)
    assert made.volume_mm3 == pytest.approx(made.solid_volume_mm3, rel=0.01)


def test_sections_that_do_not_close_are_refused_with_their_sheet(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer = {"low_mm": 0.0, "high_mm": 1.0, "volume_mm3": 1.0, "sections": [[[["line", 0.0, 0.0, 5.0, 0.0]]]]}
    monkeypatch.setattr(sections, "read_solid", lambda *given: answer)
    (tmp_path / "part.step").write_text("ISO-10303-21;", "utf-8")
    with pytest.raises(JobError) as refused:
        solid_sections(tmp_path / "part.step", "z", 1.0)
    assert refused.value.code == "slice-open" and "sheet 1" in str(refused.value)
