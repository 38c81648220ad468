# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a job's process: machine, process, material, consumable, chart, and the values that the chart gives.

machine ──► processes that it can do ──► materials of the chart ──► consumables ──► row: feed, kerf, pierce, power
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from PySide import QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.processes import MILLING, PROCESSES
from CNCStepper.workbench.features.base import value_of
from CNCStepper.workbench.features.cut_values import CUT_VALUES
from CNCStepper.workbench.features.tool import FORM, LIMITS, Tool
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME, ChoiceField, NumberField, note_label
from CNCStepper.workbench.panels.unit_values import text_of
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later, tr

FROM_FILE = object()  # the choice that asks for a file
CHART_COLOUR = "#7d8790"  # of a value that the chart gives
OF_CUTTERS = ("made_of", "spindle_rpm", "used_spindle_rpm", "used_plunge_mm_min")  # what a jet or wire does not have


class FileField(ChoiceField):
    """One of those that ship with us, or a file. FILE_CHOICE, TITLE, FILTER: words of the choice and its dialog."""

    FILE_CHOICE = TITLE = FILTER = ""

    def shipped(self) -> list[tuple[Any, str]]:
        """Return those that ship, with their words."""
        raise NotImplementedError

    def choices(self) -> list[tuple[Any, str]]:
        """Return those that ship, and the choice that asks for a file."""
        return [*self.shipped(), (FROM_FILE, tr(self.FILE_CHOICE))]

    def touched(self) -> None:
        """Take what is chosen, or ask for its file."""
        if self.read() is FROM_FILE:
            self.write()
            self.ask()
        else:
            super().touched()

    def ask(self) -> None:
        """Ask for a file, and return at once."""
        dialog = QtGui.QFileDialog(self.widget, tr(self.TITLE), self._folder(), tr(self.FILTER))
        dialog.setObjectName(f"{NAME}_{self.entry.key}_file")
        dialog.setFileMode(QtGui.QFileDialog.FileMode.ExistingFile)
        dialog.fileSelected.connect(guarded(self.take))
        dialog.finished.connect(lambda _: dialog.deleteLater())
        dialog.open()

    def take(self, path: str) -> None:
        """Choose a file; one beside the document is named from there, so that both can move."""
        folder = self._folder()
        inside = folder and Path(path).is_relative_to(folder)
        name = Path(path).relative_to(folder).as_posix() if inside else path
        self._offer(name)
        self.editors[0].setCurrentIndex(self.values.index(name))
        self.touched()

    def write(self) -> None:
        """Show the job's own, whether there is such a file or not."""
        self._offer(value_of(self.obj, self.entry))
        super().write()

    def _offer(self, name: str) -> None:
        if name not in self.values:
            self.values.append(name)
            self.editors[0].addItem(name)

    def _folder(self) -> str:
        file = self.obj.Document.FileName
        return str(Path(file).parent) if file else ""


class MachineField(FileField):
    """A profile that ships with us, or a profile's file."""

    FILE_CHOICE, TITLE = later("A profile's file…"), later("A machine's profile")
    FILTER = later("Profiles (*.toml)")

    def shipped(self) -> list[tuple[Any, str]]:
        """Return the profiles that ship and the user's own, by their names."""
        from CNCStepper.machine.own_profiles import label_of, profiles

        return [(profile.name, label_of(profile.name, words_of)) for profile in profiles()]

    def touched(self) -> None:
        """Take the chosen profile, with a process that it can do."""
        chosen = self.read()
        if isinstance(chosen, str) and (process := self.parent().fields.get("process")) is not None:
            process.suit(chosen)
        super().touched()


class ChartFileField(FileField):
    """The chart that ships with us, or a file of the shop's own."""

    FILE_CHOICE, TITLE = later("A chart's file…"), later("A cut chart")
    FILTER = later("Cut charts (*.toml *.cfg)")

    def shipped(self) -> list[tuple[Any, str]]:
        """Return the chart that ships."""
        return [("", tr("the one that ships"))]


