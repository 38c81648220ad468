# SPDX-License-Identifier: LGPL-2.1-or-later
"""The panel of an object whose content a process makes beside the window: OK waits for it, Cancel ends it."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.panels.fields import NAME, WorkNote, named_button
from CNCStepper.workbench.panels.object_form import Editor
from CNCStepper.workbench.panels.task_panel import Panel
from CNCStepper.workbench.services.button_row import ButtonRow
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.view_fit import show_all


class Work(Protocol):
    """What is made beside the window."""

    def begin(self) -> None:
        """Ask the process; raises CNCStepperError for a bad value."""

    def end(self) -> None:
        """Make nothing any more."""


class BackgroundPanel(Panel):
    """All that is made while the panel is open belongs to its one undo step.

    work: what is under way. refused: whether it could not be made. is_new: nothing was made yet; what is new is
    brought into view.
    """

    def __init__(self, obj: Any, editor: Editor, note: WorkNote, is_new: bool):
        super().__init__(obj, editor)
        self.obj, self.editor, self.note = obj, editor, note
        self.work: Work | None = None
        self.refused = False
        self._is_new = is_new
        self._closing = False  # OK was pressed while it was made

    def begin(self, work: Work, words: str) -> None:
        """Begin a work, in place of the one that is under way; what stands in its way is said below the form."""
        if self.work is not None:
            self.work.end()
        self.refused = False
        self.say("")
        self.work = work
        self.note.say(words)
        self.note.begin()
        try:
            work.begin()
        except CNCStepperError as error:
            self.failed(error)

    def accept(self) -> bool:
        """Keep all as one undo step, as soon as it is made; stay open where it could not be."""
        self.editor.apply()
        if self.work is not None:
            self._closing = True
            return False
        return not self.refused and bool(super().accept())

    def reject(self) -> bool:
        """Leave the document as it was before."""
        if self.work is not None:
            self.work.end()
            self.work = None
        return bool(super().reject())

    def done(self) -> None:
        """Show what was made, and close where OK was pressed."""
        self._end()
        if self._is_new:
            self._is_new = False
            show_all()
        self.editor.refresh()
        self.refresh_report()
        if self._closing:
            self._closing = False
            self.accept()

    def failed(self, error: CNCStepperError) -> None:
        """Say why it could not be made."""
        self._end()
        self.refused, self._closing = True, False
        self.say(translated(error.sentence))

    def refresh_report(self) -> None:
        """Show what the object knows of what was made."""
        raise NotImplementedError

    def say(self, sentence: str) -> None:
        """Say what is wrong, below the form; "" says nothing."""
        self.editor.problem.setText(sentence)
        self.editor.problem.setVisible(bool(sentence))

    def _end(self) -> None:
        self.work = None
        self.note.end()


def button_row(texts: tuple[tuple[str, str, str, Callable[[], None]], ...], parent: Any) -> ButtonRow:
    """Return a row of buttons, each by its name, text, tooltip and what it does."""
    row = ButtonRow(parent)
    for name, text, tip, act in texts:
        row.add(named_button(f"{NAME}_{name}", text, tip, act, row))
    return row
