# SPDX-License-Identifier: LGPL-2.1-or-later
"""Loads modules of the core in a thread before they are needed: the first import of their packages takes a second.

when_loaded(names, go_on) ──► all loaded? ── yes ──► go_on
                                  └── no ──► thread ──► timer: loaded ──► go_on
"""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Sequence
from concurrent.futures import Future

from PySide import QtCore

from CNCStepper.control.processes.background_thread import in_background
from CNCStepper.workbench import packages
from CNCStepper.workbench.services.messages import guarded

LOOK_EVERY_MS = 20
DRAWINGS = ("CNCStepper.job.shape_forms.drawing_form", "CNCStepper.job.drawings.imported_drawing")
TEMPLATES = (*DRAWINGS, "CNCStepper.job.templates.template_answer", "CNCStepper.job.cut_transfer")

_loading: dict[tuple[str, ...], Future[None]] = {}


def begin_to_load(names: Sequence[str]) -> Future[None]:
    """Load modules in a thread and return at once; again changes nothing. Raises MissingPackage."""
    packages.require()
    key = tuple(names)
    if key not in _loading:
        _loading[key] = in_background(lambda: _load(key))
    return _loading[key]


def when_loaded(names: Sequence[str], go_on: Callable[[], None]) -> None:
    """Call `go_on` when modules are loaded, which may be now; raises MissingPackage."""
    future = begin_to_load(names)
    if future.done():
        future.result()
        go_on()
        return
    timer = QtCore.QTimer(QtCore.QCoreApplication.instance())

    def look() -> None:
        if future.done():
            timer.stop()
            timer.deleteLater()
            future.result()
            go_on()

    timer.timeout.connect(guarded(look))
    timer.start(LOOK_EVERY_MS)


def _load(names: Sequence[str]) -> None:
    for name in names:
        if name not in sys.modules:
            importlib.import_module(name)
