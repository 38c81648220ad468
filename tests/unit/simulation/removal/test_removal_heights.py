# SPDX-License-Identifier: LGPL-2.1-or-later
"""Every height against an independent one: a walk along the move in small steps, cutter by cutter."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import Form, form_of
from CNCStepper.simulation.cutter_solid import height_at
from CNCStepper.simulation.removal.heightmap import Grid, HeightMap, Part
from CNCStepper.simulation.removal.removal_moves import Moves, moves_of
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW, ARC_CW, YZ, ZX
from helpers.simulation.programs import begun

TOOLS = {
    "flat": {},
    "ball": {},
    "bullnose": {"corner_radius_mm": 1.0},
    "v": {"tip_angle_deg": 90},
    "engraver": {"tip_angle_deg": 40, "tip_diameter_mm": 0.8},
    "drill": {"point_angle_deg": 118},
}
STOCK = Stock((30, 30, 20))
CELL_MM = 0.7
R = 3.0
STEPS = 6000
TOGETHER = 64  # steps that are looked at in one go
GROWN = 1e-4  # a walk's cutter is wider by that, for what lies on the rim between two steps


def tool(shape: str) -> Tool:
    return Tool(number=1, shape=shape, diameter_mm=2 * R, **TOOLS[shape])


def profile(shape: str, out: np.ndarray) -> np.ndarray:
    """Return the heights of each cutter over its tip, from the drawing of its shape and not from the code."""
    if shape == "flat":
        return np.zeros_like(out)
    if shape == "ball":
        return R - np.sqrt(np.maximum(R**2 - out**2, 0))
    if shape == "bullnose":
        return 1.0 - np.sqrt(np.maximum(1.0 - np.maximum(out - 2.0, 0) ** 2, 0))
    angle, tip = {"v": (90, 0.0), "engraver": (40, 0.4), "drill": (118, 0.0)}[shape]
    return np.maximum(out - tip, 0) / math.tan(math.radians(angle / 2))


def walked(points: np.ndarray, shape: str, x: np.ndarray, y: np.ndarray, grown: float) -> np.ndarray:
    """Return the lowest heights that the cutter has at any of the points; `grown` widens its rim."""
    lowest = np.zeros_like(x)
    for some in np.array_split(points[:, :, None], len(points) // TOGETHER):
        middle, around = some[len(some) // 2], np.hypot(*np.ptp(some[:, :2, 0], axis=0))
        near = np.hypot(x - middle[0], y - middle[1]) <= R + grown + around
        out = np.hypot(x[near] - some[:, 0], y[near] - some[:, 1])
        height = np.where(out <= R + grown, some[:, 2] + profile(shape, np.minimum(out, R)), 0.0)
        lowest[near] = np.minimum(lowest[near], height.min(axis=0))
    return lowest


def assert_cut_as(part: HeightMap, points: np.ndarray, shape: str) -> None:
    """Assert that the heights lie between those of a walk with a slightly smaller and a slightly larger cutter."""
    x, y = np.meshgrid(part.x_mm, part.y_mm)
    step = float(np.linalg.norm(np.diff(points, axis=0), axis=1).max())
    low, high = walked(points, shape, x, y, GROWN + step), walked(points, shape, x, y, -GROWN)
    steepest = {"engraver": 2.75, "ball": 40, "bullnose": 30}.get(shape, 1.1)
    assert (part.heights_mm <= high + 1e-5).all()
    assert (part.heights_mm >= low - step * steepest - 1e-5).all()
    assert (part.heights_mm < 0).any()


def cut(moves: Moves, cell_mm: float) -> HeightMap:
    return HeightMap(STOCK, part=Part(Grid.of(STOCK, cell_mm)).after(moves))


def point_in(rng: random.Random) -> np.ndarray:
    return np.array([rng.uniform(-10, 10), rng.uniform(-10, 10), rng.uniform(-7, -0.5)])


@pytest.mark.parametrize("shape", TOOLS)
def test_heights_of_lines_agree_with_a_walk(shape: str) -> None:
    for seed in range(4):
        print("seed", seed)
        rng = random.Random(seed)
        begin, end = point_in(rng), point_in(rng)
        if seed == 3:
            end[2] = begin[2]
        part = cut(Moves.lines([begin], [end], form_of(tool(shape))), CELL_MM)
        share = np.linspace(0, 1, STEPS)[:, None]
        assert_cut_as(part, begin * (1 - share) + end * share, shape)


@pytest.mark.slow
@pytest.mark.parametrize(
    "shape", [one if one == "ball" else pytest.param(one, marks=pytest.mark.slow) for one in TOOLS]
)
def test_heights_of_arcs_and_helices_agree_with_a_walk(shape: str) -> None:
    for seed in range(6):
        print("seed", seed)
        rng = random.Random(100 + seed)
        radius, angle, sweep = rng.uniform(0.3, 9), rng.uniform(0, 2 * math.pi), rng.uniform(0.1, 6.2)
        kind, turns = rng.choice([(ARC_CCW, 1), (ARC_CW, 1), (ARC_CCW, 3)])
        z0, z1 = (-1.5, -1.5) if seed == 5 else (rng.uniform(-6, -1), rng.uniform(-6, -1))
        cx, cy = rng.uniform(-3, 3), rng.uniform(-3, 3)
        total = (sweep + 2 * math.pi * (turns - 1)) * (1 if kind == ARC_CCW else -1)

        def on_arc(share, z0=z0, z1=z1, cx=cx, cy=cy, radius=radius, angle=angle, total=total):
            at = angle + total * share
            return cx + radius * np.cos(at), cy + radius * np.sin(at), z0 + (z1 - z0) * share

        begin, end = on_arc(0.0), on_arc(1.0)
        program = begun().rapid(begin[0], begin[1], 5).feed(*begin).arc(kind, end, (cx, cy, 0), turns=turns)
        moves = moves_of(program.toolpath(), tool(shape), STOCK)
        assert (moves.arc >= 0).sum() == 1
        part = cut(moves, CELL_MM)
        assert_cut_as(part, np.stack(on_arc(np.linspace(0, 1, 2 * STEPS)), axis=1), shape)


@pytest.mark.parametrize("shape", TOOLS)
@pytest.mark.parametrize("climb", [-1.0, 0.0, 1.0])
def test_joined_moves_cut_what_they_cut_apart(shape: str, climb: float) -> None:
    """A chain cuts each cell once, by the move it belongs to; cut one by one every move cuts all it can."""
    for seed in range(5):
        print("seed", seed)
        rng = np.random.default_rng(seed)
        turns = np.cumsum(rng.normal(0, (0.1, 0.5, 2.5, 0.3, 1.0)[seed], 60))
        steps = rng.uniform(0.05, 1.2, 60)
        x, y = np.cumsum(steps * np.cos(turns)), np.cumsum(steps * np.sin(turns))
        z = -6 + np.cumsum(climb * rng.uniform(-0.1, 0.25, 60))
        points = np.column_stack([x - x.mean(), y - y.mean(), np.where(rng.random(60) < 0.5, z, np.roll(z, 1))])
        if climb == 0.0:
            points[:, 2] = -2.0
        points[30, :2] = points[29, :2]  # a plunge or a retract between
        chain = Moves.lines(points[:-1], points[1:], form_of(tool(shape)))
        assert (chain.joined > 0).all()
        together = cut(chain, 0.31)
        part = Part(Grid.of(STOCK, 0.31))
        for k in range(len(chain)):
            part = part.after(chain.part_of(k, 1.0))
        apart = HeightMap(STOCK, part=part)
        assert np.abs(together.heights_mm - apart.heights_mm).max() < 2e-5
        volume = apart.removed_volume_mm3
        assert together.removed_volume_mm3 == pytest.approx(volume, rel=1e-3)


@pytest.mark.parametrize("shape", TOOLS)
def test_gentle_ramps_leave_to_their_neighbours_only_what_these_cut(shape: str) -> None:
    for seed, (turn, wave, high) in enumerate([(0.05, 0.3, 0.2), (0.3, 1, 0.05), (1.0, 0.2, 2), (0.1, 0.1, 3)]):
        print("seed", seed)
        along = np.cumsum(np.random.default_rng(seed).uniform(0.03, 0.4, 120))
        points = [6 * np.cos(along * turn), 8 * np.sin(along * turn * 1.1 + 0.3), -5 + high * np.sin(along * wave)]
        chain = Moves.lines(
            *(np.column_stack(points)[part] for part in (slice(-1), slice(1, None))), form_of(tool(shape))
        )
        together, part = cut(chain, 0.17), Part(Grid.of(STOCK, 0.17))
        for k in range(len(chain)):
            part = part.after(chain.part_of(k, 1.0))
        assert np.abs(together.heights_mm - part.heights_mm()).max() < 1e-6
        assert together.removed_volume_mm3 == pytest.approx(part.removed_volume_mm3, rel=2e-5)


def test_arcs_of_other_planes_and_spirals_are_cut_along_chords() -> None:
    program = begun().rapid(-4, 0, 5).feed(-4, 0, -1).arc(ARC_CCW, (4, 0, -1), (0, 0, -1), plane=ZX)
    program.feed(0, -3, -1).arc(ARC_CW, (0, 3, -1), (0, 0, -1), plane=YZ).rapid(2, 0, 5).feed(2, 0, -2)
    program.arc(ARC_CCW, (-5, 0, -2), (0, 0, -2))
    moves = moves_of(program.toolpath(), tool("ball"), STOCK)
    assert (moves.arc == -1).all() and len(moves) > 100
    assert moves.share[-1] == 1.0 and (np.diff(moves.share[moves.row == moves.row[-1]]) > 0).all()


@pytest.mark.parametrize("shape", ["flat", "ball"])
def test_short_level_moves_along_x_cut_what_those_along_y_do(shape: str) -> None:
    turns = np.cumsum(np.random.default_rng(11).normal(0.0, 0.2, 80))
    steps = np.column_stack([np.cos(turns), np.sin(turns), 0.0 * turns]) * 0.3
    points = np.array([-12.0, 1.0, -2.0]) + np.cumsum(steps, axis=0)
    along_x, along_y = (
        cut(Moves.lines(ends[:-1], ends[1:], form_of(tool(shape))), CELL_MM).part
        for ends in (points, points[:, [1, 0, 2]])
    )
    for heights in (Part.heights_mm, Part.means_mm):
        assert heights(along_x).tobytes() == heights(along_y).T.tobytes()
        assert (heights(along_x) < 0).any()


@pytest.mark.parametrize("shape", TOOLS)
def test_the_profile_is_that_of_the_drawing(shape: str) -> None:
    out = np.linspace(0, R, 50)
    form = form_of(tool(shape))
    assert [height_at(r, form) for r in out] == pytest.approx(profile(shape, out), abs=1e-9)


def test_a_tool_without_its_shapes_own_keys_is_a_flat() -> None:
    for shape in ("bullnose", "v", "engraver", "jet", "wire"):
        assert form_of(Tool(number=1, shape=shape, diameter_mm=6)) == Form(3.0, 3.0)
    assert form_of(Tool(number=1, shape="drill", diameter_mm=6)) == form_of(tool("drill"))
