# SPDX-License-Identifier: LGPL-2.1-or-later
"""Closed chains that cross: the area inside an odd number of them, judged by shapely; the sign's pocket and hole."""

from __future__ import annotations

import functools
import random
from pathlib import Path

import numpy as np
import pytest
import shapely

from CNCStepper.drawing.crossing_areas import without_crossings
from CNCStepper.drawing.drawing import Attributes, Chain
from CNCStepper.drawing.nesting_levels import nesting_levels
from CNCStepper.drawing.read_drawing import ReadOptions, read_drawing
from CNCStepper.geometry.curve import Curve, circle
from CNCStepper.geometry.region import Region
from CNCStepper.geometry.shapes.rectangle import rectangle

SIGN = Path("examples/drawings/sign.svg")
CHORD_MM = 1e-4


def polygon(curve: Curve) -> shapely.Geometry:
    return shapely.make_valid(shapely.Polygon(curve.points(CHORD_MM)))


def odd(curves: list[Curve]) -> shapely.Geometry:
    return functools.reduce(shapely.symmetric_difference, map(polygon, curves))


def chains(*curves: Curve) -> list[Chain]:
    return [Chain(curve, Attributes(name=f"{number}")) for number, curve in enumerate(curves)]


def test_chains_that_do_not_cross_stay_what_they_are() -> None:
    given = chains(circle((0, 0), 10), circle((0, 0), 4), circle((30, 0), 4))
    assert all(one is other for one, other in zip(without_crossings(given), given, strict=True))


def test_the_signs_pocket_and_its_hole_become_what_an_even_odd_fill_paints() -> None:
    drawn = [chain for chain in read_drawing(SIGN, ReadOptions()).chains if chain.attributes.layer == "pocket"]
    apart = without_crossings(drawn)
    assert len(drawn) == len(apart) == 2 and {chain.attributes.name for chain in apart} == {drawn[0].attributes.name}
    wanted = odd([chain.curve for chain in drawn])
    found = odd([chain.curve for chain in apart])
    assert shapely.symmetric_difference(wanted, found).area < 0.01
    small = min(abs(chain.curve.area_mm2) for chain in apart)
    assert 20.0 < small < 40.0  # what of the hole sticks out of the pocket's left side
    assert set(nesting_levels([chain.curve for chain in apart]).tolist()) == {0}


@pytest.mark.parametrize("seed", range(1, 13))
def test_random_circles_and_rectangles(seed: int) -> None:
    chance = random.Random(seed)
    curves = [circle((chance.uniform(0, 30), chance.uniform(0, 30)), chance.uniform(4, 14)) for _ in range(4)]
    corners = [sorted(chance.uniform(0, 30) for _ in range(2)) for _ in range(2)]
    curves.append(rectangle((corners[0][0], corners[1][0]), (corners[0][1] + 2, corners[1][1] + 2), 0.0))
    region = Region.even_odd(curves)
    assert region.area_mm2 == pytest.approx(odd(curves).area, abs=0.02)
    apart = [chain.curve for chain in without_crossings(chains(*curves))]
    levels = np.array(nesting_levels(apart))
    signed = sum(
        abs(curve.area_mm2) * (1 if level % 2 == 0 else -1) for curve, level in zip(apart, levels, strict=True)
    )
    assert signed == pytest.approx(odd(curves).area, abs=0.02)
