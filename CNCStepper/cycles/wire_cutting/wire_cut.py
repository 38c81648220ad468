# SPDX-License-Identifier: LGPL-2.1-or-later
"""Wire cutting: a hot wire comes in from the sheet's edge, cuts all parts in one continuous way and goes out again.

wire_items     drawn curves ---> rings half a kerf off the parts, lines; refusals    cycles/wire_cutting/
scrap_roadmap  shortest ways through the scrap, clear of all parts
route_tree     those ways as a tree, and its leaves with the farther ones first
wire_cut_order which item is last, and no part comes loose before it is cut
hole_slits     through the part into its holes
wire_route     all of these put together: one way
wire_run       rows of the table: power, moves, slow feeds and dwells at corners
"""

from __future__ import annotations

import shapely
from pydantic import BaseModel, ConfigDict, Field, StrictBool
from shapely import Polygon
from shapely.geometry.base import BaseGeometry

from CNCStepper.cycles.contours.disc_swept_area import swept
from CNCStepper.cycles.contours.scrap_side import as_cycle_error
from CNCStepper.cycles.cycle import Answer, Removal, Setup
from CNCStepper.cycles.moves import require_feed
from CNCStepper.cycles.parameter_types import CurveField
from CNCStepper.cycles.passes import require_few_blocks
from CNCStepper.cycles.wire_cutting.inner_corners import rest_corners, rest_warnings
from CNCStepper.cycles.wire_cutting.wire_items import Items, items_of
from CNCStepper.cycles.wire_cutting.wire_parameters import WireParameters
from CNCStepper.cycles.wire_cutting.wire_route import Route, RouteMaker, Stroke
from CNCStepper.cycles.wire_cutting.wire_run import Corners, WireRun
from CNCStepper.errors import CycleError, GeometryError, Text
from CNCStepper.quantities import MOST_ITEMS
from CNCStepper.toolpath import TableBuilder

FLAT_MM = 0.0005
SMALLER = (0.75, 0.5, 0.25, 0.1)  # of the margin: tried to tell with which one a way would be found
UNKNOWN_DEPTH_MM = 1.0  # of a sheet whose thickness the job does not know


class WireCut(WireParameters, BaseModel):
    """A cut with a hot wire."""

    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, arbitrary_types_allowed=True)

    curves: tuple[CurveField, ...] = Field(min_length=1, max_length=MOST_ITEMS["curves"])
    entry_slit: StrictBool = False

    def cut(self, setup: Setup, table: TableBuilder) -> Answer:
        """Append the way to `table`; raises CycleError before any row when the parts cannot be cut so."""
        self._require(setup)
        kerf_mm = self.kerf_of(setup)
        curves = [curve.moved(*self.offset_mm) for curve in self.curves]
        try:
            sheet = _sheet_of(setup)
            items = items_of(curves, kerf_mm, self.entry_slit, sheet)
            route = self._route(items, sheet or _around(items, kerf_mm + self.margin_mm), kerf_mm)
            band = _band(route, kerf_mm)
            corners = rest_corners(items, kerf_mm)
        except GeometryError as error:
            raise as_cycle_error(error) from error
        require_few_blocks(sum(len(stroke.curve) for stroke in route.strokes))
        run = WireRun(table, setup, sheet)
        figures = run.run(route, kerf_mm, self._corners)
        band = shapely.union_all([band, swept(run.before, kerf_mm / 2.0)])
        band = band if sheet is None else band.intersection(sheet)
        removal = Removal(band, 0.0, -(setup.thickness_mm or UNKNOWN_DEPTH_MM), self.tolerance_mm)
        figures |= {"kerf_mm": kerf_mm, "parts": len(route.parts), "lines": len(items.lines)}
        return Answer([removal], figures, run.warnings + rest_warnings(corners), corners, list(route.parts))

    def kerf_of(self, setup: Setup) -> float:
        """Return the width of the cut: its own, else the tool's diameter, which is the chart's kerf at its feed."""
        return self.kerf_mm or setup.tool.diameter_mm

    @property
    def _corners(self) -> Corners:
        return Corners(self.corner_dwell_s, self.corner_angle_deg, self.corner_distance_mm, self.corner_feed_share)

    def _require(self, setup: Setup) -> None:
        """Raise CycleError for another tool than a wire, one without a feed, and too long a stand at corners."""
        require_feed(setup.tool, "feed_mm_min")
        if setup.tool.shape != "wire":
            raise CycleError(
                "tool-shape", Text("a {shape} does not cut from the edge", shape=setup.tool.shape), advice="use a wire"
            )
        stand_s = setup.process.stand_s
        if self.corner_dwell_s > stand_s:
            raise CycleError(
                "wire-dwell",
                "the wire would stay too long at corners and melt a hole",
                value=f"{self.corner_dwell_s:g} s",
                limit=f"{setup.process.stand_s:g} s",
                advice=Text(
                    "set corner_dwell_s to at most {stand_s:g}, or cut more slowly", stand_s=setup.process.stand_s
                ),
            )

    def _route(self, items: Items, sheet: Polygon, kerf_mm: float) -> Route:
        """Return the way; raises CycleError that tells a margin that would do where no way is found with this one."""
        try:
            return RouteMaker(items, sheet, kerf_mm, self.margin_mm).route(self.enter_from, self.leave)
        except CycleError as error:
            if error.code != "wire-way":
                raise
            margin_mm = self._smaller_margin(items, sheet, kerf_mm)
            if margin_mm is None:
                raise
            raise CycleError(
                error.code,
                error.what,
                value=error.value,
                limit=Text("a margin of {margin_mm:.3g} mm", margin_mm=margin_mm),
                advice=Text("set margin_mm to at most {margin_mm:.3g}, or move the parts apart", margin_mm=margin_mm),
            ) from error

    def _smaller_margin(self, items: Items, sheet: Polygon, kerf_mm: float) -> float | None:
        for share in SMALLER:
            try:
                RouteMaker(items, sheet, kerf_mm, share * self.margin_mm).route(self.enter_from, self.leave)
            except CycleError:
                continue
            return share * self.margin_mm
        return None


def _sheet_of(setup: Setup) -> Polygon | None:
    return None if setup.stock is None else Polygon(setup.stock.points(FLAT_MM))


def _around(items: Items, far_mm: float) -> Polygon:
    """Return a sheet round all that is cut, for a setup that does not know its stock."""
    lines = [item.chords for item in items.every]
    return shapely.box(*shapely.union_all(lines).buffer(far_mm).bounds)


def _band(route: Route, kerf_mm: float) -> BaseGeometry:
    """Return what the wire sweeps; what it runs along twice counts once."""
    bands: dict[bytes, BaseGeometry] = {}
    for stroke in route.strokes:
        if _key(stroke) not in bands:
            bands[_key(stroke)] = swept([stroke.curve], kerf_mm / 2.0)
    return shapely.union_all(list(bands.values()))


def _key(stroke: Stroke) -> bytes:
    """Return the same for a stroke and for its way back."""
    there = stroke.curve.xy.round(9).tobytes() + stroke.curve.bulge.tobytes()
    back = stroke.curve.reversed()
    return min(there, back.xy.round(9).tobytes() + back.bulge.tobytes())
