# SPDX-License-Identifier: LGPL-2.1-or-later
"""The menu of edits of a whole program: a dialog for the values, then the difference, then the edit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.control.session.status import error_from_json
from CNCStepper.workbench.editor.model.syntax_colours import colours_on
from CNCStepper.workbench.editor.reader_client import ProgramReader
from CNCStepper.workbench.editor.text_edit import ProgramEdit
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.standard_buttons import name_standard_buttons
from CNCStepper.workbench.services.translation import later, tr

NAME = "CNCStepper_Editor_verb_"
CONVERT = "convert"
DIFF = "CNCStepper_Editor_diff"
SIZE = (560, 420)


@dataclass(frozen=True)
class Field:
    """A value that a verb needs: a number, or one of `choices`."""

    key: str
    label: str
    default: Any
    choices: tuple[str, ...] = ()
    whole: bool = False


@dataclass(frozen=True)
class Verb:
    """An entry of the menu; `name` is the verb of `job/editing/edit_verbs.py`."""

    name: str
    title: str
    fields: tuple[Field, ...] = ()


VERBS = (
    Verb("offset", later("Move…"), (
        Field("x_mm", later("Along X, mm"), 0.0),
        Field("y_mm", later("Along Y, mm"), 0.0),
        Field("z_mm", later("Along Z, mm"), 0.0),
    )),
    Verb("scale", later("Scale…"), (
        Field("x", later("X times"), 1.0),
        Field("y", later("Y times"), 1.0),
        Field("z", later("Z times"), 1.0),
    )),
    Verb("rotate", later("Rotate…"), (Field("angle_deg", later("Degrees, counter-clockwise"), 90.0),)),
    Verb("mirror", later("Mirror…"), (
        Field("axis", later("Axis whose sign changes"), "x", ("x", "y")),
        Field("at_mm", later("Place of the mirror, mm"), 0.0),
    )),
    Verb("feeds", later("Feeds by a factor…"), (Field("factor", later("Feeds times"), 1.0),)),
    Verb("units", later("Convert units…"), (Field("units", later("Units"), "mm", ("mm", "inch")),)),
    Verb("renumber", later("Number the lines…"), (
        Field("first", later("First number"), 10, whole=True),
        Field("step", later("From one to the next"), 10, whole=True),
    )),
    Verb("without_numbers", later("Take the line numbers out")),
    Verb("reverse", later("Reverse the contours")),
    Verb(CONVERT, later("Convert for this machine…")),
    Verb("compact", later("Make shorter…"), (Field("tolerance_mm", later("Never farther off than, mm"), 0.01),)),
)  # fmt: skip


class Verbs(QtCore.QObject):
    """The menu of one editor; `send_typed` passes the newest text to the reader."""

    def __init__(self, panel: Any, edit: ProgramEdit, reader: ProgramReader, send_typed: Callable[[], None]):
        super().__init__(panel)
        self._panel, self._edit, self._reader, self._send_typed = panel, edit, reader, send_typed
        self._verb: Verb | None = None
        self._actions: dict[str, Any] = {}
        self.menu = QtGui.QMenu(panel)
        self.menu.setObjectName(f"{NAME}menu")
        for verb in VERBS:
            action = self.menu.addAction(tr(verb.title))
            action.setObjectName(NAME + verb.name)
            action.triggered.connect(messages.guarded(lambda verb=verb: self._begin(verb)))
            self._actions[verb.name] = action
        reader.edited.connect(messages.guarded(self._show))

    def trigger(self, name: str) -> None:
        """Do what choosing that verb in the menu does."""
        self._actions[name].trigger()

    def _begin(self, verb: Verb) -> None:
        """Ask for the values, then ask the process what becomes of the program."""
        values = _ask(verb, self._panel) if verb.fields else {}
        if values is not None:
            self._verb = verb
            self._send_typed()  # an answer about an older text is not heard
            self._reader.ask({"edit": {"verb": verb.name, "values": values}})

    def _show(self, answer: dict[str, Any]) -> None:
        """Show what would change, and change it when that is wanted."""
        verb, self._verb = self._verb, None
        if verb is None:
            return
        if "error_of_edit" in answer:
            messages.error(error_from_json(answer["error_of_edit"]))
        elif not answer["changes"]:
            messages.note(tr("Nothing changes."))
        elif agreed(DiffDialog(tr(verb.title).rstrip("…"), answer, self._panel)):
            path = self._reader.folder / answer["text"]
            text = path.read_bytes().decode("utf-8", "surrogatepass")
            self._edit.replace_all(text.replace("\r\n", "\n"))


def _ask(verb: Verb, parent: Any) -> dict[str, Any] | None:
    """Ask for a verb's values, None when nobody gave them."""
    dialog = QtGui.QDialog(parent)
    dialog.setObjectName(f"{NAME}values")
    dialog.setWindowTitle(tr(verb.title).rstrip("…"))
    layout = QtGui.QFormLayout(dialog)
    inputs = {field.key: _input(field) for field in verb.fields}
    for field in verb.fields:
        layout.addRow(tr(field.label), inputs[field.key])
    kind = QtGui.QDialogButtonBox.StandardButton
    buttons = QtGui.QDialogButtonBox(kind.Ok | kind.Cancel)
    name_standard_buttons(buttons, f"{NAME}values")
    buttons.accepted.connect(dialog.accept)
    buttons.rejected.connect(dialog.reject)
    layout.addRow(buttons)
    given = agreed(dialog)
    return {key: _value(widget) for key, widget in inputs.items()} if given else None


