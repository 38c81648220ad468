# SPDX-License-Identifier: LGPL-2.1-or-later
"""Objects whose cut took too long for the window are made by the cut process, and then shown."""

from __future__ import annotations

from typing import Any

from PySide import QtCore

from CNCStepper.workbench.calculation.cut_process import CutRequest, process
from CNCStepper.workbench.calculation.precalculation import look_at
from CNCStepper.workbench.calculation.recompute import remake
from CNCStepper.workbench.features.base import proxy_type
from CNCStepper.workbench.services import jit_guard
from CNCStepper.workbench.services.messages import guarded, note
from CNCStepper.workbench.services.translation import tr

AGAIN_MS = 50

_asked: dict[str, frozenset[str]] = {}  # by document: what was asked last


def begin() -> None:
    """From now on leave what takes long to the cut process; only in a window, and again changes nothing."""
    jit_guard.long_refused = _soon


def _soon(in_ms: int = 0) -> None:
    """Ask when FreeCAD has ended its recompute."""
    QtCore.QTimer.singleShot(in_ms, guarded(_ask))


def _ask() -> None:
    import FreeCAD

    if any(document.Recomputing for document in FreeCAD.listDocuments().values()):
        _soon(AGAIN_MS)  # its progress bar lets timers run: what were touched now would stay so
        return
    jit_guard.hurry = False
    for document in FreeCAD.listDocuments().values():
        waiting = _waiting(document)
        if not waiting:
            continue
        for obj in waiting:
            obj.touch()
        look = look_at(document)
        keys = frozenset(look.unknown)
        if keys and keys != _asked.get(document.Name):  # asked once: what is not known then never will be
            _asked[document.Name] = keys
            name = document.Name
            asked = CutRequest(look.unknown, lambda words: note(tr(words)), guarded(lambda name=name: _make(name)))
            process().ask(f"document {name}", asked)


def _make(name: str) -> None:
    """Make what has waited, where its document is still there."""
    import FreeCAD

    document = FreeCAD.listDocuments().get(name)
    if document is not None:
        for obj in _waiting(document):
            obj.touch()
        remake(document)
        if not _waiting(document):
            _asked.pop(name, None)


def _waiting(document: Any) -> list[Any]:
    ours = [obj for obj in document.Objects if proxy_type(obj) and obj.Proxy.refusal is not None]
    return [obj for obj in ours if obj.Proxy.refusal.code == jit_guard.LONG]
