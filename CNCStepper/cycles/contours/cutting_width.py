# SPDX-License-Identifier: LGPL-2.1-or-later
r"""How wide a tool cuts at a height above its tip, and which tools can follow a contour.

ball, bull-nose      v, engraver        jet, wire with taper
  |     |             \     /            \        /    the kerf is `diameter` wide at the sheet's top and
  `.   .'              \   /              \      /     narrower below; how much depends on the sheet's
    `-'                 `-'                \____/      thickness, that is on the contour's depth
"""

from __future__ import annotations

from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.machine.tools.tool_shapes import BEAMS, SIDEWAYS

KERF_SHARE = 0.1  # of its width: wear and run-out make a rotating tool's cut no more narrower or wider than this


def require_contour_tool(tool: Tool) -> None:
    """Raise CycleError for a tool that cannot cut with its side."""
    if tool.shape not in SIDEWAYS:
        raise CycleError(
            "tool-shape", "a drill cannot cut along a contour", advice="use a mill, an engraver, a jet or a wire"
        )


def radius_at(tool: Tool, height_mm: float, depth_mm: float) -> float:
    """Return the radius that a tool cuts with at a height above its tip, for a contour of that depth."""
    return float(form_of(tool, depth_mm).radius_at(height_mm))


def require_kerf(tool: Tool, kerf_mm: float, depth_mm: float) -> None:
    """Raise CycleError for a kerf that a rotating tool cannot have; 0 is the tool's own."""
    wide_mm = 2.0 * radius_at(tool, depth_mm, depth_mm)
    if not kerf_mm or tool.shape in BEAMS or abs(kerf_mm - wide_mm) <= KERF_SHARE * wide_mm + 1e-9:
        return
    raise CycleError(
        "kerf-far",
        "kerf_mm is not what this tool cuts",
        value=f"{kerf_mm:g} mm",
        limit=Text(
            "{kerf_share:.4g} to {kerf_share2:.4g} mm",
            kerf_share=(1.0 - KERF_SHARE) * wide_mm,
            kerf_share2=(1.0 + KERF_SHARE) * wide_mm,
        ),
        advice="measure the width of its cut, or leave kerf_mm out",
    )
