# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernels give the same bytes compiled, compiled with checked bounds, and as plain Python."""

from __future__ import annotations

from collections.abc import Callable

import pytest

SMALL = """
import hashlib
import numpy as np
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.removal.removal_moves import moves_of
from CNCStepper.simulation.stock import Cylinder, Stock
from CNCStepper.simulation.removal.heightmap import Grid, Part
from CNCStepper.state import Start, State
from CNCStepper.toolpath import ARC_CCW, ARC_CW, TableBuilder
tools = [("flat", {}), ("ball", {}), ("bullnose", {"corner_radius_mm": 0.7}), ("v", {"tip_angle_deg": 60})]
for shape, keys in tools:
    for stock in (Stock((19, 13, 5)), Cylinder((14, 14, 5))):
        table = TableBuilder(Start.at_zero(), State(tool=1, spindle="cw"))
        rng = np.random.default_rng(3)
        for point in rng.uniform((-12, -9, -6), (12, 9, 0.5), (25, 3)):
            table.feed(point, 600)
            for x, y in ((0.3, 0.1), (0.7, 0.2), (0.6, 0.7)):  # a ramp, and level moves along x and along y
                table.feed(point + (x, y, -0.05), 600)
        table.feed((3, 0, -1), 600)
        table.arc(ARC_CCW, (3, 0, -3), (1, 0, -1), 600, turns=3)
        table.arc(ARC_CW, (-1, 0, -3), (1, 0, -1), 600)
        table.feed((-1, 0, -9), 600)
        tool = Tool(number=1, shape=shape, diameter_mm=2.2, **keys)
        part = Part(Grid.of(stock, 0.11)).after(moves_of(table.toolpath(), tool, stock))
        data = part.heights_mm().tobytes() + part.means_mm().tobytes()
        print(shape, hashlib.sha256(data).hexdigest(), repr(part.removed_volume_mm3))
"""


@pytest.mark.slow
def test_compiled_checked_and_plain_python_agree(printed_three_ways: Callable[[str], list[str]]) -> None:
    compiled, checked, plain = printed_three_ways(SMALL)
    assert compiled == checked == plain
    assert len(compiled.splitlines()) == 8
