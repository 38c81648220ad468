# SPDX-License-Identifier: LGPL-2.1-or-later
"""The tool to look at: as wide and as pointed as the one that cuts, and closed when turned."""

from __future__ import annotations

import math

import numpy as np
import pytest

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.meshes.bodies_of_revolution import AROUND, revolved
from CNCStepper.simulation.meshes.tool_outline import outlines_mm


@pytest.mark.parametrize(
    ("tool", "point_mm"),
    [
        (Tool(number=1, shape="flat", diameter_mm=6), 0.0),
        (Tool(number=1, shape="ball", diameter_mm=6), 3.0),
        (Tool(number=1, shape="bullnose", diameter_mm=6, corner_radius_mm=1), 1.0),
        (Tool(number=1, shape="v", diameter_mm=6, tip_angle_deg=90), 3.0),
        (Tool(number=1, shape="drill", diameter_mm=6), 3 / math.tan(math.radians(59))),
    ],
    ids=lambda value: getattr(value, "shape", ""),
)
def test_the_end_is_as_high_as_its_form(tool: Tool, point_mm: float) -> None:
    cutter, shank = outlines_mm(tool, 20.0)
    assert tuple(cutter[0]) == (0, 0) and cutter[:, 0].max() == pytest.approx(3)
    assert cutter[-2] == pytest.approx((3, point_mm)) and (np.diff(cutter[:, 1]) >= 0).all()
    assert tuple(shank[0]) == tuple(cutter[-1]) and shank[-1, 0] == 0


def test_own_lengths_are_kept() -> None:
    cutter, shank = outlines_mm(Tool(number=1, shape="flat", diameter_mm=6, flute_length_mm=22, length_mm=60), 20.0)
    assert cutter[-1, 1] == 22 and shank[-1, 1] == 60


def test_a_turned_outline_looks_outwards() -> None:
    faces = revolved(np.array([(0.0, 0.0), (3.0, 0.0), (3.0, 9.0), (0.0, 9.0)])).astype(float)
    area = np.cross(faces[:, 2] - faces[:, 0], faces[:, 3] - faces[:, 1]) / 2
    volume = (faces.mean(axis=1) * area).sum() / 3
    assert volume == pytest.approx(9 * AROUND / 2 * 9 * math.sin(2 * math.pi / AROUND), rel=1e-6)
