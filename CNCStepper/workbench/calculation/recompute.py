# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recomputes our objects while a person types.

FreeCAD's own recompute of a document runs its progress bar, which takes the keys that are typed meanwhile away from the
field that they are meant for. An object alone is made without it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from CNCStepper.workbench.features.base import proxy_type


def remake(document: Any) -> None:
    """Make our changed objects and their dependents, in the order of dependency."""
    for _ in steps(document):
        pass


def steps(document: Any, left: Callable[[Any], bool] = lambda _: False) -> Iterator[None]:
    """Do what `remake` does, an object at a time, so that a window can see to its events between two of them.

    left: returns whether an object is left to somebody else.
    """
    made: set[str] = set()
    for name in [obj.Name for obj in reversed(document.TopologicalSortedObjects)]:
        obj = document.getObject(name)
        if obj is None or not proxy_type(obj):
            continue
        if ("Touched" in obj.State or any(part.Name in made for part in obj.OutList)) and not left(obj):
            obj.recompute()
            obj.purgeTouched()
            made.add(name)
            yield