class ProcessField(ChoiceField):
    """The processes; those that the machine lacks are disabled and show the reason."""

    def refresh(self) -> None:
        """Show the job's process, and which others its machine can do."""
        super().refresh()
        if not self.edited:
            self._limit(_machine(self.obj.Machine, self.obj))

    def touched(self) -> None:
        """Take the chosen process, with a material that its chart has."""
        self._choose_material(self.read())
        super().touched()

    def suit(self, machine_name: str) -> None:
        """Choose a process that a machine can do, where it cannot do the present one."""
        machine = _machine(machine_name, self.obj)
        self._limit(machine)
        if machine is not None and self.read() not in machine.processes:
            self.editors[0].setCurrentIndex(self.values.index(machine.processes[0]))
            self._choose_material(machine.processes[0])
            self.edited = True

    def _limit(self, machine: Any) -> None:
        for row, name in enumerate(self.values):
            item = self.editors[0].model().item(row)
            able = machine is None or name in machine.processes
            item.setEnabled(able)
            item.setToolTip("" if able else tr("{0} does not name this process").format(machine.name))

    def _choose_material(self, process: str) -> None:
        material: MaterialField = self.parent().fields["material"]
        material.offer(process)


class MaterialField(ChoiceField):
    """A material: of the table for milling, of the cut chart for other processes."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return none, and the materials by their names."""
        return _material_choices(self.obj.Process, self.obj)

    def refresh(self) -> None:
        """Show the job's material among those of its process and chart."""
        if not self.edited and [value for value, _ in self.choices()] != self.values:
            self.fill(self.editors[0])
        super().refresh()

    def write(self) -> None:
        """Show the job's material, whether the chart has it or not."""
        own = value_of(self.obj, self.entry)
        if own not in self.values:
            self.values.append(own)
            self.editors[0].addItem(words_of(own))
        super().write()

    def offer(self, process: str) -> None:
        """Offer the materials of a process, and choose one that it can cut in the thickness of the stock."""
        from CNCStepper.workbench.document.cut_chart_of_job import best_material
        from CNCStepper.workbench.document.stock_of_job import size_mm

        pairs = _material_choices(process, self.obj)
        self.values = [value for value, _ in pairs]
        self.editors[0].clear()
        self.editors[0].addItems([words for _, words in pairs])
        present = value_of(self.obj, self.entry)
        rows = _rows(process, self.obj)
        wanted = best_material(rows, size_mm(self.obj)[2], present) if rows else present
        self.editors[0].setCurrentIndex(self.values.index(wanted) if wanted in self.values else 0)
        self.edited = True


class ConsumableField(ChoiceField):
    """A consumable of the cut chart, or the first that does."""

    def choices(self) -> list[tuple[Any, str]]:
        """Return the first that does, and those of the chart for the job's material."""
        from CNCStepper.workbench.document.cut_chart_of_job import consumables_of

        try:
            names = consumables_of(self.obj)
        except CNCStepperError:  # said beside the chart
            names = []
        own = [self.obj.Consumable] if self.obj.Consumable and self.obj.Consumable not in names else []
        return [("", tr("first of the chart")), *((name, words_of(name)) for name in [*names, *own])]

    def refresh(self) -> None:
        """Show the job's consumable among those of its chart."""
        if not self.edited and [value for value, _ in self.choices()] != self.values:
            self.fill(self.editors[0])
        super().refresh()


