# SPDX-License-Identifier: LGPL-2.1-or-later
"""Which editor is in front: the one that a person has turned to last, until they turn to FreeCAD's tree.

An editor stays in front while they work at the machine or in the 3D view. A click in the tree, or another selection
than when they turned to the editor, puts the job in front again; another tab before it, the editor of that tab.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import FreeCADGui
from PySide import QtGui

from CNCStepper.workbench.services import messages

TREE = "Gui::TreeWidget"


class ActiveEditor:
    """Follows the keyboard's focus; changed: called when another editor, or the tree, is in front."""

    def __init__(self, changed: Callable[[], None]) -> None:
        self._changed = changed
        self._dock: Any = None
        self._selected: list[str] = []  # when a person turned to that editor
        self._focus_moves = messages.guarded(self._focus_moved)
        QtGui.QApplication.instance().focusChanged.connect(self._focus_moves)

    def end(self) -> None:
        """Follow no more: FreeCAD quits."""
        QtGui.QApplication.instance().focusChanged.disconnect(self._focus_moves)

    def turn_to(self, dock: Any) -> None:
        """Put an editor's dock in front; None: the tree."""
        is_new, self._dock = dock is not self._dock, dock
        self._selected = selected() if dock is not None else []
        if is_new:
            self._changed()

    def leave(self, dock: Any) -> None:
        """Let go of a dock that closes."""
        if dock is self._dock:
            self.turn_to(None)

    def dock(self, shown: list[Any]) -> Any:
        """Return the dock in front, of those that there are; None where the tree counts."""
        if self._dock is None or self._dock not in shown or selected() != self._selected:
            return None
        return self._dock if is_seen(self._dock) else next(filter(is_seen, shown), None)

    def _focus_moved(self, _: Any, now: Any) -> None:
        """Follow the focus; runs for every change of it in FreeCAD, so it only looks at what contains the widget."""
        widget = now
        while widget is not None:
            if hasattr(widget, "is_program_editor"):
                self.turn_to(widget)
                return
            if widget.metaObject().className() == TREE:
                self.turn_to(None)
                return
            widget = widget.parentWidget()


def selected() -> list[str]:
    """Return the names of the objects that are selected in all documents."""
    return sorted(f"{part.DocumentName}#{part.ObjectName}" for part in FreeCADGui.Selection.getSelectionEx("*"))


def is_seen(dock: Any) -> bool:
    """Return whether a dock is shown, and not behind another tab."""
    return bool(dock.isVisible() and not dock.visibleRegion().isEmpty())
