# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every shape of the library: exact lines and arcs, its area by its formula, refusals of what cannot be."""

from __future__ import annotations

import random
from math import acos, asin, hypot, pi, radians, sin, sqrt, tan
from typing import Any

import numpy as np
import pytest
import shapely

from CNCStepper.drawing.shape_library.declaration import SHAPES, Figure
from CNCStepper.drawing.shape_library.shape_families import FAMILIES, figure_of, library_shape, shapes_of
from CNCStepper.errors import GeometryError, JobError

AREAS: dict[str, Any] = {  # by formula, with the usual dimensions
    "circle": pi * 20**2,
    "ring": pi * (20**2 - 10**2),
    "sector": pi * 30**2 * 75 / 360,
    "ring_sector": pi * (30**2 - 15**2) * 100 / 360,
    "segment": 25**2 * (pi - acos(10 / 25)) + 10 * sqrt(25**2 - 10**2),
    "d_hole": 5**2 * (pi - acos(3.5 / 5)) + 3.5 * sqrt(5**2 - 3.5**2),
    "double_d_hole": 2 * (6 * sqrt(64 - 36) + 64 * asin(6 / 8)),
    "slot": 28 * 12 + pi * 6**2,
    "arc_slot": radians(80) * 30 * 10 + pi * 5**2,
    "t_slot": 6 * 10 + 12 * 5,
    "rectangle": 60 * 40,
    "chamfered_rectangle": 60 * 40 - 2 * 8**2,
    "triangle": 50 * 40 / 2,
    "trapezoid": (60 + 36) / 2 * 30,
    "parallelogram": 50 * 30,
    "regular_polygon": 6 * 20**2 * tan(pi / 6),
    "star": 5 * 30 * 13 * sin(pi / 5),
    "cross": 2 * 50 * 16 - 16**2,
    "arrow": 38 * 12 + 22 * 30 / 2,
    "gusset": 60 * 60 - 10 * 10 / 2 - (60 - 8) ** 2 / 2,
    "l_bracket": 60 * 16 + 44 * 16 + 4**2 * (1 - pi / 4) - 2 * pi * 2.5**2,
    "t_bracket": 80 * 16 + 44 * 16 + 2 * 4**2 * (1 - pi / 4) - 3 * pi * 2.5**2,
    "u_bracket": 60 * 16 + 2 * 44 * 16 + 2 * 4**2 * (1 - pi / 4) - 2 * pi * 2.5**2,
    "z_bracket": 2 * 40 * 16 + 28 * 16 + 2 * 4**2 * (1 - pi / 4) - 2 * pi * 2.5**2,
    "h_profile": 2 * 50 * 10 + 40 * 8 + 4 * 4**2 * (1 - pi / 4),
    "flange": pi * (40**2 - 15**2 - 6 * 3.25**2),
    "square_flange": 70**2 - 6**2 * (4 - pi) - pi * 15**2 - 4 * pi * 3.25**2,
    "nema_plate": 50.3**2 - 4**2 * (4 - pi) - pi * 11.25**2 - 4 * pi * 1.7**2,
    "mounting_plate": 100 * 60 - 6**2 * (4 - pi) - 4 * pi * 2.5**2,
    "ratchet_wheel": 12 * 24 * 30 * sin(pi / 6) / 2 - pi * 5**2,
    "hook": 60 * 10 + pi / 2 * (22**2 - 12**2) + pi / 2 * 5**2 - 2 * pi * 2.25**2,
    "tag": 70 * 34 - (34 / 3) ** 2,
    "shield": 50 * (64 - 50 * sin(pi / 3)) + 50**2 * (pi / 3 - sin(pi / 3) / 2),
}


def polygon(figure: Figure) -> shapely.Polygon:
    outline, *holes = (curve.points(0.0005) for curve in figure.curves)
    return shapely.Polygon(outline, holes)


def test_there_are_enough_of_them_and_each_is_in_one_family() -> None:
    listed = [shape.kind for title in FAMILIES for shape in shapes_of(title)]
    assert len(listed) == len(SHAPES) == len(set(listed)) >= 40


@pytest.mark.parametrize("kind", SHAPES)
def test_a_shape_is_a_valid_figure_and_shapely_finds_its_area(kind: str) -> None:
    figure = figure_of(kind, {})
    assert all(curve.closed and curve.area_mm2 > 0 and len(curve) < 400 for curve in figure.curves)
    whole = polygon(figure)
    assert whole.is_valid and figure.area_mm2 == pytest.approx(whole.area, abs=0.001 * whole.length)
    shape = library_shape(kind)
    assert shape.title and shape.about.endswith(".")
    assert all(key.endswith(("_mm", "_deg")) or one.is_count for key, one in shape.dimensions.items())


