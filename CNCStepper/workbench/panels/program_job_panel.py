# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the task panels of all jobs have: the job's own values, its operations, its tools with the marked one below."""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.panels.fields import Field
from CNCStepper.workbench.panels.job_lists import ObjectList, OperationList, ToolList
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.task_panel import Panel
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.translation import later

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
        self.tools.list.currentRowChanged.connect(guarded(self.show_tool))
        for part in self.lists:
            part.changed.connect(guarded(self.remake))
        self.editor.applied.connect(guarded(self.operations.refresh))
        self.tools.choose(next(iter(job.Tools), None))

    def add_own_parts(self) -> None:
        """Add what only this kind of job has, above operations and tools."""

    def own_lists(self) -> tuple[ObjectList, ...]:
        """Return the lists that only this kind of job has."""
        return ()

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
