# SPDX-License-Identifier: LGPL-2.1-or-later
"""The last step: the machine is saved under a name as a profile of the user's, and written for FreeCAD if wanted."""

from __future__ import annotations

from PySide import QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.files.fcm_files import write_fcm
from CNCStepper.machine.own_profiles import values_of
from CNCStepper.machine.profile import load_machine, profile_names
from CNCStepper.workbench.assistant.machine_setup import MachineSetup
from CNCStepper.workbench.assistant.widgets import NAME, Page, choose_file, label, row
from CNCStepper.workbench.dock import window as dock_window
from CNCStepper.workbench.dock.connection import error_text
from CNCStepper.workbench.dock.model import settings
from CNCStepper.workbench.machines.machine_test_connection import Bench
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

TITLE = later("Save")
TOLD = ("controller", "processes", "axis")


class SavePage(Page):
    """See the module."""

    title = TITLE

    def __init__(self, setup: MachineSetup, bench: Bench):
        super().__init__(setup, bench, tr("Save the machine under a name: jobs and the controller's panel offer it."))
        self.name = QtGui.QLineEdit()
        self.name.setObjectName(f"{NAME}_name")
        self.name.setAccessibleName(tr("Name of the profile: letters of a to z, digits, - and _"))
        self.name.setToolTip(tr("Name of the profile: letters of a to z, digits, - and _"))
        self.name.textEdited.connect(guarded(self.refresh))
        self.saving = self.button("save", tr("Save"), self._save)
        self.exporting = self.button("export", tr("Write for FreeCAD…"), self._export)
        self.said, self.values = label("saved"), label("summary")
        self.column.addWidget(self.name)
        self.column.addLayout(row(self.saving, self.exporting))
        for widget in (self.said, self.note, self.values):
            self.column.addWidget(widget)
        self.column.addStretch(1)

    def entered(self) -> None:
        """Propose a name, and list what will be saved."""
        self.name.setText(self.setup.saved or self.setup.proposed_name())
        self.said.setText("")
        machine = self.setup.machine
        told = [line for line in values_of(machine) if line.startswith(TOLD)] if machine else []
        self.values.setText("\n".join(line for line in told if "backlash" not in line))
        self.refresh()

    def refresh(self) -> None:
        """Show what can be done."""
        self.saving.setEnabled(self.setup.machine is not None and bool(self.name.text().strip()))
        self.exporting.setEnabled(bool(self.setup.saved))

    def _save(self) -> None:
        name = self.name.text().strip()
        if name in profile_names() and name != self.setup.saved:
            question = tr("There is a machine {0} already.").format(name)
            if not messages.ask(question, tr("Change that one"), tr("Cancel")):
                return
        try:
            written = self.setup.save(name)
        except (CNCStepperError, OSError) as error:
            self.say_wrong(error_text(error) if isinstance(error, CNCStepperError) else str(error))
            return
        self.say_wrong("")
        self.said.setText(tr("{0} is written. New jobs can use it.").format(written.path))
        self._choose_in_dock(name)
        self.refresh()

    def _choose_in_dock(self, name: str) -> None:
        """Let the controller's panel have this machine."""
        settings.remember_machine(name)
        if dock_window.link_here():
            connection = dock_window.panel().connection
            connection.look_for_machines()
            connection.machine.setCurrentText(name)

    def _export(self) -> None:
        proposed = f"{self.setup.saved}.fcm"
        path = choose_file(self, tr("Machine file of FreeCAD"), tr("Machines of FreeCAD (*.fcm)"), "fcm", proposed)
        if path:
            write_fcm(path, load_machine(self.setup.saved))
            self.said.setText(tr("{0} is written.").format(path))
