# SPDX-License-Identifier: LGPL-2.1-or-later
"""Polygons that hold a part of lines and arcs, and those within a sheet: never on the wrong side of the curve."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
import shapely

from CNCStepper.errors import GeometryError
from CNCStepper.geometry.curve import Curve, circle
from CNCStepper.geometry.region import Region
from CNCStepper.nesting.outlines import grown, holding_polygon, shrunk, simplified, within_polygon


@cache  # made by the first test, not at collection, where every worker would compile the kernels of regions
def plate() -> Region:
    """Return a plate with a round end, a round notch in its side and a round hole: arcs that bulge out and in."""
    outline = Curve(
        np.array([(0, 0), (40, 0), (40, 20), (25, 20), (15, 20), (0, 20), (0, 0)], float),
        np.array([0, 1, 0, -1, 0, 0.3]),
    )
    return Region.of([outline], [circle((8.0, 8.0), 4.0)])


@pytest.mark.parametrize("tolerance_mm", [0.5, 0.02, 0.0005])
def test_the_part_is_held_and_the_sheet_is_within(tolerance_mm: float) -> None:
    holds, within = holding_polygon(plate(), tolerance_mm), within_polygon(plate(), tolerance_mm)
    places = np.concatenate([loop.at_length(np.linspace(0, loop.length_mm, 2000))[0] for loop in plate().loops])
    points = shapely.points(places)
    assert holds.buffer(1e-9).covers(shapely.multipoints(places)) and len(holds.interiors) == 1
    assert not shapely.contains(within.buffer(-1e-9), points).any()
    assert shapely.distance(holds.boundary, points).max() <= tolerance_mm + 1e-9
    assert shapely.distance(within.boundary, points).max() <= tolerance_mm + 1e-9
    assert within.area < plate().area_mm2 < holds.area


def test_a_simplified_outline_holds_the_finer_one_with_few_corners() -> None:
    fine = holding_polygon(plate(), 0.0005)
    coarse = simplified(fine, 0.05)
    assert coarse.buffer(1e-9).covers(fine)
    assert len(coarse.exterior.coords) < len(fine.exterior.coords) / 4
    assert shapely.hausdorff_distance(coarse, fine) < 0.06 or coarse.area - fine.area < 0.05 * fine.length


def test_growing_keeps_corners_and_holds_all_within_the_distance() -> None:
    square = shapely.box(0, 0, 10, 10)
    assert grown(square, 2.0).equals(shapely.box(-2, -2, 12, 12))
    spike = shapely.Polygon([(0, 0), (30, 1), (0, 2)])
    assert grown(spike, 1.0).buffer(1e-9).covers(spike.buffer(1.0))


def test_a_rim_is_kept_free_on_a_sheet_with_a_hole() -> None:
    sheet = shapely.box(0, 0, 100, 50).difference(shapely.box(40, 20, 60, 30))
    room = shrunk(sheet, 5.0)
    assert room.equals(shapely.box(5, 5, 95, 45).difference(shapely.box(35, 15, 65, 35)))
    assert shrunk(sheet, 0.0).equals(sheet)


def test_several_outlines_and_none_are_refused() -> None:
    two = Region.of([circle((0.0, 0.0), 5.0), circle((20.0, 0.0), 5.0)])
    with pytest.raises(GeometryError, match="2 outlines"):
        holding_polygon(two, 0.1)
    with pytest.raises(GeometryError, match="no area"):
        holding_polygon(Region(()), 0.1)


def test_a_circle_is_held_within_its_tolerance() -> None:
    disc = holding_polygon(Region.of([circle((3.0, 4.0), 50.0)]), 0.1)
    assert math.pi * 2500 < disc.area < math.pi * 50.1**2
