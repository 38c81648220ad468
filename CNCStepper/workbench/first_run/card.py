# SPDX-License-Identifier: LGPL-2.1-or-later
"""The card of the first evening: try it without hardware, set up a machine, or open an example."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.first_run.card_setting import remember_closed
from CNCStepper.workbench.first_run.examples import EXAMPLES, Example, open_example
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.services.icons import icon
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_FirstSteps"
WIDTH_PX = 520
ICON_PX = 32


class Card(QtGui.QDialog):
    """See the module. Whatever closes it keeps it from coming again by itself."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("First steps"))
        f1_key.attach(self, "freecad.md")
        self.setMinimumWidth(WIDTH_PX)
        self.finished.connect(guarded(remember_closed))
        column = QtGui.QVBoxLayout(self)
        column.addWidget(self._label("greeting", tr("How do you want to begin?")))
        for button in (self._try_out(), self._set_up(), self._example()):
            column.addWidget(button)
        again = tr("This card does not come again by itself: it is in the menu CNCStepper, First steps.")
        column.addWidget(self._label("again", again))
        close = QtGui.QPushButton(tr("Close"), self)
        close.setObjectName(f"{NAME}_close")
        close.clicked.connect(guarded(lambda: self.accept()))
        column.addWidget(close, 0, QtCore.Qt.AlignmentFlag.AlignRight)

    def try_out(self) -> None:
        """Begin the tour, which ends with a part cut by the virtual machine."""
        from CNCStepper.workbench.first_run.tour import begin_tour

        self.accept()
        begin_tour()

    def set_up(self) -> None:
        """Open the machine assistant."""
        from CNCStepper.workbench.assistant import open_assistant

        self.accept()
        open_assistant()

    def open(self, example: Example) -> None:
        """Open an example as a document."""
        self.accept()
        open_example(example)

    def _try_out(self) -> Any:
        about = tr("Draw a part and cut it on a virtual machine, in seven steps. Nothing is connected.")
        button = self._way("try", "CNCStepper_Simulate", tr("Try without hardware"), about)
        button.clicked.connect(guarded(self.try_out))
        return button

    def _set_up(self) -> Any:
        about = tr("Find its port, begin from a machine like yours, measure its axes and save it.")
        button = self._way("machine", "CNCStepper_Assistant", tr("Set up my machine"), about)
        button.clicked.connect(guarded(self.set_up))
        return button

    def _example(self) -> Any:
        about = tr("Look at a finished job, change its numbers and simulate it.")
        button = self._way("example", "CNCStepper_OpenJob", tr("Open an example"), about)
        menu = QtGui.QMenu(button)
        for example in EXAMPLES:
            entry = menu.addAction(tr(example.title))
            entry.triggered.connect(guarded(lambda example=example: self.open(example)))
        button.setMenu(menu)
        return button

    def _way(self, name: str, icon_name: str, title: str, about: str) -> Any:
        button = QtGui.QCommandLinkButton(title, about, self)
        button.setObjectName(f"{NAME}_{name}")
        button.setIcon(icon(icon_name))
        button.setIconSize(QtCore.QSize(ICON_PX, ICON_PX))
        return button

    def _label(self, name: str, text: str) -> Any:
        label = QtGui.QLabel(text, self)
        label.setObjectName(f"{NAME}_{name}")
        label.setWordWrap(True)
        return label
