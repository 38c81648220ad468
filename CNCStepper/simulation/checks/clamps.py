# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the tool must keep clear of: clamps with their height, and the rim of the sheet."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from CNCStepper.errors import JobError, Text
from CNCStepper.machine.tools.tool import Tool
from CNCStepper.machine.tools.tool_profile import Form, form_of
from CNCStepper.simulation.check_context import CheckContext
from CNCStepper.simulation.cutter_solid import BEAM, POINT, Cutter, Tools, tool_numbered
from CNCStepper.simulation.exact.beams import beam_cuts, through
from CNCStepper.simulation.exact.edge_tree import flat_edges
from CNCStepper.simulation.finding import Finding
from CNCStepper.simulation.stock import Stock
from CNCStepper.simulation.tip_segments import Segments, clipped_below, segments, split_ramps
from CNCStepper.tolerances import TOUCHING_MM

FLATTEN_MM = 0.0005
RAMP_STEP_MM = 0.02  # a ramp counts with the lower end of parts of this height


@dataclass(frozen=True)
class Clamp:
    """A clamp, vice or screw: its corners seen from above, two for a rectangle, and the height of its top.

    Both in work coordinates. Raises JobError for corners that enclose nothing.
    """

    corners_mm: tuple[tuple[float, float], ...]
    top_mm: float

    def __post_init__(self) -> None:
        if len(self.corners_mm) < 2 or not (self.outline.is_valid and self.outline.area > 0):
            raise JobError(
                "clamp",
                "the corners of a clamp enclose nothing",
                value=str(self.corners_mm),
                advice="give two opposite corners of a rectangle, or three and more of a polygon in their order",
            )

    @property
    def outline(self) -> shapely.Polygon:
        """The clamp seen from above."""
        if len(self.corners_mm) == 2:
            return shapely.box(*np.min(self.corners_mm, axis=0), *np.max(self.corners_mm, axis=0))
        return shapely.Polygon(self.corners_mm)


@dataclass(frozen=True)
class _Body:
    """A part of a tool that must not touch: the cutter itself, or the holder `lift_mm` above its tip."""

    name: str
    cutter: Cutter
    lift_mm: float


def clamps(subject: CheckContext, tools: Tools | None, keep_out: Sequence[Clamp]) -> Iterator[Finding]:
    """Yield for each clamp the first move on which the tool or its holder touches it; rapids count too.

    A tool that is not known counts as its axis alone.
    """
    for part in _by_tool(subject) if keep_out else ():
        for body in _bodies(tool_numbered(tools, part[0])):
            for number, clamp in enumerate(keep_out, start=1):
                group = f"{part[0]}-{body.name}-{number}"
                yield from _touched(subject, part[1], body, clamp, number, group)


def sheet_edge(subject: CheckContext, tools: Tools, stock: Stock, edge_mm: float) -> Iterator[Finding]:
    """Yield the cut that comes nearest to the sheet's edge, where it comes nearer than `edge_mm`."""
    rim = stock.outline.boundary
    for number, tool, pieces in _cuts(subject, tools, stock):
        lines = shapely.linestrings(flat_edges(pieces))
        away = shapely.distance(lines, rim)
        inside = shapely.contains(stock.outline, lines)
        left = np.where(inside, away, -away) - _widest(Cutter(form_of(tool)), pieces, stock.top_mm)
        left[shapely.disjoint(stock.outline, lines) & (away > tool.radius_mm)] = np.inf  # in the air beside it
        rows = np.unique(pieces.row[left < edge_mm - TOUCHING_MM])
        if len(rows):
            k = int(left.argmin())
            yield subject.finding(
                int(pieces.row[k]),
                "error",
                "sheet-edge",
                "the cut is too close to the sheet's edge",
                advice="move the shape inwards, or take a larger sheet",
                place_mm=tuple(pieces.end[k].tolist()),
                value=float(left[k]),
                limit=edge_mm,
                unit="mm",
                count=len(rows),
                group=str(number),
                rank=-float(left[k]),
                at_first=False,
            )


def _cuts(subject: CheckContext, tools: Tools, stock: Stock) -> Iterator[tuple[int, Tool, Segments]]:
    """Yield each known tool's number, the tool and its feeds below the stock's top; a beam's are those with it on."""
    cut_by_beam = beam_cuts(subject.toolpath, tools)
    for number, path in _by_tool(subject, known=False):
        tool = tool_numbered(tools, number)
        if tool is not None and tool.shape in BEAM:
            pieces = through(path[cut_by_beam[path.row]], stock.bottom_mm).known()
        else:
            pieces = clipped_below(path[subject.is_feed[path.row]].known(), stock.top_mm - TOUCHING_MM)
        if tool is not None and len(pieces):
            yield number, tool, pieces


def _by_tool(subject: CheckContext, known: bool = True) -> list[tuple[int, Segments]]:
    """Return the path of each tool number, whole or its known part."""
    path = segments(subject.toolpath, FLATTEN_MM)
    path = path.known() if known else path
    number = subject.tool_numbers[path.row]
    return [(one, path[number == one]) for one in np.unique(number).tolist()]


def _bodies(tool: Tool | None) -> list[_Body]:
    if tool is None:
        return [_Body("the tool", POINT, 0.0)]
    found = [_Body("the tool", Cutter(form_of(tool)), 0.0)]
    if tool.length_mm and tool.holder_diameter_mm:
        radius = tool.holder_diameter_mm / 2
        found.append(_Body("the holder", Cutter(Form(radius, radius)), tool.length_mm))
    return found


def _touched(
    subject: CheckContext, path: Segments, body: _Body, clamp: Clamp, number: int, group: str
) -> Iterator[Finding]:
    low = split_ramps(clipped_below(path, clamp.top_mm - body.lift_mm - TOUCHING_MM), RAMP_STEP_MM)
    if not len(low):
        return
    lines = shapely.linestrings(flat_edges(low))
    into = _widest(body.cutter, low, clamp.top_mm - body.lift_mm) - shapely.distance(lines, clamp.outline)
    inside = shapely.intersects(lines, clamp.outline)
    hits = np.flatnonzero((into > TOUCHING_MM) | inside)
    if len(hits):
        first = hits[low.row[hits] == low.row[hits[0]]]
        worst = int(first[into[first].argmax()])
        near = shapely.get_coordinates(shapely.shortest_line(lines[worst], clamp.outline))[0]
        yield subject.finding(
            int(low.row[worst]),
            "error",
            "clamp",
            Text("{body} goes into clamp {number}", body=body.name, number=number),
            advice="lift the tool over it, move the clamp or move the shape",
            place_mm=(*near.tolist(), float(low.low_mm[worst])),
            value=float(into[worst]),
            limit=0.0,
            unit="mm",
            count=len(np.unique(low.row[hits])),
            group=group,
        )


def _widest(cutter: Cutter, pieces: Segments, top_mm: float) -> np.ndarray:
    """Return the largest radius that the cutter has below `top_mm` on each piece."""
    return cutter.radius_at(np.maximum(top_mm - pieces.low_mm, 0.0))
