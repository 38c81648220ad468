# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the caller of a restart decides; all the rest follows from the program."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_shapes import BEAMS


@dataclass(frozen=True)
class Options:
    """How a path is entered.

    overlap_mm: how much of the way before the place is cut again. height_mm: to which the tool goes up first, above the
    stock's work zero; None is the highest at which the program's own rapids cross. spin_up_s: of the spindle. laser:
    the spindle is a laser. tools: by number, or one for every number.
    """

    overlap_mm: float = 0.0
    height_mm: float | None = None
    spin_up_s: float = 0.0
    laser: bool = False
    tools: Mapping[int, Tool] | Tool | None = None

    def tool(self, number: int) -> Tool | None:
        """Return the tool with a number, None where it is not known."""
        if isinstance(self.tools, Tool):
            return self.tools
        return self.tools.get(number) if self.tools else None

    def is_beam(self, number: int) -> bool:
        """Whether a tool is a beam or a jet, which is on only where it cuts."""
        tool = self.tool(number)
        return self.laser or (tool is not None and tool.shape in BEAMS)
