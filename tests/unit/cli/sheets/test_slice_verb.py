# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper slice`: its drawings, its list, and the nested pieces of a stack."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from CNCStepper.cli.main import group
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError
from helpers.solids.closed_meshes import sphere, write_stl

TEMPLATES = Path(__file__).parents[4] / "examples" / "templates"


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


@pytest.mark.parametrize(
    "process", ["laser", pytest.param("mill", marks=pytest.mark.slow), pytest.param("wire", marks=pytest.mark.slow)]
)
def test_each_nested_sheet_gets_a_program_that_is_proven(tmp_path: Path, process: str) -> None:
    write_stl(tmp_path / "ball.stl", sphere(15.0, rings=40))
    out, template = tmp_path / "out", TEMPLATES / f"slices-{process}.toml"
    thickness_mm = {"laser": 6, "mill": 10, "wire": 20}[process]
    words = ("--thickness", thickness_mm, "--sheet", "110,50", "--gap", 12, "--margin", 8, "--hole", 4, "--time", 0.3)
    done = run(tmp_path / "ball.stl", *words, "--template", template, "-o", out)
    assert done.exit_code == 0, done.output
    sheets = sorted(path.stem.removeprefix("sheet-") for path in out.glob("sheet-*.dxf"))
    assert sheets and f"{len(sheets)} of {len(sheets)} programs" in done.output
    for number in sheets:
        assert json.loads((out / f"job-{number}-report.json").read_text("utf-8"))["errors"] == 0
        assert (out / f"job-{number}-certificate.zip").exists() and (out / f"job-{number}.toml").exists()


def test_a_sheet_without_a_sound_program_is_told_and_the_exit_says_it(tmp_path: Path) -> None:
    write_stl(tmp_path / "ball.stl", sphere(15.0, rings=8))
    words = ("--thickness", 30, "--sheet", "60,60", "--time", 0.2, "--template", TEMPLATES / "slices-laser.toml")
    done = run(tmp_path / "ball.stl", *words, "-o", tmp_path / "out")
    assert done.exit_code == 1 and "chart-thickness" in done.output and "0 of 1 programs" in done.output


def test_words_that_do_not_go_together_are_refused(tmp_path: Path) -> None:
    write_stl(tmp_path / "ball.stl", sphere(15.0, rings=8))
    (tmp_path / "ball.step").write_text("ISO-10303-21;", "utf-8")
    alone = run(tmp_path / "ball.stl", "--thickness", 5, "--machine", "table-a", "-o", tmp_path / "out")
    assert alone.exit_code == 2 and "--template" in alone.output
    scaled = run(tmp_path / "ball.step", "--thickness", 5, "--scale", 2, "-o", tmp_path / "out")
    assert scaled.exit_code == 2 and "--scale is for STL" in scaled.output
