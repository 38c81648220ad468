# SPDX-License-Identifier: LGPL-2.1-or-later
"""The fields of a form, one class for each kind of property: shown, read, and marked with errors."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.features.base import (
    BOOL,
    ENUMERATION,
    INTEGER,
    POSITION,
    TEXT,
    Property,
    value_of,
)
from CNCStepper.workbench.help.f1_key import set_key
from CNCStepper.workbench.panels.number_input import Refused
from CNCStepper.workbench.panels.unit_values import measure_of, text_of, value_of_text, whole_of_text
from CNCStepper.workbench.services.choice_labels import words_of
from CNCStepper.workbench.services.messages import guarded
from CNCStepper.workbench.services.remedy_bar import Remedy, RemedyBar
from CNCStepper.workbench.services.theme_colours import ERROR, WARNING, letters
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Panel"
ERROR_COLOUR, WARNING_COLOUR = ERROR, WARNING
FRAME = "border: 1px solid #d32f2f; border-radius: 2px;"  # of what is wrong
NOTE_SIZE = 0.9  # of the usual letters
AXES = "XYZ"
SEEN_AFTER_MS = 300  # what takes less is not worth a flicker
WORK_BAR_PX = 4
GAP_PX = 2  # above and below a field


def named_button(name: str, text: str, tip: str, act: Callable[[], None], parent: Any) -> Any:
    """Return a button of that objectName, which Return does not press."""
    button = QtGui.QPushButton(text, parent)
    button.setObjectName(name)
    button.setToolTip(tip)
    button.setAutoDefault(False)
    button.clicked.connect(guarded(act))
    return button


class WorkNote(QtGui.QWidget):
    """A progress line, which is shown only when a calculation takes a while."""

    def __init__(self, name: str, parent: Any):
        super().__init__(parent)
        self.setObjectName(name)
        self.hide()
        self._words = ""
        self._label: Any = None
        self._timer = QtCore.QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(SEEN_AFTER_MS)
        self._timer.timeout.connect(self._show)

    def begin(self) -> None:
        """Be seen in a moment, unless it ends before."""
        if not self.isVisible() and not self._timer.isActive():
            self._timer.start()

    def end(self) -> None:
        """Be seen no longer."""
        self._timer.stop()
        self._words = ""
        self.hide()

    def say(self, words: str) -> None:
        """Say what is being done."""
        self._words = words
        if self._label is not None:
            self._label.setText(words)

    def _show(self) -> None:
        if self._label is None:
            self._make()
        self._label.setText(self._words or tr("Waiting for the cut…"))
        self.show()

    def _make(self) -> None:
        """Make what is seen, at the first need: most fields never show it."""
        self._label = QtGui.QLabel(self)
        self._label.setTextFormat(QtCore.Qt.TextFormat.PlainText)
        bar = QtGui.QProgressBar(self)
        bar.setRange(0, 0)  # how long a cut takes is not known before
        bar.setTextVisible(False)
        bar.setFixedHeight(WORK_BAR_PX)
        column = QtGui.QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(1)
        column.addWidget(bar)
        column.addWidget(self._label)


class Field(QtCore.QObject):
    """One property in a form: `widget` with the note below it. `changed` is sent after an edit by the user."""

    changed = QtCore.Signal()
    BELOW_LABEL = False  # whether it is as wide as the form

    def __init__(self, obj: Any, entry: Property, parent: Any):
        super().__init__(parent)
        self.obj = obj
        self.entry = entry
        self.name = f"{NAME}_{entry.key}"  # how the names of its widgets begin
        self.edited = False  # what stands here is not yet in the object
        self._note: NoteLabel | None = None  # this and the next two are made at the first need: few fields show them
        self._work: WorkNote | None = None
        self._mends: RemedyBar | None = None
        self.widget = QtGui.QWidget(parent)
        self.label = QtGui.QLabel(tr(entry.label), parent)
        self.label.setContentsMargins(0, GAP_PX, 0, GAP_PX)
        self._column = QtGui.QVBoxLayout(self.widget)
        self._column.setContentsMargins(0, GAP_PX, 0, GAP_PX)
        self._column.setSpacing(1)
        self.editors = self.make()
        self._explain()
        set_key(self.widget, entry.key)

    def make(self) -> list[Any]:
        """Add the widgets that are typed into or chosen from, and return them."""
        raise NotImplementedError

    def read(self) -> Any:
        """Return the field's value, in the unit of the key; raises Refused."""
        raise NotImplementedError

    def write(self) -> None:
        """Show the object's value."""
        raise NotImplementedError

    def differs(self, value: Any) -> bool:
        """Return whether writing a value would change the object."""
        return bool(value != value_of(self.obj, self.entry))

    def refresh(self) -> None:
        """Show the object's value, unless a person is just changing it here; let it rest where it is not his.

        A field whose value does not count is not seen.
        """
        reason = self._why_fixed()
        self.show(self.counts())
        for editor in self.editors:
            editor.setEnabled(not reason)
        self.widget.setToolTip(reason)
        if not self.edited and (reason or not self.has_focus()):
            self.write()

    def counts(self) -> bool:
        """Return whether the value counts with the object's others."""
        return "Hidden" not in self.obj.getEditorMode(self.entry.name)

    def asks(self) -> bool:
        """Return whether a value is missing that a person should give: its group is then unfolded."""
        return False

    def show(self, seen: bool) -> None:
        """Let the field and its label be seen, or not."""
        for part in (self.label, self.widget):
            part.setVisible(seen)

    @property
    def said(self) -> str:
        """What is said below the field to be wrong with it."""
        return "" if self._note is None else str(self._note.text())

    def mark(self, sentence: str, remedies: Sequence[Remedy] = ()) -> None:
        """Say below the field what is wrong with it, with the remedies as buttons; "" takes it back."""
        if sentence and self._note is None:
            self._note = note_label(f"{self.name}_error", ERROR_COLOUR, self.widget)
            self._column.addWidget(self._note)
        if self._note is not None:
            self._note.setText(sentence)
            self._note.setVisible(bool(sentence))
        if remedies and self._mends is None:
            self._mends = RemedyBar(self.widget)
            self._column.addWidget(self._mends)
        if self._mends is not None:
            self._mends.show_remedies(remedies)
        for editor in self.editors:
            # by its name: else the list that it opens, and its tooltip, would have the frame too
            editor.setStyleSheet(f"#{editor.objectName()} {{ {FRAME} }}" if sentence else "")

    def show_work(self, working: bool) -> None:
        """Show below the field, after a moment, that what stands there is being cut; or no longer."""
        if working and self._work is None:
            self._work = WorkNote(f"{self.name}_work", self.widget)
            self._column.insertWidget(self._column.indexOf(self._note) if self._note else -1, self._work)
        if self._work is not None:
            self._work.begin() if working else self._work.end()

    def show_stage(self, words: str) -> None:
        """Show the present stage of the calculation, if there is one."""
        if self._work is not None:
            self._work.say(words)

    def has_focus(self) -> bool:
        """Return whether the keyboard is here."""
        return any(editor.hasFocus() for editor in self.editors)

    def focus(self) -> None:
        """Take the keyboard here."""
        self.editors[0].setFocus(QtCore.Qt.FocusReason.OtherFocusReason)

    def add(self, editor: Any, suffix: str = "", layout: Any = None) -> Any:
        """Add one widget to the field under its name for tests."""
        editor.setObjectName(f"{self.name}{suffix}")
        editor.setAccessibleName(self.label.text())
        (layout or self._column).addWidget(editor)
        return editor

    def touched(self) -> None:
        """Note that a person has changed it."""
        self.edited = True
        self.changed.emit()

    def left(self) -> None:
        """Show the object's value as it is written, when the person leaves what he typed."""
        if not self.edited:
            self.write()

    def line(self, suffix: str = "", layout: Any = None) -> Any:
        """Add and return a line to type into."""
        line = self.add(QtGui.QLineEdit(self.widget), suffix, layout)
        line.setMinimumWidth(40)
        line.textEdited.connect(lambda _: self.touched())
        line.editingFinished.connect(self.left)
        return line

    def _explain(self) -> None:
        self.label.setToolTip(tr(self.entry.text))
        for editor in self.editors:
            editor.setToolTip(tr(self.entry.text))
            editor.setWhatsThis(tr(self.entry.text))  # FreeCAD's "What's this?" and Shift+F1 show it

    def _why_fixed(self) -> str:
        if any(path.lstrip(".").split(".")[0] == self.entry.name for path, *_ in self.obj.ExpressionEngine):
            return tr("An expression gives this value; change it in the property editor")
        return tr(self.obj.Proxy.WHY_FIXED) if "ReadOnly" in self.obj.getEditorMode(self.entry.name) else ""


