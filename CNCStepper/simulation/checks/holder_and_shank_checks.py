# SPDX-License-Identifier: LGPL-2.1-or-later
"""Holder, shank and flutes against the stock: what of a tool above its flutes meets material.

holder   goes into stock                      above the length that the tool sticks out
shank    rubs along a wall                    above the flutes
flutes   cut deeper than they are long        at the material in front of the tool
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.simulation.check_context import CheckContext
from CNCStepper.simulation.finding import Finding, Severity

if TYPE_CHECKING:
    from CNCStepper.simulation.removal.engagement import Engagement

DEPTH_ERROR_MM = 0.01


def names_heights(tool: Tool) -> bool:
    """Return whether a tool names the length of its flutes, or its holder, so that something can be checked."""
    return bool(tool.flute_length_mm or (tool.length_mm and tool.holder_diameter_mm))


class HolderAndShank:
    """What one tool meets above its cutting edges, against the lengths that it names."""

    def __init__(self, tool: Tool):
        self._tool = tool
        self._cut, self._wall = (LargestExcess(tool.flute_length_mm, DEPTH_ERROR_MM) for _ in range(2))
        self._holder = LargestExcess(tool.length_mm, DEPTH_ERROR_MM)

    def add(self, met: Engagement, of_place: np.ndarray, mine: np.ndarray) -> None:
        """Take further places; of_place: the record of each one's segment, mine: where it is this tool."""
        feed = mine & of_place["is_feed"]
        self._cut.add(met, of_place, feed, met.uncut_mm)
        self._wall.add(met, of_place, feed, met.beside_mm)
        if self._tool.holder_diameter_mm:
            self._holder.add(met, of_place, mine, met.holder_mm)

    def findings(self, subject: CheckContext) -> Iterator[Finding]:
        """Yield what meets material and may not."""
        tool = self._tool
        text = Text("the {tool} tool cuts deeper than its flutes are long", tool=tool.words)
        advice = "cut in more levels, or take a longer tool"
        yield from self._cut.finding(subject, "error", "flute-length", text, advice, "mm")
        if not self._cut.count:
            text = Text("the shank of the {tool} tool rubs along the wall over its flutes", tool=tool.words)
            yield from self._wall.finding(subject, "warning", "shank", text, advice, "mm")
        text = Text("the holder of the {tool} tool goes into stock", tool=tool.words)
        yield from self._holder.finding(subject, "error", "holder", text, "clamp the tool with more stickout", "mm")


class LargestExcess:
    """The place where a value is largest, of those where it is above its limit by more than the measuring error.

    limit: 0 where the tool does not say it. count: rows with such places.
    """

    def __init__(self, limit: float, error: float):
        self._limit, self._error = limit, error
        self._value, self._line = -np.inf, 0
        self._place_mm: tuple[float, ...] = ()
        self._last_row = -1
        self.count = 0

    def add(self, met: Engagement, of_place: np.ndarray, where: np.ndarray, value: np.ndarray) -> None:
        """Take the values at further places, those with `where`."""
        if not self._limit:
            return
        over = np.flatnonzero(where & (np.nan_to_num(value, nan=-np.inf) > self._limit + self._error))
        if not len(over):
            return
        rows = np.unique(of_place["row"][over])
        self.count += len(rows) - int(rows[0] == self._last_row)
        self._last_row = int(rows[-1])
        k = int(over[value[over].argmax()])
        if value[k] > self._value:
            self._value, self._line = float(value[k]), int(of_place["line"][k])
            self._place_mm = tuple(met.place_mm[k].tolist())

    def finding(
        self, subject: CheckContext, severity: Severity, code: str, text: str, advice: str, unit: str
    ) -> Iterator[Finding]:
        """Yield the finding, where there is one."""
        if self.count:
            numbers: dict[str, Any] = {"value": self._value, "limit": self._limit, "unit": unit, "count": self.count}
            yield subject.finding_at(
                self._line, severity, code, text, advice=advice, place_mm=self._place_mm, **numbers
            )
