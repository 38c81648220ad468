# SPDX-License-Identifier: LGPL-2.1-or-later
"""The lists of a job's panel: its operations in the order of cutting, and its tools."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError, Text
from CNCStepper.workbench import api
from CNCStepper.workbench.document import default_values
from CNCStepper.workbench.document.clamps import outline_of
from CNCStepper.workbench.features.base import edit, is_tool, problem_of, proxy_type
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME, WARNING_COLOUR, named_button, note_label
from CNCStepper.workbench.panels.operations.planned_times import PlannedTimes
from CNCStepper.workbench.panels.tools.tool_words import tool_words
from CNCStepper.workbench.services.button_row import ButtonRow
from CNCStepper.workbench.services.icons import icon
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.number_format import planned_text
from CNCStepper.workbench.services.theme_colours import letters
from CNCStepper.workbench.services.translation import later, tr

FEWEST_ROWS, MOST_ROWS = 2, 5  # that are seen at once
ICON_PX = 16
SPARE_PX = 6  # with less Qt shows a scroll bar: what a style adds is not known before the list is seen
CUTTER = "CNCStepper_Tool"
TITLES = {"operations": later("Operations"), "tools": later("Tools"), "clamps": later("Clamps")}
CHECKED, UNCHECKED = QtCore.Qt.CheckState.Checked, QtCore.Qt.CheckState.Unchecked


class ObjectList(QtGui.QWidget):
    """A list of document objects with buttons below it."""

    changed = QtCore.Signal()  # the job has been changed here

    def __init__(self, job: Any, name: str, parent: Any):
        super().__init__(parent)
        self.job = job
        self.name = f"{NAME}_{name}"
        self.list = QtGui.QListWidget(self)
        self.list.setObjectName(self.name)
        self.list.setAccessibleName(tr(TITLES[name]))
        self.list.setIconSize(QtCore.QSize(ICON_PX, ICON_PX))
        self.list.setHorizontalScrollBarPolicy(QtCore.Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.note = note_label(f"{self.name}_error", ERROR_COLOUR, self)
        self.buttons = ButtonRow(self)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(3)
        column.addWidget(self.list)
        column.addWidget(self.note)
        column.addWidget(self.buttons)

    def objects(self) -> list[Any]:
        """Return the objects of the list, in order."""
        raise NotImplementedError

    def chosen(self) -> Any:
        """Return the object that is marked in the list, or None."""
        row = self.list.currentRow()
        return self.objects()[row] if 0 <= row < len(self.objects()) else None

    def choose(self, obj: Any) -> None:
        """Mark an object in the list."""
        self.list.setCurrentRow(self.objects().index(obj) if obj in self.objects() else -1)

    def button(self, name: str, text: str, tip: str, act: Callable[[], None]) -> Any:
        """Add a button below the list."""
        return self.buttons.add(named_button(f"{self.name}_{name}", text, tip, act, self.buttons))

    def say(self, sentence: str) -> None:
        """Say below the list why something was not done."""
        self.note.setText(sentence)
        self.note.setVisible(bool(sentence))

    def refresh(self) -> None:
        """Show the objects as they are now; the marked one stays marked."""
        row = self.list.currentRow()
        self.list.blockSignals(True)
        self.list.clear()
        for obj in self.objects():
            item = QtGui.QListWidgetItem(self.picture(obj), self.words(obj))
            if problem_of(obj):
                item.setForeground(QtGui.QColor(letters(ERROR_COLOUR)))
                item.setToolTip(translated(problem_of(obj)))
            self.show_details(item, obj)
            self.list.addItem(item)
        self.list.setCurrentRow(min(row, self.list.count() - 1))
        self.list.blockSignals(False)
        least_px = self.fontMetrics().height() + SPARE_PX
        rows = range(min(max(self.list.count(), FEWEST_ROWS), MOST_ROWS))
        rows_px = sum(max(self.list.sizeHintForRow(row), least_px) for row in rows)
        self.list.setFixedHeight(rows_px + 2 * self.list.frameWidth() + SPARE_PX)

    def words(self, obj: Any) -> str:
        """Return how an object is listed."""
        return str(obj.Label)

    def picture(self, obj: Any) -> Any:
        """Return the icon of an object."""
        return icon(proxy_type(obj))

    def show_details(self, item: Any, obj: Any) -> None:
        """Give an entry what else it shows."""


class OperationList(ObjectList):
    """The operations in the order in which they are cut, each with tool, time and warnings; checked: in the program."""

    def __init__(self, job: Any, parent: Any):
        super().__init__(job, "operations", parent)
        self.total = QtGui.QLabel(self)
        self.total.setObjectName(f"{self.name}_total")
        self.total.setWordWrap(True)
        self.total.setToolTip(
            tr("The planned times of the checked operations, without tool changes and the ways between")
        )
        self.layout().insertWidget(1, self.total)
        self.times = PlannedTimes(self.objects, self)
        self.times.changed.connect(guarded(self.refresh))
        self.list.setToolTip(tr("Cut in this order; unchecked operations are left out of the program"))
        self.button("up", tr("Earlier"), tr("Cut it before the one above"), lambda: self.move(-1))
        self.button("down", tr("Later"), tr("Cut it after the one below"), lambda: self.move(1))
        self.list.itemChanged.connect(guarded(self.switch))
        self.refresh()

    def objects(self) -> list[Any]:
        """Return the job's operations."""
        return list(self.job.Operations)

    def words(self, obj: Any) -> str:
        """Return an operation's label, below it tool and time, below them how many warnings it has."""
        tool = f"T{obj.Tool.Number}" if is_tool(obj.Tool) else tr("no tool")
        lines = [str(obj.Label), f"{tool} · {planned_text(self.times.time_s(obj))}"]
        count = len(_warnings_of(obj))
        return "\n".join([*lines, *([tr("{0} warnings").format(count)] if count else [])])

    def refresh(self) -> None:
        """Show the operations as they are now, and the time of all that are checked."""
        super().refresh()
        self.times.look()
        times_s = [self.times.time_s(operation) for operation in self.objects() if operation.Active]
        self.total.setText(tr("Together {0}").format(planned_text(sum(times_s) if all(times_s) else 0.0)))

    def show_details(self, item: Any, obj: Any) -> None:
        """Let an entry be checked; its tooltip has the whole name of the tool and the warnings."""
        item.setFlags(item.flags() | QtCore.Qt.ItemFlag.ItemIsUserCheckable)
        item.setCheckState(CHECKED if obj.Active else UNCHECKED)
        if problem_of(obj):
            return
        warnings = _warnings_of(obj)
        item.setToolTip("\n".join([tool_words(obj.Tool) if is_tool(obj.Tool) else "", *warnings]).strip())
        if warnings:
            item.setForeground(QtGui.QColor(letters(WARNING_COLOUR)))

    def move(self, by: int) -> None:
        """Cut the marked operation earlier or later."""
        order, row = self.objects(), self.list.currentRow()
        if row < 0 or not 0 <= row + by < len(order):
            return
        order.insert(row + by, order.pop(row))
        edit(self.job, operations=order)
        self.list.setCurrentRow(row + by)
        self.changed.emit()

    def switch(self, item: Any) -> None:
        """Take an operation into the program, or leave it out."""
        edit(self.objects()[self.list.row(item)], active=item.checkState() == CHECKED)
        self.changed.emit()


