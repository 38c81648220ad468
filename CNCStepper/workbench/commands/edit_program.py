# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_EditProgram and CNCStepper_OpenProgram: a job's program, or a G-code file, in the editor."""

from __future__ import annotations

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.proving import prove_program
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


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
