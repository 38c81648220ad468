# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Simulate: prove a job's program and show what it cuts."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.editor import active_program
from CNCStepper.workbench.proving import prove_program
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Simulate(Command):
    """Opens the simulation of a job."""

    name = "CNCStepper_Simulate"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Simulate", "Check and simulate")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Simulate", "Checks the program of the job and shows what it cuts")

    def why_not(self) -> str:
        """Return why there is nothing to simulate."""
        return active_program.why_not()

    def about(self) -> str:
        """Return which program it acts on."""
        return active_program.name()

    def run(self) -> None:
        """Open the simulation of the program that is in front."""
        program = active_program.take()
        if program is not None:
            self.take(program)

    def take(self, program: Any) -> None:
        """Open the simulation of a job or of an edited program."""
        from CNCStepper.workbench import dock, freehand
        from CNCStepper.workbench.restart import open_restart
        from CNCStepper.workbench.simulation import open_simulation

        freehand.leave()
        prove_program.make(program)
        open_simulation(program, lambda job, line: open_restart(job, dock.send, line))
