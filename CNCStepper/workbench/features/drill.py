# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Drill: holes by the canned cycles, at the circles and points of a drawing or in a pattern."""

from __future__ import annotations

from CNCStepper.cycles.holes.hole_parameters import DrillParameters
from CNCStepper.workbench.features.cycle_operation import OPERATION
from CNCStepper.workbench.features.parameters import properties_of
from CNCStepper.workbench.features.places import HOLES, PATTERN, Places


class Drill(Places):
    """The proxy of drilling."""

    Type = "CNCStepper_Drill"
    CYCLE = "drill"
    PROPERTIES = (*OPERATION, *PATTERN, *properties_of(DrillParameters), HOLES)