class ChartValueField(NumberField):
    """A value of the chart, grey until a person types another one; a button then takes the chart's again."""

    def __init__(self, obj: Any, entry: Any, parent: Any):
        super().__init__(obj, entry, parent)
        self.name = f"{NAME}_cut_{entry.key}"  # the tool's editor in the same panel has a feed, too
        self.editors[0].setObjectName(self.name)

    def make(self) -> list[Any]:
        """Add the line, and beside it what takes the chart's value again."""
        row = QtGui.QHBoxLayout()
        row.setSpacing(3)
        self._column.addLayout(row)
        line = self.line(layout=row)
        line.setPlaceholderText("–")
        self.reset = QtGui.QToolButton(self.widget)
        self.reset.setObjectName(f"{NAME}_cut_{self.entry.key}_reset")
        self.reset.setIcon(self.reset.style().standardIcon(QtGui.QStyle.StandardPixmap.SP_BrowserReload))
        self.reset.setToolTip(tr("Take the chart's value again"))
        self.reset.setAccessibleName(tr("Take the chart's value again"))
        self.reset.setAutoRaise(True)
        self.reset.clicked.connect(guarded(self.take_chart))
        row.addWidget(self.reset)
        return [line]

    def write(self) -> None:
        """Show the job's own value, else the chart's."""
        own = value_of(self.obj, self.entry)
        shown = own or self._of_chart()
        self.editors[0].setText(text_of(shown, self.entry) if shown else "")
        self._show_origin(bool(own))

    def touched(self) -> None:
        """Note that a person types a value of his own."""
        self._show_origin(True)
        super().touched()

    def read(self) -> Any:
        """Return the value, 0 for an empty line: the chart's."""
        return super().read() if self.editors[0].text().strip() else 0.0

    def take_chart(self) -> None:
        """Take the chart's value again."""
        self.editors[0].clear()
        self.touched()

    def _of_chart(self) -> float:
        from CNCStepper.workbench.document.cut_chart_of_job import chart_row, cut_data_of

        try:
            row = cut_data_of(self.obj) if self.entry.key == "kerf_mm" else chart_row(self.obj)
            return float(getattr(row, self.entry.key)) if row is not None else 0.0
        except CNCStepperError:  # said in the note of the chart
            return 0.0

    def _show_origin(self, is_own: bool) -> None:
        self.reset.setVisible(is_own)
        palette = QtGui.QPalette(self.widget.palette())
        if not is_own:
            palette.setColor(QtGui.QPalette.ColorRole.Text, QtGui.QColor(CHART_COLOUR))
        self.editors[0].setPalette(palette)


class ChartNote(QtGui.QWidget):
    """Shows which values are the chart's, or why it has none."""

    def __init__(self, job: Any, parent: Any):
        super().__init__(parent)
        self.job = job
        self.note = note_label(f"{NAME}_chart_note", ERROR_COLOUR, self)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.hint = note_label(f"{NAME}_chart_hint", CHART_COLOUR, self)
        self.hint.setText(tr("Grey values are from the chart; typed values replace them"))
        for label in (self.note, self.hint):
            column.addWidget(label)
        self.refresh()

    def refresh(self) -> None:
        """Say what is so now."""
        sentence = self._why_no_row()
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))
        self.hint.setVisible(not sentence)

    def _why_no_row(self) -> str:
        from CNCStepper.workbench.document.cut_chart_of_job import cut_data_of

        if self.job.Process == MILLING.name:
            return ""
        try:
            row = cut_data_of(self.job)
        except CNCStepperError as error:
            return translated(error.sentence)
        return "" if row is not None else tr("Choose a material: the chart then gives feed and kerf")


def tool_hidden(job: Any) -> tuple[str, ...]:
    """Return the keys of tools that the process of a job has no use for."""
    process = PROCESSES[job.Process]
    if not process.uses_chart:
        return ()
    if not process.is_thermal:
        return OF_CUTTERS
    unused = [entry.key for entry in Tool.PROPERTIES if entry.group in (FORM, LIMITS) and entry.key != "taper_deg"]
    return (*unused, *OF_CUTTERS, "plunge_mm_min")


def _machine(name: str, job: Any) -> Any:
    """Return the machine of a name, None where it cannot be read: that is said beside the field."""
    from CNCStepper.workbench.document.machine_of_job import machine_named

    try:
        return machine_named(name, job)
    except CNCStepperError:
        return None


def _rows(process: str, job: Any) -> Sequence[Any]:
    from CNCStepper.workbench.document.cut_chart_of_job import rows_for

    try:
        return rows_for(process, job)
    except CNCStepperError:  # said in the note of the chart
        return ()


def _material_choices(process: str, job: Any) -> list[tuple[Any, str]]:
    from CNCStepper.machine.materials import material_names

    charted = dict.fromkeys(row.material for row in _rows(process, job))
    names = list(charted) if PROCESSES[process].uses_chart else material_names()
    return [("", tr("not given")), *((name, words_of(name)) for name in names)]


PROCESS_KINDS = {
    "process": ProcessField,
    "material": MaterialField,
    "consumable": ConsumableField,
    "chart": ChartFileField,
    **{entry.key: ChartValueField for entry in CUT_VALUES},
}
