# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper slice`: its drawings, its list, and the nested pieces of a stack."""

from __future__ import annotations

import json
from pathlib import Path

from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError
from helpers.solids.closed_meshes import sphere, write_stl


def run(*words: object) -> Result:
    return CliRunner().invoke(group, ["slice", *map(str, words)])


def test_a_sphere_becomes_drawings_a_list_a_picture_and_nested_sheets(tmp_path: Path) -> None:
    write_stl(tmp_path / "ball.stl", sphere(15.0, rings=16))
    out = tmp_path / "out"
    done = run(tmp_path / "ball.stl", "--thickness", 5, "--axis", "y", "--sheet", "80,60", "--time", 0.3, "-o", out)
    assert done.exit_code == 0, done.output
    listed = json.loads((out / "slices.json").read_text("utf-8"))
    assert [each["part"] for each in listed["slices"]] == ["front", "front", "middle", "middle", "back", "back"]
    layers = [chain.attributes.layer for chain in read_drawing(out / "slice-003.dxf", ReadOptions()).chains]
    assert layers.count("CUT") == 1 and layers.count("REGISTRATION") == 2 and layers.count("MARK") >= 1
    assert (out / "assembled.png").stat().st_size > 5000
    assert len(json.loads((out / "placements.json").read_text("utf-8"))) == 6
    assert run(tmp_path / "ball.stl", "--thickness", 15, "-o", out).exit_code == 0, "its own files are replaced"


def test_an_open_mesh_is_refused_with_its_file(tmp_path: Path) -> None:
    write_stl(tmp_path / "open.stl", sphere(15.0, rings=8)[:-1])
    done = run(tmp_path / "open.stl", "--thickness", 5, "-o", tmp_path / "out")
    assert isinstance(done.exception, JobError) and done.exception.code == "slice-open"
    assert "open.stl" in str(done.exception) and not (tmp_path / "out").exists()
