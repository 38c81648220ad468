# SPDX-License-Identifier: LGPL-2.1-or-later
"""After an undo or redo all is made again: FreeCAD only marks what changed as out of date.

Otherwise after every undo a job would report that its program does not match its drawing.
"""

from __future__ import annotations

from typing import Any

from CNCStepper.workbench.document.pasted_tools import follow_redo, follow_undo
from CNCStepper.workbench.features.base import proxy_type


class _Follower:
    def slotUndoDocument(self, document: Any) -> None:
        """Make again what an undo has changed; FreeCAD calls this."""
        _make_again(document)
        follow_undo(document)

    def slotRedoDocument(self, document: Any) -> None:
        """Make again what a redo has changed; FreeCAD calls this."""
        _make_again(document)
        follow_redo(document)


_followers: list[_Follower] = []


def follow() -> None:
    """Begin to follow undo and redo in all documents; again changes nothing."""
    if not _followers:
        import FreeCAD

        _followers.append(_Follower())
        FreeCAD.addDocumentObserver(_followers[0])


def _make_again(document: Any) -> None:
    if any(proxy_type(obj) and "Touched" in obj.State for obj in document.Objects):
        document.recompute()
