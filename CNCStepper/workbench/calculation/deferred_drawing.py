# SPDX-License-Identifier: LGPL-2.1-or-later
"""Programs are redrawn when typing pauses.

A picture is only looked at, and FreeCAD draws that of a long program for longer than a key may take:

    typed ──► objects and program made ──► draw_soon ── no key for a while ──► read for FreeCAD ──► drawn
                                               ▲                  │
                                             hold ◄──── a key ────┘
"""

from __future__ import annotations

from typing import Any

from PySide import QtCore

from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.features.preview import Preview
from CNCStepper.workbench.services.messages import guarded

PAUSE_MS = 100

_documents: set[str] = set()  # by name: some of whose pictures are to be drawn
_timers: list[Any] = []


def leave(obj: Any) -> bool:
    """Return whether an object is a picture, which is then to be drawn later."""
    if proxy_type(obj) != Preview.Type:
        return False
    obj.touch()  # until then it says so itself: whoever makes the document anew draws it too
    return True


def draw_soon(document: Any) -> None:
    """Draw the pictures of a document that were left, when no key is typed for a while."""
    if any(map(_is_left, document.Objects)):
        _documents.add(document.Name)
        _timer().start(PAUSE_MS)


def hold() -> None:
    """Wait anew: a key is typed."""
    if _documents:
        _timer().start(PAUSE_MS)


def _timer() -> Any:
    if not _timers:
        _timers.append(QtCore.QTimer(QtCore.QCoreApplication.instance()))
        _timers[0].setSingleShot(True)
        _timers[0].timeout.connect(guarded(_draw))
    return _timers[0]


def _draw() -> None:
    """Do one part of what is left, and the next when the window has seen to its events."""
    import FreeCAD

    documents = [document for name, document in FreeCAD.listDocuments().items() if name in _documents]
    left = [obj for document in documents for obj in document.Objects if _is_left(obj)]
    if not left:
        _documents.clear()
        return
    if not left[0].Proxy.read(left[0]):
        left[0].recompute()
        left[0].purgeTouched()
    _timer().start(0)


def _is_left(obj: Any) -> bool:
    return proxy_type(obj) == Preview.Type and "Touched" in obj.State
