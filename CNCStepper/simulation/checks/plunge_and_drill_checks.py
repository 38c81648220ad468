# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a tool cannot do in the stock: go straight down without cutting over its centre, drill sideways."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from CNCStepper.errors import Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import Form
from CNCStepper.simulation.checks.stock_checks import StockChecks
from CNCStepper.simulation.cutter_solid import Cutter
from CNCStepper.simulation.exact.stock_contact import RUB_MM
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.tip_segments import Segments
from CNCStepper.tolerances import SAME_MM

STEEPER = 1 + 1e-6  # than allowed, before it counts


def plunges(checks: StockChecks) -> Iterator[Finding]:
    """Yield each move on which a mill with a core goes down onto stock more steeply than on a ramp.

    Stock that earlier moves have taken from under the core (a pre-drilled hole) may be entered straight.
    """
    for row, tool in _low_feeds(checks, lambda tool: tool.core_diameter_mm > 0, downwards=True):
        move = checks.pieces(row)
        angle_deg = _fall_deg(move)
        steep = move[angle_deg > tool.ramp_max_deg * STEEPER]
        core_mm = tool.core_diameter_mm / 2
        point = checks.contact(Cutter(Form(core_mm, core_mm)), steep)
        if point is not None:
            yield checks.subject.finding(
                row,
                "error",
                "plunge",
                Text(
                    "a mill that does not cut over its centre ({tool}) goes down into stock too steeply",
                    tool=tool.words,
                ),
                advice="enter by a helix or ramp, or in the middle of a hole drilled before",
                place_mm=point,
                value=float(angle_deg.max()),
                limit=tool.ramp_max_deg,
                unit="deg",
            )


def sideways(checks: StockChecks) -> Iterator[Finding]:
    """Yield each move on which a drill goes sideways through stock: it cuts with its point only."""
    for row, _ in _low_feeds(checks, lambda tool: tool.shape == "drill", downwards=False):
        move = checks.pieces(row)
        aside = np.hypot(*(move.end - move.begin)[:, :2].T)
        cutter = checks.cutter(row)
        point = checks.contact(cutter, move[aside > SAME_MM]) if cutter else None
        if point is not None:
            text, advice = "a drill goes sideways through stock", "use a mill, or lift the drill before it"
            yield checks.subject.finding(row, "error", "drill-sideways", text, advice=advice, place_mm=point)


def _low_feeds(checks: StockChecks, of: Callable[[Tool], bool], downwards: bool) -> list[tuple[int, Tool]]:
    """Return the cutting rows of the tools asked for that go below the stock's top, with these tools."""
    subject, tools = checks.subject, {number: tool for number, tool in checks.tools.items() if tool and of(tool)}
    if not tools:
        return []
    low = np.isin(checks.numbers, list(tools))
    low &= subject.is_feed & (subject.low_mm < checks.stock.top_mm - RUB_MM)
    if downwards:
        low &= subject.low_mm < subject.begin[:, 2]
    return [(row, tools[int(checks.numbers[row])]) for row in np.flatnonzero(low).tolist()]


def _fall_deg(move: Segments) -> np.ndarray:
    way = move.end - move.begin
    return np.degrees(np.arctan2(-way[:, 2], np.hypot(way[:, 0], way[:, 1])))
