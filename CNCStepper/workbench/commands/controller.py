# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Controller: the dock with the state of the machine."""

from __future__ import annotations

from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Controller(Command):
    """Shows the controller's dock; there is nothing it needs."""

    name = "CNCStepper_Controller"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Controller", "Controller")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Controller", "Shows the machine: state, position, hold, stop, jog, zero")

    def run(self) -> None:
        """Show the dock."""
        from CNCStepper.workbench import dock

        dock.show()
