# SPDX-License-Identifier: LGPL-2.1-or-later
"""Who is told of each document object of ours when it is made or opened: in a window that is the tree.

FreeCAD's start loads this: it imports nothing of ours.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

_observers: list[Callable[[Any], None]] = []


def observe(observer: Callable[[Any], None]) -> None:
    """Call `observer` with each object that is made or opened from now on; again changes nothing."""
    if observer not in _observers:
        _observers.append(observer)


def announce(obj: Any) -> None:
    """Pass a new or opened object to all observers."""
    for observer in _observers:
        observer(obj)
