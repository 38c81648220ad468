# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of toolbar and menu, from left to right along the road of a part."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

from CNCStepper.workbench.services.command import Command

SEPARATOR = "Separator"  # FreeCAD's word for it


def register() -> tuple[list[str], list[str]]:
    """Make the commands known to FreeCAD and return the names of the toolbar and of the menu, with separators.

    What only serves the selected operations stands in the menu and in the tree.
    """
    import FreeCADGui

    from CNCStepper.workbench.commands.contour import Contour
    from CNCStepper.workbench.commands.controller import Controller
    from CNCStepper.workbench.commands.edit_program import EditProgram, OpenProgram
    from CNCStepper.workbench.commands.elliptical_pocket import EllipticalPocket
    from CNCStepper.workbench.commands.engrave import Engrave
    from CNCStepper.workbench.commands.freehand import Freehand
    from CNCStepper.workbench.commands.holes import Bore, Drill, Thread
    from CNCStepper.workbench.commands.import_tools import ImportTools
    from CNCStepper.workbench.commands.new_job import NewJob
    from CNCStepper.workbench.commands.pockets import CircularPocket, Face, Pocket, RectangularPocket
    from CNCStepper.workbench.commands.reorder import COMMANDS as ORDERING
    from CNCStepper.workbench.commands.send import Send
    from CNCStepper.workbench.commands.simulate import Simulate

    drawing = (NewJob(), ImportTools(), Freehand())
    areas = (Face(), Pocket(), RectangularPocket(), CircularPocket(), EllipticalPocket())
    lines_and_holes = (Contour(), Drill(), Bore(), Thread(), Engrave())
    machine = (EditProgram(), OpenProgram(), Simulate(), Send(), Controller())
    order = tuple(kind() for kind in ORDERING)
    for command in (*drawing, *areas, *lines_and_holes, *order, *machine):
        FreeCADGui.addCommand(command.name, command)
    return _names(drawing, areas, lines_and_holes, machine), _names(drawing, areas, lines_and_holes, order, machine)


def _names(*groups: Sequence[Command]) -> list[str]:
    names = ([*(command.name for command in group), SEPARATOR] for group in groups)
    return [*itertools.chain.from_iterable(names)][:-1]
