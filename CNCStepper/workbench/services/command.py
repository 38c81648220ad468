# SPDX-License-Identifier: LGPL-2.1-or-later
"""The base of all commands: enabled exactly when they can work; otherwise the tooltip has the reason."""

from __future__ import annotations

import html
from typing import Any

from CNCStepper.workbench import packages
from CNCStepper.workbench.services.messages import guarded, polled


class Command:
    """A command of FreeCAD's.

    FreeCAD translates `menu_text` and `tooltip` itself, in the context of the command's name.
    """

    name = ""
    menu_text = ""
    tooltip = ""

    def __init__(self) -> None:
        self._own_tooltip = ""  # as FreeCAD wrote it, in its language
        self._shown_tooltip = ""

    def why_not(self) -> str:
        """Return why the command cannot work now, in one sentence, or "" when it can.

        It is asked several times a second: it only looks, and is quick.
        """
        return ""

    def about(self) -> str:
        """Return what the command acts on, for its tooltip, "" where that is plain; as quick as `why_not`."""
        return ""

    def run(self) -> None:
        """Run the command; raises a CNCStepperError with the reason when that fails."""
        raise NotImplementedError

    def text(self) -> str:
        """Return the menu text in FreeCAD's language."""
        import FreeCAD

        return FreeCAD.Qt.translate(self.name, self.menu_text)

    def GetResources(self) -> dict[str, str]:
        """Return what FreeCAD shows of the command; "ForEdit": also asked while a panel is open."""
        icon = packages.ROOT / "resources" / "icons" / f"{self.name}.svg"
        return {"MenuText": self.menu_text, "ToolTip": self.tooltip, "Pixmap": str(icon), "CmdType": "ForEdit"}

    def IsActive(self) -> bool:
        """Return whether the command can work now, and put the reason into its tooltip when it cannot."""
        return bool(self._is_able())

    @polled
    def _is_able(self) -> bool:
        reason = self.why_not()
        self._explain(f"<b>{html.escape(reason)}</b>" if reason else html.escape(self.about()))
        return not reason

    @guarded
    def Activated(self, index: int = 0) -> None:
        """Do what the command is for; a refusal is shown."""
        note_in_macro(self.name)
        self.run()

    def _explain(self, sentence: str) -> None:
        """Put a sentence below FreeCAD's own tooltip, which FreeCAD writes anew when its language changes."""
        for action in _actions(self.name):
            present = action.toolTip()
            if present != self._shown_tooltip:
                self._own_tooltip = present
            wanted = self._own_tooltip + (f"<p>{sentence}</p>" if sentence else "")
            if present != wanted:
                action.setToolTip(wanted)
            self._shown_tooltip = wanted


def note_in_macro(name: str) -> None:
    """Say in a macro that is being recorded which command was chosen, as a comment.

    FreeCAD records a command without a line of its own as one that runs again: that would open its panel, or the
    machine would move. What a command does to the document is recorded by `document/macro_recorder.py`.
    """
    import FreeCADGui

    FreeCADGui.doCommand(f"# {name}")


def look_again(*names: str) -> None:
    """Let commands update at once whether they can work: FreeCAD asks only after a change of its own."""
    import FreeCADGui

    for name in names:
        command = FreeCADGui.Command.get(name)
        is_able = bool(command and command.isActive())
        for action in _actions(name):
            action.setEnabled(is_able)


def _actions(name: str) -> list[Any]:
    """Return the command's QActions: none before FreeCAD has put it into a toolbar or menu."""
    import FreeCADGui

    command = FreeCADGui.Command.get(name)
    return command.getAction() if command else []
