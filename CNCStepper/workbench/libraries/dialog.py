# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog of tools, materials and cut charts, a page each; what is typed stays until it is saved or reverted."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import FreeCADGui
from PySide import QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.machine.libraries.chart_library import CHARTED, ChartLibrary
from CNCStepper.machine.libraries.material_library import MaterialLibrary
from CNCStepper.machine.libraries.table_draft import Library
from CNCStepper.machine.libraries.tool_library import ToolLibrary
from CNCStepper.workbench.document import targets
from CNCStepper.workbench.document.tools import library_of_job
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.libraries.library_page import Page
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.event_steps import in_events
from CNCStepper.workbench.services.front_window import in_front
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Library"
SIZE = (1000, 600)
GUIDE = "libraries.md"


class Libraries(QtGui.QDialog):
    """See the module."""

    is_made = False  # whether all pages are there

    def __init__(self, parent: Any):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Tools and materials"))
        f1_key.attach(self, GUIDE)
        self.resize(*SIZE)
        self.pages: dict[Page, str] = {}
        self._shown_process = 0
        self.tabs = QtGui.QTabWidget(self)
        self.tabs.setObjectName(f"{NAME}_tabs")
        column = QtGui.QVBoxLayout(self)
        column.addWidget(self.tabs)

    def make_pages(self) -> Iterator[None]:
        """Make the pages, a step each: all at once would keep the window too long."""
        self.tools = self._page(ToolLibrary(), "tools", tr("Tools"))
        tip = tr("Save, and add the marked tools to the job")
        self.to_job = self.tools.button("to_job", tr("Add to job"), tip, self.add_to_job)
        yield
        self.materials = self._page(MaterialLibrary(), "materials", tr("Materials"))
        yield
        self.charts = self._page(ChartLibrary(CHARTED[0]), "charts", tr("Cut charts"))
        self._add_processes()
        self.is_made = True

    def _page(self, library: Library, name: str, title: str) -> Page:
        page = Page(library, f"{NAME}_{name}", self)
        self.pages[page] = title
        page.table.setAccessibleName(title)
        self.tabs.addTab(page, title)
        return page

    def look(self) -> None:
        """Show the files as they are now, where nothing was typed; and whether there is a job to add tools to."""
        for page in self.pages:
            if not page.draft.is_changed:
                page.revert()
        self.to_job.setEnabled(not targets.why_no_job())

    def look_in_front(self) -> None:
        """Do what `look` does, and show the dialog in front."""
        self.look()
        in_front(self)

    def add_to_job(self) -> None:
        """Add the marked tools to the job as one undo step; what was typed is saved before."""
        job, rows = targets.job(), self.tools.rows()
        if not rows or job is None or self.tools.model.problems:
            return
        if self.tools.draft.is_changed:
            self.tools.save()
        found = self.tools.draft.judged()[0]
        count = library_of_job.add_as_one_step(job, [found[row][1] for row in rows], tr("Add tool"))
        messages.note(tr("{0} tools imported").format(count))

    def closeEvent(self, event: Any) -> None:
        """Close, unless somebody thinks better of losing what was typed; FreeCAD's Esc comes here too."""
        event.accept() if self._may_close() else event.ignore()

    def reject(self) -> None:
        """Close, as Esc does."""
        self.close()

    def _may_close(self) -> bool:
        changed = [page for page in self.pages if page.draft.is_changed]
        if not changed:
            return True
        answers = {"discard": (tr("Discard"), "Destructive"), "cancel": (tr("Cancel"), "Reject")}
        text = tr("These tables have changes that are not saved: {0}").format(
            ", ".join(self.pages[page] for page in changed)
        )
        if messages.choose(f"{NAME}_closing", "Warning", self.windowTitle(), text, answers, "cancel") == "cancel":
            return False
        for page in changed:
            page.revert()
        return True

    def _add_processes(self) -> None:
        """Let a person choose the process whose chart is shown."""
        self.process = QtGui.QComboBox(self.charts)
        self.process.setObjectName(f"{NAME}_charts_process")
        self.process.setAccessibleName(tr("Process"))
        for name in CHARTED:
            self.process.addItem(words_of(name), name)
        self.charts.head.insertWidget(0, self.process)
        self.process.activated.connect(guarded(lambda *_: self._show_chart()))

    def _show_chart(self) -> None:
        """Show the chart of the process that is chosen; one that was changed has to be saved or reverted first."""
        if self.charts.draft.is_changed:
            self.process.setCurrentIndex(self._shown_process)
            messages.note(tr("Save or revert this chart first"))
            return
        try:
            self.charts.show_library(ChartLibrary(self.process.itemData(self.process.currentIndex())))
        except CNCStepperError as error:
            messages.error(error)
            return
        self._shown_process = self.process.currentIndex()


def shown() -> Libraries:
    """Return the dialog, made at its first opening; it is shown when all its pages are there."""
    window = FreeCADGui.getMainWindow()
    found = window.findChild(QtGui.QDialog, NAME)
    if not isinstance(found, Libraries):
        made = Libraries(window)
        in_events(made.make_pages(), made.look_in_front)
        return made
    if found.is_made:
        found.look_in_front()
    return found
