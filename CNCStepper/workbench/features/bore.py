# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Bore: holes wider than the tool, cut along helices."""

from __future__ import annotations

from CNCStepper.workbench.features.base import DISTANCE, Property
from CNCStepper.workbench.features.common import CUT, DEPTH, DIRECTION, FINISH, FINISH_FEED, PASSES
from CNCStepper.workbench.features.operation import OPERATION
from CNCStepper.workbench.features.places import HOLES, ORDER, PATTERN, THROUGH, Places
from CNCStepper.workbench.services.translation import later


class Bore(Places):
    """The proxy of helical boring."""

    Type = "CNCStepper_Bore"
    CYCLE = "bore"
    PROPERTIES = (
        *OPERATION,
        *PATTERN,
        Property("diameter_mm", "Diameter", DISTANCE, CUT, later("Diameter"),
                 later("Of the bores; 0: that of each circle of the drawing"), 12.0),
        DEPTH,
        THROUGH,
        Property("pitch_mm", "Pitch", DISTANCE, CUT, later("Pitch"), later("How far one turn of the helix falls"), 1.0),
        Property("stepover_mm", "Stepover", DISTANCE, CUT, later("Stepover ae"),
                 later("Between neighbouring helices at most; 0: 0.4 of the tool's diameter"), 0.0),
        DIRECTION,
        Property("finish_stepover_mm", "FinishStepover", DISTANCE, FINISH, later("Last stepover"),
                 later("The last pass at the wall, ae_acab; 0: none"), 0.0),
        FINISH_FEED,
        ORDER,
        HOLES,
        *(entry for entry in PASSES if entry.key != "levels"),
    )  # fmt: skip
