# SPDX-License-Identifier: LGPL-2.1-or-later
"""The window of the machine assistant: its steps on the left, one of them beside, and the way on and back.

Port ──► Machine ──► Values ──► Measure ──► Settings ──► Save        every step can be left out
"""

from __future__ import annotations

from typing import Any

import FreeCADGui
from PySide import QtGui

from CNCStepper.workbench.assistant.connect_page import ConnectPage
from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.assistant.measure_page import MeasurePage
from CNCStepper.workbench.assistant.save_page import SavePage
from CNCStepper.workbench.assistant.settings_page import SettingsPage
from CNCStepper.workbench.assistant.start_page import StartPage
from CNCStepper.workbench.assistant.values_page import ValuesPage
from CNCStepper.workbench.assistant.widgets import NAME, Page
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.services.front_window import in_front
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

SIZE = (860, 600)
LIST_PX = 130
PAGES: tuple[Any, ...] = (ConnectPage, StartPage, ValuesPage, MeasurePage, SettingsPage, SavePage)


class Assistant(QtGui.QDialog):
    """See the module. A page is made when it is first shown, so that opening takes no time."""

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Machine assistant"))
        self.resize(*SIZE)
        self.setup, self.bench = MachineSetup(), Bench(self)
        self.pages: dict[int, Page] = {}
        self.steps = QtGui.QListWidget()
        self.steps.setObjectName(f"{NAME}_steps")
        self.steps.setAccessibleName(tr("Steps"))
        self.steps.setFixedWidth(LIST_PX)
        for number, page in enumerate(PAGES, 1):
            self.steps.addItem(f"{number}. {tr(page.title)}")
        self.stack = QtGui.QStackedWidget()
        self.back, self.next = self._button("back", tr("Back"), -1), self._button("next", tr("Next"), 1)
        self.next.setDefault(True)
        closing = QtGui.QPushButton(tr("Close"), self)
        closing.setObjectName(f"{NAME}_close")
        closing.setAutoDefault(False)
        closing.clicked.connect(guarded(lambda: self.close()))
        self._arrange(closing)
        self.bench.changed.connect(guarded(self.refresh))
        self.steps.currentRowChanged.connect(guarded(self.show_step))
        self.steps.setCurrentRow(0)

    @property
    def page(self) -> Page:
        """The page that is shown."""
        return self.pages[self.steps.currentRow()]

    def show_step(self, number: int) -> None:
        """Show a step."""
        if number not in self.pages:
            self.pages[number] = PAGES[number](self.setup, self.bench)
            self.stack.addWidget(self.pages[number])
        self.stack.setCurrentWidget(self.pages[number])
        self.page.entered()
        self.refresh()

    def refresh(self) -> None:
        """Show the present moment in the page, and where the way leads."""
        number = self.steps.currentRow()
        self.page.refresh()
        self.back.setEnabled(number > 0)
        self.next.setEnabled(number < len(PAGES) - 1)

    def showEvent(self, event: Any) -> None:
        """Follow the machine while this is seen."""
        super().showEvent(event)
        self.bench.watch(True)

    def hideEvent(self, event: Any) -> None:
        """Let the machine go."""
        super().hideEvent(event)
        self.bench.watch(False)

    def _go(self, way: int) -> None:
        """Go to the next step or back; a step that is not right stays, with its errors."""
        why = self.page.why_not() if way > 0 else ""
        if why:
            self.page.say_wrong(why)
            return
        self.steps.setCurrentRow(self.steps.currentRow() + way)

    def _button(self, name: str, text: str, way: int) -> Any:
        button = QtGui.QPushButton(text, self)
        button.setObjectName(f"{NAME}_{name}")
        button.setAutoDefault(False)
        button.clicked.connect(guarded(lambda: self._go(way)))
        return button

    def _arrange(self, closing: Any) -> None:
        bottom = QtGui.QHBoxLayout()
        bottom.addStretch(1)
        for button in (self.back, self.next, closing):
            bottom.addWidget(button)
        right = QtGui.QVBoxLayout()
        right.addWidget(self.stack, 1)
        right.addLayout(bottom)
        whole = QtGui.QHBoxLayout(self)
        whole.addWidget(self.steps)
        whole.addLayout(right, 1)


def shown() -> Assistant:
    """Show the assistant, made at its first opening in this language, and return it."""
    window = FreeCADGui.getMainWindow()
    found = window.findChild(QtGui.QDialog, NAME)
    if isinstance(found, Assistant) and found.windowTitle() == tr("Machine assistant"):
        dialog = found
    else:
        dialog = Assistant(window)
    return in_front(dialog)
