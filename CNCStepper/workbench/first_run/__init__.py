# SPDX-License-Identifier: LGPL-2.1-or-later
"""The first steps: a card with three ways to begin, which comes once, and a tour of the road. Loads nothing of Qt."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.first_run.card_setting import was_closed


def show_once() -> None:
    """Show the card, unless a person has closed it before."""
    import FreeCAD

    if FreeCAD.GuiUp and not was_closed():
        open_card()


def open_card() -> Any:
    """Show the card in front, in FreeCAD's language, and return it."""
    import FreeCADGui

    from CNCStepper.workbench.first_run.card import NAME, Card
    from CNCStepper.workbench.services.front_window import in_front

    window = FreeCADGui.getMainWindow()
    for former in window.findChildren(Card, NAME):
        former.deleteLater()
    return in_front(Card(window))
