# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands that take a program further: edit, open, check and simulate, send; and the controller's dock."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.commands.create_object import create, labelled
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.editor import active_program
from CNCStepper.workbench.proving import prove_program
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP, tr


class EditProgram(Command):
    """Opens the program of a job, or an edited one, in the editor."""

    name = "CNCStepper_EditProgram"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_EditProgram", "Edit program")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_EditProgram", "Opens the program of the job in the editor")

    def why_not(self) -> str:
        """Return why there is no program to edit."""
        if targets.program() is not None:
            return missing_packages.why_not()
        return prove_program.why_not()

    def run(self) -> None:
        """Open the program that is meant."""
        from CNCStepper.workbench import editor

        meant = prove_program.meant()
        if targets.program() is None:
            prove_program.make(meant)
        editor.open_program(meant)


class OpenProgram(Command):
    """Opens a G-code file in the editor."""

    name = "CNCStepper_OpenProgram"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_OpenProgram", "Open G-code file…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_OpenProgram", "Opens a G-code file in the editor")

    def why_not(self) -> str:
        """Return why no program can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Ask for the file and open it."""
        from CNCStepper.workbench import editor
        from CNCStepper.workbench.editor.file_dialogs import ask_which

        path = ask_which()
        if path is not None:
            editor.open_file(path)


class SaveProgram(Command):
    """Saves the program of a job."""

    name = "CNCStepper_SaveProgram"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_SaveProgram", "Save program…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_SaveProgram", "Saves the program of the job as a file for the machine")

    def why_not(self) -> str:
        """Return why there is no program of a job."""
        no_job = missing_packages.why_not() or targets.why_no_panel() or targets.why_no_job()
        return no_job or targets.why_no_program(targets.job())

    def run(self) -> None:
        """Ask for a file and write the program into it."""
        prove_program.save_as(targets.job())


class Arrange(Command):
    """Places programs on the work surface, as one program."""

    name = "CNCStepper_Arrangement"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Arrangement", "Arrange programs…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Arrangement", "Places programs on the work surface with the mouse, and makes one program of them"
    )

    def why_not(self) -> str:
        """Return why nothing can be arranged."""
        return missing_packages.why_not() or targets.why_no_view() or targets.why_no_panel() or targets.why_no_job()

    def run(self) -> None:
        """Make the arrangement of the selected programs, else of the job's own, and open its panel."""
        job, selected = targets.job(), targets.selected()
        create(job.Document, self.text(), lambda: _arrangement(job, selected))


def _arrangement(job: Any, selected: list[Any]) -> Any:
    """Return an arrangement of those of some objects that have programs, else of the job's."""
    from CNCStepper.workbench import api
    from CNCStepper.workbench.features.programs.arrangement import is_source

    found = [each for each in selected if is_source(each)] or [each for each in [job] if is_source(each)]
    return labelled(api.add_arrangement(job, found), tr("Arrangement"))


class Compare(Command):
    """Compares the motion of two programs."""

    name = "CNCStepper_Compare"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Compare", "Compare programs…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Compare", "Lays the tool paths of two programs over each other, and says where they differ"
    )

    def why_not(self) -> str:
        """Return why no program can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Open the window with the program that is meant."""
        from CNCStepper.workbench.comparison import open_comparison

        open_comparison(prove_program.meant())


class Further(Command):
    """A command that acts on the program in front."""

    def why_not(self) -> str:
        """Return why there is no program to act on."""
        return active_program.why_not()

    def about(self) -> str:
        """Return which program it acts on."""
        return active_program.name()

    def run(self) -> None:
        """Act on the program that is in front."""
        program = active_program.take()
        if program is not None:
            self.take(program)

    def take(self, program: Any) -> None:
        """Act on a job or on an edited program."""
        raise NotImplementedError


class Simulate(Further):
    """Opens the simulation of a job."""

    name = "CNCStepper_Simulate"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Simulate", "Check and simulate")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Simulate", "Checks the program of the job and shows what it cuts")

    def take(self, program: Any) -> None:
        """Open the simulation of a job or of an edited program."""
        from CNCStepper.workbench import dock, freehand
        from CNCStepper.workbench.restart import open_restart
        from CNCStepper.workbench.simulation import open_simulation

        freehand.leave()
        prove_program.make(program)
        open_simulation(program, lambda job, line: open_restart(job, dock.send, line))


class Send(Further):
    """Sends a job."""

    name = "CNCStepper_Send"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Send", "Send")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Send", "Checks the program of the job and streams it to the machine")

    def take(self, program: Any) -> None:
        """Send a job or an edited program."""
        from CNCStepper.workbench import dock

        prove_program.make(program)
        dock.send(program)


class Controller(Command):
    """Shows the controller's dock; there is nothing it needs."""

    name = "CNCStepper_Controller"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Controller", "Controller")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Controller", "Shows the machine: state, position, hold, stop, jog, zero")

    def run(self) -> None:
        """Show the dock."""
        from CNCStepper.workbench import dock

        dock.show()


COMMANDS = (EditProgram, OpenProgram, SaveProgram, Arrange, Simulate, Send, Controller)