def _input(field: Field) -> Any:
    """Return the widget in which a value is given."""
    if field.choices:
        made = QtGui.QComboBox()
        made.addItems(field.choices)
        made.setCurrentText(field.default)
    elif field.whole:
        made = QtGui.QSpinBox()
        made.setRange(1, 99_999)
        made.setValue(field.default)
    else:
        made = QtGui.QDoubleSpinBox()
        made.setDecimals(4)
        made.setRange(-99_999.0, 99_999.0)
        made.setValue(field.default)
    made.setObjectName(NAME + field.key)
    return made


def _value(widget: Any) -> Any:
    return widget.currentText() if isinstance(widget, QtGui.QComboBox) else widget.value()


class DiffDialog(QtGui.QDialog):
    """The difference as lines with - and +, and two buttons."""

    def __init__(self, title: str, answer: dict[str, Any], parent: Any = None):
        super().__init__(parent)
        self.setObjectName(DIFF)
        self.setWindowTitle(title)
        self.resize(*SIZE)
        head = QtGui.QLabel(tr("{0} lines change:").format(answer["changes"]))
        self._text = QtGui.QPlainTextEdit()
        self._text.setObjectName(f"{DIFF}_text")
        self._text.setReadOnly(True)
        self._text.setLineWrapMode(QtGui.QPlainTextEdit.LineWrapMode.NoWrap)
        self._text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
        _Colours(self._text.document(), self._text.palette().color(QtGui.QPalette.ColorRole.Base).lightness())
        more = [tr("… and {0} more lines").format(answer["more"])] if answer["more"] else []
        self._text.setPlainText("\n".join([*answer["diff"][2:], *more]))
        kind = QtGui.QDialogButtonBox.StandardButton
        buttons = QtGui.QDialogButtonBox(kind.Apply | kind.Cancel)
        name_standard_buttons(buttons, DIFF)
        buttons.button(kind.Apply).clicked.connect(self.accept)
        buttons.rejected.connect(self.reject)
        layout = QtGui.QVBoxLayout(self)
        for widget in (head, self._text, buttons):
            layout.addWidget(widget)


def agreed(dialog: Any) -> bool:
    """Show a dialog, wait, and return whether it was agreed to."""
    answer = bool(getattr(dialog, "exec", dialog.exec_)())
    dialog.deleteLater()
    return answer


class _Colours(QtGui.QSyntaxHighlighter):
    """Colours removed and added lines."""

    def __init__(self, document: Any, lightness: int):
        super().__init__(document)
        colours = colours_on(lightness)
        self._colours = {"-": colours["wrong"], "+": colours["centre"], "@": colours["number"]}

    def highlightBlock(self, text: str) -> None:
        """Colour one line; Qt calls this."""
        if text[:1] in self._colours:
            shown = QtGui.QTextCharFormat()
            shown.setForeground(QtGui.QBrush(QtGui.QColor(self._colours[text[:1]])))
            self.setFormat(0, len(text), shown)