@pytest.mark.parametrize("kind", AREAS)
def test_the_area_is_that_of_the_formula(kind: str) -> None:
    rounding = {"tag": 4**2 * (2 * (1 - pi / 4) + 4 * (tan(pi / 8) - pi / 8))}.get(kind, 0.0)
    hole = {"tag": pi * 2.5**2}.get(kind, 0.0)
    assert figure_of(kind, {}).area_mm2 == pytest.approx(AREAS[kind] - rounding - hole, rel=1e-9)


def test_bands_around_circles_touch_them() -> None:
    lever = figure_of("lever", {}).outline
    for centre, radius in (((0, 0), 15), ((60, 0), 9)):
        assert float(lever.distances_mm(np.array([centre], float))[0]) == pytest.approx(radius)
    hull = shapely.union_all([shapely.Point(0, 0).buffer(15, 256), shapely.Point(60, 0).buffer(9, 256)]).convex_hull
    assert lever.area_mm2 == pytest.approx(hull.area, rel=1e-4)


def test_a_drop_leaves_its_circle_along_the_tangent() -> None:
    outline = figure_of("drop", {}).outline
    turns = np.angle(
        (outline.begin_directions @ (1, 1j)) * np.conj(np.roll(outline.end_directions @ (1, 1j), 1))
    )  # at each vertex
    assert (np.abs(turns) > 1e-6).sum() == 1, "the point alone is a corner"
    assert outline.box_mm == pytest.approx((-15, -15, 15, 36))


@pytest.mark.parametrize(
    ("kind", "values", "code"),
    [
        ("ring", {"inner_diameter_mm": 40.0}, "shape-size"),
        ("flange", {"bolt_circle_mm": 76.0}, "shape-size"),
        ("flange", {"holes": 40}, "shape-size"),
        ("flange", {"holes": 4.5}, "quantity"),
        ("flange", {"diameter_mm": 4}, "shape-key"),
        ("circle", {"diameter_mm": -3}, "quantity"),
        ("circle", {"diameter_mm": float("nan")}, "quantity"),
        ("circle", {"diameter_mm": "12"}, "quantity"),
        ("nema_plate", {"size": 18}, "shape-size"),
        ("rectangle", {"corner_radius_mm": 21}, "shape-size"),
        ("lever", {"distance_mm": 3}, "shape-size"),
        ("blob", {}, "library-kind"),
        (3, {}, "library-kind"),
    ],
)
def test_what_cannot_be_is_refused(kind: Any, values: dict[str, Any], code: str) -> None:
    with pytest.raises((GeometryError, JobError)) as refusal:
        figure_of(kind, values)
    assert refusal.value.code == code and refusal.value.advice


def test_a_refusal_names_place_and_measure() -> None:
    flange = {key: one.usual for key, one in SHAPES["flange"].dimensions.items()}
    far = flange["outer_diameter_mm"] - flange["hole_diameter_mm"] + 2.0  # 1 mm beyond, each side
    with pytest.raises(GeometryError, match=rf"the hole at X{far / 2:.2f} Y0.00 would reach 1 mm beyond its outline"):
        figure_of("flange", {"bolt_circle_mm": far})
    with pytest.raises(GeometryError, match=r"the holes at X\S+ Y\S+ and X\S+ Y\S+ would overlap by") as refusal:
        figure_of("flange", {"holes": 40})
    apart = flange["bolt_circle_mm"] * sin(pi / 40)
    lens = flange["hole_diameter_mm"] - apart  # its width, along the line between the middles
    assert refusal.value.sentence.split("overlap by ")[1].startswith(f"{lens:.3g} mm")
    with pytest.raises(GeometryError, match=r"value 3\.6°, limit 15\.2"):
        figure_of("locking_wheel", {"notches": 100})


def test_random_dimensions_give_a_valid_figure_or_a_refusal() -> None:
    made, refused = 0, 0
    for seed in range(6):
        chance = random.Random(seed)
        for shape in SHAPES.values():
            values: dict[str, Any] = {}
            for key, one in shape.dimensions.items():
                low, high = max(one.bounds.low, 0.3 * one.usual), min(one.bounds.high, 1.7 * one.usual or 1.0)
                values[key] = chance.randint(int(low), int(high)) if one.is_count else chance.uniform(low, high)
            try:
                figure = shape.figure(values)
            except (GeometryError, JobError) as error:
                assert error.code in ("shape-size", "quantity"), (seed, shape.kind, values, str(error))
                refused += 1
                continue
            made += 1
            assert polygon(figure).is_valid and figure.area_mm2 > 0, (seed, shape.kind, values)
            width, height = np.subtract(figure.outline.box_mm[2:], figure.outline.box_mm[:2])
            assert hypot(width, height) < 1000
    print(f"seeds 0 to 5: {made} made, {refused} refused")
    assert made > 100 and refused > 15
