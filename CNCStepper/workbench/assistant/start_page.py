# SPDX-License-Identifier: LGPL-2.1-or-later
"""The step that chooses a machine to begin from, by its process and controller, or a machine file of FreeCAD's."""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.machine.controller_family import FAMILIES
from CNCStepper.machine.processes import PROCESSES
from CNCStepper.workbench.assistant.machine_setup import MachineSetup, StartMachine, start_machines
from CNCStepper.workbench.assistant.widgets import NAME, Page, choose_file, combo, label, row
from CNCStepper.workbench.machines.labels import choice_label
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

TITLE = later("Machine")
LATHE = "lathe"


class StartPage(Page):
    """See the module."""

    title = TITLE

    def __init__(self, setup: MachineSetup, bench: Bench):
        super().__init__(setup, bench, tr("Choose what the machine does, and the machine that is nearest to yours."))
        self._starts: list[StartMachine] = start_machines()
        processes = [(choice_label(("processes",), name), name) for name in PROCESSES]
        every = (tr("all"), "")
        self.process = combo("process", tr("Process"), [every, *processes, (tr("turning"), LATHE)], self._filter)
        controllers = sorted({start.machine.controller.partition(":")[0] for start in self._starts} | set(FAMILIES))
        every_controller = [every, *((name, name) for name in controllers)]
        self.controller = combo("controller", tr("Controller"), every_controller, self._filter)
        self.list = QtGui.QListWidget()
        self.list.setObjectName(f"{NAME}_starts")
        self.list.setAccessibleName(tr("Machines"))
        self.list.currentItemChanged.connect(guarded(self._chosen))
        self.about = label("about")
        self.about.setAlignment(QtCore.Qt.AlignmentFlag.AlignTop)
        self.column.addLayout(row(QtGui.QLabel(tr("Process")), self.process, QtGui.QLabel(tr("Controller")),
                                  self.controller))  # fmt: skip
        beside = QtGui.QHBoxLayout()
        beside.addWidget(self.list, 3)
        beside.addWidget(self.about, 2)
        self.column.addLayout(beside, 1)
        self.column.addWidget(self.note)
        self.column.addLayout(row(self.button("fcm", tr("Machine file of FreeCAD…"), self._read_fcm)))
        self._filter()

    def _filter(self) -> None:
        """List the machines that can do it."""
        process, controller = self.process.currentData(), self.controller.currentData()
        self.list.blockSignals(True)
        self.list.clear()
        for start in self._starts:
            turns = start.machine.is_lathe or "y" not in start.machine.axis
            does = turns if process == LATHE else (process in start.machine.processes and not turns)
            if (does or not process) and controller in ("", start.machine.controller.partition(":")[0]):
                item = QtGui.QListWidgetItem(start.text)
                item.setData(QtCore.Qt.ItemDataRole.UserRole, start.profile)
                self.list.addItem(item)
                if start.profile == self.setup.base:
                    self.list.setCurrentItem(item)
        self.list.blockSignals(False)
        self._show_about()

    def _chosen(self, item: Any) -> None:
        if item is not None:
            self.setup.begin_from(str(item.data(QtCore.Qt.ItemDataRole.UserRole)))
        self.say_wrong("")
        self._show_about()

    def _show_about(self) -> None:
        start = next((one for one in self._starts if one.profile == self.setup.base), None)
        self.about.setText(start.about if start else "")

    def _read_fcm(self) -> None:
        path = choose_file(self, tr("Machine file of FreeCAD"), tr("Machines of FreeCAD (*.fcm)"))
        if path:
            self.setup.begin_from_fcm(path)
            self.about.setText(tr("{0} is read. What it does not have comes from the machine on the left.").format(
                self.setup.draft.texts[("name",)]))  # fmt: skip
