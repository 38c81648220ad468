# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Thread: threads milled in holes or round bosses."""

from __future__ import annotations

from CNCStepper.workbench.features.base import DISTANCE, ENUMERATION, INTEGER, Property
from CNCStepper.workbench.features.common import CUT, DEPTH, DIRECTION, RESULT
from CNCStepper.workbench.features.operation import OPERATION
from CNCStepper.workbench.features.places import HOLES, ORDER, PATTERN, Places
from CNCStepper.workbench.services.translation import later


class Thread(Places):
    """The proxy of thread milling."""

    Type = "CNCStepper_Thread"
    CYCLE = "thread"
    PROPERTIES = (
        *OPERATION,
        *PATTERN,
        Property("side", "Side", ENUMERATION, CUT, later("Side"), later("In holes, or round bosses"), "inside",
                 choices=("inside", "outside")),
        Property("hand", "Hand", ENUMERATION, CUT, later("Hand"), later("How the thread winds"), "right",
                 choices=("right", "left")),
        Property("major_diameter_mm", "MajorDiameter", DISTANCE, CUT, later("Major"),
                 later("The nominal diameter; 0: that of each circle of the drawing"), 10.0),
        Property("minor_diameter_mm", "MinorDiameter", DISTANCE, CUT, later("Minor"),
                 later("The diameter at the other end of the flanks; 0: that of a metric thread"), 0.0),
        Property("pitch_mm", "Pitch", DISTANCE, CUT, later("Pitch"), later("From one turn of the thread to the next"),
                 1.5),
        DEPTH,
        Property("passes", "RadialPasses", INTEGER, CUT, later("Passes"), later("In how many steps outwards"), 1),
        DIRECTION,
        ORDER,
        HOLES,
        Property("turns", "Turns", INTEGER, RESULT, later("Turns"), later("How many turns the thread has"), 0,
                 output=True),
        Property("minor_mm", "MinorUsed", DISTANCE, RESULT, later("Minor"), later("The minor diameter that is cut"),
                 0.0, output=True),
    )  # fmt: skip
