# SPDX-License-Identifier: LGPL-2.1-or-later
"""An object and the form that edits it: what a person changes goes into the object as soon as it is good.

    typed ──► read ──► judged by the core's model ──► written, recomputed ──► judged by the cut itself
               │                │                                                 │
               └── refused ─────┴──── said beside the field, not written          └── taken back, said

So the object, its program and its picture are always those of the last good values.
"""

from __future__ import annotations

from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench import warming
from CNCStepper.workbench.features.base import FAILED, edit, named, problem_of, values
from CNCStepper.workbench.panels.complaints import complaints, key_of, labelled, model_of_type
from CNCStepper.workbench.panels.fields import ERROR_COLOUR, NAME, WARNING_COLOUR, Field, note_label
from CNCStepper.workbench.panels.form import Form
from CNCStepper.workbench.panels.measures import text_of
from CNCStepper.workbench.panels.numbers import Refused
from CNCStepper.workbench.patience import WAITS
from CNCStepper.workbench.remake import remake
from CNCStepper.workbench.sentences import translated
from CNCStepper.workbench.tell import guarded
from CNCStepper.workbench.words import tr

PAUSE_MS = 20  # between two keys of one that types fast


class Editor(QtGui.QWidget):
    """A form, what the cut warns of, and what is wrong with no single field; `applied` tells of each recompute."""

    applied = QtCore.Signal()

    def __init__(
        self,
        obj: Any,
        kinds: dict[str, type[Field]],
        folded: tuple[str, ...] = (),
        hidden: tuple[str, ...] = (),
        parent: Any = None,
    ):
        super().__init__(parent)
        self.obj = obj
        self.form = Form(obj, kinds, folded, hidden, self)
        self.warnings = note_label(f"{NAME}_warnings", WARNING_COLOUR, self)
        self.problem = note_label(f"{NAME}_problem", ERROR_COLOUR, self)
        self.timer = QtCore.QTimer(self)
        self.timer.setSingleShot(True)
        self.timer.setInterval(PAUSE_MS)
        self.timer.timeout.connect(guarded(self.apply))
        self.form.changed.connect(self.timer.start)
        if run := warming.running():
            run.ended.connect(self.timer.start)  # what had to wait is made now
        self.refused = False  # whether the object could not be made from what stands here
        self.good: dict[str, Any] = {}  # the last values with which the object could be made
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        for widget in (self.form, self.warnings, self.problem):
            column.addWidget(widget)
        self._recompute()
        self._judge([])

    def flush(self) -> bool:
        """Apply what was typed last; return whether all is good, else the keyboard is where it is not."""
        self.apply()
        marked = [field for field in self.form.field_order() if field.note.text()]
        if marked:
            marked[0].focus()
        return not marked and not self.refused

    def stop(self) -> None:
        """Let nothing reach the object any more: it may be gone before the form is."""
        self.timer.stop()
        self.timer.blockSignals(True)
        for field in self.form.fields.values():
            for editor in field.editors:
                editor.blockSignals(True)

    def apply(self) -> None:
        """Write what is good of what a person has changed, recompute, and say what is not."""
        self.timer.stop()
        self.form.unmark()
        changes = self._accepted(self._read())
        tried = [key for key, value in changes.items() if self.form.fields[key].differs(value)]
        if tried:
            edit(self.obj, **{key: changes[key] for key in tried})
            self._recompute()
        self._judge(list(changes))
        self.applied.emit()

    def take(self, changes: dict[str, Any]) -> None:
        """Write values that a button has found, in place of what a person has typed into their fields."""
        for key in changes:
            self.form.fields[key].edited = False
        edit(self.obj, **changes)
        self._recompute()
        self.form.unmark()
        self._judge(list(changes))
        self.applied.emit()

    def refresh(self) -> None:
        """Show what stands in the object now."""
        self.form.refresh()
        self._say(self.warnings, "\n".join(map(self._labelled, getattr(self.obj.Proxy, "warnings", ()))))

    def _read(self) -> dict[str, Any]:
        """Return what the changed fields say, by key; those that say nothing sensible are marked."""
        found = {}
        for key, field in self.form.fields.items():
            if field.edited:
                try:
                    found[key] = field.read()
                except Refused as refused:
                    self._mark(key, refused)
        return found

    def _accepted(self, changes: dict[str, Any]) -> dict[str, Any]:
        """Return those changes that the core's model has nothing against; the others are marked."""
        model = model_of_type(self.obj)
        wrong = complaints(model, self._given(changes), self._shown) if model and changes else {}
        for key in wrong.keys() & changes.keys():
            self._mark(key, wrong[key])
        return {key: value for key, value in changes.items() if key not in wrong}

    def _given(self, changes: dict[str, Any]) -> dict[str, Any]:
        return dict(self.obj.Proxy.given(values(self.obj) | changes))

    def _judge(self, changed: list[str]) -> None:
        """Keep what could be made as good; take back what could not, and say why."""
        error = self._own_refusal()
        self.refused = error is not None
        self._say(self.problem, "")
        if error is None:
            self._keep(changed)
        else:
            self._tell(error, changed)
            if self.good:
                edit(self.obj, **self.good)
                self._recompute()
        self.refresh()

    def _keep(self, changed: list[str]) -> None:
        self.good = {key: value for key, value in values(self.obj).items() if key in self.form.fields}
        for key in changed:
            self.form.fields[key].edited = False
        self._say(self.problem, self._caused_elsewhere())

    def _tell(self, error: CNCStepperError, changed: list[str]) -> None:
        """Say an error beside the field that it speaks of, or at the bottom."""
        key = key_of(error, changed) or key_of(error, self.form.fields)
        sentence = self._labelled(error.sentence)
        if key:
            self.form.mark(key, sentence)
        else:
            self._say(self.problem, sentence)

    def _labelled(self, sentence: str) -> str:
        """Return what the core says in the user's language, with the labels of the fields in place of their keys."""
        return labelled(translated(sentence), {key: field.label.text() for key, field in self.form.fields.items()})

    def _own_refusal(self) -> CNCStepperError | None:
        """Return why the object itself cannot be made; what another object has caused is not mended here, nor
        what only has to wait."""
        error = self.obj.Proxy.refusal
        return None if error is None or error.code in (FAILED, WAITS) else error

    def _caused_elsewhere(self) -> str:
        """Return what stands in the way of the program though this object is good, "" when nothing does."""
        if self.obj.Proxy.refusal is not None:
            return translated(self.obj.Proxy.refusal.sentence)
        above = [other for other in self.obj.InList if problem_of(other)]
        own = [other for other in above if other.Proxy.refusal is None or other.Proxy.refusal.code != FAILED]
        return named(own[0], translated(problem_of(own[0]))) if own else ""

    def _recompute(self) -> None:
        remake(self.obj.Document)

    def _mark(self, key: str, refused: Refused) -> None:
        self.form.mark(key, tr(refused.sentence).format(*refused.values))

    def _shown(self, key: str, number: float) -> str:
        return text_of(number, self._entry(key))

    def _entry(self, key: str) -> Any:
        return self.form.fields[key].entry

    def _say(self, label: Any, sentence: str) -> None:
        label.setText(sentence)
        label.setVisible(bool(sentence))
