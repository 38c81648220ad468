# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Tool: a cutter and what it may do, linked by the operations that use it."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.features.base import DISTANCE, ENUMERATION, INTEGER, SPEED, Feature, Property, values
from CNCStepper.workbench.words import later

TOOL, CUTTING = later("Tool"), later("Cutting")
SHAPES = ("flat", "ball", "bullnose", "v", "drill", "engraver")


class Tool(Feature):
    """The proxy of a tool; its keys are those of a job file's `[[tool]]`."""

    Type = "CNCStepper_Tool"
    PROPERTIES = (
        Property("number", "Number", INTEGER, TOOL, later("Number"), later("The T word of the program"), 1),
        Property("shape", "ToolShape", ENUMERATION, TOOL, later("Shape"), later("The form of the cutter"), "flat",
                 choices=SHAPES),
        Property("diameter_mm", "Diameter", DISTANCE, TOOL, later("Diameter"), later("The diameter of the cutter"),
                 6.0),
        Property("feed_mm_min", "Feed", SPEED, CUTTING, later("Feed"), later("The speed of cutting moves"), 800.0),
        Property("plunge_mm_min", "Plunge", SPEED, CUTTING, later("Plunge feed"), later("The speed straight down"),
                 200.0),
        Property("spindle_rpm", "SpindleSpeed", "App::PropertyFloat", CUTTING, later("Spindle"),
                 later("Spindle turns a minute"), 10000.0),
    )  # fmt: skip

    def check(self, obj: Any) -> None:
        """Raise JobError that names the value that cannot be."""
        model_of(obj)

    make = check


def model_of(obj: Any) -> Any:
    """Return a tool object as `machine.tool.Tool`; raises JobError."""
    packages.require()
    from CNCStepper.machine.profile import validated
    from CNCStepper.machine.tool import Tool as Model

    return validated(Model, values(obj), obj.Label)
