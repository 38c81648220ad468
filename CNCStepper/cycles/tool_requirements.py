# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every cycle that leaves a flat floor asks of its tool."""

from __future__ import annotations

from CNCStepper.errors import CycleError, Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_shapes import FLAT_FLOOR


def require_flat(tool: Tool) -> None:
    """Raise CycleError when the tool leaves no flat floor."""
    if tool.shape not in FLAT_FLOOR:
        raise CycleError(
            "tool-shape",
            Text("a {tool_shape} tool leaves no flat floor", tool_shape=tool.shape),
            advice="use a flat tool",
        )


def require_stepover(stepover_mm: float, tool: Tool, says: str = "stepover_mm (ae)") -> None:
    """Raise CycleError when passes are farther apart than the tool is wide; says: the key's name."""
    if stepover_mm > tool.diameter_mm:
        raise CycleError(
            "stepover-wide",
            Text("{says} is larger than the tool", says=says),
            value=f"{stepover_mm:g} mm",
            limit=f"{tool.diameter_mm:g} mm",
            advice="make it smaller, or islands remain",
        )
