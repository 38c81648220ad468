# SPDX-License-Identifier: LGPL-2.1-or-later
"""The operations by the cycles that they stand for, in the order of the toolbar."""

from __future__ import annotations

from CNCStepper.errors import JobError, Text
from CNCStepper.workbench.features.bore import Bore
from CNCStepper.workbench.features.circular_pocket import CircularPocket
from CNCStepper.workbench.features.contour import Contour
from CNCStepper.workbench.features.cycle_operation import CycleOperation
from CNCStepper.workbench.features.drill import Drill
from CNCStepper.workbench.features.elliptical_pocket import EllipticalPocket
from CNCStepper.workbench.features.engrave import Engrave
from CNCStepper.workbench.features.face import Face
from CNCStepper.workbench.features.operation import Operation
from CNCStepper.workbench.features.pocket import Pocket
from CNCStepper.workbench.features.rectangular_pocket import RectangularPocket
from CNCStepper.workbench.features.sheet_cut import SheetCut
from CNCStepper.workbench.features.thread import Thread
from CNCStepper.workbench.features.turning.turning_operation import TURNING_OPERATIONS
from CNCStepper.workbench.features.wire_cut import WireCut

KINDS: tuple[type[Operation], ...] = (
    Face,
    Pocket,
    RectangularPocket,
    CircularPocket,
    EllipticalPocket,
    Contour,
    Drill,
    Bore,
    Thread,
    Engrave,
    SheetCut,
    WireCut,
)
OPERATIONS = {kind.CYCLE: kind for kind in KINDS}


def operation_class(cycle: str) -> type[CycleOperation]:
    """Return the document object's class for a cycle, a lathe's too; raises JobError for an unknown name."""
    every: dict[str, type[CycleOperation]] = {**OPERATIONS, **TURNING_OPERATIONS}
    if cycle not in every:
        raise JobError(
            "cycle-unknown",
            Text("there is no cycle '{cycle}'", cycle=cycle),
            advice=Text("use one of: {operations}", operations=", ".join(sorted(every))),
        )
    return every[cycle]
