# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that shows the card of the first steps again."""

from __future__ import annotations

from CNCStepper.workbench.services import missing_packages
from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class FirstSteps(Command):
    """Shows the card."""

    name = "CNCStepper_FirstSteps"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_FirstSteps", "First steps…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_FirstSteps", "Three ways to begin: a tour without a machine, your machine, an example"
    )

    def why_not(self) -> str:
        """Return why nothing can be begun."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Show the card."""
        from CNCStepper.workbench.first_run import open_card

        open_card()