class NumberField(Field):
    """A number, with a unit where it has one."""

    def make(self) -> list[Any]:
        """Add the line."""
        return [self.line()]

    def read(self) -> Any:
        """Return the number; raises Refused."""
        read = whole_of_text if self.entry.type == INTEGER else value_of_text
        return read(self.editors[0].text(), self.entry, self.obj)

    def write(self) -> None:
        """Show the object's number."""
        self.editors[0].setText(text_of(value_of(self.obj, self.entry), self.entry))


class VectorField(Field):
    """Lengths along X, Y and Z; of a place in the plane only two."""

    def make(self) -> list[Any]:
        """Add a line for each axis, side by side."""
        row = QtGui.QHBoxLayout()
        row.setSpacing(3)
        self._column.addLayout(row)
        axes = AXES[:2] if self.entry.plane else AXES
        lines = [self.line(f"_{axis.lower()}", row) for axis in axes]
        for axis, line in zip(axes, lines, strict=True):
            line.setAccessibleName(f"{self.label.text()} {axis}")
        row.addWidget(QtGui.QLabel(measure_of(self.entry).unit, self.widget))
        return lines

    def read(self) -> tuple[float, ...]:
        """Return the lengths; raises Refused."""
        return tuple(value_of_text(line.text(), self.entry, self.obj) for line in self.editors)

    def write(self) -> None:
        """Show the object's lengths."""
        for line, length in zip(self.editors, value_of(self.obj, self.entry), strict=False):
            if not line.hasFocus():
                line.setText(text_of(length, self.entry, with_unit=False))

    def has_focus(self) -> bool:
        """Let the lengths be shown at any time: `write` spares the one that has the keyboard."""
        return False


