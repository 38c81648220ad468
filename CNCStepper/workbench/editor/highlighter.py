# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours the words of the lines that are seen, so that a long program costs no more than a short one."""

from __future__ import annotations

from typing import Any

from PySide import QtGui

from CNCStepper.workbench.editor.model.syntax_colours import BOLD
from CNCStepper.workbench.editor.model.word_spans import spans_of


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
