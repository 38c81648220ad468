# SPDX-License-Identifier: LGPL-2.1-or-later
"""`cncstepper nest`: the files that it writes, what it prints, and orders that it refuses."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import shapely
from click.testing import CliRunner, Result
from shapely import LineString, Polygon, affinity

from CNCStepper.cli.common.language import OVERRIDE
from CNCStepper.cli.main import group
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.errors import JobError
from CNCStepper.job.drawings import program_paths
from CNCStepper.job.nesting.order_file import read_order
from CNCStepper.job.slicing.slice_programs import on_sheets, write_programs
from CNCStepper.job.templates.template import read_template
from CNCStepper.nesting.nesting_model import Placement, placed

ROOT = Path(__file__).parents[4]
TRIANGLE = [[0.0, 0.0], [20.0, 0.0], [0.0, 15.0]]
ORDER = """
kerf_mm = 0.5
gap_mm = 1.0
margin_mm = 2.0
[[sheet]]
size_mm = [120.0, 80.0]
[[sheet]]
drawing = "remnant.dxf"
[[part]]
drawing = "../gasket.dxf"
layer = "CUT"
count = {count}
[[part]]
diameter_mm = 12.0
rotations_deg = "any"
count = 3
"""


def run(*words: object) -> Result:
    return CliRunner().invoke(group, ["nest", *map(str, words)])


def instance(folder: Path, items: list[dict], height: object = 30.0) -> Path:
    path = folder / "instance.json"
    path.write_text(json.dumps({"name": "x", "strip_height": height, "items": items}), encoding="utf-8")
    return path


@pytest.mark.parametrize("own", [True, False])
def test_an_instance_gives_placements_and_its_density_last(
    tmp_path: Path, own: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    items = [{"demand": 6, "rotations_deg": [0.0, 180.0], "polygon": [*TRIANGLE, TRIANGLE[0]]}]
    done = run(instance(tmp_path, items), "--time", 3, "-o", tmp_path / "out", *["--no-spyrrow"] * own)
    assert done.exit_code == 0, done.output
    rows = json.loads((tmp_path / "out" / "placements.json").read_text("utf-8"))
    assert len(rows) == 6 and all(row["sheet"] == 0 and row["item"] == 0 for row in rows)
    parts = [
        affinity.translate(affinity.rotate(Polygon(TRIANGLE), row["rotation_deg"], origin=(0, 0)), row["x"], row["y"])
        for row in rows
    ]
    assert all(part.bounds[1] > -1e-6 and part.bounds[3] < 30 + 1e-6 and part.bounds[0] > -1e-6 for part in parts)
    assert all(one.intersection(two).area < 1e-4 for n, one in enumerate(parts) for two in parts[:n])
    density = 6 * 150.0 / (30.0 * max(part.bounds[2] for part in parts))
    assert done.stdout.splitlines()[-1] == f"density {density:.3f}" and density > 0.7
    assert (tmp_path / "out" / "nest.png").stat().st_size > 5000
    monkeypatch.setenv(OVERRIDE, "pt")
    again = run(instance(tmp_path, items), "--time", 1, "-o", tmp_path / "out", "--no-spyrrow")
    assert again.exit_code == 0, "its own files are replaced"
    assert "6 peças em uma faixa" in again.output.splitlines(), "no value stays English in a Portuguese sentence"


def test_an_order_of_drawings_gives_drawings_and_a_remnant_that_is_a_sheet(tmp_path: Path) -> None:
    drawn, folder = tmp_path / "gasket.dxf", tmp_path / "orders"
    folder.mkdir()
    write_plate(drawn)
    (folder / "remnant.dxf").write_bytes(drawn.read_bytes())
    order = folder / "order.toml"
    order.write_text(ORDER.format(count=1), encoding="utf-8")
    done = run(order, "--time", 1, "-o", folder / "out", "--no-spyrrow")
    assert done.exit_code == 0, done.output
    chains = read_drawing(folder / "out" / "sheet-0.dxf", ReadOptions()).chains
    arcs = [chain for chain in chains if chain.attributes.layer == "CUT" and chain.curve.bulge.any()]
    assert len(arcs) == 4, "the hole of the plate and three discs are arcs still"
    remnant = next((folder / "out").glob("remnant-0-*.dxf"))
    order.write_text(f'[[sheet]]\ndrawing = "out/{remnant.name}"\n[[part]]\nsize_mm = [5.0, 5.0]\n', encoding="utf-8")
    done = run(order, "--time", 0.5, "-o", folder / "next", "--no-spyrrow")
    assert done.exit_code == 0, done.output


def write_plate(path: Path) -> None:
    from CNCStepper.drawing.drawing import Attributes, Chain, Drawing
    from CNCStepper.drawing.writers.dxf_writer import dxf_bytes
    from CNCStepper.geometry.curve import circle, from_points

    cut = Attributes(layer="CUT")
    outline = from_points([(0, 0), (60, 0), (60, 40), (0, 40)], closed=True)
    chains = Chain(outline, cut), Chain(circle((30.0, 20.0), 15.0), cut)
    path.write_bytes(dxf_bytes(Drawing(chains)))


def test_parts_without_a_place_are_told_and_the_exit_is_1(tmp_path: Path) -> None:
    write_plate(tmp_path / "gasket.dxf")
    folder = tmp_path / "orders"
    folder.mkdir()
    write_plate(folder / "remnant.dxf")
    (folder / "order.toml").write_text(ORDER.format(count=5), encoding="utf-8")
    done = run(folder / "order.toml", "--time", 0.5, "-o", folder / "out", "--no-spyrrow")
    assert done.exit_code == 1
    assert "of gasket: the sheets are full" in done.output


SQUARE = {"polygon": [[0, 0], [5, 0], [5, 5], [0, 5]]}


@pytest.mark.parametrize(
    ("item", "code"),
    [
        ({"polygon": [[0, 0], [5, 5], [5, 0], [0, 5]]}, "nest-crossing"),
        ({"polygon": [[0, 0], [5, 0], [10, 0]]}, "nest-crossing"),
        ({"polygon": [[0, 0], [1e-5, 0], [1e-5, 1e-5]]}, "nest-area"),
        ({"polygon": [[0, 0], [5, 0]]}, "nest-corners"),
        ({"polygon": [[0, 0], [5, 0], [float("nan"), 5]]}, "nest-number"),
        ({"polygon": [[0, 0], [5, 0], [1e300, 5]]}, "nest-number"),
        ({"polygon": "no"}, "nest-corners"),
        ({"polygon": [[0, 0], [50, 0], [50, 50], [0, 50]]}, "nest-part-large"),
        (SQUARE | {"demand": 10**9}, "nest-count"),
        (SQUARE | {"demand": 0}, "nest-count"),
        (SQUARE | {"demand": 1.5}, "nest-count"),
        (SQUARE | {"rotations_deg": [float("inf")]}, "nest-number"),
        (SQUARE | {"rotations_deg": []}, "nest-rotations"),
        (7, "nest-instance"),
    ],
)
def test_hostile_items_are_refused_by_name(tmp_path: Path, item: dict, code: str) -> None:
    begun_s = time.monotonic()
    done = run(instance(tmp_path, [SQUARE, item]), "--time", 60, "-o", tmp_path / "out")
    assert isinstance(done.exception, JobError) and done.exception.code == code
    assert "item 1" in str(done.exception) and time.monotonic() - begun_s < 20.0
    assert not (tmp_path / "out").exists()


BOW = "[[sheet]]\nsize_mm = [5.0, 5.0]\n[[part]]\npolygon_mm = [[0, 0], [4, 2], [4, 0], [0, 2]]\n"


def test_keys_and_sheets_of_an_order_are_checked(tmp_path: Path) -> None:
    path = tmp_path / "order.toml"
    for text, words in (
        ("[[sheet]]\nsize_mm = [5.0, 5.0]\n[[part]]\nsize_mm = [1.0, 1.0]\ncuont = 3\n", "cuont"),
        ("[[sheet]]\n[[part]]\nsize_mm = [1.0, 1.0]\n", "a sheet needs one of size_mm, drawing, strip_height_mm"),
        ("[[sheet]]\nsize_mm = [5.0, 5.0]\n[[part]]\nsize_mm = [1.0, 1.0]\ndiameter_mm = 2.0\n", "a part needs one of"),
        ("[[sheet]]\nsize_mm = [5.0, 5.0]\n[[part]]\ndrawing = 'no.dxf'\n", "no.dxf"),
        (BOW, "the outline of part 0 crosses itself .value X2 Y1."),
        (
            BOW.replace(
                "[[0, 0], [4, 2], [4, 0], [0, 2]]", "[[0, 0], [4, 0], [4, 2]]\nholes_mm = [[[8, 8], [9, 8], [9, 9]]]"
            ),
            "lies beyond its outline",
        ),
    ):
        path.write_text(text, encoding="utf-8")
        with pytest.raises(JobError, match=words):
            read_order(path)


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for one process")
def test_ctrl_c_ends_the_search_with_what_it_has(tmp_path: Path) -> None:
    path = instance(tmp_path, [SQUARE | {"demand": 9}])
    words = [sys.executable, "-m", "CNCStepper.cli.main", "nest", path, "--time", "300", "-o", tmp_path / "out"]
    process = subprocess.Popen([*map(str, words)], cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stderr and "Ctrl+C ends it" in process.stderr.readline()
    time.sleep(1.0)
    process.send_signal(signal.SIGINT)
    output, errors = process.communicate(timeout=120)
    assert process.returncode == 0, errors
    assert output.splitlines()[-1].startswith("density 0.")


def test_the_program_of_common_lines_cuts_every_part_free_in_its_size(tmp_path: Path) -> None:
    text = (ROOT / "examples" / "orders" / "common-lines.toml").read_text(encoding="utf-8")
    for more, fewer in (("[300.0, 200.0]", "[140.0, 105.0]"), ("count = 6", "count = 2"), ("count = 4", "count = 2")):
        assert more in text
        text = text.replace(more, fewer)
    path = tmp_path / "order.toml"
    path.write_text(text, encoding="utf-8")
    result = run(path, "--time", "1", "--no-spyrrow", "-o", tmp_path)
    assert result.exit_code == 0, result.output
    assert "common lines: " in result.stdout and "blocks of parts" in result.stdout
    layers = {chain.attributes.layer for chain in read_drawing(tmp_path / "sheet-0.dxf", ReadOptions()).chains}
    assert layers == {"SHEET", "CUT", "COMMON"}
    template = read_template(ROOT / "examples" / "templates" / "common-lines.toml")
    (made,) = write_programs(on_sheets(template, (140.0, 105.0)), tmp_path, [0], 3.0)
    assert made.is_sound, (made.error, made.refused)
    cut = program_paths.read(tmp_path / "job-0.nc", ReadOptions(), lambda share: None).chains
    ways = [LineString(chain.curve.points(0.002)) for chain in cut]
    order = read_order(path)
    rows = json.loads((tmp_path / "placements.json").read_text(encoding="utf-8"))
    places = [Placement(row["sheet"], row["item"], row["x"], row["y"], row["rotation_deg"]) for row in rows]
    parts = [placed(order.items[each.item].exact, each) for each in places]
    assert len(parts) == 4
    band = shapely.union_all([way.buffer(0.6 * order.kerf_mm + 0.01) for way in ways])
    for part in parts:
        assert band.covers(part.exterior), "its whole outline is cut"
        assert min(way.distance(part) for way in ways) >= order.kerf_mm / 2.0 - 0.01


def test_common_lines_and_a_gap_do_not_go_together(tmp_path: Path) -> None:
    (tmp_path / "order.toml").write_text(
        "gap_mm = 1.0\n[[sheet]]\nsize_mm = [90.0, 80.0]\n[[part]]\nsize_mm = [9.0, 8.0]\n", encoding="utf-8"
    )
    with pytest.raises(JobError) as refused:
        CliRunner().invoke(
            group, ["nest", str(tmp_path / "order.toml"), "--common-lines", "-o", str(tmp_path / "out")],
            catch_exceptions=False, standalone_mode=False,
        )  # fmt: skip
    assert refused.value.code == "nest-common-gap"
