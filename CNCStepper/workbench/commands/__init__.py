# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of toolbar and menu, from left to right along the road of a part."""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Sequence

from CNCStepper.workbench.services.command import Command

SEPARATOR = "Separator"  # FreeCAD's word for it


def register() -> tuple[list[str], list[str], list[str]]:
    """Make the commands known to FreeCAD; return the names of toolbar and menu, with separators, and the lathe's.

    What only serves the selected operations stands in the menu and in the tree.
    """
    import FreeCADGui

    from CNCStepper.workbench.commands import operations, program
    from CNCStepper.workbench.commands.create_object import Freehand
    from CNCStepper.workbench.commands.drawings import ImportDrawing, Nest, Shapes, Slice, Template, Text
    from CNCStepper.workbench.commands.first_steps import FirstSteps
    from CNCStepper.workbench.commands.help import Help
    from CNCStepper.workbench.commands.job import ImportTools, NewJob
    from CNCStepper.workbench.commands.job_files import ExportJob, OpenJob, Report, SaveJobTemplate
    from CNCStepper.workbench.commands.machines import Assistant, Letters, Library, Machines
    from CNCStepper.workbench.commands.packages import Install
    from CNCStepper.workbench.commands.reorder import COMMANDS as ORDERING
    from CNCStepper.workbench.commands.turning import COMMANDS as TURNING

    drawing = (NewJob(), ImportTools(), ImportDrawing(), Template(), Text(), Shapes(), Slice(), Nest(), Freehand())
    areas, lines_and_holes = _made(operations.AREAS), _made(operations.LINES_AND_HOLES)
    sheets = _made(operations.SHEETS)
    machine = (*_made(program.COMMANDS), Machines(), Library(), Letters())
    order, files = _made(ORDERING), (OpenJob(), ExportJob(), SaveJobTemplate(), Report(), program.Compare())
    setting_up, manual = (FirstSteps(), Assistant(), Install()), (Help(),)
    turning = _made(TURNING)
    kinds = (drawing, areas, lines_and_holes, sheets)
    for command in itertools.chain(*kinds, turning, order, machine, files, setting_up, manual):
        FreeCADGui.addCommand(command.name, command)
    menu = _names(*kinds, order, machine, files, (*setting_up, *manual))
    return _names(*kinds, machine, manual), menu, _names(turning)


def _made(kinds: Iterable[type[Command]]) -> tuple[Command, ...]:
    return tuple(kind() for kind in kinds)


def _names(*groups: Sequence[Command]) -> list[str]:
    names = ([*(command.name for command in group), SEPARATOR] for group in groups)
    return [*itertools.chain.from_iterable(names)][:-1]
