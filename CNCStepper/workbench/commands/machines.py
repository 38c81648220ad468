# SPDX-License-Identifier: LGPL-2.1-or-later
"""The commands of the shop: the machine assistant, profiles, tools and materials, and pulse letters."""

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


class Assistant(Command):
    """Opens the machine assistant."""

    name = "CNCStepper_Assistant"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Assistant", "Machine assistant…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Assistant", "Sets a machine up: port, values, measured axes, settings, and a profile of its own"
    )

    def why_not(self) -> str:
        """Return why no profile can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Open the assistant."""
        from CNCStepper.workbench.assistant import open_assistant

        open_assistant()


class Library(Command):
    """Opens the user's own tools, materials and cut charts."""

    name = "CNCStepper_Library"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Library", "Tools and materials…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Library", "Your own tools, materials and cut charts: search, edit, import and export them"
    )

    def why_not(self) -> str:
        """Return why no table can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Open the dialog."""
        from CNCStepper.workbench.libraries import open_libraries

        open_libraries()


class Letters(Command):
    """Opens the window of pulse letters."""

    name = "CNCStepper_Letters"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Letters", "Pulse letters…")
    tooltip = QT_TRANSLATE_NOOP("CNCStepper_Letters", "Draws a file of pulse letters and sends it, forwards and back")

    def why_not(self) -> str:
        """Return why no letters can be read."""
        return missing_packages.why_not()

    def run(self) -> None:
        """Open the window."""
        from CNCStepper.workbench.letters import open_letters

        open_letters()
