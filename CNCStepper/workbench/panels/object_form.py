# SPDX-License-Identifier: LGPL-2.1-or-later
"""An object and the form that edits it: valid changes go into the object at once.

    typed ──► read ──► judged by the core's model ──► cut and written by a process of its own ──► written, shown
               │       and by what the job can hold                 │
               └── refused ─────┴──────── said beside the field ────┘

The process (`cutting`) makes what changes before anything is written. Typing goes on meanwhile; the last value wins.
So the object and its program are always those of the last good values; the picture follows when the keys pause.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.errors import CNCStepperError
from CNCStepper.workbench.calculation import deferred_drawing, kernel_warmup
from CNCStepper.workbench.calculation.cut_process import CutRequest, process
from CNCStepper.workbench.calculation.precalculation import Look, look_at
from CNCStepper.workbench.calculation.recompute import remake, steps
from CNCStepper.workbench.features.base import FAILED, STALE, edit, named, problem_of, proxy_type, values
from CNCStepper.workbench.features.cycle_operation import OPERATION_GROUP, CycleOperation
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.help.topics import object_address
from CNCStepper.workbench.panels import remedies
from CNCStepper.workbench.panels.field_errors import (
    beyond,
    complaints,
    key_of,
    labelled,
    model_of_type,
    stock_findings_of,
)
from CNCStepper.workbench.panels.fields import (
    ERROR_COLOUR,
    NAME,
    WARNING_COLOUR,
    Field,
    bring_into_view,
    note_label,
)
from CNCStepper.workbench.panels.form import Form
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.panels.operations.planned_times import PlannedTimes
from CNCStepper.workbench.panels.operations.preset_row import PresetRow, preset_entries
from CNCStepper.workbench.panels.unit_values import text_of
from CNCStepper.workbench.services.findings_list import sentence
from CNCStepper.workbench.services.jit_guard import LONG, WAITS
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.number_format import planned_text
from CNCStepper.workbench.services.remedy_bar import RemedyBar
from CNCStepper.workbench.services.translation import tr

PAUSE_MS = 20  # between two keys of one that types fast
LONGEST_TIME = "88:88:88"  # as a panel shows it
DONE = object()
STEPS_S = 0.005  # so long are objects made before the window sees to its events


class Editor(QtGui.QWidget):
    """A form with the cut's warnings and the errors of no single field; `applied` is sent at each recompute."""

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
        self.of_stock = note_label(f"{NAME}_of_stock", WARNING_COLOUR, self)  # at the top: it must be seen while typing
        self.warnings = note_label(f"{NAME}_warnings", WARNING_COLOUR, self)
        self.problem = note_label(f"{NAME}_problem", ERROR_COLOUR, self)
        self.timer = QtCore.QTimer(self)
        self.timer.setSingleShot(True)
        self.timer.setInterval(PAUSE_MS)
        self.timer.timeout.connect(guarded(self.apply))
        self.form.changed.connect(self._typed)
        if run := kernel_warmup.running():
            run.ended.connect(self.timer.start)  # what had to wait is made now
        self.refused = False  # whether the object could not be made from what stands here
        self.waiting = False  # whether what stands here is being cut
        self.then: Callable[[], Any] | None = None  # what is to happen when it is
        self.good: dict[str, Any] = {}  # the last values with which the object could be made
        self._stale = True  # whether objects have changed besides what is typed here
        self._steps: Iterator[Any] | None = None  # of making what was written last
        self._again = False  # something was typed meanwhile
        self._changed: list[str] = []  # the keys of what was written last
        self._asked: dict[str, Any] = {}  # the values that the process is cutting
        self._taken: dict[str, Any] = {}  # what a button has found, and is not written yet
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.mends = {name: RemedyBar(self) for name in ("stock", "warnings", "refusal")}
        order = (self.of_stock, "stock", self.form, self.warnings, "warnings", self.problem, "refusal")
        for widget in (self.mends[part] if isinstance(part, str) else part for part in order):
            column.addWidget(widget)
        self._show_time()
        self._show_presets()
        self._gone = gone = [False]  # FreeCAD may close the panel without OK or Cancel, as it does with a document
        self.destroyed.connect(lambda: gone.__setitem__(0, True))
        f1_key.attach(self, object_address(proxy_type(obj)))
        process().prepare()
        self.form.refresh()
        self.apply()

    def _show_time(self) -> None:
        """Give an operation a line with its planned time, which follows what is typed."""
        self.times: PlannedTimes | None = None
        if not isinstance(self.obj.Proxy, CycleOperation):
            return
        tip = tr("The planned time of its own moves; the way to them and the tool change are not in it")
        line = self.form.add_result(OPERATION_GROUP, "time", tr("Time"), tip)
        line.setMinimumWidth(line.fontMetrics().boundingRect(LONGEST_TIME).width())  # the time comes later
        self.times = times = PlannedTimes(lambda: [self.obj], self)
        times.changed.connect(lambda: line.setText(planned_text(times.time_s(self.obj))))
        line.setText(planned_text(0.0))

    def _show_presets(self) -> None:
        """Give an operation the row of its presets."""
        if isinstance(self.obj.Proxy, CycleOperation) and preset_entries(self.obj):
            self.presets = PresetRow(self, self)
            self.form.add_widget(OPERATION_GROUP, self.presets)

    def flush(self) -> bool:
        """Apply what was typed last; return whether all is good, else the keyboard is where it is not, or why is seen.

        What is still being cut is not good yet: `waiting` says so.
        """
        self.apply()
        marked = [field for field in self.form.field_order() if field.said]
        if marked:
            marked[0].focus()
        elif self.refused:
            self._show_refusal()
        return not marked and not self.refused and not self.waiting

    def _show_refusal(self) -> None:
        """Scroll to why the object cannot be made: the end of a long panel lies below what is shown."""

        def show() -> None:
            if not self._gone[0]:
                bring_into_view(self.problem)

        QtCore.QTimer.singleShot(0, guarded(show))

    def stop(self) -> None:
        """Let nothing reach the object any more: it may be gone before the form is."""
        self.timer.stop()
        self.timer.blockSignals(True)
        self.waiting, self.then, self._steps = False, None, None
        process().forget(self)
        for times in self.findChildren(PlannedTimes):
            times.stop()
        for field in self.form.fields.values():
            for editor in field.editors:
                editor.blockSignals(True)

    def apply(self) -> None:
        """Write the valid edits, recompute, and show the errors of the others.

        What takes a cut is asked of the process first, and written when it has answered.
        """
        self.timer.stop()
        if self._steps is not None:
            self._again = True
            return
        begun_s = time.thread_time()
        self.form.unmark()
        self.mends["refusal"].show_remedies(())
        changes = {**self._taken, **self._accepted(self._read())}
        tried = {key: value for key, value in changes.items() if self.form.fields[key].differs(value)}
        if self.waiting and tried == self._asked:
            return
        look = Look()
        if tried or self._stale:
            look = look_at(self.obj.Document, self.obj, tried, self._warn_of_stock)
        self._wait(look, tried)
        if self.waiting:
            return
        self._taken = {}
        if tried and (error := look.refusals.get(self.obj.Name)) is not None and error.code not in (FAILED, STALE):
            self._refuse(error, list(changes))
            self._settled()
        else:
            self._write(tried, list(changes), begun_s)

    def take(self, changes: dict[str, Any]) -> None:
        """Write values that a button has found, in place of what a person has typed into their fields."""
        for key in changes:
            self.form.fields[key].edited = False
        self._taken = dict(changes)
        self.apply()

    def remake(self) -> None:
        """Make what has changed in the document besides what is typed here."""
        self._stale, self.waiting = True, False
        self.apply()

    def _wait(self, look: Look, tried: dict[str, Any]) -> None:
        """Ask the process what is not known yet, and show that it works; or show no longer that it does."""
        self.waiting, self._asked = bool(look.unknown), tried
        for field in self.form.fields.values():
            field.show_work(self.waiting and field.entry.key in tried)
        if self.waiting:
            process().ask(self, CutRequest(look.unknown, self._show_stage, self._answered))
        else:
            process().forget(self)

    def _answered(self) -> None:
        """Let the keys that wait go first: reading a long answer takes a while, and so does applying it."""
        QtCore.QTimer.singleShot(0, guarded(self._take_answer))

    def _take_answer(self) -> None:
        """Apply what stands here now, of which the process may have made all, or ask for the rest."""
        if not self._gone[0]:
            self.waiting = False
            self.apply()

    def _show_stage(self, words: str) -> None:
        for field in () if self._gone[0] else self.form.fields.values():
            field.show_stage(tr(words))

    def _settled(self) -> None:
        """Tell that nothing is waited for, and do what was to happen then."""
        self.applied.emit()
        if self.times is not None:
            self.times.look()
        then, self.then = self.then, None
        if then is not None and self.refused:
            self._show_refusal()
        elif then is not None:
            then()

    def _write(self, tried: dict[str, Any], changed: list[str], begun_s: float) -> None:
        """Write values and make what they change, which the process has cut."""
        if tried:
            edit(self.obj, **tried)
        for key in changed:  # now: what is typed while objects are made is newer
            self.form.fields[key].edited = False
        self._steps = steps(self.obj.Document, deferred_drawing.leave) if tried or self._stale else iter(())
        self._changed, self._stale = changed, False
        self._step(begun_s)

    def _step(self, begun_s: float | None = None) -> None:
        """Make some objects, and more when the window has seen to its events; then judge what became of them."""
        if self._steps is None or self._gone[0]:  # the panel has been closed
            return
        until_s = (begun_s or time.thread_time()) + STEPS_S
        while time.thread_time() < until_s:
            if next(self._steps, DONE) is DONE:
                self._made()
                return
        self.waiting = True
        QtCore.QTimer.singleShot(0, guarded(lambda: self._step()))

    def _made(self) -> None:
        """Judge what became of what was written, and take up what was typed meanwhile."""
        self._steps, self.waiting = None, False
        deferred_drawing.draw_soon(self.obj.Document)
        self._judge(self._changed)
        self._settled()
        if self._again:
            self._again = False
            self.timer.start()

    def _refuse(self, error: CNCStepperError, changed: list[str]) -> None:
        """Say why values cannot be; nothing of them was written."""
        self.refused = True
        self._say(self.problem, "")
        self._tell(error, changed)
        self.refresh()

    def refresh(self) -> None:
        """Show the object's present values."""
        self.form.refresh()
        warnings = getattr(self.obj.Proxy, "warnings", ())
        self._say(self.warnings, "\n".join(map(self._labelled, warnings)))
        mends = remedies.of_feeds(self.obj, self.remake) if warnings else []
        self.mends["warnings"].show_remedies(mends)

    def _typed(self) -> None:
        """Apply what is typed when the keys pause; who has pressed OK before wants to see it."""
        self.then = None
        deferred_drawing.hold()
        self.timer.start()

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
        wrong = {**beyond(self.obj, changes, self._shown), **wrong}
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
            self._keep()
        else:
            for key in changed:
                self.form.fields[key].edited = True
            self._tell(error, changed)
            if self.good:
                edit(self.obj, **self.good)
                self._recompute()
        self.refresh()

    def _keep(self) -> None:
        self.good = {key: value for key, value in values(self.obj).items() if key in self.form.fields}
        self._say(self.problem, self._caused_elsewhere())

    def _tell(self, error: CNCStepperError, changed: list[str]) -> None:
        """Say an error beside the field that it speaks of, or at the bottom."""
        key = key_of(error, changed) or key_of(error, self.form.fields)
        words = self._labelled(error.sentence)
        mends = remedies.of_refusal(self.obj, error, self.take)
        if key:
            self.form.mark(key, words, mends)
        else:
            self._say(self.problem, words)
            self.mends["refusal"].show_remedies(mends)

    def _labelled(self, sentence: str) -> str:
        """Return what the core says in the user's language, with the labels of the fields in place of their keys."""
        return labelled(translated(sentence), {key: field.label.text() for key, field in self.form.fields.items()})

    def _own_refusal(self) -> CNCStepperError | None:
        """Return why the object itself cannot be made; what another object has caused is not mended here, nor
        what only has to wait."""
        error = self.obj.Proxy.refusal
        return None if error is None or error.code in (FAILED, STALE, WAITS, LONG) else error

    def _caused_elsewhere(self) -> str:
        """Return what stands in the way of the program though this object is good, "" when nothing does."""
        if self.obj.Proxy.refusal is not None:
            return translated(self.obj.Proxy.refusal.sentence)
        above = [other for other in self.obj.InList if problem_of(other)]
        own = [other for other in above if other.Proxy.refusal is None or other.Proxy.refusal.code != FAILED]
        return named(own[0], translated(problem_of(own[0]))) if own else ""

    def _warn_of_stock(self) -> None:
        """Say what the values that stand in the object do not fit the stock; the cut may take long."""
        findings = stock_findings_of(self.obj)
        self._say(self.of_stock, "\n".join(map(sentence, findings)))
        beyond_stock = [(finding.code, finding.limit) for finding in findings]
        self.mends["stock"].show_remedies(remedies.of_stock(self.obj, beyond_stock, self.take, self.remake))

    def _recompute(self) -> None:
        remake(self.obj.Document)

    def _mark(self, key: str, refused: Refused) -> None:
        self.form.mark(key, tr(refused.sentence).format(*map(translated, refused.values)))

    def _shown(self, key: str, number: float) -> str:
        return text_of(number, self._entry(key))

    def _entry(self, key: str) -> Any:
        return self.form.fields[key].entry

    def _say(self, label: Any, sentence: str) -> None:
        label.setText(sentence)
        label.setVisible(bool(sentence))
