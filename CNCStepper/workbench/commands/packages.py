# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that installs packages."""

from __future__ import annotations

from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Install(Command):
    """Opens the dialog that installs missing packages."""

    name = "CNCStepper_Install"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Install", "Install packages…")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Install", "Installs the Python packages that are missing, from the internet or from files"
    )

    def run(self) -> None:
        """Open the dialog."""
        from CNCStepper.workbench.installation import open_installation

        open_installation()
