# SPDX-License-Identifier: LGPL-2.1-or-later
"""Watches an object with a program: its program may be made anew, it may be deleted, documents may be closed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class ProgramObserver:
    """Calls `changed` when the program of `obj` changes, `deleted` before it goes, `closing` before a document goes.

    obj: what is watched, None for nothing; it may be another one later.
    """

    def __init__(
        self, obj: Any, changed: Callable[[], None], deleted: Callable[[], None], closing: Callable[[str], None]
    ):
        import FreeCAD

        self.obj = obj
        self._changed, self._deleted, self._closing = changed, deleted, closing
        FreeCAD.addDocumentObserver(self)
        self._watching = True

    def end(self) -> None:
        """Watch no longer."""
        import FreeCAD

        if self._watching:
            self._watching = False
            FreeCAD.removeDocumentObserver(self)

    def slotChangedObject(self, obj: Any, name: str) -> None:
        """FreeCAD calls this at every change of a property."""
        if name == "Program" and obj is self.obj:
            self._changed()

    def slotDeletedObject(self, obj: Any) -> None:
        """FreeCAD calls this before an object goes."""
        if self.obj is not None and obj is self.obj:
            self.obj = None
            self._deleted()

    def slotDeletedDocument(self, document: Any) -> None:
        """FreeCAD calls this before a document goes."""
        self._closing(document.Name)
