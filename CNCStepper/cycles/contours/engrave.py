# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engraving: the tool's centre runs along curves at a depth (part C's freehand lines, and any drawing's)."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field, StrictBool
from shapely import LineString

from CNCStepper.cycles.contours.contour_parameters import EngraveParameters
from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.moves import Moves, point_of, require_setup
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.passes import deep_pass_warnings, require_few_blocks, whole_passes
from CNCStepper.errors import CycleError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.cut_order.cut_order import Stop, Visit, ordered, spread
from CNCStepper.geometry.fitting.point_fit import refitted
from CNCStepper.geometry.fitting.simplify import simplified
from CNCStepper.quantities import MOST_ITEMS
from CNCStepper.tolerances import COINCIDENT_MM
from CNCStepper.toolpath import TableBuilder

FLAT_MM = 0.0005


class Engrave(EngraveParameters, BaseModel):
    """An engraving that can be cut."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    curves: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["curves"])
    closed: StrictBool = False

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the engraving to `table`; raises CycleError before any row when it cannot be cut."""
        require_setup(setup)
        steps = whole_passes(self.depth_mm, self.stepdown_mm or self.depth_mm, 0.0, "stepdown_mm")
        curves = self._in_order([self._prepared(curve) for curve in self.curves], len(steps))
        require_few_blocks(len(steps) * sum(map(len, curves)))
        floors = [-self.depth_mm * (n + 1) / len(steps) for n in range(len(steps))]
        moves = Moves(table, setup)
        for number, curve in enumerate(curves, start=1):
            table.open_span("contour", f"line {number}")
            self._line(moves, curve, floors, setup.tool.feed_mm_min)
            table.close_span()
        promise_mm = self.tolerance_mm + self.simplify_mm
        removals = [Removal(LineString(curve.points(FLAT_MM)), 0.0, -self.depth_mm, promise_mm) for curve in curves]
        length_mm = sum(curve.length_mm for curve in curves)
        figures = {"ap_mm": steps[0], "levels": len(steps), "lines": len(curves), "length_mm": length_mm}
        return Answer(removals, figures, deep_pass_warnings(max(steps), setup.tool))

    def _prepared(self, curve: Curve) -> Curve:
        if self.closed and not curve.closed:
            raise CycleError(
                "curve-open", "the line does not end where it began", advice="close it or set closed = false"
            )
        if not curve.length_mm > COINCIDENT_MM:
            raise CycleError("curve-length", "the line has no length", value="0 mm", advice="draw at least two points")
        return (_fewest(curve, self.simplify_mm) if self.simplify_mm else curve).moved(*self.offset_mm)

    def _in_order(self, curves: list[Curve], levels: int) -> list[Curve]:
        if self.order == "drawn":
            return curves
        visits = ordered([_stop(curve, levels) for curve in curves])
        return [_begun(curves[visit.item], visit) for visit in visits]

    def _line(self, moves: Moves, curve: Curve, floors_mm: list[float], feed_mm_min: float) -> None:
        """Cut one curve at every depth: an open one to and fro, a closed one round and round."""
        moves.approach(point_of(curve.xy[0]))
        for floor_mm in floors_mm:
            moves.plunge(floor_mm)
            moves.follow(curve, feed_mm_min)
            if not curve.closed:
                curve = curve.reversed()
        moves.retract()


def _fewest(curve: Curve, tolerance_mm: float) -> Curve:
    """Return the curve as lines, or as lines and arcs where these are fewer."""
    lines, fitted = simplified(curve, tolerance_mm), refitted(curve, tolerance_mm)
    return fitted if len(fitted) < len(lines) else lines


def _stop(curve: Curve, levels: int) -> Stop:
    """Return where a line may begin and then ends: an open one, cut an even number of times, where it began."""
    if curve.closed or levels % 2:
        return Stop.of_curve(curve, turns=True)
    ends = curve.xy[[0, -1]]
    return Stop(ends, ends, False)


def _begun(curve: Curve, visit: Visit) -> Curve:
    if curve.closed:
        return curve.started_at(spread(len(curve))[visit.start])
    return curve.reversed() if visit.turned or visit.start else curve
