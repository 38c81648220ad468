# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels of all jobs have: the job's own values, its operations, its tools with the marked one below."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from PySide import QtCore

from CNCStepper.workbench.panels.fields import Field
from CNCStepper.workbench.panels.job_lists import ObjectList, OperationList, ToolList
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.task_panel import Panel
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.translation import later, tr
from CNCStepper.workbench.templates.begin_with import BeginWith
from CNCStepper.workbench.templates.beginning import Beginning

OPERATIONS, TOOLS = later("Operations"), later("Tools")


class ProgramJobPanel(Panel):
    """The panel of a job; the marked tool has an editor of its own in it."""

    def __init__(self, job: Any, kinds: dict[str, type[Field]], folded: tuple[str, ...], hidden: tuple[str, ...]):
        self.job = job
        self.editor = Editor(job, kinds, folded, hidden)
        super().__init__(job, self.editor)
        self.add_own_parts()
        self.operations = OperationList(job, self.editor)
        self.tools = ToolList(job, self.editor)
        self.lists: tuple[ObjectList, ...] = (*self.own_lists(), self.operations, self.tools)
        self.editor.form.add_widget(OPERATIONS, self.operations)
        self.editor.form.add_widget(TOOLS, self.tools)
        self.editor.form.box(OPERATIONS).setVisible(bool(job.Operations))
        self.tools.choose(next(iter(job.Tools), None))
        self.tools.list.currentRowChanged.connect(guarded(self.show_tool))
        for part in self.lists:
            part.changed.connect(guarded(self.remake))
        self.editor.applied.connect(guarded(self.operations.refresh))
        self._show_tool_soon()

    def _show_tool_soon(self) -> None:
        """Show the marked tool's editor in an event of its own: the panel takes long enough by itself."""
        timer = QtCore.QTimer(self.editor)  # it goes with the panel
        timer.setSingleShot(True)
        timer.timeout.connect(guarded(lambda: None if self._closed else self.show_tool()))
        timer.start(0)

    def add_own_parts(self) -> None:
        """Add what only this kind of job has, above operations and tools."""

    def own_lists(self) -> tuple[ObjectList, ...]:
        """Return the lists that only this kind of job has."""
        return ()

    def offer_beginnings(self, beginning: Beginning, choices: Sequence[tuple[str, str]]) -> None:
        """Put on top what a new job can begin with: what is preferred, or a template (paths and words)."""
        self.beginning = beginning
        self.beginnings = BeginWith(choices, self.begin, self.editor)
        self.editor.layout().insertWidget(0, self.beginnings)

    def begin(self, path: str) -> bool:
        """Let a new job begin with a template, or with what is preferred (""); return whether it does.

        Raises CNCStepperError for a template that cannot be used, and then changes nothing.
        """
        good = [editor.flush() for editor in self.editors]
        if not all(good):
            self._begin_later(path)
            return False
        self.tools.list.setCurrentRow(-1)  # a tool that goes has no editor
        try:
            self.beginning.take(path)
        finally:
            self.has_begun()
            self.tools.refresh()
            self.tools.choose(next(iter(self.job.Tools), None))
            self.remake()
        return True

    def has_begun(self) -> None:
        """Note what only this kind of job has, after a beginning."""

    def _begin_later(self, path: str) -> None:
        """Begin when what was typed last is applied; where it cannot be, say so."""
        waiting = [editor for editor in self.editors if editor.waiting]
        if waiting:
            waiting[0].then = lambda: self.beginnings.begin(self.beginnings.choice.findData(path))
        else:
            note(tr("Correct the marked values first"))

    def tool_form(self, tool: Any) -> Editor:
        """Return the editor of a tool."""
        raise NotImplementedError

    def remake(self) -> None:
        """Recompute after a list was changed, and show all as it is now."""
        self.editor.remake()
        for part in self.lists:
            part.refresh()

    def show_tool(self) -> None:
        """Show the marked tool's editor below the list; the one before keeps its place while something is wrong."""
        tool = self.tools.chosen()
        shown = self.editors[1:]
        if shown and shown[0].obj is tool:
            return
        if shown and shown[0].obj in self.job.Tools and not shown[0].flush():
            self.tools.choose(shown[0].obj)
            return
        self.drop_tool()
        if tool is not None:
            editor = self.tool_form(tool)
            editor.applied.connect(guarded(self._tool_changed))
            self.tools.layout().addWidget(editor)
            self.editors.append(editor)

    def drop_tool(self) -> None:
        """Show no tool's editor any more."""
        for editor in self.editors[1:]:
            editor.stop()
            editor.setParent(None)
            editor.deleteLater()
        self.editors[1:] = []

    def _tool_changed(self) -> None:
        self.tools.refresh()
        self.operations.refresh()
        self.editor.refresh()
