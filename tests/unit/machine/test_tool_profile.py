# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tool's profile is declared once: the radius by height and the height by radius are each other's inverse."""

from __future__ import annotations

import math
import random
import re
from collections import Counter

import numpy as np
import pytest

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.simulation.cutter_solid import Cutter, height_at
from CNCStepper.simulation.meshes.tool_outline import outlines_mm
from helpers.imports import PACKAGE, modules

THICKNESS_MM = 8.0
NEAR_MM = 1e-6
KEYS = "corner_radius_mm|tip_angle_deg|point_angle_deg|taper_deg"  # without which there is no profile


def random_tool(chance: random.Random) -> Tool:
    """Return a tool of a random shape, with the keys of its shape or without them."""
    shape = chance.choice(["flat", "ball", "bullnose", "v", "engraver", "drill", "jet", "wire"])
    diameter = chance.uniform(0.2, 20.0)
    given: dict[str, float] = {}
    if chance.random() < 0.8:
        given = {
            "bullnose": {"corner_radius_mm": chance.uniform(0.02, 0.5) * diameter},
            "v": {"tip_angle_deg": chance.uniform(10, 170)},
            "engraver": {"tip_angle_deg": chance.uniform(10, 90), "tip_diameter_mm": chance.uniform(0, 0.9) * diameter},
            "drill": {"point_angle_deg": chance.uniform(60, 150)},
            "jet": {"taper_deg": chance.uniform(0.1, 5)},
            "wire": {"taper_deg": chance.uniform(0.1, 40)},
        }.get(shape, {})
    return Tool(number=1, shape=shape, diameter_mm=diameter, **given)  # type: ignore[arg-type]


def test_radius_and_height_are_inverse() -> None:
    seed = random.randrange(2**32)
    print("seed", seed)
    chance, kinds = random.Random(seed), Counter[str]()
    for _ in range(400):
        tool = random_tool(chance)
        form = form_of(tool, THICKNESS_MM)
        kinds["flat" if form.is_flat else "corner" if form.corner_mm else "cone"] += 1
        kinds["pointed"] += form.tip_mm == 0.0
        heights = np.linspace(0.0, 1.2 * form.rise_mm, 40)
        radii = form.radius_at(heights)
        assert (np.diff(radii) >= 0.0).all()
        assert radii[0] == pytest.approx(form.radius_mm if form.is_flat else form.tip_mm)
        assert radii[-1] == pytest.approx(form.radius_mm)
        for height, radius in zip(heights, radii, strict=True):
            back = height_at(min(float(radius), form.radius_mm), form)
            assert abs(back - min(height, form.rise_mm)) < 1e-4 * max(1.0, form.rise_mm) or form.is_flat, tool
        assert np.array_equal(Cutter(form).radius_at(heights), radii)
        outline, _ = outlines_mm(tool, THICKNESS_MM)
        beyond = outline[:, 1] <= form.rise_mm
        if not form.is_flat:
            assert np.abs(form.radius_at(outline[beyond, 1])[1:] - outline[beyond, 0][1:]).max() < NEAR_MM, tool
    assert min(kinds[kind] for kind in ("flat", "corner", "cone", "pointed")) > 20, kinds


def test_a_drill_without_an_angle_has_the_standard_point() -> None:
    form = form_of(Tool(number=1, shape="drill", diameter_mm=6.0))
    assert form.rise_mm == pytest.approx(3.0 / math.tan(math.radians(59.0)))
    assert form.radius_at(form.rise_mm / 2) == pytest.approx(1.5)


def reads_a_shape(source: str) -> bool:
    """Whether a module takes the keys of a tool's shape out of a tool, by which it may calculate a profile."""
    return bool(re.search(rf"\btool\w*\.({KEYS})\b", source))


def test_nothing_else_calculates_a_profile() -> None:
    tools = PACKAGE / "machine" / "tools"
    others = {name: path for name, path in modules().items() if not path.is_relative_to(tools)}
    assert len(others) > 500
    assert not [name for name, path in others.items() if reads_a_shape(path.read_text("utf-8"))]
    assert reads_a_shape("corner = setup.tool.corner_radius_mm")
    assert not reads_a_shape("form_of(tool).corner_mm")