def _warnings_of(operation: Any) -> list[str]:
    """Return in the user's language what the last cut of an operation says that a person should know."""
    return [translated(warning) for warning in operation.Proxy.warnings]


class ToolList(ObjectList):
    """The tools that the job's operations may choose from."""

    def __init__(self, job: Any, parent: Any):
        super().__init__(job, "tools", parent)
        self.button("add", tr("Add tool"), tr("Add a tool to this job"), self.add)
        self.button("remove", tr("Remove tool"), tr("Delete the marked tool"), self.remove)
        if job.Proxy.TOOL == CUTTER:  # FreeCAD's library and tool tables hold no inserts
            tip = tr("Add the tools of FreeCAD's library or of a tool table")
            self.button("import", tr("Import…"), tip, self.import_)
            tip = tr("Add a tool of your own library, or keep the marked one there")
            self.library = self.button("library", tr("Library…"), tip, self.show_library)
        self.refresh()

    def objects(self) -> list[Any]:
        """Return the job's tools."""
        return list(self.job.Tools)

    def words(self, obj: Any) -> str:
        """Return a tool's number, diameter and form."""
        return tool_words(obj)

    def picture(self, obj: Any) -> Any:
        """Return the icon of a tool's shape, as the tree has it."""
        return icon(obj.ViewObject.Proxy.icon_name())

    def add(self) -> None:
        """Add a tool with the next free number, and mark it."""
        is_cutter = self.job.Proxy.TOOL == CUTTER
        tool = api.add_tool(self.job, **(default_values.tool(self.job) if is_cutter else {}))
        self.say("")
        self.refresh()
        self.choose(tool)
        self.changed.emit()

    def show_library(self) -> None:
        """List the tools of the user's library in a menu, and that the marked tool can be kept there."""
        from CNCStepper.workbench.document.tools import library_of_job

        menu = QtGui.QMenu(self.library)
        menu.setObjectName(f"{self.name}_library_menu")
        for stored in library_of_job.library_tools():
            entry = menu.addAction(f"T{stored.number}  {stored.name}")
            entry.setObjectName("stored")
            entry.triggered.connect(guarded(lambda *_, stored=stored: self.take_stored(stored)))
        menu.addSeparator()
        keep = menu.addAction(tr("Keep the marked tool"))
        keep.setObjectName("keep")
        keep.setEnabled(self.chosen() is not None)
        keep.triggered.connect(guarded(lambda *_: self.keep()))
        menu.popup(self.library.mapToGlobal(self.library.rect().bottomLeft()))

    def take_stored(self, stored: Any) -> None:
        """Add a tool of the library, and mark it."""
        api.add_stored_tool(self.job, stored)
        self.imported()

    def keep(self) -> None:
        """Put a copy of the marked tool into the user's library."""
        from CNCStepper.workbench.document.tools import library_of_job

        note(tr("{0} is tool {1} of the library").format(self.chosen().Label, library_of_job.keep(self.chosen())))

    def import_(self) -> None:
        """Ask for a file of tools, and list them."""
        from CNCStepper.workbench.document.tools import tool_import

        tool_import.ask(self.job, self.imported)

    def imported(self) -> None:
        """List the tools that have come, and mark the last."""
        self.say("")
        self.refresh()
        self.choose(self.job.Tools[-1])
        self.changed.emit()

    def remove(self) -> None:
        """Delete the marked tool, unless an operation needs it."""
        tool = self.chosen()
        if tool is None:
            return
        users = [other.Label for other in tool.InList if proxy_type(other) != proxy_type(self.job)]
        if users:
            self.say(tr("{0} is cut with it; choose another tool there first").format(users[0]))
            return
        self.say("")
        edit(self.job, tools=[other for other in self.job.Tools if other is not tool])
        self.list.setCurrentRow(-1)
        tool.Document.removeObject(tool.Name)
        self.refresh()
        self.choose(next(iter(self.objects()), None))
        self.changed.emit()


