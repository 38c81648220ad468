# SPDX-License-Identifier: LGPL-2.1-or-later
"""The shapes of a job file: drawn in every way, named by operations, refused with the name."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import ezdxf
import numpy as np
import pytest

from CNCStepper.errors import JobError
from CNCStepper.job.model import load_job, operation_of, save_job
from CNCStepper.job.shapes import SHAPE_KEYS, Drawn, Shapes, read_shapes, with_curves

SQUARE = {"name": "square", "polygon_mm": [[0, 0], [10, 0], [10, 10], [0, 10]]}
ENGRAVING = {"cycle": "engrave", "tool": 1, "depth_mm": 1}
JOB = """
machine = "table-a"
clearance_mm = 10
retract_mm = 2
[stock]
size_mm = [60, 60, 10]
origin = "top-left-front"
[[tool]]
number = 1
shape = "engraver"
diameter_mm = 1
feed_mm_min = 300
plunge_mm_min = 100
spindle_rpm = 10000
"""


def shapes_of(*tables: dict[str, Any], folder: Path = Path(".")) -> Shapes:
    return read_shapes(tables, folder, "job.toml", Drawn())


def drawing(path: Path) -> None:
    """Write a layer with a closed square of loose lines, a circle, and a line that nearly meets another; and a text."""
    document = ezdxf.new(units=ezdxf.units.MM)
    space = document.modelspace()
    corners = [(0, 0), (20, 0), (20, 20), (0, 20)]
    for begin, end in zip(corners, corners[1:] + corners[:1], strict=True):
        space.add_line(begin, end, dxfattribs={"layer": "Corte"})
    space.add_circle((40, 10), 5, dxfattribs={"layer": "Corte"})
    space.add_line((0, 30), (10, 30), dxfattribs={"layer": "Aberto"})
    space.add_line((10.05, 30), (20, 30), dxfattribs={"layer": "Aberto"})
    space.add_point((0, 0), {"layer": "Aberto"})
    document.saveas(path)


@pytest.mark.parametrize(
    ("way", "area_mm2", "length_mm"),
    [
        ({"polygon_mm": [[0, 0], [10, 0], [10, 10], [0, 10]]}, 100.0, 40.0),
        ({"circle_mm": {"centre": [5, 5], "radius": 3}}, 9 * math.pi, 6 * math.pi),
        ({"rectangle_mm": {"corner_a": [10, 20], "corner_b": [0, 0]}}, 200.0, 60.0),
        (
            {"rectangle_mm": {"corner_a": [0, 20], "corner_b": [10, 0], "corner_radius": 2}},
            200.0 - (4 - math.pi) * 4,
            60.0 - 16 + 4 * math.pi,
        ),
        (
            {"rectangle_mm": {"corner_a": [0, 0], "corner_b": [10, 10], "corner_radius": 5}},
            25 * math.pi,
            10 * math.pi,
        ),
        ({"ellipse_mm": {"centre": [1, 2], "radius_x": 4, "radius_y": 9, "rotation_deg": 20}}, 36 * math.pi, None),
        ({"curve": {"xy": [[0, 0], [4, 0], [0, 0]], "bulge": [1, 1]}}, 4 * math.pi, 4 * math.pi),
    ],
)
def test_every_way_of_drawing_gives_the_closed_curve_counter_clockwise(
    way: dict[str, Any], area_mm2: float, length_mm: float | None
) -> None:
    (curve,) = shapes_of({"name": "a", **way}).curves["a"]
    assert curve.closed and curve.area_mm2 == pytest.approx(area_mm2, rel=1e-4)
    assert length_mm is None or curve.length_mm == pytest.approx(length_mm)


def test_points_come_from_a_file_beside_the_job_closed_or_not(tmp_path: Path) -> None:
    (tmp_path / "linha.csv").write_text("0,0\n5,0\n5,5\n", encoding="utf-8")
    table = {"name": "a", "points": "linha.csv"}
    shapes = shapes_of(table, table | {"name": "b", "closed": True}, folder=tmp_path)
    assert [shapes.curves[name][0].closed for name in "ab"] == [False, True]


def test_a_layer_of_a_drawing_gives_all_its_chains_and_tells_what_is_not_in_them(tmp_path: Path) -> None:
    drawing(tmp_path / "peça 1.dxf")
    dxf = {"file": "peça 1.dxf", "layer": "corte"}
    shapes = shapes_of(
        {"name": "cut", "dxf": dxf},
        {"name": "inches", "dxf": dxf | {"unit_mm": 25.4}},
        {"name": "open", "dxf": dxf | {"layer": "Aberto"}},
        folder=tmp_path,
    )
    areas = sorted(curve.area_mm2 for curve in shapes.curves["cut"])
    assert areas == pytest.approx([25 * math.pi, 400.0])
    assert sorted(curve.area_mm2 for curve in shapes.curves["inches"]) == pytest.approx(
        [area * 25.4**2 for area in areas]
    )
    gap, point = shapes.notes
    assert "'open'" in gap and "0.05 mm apart at X10.025 Y30.000" in gap
    assert "POINT" in point


@pytest.mark.slow
def test_one_job_reads_a_bounded_number_of_drawings_and_of_points(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    drawing(tmp_path / "a.dxf")
    (tmp_path / "a.csv").write_text("0,0\n5,0\n5,5\n", encoding="utf-8")
    dxf = {"file": "a.dxf", "layer": "corte"}
    many = [{"name": f"{n}", "dxf": dxf | {"tolerance_mm": 0.01 + n / 1000}} for n in range(33)]
    same = [{"name": f"{n}", "dxf": dxf} for n in range(100)]
    assert len(shapes_of(*same, folder=tmp_path).curves) == 100
    with pytest.raises(JobError, match=r"too many drawings.*value 33, limit 32") as error:
        shapes_of(*many, folder=tmp_path)
    assert "job.toml shape 33" in str(error.value)
    monkeypatch.setattr("CNCStepper.job.shapes.MOST_DRAWN", 10)
    points = [{"name": f"{n}", "points": "a.csv"} for n in range(6)]
    assert len(shapes_of(*points[:5], folder=tmp_path).curves) == 5
    with pytest.raises(JobError, match=r"too many lines and arcs in its files.*value 12, limit 10"):
        shapes_of(*points, folder=tmp_path)
    drawn = Drawn()
    for _ in range(5):
        operation_of(ENGRAVING | {"points": "a.csv"}, tmp_path, "job.toml", drawn=drawn)
    with pytest.raises(JobError, match=r"too many lines and arcs in its files"):
        operation_of(ENGRAVING | {"points": "a.csv"}, tmp_path, "job.toml", drawn=drawn)


def test_operations_name_shapes_one_or_several_and_the_cycle_gets_curves() -> None:
    shapes = shapes_of(SQUARE, {"name": "disc", "circle_mm": {"centre": [5, 5], "radius": 3}})
    one = operation_of(ENGRAVING | {"region": "square"}, Path(), "job.toml", shapes)
    both = operation_of(ENGRAVING | {"curves": ["square", "disc"]}, Path(), "job.toml", shapes)
    mixed = operation_of(ENGRAVING | {"curves": "disc", "region": ["square"]}, Path(), "job.toml", shapes)
    assert [curve.area_mm2 for curve in one.curves] == [100.0]
    assert [len(curve) for curve in both.curves] == [4, 2]
    assert [len(curve) for curve in mixed.curves] == [2, 4]


def test_keys_within_a_table_name_shapes_too() -> None:
    shapes = shapes_of({"name": "hole", "circle_mm": {"centre": [5, 5], "radius": 3}})
    raw = {"cycle": "drill", "pattern": {"kind": "circles", "circles": ["hole"]}}
    assert with_curves(raw, shapes, "job.toml")["pattern"]["circles"] == shapes.curves["hole"]
    assert raw["pattern"] == {"kind": "circles", "circles": ["hole"]}


def test_the_table_of_keys_is_true_of_the_cycles() -> None:
    from CNCStepper.cycles.catalogue import CYCLES, cycle_class

    for cycle, keys in SHAPE_KEYS.items():
        if cycle in CYCLES:
            fields = cycle_class(cycle).model_fields
            assert {key.field.partition(".")[0] for key in keys} <= set(fields), cycle


SHAPE_REFUSALS = [
    ({}, "needs one of polygon_mm"),
    ({"polygon_mm": [[0, 0], [1, 0]]}, "polygon_mm"),
    ({"polygon_mm": [[0, 0], [1, 0], [1, float("nan")]]}, "polygon_mm"),
    ({"circle_mm": {"centre": [0, 0], "radius": 0}}, "radius"),
    ({"circle_mm": {"centre": [0, 0], "raduis": 1}}, "raduis"),
    ({"rectangle_mm": {"corner_a": [0, 0], "corner_b": [0, 5]}}, "differ in x and in y"),
    ({"rectangle_mm": {"corner_a": [0, 0], "corner_b": [4, 5], "corner_radius": 2.1}}, "half of its shorter side"),
    ({"polygon_mm": [[0, 0], [1, 0], [1, 1]], "circle_mm": {"centre": [0, 0], "radius": 1}}, "polygon_mm and circle"),
    ({"polygon_mm": [[0, 0], [1, 0], [1, 1]], "closed": True}, "closed belongs to points"),
    ({"points": "none.csv"}, "none.csv"),
    ({"dxf": {"file": "none.dxf", "layer": "0"}}, "none.dxf"),
    ({"curve": {"xy": [[0, 0]], "bulge": []}}, "not a curve"),
]


@pytest.mark.parametrize(("way", "told"), SHAPE_REFUSALS)
def test_a_bad_shape_is_refused_with_file_and_reason(way: dict[str, Any], told: str) -> None:
    with pytest.raises(JobError) as caught:
        shapes_of(SQUARE, {"name": "a", **way})
    assert told in str(caught.value) and "job.toml shape 2" in str(caught.value)


def test_two_shapes_of_one_name_are_refused() -> None:
    with pytest.raises(JobError, match=r"'square'.*rename"):
        shapes_of(SQUARE, SQUARE)


@pytest.mark.parametrize(
    ("named", "told"),
    [
        ({"region": "sqare"}, ["region", "'sqare'", "'square', 'line'"]),
        ({"curves": ["square", "sqare"]}, ["curves", "'sqare'"]),
        ({"region": ["line"]}, ["region needs a closed shape", "'line'", "(2.0, 3.0)"]),
        ({"region": 7}, ["region must be the name of a shape"]),
    ],
)
def test_a_wrong_name_is_refused_with_file_operation_key_and_the_known_names(
    named: dict[str, Any], told: list[str]
) -> None:
    shapes = shapes_of(SQUARE, {"name": "line", "curve": {"xy": [[2, 3], [4, 4]], "bulge": [0]}})
    with pytest.raises(JobError) as caught:
        operation_of(ENGRAVING | named, Path(), "job.toml operation 3", shapes)
    assert all(text in str(caught.value) for text in [*told, "job.toml operation 3"])


def test_a_saved_job_holds_the_curves_and_the_notes_of_the_drawing(tmp_path: Path) -> None:
    drawing(tmp_path / "a.dxf")
    shape = '[[shape]]\nname = "a"\ndxf = { file = "a.dxf", layer = "Aberto" }\n'
    operation = '[[operation]]\ncycle = "engrave"\ntool = 1\ncurves = "a"\ndepth_mm = 1\n'
    (tmp_path / "job.toml").write_text(JOB + shape + operation, encoding="utf-8")
    job, _ = load_job(tmp_path / "job.toml")
    save_job(job, tmp_path / "elsewhere.json")
    (tmp_path / "a.dxf").unlink()
    again, _ = load_job(tmp_path / "elsewhere.json")
    assert again == job and len(job.notes) == 2


def test_cycles_are_told_the_stock_and_the_parts_that_stand(tmp_path: Path) -> None:
    shape = '[[shape]]\nname = "a"\ncircle_mm = { centre = [30, 30], radius = 5 }\n'
    operation = '[[operation]]\ncycle = "engrave"\ntool = 1\ncurves = "a"\ndepth_mm = 1\n'
    (tmp_path / "job.toml").write_text(JOB + shape + operation, encoding="utf-8")
    job, _ = load_job(tmp_path / "job.toml")
    setup = job.setup(job.operation[0])
    assert setup.stock is not None and setup.stock.area_mm2 == 3600.0 and setup.keep == ()
    assert np.array_equal(setup.stock.xy[0], (0.0, 0.0))


@pytest.mark.parametrize(
    ("keys", "areas_mm2"),
    [
        ({}, (100 * math.pi, 400.0)),
        ({"layer": "C*"}, (100 * math.pi, 400.0)),
        ({"without": [{"layer": "corte 2"}]}, (400.0,)),
        ({"layer": "corte*", "nesting": 1}, (100 * math.pi,)),
        ({"nesting": 0, "offset_mm": [5, 7], "rotation_deg": 90}, (400.0,)),
    ],
)
def test_chains_of_a_drawing_are_selected_and_placed(tmp_path: Path, keys: dict[str, Any], areas_mm2: tuple) -> None:
    document = ezdxf.new(units=ezdxf.units.MM)
    space = document.modelspace()
    space.add_lwpolyline([(0, 0), (20, 0), (20, 20), (0, 20)], close=True, dxfattribs={"layer": "Corte"})
    space.add_circle((10, 10), 10, dxfattribs={"layer": "Corte 2"})
    document.saveas(tmp_path / "part.dxf")
    table = {"name": "part", "drawing": {"file": "part.dxf", **keys}}
    curves = shapes_of(table, folder=tmp_path).curves["part"]
    assert sorted(abs(curve.area_mm2) for curve in curves) == pytest.approx(sorted(areas_mm2))
    if "offset_mm" in keys:
        assert curves[0].box_mm == pytest.approx((-15, 7, 5, 27))


def test_a_drawing_without_what_a_shape_wants_names_what_it_has(tmp_path: Path) -> None:
    drawing(tmp_path / "part.dxf")
    with pytest.raises(JobError) as refusal:
        shapes_of({"name": "a", "drawing": {"file": "part.dxf", "layer": "x*"}}, folder=tmp_path)
    assert refusal.value.code == "drawing-selection" and "'Corte'" in refusal.value.advice
    with pytest.raises(JobError, match=r"cannot be read"):
        shapes_of({"name": "a", "drawing": {"file": "part.xyz"}}, folder=tmp_path)


def test_a_drawing_is_mended_where_the_shape_says_so_and_the_notes_tell(tmp_path: Path) -> None:
    drawing(tmp_path / "part.dxf")
    table = {"name": "a", "drawing": {"file": "part.dxf", "layer": "Aberto", "mend": {"close_mm": 0.1}}}
    shapes = shapes_of(table, folder=tmp_path)
    assert [curve.length_mm for curve in shapes.curves["a"]] == pytest.approx([20])
    assert any("gaps were closed: 1" in note for note in shapes.notes)


def test_a_shape_of_the_library_is_drawn_by_its_dimensions() -> None:
    keys = {"kind": "flange", "holes": 4, "bore_diameter_mm": 0, "offset_mm": [50, 40], "rotation_deg": 45}
    every, holes = (shapes_of({"name": "f", "library": keys | {"part": part}}).curves["f"] for part in ("all", "holes"))
    assert len(every) == 5 and len(holes) == 4 and every[0].box_mm == pytest.approx((10, 0, 90, 80))
    assert holes[0].centres[0].tolist() == pytest.approx([50 + 30 * math.sqrt(0.5), 40 + 30 * math.sqrt(0.5)])


@pytest.mark.parametrize(
    ("library", "words"),
    [
        ({"kind": "blob"}, "no shape 'blob'"),
        ({"kind": "ring", "inner_diameter_mm": 50}, "must be larger than"),
        ({"kind": "ring", "thickness_mm": 50}, "no dimension 'thickness_mm'"),
        ({"kind": "slot", "part": "holes"}, "has no holes"),
        ({"kind": "slot", "offset_mm": "x"}, "offset_mm"),
        ({}, "kind"),
    ],
)
def test_a_library_shape_that_cannot_be_is_refused(library: dict[str, Any], words: str) -> None:
    with pytest.raises(JobError) as refusal:
        shapes_of({"name": "f", "library": library})
    assert words in str(refusal.value)


def test_freehand_points_become_few_arcs_within_the_tolerance(tmp_path: Path) -> None:
    chance = np.random.default_rng(4)
    angles = np.linspace(0, 2 * np.pi, 400)
    points = np.column_stack([40 * np.cos(angles), 25 * np.sin(angles)]) + chance.uniform(-0.08, 0.08, (400, 2))
    (tmp_path / "hand.csv").write_text("".join(f"{x:.4f},{y:.4f}\n" for x, y in points), "ascii")
    drawn, smooth = (
        shapes_of({"name": "h", "points": "hand.csv", "smooth_mm": mm}, folder=tmp_path).curves["h"][0]
        for mm in (0, 0.2)
    )
    assert len(drawn) == 399 and len(smooth) < 40 and smooth.bulge.any()
    assert float(smooth.distances_mm(drawn.xy).max()) <= 0.2 + 1e-9
    with pytest.raises(JobError, match="smooth_mm belongs to points"):
        shapes_of({"name": "c", "circle_mm": {"centre": [0, 0], "radius": 3}, "smooth_mm": 0.1})
