# SPDX-License-Identifier: LGPL-2.1-or-later
"""Shows what an edit would change before it is applied."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.workbench.editor.model.syntax_colours import colours_on
from CNCStepper.workbench.services.translation import tr

NAME = "CNCStepper_Editor_diff"
SIZE = (560, 420)


class DiffDialog(QtGui.QDialog):
    """The difference as lines with - and +, and two buttons."""

    def __init__(self, title: str, answer: dict[str, Any], parent: Any = None):
        super().__init__(parent)
        self.setObjectName(NAME)
        self.setWindowTitle(title)
        self.resize(*SIZE)
        head = QtGui.QLabel(tr("{0} lines change:").format(answer["changes"]))
        self._text = QtGui.QPlainTextEdit()
        self._text.setObjectName(f"{NAME}_text")
        self._text.setReadOnly(True)
        self._text.setLineWrapMode(QtGui.QPlainTextEdit.LineWrapMode.NoWrap)
        self._text.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
        _Colours(self._text.document(), self._text.palette().color(QtGui.QPalette.ColorRole.Base).lightness())
        more = [tr("… and {0} more lines").format(answer["more"])] if answer["more"] else []
        self._text.setPlainText("\n".join([*answer["diff"][2:], *more]))
        kind = QtGui.QDialogButtonBox.StandardButton
        buttons = QtGui.QDialogButtonBox(kind.Apply | kind.Cancel)
        apply = buttons.button(kind.Apply)
        apply.setObjectName(f"{NAME}_apply")
        apply.setText(tr("Apply"))
        apply.clicked.connect(self.accept)
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
    """Colours what goes and what comes."""

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
