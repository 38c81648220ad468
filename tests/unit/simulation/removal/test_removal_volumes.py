# SPDX-License-Identifier: LGPL-2.1-or-later
"""Removed volumes of every cutter on plunges, lines, ramps, arcs and helices against volumes that no grid made."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.simulation.cutter_solid import height_at
from CNCStepper.simulation.removal.heightmap import height_map
from CNCStepper.simulation.stock import Stock
from CNCStepper.toolpath import ARC_CCW, ARC_CW
from helpers.simulation.programs import Program, begun

STOCK = Stock((40, 32, 20))
R, DEPTH = 3.0, 2.0
TOOLS = [
    Tool(number=1, diameter_mm=6, shape="flat"),
    Tool(number=1, diameter_mm=6, shape="ball"),
    Tool(number=1, diameter_mm=6, shape="bullnose", corner_radius_mm=1),
    Tool(number=1, diameter_mm=6, shape="v", tip_angle_deg=90),
    Tool(number=1, diameter_mm=6, shape="engraver", tip_angle_deg=40, tip_diameter_mm=0.8),
    Tool(number=1, diameter_mm=6, shape="drill"),
]
each_tool = pytest.mark.parametrize("tool", TOOLS, ids=lambda tool: tool.shape)
one_tool_quickly = pytest.mark.parametrize(
    "tool",
    [tool if tool.shape == "ball" else pytest.param(tool, marks=pytest.mark.slow) for tool in TOOLS],
    ids=lambda tool: tool.shape,
)
TURN_OFF = math.radians(23.7)  # of lines and ramps against the grid


def heights(tool: Tool, out: np.ndarray) -> np.ndarray:
    form = form_of(tool)
    return np.vectorize(lambda r: height_at(r, form))(out)


def integral(values: np.ndarray, x: np.ndarray) -> float:
    return float(np.trapezoid(values, x))


def across(tool: Tool) -> tuple[np.ndarray, np.ndarray]:
    """Return radii and how deep the cutter is there when its tip is DEPTH below the top."""
    out = np.linspace(0, R, 20001)
    return out, np.maximum(DEPTH - heights(tool, out), 0)


def plunged(tool: Tool) -> float:
    out, deep = across(tool)
    return integral(2 * np.pi * out * deep, out)


def assert_volume(program: Program, tool: Tool, want: float) -> None:
    """Assert 0.1 % at 0.05 mm cells, and that coarse cells are worse unless both are close."""
    toolpath = program.toolpath()
    coarse, fine = (abs(height_map(toolpath, tool, STOCK, cell).removed_volume_mm3 / want - 1) for cell in (0.4, 0.05))
    assert fine < 1e-3
    assert fine < max(coarse / 4, 3e-4)


@each_tool
def test_a_plunge(tool: Tool) -> None:
    assert_volume(begun().rapid(0.013, 0.021, 5).feed(0.013, 0.021, -DEPTH), tool, plunged(tool))


@each_tool
@pytest.mark.parametrize("turn", [pytest.param(0.0, marks=pytest.mark.slow), TURN_OFF])
def test_a_line(tool: Tool, turn: float) -> None:
    x, y = 15 * math.cos(turn), 15 * math.sin(turn)
    out, deep = across(tool)
    program = begun().rapid(-x / 2, -y / 2, 5).feed(-x / 2, -y / 2, -DEPTH).feed(x / 2, y / 2, -DEPTH)
    assert_volume(program, tool, plunged(tool) + 15 * 2 * integral(deep, out))


@pytest.mark.slow
@one_tool_quickly
@pytest.mark.parametrize("fall", [pytest.param(0.5, marks=pytest.mark.slow), 4.0])
def test_a_ramp(tool: Tool, fall: float) -> None:
    """In each plane along the ramp the cutter is convex, so that what it sweeps there is a convex hull."""
    x, y = 12 * math.cos(TURN_OFF), 12 * math.sin(TURN_OFF)
    program = begun().rapid(-x / 2, -y / 2, 5).feed(-x / 2, -y / 2, -0.5).feed(x / 2, y / 2, -0.5 - fall)
    beside = R * np.sin(np.linspace(0, np.pi / 2, 161))
    below = shapely.box(-50, -50, 50, 0)
    areas = []
    for p in beside:
        t = math.sqrt(max(R**2 - p**2, 0)) * np.sin(np.linspace(-np.pi / 2, np.pi / 2, 801))
        z = heights(tool, np.minimum(np.hypot(t, p), R)) - 0.5
        points = [np.column_stack(c) for c in ((t, z), (t + 12, z - fall), (t, z + 40), (t + 12, z + 40))]
        areas.append(shapely.MultiPoint(np.vstack(points)).convex_hull.intersection(below).area)
    assert_volume(program, tool, 2 * integral(np.array(areas), beside))


@each_tool
@pytest.mark.parametrize("kind", [ARC_CCW, pytest.param(ARC_CW, marks=pytest.mark.slow)])
def test_a_circle(tool: Tool, kind: int) -> None:
    out, deep = across(tool)
    program = begun().rapid(8, 0, 5).feed(8, 0, -DEPTH).arc(kind, (8, 0, -DEPTH), (0, 0, 0))
    assert_volume(program, tool, 2 * np.pi * 8 * 2 * integral(deep, out))


@each_tool
def test_an_arc(tool: Tool) -> None:
    out, deep = across(tool)
    program = begun().rapid(9, 0, 5).feed(9, 0, -DEPTH).arc(ARC_CCW, (0, 9, -DEPTH), (0, 0, 0))
    assert_volume(program, tool, plunged(tool) + np.pi / 2 * 9 * 2 * integral(deep, out))


@pytest.mark.slow
@one_tool_quickly
@pytest.mark.parametrize(("radius", "pitch"), [(2.0, 0.8), pytest.param(6.0, 1.5, marks=pytest.mark.slow)])
def test_a_helix(tool: Tool, radius: float, pitch: float) -> None:
    """Seen from the axis: the lowest that the cutter reaches on the last two passes of each place."""
    top, turns = -0.4 - DEPTH, 3
    program = begun().rapid(radius, 0, 5).feed(radius, 0, top)
    program.arc(ARC_CCW, (radius, 0, top - turns * pitch), (0, 0, 0), turns=turns)
    out = np.linspace(max(radius - R, 0), radius + R, 601)
    since = np.linspace(0, 2 * np.pi, 361)  # how far before the helix' end it passed the place last
    v = np.linspace(-np.pi, np.pi, 1441)
    fall = pitch / (2 * np.pi)
    distance = np.sqrt((out[:, None] - radius) ** 2 + 4 * out[:, None] * radius * np.sin(v / 2) ** 2)
    height, below = np.full(distance.shape, 1e3), distance <= R + 1e-9
    height[below] = heights(tool, np.minimum(distance[below], R))
    lowest_yet = np.minimum.accumulate(height - fall * v, axis=1)  # on the way up to each v
    passes = []
    for past in (since - 2 * np.pi, since, since + 2 * np.pi):
        reached = np.searchsorted(v, past, side="right") - 1
        passes.append(np.where(reached < 0, 1e3, lowest_yet[:, reached] + fall * past))
    depth = np.maximum(-(top - turns * pitch + np.min(passes, axis=0)), 0)
    want = integral(out * np.array([integral(row, since) for row in depth]), out)
    assert_volume(program, tool, want)


def test_the_volume_does_not_depend_on_where_the_cells_lie() -> None:
    """A slot along the grid, its walls anywhere within a cell: half a cell would be 0.8 % of its volume."""
    volumes = [
        height_map(
            begun().rapid(0, y, 5).feed(0, y, -2).feed(12, y, -2).toolpath(), TOOLS[0], STOCK, 0.1
        ).removed_volume_mm3
        for y in np.linspace(0, 0.1, 7)
    ]
    assert volumes == pytest.approx([2 * (np.pi * R**2 + 12 * 2 * R)] * 7, rel=1e-4)


def test_a_cutter_narrower_than_a_cell() -> None:
    needle = Tool(number=1, shape="flat", diameter_mm=0.04)
    program = begun().feed(-7, -3, -1).feed(8, 4, -1)
    assert height_map(program.toolpath(), needle, STOCK, 0.1).removed_volume_mm3 == pytest.approx(
        np.hypot(15, 7) * 0.04, rel=0.02
    )
