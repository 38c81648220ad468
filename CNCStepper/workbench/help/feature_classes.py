# SPDX-License-Identifier: LGPL-2.1-or-later
"""The classes of all kinds of objects that have a page in the help."""

from __future__ import annotations

from CNCStepper.workbench.features.base import Feature
from CNCStepper.workbench.features.catalogue import KINDS
from CNCStepper.workbench.features.drawings.drawing import Drawing
from CNCStepper.workbench.features.drawings.nest import Nest
from CNCStepper.workbench.features.drawings.shape import Shape
from CNCStepper.workbench.features.drawings.slices import Slices
from CNCStepper.workbench.features.drawings.text import Text
from CNCStepper.workbench.features.freehand import Freehand
from CNCStepper.workbench.features.job import Job
from CNCStepper.workbench.features.program import Program
from CNCStepper.workbench.features.programs.arrangement import Arrangement
from CNCStepper.workbench.features.tool import Tool
from CNCStepper.workbench.features.turning.lathe_job import LatheJob
from CNCStepper.workbench.features.turning.turning_operation import TURNING_KINDS
from CNCStepper.workbench.features.turning.turning_profile import TurningProfile
from CNCStepper.workbench.features.turning.turning_tool import TurningTool

DRAWN = (Drawing, Text, Shape, Freehand, Slices, Nest)
CLASSES: tuple[type[Feature], ...] = (
    *(Job, Tool, Program, Arrangement, LatheJob, TurningTool, TurningProfile),
    *(*KINDS, *TURNING_KINDS, *DRAWN),
)
