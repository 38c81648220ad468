# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a job that name its machine: a shipped profile or a file, and the program's dialect."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from PySide import QtGui

from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.panels.choice_labels import words_of
from CNCStepper.workbench.panels.fields import NAME, ChoiceField
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

FROM_FILE = object()  # the choice that asks for a file


class MachineField(ChoiceField):
    """A profile that ships with us, or a profile's file."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the shipped profiles by their names, and the choice that asks for a file."""
        from CNCStepper.machine.profile import load_machine, profile_names

        shipped = [(name, f"{load_machine(name).name} ({name})") for name in profile_names()]
        return [*shipped, (FROM_FILE, tr("A profile's file…"))]

    def touched(self) -> None:
        """Take the chosen profile, or ask for its file."""
        if self.read() is FROM_FILE:
            self.write()
            self.ask()
        else:
            super().touched()

    def ask(self) -> None:
        """Ask for a profile's file, and return at once."""
        dialog = QtGui.QFileDialog(self.widget, tr("A machine's profile"), self._folder(), tr("Profiles (*.toml)"))
        dialog.setObjectName(f"{NAME}_machine_file")
        dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
        dialog.fileSelected.connect(guarded(self.take))
        dialog.finished.connect(lambda _: dialog.deleteLater())
        dialog.open()

    def take(self, path: str) -> None:
        """Choose a profile's file; one beside the document is named from there, so that both can move."""
        folder = self._folder()
        inside = folder and Path(path).is_relative_to(folder)
        name = Path(path).relative_to(folder).as_posix() if inside else path
        self._offer(name)
        self.editors[0].setCurrentIndex(self.values.index(name))
        super().touched()

    def write(self) -> None:
        """Show the job's machine, whether there is such a profile or not."""
        self._offer(value_of(self.obj, self.entry))
        super().write()

    def _offer(self, name: str) -> None:
        if name not in self.values:
            self.values.append(name)
            self.editors[0].addItem(name)

    def _folder(self) -> str:
        file = self.obj.Document.FileName
        return str(Path(file).parent) if file else ""


class MaterialField(ChoiceField):
    """A material of the table, or none."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return none, and the materials by their names."""
        from CNCStepper.machine.materials import material_names

        return [("", tr("not given")), *((name, words_of(name)) for name in material_names())]


class DialectField(ChoiceField):
    """The machine's own dialect, or another one that we write."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the machine's own and the dialects that programs are written in."""
        from CNCStepper.gcode.dialects import dialect, dialect_names

        names = [name for name in dialect_names() if dialect(name).writing is not None]
        return [("", words_of("")), *((name, dialect(name).title) for name in names)]
