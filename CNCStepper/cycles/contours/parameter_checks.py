# SPDX-License-Identifier: LGPL-2.1-or-later
"""Parameters of a contour that do not go together, or not with the tool."""

from __future__ import annotations

from CNCStepper.cycles.contours.contour_model import ContourModel
from CNCStepper.cycles.contours.cutting_width import require_contour_tool, require_kerf
from CNCStepper.cycles.cycle import Setup
from CNCStepper.cycles.moves import require_setup
from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.tool_shapes import BEAMS


def require_cuttable(cycle: ContourModel, setup: Setup) -> None:
    """Raise CycleError for parameters that do not go together, or not with the tool."""
    tool = setup.tool
    require_contour_tool(tool)
    require_setup(setup)
    require_kerf(tool, cycle.kerf_mm, cycle.depth_mm)
    if tool.shape in BEAMS and (cycle.tabs or cycle.ramp_deg):
        raise CycleError(
            "beam-height",
            Text("a {tool_shape} cuts through at any height: no tabs, no ramp", tool_shape=tool.shape),
            advice="leave them out",
        )
    if cycle.tabs and cycle.tabs.height_mm >= cycle.depth_mm:
        raise CycleError(
            "tab-high",
            "the tabs are as high as the contour is deep",
            value=f"{cycle.tabs.height_mm:g} mm",
            limit=Text("below {depth_mm:g} mm", depth_mm=cycle.depth_mm),
            advice="make them lower",
        )
    if cycle.side == "on" and (cycle.lead_in.kind != "none" or cycle.lead_out.kind != "none"):
        raise CycleError("lead-side", "on its line a contour has no scrap side for leads", advice="choose another side")
    if cycle.side == "on" and (cycle.dogbones != "none" or cycle.finish_stepover_mm or cycle.stock_to_leave_mm):
        what = "on its line a contour has no wall for dog-bones, a finishing pass or stock to leave"
        raise CycleError("wall-side", what, advice="choose another side")
    if tool.core_diameter_mm > 0 and (not cycle.ramp_deg or cycle.ramp_deg > tool.ramp_max_deg or cycle.tabs):
        raise CycleError(
            "tool-core",
            "the mill does not cut over its centre: it can neither plunge nor come down beside a tab",
            value=Text("ramp {ramp_deg:g} deg", ramp_deg=cycle.ramp_deg),
            limit=Text("above 0, at most {ramp_max_deg:g} deg, no tabs", ramp_max_deg=tool.ramp_max_deg),
            advice="set ramp_deg and no tabs, or use a mill that cuts over its centre",
        )
