# SPDX-License-Identifier: LGPL-2.1-or-later
"""The text of a program: Qt's own plain text editor, with a margin, colours, waves under what is refused, tooltips.

A long text is put in bit by bit, and what is drawn is only what is seen, so that nothing waits.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from PySide import QtCore, QtGui

from CNCStepper.workbench.editor.margin import Margin
from CNCStepper.workbench.editor.model.error_marks import Change, Marks, joined
from CNCStepper.workbench.editor.model.syntax_colours import BOLD, colours_on, spans_of
from CNCStepper.workbench.services import messages
from CNCStepper.workbench.services.message_translation import translated
from CNCStepper.workbench.services.translation import tr

LINES_AT_ONCE = 1000  # so many are put in at once, which takes some ms
NEAR_LINES = 100  # so far apart, two changes may still be told as one
KEYS = {"Ctrl+S": "save", "Ctrl+F": "find", "Ctrl+H": "find", "F3": "find_next", "Shift+F3": "find_before"}


class ProgramEdit(QtGui.QPlainTextEdit):
    """`changed` is sent when lines have changed (`take_change` says which), `filled` when all of a text stands there,
    `wanted` with the name of what a key asks for."""

    changed = QtCore.Signal()
    filled = QtCore.Signal()
    wanted = QtCore.Signal(str)

    def __init__(self, parent: Any = None):
        super().__init__(parent)
        self.setObjectName("CNCStepper_Editor_text")
        self.setAccessibleName(tr("Program"))
        self.setFont(QtGui.QFontDatabase.systemFont(QtGui.QFontDatabase.SystemFont.FixedFont))
        self.setLineWrapMode(QtGui.QPlainTextEdit.LineWrapMode.NoWrap)
        self.colours = colours_on(255)
        self.marks = Marks()
        self.margin = Margin(self, self.seen_lines, self.marks, self.colours)
        self._highlighter = Highlighter(self.document(), self.colours)
        self._change: Change | None = None
        self._count = 1
        self._filling: Iterator[None] = iter(())
        self._filler = QtCore.QTimer(self)
        self._filler.setInterval(0)
        self._filler.timeout.connect(messages.guarded(self._fill_on))
        self._seer = QtCore.QTimer(self)  # what is seen is known when Qt has scrolled
        self._seer.setSingleShot(True)
        self._seer.setInterval(0)
        self._seer.timeout.connect(messages.guarded(self._see))
        self.document().contentsChange.connect(messages.guarded(self._note))
        self.blockCountChanged.connect(messages.guarded(self._widen))
        self.updateRequest.connect(messages.guarded(self._scroll))
        self.cursorPositionChanged.connect(messages.guarded(self.show_marks))
        self.verticalScrollBar().valueChanged.connect(self._seer.start)
        self._widen()

    # ---- the text ----

    @property
    def filling(self) -> bool:
        """Whether a text is still being put in."""
        return self._filler.isActive()

    def fill(self, text: str) -> None:
        """Put a text in, bit by bit; until `filled` it cannot be edited."""
        self.setReadOnly(True)
        self.setUndoRedoEnabled(False)
        self._filling = self._bit_by_bit(text)
        self._filler.start()  # from now on nothing counts as a change
        self._change = None
        self.clear()
        self.marks.take([])

    def lines(self, first: int, count: int) -> list[str]:
        """Return lines of the text, from `first`, counted from 0."""
        block, found = self.document().findBlockByNumber(first), []
        for _ in range(count):
            found.append(block.text())
            block = block.next()
        return found

    def take_change(self) -> Change | None:
        """Return what has changed since this was asked last."""
        change, self._change = self._change, None
        return change

    @property
    def far_from_change(self) -> bool:
        """Whether the cursor has left what `take_change` would return: one change of both places would be long."""
        if self._change is None:
            return False
        before = self._change.first - self.textCursor().blockNumber()
        return max(before, -before - self._change.added) > NEAR_LINES

    def replace_all(self, text: str) -> None:
        """Put another text in the place of all, as one step that can be undone."""
        line, column = self.line, self.column
        cursor = QtGui.QTextCursor(self.document())
        cursor.beginEditBlock()
        cursor.select(QtGui.QTextCursor.SelectionType.Document)
        cursor.insertText(text)
        cursor.endEditBlock()
        self.go_to(line, column)

    # ---- the cursor ----

    @property
    def line(self) -> int:
        """The cursor's line, from 1."""
        return int(self.textCursor().blockNumber()) + 1

    @property
    def column(self) -> int:
        """The cursor's column, from 1."""
        return int(self.textCursor().positionInBlock()) + 1

    def go_to(self, line: int, column: int = 1) -> None:
        """Put the cursor at a place, and let it be seen."""
        block = self.document().findBlockByNumber(min(max(line, 1), self.blockCount()) - 1)
        cursor = QtGui.QTextCursor(block)
        cursor.setPosition(block.position() + min(max(column - 1, 0), len(block.text())))
        self.setTextCursor(cursor)
        self.centerCursor()

    # ---- what is seen ----

    def seen_lines(self) -> Iterator[tuple[int, int, int]]:
        """Yield number (from 0), top and height in pixels of the lines that are seen."""
        block = self.firstVisibleBlock()
        top = self.blockBoundingGeometry(block).translated(self.contentOffset()).top()
        bottom = self.viewport().height()
        while block.isValid() and top <= bottom:
            height = self.blockBoundingRect(block).height()
            yield block.blockNumber(), round(top), round(height)
            top += height
            block = block.next()

    def show_marks(self) -> None:
        """Draw the cursor's line and the waves of what is seen."""
        seen = [number for number, _, _ in self.seen_lines()]
        selections = [self._cursor_line()]
        for mark in self.marks.between(seen[0] + 1, seen[-1] + 1) if seen else ():
            selections.append(self._wave(mark))
        self.setExtraSelections(selections)
        self.margin.update()

    def resizeEvent(self, event: Any) -> None:
        """Place the margin at the left of the text."""
        super().resizeEvent(event)
        inside = self.contentsRect()
        self.margin.setGeometry(inside.left(), inside.top(), self.margin.wanted_px(), inside.height())
        self._seer.start()

    def changeEvent(self, event: Any) -> None:
        """Take other colours with another theme."""
        super().changeEvent(event)
        if event.type() in (QtCore.QEvent.Type.PaletteChange, QtCore.QEvent.Type.StyleChange):
            self._choose_colours()

    def showEvent(self, event: Any) -> None:
        """Take the colours of the theme, which is known by now."""
        super().showEvent(event)
        self._choose_colours()

    def event(self, event: Any) -> bool:
        """Keep our keys from FreeCAD's commands, and show why a word is refused as its tooltip."""
        kind = event.type()
        if kind == QtCore.QEvent.Type.ShortcutOverride and _wanted(event):
            event.accept()
            return True
        if kind == QtCore.QEvent.Type.ToolTip:
            return self._show_tooltip(event)
        return bool(super().event(event))

    def keyPressEvent(self, event: Any) -> None:
        """Heed our keys, leave the others to Qt."""
        request = _wanted(event)
        if request:
            self.wanted.emit(request)
        else:
            super().keyPressEvent(event)

    # ---- inside ----

    def _bit_by_bit(self, text: str) -> Iterator[None]:
        cursor, lines = QtGui.QTextCursor(self.document()), text.split("\n")
        yield
        for first in range(0, len(lines), LINES_AT_ONCE):
            cursor.movePosition(QtGui.QTextCursor.MoveOperation.End)
            piece = "\n".join(lines[first : first + LINES_AT_ONCE])
            cursor.insertText(f"\n{piece}" if first else piece)
            if not first:
                self.moveCursor(QtGui.QTextCursor.MoveOperation.Start)  # else the end would be shown
            yield

    def _fill_on(self) -> None:
        if next(self._filling, self) is None:
            return
        self._filler.stop()
        self.setUndoRedoEnabled(True)
        self.setReadOnly(False)
        self.document().setModified(False)
        self._change = None
        self._see()
        self.filled.emit()

    def _note(self, position: int, removed: int, added: int) -> None:
        """Note which lines a change concerns; Qt tells only characters."""
        count = self.blockCount()
        grown, self._count = count - self._count, count
        document = self.document()
        first = document.findBlock(position).blockNumber()
        end = document.findBlock(position + added)
        last = (end if end.isValid() else document.lastBlock()).blockNumber()
        after = last - first + 1
        if self.filling or after - grown < 0:
            return
        self._change = joined(self._change, first, after - grown, after)
        self.marks.move(first, after - grown, after)
        self.changed.emit()

    def _widen(self, *_: Any) -> None:
        self.setViewportMargins(self.margin.wanted_px(), 0, 0, 0)
        inside = self.contentsRect()
        self.margin.setGeometry(inside.left(), inside.top(), self.margin.wanted_px(), inside.height())
        self._seer.start()

    def _scroll(self, rectangle: Any, dy: int) -> None:
        if dy:
            self.margin.scroll(0, dy)
        else:
            self.margin.update(0, rectangle.y(), self.margin.width(), rectangle.height())

    def _see(self, *_: Any) -> None:
        """Colour and mark what is seen now."""
        seen = [number for number, _, _ in self.seen_lines()]
        if seen:
            self._highlighter.show(seen[0], seen[-1])
            self.show_marks()

    def _choose_colours(self) -> None:
        chosen = colours_on(self.palette().color(QtGui.QPalette.ColorRole.Base).lightness())
        if chosen is not self.colours:
            self.colours = self.margin.colours = chosen
            self._highlighter.set_colours(chosen)
            self._see()

    def _cursor_line(self) -> Any:
        line = QtGui.QTextEdit.ExtraSelection()
        line.format.setBackground(QtGui.QColor(self.colours["line"]))
        line.format.setProperty(QtGui.QTextFormat.Property.FullWidthSelection, True)
        line.cursor = self.textCursor()
        line.cursor.clearSelection()
        return line

    def _wave(self, mark: Any) -> Any:
        block = self.document().findBlockByNumber(mark.line - 1)
        whole = len(block.text())
        begin = min(mark.column - 1 if mark.length else 0, whole)
        end = min(begin + (mark.length or whole), whole)
        wave = QtGui.QTextEdit.ExtraSelection()
        wave.format.setUnderlineStyle(QtGui.QTextCharFormat.UnderlineStyle.WaveUnderline)
        wave.format.setUnderlineColor(QtGui.QColor(self.colours["wrong"]))
        wave.cursor = QtGui.QTextCursor(block)
        wave.cursor.setPosition(block.position() + begin)
        wave.cursor.setPosition(block.position() + end, QtGui.QTextCursor.MoveMode.KeepAnchor)
        return wave

    def _show_tooltip(self, event: Any) -> bool:
        place = self.viewport().mapFromGlobal(event.globalPos())
        mark = self.marks.at(self.cursorForPosition(place).blockNumber() + 1)
        if mark is None:
            QtGui.QToolTip.hideText()
        else:
            QtGui.QToolTip.showText(event.globalPos(), translated(mark.error.sentence), self)
        return True


