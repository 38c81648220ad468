# SPDX-License-Identifier: LGPL-2.1-or-later
"""The spiral in random rooms that allow it: nothing gouged, nothing left, one curve; a reason where it may not be."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from CNCStepper.cycles.clearing.pattern import Area
from CNCStepper.cycles.clearing.spiral_pattern import spiral
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve, circle, from_points
from CNCStepper.geometry.region import Region
from helpers.cycles.random_areas import DEEP_MM, TOLERANCE_MM, path_of, polygon
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, gouge_mm, left_mm, reachable, swept

KINDS = ("circle", "box", "stadium", "hull", "waves", "sliver")


def random_outline(seed: int) -> tuple[str, Curve]:
    """Return an outline of each kind in turn; "sliver" is a long thin triangle."""
    rng, kind = np.random.default_rng(seed), KINDS[seed % len(KINDS)]
    wide, high = rng.uniform(8, 40), rng.uniform(4, 12)
    angle = np.linspace(0, 2 * math.pi, 200, endpoint=False)
    ring = np.column_stack([np.cos(angle), np.sin(angle)])
    corners = np.array([(-wide, -high), (wide, -high), (wide, high), (-wide, high), (-wide, -high)])
    hull = shapely.MultiPoint(rng.normal(0, 15, (8, 2))).convex_hull.exterior.coords
    wave = 1 + rng.uniform(0, 0.08) * np.sin(rng.integers(2, 6) * angle)
    curve = {
        "circle": circle((0, 0), wide),
        "box": Curve(corners, np.zeros(4)),
        "stadium": Curve(corners, np.array([0, 1.0, 0, 1.0])),
        "hull": from_points(hull, closed=True),
        "waves": from_points(20 * wave[:, None] * ring, closed=True),
        "sliver": from_points([(0, 0), (60, high / 2), (60, -high / 2)], closed=True),
    }[kind]
    return kind, curve.rotated(rng.uniform(0, 360)).moved(*rng.uniform(-20, 20, 2))


def area_of(outline: Curve, tool_mm: float, step_mm: float, climb: bool = True) -> Area:
    return Area(Region.of([outline]).offset(-tool_mm, 0.001), tool_mm, step_mm, TOLERANCE_MM, climb)


@pytest.mark.slow
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_room_is_cleared_in_one_curve(seed: int) -> None:
    rng = np.random.default_rng(seed + 500)
    _, outline = random_outline(seed)
    region = polygon(outline)
    tool_mm = round(shapely.maximum_inscribed_circle(region).length * float(rng.uniform(0.1, 0.95)), 3)
    (run,) = spiral(area_of(outline, tool_mm, 2 * tool_mm * rng.choice([0.2, 0.4, 1.0]), climb=bool(seed % 2)))
    path = path_of([run], tool_mm)
    assert gouge_mm(path, tool_mm, [Wanted(region, -DEEP_MM)]) <= TOLERANCE_MM
    assert left_mm(reachable(region, tool_mm), swept(path, tool_mm, -DEEP_MM)) <= TOLERANCE_MM
    assert len(run.passes) == 2 and run.passes[1].curve.closed


def turns_apart_mm(curve: Curve) -> float:
    """Return how far apart the turns of a round spiral are at most, measured along the ray of each of its points."""
    points = curve.points(1e-3) @ (1, 1j)
    turned = np.cumsum(np.angle(points[2:] / points[1:-1]))
    size = np.abs(points[2:])
    inner = np.interp(turned - 2 * math.pi, turned, size, left=0.0)
    return float((size - inner).max())


@pytest.mark.slow
@pytest.mark.parametrize("climb", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_a_round_room_gets_even_turns(climb: bool) -> None:
    (run,) = spiral(area_of(circle((0, 0), 25.0), 3.0, 2.4, climb))
    way, wall = (one.curve for one in run.passes)
    assert way.xy[0] == pytest.approx((0, 0), abs=1e-6)
    assert wall.area_mm2 == pytest.approx(math.pi * 22**2 * (1 if climb else -1), rel=1e-6)
    assert turns_apart_mm(way if climb else way.mirrored_x()) <= 2.4 + TOLERANCE_MM
    assert len(way) < 150


def test_the_stepover_is_never_above_the_radius_so_that_no_corner_stays() -> None:
    box = from_points([(0, 0), (40, 0), (40, 40), (0, 40)], closed=True)
    wide, narrow = (sum(len(one.curve) for one in spiral(area_of(box, 3.0, step))[0].passes) for step in (6.0, 2.9))
    assert wide == narrow


U = from_points([(0, 0), (60, 0), (60, 40), (45, 40), (45, 12), (15, 12), (15, 40), (0, 40)], closed=True)
BARBELL = from_points([(0, 0), (20, 0), (20, 8), (40, 8), (40, 0), (60, 0), (60, 20), (40, 20), (40, 12), (20, 12),
                       (20, 20), (0, 20)], closed=True)  # fmt: skip


@pytest.mark.parametrize("outline", [U, BARBELL], ids=["u", "barbell"])
def test_a_room_that_splits_or_hides_is_refused_with_advice(outline: Curve) -> None:
    with pytest.raises(CycleError, match="offset") as caught:
        spiral(area_of(outline, 1.5, 1.0))
    assert caught.value.code == "spiral-shape"


def test_an_island_is_refused_with_advice() -> None:
    room = Region.of([circle((0, 0), 30)], [circle((10, 0), 5)]).offset(-3, 0.001)
    with pytest.raises(CycleError, match="islands"):
        spiral(Area(room, 3.0, 2.0, TOLERANCE_MM, True))


@pytest.mark.slow
def test_the_turns_are_as_far_apart_as_is_told() -> None:
    (run,) = spiral(area_of(circle((0, 0), 25.0), 3.0, 2.5))
    assert run.apart_mm == pytest.approx(22 / 9, rel=0.005)
    points = run.passes[0].curve.points(1e-3) @ (1, 1j)
    turned = np.cumsum(np.angle(points[2:] / points[1:-1]))
    sizes_mm = np.interp(2.0 * math.pi * np.arange(1, 9), turned, np.abs(points[2:]))
    assert np.diff(sizes_mm) == pytest.approx(run.apart_mm, abs=TOLERANCE_MM)
