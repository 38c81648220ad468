# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values with which new objects of a lathe begin: they fit the bar and the tool."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.features.turning.turning_tool import BORING, DRILL, PARTING, THREADING, TURNING

PROFILE = ("20; 0", "20; -30")
KIND_OF_TOOL = {
    "turn_face": TURNING,
    "turn_rough": TURNING,
    "turn_finish": TURNING,
    "turn_taper": TURNING,
    "turn_groove": PARTING,
    "turn_part": PARTING,
    "turn_drill": DRILL,
    "turn_bore": BORING,
    "turn_thread": THREADING,
}
TOOLS: dict[str, dict[str, Any]] = {
    TURNING: {"insert": "CNMG 120408", "shank_mm": 20.0},
    PARTING: {"width_mm": 3.0, "reach_mm": 30.0, "feed_mm_rev": 0.05},
    DRILL: {"diameter_mm": 10.0},
    BORING: {"insert": "CCMT 060204", "bar_mm": 8.0, "smallest_bore_mm": 10.0},
    THREADING: {"insert": "", "tip_angle_deg": 60.0, "spindle_rpm": 90.0},
}
TO_LEAVE_MM = 0.3  # on a profile that is finished afterwards
SMALL_SHARE, LARGE_SHARE = 0.6, 0.9  # of the bar's diameter: of a profile or cone at its begin and its end
TAPER_SHARE = 0.25  # of the bar's length: a cone
GROOVE_SHARE = 0.8  # of the bar's diameter: the floor of a groove
PART_SHARE = 0.6  # of the bar's length: what is kept of it
DRILLED_SHARE = 0.3  # of the bar's length


def profile(job: Any) -> tuple[str, ...]:
    """Return the rows of a new profile: two steps on the bar of a lathe's job, X as its diameter."""
    large, small = (round(share * float(job.Diameter), 1) for share in (LARGE_SHARE, SMALL_SHARE))
    middle, end = round(-0.25 * float(job.Length), 1), round(-0.5 * float(job.Length), 1)
    return f"{small:g}; 0", f"{small:g}; {middle:g}", f"{large:g}; {middle:g}", f"{large:g}; {end:g}"


def tool(kind: str) -> dict[str, Any]:
    """Return the values of a new tool of a kind."""
    return {"kind": kind, **TOOLS[kind]}


def operation(cycle: str, diameter_mm: float, length_mm: float, tool: Any) -> dict[str, Any]:
    """Return the values of a new operation on a bar, by its cycle."""
    if cycle in ("turn_rough", "turn_bore"):
        return {"stock_to_leave_mm": TO_LEAVE_MM}
    if cycle == "turn_taper":
        small, large = round(SMALL_SHARE * diameter_mm, 1), round(LARGE_SHARE * diameter_mm, 1)
        return {"diameter_mm": small, "end_diameter_mm": large, "length_mm": round(TAPER_SHARE * length_mm, 1)}
    if cycle == "turn_groove":
        floor_mm, width_mm = round(GROOVE_SHARE * diameter_mm, 1), float(tool.Width)
        return {"diameter_mm": floor_mm, "top_diameter_mm": diameter_mm, "width_mm": width_mm}
    if cycle == "turn_part":
        return {"z_mm": round(-PART_SHARE * length_mm, 1)}
    if cycle == "turn_drill":
        return {"depth_mm": round(DRILLED_SHARE * length_mm, 1)}
    return {}
