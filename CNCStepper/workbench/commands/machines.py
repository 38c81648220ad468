# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command of the machine profiles."""

from __future__ import annotations

from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Machines(Command):
    """Opens the machine profiles."""

    name = "CNCStepper_Machines"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Machines", "Machines…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Machines", "Makes and changes machine profiles, and tests a machine")

    def why_not(self) -> str:
        """Return why no profile can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Open the dialog."""
        from CNCStepper.workbench.machines import open_machines

        open_machines()