class TextField(Field):
    """A text."""

    def make(self) -> list[Any]:
        """Add the line."""
        return [self.line()]

    def read(self) -> str:
        """Return the text."""
        return str(self.editors[0].text())

    def write(self) -> None:
        """Show the object's text."""
        self.editors[0].setText(value_of(self.obj, self.entry))


class CheckField(Field):
    """Yes or no."""

    def make(self) -> list[Any]:
        """Add the box."""
        box = self.add(QtGui.QCheckBox(self.widget))
        box.clicked.connect(lambda _: self.touched())
        return [box]

    def read(self) -> bool:
        """Return whether it is checked."""
        return bool(self.editors[0].isChecked())

    def write(self) -> None:
        """Show the object's value."""
        self.editors[0].setChecked(value_of(self.obj, self.entry))


class ChoiceBox(QtGui.QComboBox):
    """A box whose open list is as wide as its longest choice, and that shows where its own text goes on."""

    def shown_text(self) -> str:
        """Return its text as it is shown, with "…" where the box is too narrow."""
        option = self._option()
        styled = QtGui.QStyle.ComplexControl.CC_ComboBox, option, QtGui.QStyle.SubControl.SC_ComboBoxEditField
        styles = self.style(), QtGui.QApplication.style()  # the style sheet of a refused choice forgets the arrow
        room = min(style.subControlRect(*styled, self).width() for style in styles)
        return str(self.fontMetrics().elidedText(option.currentText, QtCore.Qt.TextElideMode.ElideRight, room))

    def paintEvent(self, event: Any) -> None:
        """Draw it; Qt calls this."""
        painter, option = QtGui.QStylePainter(self), self._option()
        option.currentText = self.shown_text()
        painter.drawComplexControl(QtGui.QStyle.ComplexControl.CC_ComboBox, option)
        painter.drawControl(QtGui.QStyle.ControlElement.CE_ComboBoxLabel, option)
        painter.end()

    def _option(self) -> Any:
        option = QtGui.QStyleOptionComboBox()
        self.initStyleOption(option)
        return option

    def showPopup(self) -> None:
        """Open the list; Qt calls this."""
        view = self.view()
        view.setMinimumWidth(view.sizeHintForColumn(0) + view.verticalScrollBar().sizeHint().width())
        super().showPopup()


