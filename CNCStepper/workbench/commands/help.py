# SPDX-License-Identifier: LGPL-2.1-or-later
"""The command that opens the help."""

from __future__ import annotations

from CNCStepper.workbench.services.command import Command
from CNCStepper.workbench.services.translation import QT_TRANSLATE_NOOP


class Help(Command):
    """Opens the page of the selected object, the contents where none of ours is selected."""

    name = "CNCStepper_Help"
    menu_text = QT_TRANSLATE_NOOP("CNCStepper_Help", "Help")
    tooltip = QT_TRANSLATE_NOOP(
        "CNCStepper_Help", "The guides and all fields, of the selected object first; F1 in a panel opens its page"
    )

    def run(self) -> None:
        """Open the help."""
        import FreeCADGui

        from CNCStepper.workbench.features.base import proxy_type
        from CNCStepper.workbench.help.topics import CONTENTS, object_address
        from CNCStepper.workbench.help.window import open_help

        selected = FreeCADGui.Selection.getSelection()
        open_help(object_address(proxy_type(selected[0])) if len(selected) == 1 else CONTENTS)
