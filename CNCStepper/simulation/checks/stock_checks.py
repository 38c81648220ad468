# SPDX-License-Identifier: LGPL-2.1-or-later
"""What goes wrong at the stock: rapids and a still spindle in material, cuts below it, gouges, material left."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
import shapely

from CNCStepper.errors import Text, all_of
from CNCStepper.machine.processes import MILLING, Process
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import form_of
from CNCStepper.machine.tools.tool_shapes import OWN_KEYS
from CNCStepper.simulation.check_context import CheckContext
from CNCStepper.simulation.cutter_solid import BEAM, Cutter, Tools, tool_numbered
from CNCStepper.simulation.exact.edge_tree import flat_edges
from CNCStepper.simulation.exact.gouge import Worst
from CNCStepper.simulation.exact.stock_contact import RUB_MM, Cuts, Remaining
from CNCStepper.simulation.exact.swept_area import FLATTEN_MM, Judgement, cutting_path
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, clipped_below, segments

JUDGE_ERROR_MM = 0.001  # the judge's own error does not count against a program
PASSED_MM = 0.001
ON_EDGE_MM = 0.01  # a shape may end on the stock's edge
LineOf = Callable[[int], int]
SPOIL_MM = 5.0  # a spoil board is cut no deeper on purpose; below lies the table


def tools_known(subject: CheckContext, tools: Tools, seen: set[int]) -> Iterator[Finding]:
    """Yield each tool number that cuts and is not known, and each shape that is simulated as another.

    seen: the numbers that were checked before; those of this part are added.
    """
    numbers = subject.tool_numbers
    feeds = np.flatnonzero(subject.is_feed)
    for number in sorted(set(np.unique(numbers[feeds]).tolist()) - seen):
        seen.add(number)
        row = int(feeds[numbers[feeds] == number][0])
        tool = tool_numbered(tools, number)
        if tool is None:
            text = Text("tool {number} is unknown, so that its cuts are not checked", number=number)
            advice = "add the tool or correct the T word"
            yield subject.finding(row, "error", "unknown-tool", text, advice=advice)
        elif tool.shape not in ("flat", *BEAM) and Cutter(form_of(tool)).is_flat:
            text = Text(
                "the {tool_shape} tool's form is not given, so it is judged as a flat one of its diameter",
                tool_shape=tool.shape,
            )
            advice = Text("give its {own_key}", own_key=all_of(sorted(OWN_KEYS[tool.shape])))
            yield subject.finding(row, "warning", "tool-shape", text, advice=advice)


def unknown_place_cuts(subject: CheckContext, stock: Stock) -> Iterator[Finding]:
    """Yield moves below the stock's top at an unknown X or Y: their cut is unknown."""
    unknown = np.isnan(subject.end[:, :2]).any(axis=1) | np.isnan(subject.begin[:, :2]).any(axis=1)
    rows = np.flatnonzero(unknown & (subject.low_mm < stock.top_mm - RUB_MM))
    if len(rows):
        text = "the tool is below the stock's top while its place in X or Y is not known"
        advice = "name X and Y in a rapid above the stock first"
        row, code = int(rows[0]), "place-unknown-in-stock"
        yield subject.finding(row, "error", code, text, advice=advice, count=len(rows), group="")


