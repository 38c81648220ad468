# SPDX-License-Identifier: LGPL-2.1-or-later
"""CNCStepper_Freehand: draw a line with the mouse."""

from __future__ import annotations

from CNCStepper.workbench.document import targets
from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Freehand(Command):
    """Starts drawing in the 3D view."""

    name = "CNCStepper_Freehand"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Freehand", "Freehand")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Freehand", "Draws a line with the mouse: press, move, release")

    def why_not(self) -> str:
        """Return why there is nothing to draw on."""
        return missing_packages.why_not() or targets.why_no_panel() or targets.why_no_view()

    def run(self) -> None:
        """Let the mouse draw."""
        from CNCStepper.workbench import freehand

        freehand.start()
