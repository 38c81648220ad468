# SPDX-License-Identifier: LGPL-2.1-or-later
"""What every cycle that leaves a flat floor asks of its tool."""

from __future__ import annotations

from CNCStepper.errors import CycleError
from CNCStepper.machine.tools.tool import Tool


def require_flat(tool: Tool) -> None:
    """Raise CycleError when the tool leaves no flat floor."""
    if tool.shape != "flat":
        raise CycleError("tool-shape", f"a {tool.shape} tool leaves no flat floor", advice="use a flat tool")


def require_stepover(stepover_mm: float, tool: Tool, says: str = "stepover_mm (ae)") -> None:
    """Raise CycleError when passes are farther apart than the tool is wide; says: the key's name."""
    if stepover_mm > tool.diameter_mm:
        raise CycleError(
            "stepover-wide",
            f"{says} is larger than the tool",
            value=f"{stepover_mm:g} mm",
            limit=f"{tool.diameter_mm:g} mm",
            advice="make it smaller, or islands remain",
        )
