# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Send: check a job's program and stream it to the machine."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.editor import active_program
from CNCStepper.workbench.proving import prove_program
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Send(Command):
    """Sends a job."""

    name = "CNCStepper_Send"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Send", "Send")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Send", "Checks the program of the job and streams it to the machine")

    def why_not(self) -> str:
        """Return why there is nothing to send."""
        return active_program.why_not()

    def about(self) -> str:
        """Return which program it acts on."""
        return active_program.name()

    def run(self) -> None:
        """Send the program that is in front."""
        program = active_program.take()
        if program is not None:
            self.take(program)

    def take(self, program: Any) -> None:
        """Send a job or an edited program."""
        from CNCStepper.workbench import dock

        prove_program.make(program)
        dock.send(program)
