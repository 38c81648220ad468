# SPDX-License-Identifier: LGPL-2.1-or-later
"""The values of a job that its cut chart gives, and that a person may type otherwise: 0 is the chart's.

    key in a row of the chart (`machine/cut_data.py`)  =  key of the property

An object has all of them; `document/cut_chart_of_job.py` says which its process and its machine have.
"""

from __future__ import annotations

from CNCStepper.workbench.features.base import DISTANCE, FLOAT, SPEED, Property
from CNCStepper.workbench.services.translation import later

CHART = later("Cut chart")
HEIGHT_KEYS = ("clearance_mm", "retract_mm")  # of a job whose machine has a Z
CUT_VALUES = (
    Property("feed_mm_min", "CutFeed", SPEED, CHART, later("Feed"), later("The speed of the cut; 0: that of the chart"),
             0.0),
    Property("kerf_mm", "Kerf", DISTANCE, CHART, later("Kerf"), later("The width of the cut; 0: that of the chart"),
             0.0),
    Property("pierce_height_mm", "PierceHeight", DISTANCE, CHART, later("Pierce height"),
             later("The torch above the sheet while it pierces; 0: that of the chart"), 0.0),
    Property("pierce_delay_s", "PierceDelay", FLOAT, CHART, later("Pierce delay"),
             later("Power on before the tool moves; 0: that of the chart"), 0.0),
    Property("preheat_s", "Preheat", FLOAT, CHART, later("Preheat"),
             later("How long the flame heats before the pierce; 0: that of the chart"), 0.0),
    Property("cut_height_mm", "CutHeight", DISTANCE, CHART, later("Cut height"),
             later("The torch above the sheet while it cuts; 0: that of the chart"), 0.0),
    Property("amperes", "Amperes", FLOAT, CHART, later("Current"),
             later("The current set at the power source; 0: from the chart"), 0.0),
    Property("power_percent", "Power", FLOAT, CHART, later("Power"),
             later("A share of the machine's greatest power; 0: that of the chart"), 0.0),
)  # fmt: skip
CUT_KEYS = tuple(entry.key for entry in CUT_VALUES)  # as a row of a cut chart has them
