# SPDX-License-Identifier: LGPL-2.1-or-later
"""The step with the values: name, controller and spindle, and of each axis steps, speed, acceleration and travel.

They are typed, or taken from the controller that answered.
"""

from __future__ import annotations

from PySide import QtGui

from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.assistant.widgets import Page, label, row
from CNCStepper.workbench.machines.declaration import Path
from CNCStepper.workbench.machines.draft import ROWS
from CNCStepper.workbench.machines.fields import words_of
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.machines.sections import AxesSection, FormSection, scrolled
from CNCStepper.workbench.services.translation import later, tr

TITLE = later("Values")
WHOLE = [("name",), ("controller",), ("processes",)]
SPINDLE = [("spindle", key) for key in ("min_rpm", "max_rpm", "laser")]
OF_AXIS = ("steps_per_mm", "max_rate_mm_min", "acceleration_mm_s2", "travel_min_mm", "travel_max_mm", "homing")


class ValuesPage(Page):
    """See the module."""

    title = TITLE

    def __init__(self, setup: MachineSetup, bench: Bench):
        super().__init__(setup, bench, tr("Look at the values of your machine, and correct them."))
        by_path = {row_.path: row_ for row_ in ROWS}
        axes = [row_ for row_ in ROWS if row_.path[0] == "axis" and len(row_.path) == 3 and row_.path[2] in OF_AXIS]
        self.sections = (
            FormSection([by_path[path] for path in (*WHOLE, *SPINDLE)], self._typed, (), self.refresh),
            AxesSection(axes, self._typed),
        )
        content = QtGui.QWidget()
        column = QtGui.QVBoxLayout(content)
        for section in self.sections:
            column.addWidget(section)
        self.taking = self.button("take", tr("Take the controller's values"), self._take)
        self.said = label("taken")
        self.column.addWidget(scrolled(content), 1)
        self.column.addWidget(self.note)
        self.column.addLayout(row(self.taking, self.said))

    def entered(self) -> None:
        """Show the draft."""
        self.said.setText("")
        self._show()

    def refresh(self) -> None:
        """Show whether a controller has values to take."""
        has = bool(self.setup.identity and self.setup.identity.settings)
        self.taking.setEnabled(has)
        self.taking.setToolTip("" if has else tr("No controller with settings has answered."))

    def why_not(self) -> str:
        """Return that a value is none."""
        return tr("Correct the marked fields first.") if self.setup.draft.judged()[1] else ""

    def _typed(self, path: Path, text: str) -> None:
        self.setup.draft.texts[path] = text
        self._judge()

    def _take(self) -> None:
        self.setup.take_settings()
        self._show()
        self.said.setText(tr("The values of the controller are in the fields."))

    def _show(self) -> None:
        for section in self.sections:
            section.show_draft(self.setup.draft)
        self._judge()
        self.refresh()

    def _judge(self) -> None:
        words = {path: words_of(refused) for path, refused in self.setup.draft.judged()[1].items()}
        for section in self.sections:
            for path in section.mark(words):
                words.pop(path, None)
        self.say_wrong("\n".join(words.values()))
