# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dialog with the tools of a template: the table of the libraries, which OK puts into the template."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.libraries.library_page import TablePage
from CNCStepper.workbench.services.translation import tr
from CNCStepper.workbench.templates.draft import Draft
from CNCStepper.workbench.templates.tool_table import TemplateTools

NAME = "CNCStepper_Template_tools"
GUIDE = "freecad.md"
SIZE = (900, 400)


class TemplateToolDialog(QtGui.QDialog):
    """See the module; `done` is called when the draft has the tools."""

    def __init__(self, draft: Draft, done: Callable[[], None], parent: Any):
        super().__init__(parent)
        self._done = done
        self.setObjectName(NAME)
        self.setWindowTitle(tr("Tools of the template"))
        self.setAttribute(QtCore.Qt.WidgetAttribute.WA_DeleteOnClose)
        f1_key.attach(self, GUIDE)
        self.resize(*SIZE)
        self.page = TablePage(TemplateTools(draft), NAME, self)
        self.page.button("cancel", tr("Cancel"), tr("Leave the tools as they were"), lambda: self.reject())
        self.page.button("ok", tr("OK"), tr("Take these tools into the template"), self.take)
        QtGui.QVBoxLayout(self).addWidget(self.page)

    def take(self) -> None:
        """Put the tools into the template, unless a cell is wrong, which the page says."""
        if self.page.model.problems:
            return
        self.page.draft.save()
        self._done()
        self.accept()


def open_template_tools(draft: Draft, done: Callable[[], None], parent: Any) -> None:
    """Show the tools of a template, and return at once; `done` is called when they are changed."""
    TemplateToolDialog(draft, done, parent).open()