class ChoiceField(Field):
    """One of several values, each with its words."""

    def make(self) -> list[Any]:
        """Add the box to choose from."""
        box = self.add(ChoiceBox(self.widget))
        box.setSizeAdjustPolicy(QtGui.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        box.setMinimumContentsLength(5)
        box.setSizePolicy(QtGui.QSizePolicy.Policy.Expanding, QtGui.QSizePolicy.Policy.Fixed)
        self.values: list[Any] = []
        self.fill(box)
        box.currentIndexChanged.connect(lambda _: self._explain())
        box.activated.connect(lambda _: self.touched())
        return [box]

    def _explain(self) -> None:
        """Say the choice in the tooltip too: a narrow panel shows its front."""
        super()._explain()
        box = self.editors[0]
        box.setToolTip("\n".join(filter(None, (box.currentText(), tr(self.entry.text)))))

    def choices(self) -> list[tuple[Any, str]]:
        """Return the values and their words, in order."""
        return [(choice, words_of(choice, self.entry.key)) for choice in self.entry.choices]

    def fill(self, box: Any) -> None:
        """Put the choices into the box."""
        pairs = self.choices()
        self.values = [value for value, _ in pairs]
        box.clear()
        box.addItems([words for _, words in pairs])

    def read(self) -> Any:
        """Return the chosen value; raises Refused when nothing is chosen."""
        index = self.editors[0].currentIndex()
        if index < 0:
            raise Refused(tr("Choose one here"))
        return self.values[index]

    def write(self) -> None:
        """Show the object's value."""
        value = value_of(self.obj, self.entry)
        self.editors[0].setCurrentIndex(self.values.index(value) if value in self.values else -1)


KINDS: dict[str, type[Field]] = {
    POSITION: VectorField,
    ENUMERATION: ChoiceField,
    BOOL: CheckField,
    TEXT: TextField,
}


def field_class(entry: Property) -> type[Field]:
    """Return the class of field that shows a property."""
    return KINDS.get(entry.type, NumberField)


class NoteLabel(QtGui.QLabel):
    """A label that wraps, at least as high as its lines are: Qt's form layout may give it less in a style sheet.

    It gets its looks with its first text: Qt takes long over a style sheet, and most notes of a panel stay empty.
    """

    def __init__(self, colour: str, parent: Any):
        super().__init__(parent)
        self._colour = colour

    def setText(self, text: str) -> None:
        """Show a text, and hold its lines."""
        if text and self._colour:
            self._dress()
        super().setText(text)
        self._hold_lines()

    def resizeEvent(self, event: Any) -> None:
        """Follow the width; Qt calls this."""
        super().resizeEvent(event)
        self._hold_lines()

    def _dress(self) -> None:
        self.setStyleSheet(f"color: {letters(self._colour)};")
        font = self.font()
        font.setPointSizeF(font.pointSizeF() * NOTE_SIZE)
        self.setFont(font)
        self._colour = ""

    def _hold_lines(self) -> None:
        self.setMinimumHeight(self.heightForWidth(self.width()) if self.text() else 0)


def bring_into_view(widget: Any) -> None:
    """Scroll the panel that a widget stands in until the widget is seen."""
    area = widget.parentWidget()
    while area is not None and not isinstance(area, QtGui.QScrollArea):
        area = area.parentWidget()
    if area is not None:
        area.ensureWidgetVisible(widget)


def note_label(name: str, colour: str, parent: Any) -> Any:
    """Return a small label that wraps, for notes below fields; it is hidden."""
    note = NoteLabel(colour, parent)
    note.setObjectName(name)
    note.setWordWrap(True)
    note.setTextFormat(QtCore.Qt.TextFormat.PlainText)
    note.setTextInteractionFlags(QtCore.Qt.TextInteractionFlag.TextSelectableByMouse)
    note.hide()
    return note