class ClampList(ObjectList):
    """The clamps, numbered as findings name them."""

    def __init__(self, job: Any, parent: Any):
        super().__init__(job, "clamps", parent)
        self.list.setToolTip(tr("Solids that the tool must not touch; findings name them by their number"))
        self.button("add", tr("Add selected"), tr("Take the solids that are selected for clamps"), self.add)
        self.button("remove", tr("Take out"), tr("The marked solid is no clamp any more; it stays"), self.remove)
        self.refresh()

    def objects(self) -> list[Any]:
        """Return the job's clamps."""
        return list(self.job.Clamps)

    def words(self, obj: Any) -> str:
        """Return a clamp's number and label."""
        return f"{self.objects().index(obj) + 1}  {obj.Label}"

    def picture(self, obj: Any) -> Any:
        """Return FreeCAD's own icon of the solid."""
        return obj.ViewObject.Icon

    def add(self) -> None:
        """Take the selected solids; what is none is named, and then nothing is taken."""
        import FreeCADGui

        chosen = [obj for obj in FreeCADGui.Selection.getSelection() if obj not in self.job.Clamps]
        self.say("" if chosen else tr("Select one or more solids first"))
        try:
            for obj in chosen:
                self._check(obj)
        except CNCStepperError as error:
            self.say(translated(error.what))
            return
        if chosen:
            edit(self.job, clamps=[*self.job.Clamps, *chosen])
            self._show(chosen[-1])

    def remove(self) -> None:
        """Take the marked solid out of the list."""
        clamp = self.chosen()
        if clamp is not None:
            self.say("")
            left = [other for other in self.job.Clamps if other is not clamp]
            edit(self.job, clamps=left)
            self._show(left[-1] if left else None)

    def _check(self, obj: Any) -> None:
        """Raise JobError for what cannot be a clamp."""
        from CNCStepper.errors import JobError

        if self.job in [obj, *obj.OutListRecursive]:
            what = Text("'{obj}' stands on this job and cannot be its clamp", obj=obj.Label)
            advice = "choose a solid that does not depend on the job"
            raise JobError("clamp", what, advice=advice)
        outline_of(obj)

    def _show(self, clamp: Any) -> None:
        self.refresh()
        self.choose(clamp)
        self.changed.emit()
