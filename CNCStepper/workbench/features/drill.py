# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Drill: holes by the canned cycles, at the circles and points of a drawing or in a pattern."""

from __future__ import annotations

from CNCStepper.workbench.features.base import DISTANCE, ENUMERATION, FLOAT, Property
from CNCStepper.workbench.features.common import CUT, DEPTH, PATH
from CNCStepper.workbench.features.operation import OPERATION
from CNCStepper.workbench.features.places import HOLES, ORDER, PATTERN, THROUGH, Places
from CNCStepper.workbench.services.translation import later


class Drill(Places):
    """The proxy of drilling."""

    Type = "CNCStepper_Drill"
    CYCLE = "drill"
    PROPERTIES = (
        *OPERATION,
        *PATTERN,
        DEPTH,
        Property("tip", "DepthOf", ENUMERATION, CUT, later("Depth to"),
                 later("Whether the depth is that of the point or of the full diameter"), "tip",
                 choices=("tip", "diameter")),
        THROUGH,
        Property("style", "Style", ENUMERATION, CUT, later("Cycle"), later("How the drill goes down"), "G81",
                 choices=("G81", "G82", "G83", "G73")),
        Property("peck_mm", "Peck", DISTANCE, CUT, later("Peck"), later("How deep one peck goes"), 2.0,
                 only=("style", ("G83", "G73"))),
        Property("dwell_s", "Dwell", FLOAT, CUT, later("Pause"), later("Seconds at the bottom"), 0.5,
                 only=("style", ("G82",))),
        Property("retract", "RetractTo", ENUMERATION, PATH, later("Retract to"),
                 later("The height of the rapids between holes: G98 or G99"), "clearance",
                 choices=("clearance", "retract")),
        ORDER,
        HOLES,
    )  # fmt: skip
