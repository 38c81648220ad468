# SPDX-License-Identifier: LGPL-2.1-or-later
"""A tool as two outlines to look at: what cuts, and the shank above it.

The cutting end is the very form by which material is removed. Where a tool's own lengths are not given they are
drawn as such tools usually are.
"""

from __future__ import annotations

import numpy as np

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.simulation.cutter_solid import height_at

FLUTES = 3.0  # usual length of the cutting part, in diameters
SHANK = 2.5  # usual length of the shank above it, in diameters
SHANK_SHARE = 0.98  # of the cutter's radius, so that the two look different
ROUND_STEPS = 8


def outlines_mm(tool: Tool, through_mm: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the outlines of cutter and shank from the tip up, float64[n, 2]: radius, height above the tip.

    through_mm: the thickness that a jet or a wire goes through.
    """
    form = form_of(tool, through_mm)
    steps = np.sin(np.linspace(0, np.pi / 2, ROUND_STEPS + 1)) if form.corner_mm else np.array([0.0, 1.0])
    radii = form.tip_mm + (form.radius_mm - form.tip_mm) * steps
    end = [(0.0, 0.0), *((radius, height_at(radius, form)) for radius in radii)]
    foot = max(tool.flute_length_mm or FLUTES * tool.diameter_mm, end[-1][1])
    top = max(tool.length_mm, foot + SHANK * tool.diameter_mm)
    shank = form.radius_mm * SHANK_SHARE
    cutter = np.array([*end, (form.radius_mm, foot)])
    return cutter, np.array([(form.radius_mm, foot), (shank, foot), (shank, top), (0.0, top)])
