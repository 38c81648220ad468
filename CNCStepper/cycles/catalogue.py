# SPDX-License-Identifier: LGPL-2.1-or-later
"""The cycles by the names that job files use; a cycle is loaded when it is first asked for.

Loading all of them takes longer than most of them need to make a program.
"""

from __future__ import annotations

import importlib

from pydantic import BaseModel

from CNCStepper.errors import JobError, Text
from CNCStepper.quantities import shown

CYCLES = {  # the class of each, in a module of this package
    "bore": "holes.bore.Bore",
    "circular_pocket": "pockets.circular_pocket.CircularPocket",
    "contour": "contours.contour.Contour",
    "drill": "holes.drill.Drill",
    "elliptical_pocket": "pockets.elliptical_pocket.EllipticalPocket",
    "engrave": "contours.engrave.Engrave",
    "face": "facing.face.Face",
    "pocket": "pockets.pocket.Pocket",
    "rectangular_pocket": "pockets.rectangular_pocket.RectangularPocket",
    "sheet_cut": "sheet_cutting.sheet_cut.SheetCut",
    "thread": "holes.thread_milling.Thread",
    "wire_cut": "wire_cutting.wire_cut.WireCut",
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
    module, _, class_name = CYCLES[name].rpartition(".")
    found: type[BaseModel] = getattr(importlib.import_module(f"CNCStepper.cycles.{module}"), class_name)
    return found