def _wanted(event: Any) -> str:
    """Return what a key asks for, "" where it is Qt's."""
    return KEYS.get(_name(event), "")


def _name(event: Any) -> str:
    """Return a key's name, as "Ctrl+S"."""
    control = QtCore.Qt.KeyboardModifier.ControlModifier
    shift = QtCore.Qt.KeyboardModifier.ShiftModifier
    letters = {QtCore.Qt.Key.Key_S: "S", QtCore.Qt.Key.Key_F: "F", QtCore.Qt.Key.Key_H: "H", QtCore.Qt.Key.Key_F3: "F3"}
    name = next((name for key, name in letters.items() if event.key() == key), "")
    modifiers = event.modifiers()
    return ("Ctrl+" if modifiers & control else "") + ("Shift+" if modifiers & shift else "") + name


class Highlighter(QtGui.QSyntaxHighlighter):
    """Colours a document's blocks from `first` to `last`, counted from 0."""

    def __init__(self, document: Any, colours: dict[str, str]):
        super().__init__(document)
        self._first, self._last = 0, -1
        self._formats: dict[str, Any] = {}
        self.set_colours(colours)

    def set_colours(self, colours: dict[str, str]) -> None:
        """Use these colours from now on."""
        self._formats = {kind: _format(colour, kind in BOLD) for kind, colour in colours.items()}
        self._first, self._last = 0, -1

    def show(self, first: int, last: int) -> None:
        """Colour these blocks, of which some may be coloured already."""
        fresh = [number for number in range(first, last + 1) if not self._first <= number <= self._last]
        self._first, self._last = first, last
        for number in fresh:
            self.rehighlightBlock(self.document().findBlockByNumber(number))

    def highlightBlock(self, text: str) -> None:
        """Colour one line, if it is seen; Qt calls this for every line that changes."""
        if self._first <= self.currentBlock().blockNumber() <= self._last:
            for start, length, kind in spans_of(text):
                self.setFormat(start, length, self._formats[kind])


def _format(colour: str, bold: bool) -> Any:
    shown = QtGui.QTextCharFormat()
    shown.setForeground(QtGui.QColor(colour))
    if bold:
        shown.setFontWeight(QtGui.QFont.Weight.DemiBold)
    return shown
