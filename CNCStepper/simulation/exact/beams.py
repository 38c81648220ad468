# SPDX-License-Identifier: LGPL-2.1-or-later
"""Jets and wires: they cut through the whole sheet wherever they are held, and only while they are on."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.profile import Machine
from CNCStepper.simulation.check_context import CheckContext, PartCheck
from CNCStepper.simulation.cutter_solid import BEAM, Tools, tool_numbered
from CNCStepper.simulation.exact.edge_tree import flat_edges
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, segments
from CNCStepper.toolpath import RAPID, Toolpath

FLATTEN_MM = 0.01


def beam_rows(toolpath: Toolpath, tools: Tools | None) -> tuple[np.ndarray, np.ndarray]:
    """Return which rows have a beam for their tool, and on which of them it is on, bool[n] each."""
    shapes = [getattr(tool_numbered(tools, state.tool), "shape", "") for state in toolpath.states]
    is_beam = np.array([shape in BEAM for shape in shapes], bool)
    on = is_beam & np.array([state.spindle_turns for state in toolpath.states], bool)
    state = toolpath.table().state
    return is_beam[state], on[state]


def beam_cuts(toolpath: Toolpath, tools: Tools | None) -> np.ndarray:
    """Return on which rows a beam cuts, bool[n]: it is on, and the row is no rapid."""
    return beam_rows(toolpath, tools)[1] & (toolpath.table().kind != RAPID)


def through(pieces: Segments, bottom_mm: float) -> Segments:
    """Return the segments laid at the stock's bottom, where the narrow end of a beam's kerf is."""
    begin, end = pieces.begin.copy(), pieces.end.copy()
    begin[:, 2] = end[:, 2] = bottom_mm
    return Segments(begin, end, pieces.row)


def switches_itself_off(machine: Machine) -> bool:
    """Return whether the controller switches the beam off on rapids by itself, as that of a laser does ($32=1)."""
    return machine.spindle.laser


class Beams(PartCheck):
    """Finds rapids that the process forbids, and a program whose beam is never on.

    Of a beam whose process is not known the rapids over the stock are found on which it is on. A process without power
    on rapids may have none on any of them; a wire may not cross the stock on one, for it would cut even when it is off.
    """

    def __init__(self, stock: Stock, tools: Tools, process: Process = MILLING):
        self._stock, self._tools, self._process = stock, tools, process
        self._ever_on = False  # on a feed over the stock
        self._dark: list[Finding] = []  # feeds over the stock with the beam off

    def __call__(self, subject: CheckContext) -> Iterator[Finding]:
        is_beam, on = beam_rows(subject.toolpath, self._tools)
        if not is_beam.any():
            return
        over = self._over_stock(subject)
        yield from self._rapids(subject, is_beam & ~subject.is_feed, on, over)
        feeds = np.flatnonzero(is_beam & subject.is_feed & over)
        self._ever_on |= bool(on[feeds].any())
        if len(feeds) and not self._ever_on:
            text, advice = "the beam is never on during a cut", "switch it on with M3 and S before it"
            row, code = int(feeds[0]), "spindle-off"
            self._dark.append(subject.finding(row, "error", code, text, advice=advice, count=len(feeds), group="beam"))

    def _rapids(self, subject: CheckContext, rapid: np.ndarray, on: np.ndarray, over: np.ndarray) -> Iterator[Finding]:
        """Yield one finding for the rapids that are forbidden; each argument is bool[n]."""
        text, advice = "a rapid crosses the stock with the beam on", "switch it off with M5 before it"
        wrong = rapid & on & over
        if self._process.rapid == "unpowered":
            text, wrong = "a rapid goes with the power on", rapid & on
        elif self._process.rapid == "never":
            text, advice = "a rapid crosses the sheet, which a wire cannot", "go round the sheet, or cut with G1"
            wrong = rapid & over
        rows = np.flatnonzero(wrong)
        if len(rows) and (self._process.rapid == "never" or not switches_itself_off(subject.machine)):
            row, code = int(rows[0]), "rapid-in-stock"
            yield subject.finding(row, "error", code, text, advice=advice, count=len(rows), group="beam")

    def _over_stock(self, subject: CheckContext) -> np.ndarray:
        """Return which rows cross the stock seen from above, bool[n]."""
        path = through(segments(subject.toolpath, FLATTEN_MM), self._stock.bottom_mm).known()
        over = np.zeros(len(subject.table), bool)
        over[path.row[shapely.intersects(shapely.linestrings(flat_edges(path)), self._stock.outline)]] = True
        return over

    def end(self, last: CheckContext) -> Iterator[Finding]:
        if not self._ever_on:
            yield from self._dark
