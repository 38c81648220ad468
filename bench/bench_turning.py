# SPDX-License-Identifier: LGPL-2.1-or-later
"""The exact turned part: a program of 10 000 moves over a curved profile, and the checks of its part."""

from __future__ import annotations

import time

import numpy as np

from CNCStepper.machine.tools.turning_tool import TurningTool
from CNCStepper.simulation.turning.half_section import bar
from CNCStepper.simulation.turning.swept_outline import moves_of
from CNCStepper.simulation.turning.tool_section import ToolSection
from CNCStepper.simulation.turning.turned_part import turned_part
from CNCStepper.simulation.turning.turning_checks import TurningSetup, check_turning
from CNCStepper.simulation.turning.wanted_profile import wanted_chain
from CNCStepper.state import Start, State
from CNCStepper.toolpath import TableBuilder, Toolpath

PASSES, MOVES = 50, 200


def wavy(z: np.ndarray) -> np.ndarray:
    """Return the radius of the profile at each z."""
    return 20 + 3 * np.sin(z / 8)


def program() -> Toolpath:
    """Return passes of short lines, each 0.3 mm deeper, down to the profile."""
    table = TableBuilder(Start((40.0, 0.0, 5.0), zero_known=True), State(tool=1, spindle_rpm=1000, spindle="cw"))
    z = np.linspace(1, -100, MOVES)
    for left_mm in np.linspace(15, 0, PASSES):
        radius = np.minimum(wavy(z) + left_mm, 30)
        table.rapid((40, 0, 3))
        table.rapid((radius[0], 0, 3))
        for place, x in zip(z.tolist(), radius.tolist(), strict=True):
            table.feed((x, 0, place), 200)
        table.feed((40, 0, -98), 500)
    return table.toolpath()


def main() -> None:
    """Print the processor time of each step."""
    path, stock = program(), bar(55, 170, 1)
    z = np.linspace(0, -100, MOVES)
    wanted = wanted_chain(np.column_stack([z, wavy(z)]), left_mm=1.0, tools=(1,), name="wavy")
    tools = {1: ToolSection.of(TurningTool(number=1, insert="VBMT 160404", lead_deg=107.5, shank_mm=20))}
    begun = time.process_time()
    part = turned_part(moves_of(path), stock, tools)
    cut = time.process_time()
    found = check_turning(part, TurningSetup(stock, tools, wanted=[wanted]))
    checked = time.process_time()
    profile = part.section.outer_profile
    state = part.at(len(path) // 2)
    print(f"{len(path)} moves: part {cut - begun:.2f} s, checks {checked - cut:.2f} s, {len(found)} findings")
    ended = time.process_time()
    taken_s, left = ended - checked, state.volume_mm3
    print(f"profile of {len(profile)} points and the state half way, {left:.0f} mm3: {taken_s:.3f} s")


if __name__ == "__main__":
    main()
