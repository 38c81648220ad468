# SPDX-License-Identifier: LGPL-2.1-or-later
"""The editor: text, refusals, status line and 3D view, held together. Reading is done by another process.

typing ──► edit.changed ──► reader.change ──► read: marks, list ──► timed: path in the 3D view
cursor ──► reader.ask line ──► status line, way in the 3D view       click in the 3D view ──► pick ──► cursor
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.editor import file_dialogs
from CNCStepper.workbench.editor.edit_menu import CONVERT, Verbs
from CNCStepper.workbench.editor.error_list import RefusalList
from CNCStepper.workbench.editor.find_replace import FindBar
from CNCStepper.workbench.editor.model.syntax_colours import word_at
from CNCStepper.workbench.editor.reader_client import ProgramReader
from CNCStepper.workbench.editor.status_line import StatusLine
from CNCStepper.workbench.editor.text_edit import ProgramEdit
from CNCStepper.workbench.editor.toolbar import EditorBar
from CNCStepper.workbench.editor.view_session import EditorStage
from CNCStepper.workbench.help import f1_key
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.object_observers import ProgramObserver
from CNCStepper.workbench.services.translation import tr

if TYPE_CHECKING:
    from CNCStepper.errors import CNCStepperError
    from CNCStepper.workbench.editor.model.error_marks import Mark

SEND_AFTER_MS = 40  # of rest: letters that follow each other faster are sent together
NAME = "CNCStepper_Editor_"


class EditorPanel(QtGui.QWidget):
    """The widget of one edited text; `title_changed` is sent when its name or whether it is saved changes."""

    title_changed = QtCore.Signal()

    def __init__(self, source: Any, parent: Any = None):
        text = source.text()
        super().__init__(parent)
        self.setObjectName("CNCStepper_Editor")
        f1_key.attach(self, "editing.md")
        self.source = source
        self.edit = ProgramEdit()
        self.reader = ProgramReader(self.text, self)
        self.stage = EditorStage(lambda pick: self.reader.ask({"pick": pick}))
        self.duration_s: float | None = None
        self.timed_mark = 0  # of the newest text whose times are known
        self.shown_way: list[list[list[float]]] = []  # of the cursor's line, in the 3D view
        self._sender = QtCore.QTimer(self)
        self._sender.setSingleShot(True)
        self._sender.setInterval(SEND_AFTER_MS)
        changed, closing = messages.guarded(self._source_changed), messages.guarded(self._document_closing)
        self._watch = ProgramObserver(None, changed, lambda: None, closing)
        self._arrange()
        self._connect()
        self._open(text)

    # ---- the text ----

    def _open(self, text: str) -> None:
        """Put the source's text into the editor."""
        self._watch.obj = self.source.obj
        self.bar.choose_machine(self.source)
        self._text = text
        self.edit.fill(text)
        self.reader.begin(self._language())
        self.title_changed.emit()

    def text(self) -> str:
        """Return the whole text."""
        return self._text if self.edit.filling else str(self.edit.toPlainText())

    @property
    def modified(self) -> bool:
        """Whether something is not saved."""
        return bool(self.edit.document().isModified())

    @property
    def title(self) -> str:
        """The name of the text, with a star while something is not saved."""
        return self.source.name + (" *" if self.modified else "")

    def save(self) -> bool:
        """Save where the text came from, or ask for a file; whether all is saved now."""
        if self.edit.filling:
            return False
        if not self.source.alive or (self._is_file and self.source.path is None):
            return self.save_as()
        self._saved(self.source.save(self.text()))
        return True

    def save_as(self) -> bool:
        """Ask for a file and save there; whether that was done."""
        path = file_dialogs.ask_where_to(self.source)
        if path is None:
            return False
        self._saved(file_dialogs.in_file(self.source, path).save(self.text()))
        return True

    def may_close(self) -> bool:
        """Ask what becomes of a text that is not saved; whether the editor may go."""
        if not self.modified:
            return True
        answer = file_dialogs.ask_to_save(self.source.name)
        return self.save() if answer == "save" else answer == "discard"

    def end(self) -> None:
        """Leave nothing behind."""
        self._sender.stop()
        self._watch.end()
        self.stage.clear()
        self.reader.forget()

    # ---- inside ----

    @property
    def _is_file(self) -> bool:
        return self.source.obj is None

    def _language(self) -> Any:
        from CNCStepper.machine.profile import load_machine

        machine = load_machine(self.bar.machine) if self._is_file else None
        return self.source.language(machine)

    def _saved(self, source: Any) -> None:
        self.source = source
        self._watch.obj = source.obj
        self.edit.document().setModified(False)
        self.bar.choose_machine(source)
        self._say("")
        messages.note(tr("Saved {0}").format(source.name))
        self.title_changed.emit()

    def send_typed(self) -> None:
        """Tell the process at once which lines have changed, and ask about the cursor's."""
        self._sender.stop()
        change = self.edit.take_change()
        if change is not None:
            self.reader.change(change.first, change.removed, self.edit.lines(change.first, change.added))
            self.duration_s = None
        self._ask_line()

    def _ask_line(self) -> None:
        self.reader.ask({"line": self.edit.line})

    def _filled(self) -> None:
        self._text = ""
        self._ask_line()
        self._show_cursor()

    def _read(self, answer: dict[str, Any]) -> None:
        self.edit.marks.take(answer["refusals"])
        self._show_refusals(answer["refused"])

    def _timed(self, answer: dict[str, Any]) -> None:
        self.timed_mark, self.duration_s = answer["timed"], answer["duration_s"]
        path = self.reader.folder / answer["path"]
        self.stage.show(self.source, path)
        path.unlink(missing_ok=True)
        self._ask_line()

    def _sendable(self, answer: dict[str, Any]) -> None:
        """Mark what only fails when it is sent."""
        if answer["refusals"]:
            self.edit.marks.take(answer["refusals"])
            self._show_refusals(len(answer["refusals"]))

    def _show_refusals(self, count: int) -> None:
        self.edit.show_marks()
        self.refusals.show_marks(self.edit.marks.all)
        self.convert.setVisible(bool(count))
        self.bar.show_count(count)
        self._show_cursor()

    def _at_line(self, answer: dict[str, Any]) -> None:
        if answer["line"] == self.edit.line:
            self.status.show_answer(answer, self.duration_s)
            self.shown_way = answer["way"]
            self.stage.show_line(self.shown_way)

    def _picked(self, answer: dict[str, Any]) -> None:
        """Put the cursor on the line whose way was clicked."""
        if answer["pick"] is not None:
            self.edit.go_to(answer["pick"])
            self.edit.setFocus()

    def _failed(self, error: CNCStepperError) -> None:
        self._say("\n".join(part for part in (messages.sentence(error), translated(error.advice)) if part))

    def _cursor_moved(self) -> None:
        self._show_cursor()
        if self.edit.far_from_change:
            self.send_typed()
        elif not self.edit.filling:
            self._sender.start()

    def _show_cursor(self) -> None:
        word = word_at(self.edit.textCursor().block().text(), self.edit.column - 1)
        line = self.edit.line
        self.status.show_cursor(line, self.edit.column, word, self.edit.marks.at(line))

    def _go_to_mark(self, mark: Mark) -> None:
        self.edit.go_to(mark.line, max(mark.column, 1))
        self.edit.setFocus()

    def _handle(self, request: str) -> None:
        """Do what a key asks for."""
        requests = {"save": self.save, "find": self.find.begin, "find_next": self.find.next}
        requests.get(request, self.find.before)()

    def _source_changed(self) -> None:
        """Follow a program that was made anew or undone, unless that would lose what was typed."""
        QtCore.QTimer.singleShot(0, messages.guarded(self._follow_source))

    def _follow_source(self) -> None:
        if not self.source.alive or self.edit.filling:
            return
        text = self.source.text()
        if text.rstrip("\n") == self.text().rstrip("\n"):
            return
        if self.modified:
            self._say(tr("{0} has changed in the document; your typed values are kept here").format(self.source.name))
        elif text:
            self._open(text)

    def _document_closing(self, name: str) -> None:
        """Let go of the 3D view of a document that goes; the text stays here."""
        if self._is_file or self.source.document_name == name:
            self.stage.clear()

    def _say(self, text: str) -> None:
        self._message.setText(text)
        self._message.setVisible(bool(text))

    def _connect(self) -> None:
        guarded, edit, reader = messages.guarded, self.edit, self.reader
        self._sender.timeout.connect(guarded(self.send_typed))
        edit.changed.connect(self._sender.start)
        edit.filled.connect(guarded(self._filled))
        edit.cursorPositionChanged.connect(guarded(self._cursor_moved))
        edit.wanted.connect(guarded(self._handle))
        edit.document().modificationChanged.connect(lambda _: self.title_changed.emit())
        reader.read.connect(guarded(self._read))
        reader.timed.connect(guarded(self._timed))
        reader.sendable.connect(guarded(self._sendable))
        reader.at_line.connect(guarded(self._at_line))
        reader.picked.connect(guarded(self._picked))
        reader.failed.connect(guarded(self._failed))
        self.refusals.chosen.connect(guarded(self._go_to_mark))
        self.convert.clicked.connect(guarded(lambda: self.verbs.trigger(CONVERT)))
        self.find.said.connect(guarded(self._say))
        self.bar.save.connect(guarded(self.save))
        self.bar.save_as.connect(guarded(self.save_as))
        self.bar.find.connect(guarded(self.find.begin))
        self.bar.machine_changed.connect(guarded(lambda: self.reader.begin(self._language())))

    def _arrange(self) -> None:
        self.verbs = Verbs(self, self.edit, self.reader, self.send_typed)
        self.bar = EditorBar(self.verbs.menu)
        self.find = FindBar(self.edit)
        self.refusals = RefusalList()
        self.convert = QtGui.QPushButton(tr("Convert for this machine…"))
        self.convert.setObjectName(NAME + "convert")
        self.convert.setToolTip(
            tr("Shows the same program as this machine's controller reads it: M6 becomes the machine's tool change")
        )
        self.convert.hide()
        self.status = StatusLine()
        self._message = QtGui.QLabel()
        self._message.setObjectName(NAME + "message")
        self._message.setWordWrap(True)
        self._message.hide()
        split = QtGui.QSplitter(QtCore.Qt.Orientation.Vertical)
        split.setChildrenCollapsible(False)
        split.addWidget(self.edit)
        split.addWidget(self.refusals)
        split.setStretchFactor(0, 4)
        layout = QtGui.QVBoxLayout(self)
        layout.setContentsMargins(2, 2, 2, 2)
        layout.setSpacing(2)
        for widget in (self.bar, self._message):
            layout.addWidget(widget)
        layout.addWidget(split, 1)
        for widget in (self.convert, self.find, self.status):
            layout.addWidget(widget)
