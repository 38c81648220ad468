# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Bore: holes wider than the tool, cut along helices."""

from __future__ import annotations

from CNCStepper.cycles.holes.hole_parameters import BoreParameters
from CNCStepper.workbench.features.cycle_operation import OPERATION
from CNCStepper.workbench.features.parameters import PASSES, properties_of
from CNCStepper.workbench.features.places import HOLES, PATTERN, Places


class Bore(Places):
    """The proxy of helical boring."""

    Type = "CNCStepper_Bore"
    CYCLE = "bore"
    PROPERTIES = (
        *OPERATION,
        *PATTERN,
        *properties_of(BoreParameters),
        HOLES,
        *(entry for entry in PASSES if entry.key != "levels"),
    )
