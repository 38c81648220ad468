# SPDX-License-Identifier: LGPL-2.1-or-later
"""Circular and rectangular pockets by every pattern, against shapes drawn here by shapely alone."""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np
import pytest
import shapely
from shapely import Polygon
from shapely.affinity import rotate

from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.pockets.circular_pocket import CircularPocket
from CNCStepper.cycles.pockets.pocket import Pocket as AnyPocket
from CNCStepper.cycles.pockets.rectangular_pocket import RectangularPocket
from CNCStepper.errors import CycleError, GeometryError, JobError
from CNCStepper.geometry.shapes.rectangle import rectangle
from CNCStepper.machine.profile import validated
from CNCStepper.state import Start
from CNCStepper.toolpath import TableBuilder
from helpers.cycles.product_verdict import cut, judged, tool
from helpers.cycles.seeds import SEEDS
from helpers.cycles.sweep_judge import Wanted, band, gouge_mm, left_by_level

PATTERNS = ("offset", "zigzag", "spiral")
Pocket = CircularPocket | RectangularPocket


def random_keys(seed: int, width_mm: float) -> tuple[dict, float]:
    """Return keys that all pockets have, and the tool's radius: 0.1 to 1.0 of the narrowest width."""
    rng = np.random.default_rng(seed)
    tool_mm = round(width_mm / 2 * float(rng.uniform(0.1, 0.95)), 3)
    finish_mm = float(rng.choice([0.0, 0.1 * tool_mm]))
    return {
        "tool": 1,
        "depth_mm": 2.0,
        "stepdown_mm": float(rng.choice([1.2, 3.0])),
        "stepover_mm": 2 * tool_mm * float(rng.choice([0.3, 0.5, 0.9])),
        "finish_stepover_mm": finish_mm if width_mm / 2 - tool_mm > 2 * finish_mm else 0.0,
        "stock_to_leave_mm": float(rng.choice([0.0, 0.02 * tool_mm])),
        "pattern": PATTERNS[seed % 3],
        "angle_deg": float(rng.uniform(0, 180)),
        "entry": str(rng.choice(["helix", "ramp", "plunge"])),
        "direction": str(rng.choice(["climb", "conventional"])),
    }, tool_mm


def random_circle(seed: int) -> tuple[Pocket, Polygon, float]:
    rng = np.random.default_rng(seed)
    at, radius_mm = rng.uniform(-20, 20, 2), float(rng.uniform(3, 30))
    keys, tool_mm = random_keys(seed, 2 * radius_mm)
    angle = np.linspace(0, 2 * math.pi, 4001)[:-1]
    shape = Polygon(at + radius_mm * np.column_stack([np.cos(angle), np.sin(angle)]))
    return CircularPocket(centre_mm=tuple(at), radius_mm=radius_mm, **keys), shape, tool_mm


def random_rectangle(seed: int) -> tuple[Pocket, Polygon, float]:
    """Return one with sharp corners, with corners rounder or sharper than the tool, or a sliver; turned or not."""
    rng = np.random.default_rng(seed + 77)
    size = rng.uniform(6, 40, 2) if seed % 4 else np.array([rng.uniform(30, 60), rng.uniform(0.6, 2.0)])
    a = rng.uniform(-20, 20, 2)
    b = a + size * rng.choice([-1, 1], 2)
    keys, tool_mm = random_keys(seed, float(size.min()))
    radius_mm = float(rng.choice([0.0, 0.5, 0.99])) * float(size.min()) / 2
    turn = float(rng.choice([0.0, rng.uniform(-360, 360)]))
    sharp = shapely.box(*np.minimum(a, b), *np.maximum(a, b))
    inner = shapely.box(*(np.minimum(a, b) + radius_mm), *(np.maximum(a, b) - radius_mm))
    shape = inner.buffer(radius_mm, quad_segs=500) if radius_mm else sharp
    pocket = RectangularPocket(
        corner_a_mm=tuple(a), corner_b_mm=tuple(b), corner_radius_mm=radius_mm, rotation_deg=turn, **keys
    )
    return pocket, rotate(shape, turn, origin=tuple(a)), tool_mm


@pytest.mark.slow
@pytest.mark.parametrize("make", [random_circle, random_rectangle])
@pytest.mark.parametrize("seed", SEEDS)
def test_a_random_pocket_is_right_to_its_tolerance(
    make: Callable[[int], tuple[Pocket, Polygon, float]], seed: int
) -> None:
    pocket, shape, tool_mm = make(seed)
    if pocket.stock_to_leave_mm:
        shape = shape.difference(band(shape, pocket.stock_to_leave_mm))
    found = judged(pocket, tool(2 * tool_mm))
    assert found.clean, found.faults
    assert gouge_mm(found.toolpath, tool_mm, [Wanted(shape, -2.0)]) <= pocket.tolerance_mm
    left = left_by_level(found.toolpath, tool_mm, shape)  # a ramp of small fall has levels of its own
    floors = -2.0 * np.arange(1, found.answer.figures["levels"] + 1) / found.answer.figures["levels"]
    assert all(min(left[z] for z in left if abs(z - floor) < 0.001) <= pocket.tolerance_mm for floor in floors)


