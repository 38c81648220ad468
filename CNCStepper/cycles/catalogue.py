# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cycles by the names that job files use."""

from __future__ import annotations

from pydantic import BaseModel

from CNCStepper.cycles.contours.contour import Contour
from CNCStepper.cycles.contours.engrave import Engrave
from CNCStepper.cycles.facing.face import Face
from CNCStepper.cycles.holes.bore import Bore
from CNCStepper.cycles.holes.drill import Drill
from CNCStepper.cycles.holes.thread_milling import Thread
from CNCStepper.cycles.pockets.circular_pocket import CircularPocket
from CNCStepper.cycles.pockets.elliptical_pocket import EllipticalPocket
from CNCStepper.cycles.pockets.pocket import Pocket
from CNCStepper.cycles.pockets.rectangular_pocket import RectangularPocket
from CNCStepper.cycles.sheet_cutting.sheet_cut import SheetCut
from CNCStepper.cycles.wire_cutting.wire_cut import WireCut
from CNCStepper.errors import JobError, Text
from CNCStepper.quantities import shown

CYCLES: dict[str, type[BaseModel]] = {
    "bore": Bore,
    "circular_pocket": CircularPocket,
    "contour": Contour,
    "drill": Drill,
    "elliptical_pocket": EllipticalPocket,
    "engrave": Engrave,
    "face": Face,
    "pocket": Pocket,
    "rectangular_pocket": RectangularPocket,
    "sheet_cut": SheetCut,
    "thread": Thread,
    "wire_cut": WireCut,
}


def cycle_class(name: object) -> type[BaseModel]:
    """Return the parameter model of a cycle; raises JobError for a name that is none."""
    if not isinstance(name, str) or name not in CYCLES:
        told = name if isinstance(name, str) else shown(name)
        raise JobError(
            "cycle-unknown",
            Text("there is no cycle '{told}'", told=told[:60]),
            advice=Text("use one of: {cycles}", cycles=", ".join(sorted(CYCLES))),
        )
    return CYCLES[name]