class StockChecks:
    """The checks of a program, or of a part of it, against the stock that earlier moves have left.

    before: the cutting paths of the parts before.
    """

    def __init__(self, subject: CheckContext, stock: Stock, tools: Tools, before: Cuts = ()):
        self.subject = subject
        self.stock = stock
        self.path = segments(subject.toolpath, FLATTEN_MM).known()
        self.cuts = cutting_path(subject.toolpath, tools, stock.top_mm, stock)
        self.remaining = Remaining(stock, self.cuts, before)
        self.numbers = subject.tool_numbers
        self.tools = {int(number): tool_numbered(tools, int(number)) for number in np.unique(self.numbers)}

    def tool(self, row: int) -> Tool | None:
        """Return the tool of a row, or None where it is not known."""
        return self.tools[int(self.numbers[row])]

    def cutter(self, row: int) -> Cutter | None:
        """Return the cutter of a row; None where it is not known, and for a beam, which touches nothing."""
        tool = self.tool(row)
        return None if tool is None or tool.shape in BEAM else Cutter(form_of(tool))

    def pieces(self, row: int) -> Segments:
        """Return the row's segments."""
        first, last = np.searchsorted(self.path.row, [row, row + 1])
        return self.path[first:last]

    def contact(self, cutter: Cutter, move: Segments) -> tuple[float, ...] | None:
        """Return the first place where the cutter, on segments of one row, touches stock; None where it does not."""
        return self.remaining.first_contact(cutter, move) if len(move) else None

    def rapids(self) -> Iterator[Finding]:
        """Yield each rapid that touches stock which the moves before it have not cleared."""
        low = self.subject.low_mm < self.stock.top_mm - RUB_MM
        for row in np.flatnonzero(~self.subject.is_feed & low).tolist():
            point = self.touched(row)
            if point is not None:
                yield self.touch(row, point, "rapid-in-stock", "a rapid goes through stock", "lift the tool before it")

    def below(self) -> Iterator[Finding]:
        """Yield the deepest cut that goes through the bottom of the stock; an error where it goes into the table."""
        deep = np.flatnonzero(self.subject.low_mm < self.stock.bottom_mm - PASSED_MM)
        rows = [row for row in deep.tolist() if self._over_stock(row)]
        if rows:
            lowest_mm = float(self.subject.low_mm[rows].min())
            yield self.subject.finding(
                rows[int(np.argmin(self.subject.low_mm[rows]))],
                "error" if lowest_mm < self.stock.bottom_mm - SPOIL_MM else "warning",
                "below-stock",
                "the tool goes below the stock and cuts the table under it",
                advice="check the depth, or lay a spoil board under the stock",
                value=lowest_mm,
                limit=self.stock.bottom_mm,
                unit="mm",
                count=len(rows),
                group="",
                rank=-lowest_mm,
                at_first=False,
            )

    def _over_stock(self, row: int) -> bool:
        cutter = self.cutter(row)
        deep = clipped_below(self.pieces(row), self.stock.bottom_mm - PASSED_MM)
        if cutter is None:
            return False
        beside = shapely.distance(shapely.linestrings(flat_edges(deep)), self.stock.outline)
        return bool((beside < cutter.radius_mm).any())

    def touched(self, row: int) -> tuple[float, ...] | None:
        """Return the first place where the cutter of a row touches stock; None where it does not."""
        cutter = self.cutter(row)
        return None if cutter is None else self.contact(cutter, self.pieces(row))

    def touch(self, row: int, point: tuple[float, ...], code: str, text: str, advice: str) -> Finding:
        """Return the finding of a row that touches stock at a place."""
        return self.subject.finding(
            row, "error", code, text, advice=advice, place_mm=point, value=point[2], limit=self.stock.top_mm, unit="mm"
        )


class StillSpindle:
    """Finds the first cut into stock of each stretch of the program without a turning spindle."""

    def __init__(self) -> None:
        self._still = False  # on the last row before
        self._reported = False  # a cut in the stretch of that row

    def __call__(self, checks: StockChecks) -> Iterator[Finding]:
        """Yield the findings in the next part of the program."""
        subject, still = checks.subject, ~checks.subject.spindle_on
        if not len(still):
            return
        stretch = np.cumsum(np.append(still[0] != self._still, still[1:] != still[:-1]))
        reported = {0} if self._reported else set()
        low = subject.low_mm < checks.stock.top_mm - RUB_MM
        for row in np.flatnonzero(still & subject.is_feed & low).tolist():
            point = None if int(stretch[row]) in reported else checks.touched(row)
            if point is not None:
                reported.add(int(stretch[row]))
                advice = "start the spindle with M3 and S before it"
                yield checks.touch(row, point, "spindle-off", "a cut goes into stock while the spindle is off", advice)
        self._still, self._reported = bool(still[-1]), int(stretch[-1]) in reported


def verdict(
    subject: CheckContext, judgement: Judgement, line: LineOf | None = None, process: Process = MILLING
) -> Iterator[Finding]:
    """Yield the deepest gouge and the thickest material left where they exceed the removals' tolerances.

    line: gives the file's line of a row that was judged; those of `subject` where left out.
    """
    at = partial(_excess, subject, line or subject.line)
    text, advice = "the tool cuts into the wanted part", "correct the path, the tool's diameter or the depth"
    if process.is_thermal:
        text, advice = "the kerf goes beyond the drawing", "correct the path, the lead-in or the kerf"
    yield from at(judgement.gouge, judgement.gouge_tolerance_mm, "gouge", text, advice)
    for left in judgement.removals:
        islands = f", {len(left.islands)} island(s)" if left.islands else ""
        yield from at(
            left.worst,
            left.tolerance_mm,
            "left-over",
            Text("material is left where it should be removed{islands}", islands=islands),
            "add the missing pass, or lower the stepover or the stepdown",
        )


def _excess(
    subject: CheckContext, line: LineOf, worst: Worst, tolerance_mm: float, code: str, text: str, advice: str
) -> Iterator[Finding]:
    if worst.depth_mm > tolerance_mm + JUDGE_ERROR_MM:
        numbers = {"value": worst.depth_mm, "limit": tolerance_mm, "unit": "mm"}
        place = {"place_mm": worst.place_mm}
        yield subject.finding_at(line(worst.row), "error", code, text, advice=advice, **place, **numbers)