@pytest.mark.slow
def test_a_pocket_whose_path_no_triangulation_wants_as_it_lies_is_judged() -> None:
    """GEOS finds no triangles between the points of this path (seed 90 of the random rectangles)."""
    pocket, _, tool_mm = random_rectangle(90)
    assert judged(pocket, tool(2 * tool_mm)).clean


@pytest.mark.parametrize("pattern", PATTERNS)
def test_a_corner_sharper_than_the_tool_is_reported_with_its_size(pattern: str) -> None:
    pocket = RectangularPocket(
        tool=1, corner_a_mm=(0, 0), corner_b_mm=(40, 30), depth_mm=2, stepdown_mm=2, stepover_mm=2, pattern=pattern
    )
    _, answer = cut(pocket, tool(6.0))
    assert answer.figures["rest_corners"] == 4
    assert answer.figures["rest_corner_mm"] == pytest.approx(3 * (math.sqrt(2) - 1), abs=0.002)
    assert answer.figures["rest_area_mm2"] == pytest.approx((4 - math.pi) * 9, rel=0.01)
    assert any("does not reach into 4 corners" in warning for warning in answer.warnings)


def test_round_corners_as_large_as_the_tool_leave_nothing() -> None:
    pocket = RectangularPocket(
        tool=1, corner_a_mm=(40, 30), corner_b_mm=(0, 0), corner_radius_mm=3.1, depth_mm=2, stepdown_mm=2, stepover_mm=2
    )
    assert cut(pocket, tool(6.0))[1].figures["rest_corners"] == 0


@pytest.mark.slow
def test_a_circle_is_cleared_in_one_spiral_without_lifting_within_a_level() -> None:
    found = judged(CircularPocket(tool=1, radius_mm=20, depth_mm=4, stepdown_mm=2, stepover_mm=2.4), tool(6.0))
    assert found.clean and found.gouge_mm <= 0.01 and found.left_mm <= 0.01
    assert sum("G0" in line and "Z" in line for line in found.lines) <= 4


@pytest.mark.parametrize(
    ("corners", "radius_mm", "code"),
    [(((0, 0), (0, 9)), 0.0, "rectangle-flat"), (((0, 0), (9, 20)), 4.6, "rectangle-radius")],
)
def test_a_rectangle_that_is_none_is_refused(corners: tuple, radius_mm: float, code: str) -> None:
    with pytest.raises(GeometryError) as caught:
        rectangle(*corners, radius_mm)
    assert caught.value.code == code and caught.value.advice


def test_a_tool_wider_than_the_circle_is_refused_before_any_row() -> None:
    table = TableBuilder(Start())
    with pytest.raises(CycleError) as caught:
        CircularPocket(tool=1, radius_mm=2.9, depth_mm=1, stepdown_mm=1, stepover_mm=1).cut(
            Setup(tool(6.0), 10.0, 2.0), table
        )
    assert caught.value.code == "tool-wide" and table.index == 0


@pytest.mark.parametrize("cycle", [CircularPocket, RectangularPocket])
def test_shaped_pockets_take_what_a_pocket_takes(cycle: type[Pocket]) -> None:
    for key in ("pattern", "angle_deg", "engagement_max_deg"):
        own, pockets = cycle.model_fields[key], AnyPocket.model_fields[key]
        assert (own.annotation, own.metadata) == (pockets.annotation, pockets.metadata)


def test_an_engagement_that_no_pocket_keeps_is_refused_before_it_is_cut() -> None:
    keys = {"tool": 1, "radius_mm": 20, "depth_mm": 1, "stepdown_mm": 1, "stepover_mm": 1, "pattern": "engagement"}
    with pytest.raises(JobError, match="engagement_max_deg"):
        validated(CircularPocket, keys | {"engagement_max_deg": 15}, "job.toml operation 1")


SIDES = {"corner_a_mm": (0, 0), "corner_b_mm": (40, 30), "depth_mm": 2, "stepdown_mm": 2}


@pytest.mark.parametrize(
    ("pattern", "apart_mm"), [("offset", 2.5), ("zigzag", 24 / 10), ("spiral", pytest.approx(2.5, rel=0.1))]
)
def test_the_spacing_of_the_passes_is_told_as_it_is(pattern: str, apart_mm: float) -> None:
    pocket = RectangularPocket(tool=1, **SIDES, stepover_mm=2.5, pattern=pattern)
    found = cut(pocket, tool(6.0))[1].figures["ae_mm"]
    assert found == apart_mm and found <= 2.5 + 1e-9


def test_a_single_pass_is_apart_from_nothing() -> None:
    slot = RectangularPocket(tool=1, **SIDES | {"corner_b_mm": (40, 6.5)}, stepover_mm=2.5)
    assert cut(slot, tool(6.0))[1].figures["ae_mm"] == 0.0
