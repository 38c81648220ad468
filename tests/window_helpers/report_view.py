# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's report view as a person sees it: lines, and what their colour says."""

from __future__ import annotations

import re
from typing import Any, NamedTuple

import FreeCAD
import FreeCADGui
from PySide import QtGui

SETTINGS = "User parameter:BaseApp/Preferences/OutputWindow"
TIME = re.compile(r"^\d\d:\d\d:\d\d\s*")
KINDS = (("error", "colorError", 0xFF0000FF), ("warning", "colorWarning", 0xFFAA00FF))


class Line(NamedTuple):
    """One line: its kind ("message", "warning", "error") and its text."""

    kind: str
    text: str

    @property
    def bad(self) -> bool:
        """Tell whether a person would take it for something gone wrong."""
        return self.kind != "message" or self.text.startswith("Traceback")


def _view() -> Any:
    view = FreeCADGui.getMainWindow().findChild(QtGui.QTextEdit, "Report view")
    assert view is not None, "FreeCAD has no report view"
    return view


def _colours() -> dict[int, str]:
    settings = FreeCAD.ParamGet(SETTINGS)
    return {settings.GetUnsigned(name, default) >> 8: kind for kind, name, default in KINDS}


def read() -> list[Line]:
    """Return all lines of the report view; runs on the interface thread."""
    colours = _colours()
    lines = []
    block = _view().document().begin()
    while block.isValid():
        formats = block.layout().formats()
        colour = formats[0].format.foreground().color().rgb() & 0xFFFFFF if formats else 0
        if text := TIME.sub("", block.text()):
            lines.append(Line(colours.get(colour, "message"), text))
        block = block.next()
    return lines


def clear() -> None:
    """Empty the report view; runs on the interface thread."""
    _view().clear()
