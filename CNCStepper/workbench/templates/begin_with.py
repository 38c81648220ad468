# SPDX-License-Identifier: LGPL-2.1-or-later
"""The row of a new job's panel that chooses what the job begins with: what is preferred, or a template."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide import QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME, note_label
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

PREFERRED = ""  # the choice of what is preferred


class BeginWith(QtGui.QWidget):
    """The list of beginnings, and below it why one cannot be; `begin` is called with a template's path or PREFERRED.

    choices: the templates, their paths and words. `begin` returns whether it has begun; where it has not, and where it
    raises a CNCStepperError, the choice goes back.
    """

    def __init__(self, choices: Sequence[tuple[str, str]], begin: Callable[[str], bool], parent: Any):
        super().__init__(parent)
        self._begin, self._begun = begin, 0
        f1_key.set_page(self, "freecad.md")
        self.choice = _list_of_beginnings(choices, self)
        self.choice.activated.connect(guarded(lambda *_: self.begin(self.choice.currentIndex())))
        self.problem = note_label(f"{NAME}_begin_with_problem", ERROR_COLOUR, self)
        label = QtGui.QLabel(tr("Begin with"), self)
        label.setBuddy(self.choice)
        grid = QtGui.QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setColumnStretch(1, 1)
        grid.addWidget(label, 0, 0)
        grid.addWidget(self.choice, 0, 1)
        grid.addWidget(self.problem, 1, 0, 1, 2)

    def begin(self, row: int) -> None:
        """Begin with what a row of the list says."""
        begun, why = False, ""
        try:
            begun = self._begin(self.choice.itemData(row))
        except CNCStepperError as error:
            why = f"{self.choice.itemText(row)}: {translated(error.sentence)}"
        if begun:
            self._begun = row
        self.choice.setCurrentIndex(self._begun)
        self.problem.setText(why)
        self.problem.setVisible(bool(why))


def _list_of_beginnings(choices: Sequence[tuple[str, str]], parent: Any) -> Any:
    """Return the list, which is no wider than the panel."""
    found = QtGui.QComboBox(parent)
    found.setObjectName(f"{NAME}_begin_with")
    found.setAccessibleName(tr("Begin with"))
    found.setToolTip(tr("A template gives machine, material, stock and tools; what you have typed stays"))
    found.setMinimumContentsLength(1)
    found.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    for path, words in ((PREFERRED, tr("what is preferred")), *choices):
        found.addItem(words, path)
    return found
