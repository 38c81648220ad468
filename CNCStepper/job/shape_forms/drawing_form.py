# SPDX-License-Identifier: LGPL-2.1-or-later
"""`[[shape]] drawing = { ... }`: chains of a drawing, selected by their attributes, which follow the file."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

from pydantic import Field, StrictBool

from CNCStepper.drawing.crossing_areas import without_crossings
from CNCStepper.drawing.drawing import Chain
from CNCStepper.drawing.nesting_levels import nesting_levels
from CNCStepper.drawing.read_drawing import ReadOptions
from CNCStepper.drawing.repair.problems import RepairLimits
from CNCStepper.drawing.selection import Selection
from CNCStepper.drawing.trace.options import TraceOptions
from CNCStepper.geometry.chain_joining import NEAR_MM
from CNCStepper.geometry.curve import Curve
from CNCStepper.quantities import Angle, Bounds, Coordinate, Unit

MOST_EXCEPTIONS = 200


class DrawingForm(Selection):
    """Chains of a drawing of any format: those that the keys of `Selection` take and none of `without` does.

    nesting: only closed chains that lie in so many others of them; of those that cross, the boundaries of the area
    inside an odd number of them. The drawing is turned about its zero and then
    moved. mend: repairs it first, within these limits; unit_mm as for DXF; trace: how a picture
    becomes contours; height_mm: of a solid, the height of its faces or section, else its outline from above.
    """

    file: str = Field(min_length=1)
    without: tuple[Selection, ...] = Field(default=(), max_length=MOST_EXCEPTIONS)
    nesting: Annotated[int, Bounds("number", 0, 100)] | None = None
    offset_mm: tuple[Coordinate, Coordinate] = (0.0, 0.0)
    rotation_deg: Angle = 0.0
    tolerance_mm: Annotated[float, Bounds("tolerance", most=1.0)] = 0.005
    unit_mm: Unit | None = None
    by_colour: StrictBool = True
    mend: RepairLimits | None = None
    trace: TraceOptions = TraceOptions()
    height_mm: Coordinate | None = None

    def options(self) -> ReadOptions:
        """Return how the drawing is read."""
        near_mm = max(NEAR_MM, self.mend.close_mm) if self.mend else NEAR_MM
        return ReadOptions(
            self.tolerance_mm,
            self.unit_mm,
            near_mm=near_mm,
            by_colour=self.by_colour,
            height_mm=self.height_mm,
            trace=self.trace,
        )

    def selected(self, chains: Sequence[Chain]) -> tuple[Chain, ...]:
        """Return the chains that it means, before they are turned and moved."""
        taken = [chain for chain in self.of(chains) if not any(each.takes(chain) for each in self.without)]
        if self.nesting is None:
            return tuple(taken)
        closed = without_crossings([chain for chain in taken if chain.curve.closed])
        levels = nesting_levels([chain.curve for chain in closed]).tolist()
        return tuple(chain for chain, level in zip(closed, levels, strict=True) if level == self.nesting)

    def placed(self, curve: Curve) -> Curve:
        """Return a curve of the drawing at its place."""
        return (curve.rotated(self.rotation_deg) if self.rotation_deg else curve).moved(*self.offset_mm)
