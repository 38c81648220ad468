# SPDX-License-Identifier: LGPL-2.1-or-later
"""Watches a job while its simulation is open: its program may change, its document may be closed."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any


class JobWatch:
    """Calls `changed` when the job's program changes, `deleted` when the job or its document is about to go."""

    def __init__(self, job: Any, changed: Callable[[], None], deleted: Callable[[], None]):
        import FreeCAD

        self._job, self._document_name = job, job.Document.Name
        self._changed, self._deleted = changed, deleted
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
        if name == "Program" and obj is self._job:
            self._changed()

    def slotDeletedObject(self, obj: Any) -> None:
        """FreeCAD calls this before an object goes."""
        if obj is self._job:
            self._deleted()

    def slotDeletedDocument(self, document: Any) -> None:
        """FreeCAD calls this before a document goes."""
        if document.Name == self._document_name:
            self._deleted()
