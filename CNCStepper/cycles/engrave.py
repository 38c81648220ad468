# SPDX-License-Identifier: LGPL-2.1-or-later
"""Engraving: the tool's centre runs along curves at a depth (part C's freehand lines, and any drawing's)."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, PlainSerializer
from shapely import LineString

from CNCStepper.cycles.form import Answer, Coordinate, Removal, Setup
from CNCStepper.cycles.moves import Moves, point_of, require_setup
from CNCStepper.cycles.passes import require_few_blocks, whole_passes
from CNCStepper.errors import CycleError, GeometryError
from CNCStepper.geometry.curve import Curve
from CNCStepper.geometry.simplify import simplified
from CNCStepper.toolpath import TableBuilder

FLAT_MM = 0.0005


def _curve(content: Any) -> Curve:
    if isinstance(content, Curve):
        return content
    try:
        return Curve(content["xy"], content["bulge"])
    except (KeyError, TypeError, GeometryError) as error:
        raise ValueError(f"not a curve with xy and bulge: {error}") from error


CurveField = Annotated[
    Curve,
    BeforeValidator(_curve),
    PlainSerializer(lambda curve: {"xy": curve.xy.tolist(), "bulge": curve.bulge.tolist()}),
]


class Engrave(BaseModel):
    """Parameters of an engraving, named as in a job file; `curves` are in drawing order.

    A curve with `closed` runs back to its first point. simplify_mm: how far the cut line may leave the
    drawn points.
    """

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    cycle: Literal["engrave"] = "engrave"
    tool: int
    curves: tuple[CurveField, ...] = Field(min_length=1)
    offset_mm: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    depth_mm: float = Field(gt=0, le=10_000)
    stepdown_mm: float = Field(default=0.0, ge=0)
    closed: bool = False
    simplify_mm: float = Field(default=0.0, ge=0)
    tolerance_mm: float = Field(default=0.01, gt=0, le=1.0)

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the engraving to `table`; raises CycleError before any row when it cannot be cut."""
        require_setup(setup)
        curves = [self._prepared(curve) for curve in self.curves]
        steps = whole_passes(self.depth_mm, self.stepdown_mm or self.depth_mm, 0.0, "stepdown_mm")
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
        return Answer(removals, figures)

    def _prepared(self, curve: Curve) -> Curve:
        if self.simplify_mm:
            curve = simplified(curve, self.simplify_mm)
        if self.closed and not curve.closed:
            raise CycleError(
                "curve-open", "the line does not end where it began", advice="close it or set closed = false"
            )
        if not curve.length_mm > 0:
            raise CycleError("curve-length", "the line has no length", value="0 mm", advice="draw at least two points")
        return curve.moved(*self.offset_mm)

    def _line(self, moves: Moves, curve: Curve, floors_mm: list[float], feed_mm_min: float) -> None:
        """Cut one curve at every depth: an open one to and fro, a closed one round and round."""
        moves.approach(point_of(curve.xy[0]))
        for floor_mm in floors_mm:
            moves.plunge(floor_mm)
            moves.follow(curve, feed_mm_min)
            if not curve.closed:
                curve = curve.reversed()
        moves.retract()
