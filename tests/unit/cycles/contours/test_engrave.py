# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engraving along open and closed curves, to and fro at several depths."""

from __future__ import annotations

import math

import numpy as np
import pytest
from shapely import LineString, points

from CNCStepper.cycles.contours.engrave import Engrave
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.toolpath import ARC_CCW, ARC_CW, LINE, RAPID, Toolpath
from helpers.cycles.ellipse_judge import FLAT_MM, runs, spans
from helpers.cycles.product_verdict import cut, tool

OPEN = Curve(np.array([(0.0, 0), (10, 0), (10, 10)]), np.array([0.0, math.tan(math.pi / 8)]))
SQUARE = from_points([(0, 0), (5, 0), (5, 5), (0, 5)], closed=True)


def work(path: Toolpath) -> list[tuple[int, list[float]]]:
    rows = path.table()
    return [
        (int(kind), [round(value, 9) + 0.0 for value in end]) for kind, end in zip(rows.kind, rows.end, strict=True)
    ]


def test_an_open_line_is_cut_to_and_fro() -> None:
    path, answer = cut(Engrave(tool=1, curves=(OPEN,), depth_mm=2, stepdown_mm=1.5))
    assert work(path) == [
        (RAPID, [0, 0, 10]),
        (RAPID, [0, 0, 2]),
        (LINE, [0, 0, -1]),
        (LINE, [10, 0, -1]),
        (ARC_CCW, [10, 10, -1]),
        (LINE, [10, 10, -2]),
        (ARC_CW, [10, 0, -2]),
        (LINE, [0, 0, -2]),
        (RAPID, [0, 0, 10]),
    ]
    assert answer.figures == {
        "ap_mm": 1,
        "levels": 2,
        "lines": 1,
        "length_mm": pytest.approx(10 + 5 * math.pi / math.sqrt(2)),
    }
    assert path.table().centre[4][:2] == pytest.approx((5, 5)) and path.table().centre[6][:2] == pytest.approx((5, 5))


def test_a_closed_line_goes_round_and_round() -> None:
    path, _ = cut(Engrave(tool=1, curves=(SQUARE,), depth_mm=1, stepdown_mm=0.5, closed=True))
    corners = [end[:2] for kind, end in work(path) if kind == LINE]
    assert corners == [[0, 0], [5, 0], [5, 5], [0, 5], [0, 0]] * 2


def test_plunges_are_slow_and_rapids_high() -> None:
    path, _ = cut(
        Engrave(tool=1, curves=(OPEN, SQUARE, circle((20, 20), 3)), depth_mm=3, stepdown_mm=1), tool(2, shape="ball")
    )
    rows = path.table()
    assert rows.end[rows.kind == RAPID, 2].min() == 2.0 and rows.end[-1, 2] == 10.0
    for run in runs(path, 2):
        if run.kind != RAPID and run.fall_mm:
            assert run.run_mm == 0 and run.feed_mm_min == 200
        elif run.kind != RAPID:
            assert run.feed_mm_min == 800 and run.xyz[0, 2] < 0
        elif run.run_mm:
            assert run.xyz[:, 2].min() == 10.0
    assert [span.name for span in spans(path, "contour")] == ["line 1", "line 2", "line 3"]
    assert (rows.kind == RAPID).sum() == 3 * 3


def test_the_line_is_moved_and_simplified_within_its_promise() -> None:
    drawn = np.column_stack([np.linspace(0, 50, 800), np.sin(np.linspace(0, 12, 800))])
    operation = Engrave(tool=1, curves=(from_points(drawn),), depth_mm=1, simplify_mm=0.05, offset_mm=(3, -4))
    path, answer = cut(operation)
    line = np.vstack([run.xyz[:, :2] for run in runs(path) if run.kind != RAPID and run.run_mm])
    assert len(path) < 100
    assert LineString(line).distance(points(drawn + (3, -4))).max() <= 0.05 + FLAT_MM  # noqa: RUF005
    assert answer.removals[0].tolerance_mm == pytest.approx(0.06) and answer.removals[0].bottom_mm == -1
    assert LineString(line).hausdorff_distance(answer.removals[0].region) < 0.001


def test_without_a_stepdown_there_is_one_level() -> None:
    assert cut(Engrave(tool=1, curves=(OPEN,), depth_mm=4))[1].figures["levels"] == 1


def test_it_comes_back_from_json_as_it_went() -> None:
    operation = Engrave(tool=1, curves=(OPEN, circle((1 / 3, 2), 0.1)), depth_mm=1)
    assert Engrave.model_validate_json(operation.model_dump_json()) == operation
    assert Engrave.model_validate(operation.model_dump()) == operation
    assert Engrave.model_validate(operation.model_dump()) != operation.model_copy(update={"curves": (SQUARE,)})


def test_a_pass_deeper_than_the_tool_is_wide_is_told() -> None:
    line = from_points([(0, 0), (20, 0)])
    shallow, deep = (cut(Engrave(tool=1, curves=(line,), depth_mm=mm), tool(3.0))[1].warnings for mm in (3.0, 3.1))
    assert shallow == [] and deep == [
        "one pass is 3.1 mm deep, deeper than the tool's diameter of 3 mm; give stepdown_mm"
    ]
