# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of toolbar and menu, from left to right along the road of a part."""

from __future__ import annotations


def register() -> list[str]:
    """Make the commands known to FreeCAD and return their names in their order."""
    import FreeCADGui

    from CNCStepper.workbench.commands.controller import Controller
    from CNCStepper.workbench.commands.elliptical_pocket import EllipticalPocket
    from CNCStepper.workbench.commands.engrave import Engrave
    from CNCStepper.workbench.commands.freehand import Freehand
    from CNCStepper.workbench.commands.new_job import NewJob
    from CNCStepper.workbench.commands.send import Send
    from CNCStepper.workbench.commands.simulate import Simulate

    order = (NewJob(), Freehand(), EllipticalPocket(), Engrave(), Simulate(), Send(), Controller())
    for command in order:
        FreeCADGui.addCommand(command.name, command)
    return [command.name for command in order]
