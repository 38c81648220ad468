# SPDX-License-Identifier: LGPL-2.1-or-later
"""The properties that several operations have, each under one key, one name and one text."""

from __future__ import annotations

from CNCStepper.workbench.features.base import ANGLE, DISTANCE, ENUMERATION, INTEGER, SPEED, Property
from CNCStepper.workbench.services.translation import later

CUT, FINISH, PATH = later("Cut"), later("Finish"), later("Path")
RESULT = later("In whole passes")

DEPTH = Property(
    "depth_mm", "Depth", DISTANCE, CUT, later("Depth"), later("The depth below the top of the stock"), 10.0
)
STEPDOWN = Property("stepdown_mm", "Stepdown", DISTANCE, CUT, later("Stepdown ap"),
                    later("The depth of one pass at most, ap"), 2.0)  # fmt: skip
STEPOVER = Property("stepover_mm", "Stepover", DISTANCE, CUT, later("Stepover ae"),
                    later("The width of one pass at most, ae"), 2.4)  # fmt: skip
DIRECTION = Property("direction", "Direction", ENUMERATION, CUT, later("Direction"),
                     later("How the cutter turns against the feed"), "climb",
                     choices=("climb", "conventional"))  # fmt: skip
AREA_CUT = (DEPTH, STEPDOWN, STEPOVER, DIRECTION)

PATTERN = Property("pattern", "Pattern", ENUMERATION, CUT, later("Pattern"), later("How the area is cleared"),
                   "offset", choices=("offset", "zigzag", "spiral", "engagement"))  # fmt: skip
PATTERN_VALUES = (
    Property("angle_deg", "Angle", ANGLE, CUT, later("Angle"), later("From X to the lines of the pattern"), 0.0,
             only=("pattern", ("zigzag", "oneway"))),
    Property("engagement_max_deg", "EngagementMax", ANGLE, CUT, later("Engagement"),
             later("How much of the rim may be in the material at most, as an angle"), 60.0,
             only=("pattern", ("engagement",))),
)  # fmt: skip
CLEARING = (PATTERN, *PATTERN_VALUES)

FINISH_STEPDOWN = Property("finish_stepdown_mm", "FinishStepdown", DISTANCE, FINISH, later("Last stepdown"),
                           later("The last pass in depth, ap_acab; 0: none"), 0.2)  # fmt: skip
FINISH_STEPOVER = Property("finish_stepover_mm", "FinishStepover", DISTANCE, FINISH, later("Last stepover"),
                           later("The last pass at the wall, ae_acab; 0: none"), 0.3)  # fmt: skip
FINISH_FEED = Property("finish_feed_mm_min", "FinishFeed", SPEED, FINISH, later("Wall feed"),
                       later("The feed of the last pass at the wall; 0: the tool's own feed"), 0.0)  # fmt: skip
FINISHING = (FINISH_STEPDOWN, FINISH_STEPOVER, FINISH_FEED)
STOCK_TO_LEAVE = Property("stock_to_leave_mm", "StockToLeave", DISTANCE, FINISH, later("Stock to leave"),
                          later("What stays at the wall, for another operation to take"), 0.0)  # fmt: skip

TOLERANCE = Property("tolerance_mm", "Tolerance", DISTANCE, PATH, later("Tolerance"),
                     later("How far the wall may be off the drawing"), 0.01)  # fmt: skip
ENTRY = (
    Property("entry", "Entry", ENUMERATION, PATH, later("Entry"), later("How the tool goes down"), "helix",
             choices=("helix", "ramp", "plunge")),
    Property("entry_angle_deg", "EntryAngle", ANGLE, PATH, later("Entry angle"),
             later("How steeply a helix or ramp goes down"), 3.0, only=("entry", ("helix", "ramp"))),
)  # fmt: skip

LEVELS = (
    Property("ap_mm", "StepdownUsed", DISTANCE, RESULT, later("Stepdown ap"),
             later("ap, recalculated to whole passes"), 0.0, output=True),
    Property("levels", "Levels", INTEGER, RESULT, later("Levels"), later("How many passes in depth"), 0, output=True),
)  # fmt: skip
PASSES = (
    *LEVELS,
    Property("ae_mm", "StepoverUsed", DISTANCE, RESULT, later("Stepover ae"),
             later("ae, recalculated to whole passes"), 0.0, output=True),
    Property("passes", "Passes", INTEGER, RESULT, later("Passes"), later("How many passes at each depth"), 0,
             output=True),
)  # fmt: skip
REST = (
    Property("rest_corners", "RestCorners", INTEGER, RESULT, later("Rest corners"),
             later("How many corners and narrow places the tool does not reach into"), 0, output=True),
    Property("rest_corner_mm", "RestCorner", DISTANCE, RESULT, later("Rest at most"),
             later("The thickest material left in them"), 0.0, output=True),
)  # fmt: skip
ANY_POCKET = (*AREA_CUT, *CLEARING, *FINISHING, STOCK_TO_LEAVE, TOLERANCE, *ENTRY, *PASSES, *REST)
