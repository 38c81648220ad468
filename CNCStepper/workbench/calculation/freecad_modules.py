# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's own modules that our first object needs, loaded while the workbench opens.

    begin ──► a thread: the system loads their libraries, without Python's lock, so that the window works on
    end   ──► the window's thread: Python imports them, which then takes a few ms

Loaded with the first object, they would keep the window from its events for a third of a second.
"""

from __future__ import annotations

import contextlib
import ctypes
import importlib
import importlib.util
import os
import sys
from collections.abc import Sequence
from concurrent.futures import Future

from CNCStepper.control.processes.background_thread import in_background

NAMES = ("Part", "PartGui")
AS_PYTHON_DOES = 0x1100  # LoadLibraryEx: LOAD_LIBRARY_SEARCH_DEFAULT_DIRS, and the folder of the library itself


def begin() -> Future[None]:
    """Let the system load the libraries of the modules that are not loaded."""
    names = [name for name in NAMES if name not in sys.modules]
    return in_background(lambda: _load_libraries(names))


def _load_libraries(names: Sequence[str]) -> None:
    for name in names:
        spec = importlib.util.find_spec(name)
        if spec is not None and spec.origin is not None:
            _load_library(spec.origin)


def _load_library(path: str) -> None:
    """Let the system load a library; one that it refuses is left to Python's import, which says why."""
    if sys.platform == "win32":
        ctypes.WinDLL("kernel32").LoadLibraryExW(path, None, AS_PYTHON_DOES)
    else:
        ctypes.CDLL(None).dlopen(os.fsencode(path), os.RTLD_NOW)


def end(loading: Future[None]) -> None:
    """Wait for the libraries and import the modules; a FreeCAD that has one of them not goes without."""
    loading.exception()
    for name in NAMES:
        with contextlib.suppress(ImportError):
            importlib.import_module(name)
