# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Thread: threads milled in holes or round bosses."""

from __future__ import annotations

from CNCStepper.cycles.holes.hole_parameters import ThreadParameters
from CNCStepper.workbench.features.base import DISTANCE, INTEGER, Property
from CNCStepper.workbench.features.cycle_operation import OPERATION
from CNCStepper.workbench.features.parameters import RESULT, properties_of
from CNCStepper.workbench.features.places import HOLES, PATTERN, Places
from CNCStepper.workbench.services.translation import later


class Thread(Places):
    """The proxy of thread milling."""

    Type = "CNCStepper_Thread"
    CYCLE = "thread"
    PROPERTIES = (
        *OPERATION,
        *PATTERN,
        *properties_of(ThreadParameters),
        HOLES,
        Property("turns", "Turns", INTEGER, RESULT, later("Turns"), later("How many turns the thread has"), 0,
                 output=True),
        Property("minor_mm", "MinorUsed", DISTANCE, RESULT, later("Minor"), later("The minor diameter that is cut"),
                 0.0, output=True),
    )  # fmt: skip
