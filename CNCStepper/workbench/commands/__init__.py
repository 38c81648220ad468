# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of toolbar and menu, from left to right along the road of a part."""

from __future__ import annotations

import itertools

SEPARATOR = "Separator"  # FreeCAD's word for it


def register() -> list[str]:
    """Make the commands known to FreeCAD and return their names in their order, with separators between groups."""
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
    from CNCStepper.workbench.commands.send import Send
    from CNCStepper.workbench.commands.simulate import Simulate

    drawing = (NewJob(), ImportTools(), Freehand())
    areas = (Face(), Pocket(), RectangularPocket(), CircularPocket(), EllipticalPocket())
    lines_and_holes = (Contour(), Drill(), Bore(), Thread(), Engrave())
    machine = (EditProgram(), OpenProgram(), Simulate(), Send(), Controller())
    for command in (*drawing, *areas, *lines_and_holes, *machine):
        FreeCADGui.addCommand(command.name, command)
    groups = [[command.name for command in group] for group in (drawing, areas, lines_and_holes, machine)]
    return [*itertools.chain.from_iterable([*group, SEPARATOR] for group in groups)][:-1]
