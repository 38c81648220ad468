# SPDX-License-Identifier: LGPL-2.1-or-later
"""Opening and accepting the task panels of our commands by real clicks."""

from __future__ import annotations

import FreeCADGui

from window_helpers.hand import Hand

PANEL = "CNCStepper_Panel_"


def begin(hand: Hand, command: str, selected: str = "") -> None:
    """Select an object, or nothing, press a command's button, and wait for its panel."""
    hand.main(FreeCADGui.Selection.clearSelection)
    if selected:
        hand.tree(selected)
    hand.wait(lambda: FreeCADGui.Command.get(command).getAction()[0].isEnabled(), 10, f"{command} to be enabled")
    hand.command(command)
    hand.wait(lambda: hand.exists(f"{PANEL}ok"), 20, f"the panel of {command}")


def accept(hand: Hand) -> None:
    """Press the panel's own OK and wait until it is gone."""
    hand.click(f"{PANEL}ok")
    hand.wait(lambda: not FreeCADGui.Control.activeDialog(), 60, "the panel to close")
