# SPDX-License-Identifier: LGPL-2.1-or-later
"""What of an operation does not fit into the stock is said of its parameters, before anything is computed."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.catalogue import CYCLES, cycle_class
from CNCStepper.errors import Place
from CNCStepper.geometry.curve import circle, from_points
from CNCStepper.job import stock_fit
from CNCStepper.job.stock_fit import drawn, region_outside_stock, stock_findings
from CNCStepper.machine.profile import validated
from CNCStepper.simulation.finding import Finding, worst_first
from CNCStepper.simulation.stock import Cylinder, Stock

STOCK = Stock((100.0, 70.0, 10.0), "top-centre")
SQUARE = from_points([(-10, -10), (10, -10), (10, 10), (-10, 10)], closed=True)
CLEAR = {"stepdown_mm": 1.0, "stepover_mm": 2.0}
POINTS = {"pattern": {"kind": "points", "points_mm": [(0.0, 0.0), (20.0, 0.0)]}}
WITHIN: dict[str, dict[str, Any]] = {  # parameters of every cycle that fit into the stock
    "bore": {**POINTS, "diameter_mm": 8.0, "pitch_mm": 1.0},
    "circular_pocket": {**CLEAR, "radius_mm": 10.0},
    "contour": {"curves": (SQUARE,)},
    "drill": POINTS,
    "elliptical_pocket": {**CLEAR, "radius_x_mm": 20.0, "radius_y_mm": 10.0},
    "engrave": {"curves": (SQUARE,)},
    "wire_cut": {"curves": (SQUARE,)},
    "sheet_cut": {"curves": (SQUARE,)},
    "face": {**CLEAR, "outlines": (SQUARE,)},
    "pocket": {**CLEAR, "outlines": (SQUARE,)},
    "rectangular_pocket": {**CLEAR, "corner_a_mm": (-10.0, -10.0), "corner_b_mm": (10.0, 10.0)},
    "thread": {**POINTS, "major_diameter_mm": 8.0, "pitch_mm": 1.0},
}
DEEP = [name for name in WITHIN if "depth_mm" in cycle_class(name).model_fields]  # a wire cuts through
MOVED = {"elliptical_pocket": {"centre_mm": (45.0, 0.0)}}  # which has no offset


def cycle(name: str, **values: Any) -> Any:
    depth = {"depth_mm": 5.0} if name in DEEP else {}
    return validated(cycle_class(name), {"cycle": name, "tool": 1, **depth, **WITHIN[name], **values}, name)


def told(name: str, stock: Stock = STOCK, **values: Any) -> list[tuple[str, str]]:
    return [(one.severity, one.code) for one in stock_findings(cycle(name, **values), stock)]


def test_every_cycle_is_known() -> None:
    assert WITHIN.keys() == CYCLES.keys()
    assert all(drawn(cycle(name)) for name in CYCLES)


@pytest.mark.parametrize("name", WITHIN)
def test_what_fits_is_not_warned_of(name: str) -> None:
    assert told(name, **({"depth_mm": 10.0} if name in DEEP else {})) == []


@pytest.mark.parametrize("name", DEEP)
def test_a_depth_below_the_stock_is_told_and_is_an_error_where_it_reaches_the_table(name: str) -> None:
    (shallow,) = stock_findings(cycle(name, depth_mm=10.2), STOCK)
    assert (shallow.severity, shallow.code, shallow.value, shallow.limit) == ("warning", "below-stock", 10.2, 10.0)
    assert told(name, depth_mm=60.0) == [("error", "below-stock")]


@pytest.mark.parametrize("name", WITHIN)
def test_a_region_outside_the_stock_is_told_and_how_far(name: str) -> None:
    values = MOVED.get(name, {"offset_mm": (45.0, 0.0)})
    (found,) = stock_findings(cycle(name, **values), STOCK)
    assert (found.severity, found.code) == ("warning", "beside-stock")
    reach_mm = {"bore": 24.0, "thread": 24.0, "drill": 20.0, "elliptical_pocket": 20.0}.get(name, 10.0)
    assert found.value == pytest.approx(45.0 + reach_mm - 50.0, abs=0.01)


def test_the_worst_comes_first() -> None:
    assert told("contour", depth_mm=30.0, offset_mm=(60.0, 0.0)) == [
        ("error", "below-stock"),
        ("warning", "beside-stock"),
    ]


def test_what_goes_through_counts() -> None:
    assert told("drill", depth_mm=10.0, through_mm=1.0) == [("warning", "below-stock")]


def test_the_corner_of_a_box_around_a_cylinder_lies_outside_it() -> None:
    round_stock = Cylinder((28.0, 28.0, 10.0), "top-centre")
    assert told("contour", round_stock) == [("warning", "beside-stock")]
    assert told("circular_pocket", round_stock, radius_mm=14.0) == []


def test_a_shape_may_end_on_the_stocks_edge() -> None:
    assert told("rectangular_pocket", corner_a_mm=(-50.0, -35.0), corner_b_mm=(50.0, 35.0)) == []
    assert told("contour", curves=(circle((0.0, 0.0), 35.0),)) == []


def test_findings_are_in_the_order_of_their_weight_then_of_their_lines() -> None:
    found = [
        Finding(severity, "code", Place("a.nc", line), "text")
        for severity, line in (("info", 1), ("warning", 2), ("error", 9), ("error", 3), ("warning", 1))
    ]
    order = [(one.severity, one.place.line) for one in worst_first(found)]
    assert order == [("error", 3), ("error", 9), ("warning", 1), ("warning", 2), ("info", 1)]


@pytest.mark.parametrize("outline", [Stock((100, 80, 10), "top-centre"), Cylinder((90, 90, 10), "top-centre")])
def test_what_lies_farthest_outside_is_found_among_the_outermost_points(outline: Stock) -> None:
    points = np.random.default_rng(7).uniform(-70, 70, (3000, 2))  # seed 7
    every_mm = shapely.distance(shapely.points(points), outline.outline).max()
    finding = region_outside_stock([points], outline)
    assert finding is not None and finding.value == pytest.approx(every_mm, abs=1e-9)
    assert region_outside_stock([points / 10.0], outline) is None


def test_equal_holes_are_drawn_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[float] = []
    monkeypatch.setattr(stock_fit, "circle", lambda at, radius_mm: made.append(radius_mm) or circle(at, radius_mm))
    grid = {"kind": "grid", "origin_mm": (0, 0), "spacing_mm": (5, 5), "count": (30, 30)}
    lines = drawn(cycle("bore", diameter_mm=4.0, pattern=grid))
    assert len(lines) == 900 and made == [2.0]
    assert np.hypot(*(lines[-1] - (145, 145)).T) == pytest.approx(np.full(len(lines[-1]), 2.0))
