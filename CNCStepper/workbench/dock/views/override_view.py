# SPDX-License-Identifier: LGPL-2.1-or-later
"""Overrides of feed, rapid and spindle in percent, and the coolant, as the controller reports them."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from PySide import QtGui

from CNCStepper.workbench.dock.model.button_states import RULES, ControllerSnapshot, why_not
from CNCStepper.workbench.dock.views import widgets
from CNCStepper.workbench.services.number_format import NOTHING
from CNCStepper.workbench.services.translation import later, tr

# What stands on the button, the step, the grid's column, and over how many columns it goes.
Steps = tuple[tuple[str, "int | str", int, int], ...]
STEPS: Steps = (("−10", -10, 2, 1), ("−1", -1, 3, 1), ("100", "reset", 4, 1), ("+1", 1, 5, 1), ("+10", 10, 6, 1))
RAPIDS: Steps = (("25", 25, 2, 1), ("50", 50, 3, 3), ("100", 100, 6, 1))
COOLANTS: Steps = ((later("Flood"), "flood", 2, 3), (later("Mist"), "mist", 5, 2))
KINDS = (
    ("feed", later("Feed"), STEPS),
    ("rapid", later("Rapid"), RAPIDS),
    ("spindle", later("Spindle"), STEPS),
    ("coolant", later("Coolant"), COOLANTS),
)
ON = {"F": later("Flood"), "M": later("Mist")}  # of the letters that the controller reports


class OverrideView(QtGui.QWidget):
    """Four rows of buttons; change(kind, step) passes a click on."""

    def __init__(self, change: Callable[[str, int | str], None]):
        super().__init__()
        layout = widgets.grid(self)
        layout.setSpacing(3)
        self.figures = {}
        self._buttons: list[Any] = []
        for line, (kind, text, steps) in enumerate(KINDS):
            self.figures[kind] = widgets.figure(f"Override_{kind}")
            layout.addWidget(QtGui.QLabel(tr(text)), line, 0)
            layout.addWidget(self.figures[kind], line, 1)
            for shown, step, place, width in steps:
                button = widgets.button(f"Override_{kind}_{step}", tr(shown), partial(change, kind, step))
                button.setAccessibleName(f"{tr(text)}: {tr(shown)}")
                self._buttons.append(button)
                layout.addWidget(button, line, place, 1, width)
        for place in range(2, 2 + len(STEPS)):
            layout.setColumnStretch(place, 1)

    def lock(self, moment: ControllerSnapshot) -> None:
        """Enable the buttons when an override can be changed."""
        why = why_not("override", moment)
        for button in self._buttons:
            widgets.lock(button, why, RULES["override"].does)

    def show_overrides(self, percents: dict[str, int | None], outputs: str | None) -> None:
        """Show the percentages and the coolant reported; None shows a dash."""
        for kind, label in self.figures.items():
            percent = percents.get(kind)
            label.setText(tr("{0} %").format(NOTHING if percent is None else percent))
        on = [tr(text) for letter, text in ON.items() if letter in (outputs or "")]
        self.figures["coolant"].setText(", ".join(on) or (NOTHING if outputs is None else tr("Off")))
